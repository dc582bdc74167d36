/* The interactive tool, from its command line to its end. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cupola/rig_file.h>
#include <cupola/version.h>

#include "output_file.h"
#include "short_path.h"
#include "status.h"
#include "tool/journal.h"
#include "tool/script.h"
#include "tool/still.h"
#include "tool/tool.h"
#include "tool/tool_options.h"
#include "tool/tracker.h"
#include "tool/window.h"

static int read_rig(const char *path, struct cupola_rig *rig, char *message)
{
    struct cupola_error error = {0};

    if (cupola_rig_read(path, NULL, rig, &error) >= 0)
        return STATUS_OK;
    snprintf(message, MESSAGE_SIZE, "%s", error.message);
    return STATUS_FAILED;
}

static int begin_rig(const struct tool_options *options, struct cupola_rig *rig, char *message)
{
    int status = STATUS_OK;

    *rig = (struct cupola_rig){0};
    if (options->rig)
        status = read_rig(options->rig, rig, message);
    else if (options->preset)
        cupola_rig_preset(options->preset, rig, NULL);
    else
        cupola_rig_complete(rig, rig, NULL);
    if (status == STATUS_OK && options->projector >= rig->output_count) {
        snprintf(message, MESSAGE_SIZE, "--projector: %d is not allowed; allowed: 0 to %d",
                 options->projector, rig->output_count - 1);
        status = STATUS_USAGE;
    }
    return status;
}

/* lobby.csv: lobby-steered.csv, and that again the same. To be freed. */
static char *steered_path(const struct tool_options *options)
{
    static const char tail[] = "-steered.csv";
    const char *from = options->marks_output ? options->marks_output : options->marks;
    size_t length = strlen(from), end = strlen(tail);
    char *path = malloc(length + sizeof tail);

    if (!path)
        return NULL;
    memcpy(path, from, length + 1);
    if (options->marks_output || (length >= end && strcmp(path + length - end, tail) == 0))
        return path;
    if (length > 4 && strcmp(path + length - 4, ".csv") == 0)
        length -= 4;
    memcpy(path + length, tail, sizeof tail);
    return path;
}

static bool keeps_journal(const struct tool_options *options)
{
    return (!options->script && !options->picture && !options->headless) || options->journal;
}

/* Whether anything is there that could save: keys, a script, a journal that keeps what is not. */
static bool can_save(const struct tool_options *options)
{
    return options->script || keeps_journal(options);
}

/* NULL for standard input. */
static const char *script_file(const struct tool_options *options)
{
    return options->script && strcmp(options->script, "-") != 0 ? options->script : NULL;
}

/* Whether the files to be saved to can be written; NULL: none is. */
static bool check_saved(const struct tool_files *files, const char *rig_path,
                        const char *marks_path, char *message)
{
    return (!rig_path || output_file_check(files->output_given ? "--output" : "default --output",
                                           rig_path, message)) &&
           (!marks_path || output_file_check(files->marks_output_given ? "--marks-output"
                                                                       : "default --marks-output",
                                             marks_path, message));
}

static int open_tool(const struct tool_options *options, struct tool *tool, char *message)
{
    struct cupola_rig rig;
    struct marks marks = {0};
    const char *rig_path = options->output ? options->output : options->rig;
    const struct tool_files files = {
        .rig = options->rig,
        .theatre = options->theatre,
        .marks = options->marks,
        .script = script_file(options),
        .picture = options->picture,
        .output_given = options->output != NULL,
        .marks_output_given = options->marks_output != NULL,
    };
    char *marks_path = options->marks ? steered_path(options) : NULL;
    const char *saved_rig, *saved_marks;
    int status;

    if (!rig_path)
        rig_path = "rig.cfg";
    saved_rig = can_save(options) ? rig_path : NULL;
    saved_marks = can_save(options) ? marks_path : NULL;
    status = tool_files_check(&files, saved_rig, saved_marks, message)
                 ? begin_rig(options, &rig, message)
                 : STATUS_USAGE;
    if (status == STATUS_OK && !check_saved(&files, saved_rig, saved_marks, message))
        status = STATUS_FAILED;
    if (status == STATUS_OK && options->marks &&
        (!marks_path || !marks_read(options->marks, false, &marks, message)))
        status = STATUS_FAILED;
    if (status == STATUS_OK &&
        !tool_open(tool, &rig, options->projector, options->marks ? &marks : NULL, rig_path,
                   marks_path, message))
        status = STATUS_FAILED;
    if (status == STATUS_OK)
        tool->files = files;
    free(marks_path);
    return status;
}

