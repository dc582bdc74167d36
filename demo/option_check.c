/* Options of cupola-demo that contradict each other. */
#include "option_check.h"

#include <stddef.h>
#include <string.h>

#include "file_pattern.h"
#include "filter_options.h"

/* What is wrong with options about existing pictures taken together; NULL: nothing. */
static const char *picture_contradiction(const struct options *o)
{
    bool wished = o->show_as || o->frame_rate.given || o->picture_fov_rad.given ||
                  o->picture_aim_rad.given || o->picture_place;

    if (!o->show)
        return wished ? "--as, --frame-rate and the options --picture-... need --show; allowed: "
                        "together with it"
                      : NULL;
    if (!o->show_as)
        return "--show needs --as; allowed: --as domemaster, equirectangular or cube";
    if (o->model || o->scene_given)
        return "--show contradicts --scene and a MODEL; allowed: one of them";
    if (o->mode == SHOW_PERSPECTIVE || o->mode == SHOW_VIEWS)
        return "--show contradicts --perspective and --views-only: a picture has no views; "
               "allowed: the dome's image, or --preview";
    if (o->picture_fov_rad.given && o->show_as != CUPOLA_SOURCE_DOMEMASTER)
        return "--picture-fov belongs to --as domemaster only";
    if (o->frame_rate.given && !file_pattern_has_number(o->show))
        return "--frame-rate belongs to a sequence only; allowed: --show with %04d or the like in "
               "the name";
    if (o->views_given)
        return "--layout, --views, --goal, --density, --view-size, --guard, --head-radius, "
               "--eye-circle, --osc, --view-format, --msaa, --depth, --mask and --submission "
               "belong "
               "to views, and --show has none; allowed: without them";
    if (o->flat || o->camera.given || o->look.given || o->up.given)
        return "--flat, --camera, --look and --up belong to a scene, and --show has none; allowed: "
               "--picture-aim turns a picture";
    return NULL;
}

/* The same of options about scenes. */
static const char *scene_contradiction(const struct options *o)
{
    if (o->model && o->scene_given)
        return "--scene and a MODEL contradict each other; allowed: one of them";
    if (o->flat && o->shading >= 0)
        return "--flat and --shading contradict each other; allowed: one of them";
    if (o->shading >= 0 && (o->show || options_scene_is_numbers(o)))
        return "--shading needs surfaces; allowed: with a MODEL, --scene cube or --scene forest";
    if ((o->triangles > 0 || o->seed >= 0) && o->scene != SCENE_FOREST)
        return "--triangles and --seed belong to --scene forest only";
    return NULL;
}

/* The same of options about the plan and its views. */
static const char *plan_contradiction(const struct options *o)
{
    if (o->mode == SHOW_PERSPECTIVE && o->plan_given)
        return "--layout, --views, --goal, --density, --view-size, --guard, --mask and "
               "--submission belong to the dome's views, and --perspective has none; allowed: "
               "without them";
    if (o->lookahead_ms.given && !o->osc)
        return "--viewer-lookahead needs --osc; allowed: together with it";
    if (!o->head_radius_m.given && !o->eye_circle_m.given && !o->osc)
        return NULL;
    if (o->mode == SHOW_PERSPECTIVE)
        return "--head-radius, --eye-circle and --osc belong to the dome's views, and "
               "--perspective has none; allowed: without them";
    if (o->osc && o->eye_circle_m.given)
        return "--osc and --eye-circle both move the eye; allowed: one of them";
    if (o->head_radius_m.given && o->eye_circle_m.given &&
        o->eye_circle_m.value[0] > o->head_radius_m.value[0])
        return "--eye-circle leaves the sphere of --head-radius; allowed: up to that radius";
    return NULL;
}

/* Options that only a drawing has use for. */
static bool wishes_drawing(const struct options *o)
{
    bool window_wish = o->fullscreen || o->monitor >= 0 || o->swap_interval >= 0;
    bool scene_wish = o->model || o->scene_given || o->show || o->flat || o->shading >= 0 ||
                      o->camera.given || o->look.given || o->up.given;

    return scene_wish || window_wish || o->mark_count > 0 || o->frames > 0 || o->stats ||
           o->eye_circle_m.given || o->osc;
}

