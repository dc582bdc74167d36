/* Saving and restoring of what drawing points changes. */
#include "host_point.h"

void host_point_set(void)
{
    if (epoxy_is_desktop_gl())
        glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 1);
}

void host_point_save(struct host_point *point)
{
    point->fade_threshold_px = 0;
    if (epoxy_is_desktop_gl())
        glGetFloatv(GL_POINT_FADE_THRESHOLD_SIZE, &point->fade_threshold_px);
    host_point_set();
}

void host_point_restore(const struct host_point *point)
{
    if (epoxy_is_desktop_gl())
        glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, point->fade_threshold_px);
}
