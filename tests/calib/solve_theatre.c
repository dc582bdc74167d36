/* Random theatres with marks, and how well anybody could solve them. */
#include "solve_theatre.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cupola/dome.h>

#include "check.h"

static const double pi = 3.14159265358979323846, degree = 3.14159265358979323846 / 180;

double theatre_gauss(uint64_t *seed)
{
    double u = random_between(seed, 1e-300, 1), v = random_between(seed, 0, 2 * pi);

    return sqrt(-2 * log(u)) * cos(v);
}

static void random_in_ball(uint64_t *seed, double radius, double p[3])
{
    do {
        for (int i = 0; i < 3; i++)
            p[i] = random_between(seed, -radius, radius);
    } while (hypot(hypot(p[0], p[1]), p[2]) > radius);
}

static void random_lens(uint64_t *seed, struct cupola_lens *lens)
{
    static const double least[] = {140, 130, 140, 130, 150}, most[] = {220, 170, 210, 190, 200};

    lens->model = (enum cupola_lens_model)(int)random_between(seed, 0, 5);
    lens->fov_rad = degree * random_between(seed, least[lens->model], most[lens->model]);
    if (lens->model != CUPOLA_LENS_POLYNOMIAL)
        return;
    lens->k[0] = random_between(seed, 0.5, 2);
    lens->k[1] = lens->k[0] * random_between(seed, -0.06, 0.03);
    lens->k[2] = lens->k[0] * random_between(seed, -0.003, 0.003);
}

/* Full circles and such as frame buffers cut off. */
static void random_rig(uint64_t *seed, struct cupola_rig *rig)
{
    struct cupola_output *output = &rig->outputs[0];
    double radius_m = random_between(seed, 0.7, 8);

    *rig = (struct cupola_rig){.screen = {radius_m, degree * random_between(seed, 90, 120)}};
    rig->tilt_rad = random_between(seed, 0, pi / 2);
    random_in_ball(seed, 0.4 * radius_m, rig->eye_m);
    random_in_ball(seed, 0.5 * radius_m, output->position_m);
    output->width_px = 1400;
    output->height_px = random_between(seed, 0, 1) < 0.5 ? 1050 : 1400;
    output->circle.center_x_px = random_between(seed, 650, 750);
    output->circle.center_y_px = output->height_px * random_between(seed, 0.4, 0.6);
    output->circle.radius_px = random_between(seed, 500, 750);
    random_lens(seed, &output->lens);
    double off = degree * random_between(seed, 0, 20), way = random_between(seed, 0, 2 * pi);
    output->aim =
        (struct cupola_aim){off * cos(way), off * sin(way), degree * random_between(seed, -20, 20)};
    assert_int_equal(cupola_rig_complete(rig, rig, NULL), CUPOLA_OK);
}

/* One in each of as many fields of the image, as far as they are lit. */
static void place_marks(struct theatre *theatre, uint64_t *seed)
{
    const struct cupola_output *output = &theatre->truth.outputs[0];
    cupola_dome *dome = NULL;
    int placed = 0;

    assert_int_equal(cupola_dome_create(&theatre->truth, &dome, NULL), CUPOLA_OK);
    for (int t = 0; placed < THEATRE_MARKS; t++) {
        struct cupola_ray ray;
        double x = output->width_px * (t % 5 + random_between(seed, 0, 1)) / 5;
        double y = output->height_px * (t / 5 % 5 + random_between(seed, 0, 1)) / 5;
        assert_true(t < 10000);
        if (cupola_dome_ray(dome, 0, NULL, x, y, &ray) != 1 || ray.coverage < 1)
            continue;
        struct mark *mark = &theatre->list[placed++];
        *mark = (struct mark){.pixel_px = {x, y}, .steered = true};
        snprintf(mark->name, sizeof mark->name, "m%d", placed);
        for (int i = 0; i < 3; i++)
            mark->place[i] = ray.point_m[i] / theatre->truth.screen.radius_m;
    }
    cupola_dome_destroy(&dome);
}

