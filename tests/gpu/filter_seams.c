/*
 * No seams with any filter: where pixels send rays into several views, directions drawn into them
 * come out as exactly as elsewhere, for an eye off the axis, whatever lies beyond the guard bands.
 * The frame lies inside of the image circle: at its rim rays are kept inside, which moves the mean.
 */
#include <stdio.h>
#include <stdlib.h>

#include "direction_error.h"
#include "filter_cases.h"
#include "group.h"
#include "rig_random.h"

enum { SIDE = 160 };

static struct cupola_rig rig_inside_of_the_rim(enum cupola_lens_model model)
{
    struct cupola_rig rig = plain_rig(model, 160.0, SIDE);
    rig.outputs[0].width_px = SIDE + 17;
    rig.outputs[0].circle = (struct cupola_circle){0.51 * SIDE, 0.48 * SIDE, 0.9 * SIDE};
    rig.outputs[0].aim.roll_rad = 0.7;
    rig.screen.radius_m = 1.0;
    rig.eye_m[0] = 0.1;
    rig.eye_m[1] = 0.2;
    rig.eye_m[2] = -0.1;
    return rig;
}

static struct direction_error error_with(struct fixture *fixture, int rings)
{
    fixture_paint(fixture, PAINT_DIRECTIONS);
    spoil_beyond_views(fixture, rings);
    float *image = fixture_warp(fixture, 0);
    struct direction_error error = direction_error_of(fixture, 0, image, fixture->dome);
    free(image);
    return error;
}

/*
 * The mean direction of a pixel is its middle's but for what a picture of straight lines bends over
 * a pixel; the nearest texel is up to half a texel's diagonal away.
 */
static void check_filter(struct fixture *fixture, const struct cupola_filter *filter,
                         enum cupola_table stage)
{
    bool nearest = filter->method == CUPOLA_ANTIALIASING_NONE;
    struct cupola_gl_params params = {
        .format = CUPOLA_FORMAT_RGBA32F, .filter = *filter, .table = stage};
    fixture_replace_gl(fixture, &params);
    struct direction_error error = error_with(fixture, 1);
    printf("%s, %s: %.4f px inside, %.4f px at borders\n", filter_text(filter),
           cupola_table_name((int)stage), error.interior_px, error.border_px);
    check_at_least(error.border_pixels, 200);
    check_at_most(error.border_px, 1.2 * error.interior_px);
    check_at_most(error.interior_px, nearest ? 0.75 : 0.02);
    /* The same metric sees rings that the filter does reach. */
    error = error_with(fixture, 7);
    check_at_least(error.border_px, nearest ? 2.0 : 0.1);
}

static void directions_know_nothing_of_views(void **state)
{
    (void)state;
    static const enum cupola_lens_model models[] = {CUPOLA_LENS_ANGULAR, CUPOLA_LENS_HEMISPHERIC};
    static const enum cupola_layout layouts[] = {CUPOLA_LAYOUT_ASYMMETRIC, CUPOLA_LAYOUT_ROTATED};
    if (!context_has_floats())
        skip();
    for (int number = 0; number < 2; number++) {
        struct cupola_rig rig = rig_inside_of_the_rim(models[number]);
        struct cupola_plan_params wish = {.layout = layouts[number], .views = 4};
        struct fixture fixture;
        fixture_make(&rig, &wish, NULL, &fixture);
        for (int i = 0; i < FILTERS; i++)
            check_filter(&fixture, &filters[i], filter_stages[(i + number) % 2]);
        fixture_release(&fixture);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(directions_know_nothing_of_views),
    };
    return run_gpu_group("filter_seams", tests);
}
