/*
 * Whole faces of a cube, as others draw domes: four of them turned by 45 degrees so that they reach
 * 180 degrees, or all six; sampled as a cube map, along rays by trigonometry in the shader or along
 * those of a mesh of 50 x 50 squares. Built from public descriptions; faces are sized to no loss.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <epoxy/gl.h>

#include "bench_shaders.h"
#include "contender.h"
#include "cube_faces.h"
#include "program.h"

enum { MESH_SQUARES = 50 /* along a side */ };

struct cube_frames {
    const struct setting *setting;
    double axes[9]; /* the cube's, as rows, in the camera's frame */
    unsigned int drawn;
    struct cube_faces faces;
    GLuint program;
    GLuint vertex_array;
    GLuint vertices;
    int vertex_count;
};

static void cube_release(void *self)
{
    struct cube_frames *cube = self;

    if (!cube)
        return;
    cube_faces_destroy(&cube->faces);
    glDeleteProgram(cube->program);
    glDeleteVertexArrays(1, &cube->vertex_array);
    glDeleteBuffers(1, &cube->vertices);
    free(cube);
}

struct corner {
    float place[2]; /* clip coordinates */
    float direction[3];
};

/* Beyond the rim the direction goes on as far as the lens can. */
static struct corner corner_at(const struct setting *setting, int i, int j)
{
    double x = 2.0 * i / MESH_SQUARES - 1, y = 2.0 * j / MESH_SQUARES - 1;
    double radius = sqrt(x * x + y * y), half = setting->fov_rad / 2, angle, turn = atan2(y, x);

    if (setting->lens == CUPOLA_LENS_ANGULAR)
        angle = fmin(half * radius, 3.1);
    else
        angle = asin(fmin(radius * sin(half), 1));
    return (struct corner){
        {(float)x, (float)y},
        {(float)(sin(angle) * cos(turn)), (float)(sin(angle) * sin(turn)), (float)-cos(angle)}};
}

static void make_mesh(struct cube_frames *cube)
{
    static const int order[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
    static struct corner corners[MESH_SQUARES * MESH_SQUARES * 6];
    struct corner *corner = corners;

    for (int j = 0; j < MESH_SQUARES; j++)
        for (int i = 0; i < MESH_SQUARES; i++)
            for (int c = 0; c < 6; c++)
                *corner++ = corner_at(cube->setting, i + order[c][0], j + order[c][1]);
    cube->vertex_count = (int)(corner - corners);
    glGenBuffers(1, &cube->vertices);
    glBindVertexArray(cube->vertex_array);
    glBindBuffer(GL_ARRAY_BUFFER, cube->vertices);
    glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof *corner, NULL);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof *corner,
                          (const void *)offsetof(struct corner, direction));
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

static void set_uniforms(const struct cube_frames *cube)
{
    float axes[9];

    for (int i = 0; i < 9; i++)
        axes[i] = (float)cube->axes[i];
    glUseProgram(cube->program);
    glUniformMatrix3fv(glGetUniformLocation(cube->program, "cube_from_camera"), 1, GL_TRUE, axes);
    glUniform1f(glGetUniformLocation(cube->program, "half_fov"),
                (float)(cube->setting->fov_rad / 2));
    glUniform1i(glGetUniformLocation(cube->program, "hemispheric"),
                cube->setting->lens == CUPOLA_LENS_HEMISPHERIC);
    glUseProgram(0);
}

static bool make(struct cube_frames *cube, int variant, char *message)
{
    bool mesh = variant == CUBE_6_MESH;

    cube->program = program_create("cube", mesh ? shader_mesh_cube_vert : shader_whole_vert,
                                   mesh ? shader_mesh_cube_frag : shader_trigonometry_frag, message,
                                   MESSAGE_SIZE);
    if (!cube->program)
        return false;
    glGenVertexArrays(1, &cube->vertex_array);
    cube->vertex_count = 3;
    if (mesh)
        make_mesh(cube);
    set_uniforms(cube);
    return cube_faces_create(&cube->faces, cube_faces_no_loss_px(cube->setting, cube->axes),
                             message);
}

static void *cube_prepare(const struct setting *setting, int variant, char *message)
{
    static const double straight[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const double s = sqrt(0.5), turned[9] = {s, 0, -s, 0, 1, 0, s, 0, s};
    bool four = variant == CUBE_4_TRIGONOMETRY;
    struct cube_frames *cube;

    if (setting->off_axis || (four && setting->fov_rad > 3.1416)) {
        snprintf(message, MESSAGE_SIZE, "%s",
                 setting->off_axis ? "knows no eye off the axis" : "reaches 180 degrees at most");
        return NULL;
    }
    cube = calloc(1, sizeof *cube);
    if (!cube) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return NULL;
    }
    cube->setting = setting;
    /* Four: the two that meet in front, +X and -Z, and those above and below. */
    cube->drawn = four ? 1u << 0 | 1u << 5 | 1u << 2 | 1u << 3 : 0x3f;
    for (int i = 0; i < 9; i++)
        cube->axes[i] = four ? turned[i] : straight[i];
    if (make(cube, variant, message))
        return cube;
    cube_release(cube);
    return NULL;
}

static bool cube_views(void *self)
{
    const struct cube_frames *cube = self;

    cube_faces_draw(&cube->faces, cube->setting, cube->axes, cube->drawn);
    return true;
}

static bool cube_warp(void *self)
{
    const struct cube_frames *cube = self;

    glBindFramebuffer(GL_FRAMEBUFFER, cube->setting->target.framebuffer);
    glViewport(0, 0, cube->setting->size_px, cube->setting->size_px);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glUseProgram(cube->program);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_CUBE_MAP, cube->faces.texture);
    glBindVertexArray(cube->vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, cube->vertex_count);
    glBindVertexArray(0);
    glBindTexture(GL_TEXTURE_CUBE_MAP, 0);
    glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    return true;
}

static void cube_facts(const void *self, struct contender_facts *facts)
{
    const struct cube_frames *cube = self;
    int count = cube->drawn == 0x3f ? 6 : 4;
    double face = (double)cube->faces.size_px * cube->faces.size_px;

    *facts = (struct contender_facts){.shows = SHOWS_DOME, .views = count, .texels = count * face};
    facts->bytes = 4 * (count + 1) * face; /* one depth buffer serves all */
    snprintf(facts->note, sizeof facts->note, "faces of %d px", cube->faces.size_px);
}

const struct contender_kind contender_cube = {.prepare = cube_prepare,
                                              .views = cube_views,
                                              .warp = cube_warp,
                                              .facts = cube_facts,
                                              .release = cube_release};