void theatre_random(uint64_t seed, struct theatre *theatre)
{
    const struct cupola_output *output = &theatre->truth.outputs[0];

    seed = seed * 7919 + 17;
    *theatre = (struct theatre){.marks = {.kind = MARKS_DIRECTIONS, .count = THEATRE_MARKS}};
    theatre->marks.list = theatre->list;
    random_rig(&seed, &theatre->truth);
    theatre->noise_px = 0.05 * degree * output->circle.radius_px / (0.5 * output->lens.fov_rad);
    place_marks(theatre, &seed);
}

static void turn_direction(double d[3], double by_rad, double way_rad)
{
    double aside[3] = {0, 0, 0}, other[3];
    int least = fabs(d[0]) < fabs(d[1]) ? (fabs(d[0]) < fabs(d[2]) ? 0 : 2)
                                        : (fabs(d[1]) < fabs(d[2]) ? 1 : 2);
    double along = d[least], length = sqrt(1 - along * along);

    for (int i = 0; i < 3; i++)
        aside[i] = ((i == least) - along * d[i]) / length;
    for (int i = 0; i < 3; i++)
        other[i] = d[(i + 1) % 3] * aside[(i + 2) % 3] - d[(i + 2) % 3] * aside[(i + 1) % 3];
    for (int i = 0; i < 3; i++)
        d[i] =
            cos(by_rad) * d[i] + sin(by_rad) * (cos(way_rad) * aside[i] + sin(way_rad) * other[i]);
}

void theatre_add_noise(struct theatre *theatre, enum noise noise, double scale, uint64_t seed)
{
    for (int i = 0; i < THEATRE_MARKS; i++) {
        struct mark *mark = &theatre->list[i];
        double x = scale * theatre_gauss(&seed), y = scale * theatre_gauss(&seed);
        if (noise == NOISE_DIRECTIONS) {
            turn_direction(mark->place, 0.05 * degree * hypot(x, y), atan2(y, x));
        } else {
            mark->pixel_px[0] += theatre->noise_px * x;
            mark->pixel_px[1] += theatre->noise_px * y;
        }
    }
}

void theatre_start(const struct theatre *theatre, int free, uint64_t seed, struct cupola_rig *rig)
{
    struct cupola_output *output = &rig->outputs[0];

    *rig = theatre->truth;
    seed += 99;
    if (free & SOLVE_POSITION)
        memset(output->position_m, 0, sizeof output->position_m);
    if (free & SOLVE_AIM)
        output->aim = (struct cupola_aim){0, 0, 0};
    if (free & SOLVE_CIRCLE) {
        output->circle.center_x_px += 15 * theatre_gauss(&seed);
        output->circle.center_y_px += 15 * theatre_gauss(&seed);
    }
    if (free & SOLVE_CIRCLE_RADIUS)
        output->circle.radius_px *= random_between(&seed, 0.95, 1.05);
    if (free & SOLVE_LENS) {
        output->lens.fov_rad *= random_between(&seed, 0.95, 1.02);
        for (int i = 1; i < 4; i++)
            output->lens.k[i] *= random_between(&seed, 0.5, 1.2);
    }
    if (free & SOLVE_RADIUS)
        rig->screen.radius_m *= random_between(&seed, 0.95, 1.3);
}

static double *member(struct cupola_rig *rig, int value)
{
    struct cupola_output *output = &rig->outputs[0];
    double *const members[] = {
        &output->position_m[0],      &output->position_m[1],      &output->position_m[2],
        &output->aim.yaw_rad,        &output->aim.pitch_rad,      &output->aim.roll_rad,
        &output->circle.center_x_px, &output->circle.center_y_px, &output->circle.radius_px,
        &output->lens.fov_rad,       &output->lens.k[1],          &output->lens.k[2],
        &rig->screen.radius_m};

    return members[value];
}

double theatre_value(const struct cupola_rig *rig, int value)
{
    struct cupola_rig copy = *rig;

    return *member(&copy, value);
}

void theatre_move(struct cupola_rig *rig, int value, double by)
{
    *member(rig, value) += by;
}

