/* The warp: its programs and its draws. */
#include <stdio.h>
#include <string.h>

#include "constants.h"
#include "error.h"
#include "filter_gl.h"
#include "gl_objects.h"
#include "host_cube.h"
#include "host_point.h"
#include "instance.h"
#include "program.h"
#include "shaders.h"
#include "target_color.h"
#include "target_gl.h"

void warp_set_units(const cupola_gl *gl, GLuint program)
{
    GLint units[CUPOLA_VIEWS_MAX];
    for (int i = 0; i < CUPOLA_VIEWS_MAX; i++)
        units[i] = view_image_unit(i);
    glUniform1i(glGetUniformLocation(program, "atlas"), UNIT_IMAGE);
    glUniform1i(glGetUniformLocation(program, "table"), UNIT_TABLE);
    if (gl->params.storage != CUPOLA_STORAGE_ATLAS)
        glUniform1iv(glGetUniformLocation(program, "images"),
                     gl->params.storage == CUPOLA_STORAGE_LAYERS ? 1 : gl->plan.view_count, units);
}

GLuint warp_program_compile(const cupola_gl *gl, const char *vertex_name, const char *vertex_text,
                            const char *defines, struct cupola_error *error)
{
    const struct shader_file vertex = {vertex_name, vertex_text};
    const struct shader_file files[] = {
        {"varying.glsl", shader_varying_glsl}, {"lens.glsl", shader_lens_glsl},
        {"points.glsl", shader_points_glsl},   {"views.glsl", shader_views_glsl},
        {"images.glsl", shader_images_glsl},   {"light.glsl", shader_light_glsl},
        {"jitter.glsl", shader_jitter_glsl},   {"places", gl->filter_places},
        {"filter.glsl", shader_filter_glsl},   {"warp.frag", shader_warp_frag},
    };
    return program_create_by(&vertex, defines, files, 10, error);
}

static GLuint views_program_create(const cupola_gl *gl, int output, const char *lines,
                                   struct cupola_error *error)
{
    char defines[PROGRAM_DEFINES_MAX + WARP_LINES_MAX + CONSTANTS_MAX];
    program_defines(&gl->plan.dome, output, gl->plan.view_count, (int)gl->passes[output].stage,
                    defines);
    strcat(defines, lines);
    strcat(defines, "#define RIM 1\n");
    if (constants_write(gl, output, defines + strlen(defines), error) != CUPOLA_OK)
        return 0;
    GLuint program =
        warp_program_compile(gl, "fullscreen.vert", shader_fullscreen_vert, defines, error);
    if (!program)
        return 0;
    glUseProgram(program);
    program_set_projector(program, &gl->plan.dome, output);
    program_set_views(program, &gl->plan);
    warp_set_units(gl, program);
    return program;
}

void light_lines(enum cupola_encoding encoding, bool asked, bool gained, bool dithered,
                 char lines[WARP_LINES_MAX])
{
    enum { LINEAR, SRGB, ASKED };
    int way = encoding == CUPOLA_ENCODING_LINEAR ? LINEAR : asked ? ASKED : SRGB;
    snprintf(lines, WARP_LINES_MAX,
             "#define GAIN %d\n#define ENCODING_SRGB %d\n#define ENCODING_ASKED %d\n"
             "#define ENCODING %d\n#define DITHERED %d\n",
             gained, SRGB, ASKED, way, dithered);
}

void warp_lines(const cupola_gl *gl, bool gained, char lines[WARP_LINES_MAX])
{
    light_lines(gl->params.encoding, gl->features.srgb_always, gained, gl->params.dither_bits > 0,
                lines);
    filter_lines(&gl->params, lines + strlen(lines));
    size_t length = strlen(lines);
    snprintf(lines + length, WARP_LINES_MAX - length,
             "#define STORAGE_ATLAS %d\n#define STORAGE_TEXTURES %d\n#define STORAGE_LAYERS %d\n"
             "#define STORAGE %d\n#define JITTERS %d\n",
             CUPOLA_STORAGE_ATLAS, CUPOLA_STORAGE_TEXTURES, CUPOLA_STORAGE_LAYERS,
             (int)gl->params.storage, gl->params.jitters);
}

