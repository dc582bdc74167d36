/* The command `capture`: what its own commands share, and its patterns. */
#include "capture/command.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <cupola/rig_file.h>

#include "capture/capture.h"
#include "capture/folder.h"
#include "capture/light.h"
#include "option_values.h"
#include "plain_text.h"
#include "short_path.h"
#include "status.h"

int capture_rig(const struct capture_options *options, struct cupola_rig *rig, char *message)
{
    struct cupola_error error = {0};

    if (cupola_rig_read(options->rig, NULL, rig, &error) < 0) {
        snprintf(message, MESSAGE_SIZE, "--rig: %s", error.message);
        return STATUS_FAILED;
    }
    if (options->projector < rig->output_count)
        return STATUS_OK;
    snprintf(message, MESSAGE_SIZE, "--projector: %d is not allowed; allowed: 0 to %d",
             options->projector, rig->output_count - 1);
    return STATUS_USAGE;
}

int capture_series(const char *folder, const struct cupola_rig *rig, int projector,
                   struct series *series, char *message)
{
    const struct cupola_output *output = rig ? &rig->outputs[projector] : NULL;

    if (!folder_read_series(folder, series, message))
        return STATUS_FAILED;
    if (!output ||
        (output->width_px == series->size_px[0] && output->height_px == series->size_px[1]))
        return STATUS_OK;
    snprintf(message, MESSAGE_SIZE,
             "the patterns are of %dx%d px, and projector %d of the rig is of %dx%d; allowed: one "
             "size",
             series->size_px[0], series->size_px[1], projector, output->width_px,
             output->height_px);
    return STATUS_FAILED;
}

bool capture_picture(const struct series *series, int number, struct photo *photo, char *message)
{
    struct series_picture picture = series_picture(series, number);

    if (!photo_create(photo, series->size_px[0], series->size_px[1], message))
        return false;
    for (int j = 0; j < photo->height; j++) {
        for (int i = 0; i < photo->width; i++)
            photo->light[(size_t)j * (size_t)photo->width + (size_t)i] =
                (float)series_light(series, &picture, i, j);
    }
    return true;
}

int capture_camera(const struct capture_options *options, const struct cupola_rig *rig, int width,
                   int height, struct camera *camera, char *message)
{
    if (!camera_parse("--camera", options->camera, camera, message))
        return STATUS_USAGE;
    if (options->circle_given && camera->kind != CAMERA_FISHEYE) {
        snprintf(message, MESSAGE_SIZE, "--camera-circle is for a fisheye, and --camera is %s",
                 options->camera);
        return STATUS_USAGE;
    }
    if (!camera_fit(camera, width, height, options->circle_given ? &options->circle : NULL,
                    message))
        return STATUS_FAILED;
    memcpy(camera->position_m, options->position_given ? options->position_m : rig->eye_m,
           sizeof camera->position_m);
    camera_aim(camera, rig->tilt_rad, &options->aim);
    return STATUS_OK;
}

/* Whether two pictures are the same in files of 8 bits. */
static bool same_pictures(const struct photo *a, const struct photo *b)
{
    size_t count = (size_t)a->width * (size_t)a->height;

    if (a->width != b->width || a->height != b->height)
        return false;
    for (size_t i = 0; i < count; i++) {
        if (lround(255 * light_encode((double)a->light[i])) !=
            lround(255 * light_encode((double)b->light[i])))
            return false;
    }
    return true;
}

/* Photographs have the names of their patterns: such a one must not be lost. */
static bool keeps_pattern(const char *path, const struct photo *picture, char *message)
{
    struct photo there;
    bool same;

    if (access(path, F_OK) != 0)
        return true;
    same = photo_read(path, PHOTO_SRGB, &there, message) && same_pictures(&there, picture);
    photo_free(&there);
    if (!same)
        snprintf(message, MESSAGE_SIZE,
                 "--folder: %s is there and is not the pattern of that name; allowed: a folder "
                 "without pictures, or with just these patterns",
                 short_path(path).text);
    return same;
}

/* Looks whether a pattern may be written, or writes it. */
static bool place_pattern(const struct capture_options *options, const struct series *series,
                          int number, bool write, char *message)
{
    char name[SERIES_NAME_MAX + 1], path[PATH_MAX];
    struct photo picture;
    bool done;

    series_name(series, number, name);
    if (!folder_path(options->folder, name, ".png", path, message) ||
        !capture_picture(series, number, &picture, message))
        return false;
    done = write ? photo_write(path, &picture, PHOTO_PNG8, message)
                 : keeps_pattern(path, &picture, message);
    photo_free(&picture);
    return done;
}

/* All or, where one would be lost, none. */
static bool write_patterns(const struct capture_options *options, const struct series *series,
                           char *message)
{
    int count = series_count(series);

    for (int i = 0; i < 2 * count; i++) {
        if (!place_pattern(options, series, i % count, i >= count, message))
            return false;
    }
    return folder_write_series(options->folder, series, message);
}

int capture_patterns(const struct capture_options *options, char *message)
{
    struct cupola_rig rig;
    int status = capture_rig(options, &rig, message);
    const struct cupola_output *output = &rig.outputs[options->projector];
    struct series series;
    struct named_file rig_file;

    if (status != STATUS_OK)
        return status;
    series = (struct series){
        .size_px = {output->width_px, output->height_px},
        .period_px = options->period_px ? options->period_px
                                        : series_period_for(output->width_px, output->height_px),
        .steps = options->steps,
    };
    rig_file = (struct named_file){.name = "--rig", .path = options->rig};
    if (!folder_differs("a picture", options->folder, ".png", true, &series, &rig_file, 1, message))
        return STATUS_USAGE;
    if (!folder_is_for("--folder", options->folder, ".png", &series, message) ||
        !folder_make("--folder", options->folder, message) ||
        !write_patterns(options, &series, message))
        return STATUS_FAILED;
    printf("%d patterns of %dx%d px in ", series_count(&series), series.size_px[0],
           series.size_px[1]);
    plain_text_print(options->folder, stdout);
    printf(": sines of %d px in %d steps, %d + %d bits of Gray code\n", series.period_px,
           series.steps, series_bits(&series, 0), series_bits(&series, 1));
    return STATUS_OK;
}

int capture_main(int argc, char **argv)
{
    static int (*const commands[CAPTURE_COMMANDS])(const struct capture_options *, char *) = {
        [CAPTURE_PATTERNS] = capture_patterns,
        [CAPTURE_SHOW] = capture_show,
        [CAPTURE_DECODE] = capture_decode,
        [CAPTURE_SIMULATE] = capture_simulate,
    };
    struct capture_options options;
    char message[MESSAGE_SIZE] = "", name[64];
    int status = capture_options_parse(argc, argv, &options, message);

    if (status != STATUS_OK)
        return complain("capture", status, message);
    if (options.help) {
        capture_help();
        return STATUS_OK;
    }
    status = commands[options.command](&options, message);
    if (status == STATUS_OK)
        return STATUS_OK;
    snprintf(name, sizeof name, "capture %s", capture_command_name((int)options.command));
    return complain(name, status, message);
}