static double curve(const struct cupola_lens *lens, double angle)
{
    double square = angle * angle;

    switch (lens->model) {
    case CUPOLA_LENS_HEMISPHERIC:
        return sin(angle);
    case CUPOLA_LENS_EQUISOLID:
        return sin(angle / 2);
    case CUPOLA_LENS_STEREOGRAPHIC:
        return tan(angle / 2);
    case CUPOLA_LENS_POLYNOMIAL:
        return angle * (lens->k[0] + square * (lens->k[1] + square * lens->k[2]));
    default:
        return angle;
    }
}

/* Turns p about axis a by -angle, in place. */
static void turn_back(double p[3], int axis, double angle)
{
    int u = (axis + 1) % 3, v = (axis + 2) % 3;
    double pu = p[u], pv = p[v];

    p[u] = cos(angle) * pu + sin(angle) * pv;
    p[v] = cos(angle) * pv - sin(angle) * pu;
}

void theatre_pixel(const struct cupola_rig *rig, const struct mark *mark, enum marks_kind kind,
                   double pixel_px[2])
{
    const struct cupola_output *output = &rig->outputs[0];
    double p[3], half = 0.5 * output->lens.fov_rad;

    for (int i = 0; i < 3; i++)
        p[i] = mark->place[i] * (kind == MARKS_POINTS ? 1 : rig->screen.radius_m) -
               output->position_m[i];
    turn_back(p, 1, output->aim.yaw_rad);
    turn_back(p, 0, output->aim.pitch_rad);
    turn_back(p, 2, output->aim.roll_rad);
    double across = hypot(p[0], p[1]), angle = atan2(across, -p[2]);
    double r = output->circle.radius_px * curve(&output->lens, angle) / curve(&output->lens, half);
    pixel_px[0] = output->circle.center_x_px + r * p[0] / across;
    pixel_px[1] = output->circle.center_y_px + r * p[1] / across;
}

int theatre_values(const struct theatre *theatre, int free, int values[THEATRE_VALUES])
{
    static const int flags[] = {SOLVE_POSITION,      SOLVE_POSITION, SOLVE_POSITION, SOLVE_AIM,
                                SOLVE_AIM,           SOLVE_AIM,      SOLVE_CIRCLE,   SOLVE_CIRCLE,
                                SOLVE_CIRCLE_RADIUS, SOLVE_LENS,     SOLVE_LENS,     SOLVE_LENS,
                                SOLVE_RADIUS};
    bool polynomial = theatre->truth.outputs[0].lens.model == CUPOLA_LENS_POLYNOMIAL;
    int count = 0;

    for (int i = 0; i <= T_RADIUS; i++) {
        bool told = i != T_RADIUS || theatre->marks.kind == MARKS_DIRECTIONS;
        if (free & flags[i] && told && (polynomial || (i != T_K3 && i != T_K5)))
            values[count++] = i;
    }
    return count;
}

/* Change of a mark's pixel by a value, and by its direction to one side and the other. */
static void derive(const struct theatre *theatre, const struct mark *mark, int value, double d[2])
{
    double step = value == T_CIRCLE_X || value == T_CIRCLE_Y ? 0.01 : 1e-5, at[2][2];

    for (int s = 0; s < 2; s++) {
        struct cupola_rig rig = theatre->truth;
        struct mark moved = *mark;
        double by = s ? step : -step;
        if (value >= THEATRE_VALUES)
            turn_direction(moved.place, by, value == THEATRE_VALUES ? 0 : pi / 2);
        else
            theatre_move(&rig, value, by);
        theatre_pixel(&rig, &moved, theatre->marks.kind, at[s]);
    }
    for (int c = 0; c < 2; c++)
        d[c] = (at[1][c] - at[0][c]) / (2 * step);
}

