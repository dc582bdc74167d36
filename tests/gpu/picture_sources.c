/*
 * Existing pictures in the warp: against the warp in plain C, and by what must be true of them. The
 * pictures are those of painted.h, a texel's colour being its direction, so that a difference of
 * colours is one of angles in rad.
 */
#include <stdio.h>

#include "group.h"
#include "oracle.h"
#include "painted.h"
#include "picture_fixture.h"
#include "rig_random.h"
#include "worse.h"

enum { HEIGHT = 512, SIDE = 128, RIGS = 18 };

static struct cupola_rig rig_number(uint64_t *seed, int number)
{
    struct cupola_rig rig = random_rig(seed, 0.6);
    rig.outputs[0].lens =
        random_lens(seed, (enum cupola_lens_model)(number % 6), radians(170.0 - number));
    rig.outputs[0].width_px = SIDE;
    rig.outputs[0].height_px = SIDE - 9;
    rig.outputs[0].circle = (struct cupola_circle){60.0, 55.0, number % 2 ? 70.0 : 50.0};
    rig.screen.cap_rad = number % 3 ? 0.0 : radians(80.0);
    return rig;
}

/* How far colours are apart, where the pixel is lit in full and where a part of it is. */
struct image_error {
    double inside, edge;
};

static float *reference_of(const cupola_dome *dome, const struct cupola_source *source,
                           const float *picture, int height)
{
    const struct cupola_output *size = &cupola_dome_rig(dome)->outputs[0];
    float *image = malloc(4 * sizeof *image * (size_t)size->width_px * (size_t)size->height_px);
    assert_non_null(image);
    assert_int_equal(cupola_reference_source(dome, 0, source, picture,
                                             painted_width(source, height), height, picture_border,
                                             image),
                     CUPOLA_OK);
    return image;
}

/* A direction's alpha is 1: what is not is a mixture with the picture_border. */
static struct image_error error_of(const float *shown, const cupola_dome *dome,
                                   const struct cupola_source *source, const float *picture)
{
    const struct cupola_output *size = &cupola_dome_rig(dome)->outputs[0];
    float *expected = reference_of(dome, source, picture, HEIGHT);
    struct image_error error = {0.0, 0.0};
    for (int i = 0; i < size->width_px * size->height_px; i++) {
        const float *wish = expected + 4 * i;
        double *part = wish[3] > 0.99999f ? &error.inside : &error.edge;
        *part = worse_of(*part, picture_pixel_error(shown + 4 * i, wish));
    }
    free(expected);
    return error;
}

/*
 * 1e-5 rad; at edges beside that the coverage, times the difference of colours, at most 2: floats
 * know it within 1e-4, of a domemaster's rim within the 2e-4 px that llvmpipe's atan errs by.
 */
static const double bar = 1e-5, bar_edge = 5e-4;

static void the_image_is_that_of_the_reference(void **state)
{
    (void)state;
    uint64_t seed = 7101;
    struct image_error worst = {0.0, 0.0};
    for (int number = 0; number < RIGS; number++) {
        struct cupola_rig rig = rig_number(&seed, number);
        struct cupola_source source = random_source(&seed, number);
        struct fixture fixture;
        picture_fixture_make(&rig, &fixture);
        float *picture = painted_picture(&source, HEIGHT);
        picture_upload(&source, picture, HEIGHT);
        float *shown = picture_shown(&fixture, &source);
        struct image_error error = error_of(shown, fixture.dome, &source, picture);
        worst.inside = worse_of(worst.inside, error.inside);
        worst.edge = worse_of(worst.edge, error.edge);
        glDeleteTextures(1, &source.texture);
        free(shown);
        free(picture);
        fixture_release(&fixture);
    }
    printf("at most %.2g rad apart, at edges %.2g\n", worst.inside, worst.edge);
    check_at_most(worst.inside, bar);
    check_at_most(worst.edge, bar_edge);
}

static void a_tenth_of_a_degree_or_a_pixel_is_caught(void **state)
{
    (void)state;
    uint64_t seed = 7102;
    for (int number = 0; number < 9; number++) {
        struct cupola_rig rig = rig_number(&seed, number), shifted = rig;
        struct cupola_source source = random_source(&seed, number), turned = source;
        struct fixture fixture;
        cupola_dome *wrong = NULL;
        turned.orientation.yaw_rad += radians(0.1);
        shifted.outputs[0].circle.center_x_px += 1.0;
        picture_fixture_make(&rig, &fixture);
        assert_int_equal(cupola_dome_create(&shifted, &wrong, NULL), CUPOLA_OK);
        float *picture = painted_picture(&source, HEIGHT);
        picture_upload(&source, picture, HEIGHT);
        float *shown = picture_shown(&fixture, &source);
        struct image_error by_turn = error_of(shown, fixture.dome, &turned, picture);
        struct image_error by_shift = error_of(shown, wrong, &source, picture);
        check_at_least(by_turn.inside, 10.0 * bar);
        check_at_least(by_shift.inside, 10.0 * bar);
        check_at_least(by_shift.edge, 2.0 * bar_edge);
        cupola_dome_destroy(&wrong);
        glDeleteTextures(1, &source.texture);
        free(shown);
        free(picture);
        fixture_release(&fixture);
    }
}

