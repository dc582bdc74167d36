/* The command line of cupola-demo: every option into its place, every wrong one refused. */
#include "options.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include <cupola/rig.h>

#include "filter_options.h"
#include "option_check.h"
#include "option_list.h"
#include "option_names.h"
#include "option_paths.h"
#include "scene_options.h"
#include "short_path.h"
#include "viewer_feed.h"

enum { BIG = 1000000 };

static bool vector(const struct value_context *context, const char *text, double limit,
                   struct optional *optional)
{
    optional->given = value_numbers(context, text, "X,Y,Z", (struct number_range){-limit, limit}, 3,
                                    3, optional->value);
    return optional->given;
}

static bool aim(const struct value_context *context, const char *text, struct optional *optional)
{
    optional->given =
        value_numbers(context, text, "YAW,PITCH,ROLL",
                      (struct number_range){-360, 360, .degrees = true}, 3, 3, optional->value);
    return optional->given;
}

static bool number(const struct value_context *context, const char *text, struct number_range range,
                   struct optional *optional)
{
    optional->given = value_number(context, text, range, &optional->value[0]);
    return optional->given;
}

static bool circle(const struct value_context *context, const char *text, struct optional *optional)
{
    if (!value_numbers(context, text, "CX,CY,R (pixels, R above 0)",
                       (struct number_range){-BIG, BIG}, 3, 3, optional->value))
        return false;
    optional->given = true;
    return value_number(&(struct value_context){"--circle: R", context->message},
                        strrchr(text, ',') + 1, (struct number_range){0, BIG, .above_low = true},
                        &optional->value[2]);
}

static bool view_count(const struct value_context *context, const char *text, int *views)
{
    if (strcmp(text, "auto") == 0) {
        *views = 0;
        return true;
    }
    if (value_integer(context, text, 1, CUPOLA_VIEWS_MAX, views))
        return true;
    snprintf(context->message, MESSAGE_SIZE,
             "%s: '%.200s' is not allowed; allowed: auto or a whole number, 1 to %d",
             context->option, text, CUPOLA_VIEWS_MAX);
    return false;
}

/* One mode at most. */
static bool set_mode(const struct value_context *context, enum show_mode mode, enum show_mode *mine)
{
    if (*mine == SHOW_DOME) {
        *mine = mode;
        return true;
    }
    snprintf(context->message, MESSAGE_SIZE,
             "%s: allowed: one of --perspective, --views-only, --preview and --map, once",
             context->option);
    return false;
}

/* Options about where the camera is and where the picture goes. */
static bool take_place(const struct value_context *c, int code, const char *text, struct options *o)
{
    int index;

    switch (code) {
    case OPTION_CAMERA:
        return vector(c, text, BIG, &o->camera);
    case OPTION_LOOK:
        return vector(c, text, BIG, &o->look);
    case OPTION_UP:
        return vector(c, text, BIG, &o->up);
    case OPTION_PERSPECTIVE:
        return set_mode(c, SHOW_PERSPECTIVE, &o->mode);
    case OPTION_VIEWS_ONLY:
        return set_mode(c, SHOW_VIEWS, &o->mode);
    case OPTION_PREVIEW:
        return value_name(c, text, option_preview_name, &index) &&
               set_mode(c, index ? SHOW_PREVIEW_OUTSIDE : SHOW_PREVIEW_EYE, &o->mode);
    case OPTION_MAP:
        return value_name(c, text, option_map_name, &index) && set_mode(c, SHOW_MAP, &o->mode);
    case OPTION_SHOW_OUTPUT:
        return value_integer(c, text, 0, CUPOLA_OUTPUTS_MAX - 1, &o->show_output);
    case OPTION_HEADLESS:
        return o->headless = true;
    case OPTION_FRAMES:
        return value_integer(c, text, 1, BIG, &o->frames);
    case OPTION_REFERENCE:
        return value_integer(c, text, 1, BIG, &o->reference);
    case OPTION_OUTPUT:
        return value_output_path(c, text, &o->output);
    case OPTION_STATS:
        return value_path(c, text, &o->stats);
    case OPTION_REPORT:
        return value_path(c, text, &o->report);
    case OPTION_MONITOR:
        return value_integer(c, text, 0, 63, &o->monitor);
    case OPTION_FULLSCREEN:
        return o->fullscreen = true;
    default:
        return value_integer(c, text, 0, 60, &o->swap_interval);
    }
}

/* Options about existing pictures. */
static bool take_picture(const struct value_context *c, int code, const char *text,
                         struct options *o)
{
    int index;

