/* The rim of a domemaster: a pixel there is mixed with the border once. */
#include <stdio.h>

#include "disc.h"
#include "group.h"
#include "oracle.h"
#include "painted.h"
#include "picture_fixture.h"

struct shown {
    enum cupola_lens_model lens;
    int picture_px, output_px;
    double picture_fov_deg;
    bool mipmaps;
};

/* Through lenses of 180 degrees: pictures coarser and finer than the output, their rim that of the
 * output, inside of it and beyond. */
static const struct shown cases[] = {
    {CUPOLA_LENS_ANGULAR, 128, 128, 180.0, false},
    {CUPOLA_LENS_ANGULAR, 128, 128, 180.0, true},
    {CUPOLA_LENS_ANGULAR, 50, 128, 180.0, true},
    {CUPOLA_LENS_ANGULAR, 150, 128, 180.0, true},
    {CUPOLA_LENS_ANGULAR, 200, 128, 180.0, true},
    {CUPOLA_LENS_ANGULAR, 300, 128, 180.0, true},
    {CUPOLA_LENS_ANGULAR, 512, 128, 180.0, true},
    {CUPOLA_LENS_ANGULAR, 700, 128, 180.0, true},
    {CUPOLA_LENS_ANGULAR, 300, 128, 120.0, true},
    {CUPOLA_LENS_ANGULAR, 300, 128, 200.0, true},
    {CUPOLA_LENS_EQUISOLID, 300, 128, 180.0, true},
    {CUPOLA_LENS_STEREOGRAPHIC, 300, 128, 180.0, true},
    {CUPOLA_LENS_HEMISPHERIC, 300, 128, 180.0, true},
    {CUPOLA_LENS_HEMISPHERIC, 300, 128, 180.0, false},
};

enum { CASES = sizeof cases / sizeof cases[0] };

/* Levels of pictures are made from whole texels, and mixed. Without the inset the error is 0.25. */
static const double bar = 0.03;

static double rim_error(const struct shown *shown, double missing_px)
{
    struct cupola_source source = {.kind = CUPOLA_SOURCE_DOMEMASTER,
                                   .mipmaps = shown->mipmaps,
                                   .fov_rad = radians(shown->picture_fov_deg)};
    int side = shown->output_px;
    const struct cupola_rig rig = plain_rig(shown->lens, 180.0, side);
    struct fixture fixture;
    picture_fixture_make(&rig, &fixture);
    float *picture = disc_picture(shown->picture_px, missing_px);
    picture_upload(&source, picture, shown->picture_px);
    float *image = picture_shown(&fixture, &source);
    double part = fmin(shown->picture_fov_deg / 180.0, 1.0);
    double error = disc_error(image, side, 0.5 * side * part, picture_border);
    free(image);
    free(picture);
    glDeleteTextures(1, &source.texture);
    fixture_release(&fixture);
    return error;
}

static void a_white_domemaster_is_white_up_to_its_rim(void **state)
{
    (void)state;
    for (int i = 0; i < CASES; i++) {
        const struct shown *shown = &cases[i];
        double error = rim_error(shown, 0.0);
        printf("%s lens, %d px on %d px%s, %g degrees: %.2g\n",
               cupola_lens_model_name((int)shown->lens), shown->picture_px, shown->output_px,
               shown->mipmaps ? ", mipmaps" : "", shown->picture_fov_deg, error);
        check_at_most(error, bar);
    }
}

static void a_rim_that_is_dark_by_three_pixels_is_caught(void **state)
{
    (void)state;
    for (int i = 0; i < CASES; i++) {
        double texels_per_pixel = (double)cases[i].picture_px / cases[i].output_px;
        if (cases[i].picture_fov_deg <= 180.0)
            check_at_least(rim_error(&cases[i], 3.0 * fmax(texels_per_pixel, 1.0)), 3.0 * bar);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_white_domemaster_is_white_up_to_its_rim),
        cmocka_unit_test(a_rim_that_is_dark_by_three_pixels_is_caught),
    };
    return run_gpu_group("picture_rims", tests);
}
