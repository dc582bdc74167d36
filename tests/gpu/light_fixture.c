/* See light_fixture.h. */
#include "light_fixture.h"

#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "context.h"
#include "painted.h"
#include "rig_random.h"
#include "worse.h"

const float light_border[4] = {0.3f, 0.02f, 0.7f, 0.5f};

static const char *const names[LIGHT_KINDS] = {"atlas",      "textures",        "layers",
                                               "domemaster", "equirectangular", "cube"};

enum { PICTURE_HEIGHT = 128, LAYER = 2, LAYERS = 4 };

const char *light_name(enum light_kind kind)
{
    return names[kind];
}

bool light_exists(enum light_kind kind)
{
    return kind != LIGHT_ATLAS || context_has_floats();
}

/* All that half floats hold exactly, so that every format of floats shows the same. */
static float exact(double number)
{
    return (float)(round(1024.0 * number) / 1024.0);
}

static void light_of_direction(const double direction[3], float rgba[4], void *user)
{
    (void)user;
    for (int i = 0; i < 3; i++)
        rgba[i] = exact(0.5 + 0.5 * direction[i]);
    rgba[3] = exact(0.6 + 0.3 * direction[1]);
}

static struct cupola_rig light_rig(void)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 170.0, LIGHT_WIDTH);
    rig.outputs[0].height_px = LIGHT_HEIGHT;
    rig.outputs[0].circle = (struct cupola_circle){46.3, 41.7, 44.9};
    rig.outputs[0].position_m[0] = 0.21;
    rig.outputs[0].aim.yaw_rad = 0.13;
    rig.screen.radius_m = 1.0;
    rig.screen.cap_rad = radians(75.0);
    rig.eye_m[1] = -0.17;
    rig.eye_m[2] = 0.11;
    return rig;
}

static enum cupola_storage storage_of(enum light_kind kind)
{
    return kind == LIGHT_TEXTURES ? CUPOLA_STORAGE_TEXTURES
           : kind == LIGHT_LAYERS ? CUPOLA_STORAGE_LAYERS
                                  : CUPOLA_STORAGE_ATLAS;
}

static void make_picture(struct light_theatre *theatre)
{
    struct cupola_source *source = &theatre->source;
    bool cube = source->kind == CUPOLA_SOURCE_CUBE;
    GLenum target = cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
    int width = painted_width(source, PICTURE_HEIGHT);
    size_t face_texels = (size_t)width * PICTURE_HEIGHT;
    source->fov_rad = radians(200.0);
    theatre->height = PICTURE_HEIGHT;
    theatre->texels = painted_picture(source, PICTURE_HEIGHT);
    for (size_t i = 0; i < face_texels * (size_t)painted_faces(source); i++) {
        float *texel = theatre->texels + 4 * i;
        const double direction[3] = {(double)texel[0], (double)texel[1], (double)texel[2]};
        light_of_direction(direction, texel, NULL);
    }
    glGenTextures(1, &theatre->texture);
    glBindTexture(target, theatre->texture);
    for (int face = 0; face < painted_faces(source); face++)
        glTexImage2D(cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + (GLenum)face : target, 0, GL_RGBA16F,
                     width, PICTURE_HEIGHT, 0, GL_RGBA, GL_FLOAT,
                     theatre->texels + 4 * (size_t)face * face_texels);
    glBindTexture(target, 0);
    source->texture = theatre->texture;
}

/* The atlas as a texture, or a layer, of the host's: each view is a rectangle of it. */
static void import_views(enum light_kind kind, struct light_theatre *theatre, int width, int height)
{
    struct cupola_view_image images[CUPOLA_VIEWS_MAX];
    struct cupola_error error = {CUPOLA_OK, ""};
    glGenTextures(1, &theatre->texture);
    if (kind == LIGHT_LAYERS) {
        glBindTexture(GL_TEXTURE_2D_ARRAY, theatre->texture);
        glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA16F, width, height, LAYERS, 0, GL_RGBA,
                     GL_FLOAT, NULL);
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, LAYER, width, height, 1, GL_RGBA, GL_FLOAT,
                        theatre->texels);
        glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    } else {
        glBindTexture(GL_TEXTURE_2D, theatre->texture);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, width, height, 0, GL_RGBA, GL_FLOAT,
                     theatre->texels);
        glBindTexture(GL_TEXTURE_2D, 0);
    }
    for (int i = 0; i < cupola_plan_view_count(theatre->fixture.plan); i++)
        images[i] = (struct cupola_view_image){theatre->texture, kind == LIGHT_LAYERS ? LAYER : 0,
                                               cupola_plan_view(theatre->fixture.plan, i)->rect};
    if (cupola_gl_views_import(theatre->fixture.gl, images, &error) < 0)
        fail_msg("%s", error.message);
}