static int warp_program_create(const cupola_gl *gl, int output, int kind, bool gained,
                               struct warp_program *made, struct cupola_error *error)
{
    char lines[WARP_LINES_MAX];
    warp_lines(gl, gained, lines);
    GLuint program =
        kind >= SOURCE_KINDS ? tile_program_create(gl, output, kind - SOURCE_KINDS, lines, error)
        : kind == CUPOLA_SOURCE_VIEWS ? views_program_create(gl, output, lines, error)
                                      : source_program_create(gl, output, kind, lines, error);
    if (!program)
        return error->status;
    if (kind < SOURCE_KINDS)
        guest_name(&gl->guest, GL_PROGRAM, program, "warp of %s to output %d%s",
                   cupola_source_name(kind), output, gained ? ", with gain" : "");
    glUniform4fv(glGetUniformLocation(program, "border"), 1, gl->params.border);
    glUniform1i(glGetUniformLocation(program, "gain"), gain_unit(gl));
    *made = (struct warp_program){
        .program = program,
        .target_corner = glGetUniformLocation(program, "target_corner"),
        .encoded = glGetUniformLocation(program, "encoded"),
        .ray_jitter = glGetUniformLocation(program, "ray_jitter"),
        .eye = glGetUniformLocation(program, "eye"),
        .bases = glGetUniformLocation(program, "view_base"),
        .tile_views = glGetUniformLocation(program, "tile_view"),
        .rotation = glGetUniformLocation(program, "source_rotation"),
        .center = glGetUniformLocation(program, "source_center"),
        .half_fov = glGetUniformLocation(program, "source_half_fov"),
        .mipmaps = glGetUniformLocation(program, "source_mipmaps"),
        .image_rect = glGetUniformLocation(program, "image_rect"),
        .image_layer = glGetUniformLocation(program, "image_layer"),
    };
    return CUPOLA_OK;
}

void warp_programs_destroy(struct warp_program programs[WARP_PROGRAMS])
{
    for (int kind = 0; kind < WARP_PROGRAMS; kind++) {
        glDeleteProgram(programs[kind].program);
        programs[kind] = (struct warp_program){0};
    }
}

/* Whether a program shows views: they have one, or one for each kind of tiles. */
static bool is_of_views(const cupola_gl *gl, int output, int kind)
{
    bool tiles = gl->passes[output].stage == CUPOLA_TABLE_TILES;
    return tiles ? kind >= SOURCE_KINDS : kind == CUPOLA_SOURCE_VIEWS;
}

static bool needs_program(const cupola_gl *gl, int output, int kind)
{
    if (kind == CUPOLA_SOURCE_VIEWS || kind >= SOURCE_KINDS)
        return shows_source(gl, CUPOLA_SOURCE_VIEWS) && is_of_views(gl, output, kind);
    return shows_source(gl, (enum cupola_source_kind)kind);
}

/* The programs that a pass does not have yet, of views alone or of all that was asked for. */
static int programs_complete(const cupola_gl *gl, int output, bool gained, bool views_alone,
                             struct warp_program made[WARP_PROGRAMS], struct cupola_error *error)
{
    for (int kind = 0; kind < WARP_PROGRAMS; kind++) {
        bool wished = !views_alone || is_of_views(gl, output, kind);
        int status = CUPOLA_OK;
        if (wished && !made[kind].program && needs_program(gl, output, kind))
            status = warp_program_create(gl, output, kind, gained, &made[kind], error);
        if (status != CUPOLA_OK) {
            warp_programs_destroy(made);
            return status;
        }
    }
    return CUPOLA_OK;
}

int warp_programs_create(const cupola_gl *gl, int output, bool gained,
                         struct warp_program made[WARP_PROGRAMS], struct cupola_error *error)
{
    return programs_complete(gl, output, gained, false, made, error);
}

int warp_views_create(cupola_gl *gl, int output, struct cupola_error *error)
{
    struct warp_pass *pass = &gl->passes[output];
    if (pass->stage == CUPOLA_TABLE_TILES) {
        if (tile_pass_create(gl, output, &pass->tiles, error) != CUPOLA_OK)
            return error->status;
    } else if (pass->stage != CUPOLA_TABLE_NONE) {
        pass->table = table_create(gl, output, pass->stage, &pass->redraw, error);
        if (!pass->table)
            return error->status;
        if (pass->stage == CUPOLA_TABLE_POINTS)
            pass->points = pass->table;
    }
    return programs_complete(gl, output, false, true, pass->programs[false], error);
}

/* A table has one ray for each pixel. */
static enum cupola_table stage_of(const cupola_gl *gl)
{
    enum cupola_table wished = gl->params.table;
    bool tabled = wished != CUPOLA_TABLE_TILES && wished != CUPOLA_TABLE_AUTO;
    return tabled && filter_sends_rays(&gl->params.filter) ? CUPOLA_TABLE_NONE : wished;
}

