/* Reading the tool's command line. */
#include "tool/tool_options.h"

#include <getopt.h>
#include <stdio.h>
#include <string.h>

#include "option_paths.h"
#include "short_path.h"
#include "status.h"
#include "tool/tool.h"
#include "viewer_feed.h"

enum code {
    RIG = 256, /* above every character */
    PRESET,
    PROJECTOR,
    OUTPUT,
    MARKS,
    MARKS_OUTPUT,
    THEATRE,
    MONITOR,
    WINDOWED,
    PREVIEW,
    PATTERN,
    SCRIPT,
    HEADLESS,
    PICTURE,
    FRAMES,
    SWAP_INTERVAL,
    OSC,
    VIEWER_LOOKAHEAD,
    FRESH,
    JOURNAL,
    HELP,
    VERSION,
};

static const struct option list[] = {
    {"rig", required_argument, NULL, RIG},
    {"preset", required_argument, NULL, PRESET},
    {"projector", required_argument, NULL, PROJECTOR},
    {"output", required_argument, NULL, OUTPUT},
    {"marks", required_argument, NULL, MARKS},
    {"marks-output", required_argument, NULL, MARKS_OUTPUT},
    {"theatre", required_argument, NULL, THEATRE},
    {"monitor", required_argument, NULL, MONITOR},
    {"windowed", optional_argument, NULL, WINDOWED},
    {"preview", required_argument, NULL, PREVIEW},
    {"pattern", required_argument, NULL, PATTERN},
    {"script", required_argument, NULL, SCRIPT},
    {"headless", no_argument, NULL, HEADLESS},
    {"picture", required_argument, NULL, PICTURE},
    {"frames", required_argument, NULL, FRAMES},
    {"swap-interval", required_argument, NULL, SWAP_INTERVAL},
    {"osc", required_argument, NULL, OSC},
    {"viewer-lookahead", required_argument, NULL, VIEWER_LOOKAHEAD},
    {"fresh", no_argument, NULL, FRESH},
    {"journal", no_argument, NULL, JOURNAL},
    {"help", no_argument, NULL, HELP},
    {"version", no_argument, NULL, VERSION},
    {NULL, 0, NULL, 0},
};

/* Its value may stand behind a blank: a word that begins like a size is one. */
static bool take_windowed(const struct value_context *c, int argc, char **argv, const char *text,
                          struct tool_options *o)
{
    const char *next = optind < argc ? argv[optind] : "";
    size_t digits = strspn(next, "0123456789");

    if (!text && digits > 0 && next[digits] == 'x') {
        text = next;
        optind++;
    }
    o->windowed = true;
    return !text || value_size(c, text, &o->width, &o->height);
}

/* Options about files. */
static bool take_file(const struct value_context *c, int code, const char *text,
                      struct tool_options *o)
{
    switch (code) {
    case RIG:
        return value_path(c, text, &o->rig);
    case OUTPUT:
        return value_path(c, text, &o->output);
    case MARKS:
        return value_path(c, text, &o->marks);
    case MARKS_OUTPUT:
        return value_path(c, text, &o->marks_output);
    case THEATRE:
        return value_path(c, text, &o->theatre);
    case PICTURE:
        return value_output_path(c, text, &o->picture);
    default:
        return value_path(c, text, &o->script);
    }
}

static bool take(const struct value_context *c, int code, const char *text, struct tool_options *o)
{
    int index;

    switch (code) {
    case PRESET:
        o->preset = text;
        return value_name(c, text, cupola_rig_preset_name, &index);
    case PROJECTOR:
        return value_integer(c, text, 0, CUPOLA_OUTPUTS_MAX - 1, &o->projector);
    case MONITOR:
        return value_integer(c, text, 0, 63, &o->monitor);
    case PREVIEW:
        return value_name(c, text, tool_preview_name, &o->preview);
    case PATTERN:
        return value_name(c, text, tool_pattern_name, &o->pattern);
    case HEADLESS:
        return o->headless = true;
    case FRAMES:
        return value_integer(c, text, 1, 1000000, &o->frames);
    case SWAP_INTERVAL:
        return value_integer(c, text, 0, 60, &o->swap_interval);
    case OSC:
        o->osc = text;
        return viewer_osc_check(c, text);
    case VIEWER_LOOKAHEAD:
        o->lookahead_given = true;
        return value_number(c, text, (struct number_range){0, VIEWER_FEED_MOST_MS},
                            &o->lookahead_ms);
    case FRESH:
        return o->fresh = true;
    case JOURNAL:
        return o->journal = true;
    case HELP:
        return o->help = true;
    case VERSION:
        return o->version = true;
    default:
        return take_file(c, code, text, o);
    }
}

