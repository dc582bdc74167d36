/* The lens models in double precision. shaders/lens.glsl says the same under the same names. */
#include "lens.h"

#include <math.h>
#include <stdbool.h>

#include "error.h"
#include "names.h"

static const char *const model_names[] = {
    [CUPOLA_LENS_ANGULAR] = "angular",       [CUPOLA_LENS_HEMISPHERIC] = "hemispheric",
    [CUPOLA_LENS_EQUISOLID] = "equisolid",   [CUPOLA_LENS_STEREOGRAPHIC] = "stereographic",
    [CUPOLA_LENS_POLYNOMIAL] = "polynomial", [CUPOLA_LENS_TABLE] = "table",
};

enum { MODEL_COUNT = sizeof model_names / sizeof model_names[0] };

const char *cupola_lens_model_name(int model)
{
    return name_of_number(model_names, MODEL_COUNT, model);
}

int cupola_lens_model_find(const char *name)
{
    return number_of_name(model_names, MODEL_COUNT, name);
}

static double polynomial_radius(const double k[4], double angle)
{
    double u = angle * angle;
    return angle * (k[0] + u * (k[1] + u * (k[2] + u * k[3])));
}

static double polynomial_slope(const double k[4], double angle)
{
    double u = angle * angle;
    return k[0] + u * (3 * k[1] + u * (5 * k[2] + u * 7 * k[3]));
}

/*
 * The place in [0, h] where the slope of the polynomial is least. In u = angle^2 the slope is a
 * cubic, so its extremes are the ends and the roots of 3 k3 + 10 k5 u + 21 k7 u^2.
 */
static double polynomial_least_slope_at(const double k[4], double h)
{
    double candidates[4] = {0, h, 0, 0};
    double a = 21 * k[3], b = 10 * k[2], c = 3 * k[1];
    double discriminant = b * b - 4 * a * c;
    if (discriminant >= 0) {
        /* The form of the solution in which nothing cancels, however small a is. */
        double q = -0.5 * (b + copysign(sqrt(discriminant), b));
        candidates[2] = a != 0 ? sqrt(fmax(q / a, 0)) : 0;
        candidates[3] = q != 0 ? sqrt(fmax(c / q, 0)) : 0;
    }
    double least_at = 0;
    for (int i = 0; i < 4; i++)
        if (candidates[i] <= h &&
            polynomial_slope(k, candidates[i]) < polynomial_slope(k, least_at))
            least_at = candidates[i];
    return least_at;
}

/* Image circles per radian. A curve less steep has no inverse worth the name. */
static const double least_slope = 1e-6;

static int polynomial_prepare(const struct cupola_lens *lens, double h, double k[4],
                              struct cupola_error *error)
{
    for (int i = 0; i < 4; i++)
        if (!isfinite(lens->k[i]))
            return error_set(error, CUPOLA_ERROR_ARGUMENT,
                             "lens coefficient k%d is %g; allowed: finite numbers", 2 * i + 1,
                             lens->k[i]);
    /* Any common factor cancels: the largest becomes 1, so that nothing under- or overflows. */
    double largest = 0, common[4];
    for (int i = 0; i < 4; i++)
        largest = fmax(largest, fabs(lens->k[i]));
    for (int i = 0; i < 4; i++)
        common[i] = largest > 0 ? lens->k[i] / largest : 0;
    double rim = polynomial_radius(common, h);
    if (!isfinite(rim) || rim == 0)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "lens polynomial k1..k7 = %g, %g, %g, %g is %g at half of the field of "
                         "view, %g rad (%g degrees); allowed: a finite value other than 0",
                         lens->k[0], lens->k[1], lens->k[2], lens->k[3], rim, RAD_AND_DEG(h));
    for (int i = 0; i < 4; i++)
        k[i] = common[i] / rim;
    double worst = polynomial_least_slope_at(k, h);
    if (!(polynomial_slope(k, worst) > least_slope))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "lens polynomial k1..k7 = %g, %g, %g, %g does not increase at %g rad "
                         "(%g degrees); allowed: increasing up to half of the field of view, %g "
                         "rad (%g degrees)",
                         lens->k[0], lens->k[1], lens->k[2], lens->k[3], RAD_AND_DEG(worst),
                         RAD_AND_DEG(h));
    return CUPOLA_OK;
}

static double polynomial_angle(const double k[4], double h, double r)
{
    double low = 0, high = h, angle = r * h;
    if (!(r > 0))
        return 0;
    for (int i = 0; i < 100; i++) {
        double excess = polynomial_radius(k, angle) - r;
        if (excess > 0)
            high = angle;
        else
            low = angle;
        double next = angle - excess / polynomial_slope(k, angle);
        if (!(next > low && next < high))
            next = 0.5 * (low + high);
        if (fabs(next - angle) <= 1e-16 * h)
            return next;
        angle = next;
    }
    return angle;
}

/* Below, angles and their squares are no numbers of their own. */
static const double fov_min = 1e-6;

static int check_fov(const struct cupola_lens *lens, double fov, struct cupola_error *error)
{
    double limit = lens->model == CUPOLA_LENS_HEMISPHERIC ? pi : 2 * pi;
    bool open = lens->model == CUPOLA_LENS_STEREOGRAPHIC;
    if (fov > 0 && fov < fov_min)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "lens field of view is %g rad (%g degrees); allowed: from %g rad on",
                         RAD_AND_DEG(fov), fov_min);
    if (fov > 0 && (open ? fov < limit - 1e-9 : fov <= limit + angle_slack))
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_ARGUMENT,
                     "lens field of view is %g rad (%g degrees); allowed for %s: above 0 and %s "
                     "%g rad (%g degrees)",
                     RAD_AND_DEG(fov), model_names[lens->model], open ? "below" : "up to",
                     RAD_AND_DEG(limit));
}