int warp_pass_create(cupola_gl *gl, int output, struct cupola_error *error)
{
    struct warp_pass *pass = &gl->passes[output];
    int status = CUPOLA_OK;
    pass->stage = stage_of(gl);
    if (shows_source(gl, CUPOLA_SOURCE_VIEWS))
        status = pass->stage == CUPOLA_TABLE_AUTO ? table_choose(gl, output, error)
                                                  : warp_views_create(gl, output, error);
    if (status == CUPOLA_OK)
        status = warp_programs_create(gl, output, false, pass->programs[false], error);
    if (status == CUPOLA_OK)
        status = overlay_program_create(gl, output, false, &pass->overlays[false], error);
    return status;
}

void warp_pass_destroy(struct warp_pass *pass)
{
    for (int gained = 0; gained < 2; gained++) {
        warp_programs_destroy(pass->programs[gained]);
        overlay_program_destroy(&pass->overlays[gained]);
    }
    tile_pass_destroy(&pass->tiles);
    table_pass_destroy(&pass->redraw);
    density_pass_destroy(&pass->density);
    glDeleteTextures(1, &pass->table);
    if (pass->points != pass->table)
        glDeleteTextures(1, &pass->points);
    *pass = (struct warp_pass){0};
}

int output_check(cupola_gl *gl, int output, struct cupola_error *error)
{
    if (!gl)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "gl is NULL");
    if (guest_check_seen(&gl->guest, error) != CUPOLA_OK)
        return CUPOLA_ERROR_LOST;
    if (open_kind(gl))
        return error_set(error, CUPOLA_ERROR_ORDER, "a %s is open; end it first", open_kind(gl));
    if (output < 0 || output >= gl->plan.dome.rig.output_count)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "output is %d; allowed: 0 to %d", output,
                         gl->plan.dome.rig.output_count - 1);
    return guest_check(&gl->guest, error);
}

static void views_bind(const cupola_gl *gl, int output)
{
    glActiveTexture(GL_TEXTURE0 + UNIT_TABLE);
    glBindTexture(GL_TEXTURE_2D, gl->passes[output].table);
    if (gl->params.storage != CUPOLA_STORAGE_ATLAS) {
        view_images_bind(gl);
        return;
    }
    glActiveTexture(GL_TEXTURE0 + UNIT_IMAGE);
    glBindTexture(GL_TEXTURE_2D, gl->atlas);
}

static void program_begin(const cupola_gl *gl, const struct warp_program *program,
                          const struct cupola_target *place)
{
    glUseProgram(program->program);
    glUniform2f(program->target_corner, (GLfloat)place->x, (GLfloat)place->y);
    if (program->encoded >= 0)
        glUniform1i(program->encoded, !target_encodes(&gl->features));
    if (program->ray_jitter >= 0)
        glUniform2f(program->ray_jitter, (GLfloat)gl->jitter.pixels[0],
                    (GLfloat)gl->jitter.pixels[1]);
}

static void draw_tiles(const cupola_gl *gl, const struct warp_pass *pass,
                       const struct cupola_target *place)
{
    struct host_point host;
    if (gl->guest.leaves_state)
        host_point_set(&gl->features);
    else
        host_point_save(&host, &gl->features);
    host_set_viewport(&gl->features, place->x, place->y, pass->tiles.tiles.width_px,
                      pass->tiles.tiles.height_px);
    for (int kind = 0; kind < TILE_KINDS; kind++) {
        const struct warp_program *program = &pass->programs[pass->gain != 0][SOURCE_KINDS + kind];
        if (!pass->tiles.tiles.count[kind])
            continue;
        program_begin(gl, program, place);
        view_images_set(gl, program);
        tile_draw(&pass->tiles, kind);
    }
    if (!gl->guest.leaves_state)
        host_point_restore(&host, &gl->features);
}

void warp_draw_views(cupola_gl *gl, int output, const struct cupola_target *place)
{
    const struct cupola_output *size = &gl->plan.dome.rig.outputs[output];
    const struct warp_pass *pass = &gl->passes[output];
    const struct warp_program *program = &pass->programs[pass->gain != 0][CUPOLA_SOURCE_VIEWS];
    host_set_area(&gl->features, place->x, place->y, size->width_px, size->height_px);
    views_bind(gl, output);
    if (pass->stage == CUPOLA_TABLE_TILES) {
        draw_tiles(gl, pass, place);
        return;
    }
    program_begin(gl, program, place);
    view_images_set(gl, program);
    draw_fullscreen(gl->vertex_array);
}

