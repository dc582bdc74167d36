/* A frame of the tool: the projector's image, the theatre beside it, and text. */
#include "tool/stage.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <epoxy/gl.h>

#include <cupola/dome.h>
#include <cupola/points.h>

#include "calib_shaders.h"
#include "overlay.h"
#include "program.h"
#include "tool/dome_text.h"
#include "tool/marks_walk.h"
#include "tool/panel_draw.h"
#include "tool/pattern.h"
#include "tool/pattern_labels.h"
#include "tool/preview.h"

struct stage {
    struct cupola_rig rig;       /* as it is shown */
    cupola_dome *dome;           /* of it; NULL: nothing was drawn so far */
    struct cupola_rig table_rig; /* of the point table; its eye does not count */
    int table_output;
    cupola_points *points; /* NULL: nothing was drawn so far */
    struct target image;
    struct patterns *patterns;
    struct dome_text *text;
    struct overlay *overlay;
    struct preview_room *preview;
    GLuint show;         /* puts the image into a window */
    GLuint vertex_array; /* empty: core profiles want one */
    struct pattern_labels labels;
};

struct stage *stage_create(char *message)
{
    struct stage *stage = calloc(1, sizeof *stage);

    if (!stage) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return NULL;
    }
    glGenVertexArrays(1, &stage->vertex_array);
    stage->patterns = patterns_create(message);
    stage->text = stage->patterns ? dome_text_create(message) : NULL;
    stage->overlay = stage->text ? overlay_create(message, MESSAGE_SIZE) : NULL;
    stage->preview = stage->overlay ? preview_create(message) : NULL;
    stage->show = stage->preview ? program_create("image", shader_stage_vert, shader_show_frag,
                                                  message, MESSAGE_SIZE)
                                 : 0;
    if (stage->show)
        return stage;
    stage_destroy(stage);
    return NULL;
}

void stage_destroy(struct stage *stage)
{
    if (!stage)
        return;
    cupola_points_destroy(&stage->points);
    cupola_dome_destroy(&stage->dome);
    if (stage->image.framebuffer)
        target_destroy(&stage->image);
    patterns_destroy(stage->patterns);
    dome_text_destroy(stage->text);
    overlay_destroy(stage->overlay);
    preview_destroy(stage->preview);
    glDeleteProgram(stage->show);
    glDeleteVertexArrays(1, &stage->vertex_array);
    free(stage);
}

const struct target *stage_image(const struct stage *stage)
{
    return &stage->image;
}

static bool update_dome(struct stage *stage, const struct tool *tool, char *message)
{
    struct cupola_error error = {0};
    cupola_dome *dome = NULL;
    struct cupola_rig rig;

    tool_shown_rig(tool, &rig);
    if (stage->dome && memcmp(&rig, &stage->rig, sizeof rig) == 0)
        return true;
    if (cupola_dome_create(&rig, &dome, &error) < 0) {
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
        return false;
    }
    cupola_dome_destroy(&stage->dome);
    stage->dome = dome;
    memcpy(&stage->rig, &rig, sizeof rig);
    return true;
}

/* The point table does not depend on the eye. */
static bool update_points(struct stage *stage, int output, char *message)
{
    struct cupola_rig rig = stage->rig;
    struct cupola_error error = {0};
    int status;

    memset(rig.eye_m, 0, sizeof rig.eye_m);
    if (stage->points && output == stage->table_output &&
        memcmp(&rig, &stage->table_rig, sizeof rig) == 0)
        return true;
    status = stage->points ? cupola_points_set_dome(stage->points, stage->dome, output, &error)
                           : cupola_points_create(stage->dome, output, &stage->points, &error);
    if (status < 0) {
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
        return false;
    }
    memcpy(&stage->table_rig, &rig, sizeof rig);
    stage->table_output = output;
    return true;
}

static bool update_image(struct stage *stage, int output, char *message)
{
    const struct cupola_output *size = &stage->rig.outputs[output];
    struct target made;

    if (stage->image.framebuffer && stage->image.width == size->width_px &&
        stage->image.height == size->height_px)
        return true;
    if (!target_create(&made, size->width_px, size->height_px, TARGET_SRGB, message, MESSAGE_SIZE))
        return false;
    if (stage->image.framebuffer)
        target_destroy(&stage->image);
    stage->image = made;
    return true;
}