static void make_views(enum light_kind kind, struct light_theatre *theatre)
{
    const struct cupola_plan_report *report = cupola_plan_report(theatre->fixture.plan);
    int width = report->atlas_width_px, height = report->atlas_height_px;
    theatre->texels = calloc(4 * (size_t)width * (size_t)height, sizeof(float));
    assert_non_null(theatre->texels);
    cupola_reference_views(theatre->fixture.plan, light_of_direction, NULL, theatre->texels);
    if (kind != LIGHT_ATLAS) {
        import_views(kind, theatre, width, height);
        return;
    }
    glBindTexture(GL_TEXTURE_2D, cupola_gl_atlas(theatre->fixture.gl));
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, theatre->texels);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void light_make(enum light_kind kind, const struct cupola_gl_params *params,
                struct light_theatre *theatre)
{
    struct cupola_gl_params wished = params ? *params : (struct cupola_gl_params){.border = {0}};
    struct cupola_rig rig = light_rig();
    *theatre = (struct light_theatre){.height = 0};
    if (kind >= LIGHT_DOMEMASTER)
        theatre->source.kind =
            (enum cupola_source_kind)(CUPOLA_SOURCE_DOMEMASTER + (kind - LIGHT_DOMEMASTER));
    memcpy(wished.border, light_border, sizeof light_border);
    wished.format = kind == LIGHT_ATLAS ? CUPOLA_FORMAT_RGBA32F : CUPOLA_FORMAT_RGBA8;
    wished.storage = storage_of(kind);
    wished.sources = 1u << (unsigned int)theatre->source.kind;
    fixture_make(&rig, NULL, &wished, &theatre->fixture);
    if (theatre->source.kind == CUPOLA_SOURCE_VIEWS)
        make_views(kind, theatre);
    else
        make_picture(theatre);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

void light_release(struct light_theatre *theatre)
{
    fixture_release(&theatre->fixture);
    glDeleteTextures(1, &theatre->texture);
    free(theatre->texels);
}

static float *image_create(void)
{
    float *image = malloc(4 * sizeof *image * LIGHT_WIDTH * LIGHT_HEIGHT);
    assert_non_null(image);
    return image;
}

float *light_expected(const struct light_theatre *theatre)
{
    const struct cupola_source *source = &theatre->source;
    float *image = image_create();
    int status;
    if (source->kind == CUPOLA_SOURCE_VIEWS)
        status =
            cupola_reference_warp(theatre->fixture.plan, 0, theatre->texels, light_border, image);
    else
        status = cupola_reference_source(theatre->fixture.dome, 0, source, theatre->texels,
                                         painted_width(source, theatre->height), theatre->height,
                                         light_border, image);
    assert_int_equal(status, CUPOLA_OK);
    return image;
}

GLenum light_float_format(void)
{
    return context_has_floats() ? GL_RGBA32F : 0;
}

float *light_shown(const struct light_theatre *theatre, GLenum format, struct cupola_error *error)
{
    struct cupola_target target = {0, 0, 0};
    GLuint color = 0;
    float *image = NULL;
    glGenRenderbuffers(1, &color);
    glBindRenderbuffer(GL_RENDERBUFFER, color);
    glRenderbufferStorage(GL_RENDERBUFFER, format, LIGHT_WIDTH, LIGHT_HEIGHT);
    glGenFramebuffers(1, &target.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    if (cupola_gl_warp(theatre->fixture.gl, 0, &theatre->source, &target, error) == CUPOLA_OK) {
        image = image_create();
        context_read_pixels(LIGHT_WIDTH, LIGHT_HEIGHT, image);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &target.framebuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    glDeleteRenderbuffers(1, &color);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    return image;
}

void light_encode(float *rgba, int pixels)
{
    for (int i = 0; i < 4 * pixels; i++)
        if (i % 4 != 3)
            rgba[i] = (float)light_encoded((double)rgba[i]);
}

double light_difference(const float *a, const float *b)
{
    double worst = 0.0;
    for (int i = 0; i < 4 * LIGHT_WIDTH * LIGHT_HEIGHT; i++)
        worst = worse_of(worst, fabs((double)a[i] - (double)b[i]));
    return worst;
}
