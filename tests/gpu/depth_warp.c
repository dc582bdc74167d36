/*
 * Depth, as far as the dome's image: whichever way it runs and in whatever format it is kept, the
 * image is that of the reference in C, in which the nearest surface is found by a ray.
 *
 * The surfaces are six walls round the viewer, each of which goes on far behind the others. What
 * may differ is a pixel where two walls meet.
 */
#include <stdio.h>
#include <stdlib.h>

#include "group.h"
#include "host_depth.h"
#include "rig_random.h"
#include "triangles.h"

enum { WALLS = 6, MODES = 8 };

static const double near_distance = 0.4, far_distance = 200;
static const double half_side = 20; /* of a wall; from the viewer, all less than 40 away */
static const double wall_distance[WALLS] = {3, 4, 5, 3.5, 6, 4.5};
static const float wall_color[WALLS][4] = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1},
                                           {1, 1, 0, 1}, {0, 1, 1, 1}, {1, 0, 1, 1}};

static struct triangles triangles;

/* Orthogonal, and along no axis: towards a wall, and along it. */
static void wall_axes(int wall, double axes[3][3])
{
    static const double turned[3][3] = {
        {6.0 / 7, 2.0 / 7, 3.0 / 7}, {-3.0 / 7, 6.0 / 7, 2.0 / 7}, {-2.0 / 7, -3.0 / 7, 6.0 / 7}};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            axes[i][k] = (i == 0 && wall % 2 ? -1 : 1) * turned[(wall / 2 + i) % 3][k];
}

static void wall_points(const struct fixture *fixture, int wall, float points[6][3])
{
    static const int corners[6][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
    const struct cupola_rig *rig = cupola_dome_rig(fixture->dome);
    double axes[3][3], eye[3];

    cupola_dome_to_camera(fixture->dome, rig->eye_m, eye);
    wall_axes(wall, axes);
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < 3; k++)
            points[i][k] =
                (float)(rig->units_per_metre * eye[k] + wall_distance[wall] * axes[0][k] +
                        half_side * corners[i][0] * axes[1][k] +
                        half_side * corners[i][1] * axes[2][k]);
}

/* The wall that a ray from the eye meets first. */
static void nearest_wall(const double direction[3], float rgba[4], void *user)
{
    double most = 0;

    (void)user;
    for (int wall = 0; wall < WALLS; wall++) {
        double axes[3][3], nearness = 0;
        wall_axes(wall, axes);
        for (int k = 0; k < 3; k++)
            nearness += axes[0][k] * direction[k] / wall_distance[wall];
        if (nearness > most) {
            most = nearness;
            memcpy(rgba, wall_color[wall], 4 * sizeof *rgba);
        }
    }
}

/* `told` is what the host believes of the depth. */
static void draw_walls(const struct fixture *fixture, const struct cupola_depth *depth,
                       const struct cupola_depth *told)
{
    const struct cupola_frame frame = {.depth = *depth};
    int views = cupola_gl_frame_begin(fixture->gl, &frame, NULL);

    host_depth(told);
    for (int i = 0; i < views; i++) {
        struct cupola_gl_view view;
        assert_int_equal(cupola_gl_view_begin(fixture->gl, i, &view, NULL), CUPOLA_OK);
        for (int wall = 0; wall < WALLS; wall++) {
            float points[6][3];
            wall_points(fixture, wall, points);
            triangles_draw(&triangles, &view.camera, wall_color[wall], points, 6);
        }
        assert_int_equal(cupola_gl_view_end(fixture->gl, NULL), CUPOLA_OK);
    }
    host_depth_reset();
}

static float *image_of_reference(const struct fixture *fixture)
{
    const struct cupola_plan_report *report = cupola_plan_report(fixture->plan);
    const struct cupola_output *size = fixture_output(fixture, 0);
    float *atlas = malloc(4 * sizeof *atlas * (size_t)report->atlas_width_px *
                          (size_t)report->atlas_height_px);
    float *image = malloc(4 * sizeof *image * (size_t)size->width_px * (size_t)size->height_px);

    assert_true(atlas && image);
    assert_int_equal(cupola_reference_views(fixture->plan, nearest_wall, NULL, atlas), CUPOLA_OK);
    assert_int_equal(cupola_reference_warp(fixture->plan, 0, atlas, NULL, image), CUPOLA_OK);
    free(atlas);
    return image;
}

/* The part of the image that is another than the reference's. */
static double other(const struct fixture *fixture, const float *reference)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    float *shown = fixture_warp(fixture, 0);
    int pixels = size->width_px * size->height_px, count = 0;

    for (int i = 0; i < pixels; i++) {
        double off = 0;
        for (int c = 0; c < 4; c++)
            off = fmax(off, fabs((double)shown[4 * i + c] - (double)reference[4 * i + c]));
        count += !(off <= 0.02);
    }
    free(shown);
    return (double)count / pixels;
}

static int check_format(enum cupola_depth_format format, double *worst)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 150.0, 128);
    const struct cupola_gl_params params = {.depth = format};
    struct fixture fixture;
    int tried = 0;

    rig.eye_m[0] = 0.2;
    rig.eye_m[1] = -0.1;
    fixture_make(&rig, NULL, &params, &fixture);
    float *reference = image_of_reference(&fixture);
    for (int mode = 0; mode < MODES; mode++) {
        const struct cupola_depth depth = {near_distance, far_distance, mode & 1, mode & 2,
                                           mode & 4};
        struct cupola_depth told = depth;
        if (depth.zero_to_one && !has_clip_control())
            continue;
        draw_walls(&fixture, &depth, &depth);
        *worst = fmax(*worst, other(&fixture, reference));
        told.reversed = !told.reversed;
        draw_walls(&fixture, &depth, &told); /* the control */
        check_at_least(other(&fixture, reference), 0.3);
        tried++;
    }
    free(reference);
    fixture_release(&fixture);
    return tried;
}

static void the_image_is_that_of_the_nearest_surfaces(void **state)
{
    double worst = 0;
    int tried = 0;

    (void)state;
    triangles = triangles_create();
    for (int format = 0; format < CUPOLA_DEPTH_NONE; format++)
        tried += check_format((enum cupola_depth_format)format, &worst);
    triangles_release(&triangles);
    printf("%d ways tried: at most %.3g of the pixels are others\n", tried, worst);
    check_at_most(worst, 0.002);
    assert_int_equal(tried, has_clip_control() ? 32 : 16);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_image_is_that_of_the_nearest_surfaces),
    };
    return run_gpu_group("depth_warp", tests);
}
