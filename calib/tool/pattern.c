/* Test patterns: their programs, and what those are told. */
#include "tool/pattern.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <epoxy/gl.h>

#include "angles.h"
#include "calib_shaders.h"
#include "program.h"
#include "rotation.h"

struct patterns {
    GLuint programs[PATTERN_COUNT]; /* 0: not needed so far */
    GLuint cross;
    GLuint vertex_array; /* empty: core profiles want one */
};

static const char *const lights[PATTERN_COUNT] = {
    [PATTERN_GRID] = shader_grid_glsl,       [PATTERN_MERIDIANS] = shader_meridians_glsl,
    [PATTERN_CIRCLES] = shader_circles_glsl, [PATTERN_CHECKER] = shader_checker_glsl,
    [PATTERN_WEDGES] = shader_wedges_glsl,   [PATTERN_RAMPS] = shader_ramps_glsl,
    [PATTERN_RIM] = shader_rim_glsl,         [PATTERN_DOT] = shader_dot_glsl,
};

void pattern_frame(const struct tool *tool, const struct cupola_rig *rig,
                   struct pattern_frame *frame)
{
    *frame = (struct pattern_frame){.to_pattern = {1, 0, 0, 0, 1, 0, 0, 0, 1}};
    if (tool->pattern == PATTERN_RIM || (tool->pattern != PATTERN_DOT && tool->about == ABOUT_DOME))
        return;
    frame->about_viewer = true;
    rotation_from_tilt(rig->tilt_rad, frame->to_pattern);
    memcpy(frame->origin_m, rig->eye_m, sizeof frame->origin_m);
}

double pattern_star_spacing_rad(const struct cupola_rig *rig)
{
    /* The outermost stars, of 7.2 degrees, lie within the screen. */
    return fmax(fmin(rig->screen.cap_rad, 90 * rad_per_deg) - 8 * rad_per_deg, 24 * rad_per_deg) /
           3;
}

void pattern_dot(const struct tool *tool, double direction[3])
{
    direction[0] = -cos(tool->dot_pitch_rad) * sin(tool->dot_yaw_rad);
    direction[1] = sin(tool->dot_pitch_rad);
    direction[2] = -cos(tool->dot_pitch_rad) * cos(tool->dot_yaw_rad);
}

struct patterns *patterns_create(char *message)
{
    struct patterns *patterns = calloc(1, sizeof *patterns);

    if (!patterns) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return NULL;
    }
    glGenVertexArrays(1, &patterns->vertex_array);
    patterns->cross =
        program_create("cross-hair", shader_stage_vert, shader_cross_frag, message, MESSAGE_SIZE);
    if (patterns->cross)
        return patterns;
    patterns_destroy(patterns);
    return NULL;
}

void patterns_destroy(struct patterns *patterns)
{
    if (!patterns)
        return;
    for (int i = 0; i < PATTERN_COUNT; i++)
        glDeleteProgram(patterns->programs[i]);
    glDeleteProgram(patterns->cross);
    glDeleteVertexArrays(1, &patterns->vertex_array);
    free(patterns);
}

/* 0 with one line in `message`. */
static GLuint program_of(struct patterns *patterns, enum pattern pattern, char *message)
{
    GLuint *program = &patterns->programs[pattern];
    size_t size = strlen(shader_pattern_glsl) + strlen(lights[pattern]) + 1;
    char *text;

    if (*program)
        return *program;
    text = malloc(size);
    if (!text) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return 0;
    }
    snprintf(text, size, "%s%s", shader_pattern_glsl, lights[pattern]);
    *program =
        program_create(tool_pattern_name(pattern), shader_stage_vert, text, message, MESSAGE_SIZE);
    free(text);
    return *program;
}

static GLint place(GLuint program, const char *name)
{
    return glGetUniformLocation(program, name);
}

/* Those that a pattern does not have are not found and ignored. */
static void set_uniforms(GLuint program, const struct tool *tool, const struct cupola_rig *rig)
{
    const struct cupola_output *output = &rig->outputs[tool->output];
    const struct cupola_circle *circle = &output->circle;
    struct pattern_frame frame;
    double dot[3];
    float rows[9];

    pattern_frame(tool, rig, &frame);
    pattern_dot(tool, dot);
    for (int i = 0; i < 9; i++)
        rows[i] = (float)frame.to_pattern[i];
    glUniformMatrix3fv(place(program, "to_pattern"), 1, GL_TRUE, rows);
    glUniform3f(place(program, "origin_m"), (float)frame.origin_m[0], (float)frame.origin_m[1],
                (float)frame.origin_m[2]);
    glUniform1i(place(program, "about_viewer"), frame.about_viewer);
    glUniform1f(place(program, "spacing_rad"), (float)pattern_star_spacing_rad(rig));
    glUniform3f(place(program, "circle_px"), (float)circle->center_x_px, (float)circle->center_y_px,
                (float)circle->radius_px);
    glUniform2f(place(program, "size_px"), (float)output->width_px, (float)output->height_px);
    glUniform1f(place(program, "cap_rad"), (float)rig->screen.cap_rad);
    glUniform3f(place(program, "dot_axis"), (float)dot[0], (float)dot[1], (float)dot[2]);
    glUniform1f(place(program, "dot_rad"), (float)(0.5 * tool->dot_size_rad));
}

static void draw(const struct patterns *patterns, GLuint points)
{
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, points);
    glBindVertexArray(patterns->vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glBindTexture(GL_TEXTURE_2D, 0);
    glUseProgram(0);
}

bool patterns_draw(struct patterns *patterns, const struct tool *tool, const struct cupola_rig *rig,
                   unsigned int points, char *message)
{
    GLuint program = program_of(patterns, tool->pattern, message);

    if (!program)
        return false;
    glUseProgram(program);
    set_uniforms(program, tool, rig);
    draw(patterns, points);
    return true;
}

double pattern_cross_arm_px(const struct cupola_output *output)
{
    return fmax(16, fmin(output->width_px, output->height_px) / 24.0);
}

void patterns_draw_cross(struct patterns *patterns, const struct tool *tool,
                         const struct cupola_rig *rig, unsigned int points)
{
    const struct cupola_output *output = &rig->outputs[tool->output];
    double arm_px = pattern_cross_arm_px(output);
    int reach = (int)arm_px + 3;

    if (!(fabs(tool->cross_px[0]) < 1e6 && fabs(tool->cross_px[1]) < 1e6))
        return;
    glEnable(GL_SCISSOR_TEST);
    glScissor((int)tool->cross_px[0] - reach, (int)tool->cross_px[1] - reach, 2 * reach, 2 * reach);
    glUseProgram(patterns->cross);
    glUniform2f(place(patterns->cross, "cross_px"), (float)tool->cross_px[0],
                (float)tool->cross_px[1]);
    glUniform1f(place(patterns->cross, "arm_px"), (float)arm_px);
    draw(patterns, points);
    glDisable(GL_SCISSOR_TEST);
}