    switch (code) {
    case OPTION_SHOW:
        return value_path(c, text, &o->show);
    case OPTION_AS:
        if (!value_name(c, text, option_picture_kind_name, &index))
            return false;
        o->show_as = (enum cupola_source_kind)(index + CUPOLA_SOURCE_DOMEMASTER);
        return true;
    case OPTION_FRAME_RATE:
        return number(c, text, (struct number_range){0, 1000, .above_low = true}, &o->frame_rate);
    case OPTION_PICTURE_FOV:
        return number(c, text, (struct number_range){0, 360, true, true}, &o->picture_fov_rad);
    case OPTION_PICTURE_AIM:
        return aim(c, text, &o->picture_aim_rad);
    default:
        if (!value_name(c, text, option_picture_place_name, &index))
            return false;
        o->picture_place = (enum cupola_source_place)(index + CUPOLA_PLACE_SCREEN);
        return true;
    }
}

/* Options about the plan and its tables. */
static bool take_plan(const struct value_context *c, int code, const char *text, struct options *o)
{
    int index;
    double wished;

    o->views_given |= code != OPTION_TABLE;
    o->table_given |= code == OPTION_TABLE;
    o->plan_given |= code <= OPTION_GUARD || code == OPTION_MASK || code == OPTION_SUBMISSION;
    switch (code) {
    case OPTION_LAYOUT:
        if (!value_name(c, text, cupola_layout_name, &index))
            return false;
        o->plan.layout = (enum cupola_layout)index;
        return true;
    case OPTION_VIEWS:
        return view_count(c, text, &o->plan.views);
    case OPTION_DENSITY:
        if (!value_number(c, text, (struct number_range){1.0 / 16, 16}, &wished))
            return false;
        o->plan.density = wished;
        return true;
    case OPTION_GOAL:
        if (!value_name(c, text, goal_name, &index))
            return false;
        o->goal_auto = index > CUPOLA_GOAL_VERTICES;
        o->plan.goal = o->goal_auto ? CUPOLA_GOAL_FILL : (enum cupola_goal)index;
        return true;
    case OPTION_VIEW_SIZE:
        /* Atlases have 16384 texels each way, guard bands two at least. */
        return value_integer(c, text, 1, 16384 - 2, &o->plan.view_size_px);
    case OPTION_GUARD:
        return value_integer(c, text, 1, 256, &o->plan.guard_px);
    case OPTION_HEAD_RADIUS:
        return number(c, text, (struct number_range){0, 1000, .above_low = true},
                      &o->head_radius_m);
    case OPTION_EYE_CIRCLE:
        return number(c, text, (struct number_range){0, 1000, .above_low = true}, &o->eye_circle_m);
    case OPTION_OSC:
        o->osc = text;
        return viewer_osc_check(c, text);
    case OPTION_VIEWER_LOOKAHEAD:
        return number(c, text, (struct number_range){0, VIEWER_FEED_MOST_MS}, &o->lookahead_ms);
    case OPTION_VIEW_FORMAT:
        return value_name(c, text, option_view_format_name, &o->view_format);
    case OPTION_MSAA:
        return value_integer(c, text, 1, 64, &o->samples);
    case OPTION_DEPTH:
        if (!value_name(c, text, option_depth_name, &index))
            return false;
        o->reversed_depth = index == 1;
        return true;
    case OPTION_MASK:
        return value_name(c, text, option_mask_name, &o->mask);
    case OPTION_SUBMISSION:
        if (!value_name(c, text, option_submission_name, &index))
            return false;
        o->submission = (enum submission_wish)index;
        return true;
    default:
        if (!value_name(c, text, cupola_table_name, &index))
            return false;
        o->table = (enum cupola_table)index;
        return true;
    }
}

/* Options about the rig. */
static bool take_rig(const struct value_context *c, int code, const char *text, struct options *o)
{
    int index;

    switch (code) {
    case OPTION_RIG:
        return value_path(c, text, &o->rig);
    case OPTION_SAVE_RIG:
        return value_path(c, text, &o->save_rig);
    case OPTION_PRESET:
        o->preset = text;
        return value_name(c, text, cupola_rig_preset_name, &index);
    case OPTION_LENS:
        return value_name(c, text, cupola_lens_model_name, &o->lens);
    case OPTION_FOV:
        return number(c, text, (struct number_range){0, 360, true, true}, &o->fov_rad);
    case OPTION_LENS_K:
        o->lens_k.given = value_numbers(c, text, "K1,K3,K5,K7, 1 to 4 of them",
                                        (struct number_range){-BIG, BIG}, 1, 4, o->lens_k.value);
        return o->lens_k.given;
    case OPTION_LENS_TABLE:
        return value_path(c, text, &o->lens_table);
    case OPTION_FLIP:
        if (!value_name(c, text, option_flip_name, &index))
            return false;
        o->flip = index + 1; /* x 1, y 2, xy 3: the bits of enum cupola_flip */
        return true;
    case OPTION_SIZE:
        return value_size(c, text, &o->width_px, &o->height_px);
    case OPTION_CIRCLE:
        return circle(c, text, &o->circle_px);
    case OPTION_TILT:
        return number(c, text, (struct number_range){-180, 180, false, true}, &o->tilt_rad);
    case OPTION_CAP:
        return number(c, text, (struct number_range){0, 180, true, true}, &o->cap_rad);
    case OPTION_VIEWER:
        return vector(c, text, 1000, &o->viewer_m);
    case OPTION_PROJECTOR:
        return vector(c, text, 1000, &o->projector_m);
    case OPTION_PROJECTOR_AIM:
        return aim(c, text, &o->aim_rad);
    default:
        return number(c, text, (struct number_range){0, 1000, .above_low = true}, &o->radius_m);
    }
}

