/* Renders without a window. */
#include "still.h"

#include <stdio.h>
#include <string.h>

#include <epoxy/gl.h>

#include <cupola/rig_file.h>

#include "eye_path.h"
#include "file_clash.h"
#include "film_output.h"
#include "headless.h"
#include "output_file.h"
#include "prices.h"
#include "reference.h"
#include "stats.h"
#include "target.h"
#include "view_wishes.h"
#include "world.h"

struct still {
    struct cupola_rig rig; /* complete */
    struct headless *headless;
    struct world world;
    struct marks marks;
    struct show *show;
    struct target target;
    struct eye_path eye;
    struct stats *stats;         /* NULL: nobody wants them */
    struct reference *reference; /* NULL: each picture is one frame */
    bool numbered;               /* each frame of a film goes to a file of its own */
};

static int create(struct still *still, const struct options *options,
                  const struct show_setup *setup, FILE *news, char *message)
{
    struct show_setup mine = *setup;
    int status, width, height;

    status = eye_path_create(&still->eye, options, &setup->rig, message);
    if (status != STATUS_OK)
        return status;
    still->headless = headless_create(message, MESSAGE_SIZE);
    if (!still->headless)
        return STATUS_FAILED;
    status = world_create(&still->world, options, &setup->rig, news, message);
    if (status != STATUS_OK)
        return status;
    mine.one_pass = still->world.way != 0;
    mine.floats |= still->world.scene && still->world.scene->needs_float;
    if (!marks_create(&still->marks, options->marks, options->mark_count, message))
        return STATUS_FAILED;
    if (mine.measures_prices && still->world.scene &&
        !prices_measure(&mine, still->world.scene, &still->world.camera, message))
        return STATUS_FAILED;
    still->show = show_create(&mine, message);
    if (!still->show)
        return STATUS_FAILED;
    show_size(still->show, &width, &height);
    if (!target_create(&still->target, width, height,
                       mine.floats || mine.reference ? TARGET_FLOATS : TARGET_BYTES, message,
                       MESSAGE_SIZE))
        return STATUS_FAILED;
    if (options->stats && !(still->stats = stats_create(options->stats))) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return STATUS_FAILED;
    }
    options_notice(options, &setup->rig);
    eye_path_announce(&still->eye, news);
    return STATUS_OK;
}

static void destroy(struct still *still)
{
    eye_path_destroy(&still->eye);
    stats_destroy(still->stats);
    reference_destroy(still->reference);
    if (still->headless) {
        if (still->target.framebuffer)
            target_destroy(&still->target);
        show_destroy(still->show);
        marks_destroy(&still->marks);
        world_destroy(&still->world);
    }
    headless_destroy(still->headless);
}

/* The file of picture `index`: of a film's, or the only one. */
static bool find_path(const struct still *still, const struct options *options, long index,
                      const char *single, char path[PATH_MAX], char *message)
{
    if (still->numbered ? film_output_path(options, still->world.film, index, path)
                        : snprintf(path, PATH_MAX, "%s", single) < PATH_MAX)
        return true;
    snprintf(message, MESSAGE_SIZE, "--output makes too long a name");
    return false;
}

/* What becomes of picture `index` once it can be drawn. */
static int draw_picture(struct still *still, const struct options *options,
                        const struct show_frame *frame, long index, const char *single,
                        char *message)
{
    char path[PATH_MAX];

    if (!find_path(still, options, index, single, path, message))
        return STATUS_FAILED;
    if (still->reference)
        return reference_draw(still->reference, still->show, frame, index, path, message);
    if (!show_draw(still->show, frame, message))
        return STATUS_FAILED;
    if (still->stats)
        stats_add_frame(still->stats, frame->times);
    return !still->numbered ||
                   output_file_capture(path, still->target.framebuffer, still->target.width,
                                       still->target.height, message)
               ? STATUS_OK
               : STATUS_FAILED;
}

