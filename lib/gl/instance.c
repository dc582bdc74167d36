/* A cupola_gl: made, given back. */
#include "instance.h"

#include <stdlib.h>
#include <string.h>

#include "error.h"
#include "names.h"

static const char *const table_names[] = {
    [CUPOLA_TABLE_POINTS] = "points",           [CUPOLA_TABLE_NONE] = "none",
    [CUPOLA_TABLE_ANGLES] = "angles",           [CUPOLA_TABLE_SINES] = "sines",
    [CUPOLA_TABLE_COORDINATES] = "coordinates",
};

enum { TABLE_COUNT = sizeof table_names / sizeof table_names[0], ERRORS_PENDING_MAX = 32 };

const char *cupola_table_name(int table)
{
    return name_of_number(table_names, TABLE_COUNT, table);
}

int cupola_table_find(const char *name)
{
    return number_of_name(table_names, TABLE_COUNT, name);
}

int context_check(struct cupola_error *error)
{
    static const char allowed[] = "OpenGL 3.3 or OpenGL ES 3.0, or newer";
    int version = epoxy_gl_version(); /* 0 without a context, where any GL call would abort */
    if (version == 0)
        return error_set(error, CUPOLA_ERROR_CONTEXT,
                         "no GL context is current on this thread; allowed: %s", allowed);
    bool es = !epoxy_is_desktop_gl();
    if (version < (es ? 30 : 33))
        return error_set(error, CUPOLA_ERROR_CONTEXT,
                         "the GL context is OpenGL%s %d.%d; allowed: %s", es ? " ES" : "",
                         version / 10, version % 10, allowed);
    return CUPOLA_OK;
}

void gl_errors_drop(void)
{
    /* A GL keeps a handful at most, but one that has lost its context answers with one for ever. */
    for (int i = 0; i < ERRORS_PENDING_MAX && glGetError() != GL_NO_ERROR; i++)
        ;
}

GLuint texture_create(GLenum internal_format, int width_px, int height_px, GLenum filter,
                      struct cupola_error *error)
{
    GLuint texture = 0;
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (width_px > largest || height_px > largest) {
        error_set(error, CUPOLA_ERROR_ARGUMENT,
                  "a texture of %d x %d px is needed; allowed by this GL: up to %d each way",
                  width_px, height_px, largest);
        return 0;
    }
    gl_errors_drop();
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, (GLint)filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, (GLint)filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    bool bytes = internal_format == GL_RGBA8 || internal_format == GL_SRGB8_ALPHA8;
    glTexImage2D(GL_TEXTURE_2D, 0, (GLint)internal_format, width_px, height_px, 0, GL_RGBA,
                 bytes ? GL_UNSIGNED_BYTE : GL_FLOAT, NULL);
    GLenum failure = glGetError();
    if (failure == GL_NO_ERROR)
        return texture;
    glDeleteTextures(1, &texture);
    error_set(error, failure == GL_OUT_OF_MEMORY ? CUPOLA_ERROR_MEMORY : CUPOLA_ERROR_GL,
              "the GL refused a texture of %d x %d px (error 0x%x)", width_px, height_px, failure);
    return 0;
}

int target_bind(GLuint framebuffer, struct cupola_error *error)
{
    if (framebuffer && !glIsFramebuffer(framebuffer))
        return error_set(error, CUPOLA_ERROR_GL, "target's framebuffer %u does not exist",
                         framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return error_set(error, CUPOLA_ERROR_GL, "target's framebuffer %u is not complete",
                         framebuffer);
    return CUPOLA_OK;
}

/* The name of the texture that is the bound framebuffer's colour of an index; 0 if none is. */
static GLuint color_texture(int index)
{
    GLenum place = (GLenum)(GL_COLOR_ATTACHMENT0 + index);
    GLint type = GL_NONE, name = 0;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, place,
                                          GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
    if (type == GL_TEXTURE)
        glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, place,
                                              GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &name);
    return (GLuint)name;
}

int target_check_sampled(GLuint framebuffer, const GLuint *textures, int count,
                         struct cupola_error *error)
{
    GLint colors = 0;
    if (!framebuffer)
        return CUPOLA_OK; /* the default framebuffer has no textures */
    glGetIntegerv(GL_MAX_COLOR_ATTACHMENTS, &colors);
    for (int i = 0; i < colors; i++) {
        GLuint attached = color_texture(i);
        for (int k = 0; attached && k < count; k++)
            if (textures[k] == attached)
                return error_set(error, CUPOLA_ERROR_ARGUMENT,
                                 "target's framebuffer %u has texture %u, which is sampled, as its "
                                 "color attachment %d; allowed: other textures",
                                 framebuffer, attached, i);
    }
    return CUPOLA_OK;
}