static void draw_labels(struct stage *stage, const struct tool *tool)
{
    pattern_labels_list(tool, stage->dome, &stage->labels);
    for (int i = 0; i < stage->labels.count; i++)
        dome_text_draw(stage->text, &stage->rig, tool->output, cupola_points_texture(stage->points),
                       &stage->labels.list[i]);
}

/* The name of the mark that is being steered to, beside the cross-hair. */
static void draw_cross_name(struct stage *stage, const struct tool *tool)
{
    struct dome_label label = {.ink = {1, 0.75f, 0.1f}, .ground = 0.8f};
    char name[MARK_NAME_MAX + 1];
    struct cupola_ray ray;

    if (tool->mark < 0 || tool->mark >= tool->marks.count ||
        cupola_dome_ray(stage->dome, tool->output, NULL, tool->cross_px[0], tool->cross_px[1],
                        &ray) < 0)
        return;
    marks_walk_label(tool, tool->mark, name);
    label.text = name;
    label.unit_rad = pattern_label_unit_rad(stage->dome, tool->output, ray.direction);
    memcpy(label.direction, ray.direction, sizeof label.direction);
    dome_label_anchor(&label, 1, 1);
    dome_text_draw(stage->text, &stage->rig, tool->output, cupola_points_texture(stage->points),
                   &label);
}

/* The projector's image. Patterns are written as numbers; what lies over them is mixed as light. */
static bool draw_image(struct stage *stage, const struct tool *tool, char *message)
{
    unsigned int points = cupola_points_texture(stage->points);
    bool drawn;

    glBindFramebuffer(GL_FRAMEBUFFER, stage->image.framebuffer);
    glViewport(0, 0, stage->image.width, stage->image.height);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glDisable(GL_FRAMEBUFFER_SRGB);
    drawn = patterns_draw(stage->patterns, tool, &stage->rig, points, message);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    if (tool->shows_labels)
        draw_labels(stage, tool);
    if (tool->group == GROUP_MARKS) {
        patterns_draw_cross(stage->patterns, tool, &stage->rig, points);
        draw_cross_name(stage, tool);
    }
    if (tool->text_on_dome)
        panels_draw_on_dome(stage->text, tool, stage->dome, points);
    glDisable(GL_BLEND);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return drawn;
}

/* The image as large as it fits, in the left half beside a preview; from the bottom left. */
static void place_image(const struct tool *tool, int width, int height, int place[4])
{
    const struct cupola_output *output = &tool->rig.outputs[tool->output];
    double room = tool->preview == PREVIEW_NONE ? width : width / 2;
    double scale = fmin(room / output->width_px, (double)height / output->height_px);

    place[2] = (int)fmax(1, floor(scale * output->width_px + 0.5));
    place[3] = (int)fmax(1, floor(scale * output->height_px + 0.5));
    place[0] = ((int)room - place[2]) / 2;
    place[1] = (height - place[3]) / 2;
}

void stage_pixel(const struct tool *tool, int width, int height, double x, double y,
                 double pixel_px[2])
{
    const struct cupola_output *output = &tool->rig.outputs[tool->output];
    int place[4];

    place_image(tool, width, height, place);
    pixel_px[0] = (x - place[0]) / place[2] * output->width_px;
    pixel_px[1] = (height - y - place[1]) / place[3] * output->height_px;
}

static void show_image(struct stage *stage, unsigned int framebuffer, const int place[4])
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(place[0], place[1], place[2], place[3]);
    glUseProgram(stage->show);
    glUniform4f(glGetUniformLocation(stage->show, "place_px"), (float)place[0], (float)place[1],
                (float)place[2], (float)place[3]);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, stage->image.texture);
    glBindVertexArray(stage->vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glBindTexture(GL_TEXTURE_2D, 0);
    glUseProgram(0);
}

bool stage_draw(struct stage *stage, const struct tool *tool, unsigned int framebuffer, int width,
                int height, char *message)
{
    int place[4], theatre[4] = {width / 2, 0, width - width / 2, height};

    if (!update_dome(stage, tool, message) || !update_points(stage, tool->output, message) ||
        !update_image(stage, tool->output, message) || !draw_image(stage, tool, message))
        return false;
    if (width < 1 || height < 1)
        return true;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    place_image(tool, width, height, place);
    show_image(stage, framebuffer, place);
    if (tool->preview != PREVIEW_NONE && theatre[0] > 0 &&
        !preview_draw(stage->preview, tool, stage->image.texture, framebuffer, theatre, message))
        return false;
    if (!tool->text_on_dome)
        panels_draw(stage->overlay, tool, framebuffer, width, height);
    return true;
}
