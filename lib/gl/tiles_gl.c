/*
 * Tiles in the GL: their buffers, their programs and how they are drawn: as points, a vertex each,
 * which costs a software rasteriser a fifth of what two triangles do. A point whose middle is
 * beyond the viewport is not drawn, so the viewport is of whole tiles, and the scissor rectangle
 * cuts it.
 */
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "constants.h"
#include "error.h"
#include "filter_gl.h"
#include "geometry/vector.h"
#include "geometry/views.h"
#include "gl_objects.h"
#include "host_buffer.h"
#include "instance.h"
#include "program.h"
#include "shaders.h"

static const char *const kind_names[TILE_KINDS] = {"pure", "pair", "choosing", "exact", "dark"};

/*
 * From the host's camera frame to a view, homogeneous: its first two rows by its third are the
 * place in the view's base rectangle, or in the atlas.
 */
static void view_matrix(const cupola_plan *plan, const struct cupola_view *view, bool atlas,
                        double matrix[9])
{
    double base[4], share[4];
    view_base(view, base);
    view_share(view, &plan->report, share);
    for (int k = 0; k < 3; k++) {
        double depth = -view->rotation[6 + k];
        for (int i = 0; i < 2; i++) {
            double place = (view->rotation[3 * i + k] - base[i] * depth) / base[2 + i];
            matrix[3 * i + k] = atlas ? share[i] * depth + share[2 + i] * place : place;
        }
        matrix[6 + k] = depth;
    }
}

/* From the dome frame to places in a view, homogeneous. */
static void dome_to_view(const cupola_gl *gl, int view, double matrix[9])
{
    double rows[9];
    view_matrix(&gl->plan, &gl->plan.views[view], gl->params.storage == CUPOLA_STORAGE_ATLAS, rows);
    multiply3(rows, gl->plan.dome.tilt, matrix);
}

/* What a pair has besides: see shaders/tile.frag. */
static void set_pair(const cupola_gl *gl, struct tile *tile)
{
    int own = (int)tile->view, other = (int)tile->other;
    double from[9], to[9], back[9], across[9], apart[3], lead[3];
    dome_to_view(gl, own, from);
    dome_to_view(gl, other, to);
    invert3(from, back);
    multiply3(to, back, across);
    for (int i = 0; i < 3; i++)
        apart[i] = gl->plan.views[other].selector[i] - gl->plan.views[own].selector[i];
    transform3_back(gl->plan.dome.tilt, apart, lead);
    transform3_back(back, lead, apart);
    for (int i = 0; i < 9; i++)
        tile->across[i] = (float)across[3 * (i % 3) + i / 3];
    for (int i = 0; i < 3; i++)
        tile->lead[i] = (float)apart[i];
}

static void set_pairs(const cupola_gl *gl, struct tiles *tiles)
{
    for (int i = 0; i < tiles->count[TILE_PAIR]; i++)
        set_pair(gl, &tiles->tiles[TILE_PAIR][i]);
}

static bool has_terms(int kind)
{
    return kind <= TILE_CHOOSING;
}

/* Of the vertex array that is bound: one tile for each vertex. */
static void set_attributes(GLuint buffer, int kind)
{
    enum { ACROSS = TILE_TERMS + 1, LEAD = ACROSS + 3 };
    GLuint last = kind == TILE_PAIR ? LEAD : has_terms(kind) ? TILE_TERMS : 0;
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    for (GLuint i = 0; i <= last; i++) {
        size_t at = !i           ? 0
                    : i < ACROSS ? offsetof(struct tile, terms) + (i - 1) * 3 * sizeof(float)
                    : i < LEAD   ? offsetof(struct tile, across) + (i - ACROSS) * 3 * sizeof(float)
                                 : offsetof(struct tile, lead);
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, !i || i == LEAD ? 4 : 3, GL_FLOAT, GL_FALSE, sizeof(struct tile),
                              (const void *)at);
    }
}

