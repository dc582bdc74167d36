/* The mean of many frames against many rays into a cube map. */
#include "truth_check.h"

#include <stdio.h>
#include <stdlib.h>

#include "reference.h"
#include "similarity.h"
#include "srgb.h"
#include "truth.h"

/*
 * In steps of 8 bits, over the pixels that are wholly lit; the light is moved to the left by a part
 * of a pixel.
 */
static double mean_square(const float *light, const float *wished, size_t pixels, double moved)
{
    double sum = 0, count = 0;

    for (size_t i = 0; i + 1 < pixels; i++)
        for (size_t k = 0; wished[4 * i + 3] >= 0.5f && k < 3; k++) {
            double here = (double)light[3 * i + k], beside = (double)light[3 * (i + 1) + k];
            double code = light_encoded(here + moved * (beside - here));
            double error = 255 * (code - (double)wished[4 * i + k]);
            sum += error * error;
            count++;
        }
    return sum / count;
}

bool truth_check_run(const struct setting *setting, double density, int rays,
                     struct truth_check *check, char *message)
{
    size_t pixels = (size_t)setting->size_px * (size_t)setting->size_px;
    float *light = malloc(3 * pixels * sizeof *light);
    struct reference reference = {0};
    struct truth *truth = NULL;
    bool done = false;

    if (!light) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return false;
    }
    if (!reference_create(&reference, setting, message) ||
        !(truth = truth_create(setting, density, message)) ||
        !truth_draw(truth, rays, light, message))
        goto end;
    const float *wished = reference.pictures[SHOWS_DOME];
    check->psnr_db = decibels(mean_square(light, wished, pixels, 0));
    check->moved_db = decibels(mean_square(light, wished, pixels, 0.25));
    done = true;

end:
    truth_destroy(truth);
    reference_destroy(&reference);
    free(light);
    return done;
}
