/* The point table of a theatre without views: one texture, filled as often as the host likes. */
#include <stdlib.h>

#include "cupola/points.h"
#include "error.h"
#include "geometry/dome.h"
#include "gl_objects.h"
#include "program.h"
#include "table_gl.h"

/* A texture of an output's size, and what is drawn into where this GL can draw into floats. */
struct point_table {
    GLuint texture, framebuffer;
    int width_px, height_px;
};

struct cupola_points {
    struct host_features features;
    struct guest guest; /* of the context with these features */
    GLuint vertex_array;
    /* By the lens' model, and by whether the screen has a cap; 0 until one is needed. */
    GLuint programs[CUPOLA_LENS_TABLE + 1][2];
    struct point_table table;
};

static void table_discard(struct point_table *table)
{
    glDeleteFramebuffers(1, &table->framebuffer);
    glDeleteTextures(1, &table->texture);
}

static int table_make(const struct guest *guest, const struct cupola_output *size,
                      struct point_table *table, struct cupola_error *error)
{
    struct point_table made = {.width_px = size->width_px, .height_px = size->height_px};
    made.texture = texture_create(GL_RGBA32F, made.width_px, made.height_px, GL_NEAREST, error);
    if (!made.texture)
        return error->status;
    guest_name(guest, GL_TEXTURE, made.texture, "points, %d x %d px", made.width_px,
               made.height_px);
    if (guest->features->float_targets) {
        made.framebuffer = framebuffer_create(made.texture, "a table of floats", error);
        if (!made.framebuffer) {
            glDeleteTextures(1, &made.texture);
            return error->status;
        }
        guest_name(guest, GL_FRAMEBUFFER, made.framebuffer, "points");
    }
    *table = made;
    return CUPOLA_OK;
}

/* 0 on failure. */
static GLuint program_for(cupola_points *points, const cupola_dome *dome, int output,
                          struct cupola_error *error)
{
    const struct projector *projector = &dome->projectors[output];
    GLuint *program = &points->programs[projector->lens.model][projector->capped];
    if (*program)
        return *program;
    *program = table_program_create(dome, output, 1, CUPOLA_TABLE_POINTS, error);
    if (*program)
        guest_name(&points->guest, GL_PROGRAM, *program, "points");
    return *program;
}

/* All of it, or nothing on failure. */
static int fill(cupola_points *points, const cupola_dome *dome, int output,
                const struct point_table *table, struct cupola_error *error)
{
    if (!points->features.float_targets) {
        glBindTexture(GL_TEXTURE_2D, table->texture);
        return table_fill_by_cpu(dome, NULL, output, CUPOLA_TABLE_POINTS, error);
    }
    GLuint program = program_for(points, dome, output, error);
    if (!program)
        return error->status;
    glUseProgram(program);
    program_set_projector(program, dome, output);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, table->framebuffer);
    host_set_area(&points->features, 0, 0, table->width_px, table->height_px);
    draw_fullscreen(points->vertex_array);
    return CUPOLA_OK;
}

/* With the host's state saved. A texture of another size takes the old one's place once it is full.
 */
static int follow(cupola_points *points, const cupola_dome *dome, int output,
                  struct cupola_error *error)
{
    const struct cupola_output *size = &dome->rig.outputs[output];
    struct point_table table = points->table;
    bool fits =
        table.texture && table.width_px == size->width_px && table.height_px == size->height_px;
    int status = fits ? CUPOLA_OK : table_make(&points->guest, size, &table, error);
    if (status != CUPOLA_OK)
        return status;
    status = fill(points, dome, output, &table, error);
    if (!fits)
        table_discard(status == CUPOLA_OK ? &points->table : &table);
    if (status == CUPOLA_OK)
        points->table = table;
    return status;
}

static void destroy_objects(cupola_points *points)
{
    table_discard(&points->table);
    for (int model = 0; model <= CUPOLA_LENS_TABLE; model++)
        for (int capped = 0; capped < 2; capped++)
            glDeleteProgram(points->programs[model][capped]);
    glDeleteVertexArrays(1, &points->vertex_array);
}

static int create_objects(cupola_points *points, const cupola_dome *dome, int output,
                          struct cupola_error *error)
{
    points->vertex_array = vertex_array_create(&points->guest, "full screen", error);
    int status = points->vertex_array ? follow(points, dome, output, error) : (int)error->status;
    if (status != CUPOLA_OK)
        destroy_objects(points);
    return status;
}

/* `create`: the objects are made first, all of them or none. */
static int work(cupola_points *points, const cupola_dome *dome, int output, bool create,
                struct cupola_error *error)
{
    struct guest_work work;
    int status = guest_check(&points->guest, error);
    if (status != CUPOLA_OK)
        return status;
    guest_begin_making(&points->guest, &work, "points of output %d", output);
    status =
        create ? create_objects(points, dome, output, error) : follow(points, dome, output, error);
    if (status != CUPOLA_OK)
        gl_errors_drop();
    guest_end(&points->guest, &work);
    return guest_reason(&points->guest, status, error);
}

static int check_output(const cupola_dome *dome, int output, struct cupola_error *error)
{
    if (!dome)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "dome is NULL");
    if (output < 0 || output >= dome->rig.output_count)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "output is %d; allowed: 0 to %d", output,
                         dome->rig.output_count - 1);
    return CUPOLA_OK;
}

int cupola_points_create(const cupola_dome *dome, int output, cupola_points **points,
                         struct cupola_error *error)
{
    struct cupola_error unwanted;
    error = error ? error : &unwanted;
    int status = check_output(dome, output, error);
    if (status != CUPOLA_OK)
        return status;
    if (!points)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "points is NULL");
    status = context_check(error);
    if (status != CUPOLA_OK)
        return status;
    cupola_points *made = calloc(1, sizeof *made);
    if (!made)
        return error_set(error, CUPOLA_ERROR_MEMORY, "no memory for a point table (%zu bytes)",
                         sizeof *made);
    host_features_find(&made->features);
    made->guest.features = &made->features;
    status = work(made, dome, output, true, error);
    if (status != CUPOLA_OK) {
        free(made);
        return status;
    }
    *points = made;
    return CUPOLA_OK;
}

int cupola_points_set_dome(cupola_points *points, const cupola_dome *dome, int output,
                           struct cupola_error *error)
{
    struct cupola_error unwanted;
    error = error ? error : &unwanted;
    if (!points)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "points is NULL");
    int status = guest_check_seen(&points->guest, error);
    if (status == CUPOLA_OK)
        status = check_output(dome, output, error);
    return status == CUPOLA_OK ? work(points, dome, output, false, error) : status;
}

unsigned int cupola_points_texture(const cupola_points *points)
{
    return points ? points->table.texture : 0;
}

void cupola_points_destroy(cupola_points **points)
{
    if (!points || !*points)
        return;
    if (guest_check(&(*points)->guest, NULL) == CUPOLA_OK)
        destroy_objects(*points);
    free(*points);
    *points = NULL;
}