static int create_kind(const cupola_gl *gl, int output, int kind, struct tile_pass *pass,
                       struct cupola_error *error)
{
    const struct tiles *tiles = &pass->tiles;
    glGenBuffers(1, &pass->buffers[kind]);
    if (!pass->buffers[kind])
        return gl_refused(glGetError(), error, "a buffer of tiles");
    pass->arrays[kind] = vertex_array_create(&gl->guest, "tiles", error);
    if (!pass->arrays[kind])
        return error->status;
    set_attributes(pass->buffers[kind], kind);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(sizeof(struct tile) * (size_t)tiles->most[kind]),
                 NULL, has_terms(kind) ? GL_DYNAMIC_DRAW : GL_STATIC_DRAW);
    glBufferSubData(GL_ARRAY_BUFFER, 0,
                    (GLsizeiptr)(sizeof(struct tile) * (size_t)tiles->count[kind]),
                    tiles->tiles[kind]);
    GLenum failure = glGetError();
    if (failure != GL_NO_ERROR)
        return gl_refused(failure, error, "a buffer of %d %s tiles", tiles->most[kind],
                          kind_names[kind]);
    guest_name(&gl->guest, GL_BUFFER, pass->buffers[kind], "%s tiles of output %d",
               kind_names[kind], output);
    return CUPOLA_OK;
}

/* The largest tile that can be drawn as a point; 0 if there is none. */
static int largest_point_px(const struct host_features *features)
{
    GLfloat range[2] = {0, 0};
    int side_px = TILE_MOST_PX;
    glGetFloatv(features->es || features->compatibility ? GL_ALIASED_POINT_SIZE_RANGE
                                                        : GL_POINT_SIZE_RANGE,
                range);
    while (side_px >= TILE_LEAST_PX && !((GLfloat)side_px <= range[1]))
        side_px /= 2;
    return side_px >= TILE_LEAST_PX ? side_px : 0;
}

int tile_pass_create(const cupola_gl *gl, int output, struct tile_pass *pass,
                     struct cupola_error *error)
{
    struct host_buffer host;
    int most_px = largest_point_px(&gl->features);
    double reach_px = jitter_reach_px(gl) + filter_reach_px(&gl->params.filter);
    if (!most_px)
        return error_set(error, CUPOLA_ERROR_GL,
                         "this GL draws no points of %d px, which the table stage tiles needs; "
                         "allowed: the other stages",
                         TILE_LEAST_PX);
    int status = tiles_create(&gl->plan, output, most_px, reach_px, &pass->tiles, error);
    if (status != CUPOLA_OK)
        return status;
    set_pairs(gl, &pass->tiles);
    gl_errors_drop();
    host_buffer_save(&host);
    for (int kind = 0; status == CUPOLA_OK && kind < TILE_KINDS; kind++)
        if (pass->tiles.most[kind])
            status = create_kind(gl, output, kind, pass, error);
    host_buffer_restore(&host);
    return status;
}

void tile_pass_forget(struct tile_pass *pass)
{
    tiles_destroy(&pass->tiles);
}

void tile_pass_destroy(struct tile_pass *pass)
{
    glDeleteVertexArrays(TILE_KINDS, pass->arrays);
    glDeleteBuffers(TILE_KINDS, pass->buffers);
    tiles_destroy(&pass->tiles);
    *pass = (struct tile_pass){.buffers = {0}};
}

/* From the dome frame to each view, of a program that is in use. */
static void place_views(GLint location, const cupola_gl *gl)
{
    GLfloat matrices[9 * CUPOLA_VIEWS_MAX];
    for (int v = 0; v < gl->plan.view_count; v++) {
        double matrix[9];
        dome_to_view(gl, v, matrix);
        for (int i = 0; i < 9; i++)
            matrices[9 * v + i] = (GLfloat)matrix[i];
    }
    glUniformMatrix3fv(location, gl->plan.view_count, GL_TRUE, matrices);
}

