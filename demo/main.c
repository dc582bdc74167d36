/*
 * cupola-demo: any model or a built-in scene on a dome, in a window or in a file. Uses Cupola's
 * public headers only, like any other host.
 */
#include <signal.h>
#include <stdio.h>
#include <string.h>

#include <cupola/version.h>

#include "eye_path.h"
#include "file_clash.h"
#include "film_output.h"
#include "model_trial.h"
#include "options.h"
#include "output_file.h"
#include "plain_text.h"
#include "show.h"
#include "still.h"
#include "survey.h"
#include "window.h"
#include "world.h"

/* One line, whatever file names may hold. */
static int complain(int status, const char *message)
{
    fprintf(stderr, "cupola-demo: ");
    plain_text_print(message, stderr);
    fputc('\n', stderr);
    return status;
}

static bool check_files(const struct options *options, char *message)
{
    if (options->output && !film_output_is_numbered(options) &&
        !output_file_check("--output", options->output, message))
        return false;
    if (options->stats && strcmp(options->stats, "-") != 0 &&
        !output_file_check("--stats", options->stats, message))
        return false;
    if (options->report && strcmp(options->report, "-") != 0 &&
        !output_file_check("--report", options->report, message))
        return false;
    return !options->save_rig || output_file_check("--save-rig", options->save_rig, message);
}

static int run(const struct options *options, const struct show_setup *setup, char *message)
{
    bool window_wish = options->fullscreen || options->monitor >= 0 || options->swap_interval >= 0;

    if (survey_is_wished(options)) {
        int status = survey_run(options, setup, message);
        if (status != STATUS_OK || survey_is_all(options))
            return status;
    }
    if (options->model &&
        !model_trial(options->model, options_scene_wishes(options).shading != SCENE_FLAT, message,
                     MESSAGE_SIZE))
        return STATUS_FAILED;
    if (!options->headless && !options->output && !options->reference) {
        int status = window_run(options, setup, message);
        if (status != WINDOW_NO_DISPLAY || window_wish)
            return status == WINDOW_NO_DISPLAY ? STATUS_FAILED : status;
    }
    return still_run(options, setup, message);
}

int main(int argc, char **argv)
{
    char message[MESSAGE_SIZE] = "";
    struct options options;
    struct show_setup setup = {0};
    int status = options_parse(argc, argv, &options, message);

    signal(SIGXFSZ, SIG_IGN); /* a file that becomes too large is an ordinary error */
    if (status != STATUS_OK)
        return complain(status, message);
    if (options.help || options.version) {
        if (options.help)
            options_print_help();
        else
            printf("cupola-demo %s\n", cupola_version());
    } else {
        const char *picture = options.output;
        if (!picture && (options.headless || options.reference))
            picture = still_default_path(&options);
        if (!file_clash_check(&options, picture, message))
            return complain(STATUS_USAGE, message);
        status = world_check_camera(&options, message);
        if (status == STATUS_OK)
            status = options_rig(&options, &setup.rig, message);
        if (status == STATUS_OK && !check_files(&options, message))
            status = STATUS_FAILED;
        if (status != STATUS_OK)
            return complain(status, message);
        setup.plan = options.plan;
        setup.plan.head_radius_m = eye_path_head_radius_m(&options, &setup.rig);
        setup.measures_prices = options_time_views(&options);
        setup.table = options.table;
        setup.view_format = options.view_format;
        setup.samples = options.samples;
        setup.filter = options.filter;
        setup.aa_given = options.aa_given;
        setup.dither_bits = options.dither_bits;
        setup.reversed_depth = options.reversed_depth;
        setup.mask = (enum cupola_mask)options.mask;
        setup.plan.unmasked = options.mask == CUPOLA_MASK_NONE;
        setup.mode = options.mode;
        setup.overlays = options.mark_count > 0;
        setup.source = options.show_as;
        setup.output = options_output(&options);
        setup.picture_of_numbers = options.show && output_file_is_pfm(options.show);
        setup.reference = options.reference > 0;
        setup.floats = options.output && output_file_is_pfm(options.output) && !setup.reference;
        status = run(&options, &setup, message);
        if (status != STATUS_OK)
            return complain(status, message);
    }
    if (fflush(stdout) != 0) {
        snprintf(message, sizeof message, "standard output cannot be written");
        return complain(STATUS_FAILED, message);
    }
    return STATUS_OK;
}
