/* All that the library does in a host's context. */
#include "guest_fixture.h"

#include <stdlib.h>

#include "check.h"
#include "context.h"
#include "cupola/overlay.h"
#include "fixture.h"
#include "rig_random.h"

static void make_picture(struct cupola_source *source, enum cupola_source_kind kind)
{
    enum { SIDE = 4 };
    bool cube = kind == CUPOLA_SOURCE_CUBE;
    GLenum target = cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
    unsigned char texels[4 * SIDE * SIDE];
    for (int i = 0; i < 4 * SIDE * SIDE; i++)
        texels[i] = (unsigned char)(40 * (int)kind + 7 * i);
    *source = (struct cupola_source){.kind = kind};
    glGenTextures(1, &source->texture);
    glBindTexture(target, source->texture);
    for (GLenum face = 0; face < (cube ? 6u : 1u); face++)
        glTexImage2D(cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + face : target, 0, GL_RGBA8, SIDE, SIDE,
                     0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glBindTexture(target, 0);
}

static void make_gain(struct guest_house *house)
{
    unsigned char texels[4 * GUEST_SIZE * GUEST_SIZE];
    for (int i = 0; i < 4 * GUEST_SIZE * GUEST_SIZE; i++)
        texels[i] = (unsigned char)(255 - i % 100);
    glGenTextures(1, &house->gain);
    glBindTexture(GL_TEXTURE_2D, house->gain);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, GUEST_SIZE, GUEST_SIZE, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels);
    glBindTexture(GL_TEXTURE_2D, 0);
}

static void make_view_textures(struct guest_house *house)
{
    enum { SIDE = 8 };
    static const unsigned char texels[4 * SIDE * SIDE * CUPOLA_VIEWS_MAX] = {9, 99, 199, 255};
    glGenTextures(2, house->view_textures);
    glBindTexture(GL_TEXTURE_2D, house->view_textures[0]);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, SIDE, SIDE, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, house->view_textures[1]);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA8, SIDE, SIDE, CUPOLA_VIEWS_MAX, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, texels);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
}

