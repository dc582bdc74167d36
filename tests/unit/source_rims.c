/* The rim of a domemaster, in plain C: a pixel there is mixed with the border once. */
#include <stdio.h>
#include <stdlib.h>

#include "cupola/reference.h"
#include "disc.h"
#include "oracle.h"

static const float border[4] = {0.25f, 0.0f, 0.75f, 0.5f};

struct shown {
    int picture_px, output_px;
    double picture_fov_deg, output_fov_deg;
};

/* The same rim, from pictures much coarser than the output to finer ones; and rims far inside and
 * outside of the output's. */
static const struct shown cases[] = {
    {128, 128, 180.0, 180.0}, {96, 128, 180.0, 180.0},  {128, 96, 180.0, 180.0},
    {40, 128, 180.0, 180.0},  {256, 100, 180.0, 180.0}, {128, 128, 360.0, 360.0},
    {128, 128, 120.0, 180.0}, {128, 128, 220.0, 180.0},
};

enum { CASES = sizeof cases / sizeof cases[0] };

static double rim_error(const struct shown *shown, double missing_px)
{
    const struct cupola_source source = {.kind = CUPOLA_SOURCE_DOMEMASTER,
                                         .fov_rad = radians(shown->picture_fov_deg)};
    int side = shown->output_px;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, shown->output_fov_deg, side);
    cupola_dome *dome = dome_of(&rig);
    float *picture = disc_picture(shown->picture_px, missing_px);
    float *image = malloc(4 * sizeof *image * (size_t)side * (size_t)side);
    assert_non_null(image);
    assert_int_equal(cupola_reference_source(dome, 0, &source, picture, shown->picture_px,
                                             shown->picture_px, border, image),
                     CUPOLA_OK);
    double part = fmin(shown->picture_fov_deg / shown->output_fov_deg, 1.0);
    double error = disc_error(image, side, 0.5 * side * part, border);
    free(image);
    free(picture);
    cupola_dome_destroy(&dome);
    return error;
}

static void a_white_domemaster_is_white_up_to_its_rim(void **state)
{
    (void)state;
    for (int i = 0; i < CASES; i++) {
        double error = rim_error(&cases[i], 0.0);
        printf("%d px on %d px, %g on %g degrees: %.2g\n", cases[i].picture_px, cases[i].output_px,
               cases[i].picture_fov_deg, cases[i].output_fov_deg, error);
        check_at_most(error, 0.01);
    }
}

static void a_rim_that_is_dark_by_two_texels_is_caught(void **state)
{
    (void)state;
    for (int i = 0; i < CASES - 1; i++)
        check_at_least(rim_error(&cases[i], 2.0), 0.3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_white_domemaster_is_white_up_to_its_rim),
        cmocka_unit_test(a_rim_that_is_dark_by_two_texels_is_caught),
    };
    return cmocka_run_group_tests_name("source_rims", tests, NULL, NULL);
}
