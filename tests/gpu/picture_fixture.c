/* Existing pictures ready to be shown: textures of them, and what the warp makes of those. */
#include "picture_fixture.h"

#include <string.h>

#include "painted.h"

const float picture_border[4] = {0.3f, 0.1f, 0.2f, 0.5f};

/* A texture of a painted picture, or of any other of its shape. */
void picture_upload(struct cupola_source *source, const float *picture, int height)
{
    GLsizei width = painted_width(source, height);
    bool cube = source->kind == CUPOLA_SOURCE_CUBE;
    GLenum target = cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
    glGenTextures(1, &source->texture);
    glBindTexture(target, source->texture);
    for (int face = 0; face < painted_faces(source); face++)
        glTexImage2D(cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + (GLenum)face : target, 0, GL_RGBA32F,
                     width, height, 0, GL_RGBA, GL_FLOAT,
                     picture + 4 * (size_t)face * (size_t)width * (size_t)height);
    if (source->mipmaps)
        glGenerateMipmap(target);
    glBindTexture(target, 0); /* its filter stays GL's default, which wants mipmaps */
}

/* The image of output 0, freed by the caller. */
float *picture_shown(const struct fixture *fixture, const struct cupola_source *source)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_target target = {0, 5, 3};
    GLuint texture = 0;
    float *image = malloc(4 * sizeof *image * (size_t)size->width_px * (size_t)size->height_px);
    assert_non_null(image);
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, size->width_px + 5, size->height_px + 3, 0, GL_RGBA,
                 GL_FLOAT, NULL);
    glGenFramebuffers(1, &target.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (cupola_gl_warp(fixture->gl, 0, source, &target, &error) < 0 ||
        cupola_gl_capture(&target, size->width_px, size->height_px, image, &error) < 0)
        fail_msg("%s", error.message);
    glDeleteFramebuffers(1, &target.framebuffer);
    glDeleteTextures(1, &texture);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    return image;
}

void picture_fixture_make(const struct cupola_rig *rig, struct fixture *fixture)
{
    struct cupola_gl_params params = {.sources = 1u << CUPOLA_SOURCE_DOMEMASTER |
                                                 1u << CUPOLA_SOURCE_EQUIRECTANGULAR |
                                                 1u << CUPOLA_SOURCE_CUBE};
    memcpy(params.border, picture_border, sizeof picture_border);
    fixture_make(rig, NULL, &params, fixture);
}

double picture_pixel_error(const float *shown, const float *expected)
{
    double square = 0.0;
    for (int c = 0; c < 4; c++) {
        double off = (double)shown[c] - (double)expected[c];
        square += off * off;
    }
    return sqrt(square);
}

/* Random numbers, RGBA. */
float *picture_noise(size_t texels)
{
    uint64_t seed = 7103;
    float *picture = malloc(4 * sizeof *picture * texels);
    assert_non_null(picture);
    for (size_t i = 0; i < 4 * texels; i++)
        picture[i] = (float)random_between(&seed, 0.0, 1.0);
    return picture;
}
