/* The host's own textures as views. */
#include "error.h"
#include "gl_objects.h"
#include "instance.h"
#include "sampled.h"

/* Of a texture that is not asked for its size: larger than any. */
enum { SIZE_UNKNOWN = 1 << 24 };

GLint view_image_unit(int view)
{
    return view == 0 ? UNIT_IMAGE : UNIT_TABLE + view;
}

int view_images_create(cupola_gl *gl, struct cupola_error *error)
{
    gl->image_sampler = sampler_create(&gl->guest, "the host's views", error);
    return gl->image_sampler ? CUPOLA_OK : (int)error->status;
}

static GLenum kind_of(const cupola_gl *gl)
{
    return gl->params.storage == CUPOLA_STORAGE_LAYERS ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
}

static int refuse_texture(const cupola_gl *gl, int view, GLuint texture, struct cupola_error *error)
{
    return error_set(error, CUPOLA_ERROR_ARGUMENT,
                     "texture of view %d is %u; allowed: the name of a %s", view, texture,
                     gl->params.storage == CUPOLA_STORAGE_LAYERS ? "GL_TEXTURE_2D_ARRAY"
                                                                 : "GL_TEXTURE_2D");
}

static int check_layer(const cupola_gl *gl, int view, int layer, int layers,
                       struct cupola_error *error)
{
    if (gl->params.storage == CUPOLA_STORAGE_TEXTURES && layer != 0)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "layer of view %d is %d; allowed for a GL_TEXTURE_2D: 0", view, layer);
    if (layer < 0 || layer >= layers)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "layer of view %d is %d; allowed: 0 to %d",
                         view, layer, layers - 1);
    return CUPOLA_OK;
}

/* A side of a rectangle that begins at `at`. */
static bool fits(int at, int length, int most)
{
    return at >= 0 && length >= 1 && length <= most && at <= most - length;
}

static int check_rect(int view, const struct cupola_rect *rect, const GLint size[2], bool known,
                      struct cupola_error *error)
{
    if (!rect->x && !rect->y && !rect->width && !rect->height)
        return CUPOLA_OK;
    if (fits(rect->x, rect->width, size[0]) && fits(rect->y, rect->height, size[1]))
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_ARGUMENT,
                     "rectangle of view %d is %d x %d texels at (%d, %d); allowed: inside of %s%d "
                     "x %d texels, or all zero",
                     view, rect->width, rect->height, rect->x, rect->y,
                     known ? "the texture's " : "", size[0], size[1]);
}

/* In OpenGL ES 3.0, which cannot be asked for a texture's size, against what the GL allows. */
static int check_image(const cupola_gl *gl, const struct cupola_view_image *images, int view,
                       struct cupola_error *error)
{
    const struct cupola_view_image *image = &images[view];
    GLint size[3];
    if (!texture_found(&gl->guest, kind_of(gl), image->texture))
        return refuse_texture(gl, view, image->texture, error);
    if (gl->params.storage == CUPOLA_STORAGE_LAYERS && image->texture != images[0].texture)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "view %d is a layer of texture %u and view 0 of texture %u; allowed: "
                         "layers of one GL_TEXTURE_2D_ARRAY",
                         view, image->texture, images[0].texture);
    bool known = !gl->guest.leaves_state && texture_size(&gl->features, kind_of(gl), size);
    int status = sampled_check_in_frame(&gl->guest, kind_of(gl), image->texture, false, error);
    if (status != CUPOLA_OK) {
        error_context(error, "view %d", view);
        return status;
    }
    if (!known && gl->guest.leaves_state) {
        size[0] = size[1] = size[2] = SIZE_UNKNOWN;
    } else if (!known) {
        glGetIntegerv(GL_MAX_TEXTURE_SIZE, &size[0]);
        size[1] = size[0];
        glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &size[2]);
    }
    status = check_layer(gl, view, image->layer, size[2] > 1 ? size[2] : 1, error);
    return status == CUPOLA_OK ? check_rect(view, &image->rect, size, known, error) : status;
}

static void keep(cupola_gl *gl, const struct cupola_view_image *images)
{
    for (int i = 0; i < gl->plan.view_count; i++) {
        const struct cupola_rect *rect = &images[i].rect;
        const GLfloat numbers[4] = {(GLfloat)rect->x, (GLfloat)rect->y, (GLfloat)rect->width,
                                    (GLfloat)rect->height};
        gl->images.textures[i] = images[i].texture;
        gl->images.layers[i] = (GLfloat)images[i].layer;
        for (int k = 0; k < 4; k++)
            gl->images.rects[4 * i + k] = numbers[k];
    }
    gl->images.given = true;
}

static int views_import(cupola_gl *gl, const struct cupola_view_image *images,
                        struct cupola_error *error)
{
    if (!gl || !images)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is NULL", gl ? "images" : "gl");
    if (guest_check_seen(&gl->guest, error) != CUPOLA_OK)
        return CUPOLA_ERROR_LOST;
    if (gl->params.storage == CUPOLA_STORAGE_ATLAS || !shows_source(gl, CUPOLA_SOURCE_VIEWS))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "gl was made for views of its own or for none; allowed: one with storage "
                         "textures or layers");
    int status = guest_check(&gl->guest, error);
    if (status != CUPOLA_OK)
        return status;
    struct guest_work work;
    guest_begin(&gl->guest, &work, "import of views");
    for (int i = 0; status == CUPOLA_OK && i < gl->plan.view_count; i++)
        status = check_image(gl, images, i, error);
    guest_end(&gl->guest, &work);
    if (status == CUPOLA_OK)
        keep(gl, images);
    return status;
}

int cupola_gl_views_import(cupola_gl *gl, const struct cupola_view_image *images,
                           struct cupola_error *error)
{
    struct cupola_error unwanted;
    error = error ? error : &unwanted;
    return call_ended(gl, __func__, views_import(gl, images, error), error);
}

int view_images_check(const cupola_gl *gl, struct cupola_error *error)
{
    if (!gl->images.given)
        return error_set(error, CUPOLA_ERROR_ORDER,
                         "warp before the host's views were imported; call cupola_gl_views_import "
                         "first");
    int count = gl->params.storage == CUPOLA_STORAGE_LAYERS ? 1 : gl->plan.view_count;
    for (int i = 0; i < count; i++)
        if (!texture_found(&gl->guest, kind_of(gl), gl->images.textures[i]))
            return refuse_texture(gl, i, gl->images.textures[i], error);
    return CUPOLA_OK;
}

void view_images_bind(const cupola_gl *gl)
{
    bool layers = gl->params.storage == CUPOLA_STORAGE_LAYERS;
    for (int i = 0; i < (layers ? 1 : gl->plan.view_count); i++) {
        GLuint unit = (GLuint)view_image_unit(i);
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(kind_of(gl), gl->images.textures[i]);
        glBindSampler(unit, gl->image_sampler);
    }
}

void view_images_set(const cupola_gl *gl, const struct warp_program *program)
{
    if (gl->params.storage == CUPOLA_STORAGE_ATLAS)
        return;
    glUniform4fv(program->image_rect, gl->plan.view_count, gl->images.rects);
    if (gl->params.storage == CUPOLA_STORAGE_LAYERS)
        glUniform1fv(program->image_layer, gl->plan.view_count, gl->images.layers);
}
