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
#include "tool/focus.h"
#include "tool/panel_draw.h"
#include "tool/pattern.h"
#include "tool/pattern_labels.h"
#include "tool/preview.h"

/* What one projector throws. */
struct throw
{
    cupola_points *points;       /* NULL: nothing was drawn so far */
    struct cupola_rig table_rig; /* of the points: what they depend on, all else 0 */
    struct target image;
};

struct stage {
    struct cupola_rig rig; /* as it is shown */
    cupola_dome *dome;     /* of it; NULL: nothing was drawn so far */
    struct throw throws[CUPOLA_OUTPUTS_MAX];
    int output; /* that is set up, in the last frame */
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
    for (int i = 0; i < CUPOLA_OUTPUTS_MAX; i++) {
        cupola_points_destroy(&stage->throws[i].points);
        target_destroy(&stage->throws[i].image);
    }
    cupola_dome_destroy(&stage->dome);
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
    return &stage->throws[stage->output].image;
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

/* The point table does not depend on the eye, nor on other projectors. */
static bool update_points(struct stage *stage, int output, char *message)
{
    struct throw *throw = &stage->throws[output];
    struct cupola_rig rig;
    struct cupola_error error = {0};
    int status;

    memset(&rig, 0, sizeof rig);
    rig.screen = stage->rig.screen;
    rig.tilt_rad = stage->rig.tilt_rad;
    memcpy(&rig.outputs[output], &stage->rig.outputs[output], sizeof *rig.outputs);
    if (throw->points && memcmp(&rig, &throw->table_rig, sizeof rig) == 0)
        return true;
    status = throw->points ? cupola_points_set_dome(throw->points, stage->dome, output, &error)
                           : cupola_points_create(stage->dome, output, &throw->points, &error);
    if (status < 0) {
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
        return false;
    }
    memcpy(&throw->table_rig, &rig, sizeof rig);
    return true;
}

static bool update_image(struct stage *stage, int output, char *message)
{
    const struct cupola_output *size = &stage->rig.outputs[output];
    struct target *image = &stage->throws[output].image, made;

    if (image->framebuffer && image->width == size->width_px && image->height == size->height_px)
        return true;
    if (!target_create(&made, size->width_px, size->height_px, TARGET_SRGB, message, MESSAGE_SIZE))
        return false;
    target_destroy(image);
    *image = made;
    return true;
}

static unsigned int points_of(const struct stage *stage, const struct tool *tool)
{
    return cupola_points_texture(stage->throws[tool->output].points);
}

static void draw_labels(struct stage *stage, const struct tool *tool)
{
    pattern_labels_list(tool, stage->dome, &stage->labels);
    for (int i = 0; i < stage->labels.count; i++)
        dome_text_draw(stage->text, &stage->rig, tool->output, points_of(stage, tool),
                       &stage->labels.list[i]);
}

/* The name of the mark that is being steered to, beside the cross-hair. */
static void draw_cross_name(struct stage *stage, const struct tool *tool)
{
    char name[MARK_NAME_MAX + 1];
    struct dome_label label;

    if (focus_cross_label(tool, stage->dome, name, &label))
        dome_text_draw(stage->text, &stage->rig, tool->output, points_of(stage, tool), &label);
}

/*
 * The image of the tool's projector. Patterns are written as numbers; what lies over them is mixed
 * as light.
 */
static bool draw_image(struct stage *stage, const struct tool *tool, char *message)
{
    const struct target *image = &stage->throws[tool->output].image;
    unsigned int points;
    bool drawn;

    if (!update_points(stage, tool->output, message) || !update_image(stage, tool->output, message))
        return false;
    points = points_of(stage, tool);
    glBindFramebuffer(GL_FRAMEBUFFER, image->framebuffer);
    glViewport(0, 0, image->width, image->height);
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
    if (tool->text_on_dome)
        panels_draw_on_dome(stage->text, tool, stage->dome, points);
    /* Over them: they do not move, and it is what is steered. */
    if (tool->group == GROUP_MARKS) {
        patterns_draw_cross(stage->patterns, tool, &stage->rig, points);
        draw_cross_name(stage, tool);
    }
    glDisable(GL_BLEND);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return drawn;
}

/* What the other projectors throw: pattern and labels, and nothing of what is being done. */
static bool draw_others(struct stage *stage, const struct tool *tool,
                        unsigned int images[CUPOLA_OUTPUTS_MAX], char *message)
{
    struct tool other = *tool;

    other.text_on_dome = false;
    if (other.group == GROUP_MARKS)
        other.group = GROUP_POSITION;
    for (int i = 0; i < tool->rig.output_count && i < tool->theatre.output_count; i++) {
        other.output = i;
        if (i != tool->output && !draw_image(stage, &other, message))
            return false;
        images[i] = stage->throws[i].image.texture;
    }
    return true;
}

static bool draw_preview(struct stage *stage, const struct tool *tool, unsigned int framebuffer,
                         const int place[4], char *message)
{
    unsigned int images[CUPOLA_OUTPUTS_MAX] = {0};

    return draw_others(stage, tool, images, message) &&
           preview_draw(stage->preview, tool, images, framebuffer, place, message);
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
    glBindTexture(GL_TEXTURE_2D, stage_image(stage)->texture);
    glBindVertexArray(stage->vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glBindTexture(GL_TEXTURE_2D, 0);
    glUseProgram(0);
}

static void draw_panels(struct stage *stage, const struct tool *tool, unsigned int framebuffer,
                        int width, int height)
{
    const struct cupola_output *output = &tool->rig.outputs[tool->output];
    struct panel_clear clear;
    struct focus focus;
    int place[4];

    focus_find(tool, stage->dome, &stage->labels, &focus);
    place_image(tool, width, height, place);
    clear.count = focus.count;
    for (int i = 0; i < focus.count; i++) {
        const struct focus_box *box = &focus.list[i];
        double across = (double)place[2] / output->width_px;
        double up = (double)place[3] / output->height_px;
        clear.list[i] = (struct panel_box){
            place[0] + across * box->low_px[0], height - place[1] - up * box->high_px[1],
            across * (box->high_px[0] - box->low_px[0]), up * (box->high_px[1] - box->low_px[1])};
    }
    panels_draw(stage->overlay, tool, framebuffer, width, height, &clear);
}

bool stage_draw(struct stage *stage, const struct tool *tool, unsigned int framebuffer, int width,
                int height, char *message)
{
    int place[4], theatre[4] = {width / 2, 0, width - width / 2, height};

    if (!update_dome(stage, tool, message) || !draw_image(stage, tool, message))
        return false;
    stage->output = tool->output;
    if (width < 1 || height < 1)
        return true;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    place_image(tool, width, height, place);
    show_image(stage, framebuffer, place);
    if (tool->preview != PREVIEW_NONE && theatre[0] > 0 &&
        !draw_preview(stage, tool, framebuffer, theatre, message))
        return false;
    if (!tool->text_on_dome)
        draw_panels(stage, tool, framebuffer, width, height);
    return true;
}
