/*
 * The eye may move, the world on the screen may not: where colour = the point of the screen sphere
 * that a ray meets, every eye's image is the same, and it is the point that each pixel lights.
 */
#include <stdio.h>
#include <stdlib.h>

#include "group.h"
#include "rig_random.h"
#include "worse.h"

enum { EYES = 10 };

/*
 * The bar is that of directions: 0.05 px. A pixel is the distance between the points of neighbours.
 * In radii of the screen besides, because that is how a viewer would see it: bilinear mixing cuts
 * the sphere between texels t R apart by t^2 / 8 each way. A pixel of 150 / 241 degrees, thrown
 * over 1.5 R, is 0.016 R long, and longer where it falls aslant: 1e-4 for both ways.
 */
static const double bar_px = 0.05, bar_radii = 2e-4;

struct screen_error {
    double px, radii;
    int pixels;
};

static double distance(const double a[3], const double b[3])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

/* The point that a pixel lights, in radii, host's camera frame; false where the pixel is not lit
 * to its edges. */
static bool lit_point(const cupola_dome *dome, double x, double y, double point[3])
{
    struct cupola_ray ray;
    if (cupola_dome_ray(dome, 0, NULL, x, y, &ray) != 1 || ray.coverage < 0.9999)
        return false;
    cupola_dome_to_camera(dome, ray.point_m, point);
    for (int i = 0; i < 3; i++)
        point[i] /= cupola_dome_rig(dome)->screen.radius_m;
    return true;
}

static struct screen_error screen_error_of(const struct fixture *fixture, const cupola_dome *oracle,
                                           const float *image)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    struct screen_error error = {0.0, 0.0, 0};
    for (int j = 0; j < size->height_px; j++)
        for (int i = 0; i < size->width_px; i++) {
            const float *color = image + 4 * (j * size->width_px + i);
            const double shown[3] = {(double)color[0], (double)color[1], (double)color[2]};
            double point[3], right[3], above[3];
            if (!lit_point(oracle, i + 0.5, j + 0.5, point) ||
                !lit_point(oracle, i + 1.0, j + 0.5, right) ||
                !lit_point(oracle, i + 0.5, j + 1.0, above))
                continue;
            double pixel = 2.0 * fmin(distance(point, right), distance(point, above));
            double off = distance(point, shown);
            error.radii = worse_of(error.radii, off);
            error.px = worse_of(error.px, off / pixel);
            error.pixels++;
        }
    return error;
}

static struct cupola_rig theatre(uint64_t *seed)
{
    struct cupola_rig rig = random_rig(seed, 0.5);
    rig.outputs[0].width_px = 317;
    rig.outputs[0].height_px = 241;
    rig.outputs[0].circle = (struct cupola_circle){158.5, 120.5, 120.5};
    rig.outputs[0].lens = random_lens(seed, CUPOLA_LENS_EQUISOLID, radians(150.0));
    return rig;
}

static void the_eye_may_move_the_world_on_the_screen_may_not(void **state)
{
    (void)state;
    uint64_t seed = 4001;
    struct cupola_rig rig = theatre(&seed);
    struct cupola_gl_params params = {.format = CUPOLA_FORMAT_RGBA32F};
    float *images[EYES];
    size_t values = 4 * (size_t)rig.outputs[0].width_px * (size_t)rig.outputs[0].height_px;
    double worst_px = 0.0, worst_radii = 0.0, apart = 0.0;
    for (int k = 0; k < EYES; k++) {
        struct fixture fixture;
        random_in_ball(&seed, 0.6 * rig.screen.radius_m, rig.eye_m);
        fixture_make(&rig, NULL, &params, &fixture);
        fixture_paint(&fixture, PAINT_SCREEN);
        images[k] = fixture_warp(&fixture, 0);
        struct screen_error error = screen_error_of(&fixture, fixture.dome, images[k]);
        check_at_least(error.pixels, 10000);
        check_at_most(error.px, bar_px);
        check_at_most(error.radii, bar_radii);
        worst_px = worse_of(worst_px, error.px);
        worst_radii = worse_of(worst_radii, error.radii);
        fixture_release(&fixture);
    }
    for (int k = 1; k < EYES; k++)
        for (size_t i = 0; i < values; i++)
            apart = worse_of(apart, fabs((double)images[k][i] - (double)images[0][i]));
    printf("at most %.3g px, %.3g R from the point; images at most %.3g apart\n", worst_px,
           worst_radii, apart);
    check_at_most(apart, 2.0 * bar_radii);
    for (int k = 0; k < EYES; k++)
        free(images[k]);
}

static struct screen_error error_against(const struct fixture *fixture, const float *image,
                                         const struct cupola_rig *wrong)
{
    struct cupola_error refusal = {CUPOLA_OK, ""};
    cupola_dome *oracle = NULL;
    if (cupola_dome_create(wrong, &oracle, &refusal) < 0)
        fail_msg("%s", refusal.message);
    struct screen_error error = screen_error_of(fixture, oracle, image);
    cupola_dome_destroy(&oracle);
    return error;
}

static void a_rig_wrong_by_a_tenth_of_a_degree_or_a_pixel_is_caught(void **state)
{
    (void)state;
    uint64_t seed = 4002;
    struct cupola_rig rig = theatre(&seed), wrong = rig;
    struct cupola_gl_params params = {.format = CUPOLA_FORMAT_RGBA32F};
    struct fixture fixture;
    fixture_make(&rig, NULL, &params, &fixture);
    fixture_paint(&fixture, PAINT_SCREEN);
    float *image = fixture_warp(&fixture, 0);
    struct screen_error error = error_against(&fixture, image, &rig);
    check_at_most(error.px, bar_px);
    check_at_most(error.radii, bar_radii);
    wrong.outputs[0].aim.pitch_rad += radians(0.1);
    error = error_against(&fixture, image, &wrong);
    check_at_least(error.px, 2.0 * bar_px);
    check_at_least(error.radii, 2.0 * bar_radii);
    wrong = rig;
    wrong.outputs[0].circle.center_y_px += 1.0;
    check_at_least(error_against(&fixture, image, &wrong).px, 2.0 * bar_px);
    free(image);
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_eye_may_move_the_world_on_the_screen_may_not),
        cmocka_unit_test(a_rig_wrong_by_a_tenth_of_a_degree_or_a_pixel_is_caught),
    };
    return run_gpu_group("screen", tests);
}
