/* Rays from the viewer's eye against triangles, and what a pixel may look like. */
#include "ray_tracer.h"

#include <math.h>
#include <string.h>

#include "srgb.h"

static const double DEGREE = 3.14159265358979323846 / 180;

/*
 * How far, in pixels right and up, the texels lie from which a pixel is filtered: at a density
 * without loss a texel is at most a pixel wide, and a bilinear tap is less than a texel away in
 * each direction of the view, so at most 1.42 away in a direction of the picture.
 */
static const double REACH_PX = 1.5;

enum { FILTER_STEPS = 6, COVERAGE_STEPS = 64, NEAR_MAX = 64 };

struct vector vector_add(struct vector a, struct vector b)
{
    return (struct vector){a.x + b.x, a.y + b.y, a.z + b.z};
}

struct vector vector_scaled(struct vector a, double factor)
{
    return (struct vector){a.x * factor, a.y * factor, a.z * factor};
}

double vector_dot(struct vector a, struct vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

struct vector vector_cross(struct vector a, struct vector b)
{
    return (struct vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct vector vector_normal(struct vector a)
{
    return vector_scaled(a, 1 / sqrt(vector_dot(a, a)));
}

static double distance(struct vector a, struct vector b)
{
    struct vector apart = vector_add(a, vector_scaled(b, -1));

    return sqrt(vector_dot(apart, apart));
}

struct vector vector_rotated(const struct rotation *rotation, struct vector a)
{
    return vector_add(vector_add(vector_scaled(rotation->x, a.x), vector_scaled(rotation->y, a.y)),
                      vector_scaled(rotation->z, a.z));
}

static struct rotation product(const struct rotation *a, const struct rotation *b)
{
    return (struct rotation){vector_rotated(a, b->x), vector_rotated(a, b->y),
                             vector_rotated(a, b->z)};
}

static struct rotation about_x(double deg)
{
    double c = cos(deg * DEGREE), s = sin(deg * DEGREE);

    return (struct rotation){{1, 0, 0}, {0, c, s}, {0, -s, c}};
}

static struct rotation about_y(double deg)
{
    double c = cos(deg * DEGREE), s = sin(deg * DEGREE);

    return (struct rotation){{c, 0, -s}, {0, 1, 0}, {s, 0, c}};
}

static struct rotation about_z(double deg)
{
    double c = cos(deg * DEGREE), s = sin(deg * DEGREE);

    return (struct rotation){{c, s, 0}, {-s, c, 0}, {0, 0, 1}};
}

/* From the dome frame to the world: tilt, then the camera that looks at a point, +Y up. */
static struct rotation host_rotation(const struct theatre *theatre)
{
    struct vector back =
        vector_normal(vector_add(theatre->camera, vector_scaled(theatre->look, -1)));
    struct vector right = vector_normal(vector_cross((struct vector){0, 1, 0}, back));
    struct rotation camera = {right, vector_cross(back, right), back};
    struct rotation tilt = about_x(theatre->tilt_deg);

    return product(&camera, &tilt);
}

struct vector theatre_eye(const struct theatre *theatre)
{
    struct rotation host = host_rotation(theatre);

    return vector_add(theatre->camera, vector_rotated(&host, theatre->viewer_m));
}

static double polynomial(const double k[4], double angle)
{
    double square = angle * angle;

    return angle * (k[0] + square * (k[1] + square * (k[2] + square * k[3])));
}

bool theatre_lens_is_monotone(const struct theatre *theatre)
{
    enum { STEPS = 1000 };
    double step = theatre->fov_deg / 2 * DEGREE / STEPS;

    if (theatre->lens != POLYNOMIAL)
        return true;
    for (int i = 0; i < STEPS; i++) /* with a slope that leaves the inverse well conditioned */
        if (polynomial(theatre->k, (i + 1) * step) - polynomial(theatre->k, i * step) < 0.2 * step)
            return false;
    return true;
}

/* The angle off the axis of image radius r <= 1. */
static double lens_angle(const struct theatre *theatre, double r)
{
    double h = theatre->fov_deg / 2 * DEGREE, low = 0, high = h, wished, middle;

    switch (theatre->lens) {
    case ANGULAR:
        return h * r;
    case HEMISPHERIC:
        return asin(fmin(r * sin(h), 1));
    case EQUISOLID:
        return 2 * asin(r * sin(h / 2));
    case STEREOGRAPHIC:
        return 2 * atan(r * tan(h / 2));
    default:
        break;
    }
    wished = r * polynomial(theatre->k, h);
    for (int i = 0; i < 45; i++) {
        middle = (low + high) / 2;
        if (polynomial(theatre->k, middle) < wished)
            low = middle;
        else
            high = middle;
    }
    return (low + high) / 2;
}

/* Of image radius r <= 1 in direction `azimuth` of the picture. */
static bool ray_inside(const struct tracer *tracer, double r, double azimuth, struct vector *ray)
{
    const struct theatre *theatre = &tracer->theatre;
    double angle = lens_angle(theatre, r), along, t;
    struct vector lens_ray, point;

    lens_ray = (struct vector){sin(angle) * cos(azimuth), sin(angle) * sin(azimuth), -cos(angle)};
    lens_ray = vector_rotated(&tracer->aim, lens_ray);
    along = vector_dot(theatre->projector_m, lens_ray);
    t = -along + sqrt(along * along - vector_dot(theatre->projector_m, theatre->projector_m) +
                      theatre->radius_m * theatre->radius_m);
    point = vector_add(theatre->projector_m, vector_scaled(lens_ray, t));
    *ray = vector_add(point, vector_scaled(theatre->viewer_m, -1));
    *ray = vector_normal(vector_rotated(&tracer->host, *ray));
    return theatre->cap_deg >= 180 ||
           acos(fmax(-1, -point.z / theatre->radius_m)) <= theatre->cap_deg * DEGREE;
}

bool tracer_ray(const struct tracer *tracer, double x_px, double y_px, struct vector *ray)
{
    const struct theatre *theatre = &tracer->theatre;
    double x = (x_px - theatre->circle_x_px) / theatre->circle_radius_px;
    double y = (y_px - theatre->circle_y_px) / theatre->circle_radius_px;
    double r = hypot(x, y);
    double azimuth = atan2(theatre->flip_y ? -y : y, theatre->flip_x ? -x : x);
    struct vector inner;
    bool on_screen = ray_inside(tracer, fmin(r, 1), azimuth, ray);

    if (r > 1) {
        ray_inside(tracer, fmax(2 - r, 0), azimuth, &inner);
        *ray = vector_normal(vector_add(vector_scaled(*ray, 2), vector_scaled(inner, -1)));
    }
    return on_screen;
}

/* A cone round the triangle, to skip it by; one of 90 degrees and more would not be convex. */
static void enclose(struct seen_triangle *seen, const struct vector corner[3])
{
    struct vector sum = {0, 0, 0};

    for (int i = 0; i < 3; i++)
        sum = vector_add(sum, vector_normal(corner[i]));
    seen->middle = vector_normal(sum);
    seen->reach = 0;
    for (int i = 0; i < 3; i++)
        seen->reach = fmax(seen->reach, distance(seen->middle, vector_normal(corner[i])));
    if (seen->reach > 1.4)
        seen->reach = 2;
}

void tracer_prepare(struct tracer *tracer, const struct theatre *theatre,
                    const struct traced_world *world)
{
    struct rotation yaw = about_y(theatre->aim_deg[0]), pitch = about_x(theatre->aim_deg[1]);
    struct rotation roll = about_z(theatre->aim_deg[2]), turned = product(&yaw, &pitch);
    struct vector eye = theatre_eye(theatre), corner[3];

    tracer->theatre = *theatre;
    tracer->aim = product(&turned, &roll);
    tracer->host = host_rotation(theatre);
    tracer->triangle_count = 0;
    for (int t = 0; t < world->triangle_count; t++) {
        struct seen_triangle *seen = &tracer->triangles[tracer->triangle_count];
        double volume;

        for (int i = 0; i < 3; i++)
            corner[i] = vector_add(world->triangles[t].corner[i], vector_scaled(eye, -1));
        volume = vector_dot(corner[0], vector_cross(corner[1], corner[2]));
        if (volume == 0) /* seen from its edge */
            continue;
        for (int i = 0; i < 3; i++)
            seen->side[i] =
                vector_scaled(vector_cross(corner[(i + 1) % 3], corner[(i + 2) % 3]), 1 / volume);
        seen->plane = vector_add(vector_add(seen->side[0], seen->side[1]), seen->side[2]);
        seen->colour = world->colours[world->triangles[t].colour];
        enclose(seen, corner);
        tracer->triangle_count++;
    }
}

/* Triangles that the rays between four corner rays may meet. */
struct neighbourhood {
    const struct seen_triangle *triangles[NEAR_MAX];
    int count;
};

/* 0 where no ray between the corners meets the triangle, 2 where all do, 1 where some may. */
static int meeting(const struct seen_triangle *triangle, const struct vector corners[4])
{
    int all = 2;

    for (int i = 0; i < 3; i++) {
        int inside = 0;

        for (int c = 0; c < 4; c++)
            inside += vector_dot(triangle->side[i], corners[c]) >= 0;
        if (inside == 0)
            return 0;
        if (inside < 4)
            all = 1;
    }
    return all;
}

/* Whether a is nearer than b along every ray between the corners. */
static bool hides(const struct seen_triangle *a, const struct seen_triangle *b,
                  const struct vector corners[4])
{
    for (int c = 0; c < 4; c++)
        if (vector_dot(a->plane, corners[c]) <= vector_dot(b->plane, corners[c]))
            return false;
    return true;
}

static void look_round(const struct tracer *tracer, const struct vector corners[4],
                       struct neighbourhood *near)
{
    const struct seen_triangle *front = NULL;
    struct vector middle =
        vector_add(vector_add(corners[0], corners[1]), vector_add(corners[2], corners[3]));
    double reach = 0;
    int kept = 0;

    middle = vector_normal(middle);
    for (int c = 0; c < 4; c++)
        reach = fmax(reach, distance(middle, corners[c]));
    near->count = 0;
    for (int t = 0; t < tracer->triangle_count && near->count < NEAR_MAX; t++) {
        const struct seen_triangle *triangle = &tracer->triangles[t];
        int met;
        if (distance(triangle->middle, middle) > triangle->reach + reach)
            continue;
        met = meeting(triangle, corners);
        if (met == 0)
            continue;
        near->triangles[near->count++] = triangle;
        if (met == 2 && (!front || hides(triangle, front, corners)))
            front = triangle;
    }
    for (int n = 0; n < near->count; n++)
        if (!front || !hides(front, near->triangles[n], corners))
            near->triangles[kept++] = near->triangles[n];
    near->count = kept;
}

/* The colour of the nearest triangle; NULL where there is none. */
static const double *shoot(const struct neighbourhood *near, struct vector ray)
{
    const double *colour = NULL;
    double nearest = 0;

    for (int n = 0; n < near->count; n++) {
        const struct seen_triangle *triangle = near->triangles[n];
        double closeness = vector_dot(triangle->plane, ray);

        if (closeness > nearest && vector_dot(triangle->side[0], ray) >= 0 &&
            vector_dot(triangle->side[1], ray) >= 0 && vector_dot(triangle->side[2], ray) >= 0) {
            nearest = closeness;
            colour = triangle->colour;
        }
    }
    return colour;
}

/*
 * In linear light. Bilinear filtering is, on the average over where the texels lie, a tent of a
 * texel's width.
 */
static void filter(const struct tracer *tracer, const struct neighbourhood *near, double x_px,
                   double y_px, struct expectation *expectation)
{
    const double step = 2.0 / FILTER_STEPS;

    memset(expectation->mean, 0, sizeof expectation->mean);
    memset(expectation->right, 0, sizeof expectation->right);
    memset(expectation->up, 0, sizeof expectation->up);
    for (int n = 0; n < FILTER_STEPS * FILTER_STEPS; n++) {
        double x = -1 + (n % FILTER_STEPS + 0.5) * step;
        double y = -1 + (n / FILTER_STEPS + 0.5) * step;
        double tent_x = (1 - fabs(x)) * step, tent_y = (1 - fabs(y)) * step;
        const double *colour;
        struct vector ray;
        tracer_ray(tracer, x_px + x, y_px + y, &ray);
        colour = shoot(near, ray);
        for (int c = 0; colour && c < 3; c++) {
            double light = light_decoded(colour[c]);
            expectation->mean[c] += tent_x * tent_y * light;
            expectation->right[c] += copysign(step, x) * tent_y * light;
            expectation->up[c] += copysign(step, y) * tent_x * light;
        }
    }
}

/*
 * The part of pixel (i, j) that lies inside the image circle: the sum over lines along which the
 * rim is crossed rather than followed.
 */
static double coverage(const struct theatre *theatre, int i, int j)
{
    double x = i - theatre->circle_x_px, y = j - theatre->circle_y_px;
    double radius = theatre->circle_radius_px, sum = 0;
    bool upright = fabs(y + 0.5) > fabs(x + 0.5);
    double across = upright ? x : y, along = upright ? y : x;

    for (int n = 0; n < COVERAGE_STEPS; n++) {
        double place = across + (n + 0.5) / COVERAGE_STEPS;
        double half = fabs(place) < radius ? sqrt(radius * radius - place * place) : 0;

        sum += fmax(0, fmin(along + 1, half) - fmax(along, -half));
    }
    return sum / COVERAGE_STEPS;
}

void tracer_expect(const struct tracer *tracer, int i, int j, struct expectation *expectation)
{
    const struct theatre *theatre = &tracer->theatre;
    double x_px = i + 0.5, y_px = j + 0.5, share = coverage(theatre, i, j);
    double outermost_px = hypot(fabs(x_px - theatre->circle_x_px) + REACH_PX,
                                fabs(y_px - theatre->circle_y_px) + REACH_PX);
    double slack = share < 1 ? 1 / 255.0 : 0; /* a rim is no straight line */
    double least = fmax(share - slack, 0), most = fmin(share + slack, 1);
    struct neighbourhood near;
    struct vector corners[4];
    int on_screen = 0;
    memset(expectation, 0, sizeof *expectation);
    if (share == 0 && hypot(x_px - theatre->circle_x_px, y_px - theatre->circle_y_px) >
                          theatre->circle_radius_px + 1)
        return;
    for (int c = 0; c < 4; c++) /* counter-clockwise */
        on_screen += tracer_ray(tracer, x_px + (c == 0 || c == 3 ? -REACH_PX : REACH_PX),
                                y_px + (c < 2 ? -REACH_PX : REACH_PX), &corners[c]);
    if (on_screen == 0)
        return;
    look_round(tracer, corners, &near);
    for (int c = 0; c < 3; c++) {
        expectation->low[c] = near.count > 0 && on_screen == 4 ? 1 : 0;
        for (int n = 0; n < near.count; n++) {
            const double *colour = near.triangles[n]->colour;

            expectation->low[c] = fmin(expectation->low[c], colour[c]);
            expectation->high[c] = fmax(expectation->high[c], colour[c]);
            expectation->edge |= colour != near.triangles[0]->colour;
        }
        expectation->low[c] = light_encoded(least * light_decoded(expectation->low[c]));
        expectation->high[c] = light_encoded(most * light_decoded(expectation->high[c]));
    }
    expectation->inside = on_screen == 4 && outermost_px < theatre->circle_radius_px;
    if (expectation->inside && expectation->edge)
        filter(tracer, &near, x_px, y_px, expectation);
}
