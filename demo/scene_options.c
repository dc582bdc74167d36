/* From options to what a scene is made with. */
#include "options.h"

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