static void draw_picture(const cupola_gl *gl, int output, const struct cupola_source *source,
                         const struct cupola_target *place)
{
    const struct warp_pass *pass = &gl->passes[output];
    const struct warp_program *program = &pass->programs[pass->gain != 0][source->kind];
    bool cube = source->kind == CUPOLA_SOURCE_CUBE, kept = !gl->guest.leaves_state;
    struct host_cube host;
    program_begin(gl, program, place);
    glActiveTexture(GL_TEXTURE0 + UNIT_IMAGE);
    if (cube && kept)
        host_cube_save(&host);
    else if (cube)
        host_cube_set();
    source_bind(gl, program, source);
    draw_fullscreen(gl->vertex_array);
    if (cube && kept)
        host_cube_restore(&host);
}

/* Into the framebuffer that is bound; all has been checked. */
static void warp_draw(cupola_gl *gl, int output, const struct cupola_source *source,
                      const struct cupola_target *place)
{
    const struct cupola_output *size = &gl->plan.dome.rig.outputs[output];
    if (source->kind == CUPOLA_SOURCE_VIEWS)
        eye_follow(gl, output, place->framebuffer);
    host_set_area(&gl->features, place->x, place->y, size->width_px, size->height_px);
    if (gl->passes[output].gain)
        gain_bind(gl, output);
    if (source->kind == CUPOLA_SOURCE_VIEWS)
        warp_draw_views(gl, output, place);
    else
        draw_picture(gl, output, source, place);
}

/* All that is sampled: there, and not drawn into at the same time. The target is bound then. */
static int check_sampled(const cupola_gl *gl, int output, const struct cupola_source *source,
                         const struct cupola_target *place, struct cupola_error *error)
{
    const GLuint framebuffer = place->framebuffer;
    const struct warp_pass *pass = &gl->passes[output];
    bool views = source->kind == CUPOLA_SOURCE_VIEWS;
    bool images = views && gl->params.storage != CUPOLA_STORAGE_ATLAS;
    GLuint sampled[CUPOLA_VIEWS_MAX + 3] = {views ? gl->atlas : source->texture,
                                            views ? pass->table : 0, pass->gain};
    if (images)
        memcpy(sampled + 3, gl->images.textures, sizeof gl->images.textures);
    int status = source_check_gl(gl, source, error);
    if (status == CUPOLA_OK && images)
        status = view_images_check(gl, error);
    if (status == CUPOLA_OK && pass->gain)
        status = gain_check(gl, output, error);
    if (status == CUPOLA_OK)
        status = target_bind(&gl->guest, place, error);
    if (status != CUPOLA_OK || gl->guest.leaves_state)
        return status; /* what is attached to the target would have to be asked for */
    status = target_check_color(framebuffer, error);
    if (status == CUPOLA_OK)
        status = target_check_sampled(framebuffer, sampled, CUPOLA_VIEWS_MAX + 3, error);
    if (status == CUPOLA_OK)
        status = target_check_encoding(&gl->features, framebuffer, gl->params.encoding, error);
    return status;
}

/* Black is what views show that nobody has drawn, and a riddle to whoever forgot to. */
static void tell_if_blank(cupola_gl *gl)
{
    if (gl->views_drawn || gl->blank_told)
        return;
    guest_tell(&gl->guest, CUPOLA_LOG_WARNING, CUPOLA_LOG_NOT_DRAWN,
               "a warp shows views of which none was ever drawn");
    gl->blank_told = true;
}

static int warp(cupola_gl *gl, int output, const struct cupola_source *source,
                const struct cupola_target *target, struct cupola_error *error)
{
    int status = output_check(gl, output, error);
    if (status != CUPOLA_OK)
        return status;
    struct cupola_target place = target ? *target : (struct cupola_target){0};
    struct cupola_source shown = source ? *source : (struct cupola_source){.texture = 0};
    struct guest_work work;
    guest_begin(&gl->guest, &work, "warp of output %d", output);
    status = check_sampled(gl, output, &shown, &place, error);
    if (status == CUPOLA_OK)
        warp_draw(gl, output, &shown, &place);
    guest_end(&gl->guest, &work);
    if (status == CUPOLA_OK && shown.kind == CUPOLA_SOURCE_VIEWS &&
        gl->params.storage == CUPOLA_STORAGE_ATLAS)
        tell_if_blank(gl);
    return status;
}

int cupola_gl_warp(cupola_gl *gl, int output, const struct cupola_source *source,
                   const struct cupola_target *target, struct cupola_error *error)
{
    struct cupola_error unwanted;
    error = error ? error : &unwanted;
    return call_ended(gl, __func__, warp(gl, output, source, target, error), error);
}
