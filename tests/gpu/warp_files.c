/*
 * Writes the images of some theatres to files, PREFIX-0.pfm and so on, in the API that the
 * environment asks for: warp_files PREFIX. What apis_agree runs.
 */
#include <stdio.h>
#include <stdlib.h>

#include "check.h"
#include "context.h"
#include "cupola/image_file.h"
#include "fixture.h"
#include "rig_random.h"
#include "warp_files.h"

static struct cupola_rig rig_of(int number)
{
    uint64_t seed = 4100 + (uint64_t)number;
    struct cupola_rig rig = random_rig(&seed, 0.6);
    enum cupola_lens_model model = (enum cupola_lens_model)(number % 6);

    rig.outputs[0].lens = random_lens(&seed, model, radians(random_between(&seed, 90.0, 170.0)));
    rig.outputs[0].width_px = WARP_WIDTH;
    rig.outputs[0].height_px = WARP_HEIGHT;
    rig.outputs[0].circle = (struct cupola_circle){80.0, 60.0, number % 2 ? 75.0 : 50.0};
    return rig;
}

static void write_image(const char *prefix, int number)
{
    const struct cupola_gl_params params = {.format = CUPOLA_FORMAT_RGBA32F,
                                            .table = (enum cupola_table)(number % 5)};
    struct cupola_rig rig = rig_of(number);
    struct cupola_error error = {CUPOLA_OK, ""};
    struct fixture fixture;
    char path[4096];

    fixture_make(&rig, NULL, &params, &fixture);
    fixture_paint(&fixture, number % 2 ? PAINT_SCREEN : PAINT_DIRECTIONS);
    float *image = fixture_warp(&fixture, 0);
    snprintf(path, sizeof path, "%s-%d.pfm", prefix, number);
    if (cupola_pfm_write(path, image, WARP_WIDTH, WARP_HEIGHT, &error) < 0) {
        fprintf(stderr, "%s\n", error.message);
        exit(1);
    }
    free(image);
    fixture_release(&fixture);
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: warp_files PREFIX\n");
        return 2;
    }
    context_open();
    if (!context_has_floats())
        return 77;
    for (int number = 0; number < WARP_COUNT; number++)
        write_image(argv[1], number);
    fixture_forget_programs();
    context_close();
    return 0;
}