/* The largest difference in pixels all of which lie inside of the rim, `dx` pixels beside. */
static double difference_inside(const float *image, const float *picture, int side, int dx)
{
    double worst = 0.0, middle = 0.5 * side;
    for (int j = 0; j < side; j++)
        for (int i = 0; i < side; i++)
            if (hypot(i + 0.5 - middle, j + 0.5 - middle) < middle - 1.5)
                worst = worse_of(worst, picture_pixel_error(image + 4 * (j * side + i),
                                                            picture + 4 * (j * side + i + dx)));
    return worst;
}

/* On a planetarium as well: that its front is at the bottom holds for what is shown and shows. */
static void a_domemaster_on_its_own_rig_comes_out_as_it_is(void **state)
{
    (void)state;
    for (int number = 0; number < 4; number++) {
        struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, number % 2 ? 180.0 : 210.0, SIDE);
        struct cupola_source source = {.kind = CUPOLA_SOURCE_DOMEMASTER};
        struct fixture fixture;
        rig.tilt_rad = number / 2 ? radians(90.0) : 0.0;
        source.fov_rad = rig.outputs[0].lens.fov_rad;
        picture_fixture_make(&rig, &fixture);
        float *picture = picture_noise(SIDE * SIDE);
        picture_upload(&source, picture, SIDE);
        float *image = picture_shown(&fixture, &source);
        check_at_most(difference_inside(image, picture, SIDE, 0), 1e-3); /* 0.0005 texels */
        check_at_least(difference_inside(image, picture, SIDE, 1), 0.5);
        glDeleteTextures(1, &source.texture);
        free(image);
        free(picture);
        fixture_release(&fixture);
    }
}

static void a_domemaster_of_the_views_is_what_the_views_show(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, HEIGHT);
    struct cupola_source source = {.kind = CUPOLA_SOURCE_DOMEMASTER};
    const struct cupola_gl_params params = {.format = CUPOLA_FORMAT_RGBA32F,
                                            .sources = 1u << CUPOLA_SOURCE_VIEWS |
                                                       1u << CUPOLA_SOURCE_DOMEMASTER};
    struct fixture maker, shower;
    rig.tilt_rad = radians(90.0);
    fixture_make(&rig, NULL, &params, &maker);
    fixture_paint(&maker, PAINT_DIRECTIONS);
    float *domemaster = fixture_warp(&maker, 0);
    picture_upload(&source, domemaster, HEIGHT);
    /* Another theatre altogether, with its eye and its projector off the centre. */
    rig.outputs[0].lens = (struct cupola_lens){CUPOLA_LENS_EQUISOLID, radians(150.0)};
    rig.outputs[0].position_m[1] = -0.2;
    rig.eye_m[0] = 0.1;
    fixture_make(&rig, NULL, &params, &shower);
    float *shown = picture_shown(&shower, &source);
    double worst = 0.0;
    for (int j = 0; j < HEIGHT; j++)
        for (int i = 0; i < HEIGHT; i++) {
            struct cupola_ray ray;
            double expected[3];
            const float *pixel = shown + 4 * (j * HEIGHT + i);
            const double direction[3] = {(double)pixel[0], (double)pixel[1], (double)pixel[2]};
            cupola_dome_ray(shower.dome, 0, NULL, i + 0.5, j + 0.5, &ray);
            if (ray.coverage < 1.0 || -ray.point_m[2] < 0.05)
                continue; /* beyond the domemaster's rim, or beside it */
            cupola_dome_to_camera(shower.dome, ray.point_m, expected);
            worst = worse_of(worst, angle_between(direction, expected));
        }
    check_at_most(worst, radians(0.01));
    glDeleteTextures(1, &source.texture);
    free(shown);
    free(domemaster);
    fixture_release(&shower);
    fixture_release(&maker);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_image_is_that_of_the_reference),
        cmocka_unit_test(a_tenth_of_a_degree_or_a_pixel_is_caught),
        cmocka_unit_test(a_domemaster_on_its_own_rig_comes_out_as_it_is),
        cmocka_unit_test(a_domemaster_of_the_views_is_what_the_views_show),
    };
    return run_gpu_group("picture_sources", tests);
}
