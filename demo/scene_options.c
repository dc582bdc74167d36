/* From options to what a scene is made with. */
#include "scene_options.h"

#include "option_list.h"

enum { SEED_MAX = 1000000 };

/* In the order of enum scene_kind. */
static const char *scene_name(int index)
{
    static const char *const names[] = {"cube", "directions", "screen", "forest"};
    return index >= 0 && index < 4 ? names[index] : NULL;
}

/* In the order of enum scene_shading. */
static const char *shading_name(int index)
{
    static const char *const names[] = {"flat", "lambert", "heavy"};
    return index >= 0 && index < 3 ? names[index] : NULL;
}

bool scene_options_take(const struct value_context *context, int code, const char *text,
                        struct options *options)
{
    int index;

    switch (code) {
    case OPTION_SCENE:
        if (!value_name(context, text, scene_name, &index))
            return false;
        options->scene = (enum scene_kind)index;
        options->scene_given = true;
        return true;
    case OPTION_FLAT:
        return options->flat = true;
    case OPTION_SHADING:
        return value_name(context, text, shading_name, &options->shading);
    case OPTION_TRIANGLES:
        return value_integer(context, text, SCENE_TRIANGLES_MIN, SCENE_TRIANGLES_MAX,
                             &options->triangles);
    default:
        return value_integer(context, text, 0, SEED_MAX, &options->seed);
    }
}

struct scene_wishes options_scene_wishes(const struct options *options)
{
    struct scene_wishes wishes = {.shading = SCENE_LAMBERT, .triangles = options->triangles};

    if (options->flat)
        wishes.shading = SCENE_FLAT;
    if (options->shading >= 0)
        wishes.shading = (enum scene_shading)options->shading;
    if (options->seed >= 0)
        wishes.seed = (unsigned int)options->seed;
    return wishes;
}

bool options_scene_is_numbers(const struct options *options)
{
    return !options->model &&
           (options->scene == SCENE_DIRECTIONS || options->scene == SCENE_SCREEN);
}