/* How many frames, or pictures, there are. */
static long count_frames(const struct still *still, const struct options *options)
{
    if (still->numbered)
        return film_output_frames(options, still->world.film);
    if (still->stats)
        return stats_frames(options->frames) + 1;
    return options->frames > 0 ? options->frames : 1;
}

static int draw(struct still *still, const struct options *options, const char *path, char *message)
{
    long frames = count_frames(still, options);
    int status = STATUS_OK;
    double eye_m[3];
    struct frame_times times;
    struct scene_range range = {0};
    struct show_frame frame = {
        .source = still->world.film ? film_source(still->world.film) : NULL,
        .scene = still->world.scene,
        .camera = &still->world.camera,
        .range = &range,
        .overlays = still->marks.overlays,
        .overlay_count = still->marks.count,
        .framebuffer = still->target.framebuffer,
        .width = still->target.width,
        .height = still->target.height,
        .times = still->stats ? &times : NULL,
    };

    for (long i = still->reference ? reference_first(still->reference) : 0;
         status == STATUS_OK && i < frames; i++) {
        if (still->world.film && !film_seek(still->world.film, i, message))
            return STATUS_FAILED;
        if (eye_path_place(&still->eye, (double)i / (double)frames, eye_m))
            frame.eye_m = eye_m;
        status = draw_picture(still, options, &frame, i, path, message);
    }
    return status;
}

/* The picture last but one: when it cannot be written, neither are the statistics. */
static bool write_files(struct still *still, const struct options *options, const char *path,
                        char *message)
{
    struct cupola_error error = {0};

    if (options->save_rig && cupola_rig_write(options->save_rig, &still->rig, &error) < 0) {
        snprintf(message, MESSAGE_SIZE, "--save-rig: %s", error.message);
        return false;
    }
    if (still->stats) {
        stats_time_tables(still->stats, still->show);
        stats_add_reports(still->stats, eye_path_counts(&still->eye));
        if (strcmp(options->stats, "-") != 0 &&
            !stats_write(still->stats, still->show, still->world.scene,
                         (const char *)glGetString(GL_RENDERER), message))
            return false;
    }
    if (!still->numbered && !still->reference &&
        !output_file_capture(path, still->target.framebuffer, still->target.width,
                             still->target.height, message))
        return false;
    if (still->stats && strcmp(options->stats, "-") == 0)
        return stats_write(still->stats, still->show, still->world.scene,
                           (const char *)glGetString(GL_RENDERER), message);
    return !still->stats || stats_keep(still->stats, message);
}

const char *still_default_path(const struct options *options)
{
    return options_scene_is_numbers(options) ? "dome.pfm" : "dome.png";
}

int still_run(const struct options *options, const struct show_setup *setup, char *message)
{
    struct still still = {.rig = setup->rig, .numbered = film_output_is_numbered(options)};
    bool stdout_taken = (options->stats && strcmp(options->stats, "-") == 0) ||
                        (options->report && strcmp(options->report, "-") == 0);
    FILE *news = stdout_taken ? stderr : stdout;
    const char *path = options->output;
    int status;

    if (!path)
        path = still_default_path(options);
    if (!film_output_check_options(options, message) || !file_clash_check(options, path, message))
        return STATUS_USAGE;
    if (!still.numbered && !output_file_check("--output", path, message))
        return STATUS_FAILED;
    status = create(&still, options, setup, news, message);
    if (status == STATUS_OK &&
        !film_output_check_files(options, still.world.film, still.numbered ? NULL : path, message))
        status = STATUS_FAILED;
    if (status == STATUS_OK && options->reference &&
        !(still.reference = reference_create(
              options, path, count_frames(&still, options), &still.world, &still.target,
              view_wishes_colors(show_setup_of(still.show)), message)))
        status = STATUS_FAILED;
    if (status == STATUS_OK)
        status = draw(&still, options, path, message);
    if (status == STATUS_OK && !write_files(&still, options, path, message))
        status = STATUS_FAILED;
    if (status == STATUS_OK && !options->output)
        fprintf(news, "wrote %s\n", path);
    destroy(&still);
    return status;
}
