/* The command line of cupola-calib solve. */
#include "solve_options.h"

#include <getopt.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

#include "named_files.h"
#include "option_paths.h"
#include "short_path.h"
#include "solve/solve.h"
#include "status.h"

enum { HELP = 256, RIG, PRESET, PROJECTOR, FREE, FLIPS, OUTPUT, JSON, PLOT, VERBOSE };

static const struct option option_list[] = {
    {"help", no_argument, NULL, HELP},
    {"rig", required_argument, NULL, RIG},
    {"preset", required_argument, NULL, PRESET},
    {"projector", required_argument, NULL, PROJECTOR},
    {"free", required_argument, NULL, FREE},
    {"flips", no_argument, NULL, FLIPS},
    {"output", required_argument, NULL, OUTPUT},
    {"json", required_argument, NULL, JSON},
    {"plot", required_argument, NULL, PLOT},
    {"verbose", no_argument, NULL, VERBOSE},
    {0},
};

void solve_options_print_help(void)
{
    fputs(
        "Usage: cupola-calib solve MARKS.csv --rig START.cfg [--output RIG.cfg] [OPTIONS]\n"
        "Finds where the projector stands and aims from marks: known places of the screen and\n"
        "the pixels that light them. MARKS.csv has a header: name, x_px, y_px (origin bottom\n"
        "left), and either dir_x, dir_y, dir_z (directions from the centre of the screen, of any\n"
        "length) or x_m, y_m, z_m (points), both in the dome frame. A few wrong marks are found\n"
        "and named. Values print with their standard deviations (sd).\n"
        "\nStart\n"
        "  --rig FILE             what is known: screen, lens, image circle, viewer\n"
        "  --preset NAME          instead of a rig: one by name\n"
        "  --projector N          of the rig, 0 the first; default 0\n"
        "\nWhat is solved for\n"
        "  --free LIST            names with commas: circle (its centre), circle-radius, lens "
        "(its\n"
        "                         field of view; of a polynomial its coefficients, too, up to the\n"
        "                         last of the start that is not 0), position, aim, radius (of the\n"
        "                         screen); default position,aim\n"
        "  --flips                the picture may be mirrored otherwise than the start says\n"
        "\nResults\n"
        "  --output FILE          the solved rig; may be that of --rig; what was there stays as\n"
        "                         FILE.bak; without it there is only the report\n"
        "  --json FILE|-          values, sd and residuals as JSON; with - the report goes to\n"
        "                         standard error\n"
        "  --plot FILE.png        the residuals over the dome as a picture\n"
        "  --verbose              the residuals of all marks, not of the first 10 only\n"
        "  -h, --help\n"
        "\nExit status: 0; 1 where the marks do not determine what is free, or a file fails; 2\n"
        "for wrong options.\n",
        stdout);
}

static bool take(int code, const char *text, struct solve_options *options, char *message)
{
    char option[32] = "";
    struct value_context context = {option, message};
    int index;

    for (int i = 0; option_list[i].name; i++) {
        if (option_list[i].val == code)
            snprintf(option, sizeof option, "--%s", option_list[i].name);
    }
    switch (code) {
    case RIG:
        return value_path(&context, text, &options->rig);
    case PRESET:
        if (!value_name(&context, text, cupola_rig_preset_name, &index))
            return false;
        options->preset = cupola_rig_preset_name(index);
        return true;
    case PROJECTOR:
        return value_integer(&context, text, 0, CUPOLA_OUTPUTS_MAX - 1, &options->projector);
    case FREE:
        return solve_free_parse(option, text, &options->free, message);
    case FLIPS:
        return options->flips = true;
    case OUTPUT:
        return value_path(&context, text, &options->output);
    case JSON:
        return value_path(&context, text, &options->json);
    case PLOT:
        return value_png_path(&context, text, &options->plot);
    default:
        return options->verbose = true;
    }
}

static bool is_standard_output(const char *path)
{
    return path && strcmp(path, "-") == 0;
}

/* No file is written over another. The rig may be changed in place. */
static bool check_clashes(const struct solve_options *options, char *message)
{
    char backup[PATH_MAX] = "";
    const char *output = options->output;

    if (output && snprintf(backup, sizeof backup, "%s.bak", output) >= (int)sizeof backup)
        backup[0] = 0;
    const struct named_file files[] = {
        {.name = "--rig", .path = options->rig},
        {.name = "MARKS.csv", .path = options->marks},
        {"--output", output, true, true},
        {"--output (what was there)", *backup ? backup : NULL, true, true},
        {.name = "--json",
         .path = is_standard_output(options->json) ? NULL : options->json,
         .written = true},
        {.name = "--plot", .path = options->plot, .written = true},
    };

    return named_files_differ(files, (int)(sizeof files / sizeof *files), message);
}

static bool check(const struct solve_options *options, char *message)
{
    const char *problem = NULL;

    if (!options->marks)
        problem = "no marks; allowed: cupola-calib solve MARKS.csv ...";
    else if (!*options->marks)
        problem = "MARKS.csv: '' is not allowed; allowed: the name of a file";
    else if (!options->rig == !options->preset)
        problem = options->rig ? "--rig and --preset are both given; allowed: one of them"
                               : "nothing to start from; allowed: --rig FILE or --preset NAME";
    if (!problem)
        return check_clashes(options, message);
    snprintf(message, MESSAGE_SIZE, "%s", problem);
    return false;
}

static void unknown_option(int argc, char **argv, int code, char *message)
{
    const char *given = optind > 0 && optind <= argc ? argv[optind - 1] : "";

    if (code == ':')
        snprintf(message, MESSAGE_SIZE, "%.200s needs a value; cupola-calib solve --help names it",
                 given);
    else if (optopt >= HELP)
        snprintf(message, MESSAGE_SIZE, "%.200s: this option takes no value", given);
    else if (optopt > 0)
        snprintf(message, MESSAGE_SIZE,
                 "unknown option '-%c'; cupola-calib solve --help names the allowed ones", optopt);
    else
        snprintf(message, MESSAGE_SIZE,
                 "unknown option '%.200s'; cupola-calib solve --help names the allowed ones",
                 given);
}

int solve_options_parse(int argc, char **argv, struct solve_options *options, char *message)
{
    int code;

    *options = (struct solve_options){0};
    opterr = 0;
    while ((code = getopt_long(argc, argv, ":h", option_list, NULL)) != -1) {
        if (code == 'h' || code == HELP) {
            options->help = true;
            return STATUS_OK;
        }
        if (code == '?' || code == ':') {
            unknown_option(argc, argv, code, message);
            return STATUS_USAGE;
        }
        if (!take(code, optarg, options, message))
            return STATUS_USAGE;
    }
    if (argc - optind > 1) {
        snprintf(message, MESSAGE_SIZE, "'%s' is a second file of marks after '%s'; allowed: one",
                 short_path(argv[optind + 1]).text, short_path(argv[optind]).text);
        return STATUS_USAGE;
    }
    if (optind < argc)
        options->marks = argv[optind];
    return check(options, message) ? STATUS_OK : STATUS_USAGE;
}