/* A journal goes on where it ended even if what it began with has changed since: that is said. */
static void warn_of_others(const struct tool_options *options, struct tool *tool)
{
    struct journal_others others = journal_others(tool->journal);
    struct short_path rig = short_path(options->rig ? options->rig : "");
    struct short_path marks = short_path(options->marks ? options->marks : "");
    char what[2 * SHORT_PATH_MAX + 80] = "";

    if (!others.rig && !others.marks)
        return;
    if (others.rig && options->rig)
        snprintf(what, sizeof what, "%s has been changed since", rig.text);
    else if (others.rig)
        snprintf(what, sizeof what, "%s%s is another rig than it began with",
                 options->preset ? "--preset " : "the default",
                 options->preset ? options->preset : "");
    if (others.marks)
        snprintf(what + strlen(what), sizeof what - strlen(what), "%s%s has been changed since",
                 others.rig ? ", " : "", marks.text);
    snprintf(tool->warning, MESSAGE_SIZE,
             "restored from the journal, but %s: --fresh takes what is there now, S writes over it",
             what);
}

/* What was not saved, and where it is. */
static void tell_unsaved(const struct tool *tool)
{
    const char *path = tool->journal ? journal_path(tool->journal) : "";
    char text[MESSAGE_SIZE] = "unsaved changes are lost";

    if (tool->journal && journal_is_whole(tool->journal))
        snprintf(text, sizeof text, "unsaved changes are kept in %s", short_path(path).text);
    else if (tool->journal)
        snprintf(text, sizeof text, "unsaved changes are lost: %s cannot be written (%s)",
                 short_path(path).text, strerror(errno));
    complain("", STATUS_OK, text);
}

/* What really stands there has the projector that is set up. */
static int read_theatre(const struct tool_options *options, struct cupola_rig *theatre,
                        char *message)
{
    int status = read_rig(options->theatre, theatre, message);

    if (status != STATUS_OK || options->projector < theatre->output_count)
        return status;
    snprintf(message, MESSAGE_SIZE,
             "--projector: %d is not in --theatre %s, which has %d projector%s;"
             " allowed: 0 to %d",
             options->projector, short_path(options->theatre).text, theatre->output_count,
             theatre->output_count == 1 ? "" : "s", theatre->output_count - 1);
    return STATUS_USAGE;
}

/* Journal, then what the command line says over it. */
static int begin(const struct tool_options *options, struct tool *tool, char *message)
{
    struct cupola_rig theatre;
    int status = options->theatre ? read_theatre(options, &theatre, message) : STATUS_OK;

    if (status != STATUS_OK)
        return status;
    if (keeps_journal(options)) {
        if (journal_open(tool, options->fresh, message) == JOURNAL_FAILED)
            return STATUS_FAILED;
        warn_of_others(options, tool);
    }
    if (options->theatre)
        tool->theatre = theatre;
    if (options->pattern >= 0)
        tool->pattern = (enum pattern)options->pattern;
    if (options->preview >= 0)
        tool->preview = (enum preview)options->preview;
    journal_look(tool);
    return STATUS_OK;
}

/* What draws without a window. */
struct drawing {
    const struct tool_options *options;
    struct still *still; /* made when it is needed */
};

static void size_of(const struct drawing *drawing, const struct tool *tool, int *width, int *height)
{
    const struct cupola_output *output = &tool->rig.outputs[tool->output];

    *width = drawing->options->width > 0 ? drawing->options->width : output->width_px;
    *height = drawing->options->height > 0 ? drawing->options->height : output->height_px;
}

static bool begin_drawing(struct drawing *drawing, char *message)
{
    if (!drawing->still)
        drawing->still = still_create(message);
    return drawing->still != NULL;
}

