/* What a new cupola_gl tells the host's log about itself. */
#include <stdio.h>
#include <string.h>

#include "cupola/source.h"
#include "instance.h"

enum { LINE_MAX_CHARS = 400 };

static void describe_views(const cupola_gl *gl, char line[LINE_MAX_CHARS])
{
    const struct cupola_plan_report *report = &gl->plan.report;
    if (!shows_source(gl, CUPOLA_SOURCE_VIEWS))
        snprintf(line, LINE_MAX_CHARS, "no views");
    else if (gl->params.storage != CUPOLA_STORAGE_ATLAS)
        snprintf(line, LINE_MAX_CHARS, "%d views in %s of the host's, table %s",
                 gl->plan.view_count,
                 gl->params.storage == CUPOLA_STORAGE_LAYERS ? "layers" : "textures",
                 cupola_table_name((int)gl->params.table));
    else
        snprintf(line, LINE_MAX_CHARS, "%d views in %d x %d px %s, depth %s, samples %d, table %s",
                 gl->plan.view_count, report->atlas_width_px, report->atlas_height_px,
                 views_format_name(gl), views_depth_name(gl),
                 gl->sample_count > 1 ? gl->sample_count : 1,
                 cupola_table_name((int)gl->params.table));
}

static void describe_pictures(const cupola_gl *gl, char line[LINE_MAX_CHARS])
{
    line[0] = 0;
    for (int kind = CUPOLA_SOURCE_DOMEMASTER; kind < SOURCE_KINDS; kind++) {
        size_t length = strlen(line);
        if (shows_source(gl, (enum cupola_source_kind)kind))
            snprintf(line + length, LINE_MAX_CHARS - length, ", %s", cupola_source_name(kind));
    }
}

static void tell_features(const cupola_gl *gl)
{
    const struct host_features *f = &gl->features;
    const struct {
        bool used;
        const char *name;
    } features[] = {
        {f->viewport_array, "viewport arrays"},
        {gl->pass_buffer != 0, "all views in one pass"},
        {f->clip_control, "clip control"},
        {f->mask_per_buffer, "a colour mask for each draw buffer"},
        {f->blend_per_buffer, "blending for each draw buffer"},
        {f->transform_feedback, "transform feedback that can be paused"},
        {f->float_targets, "targets of floats"},
        {f->float_filter, "filtered floats"},
        {f->debug != HOST_DEBUG_NONE, "debug groups and labels"},
        {f->reset != HOST_RESET_NEVER, "notice of a lost context"},
    };
    char line[LINE_MAX_CHARS] = "";
    for (size_t i = 0; i < sizeof features / sizeof features[0]; i++) {
        size_t length = strlen(line);
        if (features[i].used)
            snprintf(line + length, sizeof line - length, "%s%s", length ? ", " : "",
                     features[i].name);
    }
    guest_tell(&gl->guest, CUPOLA_LOG_DEBUG, CUPOLA_LOG_FEATURES, "of the GL is used: %s",
               line[0] ? line : "the floor alone");
}

static const char *gl_string(GLenum name)
{
    const char *text = (const char *)glGetString(name);
    return text ? text : "unknown";
}

void instance_tell_created(const cupola_gl *gl)
{
    char views[LINE_MAX_CHARS], pictures[LINE_MAX_CHARS];
    if (!gl->params.log.write)
        return;
    describe_views(gl, views);
    describe_pictures(gl, pictures);
    guest_tell(&gl->guest, CUPOLA_LOG_INFO, CUPOLA_LOG_CREATED,
               "a cupola_gl was made: %d outputs, %s%s; %s, %s", gl->plan.dome.rig.output_count,
               views, pictures, gl_string(GL_RENDERER), gl_string(GL_VERSION));
    tell_features(gl);
}
