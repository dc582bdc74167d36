/*
 * The demo against a ray tracer that shares nothing with it, for random worlds and theatres. The
 * long form (CUPOLA_LONG=1) has a hundred at 512 x 512; CUPOLA_SEED=N runs number N alone.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#pragma GCC diagnostic ignored "-Wunused-function" /* until the end: static and not all used */
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdouble-promotion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wundef"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb_image.h>
#pragma GCC diagnostic pop

#include "check.h"
#include "process.h"
#include "ray_rig.h"

static struct ray_rig rig;
static struct traced_world world;
static struct tracer tracer;
static struct process process;
static struct comparison comparison;

static bool is_long(void)
{
    const char *wish = getenv("CUPOLA_LONG");

    return wish && *wish && strcmp(wish, "0") != 0;
}

/*
 * Rig `number` in its world, drawn by the demo `scale` times as large; the picture is the caller's
 * to free.
 */
static unsigned char *draw(int number, int scale)
{
    static const int SIZES_PX[][2] = {{256, 256}, {317, 241}, {200, 260}};
    static const int LONG_SIZE_PX[2] = {512, 512};
    const int *size_px = is_long() ? LONG_SIZE_PX : SIZES_PX[number % 3];
    uint64_t random = 0x6375706f6c610000u + (uint64_t)number;
    int width = 0, height = 0, channels;
    unsigned char *picture;

    ray_rig_make(&rig, number, scale * size_px[0], scale * size_px[1], &random);
    traced_world_make(&world, theatre_eye(&rig.theatre), &random);
    traced_world_write(&world, "world", &random);
    strcat(rig.command, " --output x.png world.obj");
    remove("x.png");
    process_run(&process, rig.command, NULL);
    if (process.status != 0) {
        print_error("number %d: cupola-demo %s\n%s", number, rig.command, process.err);
        return NULL;
    }
    picture = stbi_load("x.png", &width, &height, &channels, 3);
    assert_non_null(picture);
    assert_int_equal(width, rig.theatre.width_px);
    assert_int_equal(height, rig.theatre.height_px);
    return picture;
}

static bool agrees(int number)
{
    unsigned char *picture = draw(number, 1);
    bool good = false;

    memset(&comparison, 0, sizeof comparison);
    if (!picture)
        return false;
    tracer_prepare(&tracer, &rig.theatre, &world);
    ray_compare(&comparison, &tracer, picture, getenv("CUPOLA_SEED") != NULL);
    good = ray_comparison_is_good(&comparison);
    if (!good || getenv("CUPOLA_SEED")) {
        printf("number %d: cupola-demo %s\n", number, rig.command);
        ray_comparison_print(&comparison);
    }
    stbi_image_free(picture);
    return good;
}

static void the_demo_draws_what_a_ray_tracer_sees(void **state)
{
    const char *seed = getenv("CUPOLA_SEED");
    int first = seed ? atoi(seed) : 0, count = seed ? 1 : is_long() ? 100 : 9, bad = 0;
    int measured = 0;

    (void)state;
    for (int number = first; number < first + count; number++) {
        bad += !agrees(number);
        measured += comparison.has_edges;
    }
    assert_int_equal(bad, 0);
    assert_true(seed || measured >= 0.9 * count); /* a few see one wall and nothing else */
}

struct error {
    const char *name;
    size_t place;        /* of the number in the theatre */
    double by, by_radii; /* degrees, pixels; parts of the screen's radius */
};

/* The oracle itself: the same picture held against theatres that are a little wrong. */
static void check_errors_are_caught(int number)
{
    static const struct error ERRORS[] = {
        {"fov", offsetof(struct theatre, fov_deg), 0.1, 0},
        {"yaw", offsetof(struct theatre, aim_deg[0]), 0.1, 0},
        {"pitch", offsetof(struct theatre, aim_deg[1]), 0.1, 0},
        {"roll", offsetof(struct theatre, aim_deg[2]), 0.1, 0},
        {"tilt", offsetof(struct theatre, tilt_deg), -0.1, 0},
        {"circle's centre", offsetof(struct theatre, circle_x_px), 1, 0},
        {"circle's radius", offsetof(struct theatre, circle_radius_px), -1, 0},
        {"viewer's x", offsetof(struct theatre, viewer_m.x), 0, 0.01},
        {"viewer's y", offsetof(struct theatre, viewer_m.y), 0, 0.01},
        {"viewer's z", offsetof(struct theatre, viewer_m.z), 0, -0.01},
        {"projector's x", offsetof(struct theatre, projector_m.x), 0, -0.01},
    };
    unsigned char *picture = draw(number, is_long() ? 1 : 2);

    assert_non_null(picture);
    for (size_t e = 0; e < sizeof ERRORS / sizeof *ERRORS; e += is_long() ? 1 : 2) {
        struct theatre wrong = rig.theatre;

        *(double *)((char *)&wrong + ERRORS[e].place) +=
            ERRORS[e].by + ERRORS[e].by_radii * wrong.radius_m;
        tracer_prepare(&tracer, &wrong, &world);
        ray_compare(&comparison, &tracer, picture, false);
        if (!ray_comparison_is_good(&comparison))
            continue;
        print_error("not caught: a wrong %s in cupola-demo %s\n", ERRORS[e].name, rig.command);
        ray_comparison_print(&comparison);
        fail();
    }
    stbi_image_free(picture);
}

static void an_error_of_a_tenth_of_a_degree_or_a_pixel_is_caught(void **state)
{
    (void)state;
    check_errors_are_caught(2);
    if (is_long())
        check_errors_are_caught(8);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_demo_draws_what_a_ray_tracer_sees),
        cmocka_unit_test(an_error_of_a_tenth_of_a_degree_or_a_pixel_is_caught),
    };
    return cmocka_run_group_tests_name("ray_traced", tests, process_enter_directory,
                                       process_leave_directory);
}
