/* What is the same for every kind of scene. */
#include "scene.h"

double scene_distance(const struct scene *scene, const double place[3])
{
    return scene->distance ? scene->distance(scene, place) : 0;
}