static void make_target(struct guest_house *house)
{
    glGenTextures(1, &house->target_texture);
    glBindTexture(GL_TEXTURE_2D, house->target_texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, GUEST_SIZE, GUEST_SIZE, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 NULL);
    glBindTexture(GL_TEXTURE_2D, 0);
    glGenFramebuffers(1, &house->target.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, house->target.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                           house->target_texture, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void guest_house_build(struct guest_house *house)
{
    guest_house_build_for(house, 1);
}

static void build(struct guest_house *house, int projectors, double head_radius_m)
{
    const struct cupola_plan_params wishes = {.head_radius_m = head_radius_m};
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 150.0, GUEST_SIZE);
    rig.output_count = projectors;
    for (int i = 1; i < projectors; i++)
        rig.outputs[i] = rig.outputs[0];
    *house = (struct guest_house){.moving = head_radius_m > 0.0};
    assert_int_equal(cupola_dome_create(&rig, &house->dome, NULL), CUPOLA_OK);
    assert_int_equal(cupola_plan_create(house->dome, &wishes, &house->plan, NULL), CUPOLA_OK);
    for (int i = 0; i < GUEST_PICTURES; i++)
        make_picture(&house->pictures[i], (enum cupola_source_kind)(CUPOLA_SOURCE_DOMEMASTER + i));
    make_gain(house);
    make_view_textures(house);
    make_target(house);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

void guest_house_build_for(struct guest_house *house, int projectors)
{
    build(house, projectors, 0.0);
}

void guest_house_build_moving(struct guest_house *house)
{
    build(house, 1, GUEST_HEAD_RADIUS_M);
}

void guest_house_release(struct guest_house *house)
{
    cupola_theatre_destroy(&house->theatre);
    cupola_gl_destroy(&house->gl);
    cupola_plan_destroy(&house->plan);
    cupola_dome_destroy(&house->dome);
    for (int i = 0; i < GUEST_PICTURES; i++)
        glDeleteTextures(1, &house->pictures[i].texture);
    glDeleteTextures(1, &house->gain);
    glDeleteTextures(2, house->view_textures);
    glDeleteTextures(1, &house->target_texture);
    glDeleteFramebuffers(1, &house->target.framebuffer);
}

int guest_gl_create(struct guest_house *house, const struct cupola_gl_params *params,
                    struct cupola_error *error)
{
    struct cupola_gl_params wished = params ? *params : (struct cupola_gl_params){.samples = 0};
    wished.overlays = wished.overlays || !wished.sources;
    if (!wished.sources)
        wished.sources = 1u << CUPOLA_SOURCE_VIEWS | 1u << CUPOLA_SOURCE_DOMEMASTER |
                         1u << CUPOLA_SOURCE_EQUIRECTANGULAR | 1u << CUPOLA_SOURCE_CUBE;
    struct cupola_gl_params staged;
    house->storage = wished.storage;
    house->one_pass =
        wished.storage == CUPOLA_STORAGE_ATLAS && wished.sources & 1u && cupola_pass_way(NULL) > 0;
    wished.one_pass = house->one_pass;
    return cupola_gl_create(house->plan, fixture_with_stage(&wished, &staged), &house->gl, error);
}

enum cupola_table guest_moving_table(enum cupola_table wished)
{
    bool table = wished == CUPOLA_TABLE_ANGLES || wished == CUPOLA_TABLE_SINES ||
                 wished == CUPOLA_TABLE_COORDINATES;
    return table && !context_has_floats() ? CUPOLA_TABLE_POINTS : wished;
}

int guest_move(struct guest_house *house, struct cupola_error *error)
{
    static const double places_m[2][3] = {{-0.05, 0.0, 0.02}, {0.04, 0.06, -0.03}};
    if (!house->moving)
        return CUPOLA_OK;
    int status = cupola_gl_set_eye(house->gl, places_m[0], error);
    return status < 0 ? status : cupola_gl_set_eye(house->gl, places_m[1], error);
}

int guest_import(struct guest_house *house, struct cupola_error *error)
{
    bool layers = house->storage == CUPOLA_STORAGE_LAYERS;
    struct cupola_view_image images[CUPOLA_VIEWS_MAX];
    for (int i = 0; i < CUPOLA_VIEWS_MAX; i++)
        images[i] =
            (struct cupola_view_image){house->view_textures[layers], layers ? i : 0, {0, 0, 0, 0}};
    return cupola_gl_views_import(house->gl, images, error);
}

/* Something in each view. */
int guest_pass(struct guest_house *house, struct cupola_error *error)
{
    struct cupola_gl_pass pass;
    int status = cupola_gl_pass_begin(house->gl, NULL, &pass, error);
    if (status < 0)
        return status;
    for (int i = 0; i < pass.view_count; i++) {
        const GLfloat color[4] = {0.2f * (float)i, 0.5f, 0.9f - 0.2f * (float)i, 1};
        const struct cupola_rect *rect = &pass.views[i].rect;
        glScissorIndexed(0, rect->x, rect->y, rect->width, rect->height); /* as clears have it */
        glClearBufferfv(GL_COLOR, 0, color);
    }
    return cupola_gl_pass_end(house->gl, error);
}

int guest_views(struct guest_house *house, struct cupola_error *error)
{
    if (house->storage != CUPOLA_STORAGE_ATLAS)
        return guest_import(house, error);
    int views = cupola_gl_frame_begin(house->gl, NULL, error);
    for (int i = 0; i < views; i++) {
        int status = cupola_gl_view_begin(house->gl, i, NULL, error);
        if (status < 0)
            return status;
        const GLfloat color[4] = {0.2f * (float)i, 0.5f, 0.9f - 0.2f * (float)i, 1};
        glClearBufferfv(GL_COLOR, 0, color);
        status = cupola_gl_view_end(house->gl, error);
        if (status < 0)
            return status;
    }
    int status = views < 0 || !house->one_pass ? views : guest_pass(house, error);
    return status < 0 ? status : views;
}

int guest_warp(struct guest_house *house, int picture, struct cupola_error *error)
{
    return cupola_gl_warp(house->gl, 0, picture < 0 ? NULL : &house->pictures[picture],
                          &house->target, error);
}

int guest_overlays(struct guest_house *house, struct cupola_error *error)
{
    const struct cupola_overlay overlays[] = {
        {.kind = CUPOLA_OVERLAY_DISC, .direction = {0.2, 0.1, -1}, .width_rad = 0.4},
        {.direction = {-0.2, 0, -1}, .width_rad = 0.3, .texture = house->pictures[0].texture},
    };
    return cupola_gl_overlay(house->gl, 0, overlays, 2, &house->target, error);
}

int guest_frame(struct guest_house *house, struct cupola_error *error)
{
    int status = guest_move(house, error);
    if (status >= 0)
        status = guest_views(house, error);
    for (int i = GUEST_PICTURES - 1; status >= 0 && i >= -1; i--)
        status = guest_warp(house, i, error);
    return status < 0 ? status : guest_overlays(house, error);
}

int guest_theatre(struct guest_house *house, struct cupola_error *error)
{
    return guest_theatre_encoded(house, CUPOLA_ENCODING_LINEAR, error);
}

int guest_theatre_encoded(struct guest_house *house, enum cupola_encoding encoding,
                          struct cupola_error *error)
{
    struct cupola_spectator spectator;
    unsigned int images[CUPOLA_OUTPUTS_MAX];
    for (int i = 0; i < CUPOLA_OUTPUTS_MAX; i++)
        images[i] = house->pictures[0].texture;
    cupola_spectator_outside(house->dome, &spectator);
    spectator.encoding = encoding;
    return cupola_theatre_draw(house->theatre, images, &spectator, GUEST_SIZE, GUEST_SIZE,
                               &house->target, error);
}

float *guest_picture(const struct guest_house *house)
{
    float *rgba = calloc(4 * GUEST_SIZE * GUEST_SIZE, sizeof *rgba);
    assert_non_null(rgba);
    assert_int_equal(cupola_gl_capture(&house->target, GUEST_SIZE, GUEST_SIZE, rgba, NULL),
                     CUPOLA_OK);
    return rgba;
}