/* The same of what is told without drawing. */
static const char *survey_contradiction(const struct options *o)
{
    bool map = o->mode == SHOW_MAP;
    bool both = o->report && o->stats && !strcmp(o->report, "-") && !strcmp(o->stats, "-");

    if (map && !o->output)
        return "--map needs --output; allowed: FILE.png, or FILE.pfm for the numbers";
    if (map && wishes_drawing(o))
        return "--map draws no scene; allowed: the rig's options, --show-output, --output, "
               "--save-rig, --headless and --report";
    if (map && o->table_given)
        return "--table belongs to the warp, and --map has none; allowed: without it";
    if (map && o->views_given && !o->report)
        return "--layout, --views, --density and the like belong to views, and --map has none; "
               "allowed: together with --report";
    if (!o->report)
        return NULL;
    if (o->show || o->mode == SHOW_PERSPECTIVE)
        return "--report is about the dome's views, and --show and --perspective have none; "
               "allowed: without them";
    if (o->goal_auto)
        return "--report contradicts --goal auto, which times a scene's views; allowed: --goal "
               "fill or vertices";
    if (both)
        return "--report and --stats both go to stdout; allowed: one of them";
    if (!map && !o->output && !o->headless && (wishes_drawing(o) || o->mode != SHOW_DOME))
        return "--report alone draws nothing; allowed: with --output or --headless, or without "
               "options about what is drawn";
    return NULL;
}

/* The same of options about pictures of many frames. */
static const char *reference_contradiction(const struct options *o)
{
    if (!o->reference)
        return NULL;
    if (o->mode != SHOW_DOME)
        return "--reference belongs to the dome's image; allowed: without --perspective, "
               "--views-only, --preview and --map";
    if (o->report && !o->output && !o->headless)
        return "--report alone draws nothing; allowed together with --reference: with --output or "
               "--headless";
    if (o->osc)
        return "--reference and --osc contradict each other: a mean of frames wants an eye that "
               "rests; allowed: one of them";
    if (o->stats)
        return "--reference and --stats contradict each other; allowed: one of them";
    if (o->goal_auto)
        return "--reference contradicts --goal auto, which may choose another plan when it goes "
               "on; allowed: --goal fill or vertices";
    if (o->table != CUPOLA_TABLE_TILES && o->table != CUPOLA_TABLE_NONE)
        return "--reference moves every pixel's ray from frame to frame, so that no table can hold "
               "it; allowed: --table tiles (which holds no rays) or none";
    if (o->dither_bits)
        return "--reference and --dither contradict each other: noise is for single frames, and a "
               "mean would take it in; allowed: one of them";
    if (o->plan.guard_px == 1)
        return "--reference moves what is sampled of a view; allowed: --guard 2 or more";
    if (o->frames > 0 && !(o->output && file_pattern_has_number(o->output)))
        return "--reference and --frames are for many pictures together; allowed: with --output "
               "and %05d or the like in the name";
    return NULL;
}

/* The same of all options. */
const char *options_contradiction(const struct options *o)
{
    bool window_wish = o->fullscreen || o->monitor >= 0 || o->swap_interval >= 0;
    const char *problem = scene_contradiction(o);

    if (!problem)
        problem = plan_contradiction(o);
    if (!problem)
        problem = filter_options_contradiction(o);
    if (!problem)
        problem = survey_contradiction(o);
    if (!problem)
        problem = reference_contradiction(o);
    if (problem)
        return problem;
    if (o->plan.density > 0 && o->plan.view_size_px > 0)
        return "--density and --view-size contradict each other; allowed: one of them";
    if (o->lens >= 0 && o->lens != CUPOLA_LENS_POLYNOMIAL && o->lens_k.given)
        return "--lens-k belongs to --lens polynomial only";
    if (o->lens >= 0 && o->lens != CUPOLA_LENS_TABLE && o->lens_table)
        return "--lens-table belongs to --lens table only";
    if (o->mark_count > 0 && (o->mode == SHOW_PERSPECTIVE || o->mode == SHOW_VIEWS))
        return "--label and --cursor contradict --perspective and --views-only; allowed: the "
               "dome's image, or --preview";
    if (o->lens_k.given && o->lens_table)
        return "--lens-k and --lens-table contradict each other; allowed: one of them";
    if (window_wish && (o->headless || o->output || o->reference))
        return "--monitor, --fullscreen and --swap-interval need a window; allowed: not together "
               "with --headless, --output or --reference";
    return picture_contradiction(o);
}
