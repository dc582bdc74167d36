/* Options of cupola-demo that contradict each other. */
#include "option_check.h"

#include <stddef.h>

#include "file_pattern.h"

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
               "--eye-circle, --view-format, --msaa, --depth, --mask and --submission belong to "
               "views, and --show has none; allowed: without them";
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
    if (!o->head_radius_m.given && !o->eye_circle_m.given)
        return NULL;
    if (o->mode == SHOW_PERSPECTIVE)
        return "--head-radius and --eye-circle belong to the dome's views, and --perspective has "
               "none; allowed: without them";
    if (o->head_radius_m.given && o->eye_circle_m.given &&
        o->eye_circle_m.value[0] > o->head_radius_m.value[0])
        return "--eye-circle leaves the sphere of --head-radius; allowed: up to that radius";
    return NULL;
}

/* The same of all options. */
const char *options_contradiction(const struct options *o)
{
    bool window_wish = o->fullscreen || o->monitor >= 0 || o->swap_interval >= 0;
    const char *problem = scene_contradiction(o);

    if (!problem)
        problem = plan_contradiction(o);
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
    if (window_wish && (o->headless || o->output))
        return "--monitor, --fullscreen and --swap-interval need a window; allowed: not together "
               "with --headless or --output";
    return picture_contradiction(o);
}
