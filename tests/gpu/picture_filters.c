/* Existing pictures finer than the output: what the filter makes of them. */
#include <stdio.h>

#include "group.h"
#include "oracle.h"
#include "painted.h"
#include "picture_fixture.h"
#include "rig_random.h"
#include "worse.h"

enum { HEIGHT = 512 };

/* How far the shown directions are from those of the rays, over all lit pixels. */
static double blurred_error(const struct fixture *fixture, const struct cupola_source *source)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    float *shown = picture_shown(fixture, source);
    double worst = 0.0;
    for (int j = 0; j < size->height_px; j++)
        for (int i = 0; i < size->width_px; i++) {
            struct cupola_ray ray;
            double expected[3];
            const float *pixel = shown + 4 * (j * size->width_px + i);
            const double direction[3] = {(double)pixel[0], (double)pixel[1], (double)pixel[2]};
            cupola_dome_ray(fixture->dome, 0, NULL, i + 0.5, j + 0.5, &ray);
            shown_direction(fixture->dome, source, &ray, expected);
            if (ray.coverage < 1.0)
                continue;
            worst = worse_of(worst, angle_between(direction, expected));
        }
    free(shown);
    return worst;
}

/*
 * A pixel is 3 degrees wide and 16 texels. Where a gradient jumps, as the longitude does behind the
 * viewer, or a level is far too coarse, as at a pole, directions are off by tens of degrees.
 */
static void coarse_pixels_have_no_seam_behind_and_none_at_the_poles(void **state)
{
    (void)state;
    for (int kind = CUPOLA_SOURCE_DOMEMASTER; kind <= CUPOLA_SOURCE_CUBE; kind++)
        for (int turn = 0; turn < 4; turn++) {
            struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 200.0, 64);
            struct cupola_source source = {
                .kind = (enum cupola_source_kind)kind, .mipmaps = true, .fov_rad = radians(300.0)};
            struct fixture fixture;
            rig.tilt_rad = turn % 2 ? radians(90.0) : 0.0;
            source.orientation.yaw_rad = turn / 2 && kind != 1 ? radians(180.0) : 0.0;
            picture_fixture_make(&rig, &fixture);
            float *picture = painted_picture(&source, 2 * HEIGHT);
            picture_upload(&source, picture, 2 * HEIGHT);
            double error = blurred_error(&fixture, &source);
            printf("%s, turn %d: %.2g degrees\n", cupola_source_name(kind), turn,
                   error / radians(1.0));
            check_at_most(error, radians(1.0));
            glDeleteTextures(1, &source.texture);
            free(picture);
            fixture_release(&fixture);
        }
}

/* The root mean square distance from the mean, 0.5, of one channel of lit pixels. */
static double spread(const struct fixture *fixture, const struct cupola_source *source)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    float *shown = picture_shown(fixture, source);
    double square = 0.0, middle = 0.5 * size->width_px;
    int count = 0;
    for (int j = 0; j < size->height_px; j++)
        for (int i = 0; i < size->width_px; i++) {
            double off = (double)shown[4 * (j * size->width_px + i)] - 0.5;
            if (hypot(i + 0.5 - middle, j + 0.5 - middle) > middle - 1.0)
                continue;
            square += off * off;
            count++;
        }
    free(shown);
    return sqrt(square / count);
}

static void fine_pictures_are_averaged_where_they_have_mipmaps(void **state)
{
    (void)state;
    for (int kind = CUPOLA_SOURCE_DOMEMASTER; kind <= CUPOLA_SOURCE_CUBE; kind++) {
        struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 64);
        struct cupola_source source = {.kind = (enum cupola_source_kind)kind, .mipmaps = true};
        struct fixture fixture;
        picture_fixture_make(&rig, &fixture);
        float *picture = picture_noise((size_t)12 * HEIGHT * HEIGHT);
        picture_upload(&source, picture, HEIGHT);
        double averaged = spread(&fixture, &source);
        source.mipmaps = false;
        double sampled = spread(&fixture, &source);
        printf("%s: spread %.3f, without mipmaps %.3f\n", cupola_source_name(kind), averaged,
               sampled);
        check_at_most(averaged, 0.4 * sampled);
        glDeleteTextures(1, &source.texture);
        free(picture);
        fixture_release(&fixture);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(coarse_pixels_have_no_seam_behind_and_none_at_the_poles),
        cmocka_unit_test(fine_pictures_are_averaged_where_they_have_mipmaps),
    };
    return run_gpu_group("picture_filters", tests);
}