/* The information (inverse covariance) of a mark's pixel: xx, xy, yy. */
static void weigh(const struct theatre *theatre, const struct mark *mark, enum noise noise,
                  double w[3])
{
    double a[2], b[2], n = theatre->noise_px;

    w[0] = w[2] = 1 / (n * n);
    w[1] = 0;
    if (noise != NOISE_DIRECTIONS)
        return;
    derive(theatre, mark, THEATRE_VALUES, a);
    derive(theatre, mark, THEATRE_VALUES + 1, b);
    double s = 0.0025 * degree * degree;
    double xx = s * (a[0] * a[0] + b[0] * b[0]), yy = s * (a[1] * a[1] + b[1] * b[1]);
    double xy = s * (a[0] * a[1] + b[0] * b[1]), determinant = xx * yy - xy * xy;
    w[0] = yy / determinant;
    w[1] = -xy / determinant;
    w[2] = xx / determinant;
}

/* The diagonal of the inverse, by Gauss and Jordan on a matrix scaled to a diagonal of 1. */
static void invert_diagonal(int n, double *m, double *diagonal)
{
    enum { N = THEATRE_VALUES };
    double scale[N], both[N][2 * N] = {{0}};

    for (int i = 0; i < n; i++)
        scale[i] = 1 / sqrt(m[n * i + i]);
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++)
            both[i][j] = m[n * i + j] * scale[i] * scale[j];
        both[i][n + i] = 1;
    }
    for (int k = 0; k < n; k++) {
        double pivot = both[k][k];
        for (int j = 0; j < 2 * n; j++)
            both[k][j] /= pivot;
        for (int i = 0; i < n; i++) {
            double factor = both[i][k];
            for (int j = 0; i != k && j < 2 * n; j++)
                both[i][j] -= factor * both[k][j];
        }
    }
    for (int i = 0; i < n; i++)
        diagonal[i] = both[i][n + i] * scale[i] * scale[i];
}

void theatre_bound(const struct theatre *theatre, const int *values, int count, enum noise noise,
                   double *sd)
{
    double information[THEATRE_VALUES * THEATRE_VALUES] = {0}, d[THEATRE_VALUES][2], w[3];

    for (int m = 0; m < THEATRE_MARKS; m++) {
        weigh(theatre, &theatre->list[m], noise, w);
        for (int i = 0; i < count; i++)
            derive(theatre, &theatre->list[m], values[i], d[i]);
        for (int i = 0; i < count * count; i++) {
            const double *a = d[i / count], *b = d[i % count];
            information[i] +=
                w[0] * a[0] * b[0] + w[1] * (a[0] * b[1] + a[1] * b[0]) + w[2] * a[1] * b[1];
        }
    }
    invert_diagonal(count, information, sd);
    for (int i = 0; i < count; i++)
        sd[i] = sqrt(sd[i]);
}

static int compare(const void *a, const void *b)
{
    double first = *(const double *)a, second = *(const double *)b;

    return (first > second) - (first < second);
}

void theatre_direction_error(const struct theatre *theatre, const struct cupola_rig *solved,
                             double *median_rad, double *worst_rad)
{
    enum { ACROSS = 24 };
    cupola_dome *domes[2] = {NULL, NULL};
    double errors[ACROSS * ACROSS];
    int count = 0;

    assert_int_equal(cupola_dome_create(&theatre->truth, &domes[0], NULL), CUPOLA_OK);
    assert_int_equal(cupola_dome_create(solved, &domes[1], NULL), CUPOLA_OK);
    for (int i = 0; i < ACROSS * ACROSS; i++) {
        struct cupola_ray true_ray, ray;
        double x = theatre->truth.outputs[0].width_px * (i % ACROSS + 0.5) / ACROSS, square = 0;
        double y = theatre->truth.outputs[0].height_px * (i / ACROSS + 0.5) / ACROSS;
        if (cupola_dome_ray(domes[0], 0, NULL, x, y, &true_ray) != 1)
            continue;
        assert_true(cupola_dome_ray(domes[1], 0, NULL, x, y, &ray) >= 0);
        for (int k = 0; k < 3; k++)
            square += pow(ray.direction[k] - true_ray.direction[k], 2);
        errors[count++] = sqrt(square);
    }
    cupola_dome_destroy(&domes[0]);
    cupola_dome_destroy(&domes[1]);
    qsort(errors, (size_t)count, sizeof *errors, compare);
    *median_rad = errors[count / 2];
    *worst_rad = errors[count - 1];
}
