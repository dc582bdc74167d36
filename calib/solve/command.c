/* The command `solve`: from a file of marks to a rig file, a report, JSON and a picture. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cupola/rig_file.h>

#include "option_values.h"
#include "output_file.h"
#include "plain_text.h"
#include "solve/report.h"
#include "solve/residual_plot.h"
#include "solve/solve.h"
#include "solve/solve_json.h"
#include "solve/solve_options.h"
#include "status.h"
#include "whole_file.h"

static bool to_standard_output(const struct solve_options *options)
{
    return options->json && strcmp(options->json, "-") == 0;
}

/* Before the work: whether what is to be written can be. */
static bool check_files(const struct solve_options *options, char *message)
{
    return (!options->output || output_file_check("--output", options->output, message)) &&
           (!options->json || to_standard_output(options) ||
            output_file_check("--json", options->json, message)) &&
           (!options->plot || output_file_check("--plot", options->plot, message));
}

static bool read_start(const struct solve_options *options, struct cupola_rig *start, char *message)
{
    struct cupola_error error = {0};
    int status = options->rig ? cupola_rig_read(options->rig, NULL, start, &error)
                              : cupola_rig_preset(options->preset, start, &error);

    if (status < 0)
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
    return status >= 0;
}

static bool settle_json(struct whole_file *file, const struct solve_options *options,
                        const struct solve_request *request, const struct solve_result *result,
                        char *message)
{
    if (!options->json || to_standard_output(options))
        return true;
    if (!whole_file_begin(file, options->json, message))
        return false;
    solve_json_write(file->stream, request, result);
    return whole_file_settle(file, message);
}

static bool settle_plot(struct whole_file *file, const struct solve_options *options,
                        const struct solve_request *request, const struct solve_result *result,
                        char *message)
{
    return !options->plot ||
           (whole_file_begin(file, options->plot, message) &&
            residual_plot_write(file->stream, options->plot, request, result, message) &&
            whole_file_settle(file, message));
}

static bool write_rig(const struct solve_options *options, const struct cupola_rig *rig,
                      char *message)
{
    struct cupola_error error = {0};

    if (!options->output || cupola_rig_write(options->output, rig, &error) >= 0)
        return true;
    snprintf(message, MESSAGE_SIZE, "--output: %s", error.message);
    return false;
}

/*
 * JSON and picture are on the disk before the rig is, and get their names after it: a full disk
 * leaves all files as they were.
 */
static bool write_files(const struct solve_options *options, const struct solve_request *request,
                        const struct solve_result *result, char *message)
{
    struct whole_file json = {0}, plot = {0};
    bool written = settle_json(&json, options, request, result, message) &&
                   settle_plot(&plot, options, request, result, message) &&
                   write_rig(options, &result->rig, message) &&
                   (!json.path || whole_file_end(&json, message)) &&
                   (!plot.path || whole_file_end(&plot, message));

    whole_file_abort(&json);
    whole_file_abort(&plot);
    return written;
}

static void report_file(FILE *report, const char *path)
{
    fputs("written: ", report);
    plain_text_print(path, report);
    fputc('\n', report);
}

static bool run(const struct solve_options *options, const struct marks *marks, char *message)
{
    struct cupola_rig start;
    struct solve_result result;
    struct solve_request request = {&start, options->projector, marks, options->free,
                                    options->flips};

    if (!read_start(options, &start, message) || !solve(&request, &result, message))
        return false;
    bool written = write_files(options, &request, &result, message);
    if (written) {
        FILE *report = to_standard_output(options) ? stderr : stdout;
        report_write(report, &request, &result, options->verbose);
        if (options->output)
            report_file(report, options->output);
        if (to_standard_output(options))
            solve_json_write(stdout, &request, &result);
    }
    solve_result_free(&result);
    return written;
}

int solve_main(int argc, char **argv)
{
    char message[MESSAGE_SIZE] = "";
    struct solve_options options;
    struct marks marks;
    int status = solve_options_parse(argc, argv, &options, message);

    if (status != STATUS_OK)
        return complain("solve", status, message);
    if (options.help) {
        solve_options_print_help();
        return STATUS_OK;
    }
    if (!check_files(&options, message) || !marks_read(options.marks, true, &marks, message))
        return complain("solve", STATUS_FAILED, message);
    bool solved = run(&options, &marks, message);
    marks_free(&marks);
    return solved ? STATUS_OK : complain("solve", STATUS_FAILED, message);
}