static bool draw_picture(void *user, struct tool *tool, bool dome, const char *path, char *message)
{
    struct drawing *drawing = user;
    int width = 0, height = 0;

    if (!output_file_check("picture", path, message) || !begin_drawing(drawing, message))
        return false;
    if (!dome)
        size_of(drawing, tool, &width, &height);
    return still_write(drawing->still, tool, width, height, path, message);
}

static bool draw_frames(void *user, struct tool *tool, int count, char *message)
{
    struct drawing *drawing = user;
    int width, height;

    if (!begin_drawing(drawing, message))
        return false;
    size_of(drawing, tool, &width, &height);
    for (int i = 0; i < count; i++)
        if (!still_draw(drawing->still, tool, width, height, message))
            return false;
    return true;
}

static int play_script(struct tool *tool, const char *path, struct drawing *drawing, char *message)
{
    const struct script_stage stage = {drawing, draw_picture, draw_frames};
    bool is_stdin = strcmp(path, "-") == 0;
    FILE *stream = is_stdin ? stdin : fopen(path, "r");
    int status;

    if (!stream) {
        snprintf(message, MESSAGE_SIZE, "--script: %s cannot be read: %s", short_path(path).text,
                 strerror(errno));
        return STATUS_FAILED;
    }
    status = script_play(tool, stream, is_stdin ? "standard input" : path, &stage, message);
    if (!is_stdin)
        fclose(stream);
    return status;
}

static int run_without_window(const struct tool_options *options, struct tool *tool, char *message)
{
    struct drawing drawing = {options, NULL};
    int status = STATUS_OK;

    if (options->script)
        status = play_script(tool, options->script, &drawing, message);
    else if ((options->frames > 0 && !draw_frames(&drawing, tool, options->frames, message)) ||
             (options->picture && !draw_picture(&drawing, tool, false, options->picture, message)))
        status = STATUS_FAILED;
    still_destroy(drawing.still);
    return status;
}

static int run_window(const struct tool_options *options, struct tool *tool, char *message)
{
    const struct cupola_output *output = &tool->rig.outputs[tool->output];
    struct window_wishes wishes = {.monitor = options->monitor,
                                   .swap_interval = options->swap_interval,
                                   .frames = options->frames};
    struct tracker *tracker = NULL;
    int status;

    if (options->windowed) {
        wishes.width = options->width > 0 ? options->width : output->width_px;
        wishes.height = options->height > 0 ? options->height : output->height_px;
    }
    if (options->osc) {
        tracker = tracker_open(tool, options->osc, options->lookahead_ms, message);
        if (!tracker)
            return STATUS_FAILED;
        wishes.before_frame = tracker_hear;
        wishes.user = tracker;
    }
    status = window_run(tool, &wishes, message);
    tracker_close(tracker);
    return status;
}

static int run(const struct tool_options *options, char *message)
{
    char warnings[2 * MESSAGE_SIZE];
    struct tool tool;
    int status = open_tool(options, &tool, message);

    if (status != STATUS_OK)
        return status;
    status = begin(options, &tool, message);
    tool_warnings(&tool, "; ", warnings);
    if (status == STATUS_OK && (warnings[0] || tool.notice[0]))
        complain("", STATUS_OK, warnings[0] ? warnings : tool.notice);
    if (status == STATUS_OK)
        status = options->script || options->picture || options->headless
                     ? run_without_window(options, &tool, message)
                     : run_window(options, &tool, message);
    if (tool.unsaved && (tool.journal || tool.standing[0]))
        tell_unsaved(&tool);
    tool_close(&tool);
    return status;
}

int tool_main(int argc, char **argv)
{
    struct tool_options options;
    char message[MESSAGE_SIZE] = "";
    int status = tool_options_parse(argc, argv, &options, message);

    if (status == STATUS_OK && options.help)
        tool_options_help();
    else if (status == STATUS_OK && options.version)
        printf("cupola-calib %s\n", cupola_version());
    else if (status == STATUS_OK)
        status = run(&options, message);
    return status == STATUS_OK ? STATUS_OK : complain("", status, message);
}