GLuint framebuffer_create(GLuint texture)
{
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE)
        return framebuffer;
    glDeleteFramebuffers(1, &framebuffer);
    return 0;
}

void draw_fullscreen(GLuint vertex_array)
{
    glBindVertexArray(vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

static int check_params(const struct cupola_gl_params *params, struct cupola_error *error)
{
    int status = views_check_params(params, error);
    if (status != CUPOLA_OK)
        return status;
    if (!cupola_table_name((int)params->table))
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "table stage is %d; allowed: 0 to %d",
                         (int)params->table, TABLE_COUNT - 1);
    if (params->storage < CUPOLA_STORAGE_ATLAS || params->storage > CUPOLA_STORAGE_LAYERS)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "storage is %d; allowed: %d to %d",
                         (int)params->storage, CUPOLA_STORAGE_ATLAS, CUPOLA_STORAGE_LAYERS);
    if (params->storage != CUPOLA_STORAGE_ATLAS && params->table == CUPOLA_TABLE_COORDINATES)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "table stage is coordinates, which are those of the atlas; allowed for "
                         "the host's textures: points, none, angles, sines");
    if (params->encoding < CUPOLA_ENCODING_LINEAR || params->encoding > CUPOLA_ENCODING_SRGB)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "encoding is %d; allowed: %d to %d",
                         (int)params->encoding, CUPOLA_ENCODING_LINEAR, CUPOLA_ENCODING_SRGB);
    if (params->sources >> SOURCE_KINDS)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "sources is 0x%x; allowed: 0 to 0x%x",
                         params->sources, (1u << SOURCE_KINDS) - 1u);
    return CUPOLA_OK;
}

static void destroy_objects(cupola_gl *gl)
{
    for (int i = 0; i < CUPOLA_OUTPUTS_MAX; i++)
        warp_pass_destroy(&gl->passes[i]);
    views_destroy(gl);
    glDeleteSamplers(1, &gl->sampler);
    glDeleteSamplers(1, &gl->image_sampler);
    glDeleteSamplers(1, &gl->gain_sampler);
    glDeleteVertexArrays(1, &gl->vertex_array);
}

static int create_objects(cupola_gl *gl, struct cupola_error *error)
{
    glGenVertexArrays(1, &gl->vertex_array);
    bool views = shows_source(gl, CUPOLA_SOURCE_VIEWS);
    int status = CUPOLA_OK;
    if (views && gl->params.storage == CUPOLA_STORAGE_ATLAS)
        status = views_create(gl, error);
    else if (views)
        view_images_create(gl);
    if (gl->params.sources >> CUPOLA_SOURCE_DOMEMASTER)
        glGenSamplers(1, &gl->sampler);
    for (int i = 0; status == CUPOLA_OK && i < gl->plan.dome.rig.output_count; i++)
        status = warp_pass_create(gl, i, error);
    return status;
}

int cupola_gl_create(const cupola_plan *plan, const struct cupola_gl_params *params, cupola_gl **gl,
                     struct cupola_error *error)
{
    struct cupola_error unwanted;
    if (!error)
        error = &unwanted; /* what is made further down answers by the error's status */
    if (!plan || !gl)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is NULL", plan ? "gl" : "plan");
    struct cupola_gl_params wished = params ? *params : (struct cupola_gl_params){.border = {0}};
    int status = context_check(error);
    if (status != CUPOLA_OK || (status = check_params(&wished, error)) != CUPOLA_OK)
        return status;
    cupola_gl *made = calloc(1, sizeof *made);
    if (!made)
        return error_set(error, CUPOLA_ERROR_MEMORY, "no memory for a cupola_gl (%zu bytes)",
                         sizeof *made);
    made->plan = *plan;
    made->params = wished;
    if (!made->params.sources)
        made->params.sources = 1u << CUPOLA_SOURCE_VIEWS;
    struct host_state state;
    host_features_find(&made->features);
    made->features.texture_units = gain_unit(made);
    made->features.texture_arrays = made->params.storage == CUPOLA_STORAGE_LAYERS;
    host_state_save(&state, &made->features);
    status = create_objects(made, error);
    if (status != CUPOLA_OK)
        destroy_objects(made);
    host_state_restore(&state);
    if (status != CUPOLA_OK) {
        free(made);
        return status;
    }
    *gl = made;
    return CUPOLA_OK;
}

void cupola_gl_destroy(cupola_gl **gl)
{
    if (!gl || !*gl)
        return;
    if (epoxy_gl_version() != 0) {
        if ((*gl)->view_open)
            cupola_gl_view_end(*gl, NULL);
        destroy_objects(*gl);
    }
    free(*gl);
    *gl = NULL;
}
