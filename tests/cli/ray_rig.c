/* Random theatres and the command lines that ask for them. */
#include "ray_rig.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "check.h"

static const char *const LENS_NAMES[LENS_KINDS] = {"angular", "hemispheric", "equisolid",
                                                   "stereographic", "polynomial"};

static bool chance(uint64_t *random, double share)
{
    return random_between(random, 0, 1) < share;
}

/* Three decimals, as on the command line. */
static double random_rounded(uint64_t *random, double low, double high)
{
    return round(random_between(random, low, high) * 1e3) / 1e3;
}

/* Anywhere in a ball. */
static struct vector random_place(uint64_t *random, double radius)
{
    struct vector place;

    do {
        place.x = random_rounded(random, -radius, radius);
        place.y = random_rounded(random, -radius, radius);
        place.z = random_rounded(random, -radius, radius);
    } while (vector_dot(place, place) > radius * radius);
    return place;
}

static void append(struct ray_rig *rig, const char *format, ...)
{
    size_t length = strlen(rig->command);
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(rig->command + length, sizeof rig->command - length, format, arguments);
    va_end(arguments);
    assert_true(strlen(rig->command) < sizeof rig->command - 1);
}

static void make_lens(struct ray_rig *rig, int number, uint64_t *random)
{
    struct theatre *theatre = &rig->theatre;
    double fov_max_deg = 220;

    theatre->lens = (enum traced_lens)(number % LENS_KINDS);
    if (theatre->lens == HEMISPHERIC)
        fov_max_deg = 180;
    do {
        theatre->fov_deg = random_rounded(random, 60, fov_max_deg);
        theatre->k[0] = random_rounded(random, 0.5, 2);
        theatre->k[1] = random_rounded(random, -0.2, 0.1);
        theatre->k[2] = random_rounded(random, -0.02, 0.04);
        theatre->k[3] = random_rounded(random, -0.004, 0.004);
    } while (!theatre_lens_is_monotone(theatre));
    append(rig, " --lens %s --fov %.3f", LENS_NAMES[theatre->lens], theatre->fov_deg);
    if (theatre->lens == POLYNOMIAL)
        append(rig, " --lens-k %.3f,%.3f,%.3f,%.3f", theatre->k[0], theatre->k[1], theatre->k[2],
               theatre->k[3]);
}

static void make_picture(struct ray_rig *rig, uint64_t *random)
{
    struct theatre *theatre = &rig->theatre;
    double side_px = fmin(theatre->width_px, theatre->height_px);
    int flips = chance(random, 0.7) ? 0 : (int)random_between(random, 1, 4);

    append(rig, " --size %dx%d", theatre->width_px, theatre->height_px);
    theatre->circle_x_px = theatre->width_px / 2.0;
    theatre->circle_y_px = theatre->height_px / 2.0;
    theatre->circle_radius_px = side_px / 2;
    if (chance(random, 0.35)) { /* cut off, or smaller than the picture */
        theatre->circle_x_px += random_rounded(random, -0.2, 0.2) * side_px;
        theatre->circle_y_px += random_rounded(random, -0.2, 0.2) * side_px;
        theatre->circle_radius_px = random_rounded(random, 0.3, 0.8) * side_px;
        append(rig, " --circle %.9g,%.9g,%.9g", theatre->circle_x_px, theatre->circle_y_px,
               theatre->circle_radius_px);
    }
    theatre->flip_x = flips & 1;
    theatre->flip_y = flips & 2;
    if (flips)
        append(rig, " --flip %s%s", theatre->flip_x ? "x" : "", theatre->flip_y ? "y" : "");
}

static void make_room(struct ray_rig *rig, uint64_t *random)
{
    struct theatre *theatre = &rig->theatre;

    theatre->radius_m = random_rounded(random, 0.3, 3);
    theatre->cap_deg = 180;
    append(rig, " --radius %.3f", theatre->radius_m);
    if (chance(random, 0.75)) {
        theatre->viewer_m = random_place(random, 0.8 * theatre->radius_m);
        append(rig, " --viewer %.3f,%.3f,%.3f", theatre->viewer_m.x, theatre->viewer_m.y,
               theatre->viewer_m.z);
    }
    if (chance(random, 0.6)) {
        theatre->projector_m = random_place(random, 0.8 * theatre->radius_m);
        append(rig, " --projector %.3f,%.3f,%.3f", theatre->projector_m.x, theatre->projector_m.y,
               theatre->projector_m.z);
    }
    if (chance(random, 0.3)) {
        for (int i = 0; i < 3; i++)
            theatre->aim_deg[i] = random_rounded(random, -40, 40);
        append(rig, " --projector-aim %.3f,%.3f,%.3f", theatre->aim_deg[0], theatre->aim_deg[1],
               theatre->aim_deg[2]);
    }
    if (chance(random, 0.2)) {
        theatre->cap_deg = random_rounded(random, 50, 120);
        append(rig, " --cap %.3f", theatre->cap_deg);
    }
    if (chance(random, 0.5))
        theatre->tilt_deg = random_rounded(random, -90, 120);
    append(rig, " --tilt %.3f", theatre->tilt_deg);
}

static void make_camera(struct ray_rig *rig, uint64_t *random)
{
    struct theatre *theatre = &rig->theatre;

    theatre->look = (struct vector){0, 0, -1};
    if (chance(random, 0.4)) {
        theatre->camera = random_place(random, 20);
        do
            theatre->look = random_place(random, 2);
        while (hypot(theatre->look.x, theatre->look.z) < 0.5);
        theatre->look = vector_add(theatre->camera, theatre->look);
        append(rig, " --look %.3f,%.3f,%.3f", theatre->look.x, theatre->look.y, theatre->look.z);
    }
    append(rig, " --camera %.3f,%.3f,%.3f", theatre->camera.x, theatre->camera.y,
           theatre->camera.z);
}

/* The largest angle between the host's forward direction and what the viewer sees. */
static double widest_deg(const struct theatre *theatre)
{
    static const struct traced_world nothing;
    struct theatre straight = *theatre;
    struct tracer tracer;
    double least = 1;

    straight.camera = (struct vector){0, 0, 0};
    straight.look = (struct vector){0, 0, -1};
    tracer_prepare(&tracer, &straight, &nothing);
    for (double x = 0.5; x < theatre->width_px; x += 2)
        for (double y = 0.5; y < theatre->height_px; y += 2) {
            struct vector ray;

            if (hypot(x - theatre->circle_x_px, y - theatre->circle_y_px) >
                theatre->circle_radius_px)
                continue;
            tracer_ray(&tracer, x, y, &ray);
            least = fmin(least, -ray.z);
        }
    return acos(least) * 180 / 3.14159265358979323846;
}

static void choose_views(struct ray_rig *rig, uint64_t *random)
{
    if (widest_deg(&rig->theatre) < 75 && chance(random, 0.6))
        append(rig, " --layout asymmetric --views %d", (int)random_between(random, 1, 9));
    else if (chance(random, 0.3))
        append(rig, " --layout rotated --views %d", (int)random_between(random, 4, 9));
    else if (chance(random, 0.3))
        append(rig, " --layout rotated");
    if (chance(random, 0.2))
        append(rig, " --density 1.5");
}

void ray_rig_make(struct ray_rig *rig, int number, int width_px, int height_px, uint64_t *random)
{
    memset(rig, 0, sizeof *rig);
    rig->theatre.width_px = width_px;
    rig->theatre.height_px = height_px;
    append(rig, "--flat --headless");
    make_lens(rig, number, random);
    make_picture(rig, random);
    make_room(rig, random);
    make_camera(rig, random);
    choose_views(rig, random);
}
