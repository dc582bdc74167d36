/* The command `capture simulate`. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "angles.h"
#include "capture/command.h"
#include "capture/folder.h"
#include "capture/simulate.h"
#include "marks.h"
#include "option_values.h"
#include "output_file.h"
#include "plain_text.h"
#include "status.h"

/* Places of the screen as somebody would measure them: its middle and two rings round it. */
enum { RING = 8, REFERENCES = 1 + 2 * RING };

static void reference_direction(const struct cupola_rig *rig, int index, double direction[3])
{
    double most = fmin(rig->screen.cap_rad, pi / 2);
    double angle = index == 0 ? 0 : index <= RING ? 0.4 * most : 0.8 * most;
    double round = 2 * pi * index / RING;

    direction[0] = sin(angle) * cos(round);
    direction[1] = sin(angle) * sin(round);
    direction[2] = -cos(angle);
}

static int write_references(const struct capture_options *options, const struct cupola_rig *rig,
                            const struct camera *camera, char *message)
{
    struct mark list[REFERENCES];
    struct marks marks = {.kind = MARKS_DIRECTIONS, .list = list};

    for (int i = 0; i < REFERENCES; i++) {
        struct mark mark = {.steered = true};
        double point[3];
        reference_direction(rig, i, mark.place);
        for (int k = 0; k < 3; k++)
            point[k] = rig->screen.radius_m * mark.place[k];
        snprintf(mark.name, sizeof mark.name, "reference-%d", i);
        if (camera_place(camera, point, mark.pixel_px))
            list[marks.count++] = mark;
    }
    if (marks.count < 2) {
        snprintf(message, MESSAGE_SIZE,
                 "--references: %d of the screen's places are in the picture; allowed: 2 or more",
                 marks.count);
        return STATUS_FAILED;
    }
    return marks_write(options->references, &marks, message) ? STATUS_OK : STATUS_FAILED;
}

/* What the projector shows is read from its file, 8 bits and all. */
static bool take(struct simulator *simulator, const struct series *series, int number,
                 const struct capture_options *options, char *message)
{
    char name[SERIES_NAME_MAX + 1], from[PATH_MAX], to[PATH_MAX];
    struct photo shown, photo = {0};
    bool done;

    series_name(series, number, name);
    if (!folder_path(options->patterns, name, ".png", from, message) ||
        !folder_path(options->folder, name, photo_suffix(options->format), to, message) ||
        !photo_read(from, PHOTO_SRGB, &shown, message))
        return false;
    done = shown.width == series->size_px[0] && shown.height == series->size_px[1];
    if (!done)
        snprintf(message, MESSAGE_SIZE, "%s.png of --patterns is %d x %d px; allowed: %d x %d",
                 name, shown.width, shown.height, series->size_px[0], series->size_px[1]);
    done = done && simulator_take(simulator, &shown, &photo, message) &&
           photo_write(to, &photo, options->format, message);
    photo_free(&shown);
    photo_free(&photo);
    return done;
}

static int take_all(const struct simulation *simulation, const struct series *series,
                    const struct capture_options *options, char *message)
{
    struct simulator *simulator = simulator_create(simulation, message);
    bool done = simulator != NULL;

    if (done && simulation->camera->kind == CAMERA_RECTILINEAR && !simulator_uses_gl(simulator))
        fprintf(stderr, "cupola-calib capture simulate: without a GL, by rays (%s)\n", message);
    for (int i = 0; done && i < series_count(series); i++)
        done = take(simulator, series, i, options, message);
    simulator_destroy(simulator);
    return done ? STATUS_OK : STATUS_FAILED;
}

/* No file is written over another, and the folder holds nothing else afterwards. */
static int check_files(const struct capture_options *options, const struct series *series,
                       char *message)
{
    const char *suffix = photo_suffix(options->format);
    const struct named_file others[] = {
        {.name = "--rig", .path = options->rig},
        {.name = "--references", .path = options->references, .written = true},
    };
    enum { OTHERS = sizeof others / sizeof *others };

    if (!named_files_differ(others, OTHERS, message) ||
        !folder_differs("a photograph", options->folder, suffix, true, series, others, OTHERS,
                        message) ||
        !folder_differs("a pattern", options->patterns, ".png", false, series, others, OTHERS,
                        message))
        return STATUS_USAGE;
    if (!folder_is_for("--folder", options->folder, suffix, series, message) ||
        !folder_make("--folder", options->folder, message) ||
        (options->references && !output_file_check("--references", options->references, message)))
        return STATUS_FAILED;
    return STATUS_OK;
}

int capture_simulate(const struct capture_options *options, char *message)
{
    struct cupola_rig rig;
    struct series series;
    struct camera camera;
    struct simulation simulation = {
        .rig = &rig,
        .output = options->projector,
        .camera = &camera,
        .exposure = options->exposure,
        .ambient = options->ambient,
        .vignetting = options->vignetting,
        .blur_px = options->blur_px,
        .noise = options->noise,
        .seed = options->seed,
    };
    int width = options->width ? options->width : 1280;
    int height = options->height ? options->height : 960;
    int status = capture_rig(options, &rig, message);

    if (status == STATUS_OK)
        status = capture_series(options->patterns, &rig, options->projector, &series, message);
    if (status == STATUS_OK)
        status = capture_camera(options, &rig, width, height, &camera, message);
    if (status == STATUS_OK)
        status = check_files(options, &series, message);
    if (status == STATUS_OK)
        status = take_all(&simulation, &series, options, message);
    if (status == STATUS_OK && !folder_write_series(options->folder, &series, message))
        status = STATUS_FAILED;
    if (status == STATUS_OK && options->references)
        status = write_references(options, &rig, &camera, message);
    if (status != STATUS_OK)
        return status;
    printf("%d photographs of %dx%d px in ", series_count(&series), width, height);
    plain_text_print(options->folder, stdout);
    putchar('\n');
    return STATUS_OK;
}
