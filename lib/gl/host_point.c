/* Saving and restoring of what drawing points changes. */
#include "host_point.h"

void host_point_set(const struct host_features *features)
{
    if (!features->es)
        glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 1);
    if (!features->compatibility)
        return;
    glDisable(GL_POINT_SMOOTH);
    glEnable(GL_POINT_SPRITE);
}

void host_point_save(struct host_point *point, const struct host_features *features)
{
    *point = (struct host_point){.fade_threshold_px = 0};
    if (!features->es)
        glGetFloatv(GL_POINT_FADE_THRESHOLD_SIZE, &point->fade_threshold_px);
    if (features->compatibility) {
        point->smooth = glIsEnabled(GL_POINT_SMOOTH);
        point->sprite = glIsEnabled(GL_POINT_SPRITE);
    }
    host_point_set(features);
}

void host_point_restore(const struct host_point *point, const struct host_features *features)
{
    if (!features->es)
        glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, point->fade_threshold_px);
    if (!features->compatibility)
        return;
    host_set_capability(GL_POINT_SMOOTH, point->smooth);
    host_set_capability(GL_POINT_SPRITE, point->sprite);
}