int lens_prepare(const struct cupola_lens *lens, struct lens *prepared, struct cupola_error *error)
{
    if (!cupola_lens_model_name((int)lens->model))
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "lens model is %d; allowed: 0 to %d",
                         (int)lens->model, MODEL_COUNT - 1);
    if (lens->model == CUPOLA_LENS_TABLE &&
        (lens->table_count < 2 || lens->table_count > CUPOLA_LENS_TABLE_MAX))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "lens table has %d samples; allowed: 2 to %d", lens->table_count,
                         CUPOLA_LENS_TABLE_MAX);

    double fov = lens->fov_rad;
    if (fov == 0)
        fov = lens->model == CUPOLA_LENS_TABLE ? 2 * lens->table[lens->table_count - 1].angle_rad
                                               : pi;
    struct lens ready = {.model = lens->model, .half_fov = 0.5 * fov, .scale = 1};
    double h = ready.half_fov;
    int status = CUPOLA_OK;
    if (lens->model == CUPOLA_LENS_TABLE)
        status = lens_table_prepare(lens, h, &ready.table, error);
    if (status == CUPOLA_OK)
        status = check_fov(lens, fov, error);
    if (status == CUPOLA_OK && lens->model == CUPOLA_LENS_POLYNOMIAL)
        status = polynomial_prepare(lens, h, ready.k, error);
    if (status != CUPOLA_OK)
        return status;

    if (lens->model == CUPOLA_LENS_HEMISPHERIC)
        ready.scale = sin(h);
    else if (lens->model == CUPOLA_LENS_EQUISOLID)
        ready.scale = sin(0.5 * h);
    else if (lens->model == CUPOLA_LENS_STEREOGRAPHIC)
        ready.scale = tan(0.5 * h);
    *prepared = ready;
    return CUPOLA_OK;
}

double lens_radius(const struct lens *lens, double angle)
{
    switch (lens->model) {
    case CUPOLA_LENS_ANGULAR:
        return angle / lens->half_fov;
    case CUPOLA_LENS_HEMISPHERIC:
        return sin(angle) / lens->scale;
    case CUPOLA_LENS_EQUISOLID:
        return sin(0.5 * angle) / lens->scale;
    case CUPOLA_LENS_STEREOGRAPHIC:
        return tan(0.5 * angle) / lens->scale;
    case CUPOLA_LENS_POLYNOMIAL:
        return polynomial_radius(lens->k, angle);
    case CUPOLA_LENS_TABLE:
        return lens_table_radius(&lens->table, angle);
    }
    return nan("");
}

double lens_angle(const struct lens *lens, double r)
{
    switch (lens->model) {
    case CUPOLA_LENS_ANGULAR:
        return lens->half_fov * r;
    case CUPOLA_LENS_HEMISPHERIC:
        return asin(fmin(r * lens->scale, 1));
    case CUPOLA_LENS_EQUISOLID:
        return 2 * asin(fmin(r * lens->scale, 1));
    case CUPOLA_LENS_STEREOGRAPHIC:
        return 2 * atan(r * lens->scale);
    case CUPOLA_LENS_POLYNOMIAL:
        return polynomial_angle(lens->k, lens->half_fov, r);
    case CUPOLA_LENS_TABLE:
        return fmin(lens_table_angle(&lens->table, r), lens->half_fov);
    }
    return nan("");
}

double lens_angle_slope(const struct lens *lens, double r, double angle)
{
    /* At the rim of a hemispheric lens of 180 degrees (equisolid: 360) the slope is infinite; this
     * bound keeps products with it finite and is met only within 1e-12 of the rim. */
    static const double least_cosine = 1e-6;
    double s = lens->scale;
    switch (lens->model) {
    case CUPOLA_LENS_ANGULAR:
        return lens->half_fov;
    case CUPOLA_LENS_HEMISPHERIC:
        return s / sqrt(fmax(1 - r * r * s * s, least_cosine * least_cosine));
    case CUPOLA_LENS_EQUISOLID:
        return 2 * s / sqrt(fmax(1 - r * r * s * s, least_cosine * least_cosine));
    case CUPOLA_LENS_STEREOGRAPHIC:
        return 2 * s / (1 + r * r * s * s);
    case CUPOLA_LENS_POLYNOMIAL:
        return 1 / polynomial_slope(lens->k, angle);
    case CUPOLA_LENS_TABLE:
        return 1 / fmax(lens_table_slope(&lens->table, angle), least_cosine);
    }
    return nan("");
}

int cupola_lens_validate(const struct cupola_lens *lens, struct cupola_error *error)
{
    struct lens prepared;
    if (!lens)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "lens is NULL; allowed: a lens");
    return lens_prepare(lens, &prepared, error);
}

double cupola_lens_radius(const struct cupola_lens *lens, double angle_rad)
{
    struct lens prepared;
    if (!lens || lens_prepare(lens, &prepared, NULL) != CUPOLA_OK || isnan(angle_rad))
        return nan("");
    return angle_rad >= prepared.half_fov ? 1 : lens_radius(&prepared, fmax(angle_rad, 0));
}

double cupola_lens_angle(const struct cupola_lens *lens, double radius)
{
    struct lens prepared;
    if (!lens || lens_prepare(lens, &prepared, NULL) != CUPOLA_OK || isnan(radius))
        return nan("");
    return radius >= 1 ? prepared.half_fov : lens_angle(&prepared, fmax(radius, 0));
}
