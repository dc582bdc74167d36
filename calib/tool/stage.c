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
#include "tool/panel_draw.h"
#include "tool/pattern.h"
#include "tool/pattern_labels.h"
#include "tool/preview.h"

static const double RADIANS = 3.14159265358979323846 / 180;

struct stage {
    struct cupola_rig rig;       /* as it is shown */
    struct cupola_rig table_rig; /* of the point table; its eye does not count */
    cupola_points *points;       /* NULL: nothing was drawn so far */
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

/* The point table does not depend on the eye. */
static bool update_points(struct stage *stage, int output, char *message)
{
    struct cupola_rig rig = stage->rig;
    struct cupola_error error = {0};
    cupola_dome *dome = NULL;
    int status;

    memset(rig.eye_m, 0, sizeof rig.eye_m);
    if (stage->points && memcmp(&rig, &stage->table_rig, sizeof rig) == 0)
        return true;
    status = cupola_dome_create(&rig, &dome, &error);
    if (status >= 0)
        status = stage->points ? cupola_points_set_dome(stage->points, dome, output, &error)
                               : cupola_points_create(dome, output, &stage->points, &error);
    cupola_dome_destroy(&dome);
    if (status >= 0)
        memcpy(&stage->table_rig, &rig, sizeof rig);
    else
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
    return status >= 0;
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

/* In the middle of the image circle. */
static double radians_per_px(const struct stage *stage, int output)
{
    const struct cupola_output *made = &stage->rig.outputs[output];
    const double near = 0.01;

    return cupola_lens_angle(&made->lens, near) / (near * made->circle.radius_px);
}

/* Nine pixels high, but neither tiny nor huge on the dome. */
static double label_unit_rad(const struct stage *stage, int output)
{
    return fmin(fmax(9 * radians_per_px(stage, output), 1.2 * RADIANS), 4 * RADIANS) / 7;
}

static void draw_labels(struct stage *stage, const struct tool *tool)
{
    pattern_labels_list(tool, &stage->rig, label_unit_rad(stage, tool->output), &stage->labels);
    for (int i = 0; i < stage->labels.count; i++)
        dome_text_draw(stage->text, &stage->rig, tool->output, cupola_points_texture(stage->points),
                       &stage->labels.list[i]);
}

/* The name of the mark that is being steered to, beside the cross-hair. */
static void draw_cross_name(struct stage *stage, const struct tool *tool)
{
    struct dome_label label = {.ink = {1, 0.75f, 0.1f}, .ground = 0.8f};
    cupola_dome *dome = NULL;
    struct cupola_ray ray;

    if (tool->mark < 0 || tool->mark >= tool->marks.count ||
        cupola_dome_create(&stage->rig, &dome, NULL) < 0)
        return;
    if (cupola_dome_ray(dome, tool->output, NULL, tool->cross_px[0], tool->cross_px[1], &ray) >=
        0) {
        label.text = tool->marks.list[tool->mark].name;
        label.unit_rad = label_unit_rad(stage, tool->output);
        memcpy(label.direction, ray.direction, sizeof label.direction);
        dome_label_anchor(&label, 1, 1);
        dome_text_draw(stage->text, &stage->rig, tool->output, cupola_points_texture(stage->points),
                       &label);
    }
    cupola_dome_destroy(&dome);
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
        panels_draw_on_dome(stage->text, tool, &stage->rig, points,
                            radians_per_px(stage, tool->output));
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

bool stage_pixel(const struct tool *tool, int width, int height, double x, double y,
                 double pixel_px[2])
{
    const struct cupola_output *output = &tool->rig.outputs[tool->output];
    int place[4];
    double at[2];

    place_image(tool, width, height, place);
    at[0] = (x - place[0]) / place[2];
    at[1] = (height - y - place[1]) / place[3];
    pixel_px[0] = at[0] * output->width_px;
    pixel_px[1] = at[1] * output->height_px;
    return at[0] >= 0 && at[0] <= 1 && at[1] >= 0 && at[1] <= 1;
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

    tool_shown_rig(tool, &stage->rig);
    if (!update_points(stage, tool->output, message) ||
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