/* What is laid over the dome's image. */
static bool take_mark(const struct value_context *c, int code, const char *text, struct options *o)
{
    struct mark *mark = &o->marks[o->mark_count];

    if (o->mark_count == MARKS_MAX) {
        snprintf(c->message, MESSAGE_SIZE,
                 "%s: '%.200s' is one too many; allowed: %d of --label "
                 "and --cursor",
                 c->option, text, MARKS_MAX);
        return false;
    }
    o->mark_count++;
    return code == OPTION_LABEL ? value_label(c, text, mark) : value_cursor(c, text, mark);
}

static bool take(int code, int index, const char *text, struct options *options, char *message)
{
    char option[40];
    struct value_context context = {option, message};

    snprintf(option, sizeof option, "--%s", option_list[index].name);
    switch (code) {
    case OPTION_HELP:
        return options->help = true;
    case OPTION_VERSION:
        return options->version = true;
    default:
        if (code >= OPTION_RIG && code <= OPTION_RADIUS)
            return take_rig(&context, code, text, options);
        if (code >= OPTION_LAYOUT && code <= OPTION_TABLE)
            return take_plan(&context, code, text, options);
        if (code >= OPTION_AA && code <= OPTION_DITHER)
            return filter_options_take(&context, code, text, options);
        if (code >= OPTION_SCENE && code <= OPTION_SEED)
            return scene_options_take(&context, code, text, options);
        if (code >= OPTION_LABEL && code <= OPTION_CURSOR)
            return take_mark(&context, code, text, options);
        if (code >= OPTION_SHOW && code <= OPTION_PICTURE_PLACE)
            return take_picture(&context, code, text, options);
        return take_place(&context, code, text, options);
    }
}

static void unknown_option(int argc, char **argv, int code, char *message)
{
    const char *given = optind > 0 && optind <= argc ? argv[optind - 1] : "";

    if (code == ':')
        snprintf(message, MESSAGE_SIZE, "%.200s needs a value; cupola-demo --help names it", given);
    else if (optopt >= OPTION_HELP)
        snprintf(message, MESSAGE_SIZE, "%.200s: this option takes no value", given);
    else if (optopt > 0)
        snprintf(message, MESSAGE_SIZE,
                 "unknown option '-%c'; cupola-demo --help names the allowed ones", optopt);
    else
        snprintf(message, MESSAGE_SIZE,
                 "unknown option '%.200s'; cupola-demo --help names the allowed ones", given);
}

bool options_time_views(const struct options *options)
{
    return options->goal_auto;
}

int options_parse(int argc, char **argv, struct options *options, char *message)
{
    int code, index = 0;
    const char *problem;

    *options = (struct options){.table = CUPOLA_TABLE_TILES,
                                .lens = -1,
                                .flip = -1,
                                .shading = -1,
                                .seed = -1,
                                .view_format = -1,
                                .show_output = -1,
                                .monitor = -1,
                                .swap_interval = -1};
    options->words = argv + (argc > 0);
    options->word_count = argc - (argc > 0);
    opterr = 0;
    while ((code = getopt_long(argc, argv, ":h", option_list, &index)) != -1) {
        if (code == 'h') {
            options->help = true;
            return STATUS_OK;
        }
        if (code == '?' || code == ':') {
            unknown_option(argc, argv, code, message);
            return STATUS_USAGE;
        }
        if (!take(code, index, optarg, options, message))
            return STATUS_USAGE;
        if (options->help || options->version)
            return STATUS_OK;
    }
    if (argc - optind > 1) {
        snprintf(message, MESSAGE_SIZE, "'%s' is a second MODEL after '%s'; allowed: one MODEL",
                 short_path(argv[optind + 1]).text, short_path(argv[optind]).text);
        return STATUS_USAGE;
    }
    if (optind < argc)
        options->model = argv[optind];
    if ((problem = options_contradiction(options))) {
        snprintf(message, MESSAGE_SIZE, "%s", problem);
        return STATUS_USAGE;
    }
    return STATUS_OK;
}
