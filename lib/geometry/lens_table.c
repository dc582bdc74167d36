/*
 * A measured lens: the monotone cubic r(angle) through its samples (Fritsch and Carlson, SIAM J.
 * Numer. Anal. 17, 1980) and its inverse.
 */
#include <math.h>
#include <stdbool.h>

#include "error.h"
#include "lens.h"

/* Samples that lie closer have no slope between them. */
static const double step_min_rad = 1e-9;

static int check_samples(const struct cupola_lens *lens, struct cupola_error *error)
{
    double largest = lens->table[lens->table_count - 1].radius;
    double step_min = isfinite(largest) ? 1e-9 * largest : 0;
    for (int i = 0; i < lens->table_count; i++) {
        struct cupola_lens_sample sample = lens->table[i];
        struct cupola_lens_sample before =
            i > 0 ? lens->table[i - 1] : (struct cupola_lens_sample){0, 0};
        bool origin = i == 0 && sample.angle_rad == 0 && sample.radius == 0;
        if (!isfinite(sample.radius) || !(sample.angle_rad >= 0 && sample.angle_rad <= pi + 1e-12))
            return error_set(error, CUPOLA_ERROR_ARGUMENT,
                             "lens table sample %d is (%g rad (%g degrees), %g); allowed: angles "
                             "of 0 to pi rad (180 degrees), finite radii",
                             i + 1, RAD_AND_DEG(sample.angle_rad), sample.radius);
        if (!origin && !(sample.angle_rad - before.angle_rad > step_min_rad &&
                         sample.radius - before.radius > step_min))
            return error_set(error, CUPOLA_ERROR_ARGUMENT,
                             "lens table sample %d is (%g rad (%g degrees), %g) after (%g rad (%g "
                             "degrees), %g); allowed: both strictly increasing from (0, 0)",
                             i + 1, RAD_AND_DEG(sample.angle_rad), sample.radius,
                             RAD_AND_DEG(before.angle_rad), before.radius);
    }
    return CUPOLA_OK;
}

static double secant(const struct lens_table *table, int i)
{
    return (table->radius[i + 1] - table->radius[i]) / (table->angle[i + 1] - table->angle[i]);
}

/* Slopes by parabolas through neighbouring knots; r is odd in the angle, so the first is known. */
static void estimate_slopes(struct lens_table *table)
{
    int last = table->count - 1;
    table->slope[0] = secant(table, 0);
    for (int i = 1; i < last; i++) {
        double before = table->angle[i] - table->angle[i - 1];
        double after = table->angle[i + 1] - table->angle[i];
        table->slope[i] =
            (after * secant(table, i - 1) + before * secant(table, i)) / (before + after);
    }
    double end = secant(table, last - 1);
    if (last >= 2) {
        double before = table->angle[last - 1] - table->angle[last - 2];
        double here = table->angle[last] - table->angle[last - 1];
        end += here * (end - secant(table, last - 2)) / (before + here);
    }
    /* Above 0, so that the inverse has a slope. */
    table->slope[last] = fmax(end, 1e-3 * secant(table, last - 1));
}

/* Section 4 of Fritsch and Carlson: slopes of an interval stay within a circle of radius 3. */
static void limit_slopes(struct lens_table *table)
{
    for (int i = 0; i + 1 < table->count; i++) {
        double d = secant(table, i);
        double a = table->slope[i] / d, b = table->slope[i + 1] / d;
        double length = hypot(a, b);
        if (length > 3) {
            table->slope[i] = 3 * d * a / length;
            table->slope[i + 1] = 3 * d * b / length;
        }
    }
}

int lens_table_prepare(const struct cupola_lens *lens, double half_fov, struct lens_table *table,
                       struct cupola_error *error)
{
    int status = check_samples(lens, error);
    if (status != CUPOLA_OK)
        return status;
    double last = lens->table[lens->table_count - 1].angle_rad;
    double largest = lens->table[lens->table_count - 1].radius;
    if (!(half_fov > 0 && half_fov <= last * (1 + 1e-12)))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "lens field of view is %g rad (%g degrees); allowed for this table: "
                         "above 0 and up to twice its last angle, %g rad (%g degrees)",
                         RAD_AND_DEG(2 * half_fov), RAD_AND_DEG(2 * last));

    table->count = 0;
    if (lens->table[0].angle_rad > 0)
        table->angle[0] = table->radius[0] = 0, table->count = 1;
    for (int i = 0; i < lens->table_count; i++, table->count++) {
        table->angle[table->count] = lens->table[i].angle_rad;
        /* As a part of the last one: the unit may be so small that slopes in it are no numbers. */
        table->radius[table->count] = lens->table[i].radius / largest;
    }
    estimate_slopes(table);
    limit_slopes(table);

    double rim = lens_table_radius(table, fmin(half_fov, last));
    for (int i = 0; i < table->count; i++) {
        table->radius[i] /= rim;
        table->slope[i] /= rim;
    }
    return CUPOLA_OK;
}

/* The knot before a value in one of the columns. */
static int interval_of(const double *column, int count, double value)
{
    int low = 0, high = count - 1;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (column[middle] <= value)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* The cubic of an interval at t, 0 to 1 (Hermite form), and its derivative by t. */
static double cubic(const struct lens_table *table, int i, double t, double *derivative)
{
    double width = table->angle[i + 1] - table->angle[i];
    double rise = table->radius[i + 1] - table->radius[i];
    double a = width * table->slope[i], b = width * table->slope[i + 1];
    double c2 = 3 * rise - 2 * a - b, c3 = a + b - 2 * rise;
    *derivative = a + t * (2 * c2 + t * 3 * c3);
    return table->radius[i] + t * (a + t * (c2 + t * c3));
}

static double place_in(const struct lens_table *table, int i, double angle)
{
    return (angle - table->angle[i]) / (table->angle[i + 1] - table->angle[i]);
}

double lens_table_radius(const struct lens_table *table, double angle)
{
    double derivative;
    int i = interval_of(table->angle, table->count, angle);
    return cubic(table, i, place_in(table, i, angle), &derivative);
}

double lens_table_slope(const struct lens_table *table, double angle)
{
    double derivative;
    int i = interval_of(table->angle, table->count, angle);
    cubic(table, i, place_in(table, i, angle), &derivative);
    return derivative / (table->angle[i + 1] - table->angle[i]);
}

double lens_table_angle(const struct lens_table *table, double r)
{
    int i = interval_of(table->radius, table->count, r);
    double low = 0, high = 1;
    double t = (r - table->radius[i]) / (table->radius[i + 1] - table->radius[i]);
    t = fmin(fmax(t, 0), 1);
    for (int step = 0; step < 100; step++) {
        double derivative;
        double excess = cubic(table, i, t, &derivative) - r;
        if (excess > 0)
            high = t;
        else
            low = t;
        double next = t - excess / derivative;
        if (!(next > low && next < high))
            next = 0.5 * (low + high);
        if (fabs(next - t) <= 1e-16)
            break;
        t = next;
    }
    return table->angle[i] + t * (table->angle[i + 1] - table->angle[i]);
}