static void unknown_option(int argc, char **argv, int code, char *message)
{
    const char *given = optind > 0 && optind <= argc ? argv[optind - 1] : "";

    if (code == ':')
        snprintf(message, MESSAGE_SIZE, "%.200s needs a value; cupola-calib --help names it",
                 given);
    else if (optopt >= RIG)
        snprintf(message, MESSAGE_SIZE, "%.200s: this option takes no value", given);
    else if (optopt > 0)
        snprintf(message, MESSAGE_SIZE,
                 "unknown option '-%c'; cupola-calib --help names the allowed ones", optopt);
    else
        snprintf(message, MESSAGE_SIZE,
                 "unknown option '%.200s'; cupola-calib --help names the allowed ones", given);
}

static const char *contradiction(const struct tool_options *o)
{
    if (o->rig && o->preset)
        return "--preset and a rig file both say what to begin with; allowed: one of them";
    if (o->script && o->picture)
        return "--script and --picture are both there; allowed: a line 'picture FILE.png' in the "
               "script";
    if (o->script && o->frames > 0)
        return "--script and --frames are both there; allowed: a line 'frames N' in the script";
    if (o->script && o->osc)
        return "--script and --osc are both there; allowed: lines 'eye X Y Z' in the script";
    if ((o->headless || o->picture) && o->osc)
        return "--osc needs a window; allowed: without --headless and --picture";
    if (o->lookahead_given && !o->osc)
        return "--viewer-lookahead needs --osc; allowed: together with it";
    if (o->headless && !o->script && !o->picture && o->frames == 0)
        return "--headless shows nothing; allowed: with --script, --picture or --frames";
    if (o->marks_output && !o->marks)
        return "--marks-output needs --marks; allowed: both";
    return NULL;
}

static int take_rest(int argc, char **argv, struct tool_options *options, char *message)
{
    const char *problem;

    if (optind < argc && !options->rig)
        options->rig = argv[optind++];
    if (optind < argc) {
        snprintf(message, MESSAGE_SIZE,
                 "'%s' is one too many; allowed: one rig file, or a command (solve, capture) first",
                 short_path(argv[optind]).text);
        return STATUS_USAGE;
    }
    if (options->rig && !*options->rig) {
        snprintf(message, MESSAGE_SIZE, "'' is not allowed; allowed: the name of a rig file");
        return STATUS_USAGE;
    }
    problem = contradiction(options);
    if (problem)
        snprintf(message, MESSAGE_SIZE, "%s", problem);
    return problem ? STATUS_USAGE : STATUS_OK;
}

int tool_options_parse(int argc, char **argv, struct tool_options *options, char *message)
{
    int code, index = 0;
    char option[40];
    struct value_context context = {option, message};

    *options = (struct tool_options){
        .preview = -1, .pattern = -1, .swap_interval = 1, .lookahead_ms = VIEWER_FEED_USUAL_MS};
    optind = 1;
    opterr = 0;
    while ((code = getopt_long(argc, argv, ":h", list, &index)) != -1) {
        if (code == '?' || code == ':') {
            unknown_option(argc, argv, code, message);
            return STATUS_USAGE;
        }
        options->help |= code == 'h';
        if (code != 'h') {
            snprintf(option, sizeof option, "--%s", list[index].name);
            if (!(code == WINDOWED ? take_windowed(&context, argc, argv, optarg, options)
                                   : take(&context, code, optarg, options)))
                return STATUS_USAGE;
        }
        if (options->help || options->version)
            return STATUS_OK;
    }
    return take_rest(argc, argv, options, message);
}