GLuint tile_program_create(const cupola_gl *gl, int output, int kind, const char *lines,
                           struct cupola_error *error)
{
    static const struct shader_file vertex = {"tile.vert", shader_tile_vert};
    const struct shader_file other[] = {
        {"varying.glsl", shader_varying_glsl}, {"views.glsl", shader_views_glsl},
        {"images.glsl", shader_images_glsl},   {"light.glsl", shader_light_glsl},
        {"places", gl->filter_places},         {"filter.glsl", shader_filter_glsl},
        {"tile.frag", shader_tile_frag},
    };
    char defines[PROGRAM_DEFINES_MAX + WARP_LINES_MAX + TILE_LINES_MAX + CONSTANTS_MAX];
    char tile_lines[TILE_LINES_MAX];
    program_defines(&gl->plan.dome, output, gl->plan.view_count, CUPOLA_TABLE_NONE, defines);
    strcat(defines, lines);
    snprintf(tile_lines, sizeof tile_lines,
             "#define TILE_PURE %d\n#define TILE_PAIR %d\n#define TILE_CHOOSING %d\n"
             "#define TILE_EXACT %d\n#define TILE_DARK %d\n#define TILE_KIND %d\n"
             "#define RIM %d\n#define CORNER (GAIN || DITHERED || TURNED)\n%s",
             TILE_PURE, TILE_PAIR, TILE_CHOOSING, TILE_EXACT, TILE_DARK, kind, kind == TILE_EXACT,
             kind == TILE_DARK ? "#undef RAYS\n#define RAYS 0\n" : "");
    strcat(defines, tile_lines);
    if (constants_write(gl, output, defines + strlen(defines), error) != CUPOLA_OK)
        return 0;
    const struct tiles *tiles = &gl->passes[output].tiles.tiles;
    const double viewport[2] = {tiles->width_px, tiles->height_px};
    GLuint program = kind == TILE_EXACT
                         ? warp_program_compile(gl, vertex.name, vertex.text, defines, error)
                         : program_create_by(&vertex, defines, other, 7, error);
    if (!program)
        return 0;
    glUseProgram(program);
    program_set_projector(program, &gl->plan.dome, output);
    program_set_views(program, &gl->plan);
    program_set_vector(program, "viewport_size", viewport, 2);
    place_views(glGetUniformLocation(program, "tile_view"), gl);
    warp_set_units(gl, program);
    guest_name(&gl->guest, GL_PROGRAM, program, "warp of %s tiles of output %d", kind_names[kind],
               output);
    return program;
}

void tile_draw(const struct tile_pass *pass, int kind)
{
    glBindVertexArray(pass->arrays[kind]);
    glDrawArrays(GL_POINTS, 0, pass->tiles.count[kind]);
}

void tile_pass_refit(cupola_gl *gl, int output)
{
    struct warp_pass *warp = &gl->passes[output];
    struct tile_pass *pass = &warp->tiles;
    struct host_buffer host;
    bool kept = !gl->guest.leaves_state;
    tiles_refit(&gl->plan, &pass->tiles);
    set_pairs(gl, &pass->tiles);
    if (kept)
        host_buffer_save(&host);
    for (int kind = TILE_PURE; kind <= TILE_CHOOSING; kind++) {
        const struct tiles *tiles = &pass->tiles;
        if (!tiles->most[kind])
            continue;
        glBindBuffer(GL_ARRAY_BUFFER, pass->buffers[kind]);
        glBufferSubData(GL_ARRAY_BUFFER, 0,
                        (GLsizeiptr)(sizeof(struct tile) * (size_t)tiles->count[kind]),
                        tiles->tiles[kind]);
    }
    if (kept)
        host_buffer_restore(&host);
    for (int gained = 0; gained < 2; gained++)
        for (int kind = TILE_PURE; kind <= TILE_EXACT; kind++) {
            const struct warp_program *program = &warp->programs[gained][SOURCE_KINDS + kind];
            if (!program->program)
                continue;
            glUseProgram(program->program);
            program_place_eye(program->eye, &gl->plan.dome);
            program_place_bases(program->bases, &gl->plan);
            place_views(program->tile_views, gl);
        }
}
