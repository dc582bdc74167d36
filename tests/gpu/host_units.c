/*
 * The host's texture units beyond those of a plain frame: the host's views, layers and gains take
 * more of them, and each is left as it was; whatever was bound there changes no pixel.
 */
#include <stdio.h>
#include <stdlib.h>

#include "gl/instance.h"
#include "group.h"
#include "light_fixture.h"
#include "state_snapshot.h"

enum { PIXELS = LIGHT_WIDTH * LIGHT_HEIGHT, ACTIVE = 7 };

static GLuint flats[SNAPSHOT_UNITS], arrays[SNAPSHOT_UNITS], samplers[SNAPSHOT_UNITS];

static void host_create(void)
{
    glGenTextures(SNAPSHOT_UNITS, flats);
    glGenTextures(SNAPSHOT_UNITS, arrays);
    glGenSamplers(SNAPSHOT_UNITS, samplers);
    for (GLuint unit = 0; unit < SNAPSHOT_UNITS; unit++) {
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, flats[unit]);
        glBindTexture(GL_TEXTURE_2D_ARRAY, arrays[unit]);
        glBindSampler(unit, samplers[unit]); /* by mipmaps where there are none: black */
        glSamplerParameteri(samplers[unit], GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    }
    glActiveTexture(GL_TEXTURE0 + ACTIVE);
}

static void host_release(void)
{
    glDeleteTextures(SNAPSHOT_UNITS, flats);
    glDeleteTextures(SNAPSHOT_UNITS, arrays);
    glDeleteSamplers(SNAPSHOT_UNITS, samplers);
    glActiveTexture(GL_TEXTURE0);
}

static GLuint gain_create(void)
{
    static float gain[4 * PIXELS];
    GLuint texture = 0;
    for (int i = 0; i < 4 * PIXELS; i++)
        gain[i] = (float)(i % 7) / 4.0f;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, LIGHT_WIDTH, LIGHT_HEIGHT, 0, GL_RGBA, GL_FLOAT,
                 gain);
    glBindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

/* The same textures once more: an import that the host's state could disturb. */
static void import_again(const struct light_theatre *theatre)
{
    struct cupola_view_image images[CUPOLA_VIEWS_MAX];
    for (int i = 0; i < cupola_plan_view_count(theatre->fixture.plan); i++)
        images[i] =
            (struct cupola_view_image){theatre->texture, (int)theatre->fixture.gl->images.layers[i],
                                       cupola_plan_view(theatre->fixture.plan, i)->rect};
    assert_int_equal(cupola_gl_views_import(theatre->fixture.gl, images, NULL), CUPOLA_OK);
}

/* All calls that use units, and a warp; the picture in `image` or what was there before. */
static void calls(enum light_kind kind, const struct light_theatre *theatre, GLuint gain,
                  const struct cupola_target *target)
{
    const struct fixture *fixture = &theatre->fixture;
    if (kind == LIGHT_TEXTURES || kind == LIGHT_LAYERS)
        import_again(theatre);
    assert_int_equal(cupola_gl_set_gain(fixture->gl, 0, gain, NULL), CUPOLA_OK);
    assert_int_equal(cupola_gl_warp(fixture->gl, 0, &theatre->source, target, NULL), CUPOLA_OK);
}

static struct cupola_target target_create(GLuint *color)
{
    struct cupola_target target = {0, 0, 0};
    glGenRenderbuffers(1, color);
    glBindRenderbuffer(GL_RENDERBUFFER, *color);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, LIGHT_WIDTH, LIGHT_HEIGHT);
    glGenFramebuffers(1, &target.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, *color);
    return target;
}

/* How much of a host's state differs after the calls; their pixels. */
static int disturbed(enum light_kind kind, GLuint gain, bool hostile, bool careless, float *pixels)
{
    const struct cupola_gl_params params = {.encoding = CUPOLA_ENCODING_SRGB};
    struct light_theatre theatre;
    struct snapshot before, after;
    GLuint color = 0;
    light_make(kind, &params, &theatre);
    struct cupola_target target = target_create(&color);
    if (hostile)
        host_create();
    if (careless) { /* as if one unit were all that is used */
        cupola_gl_set_gain(theatre.fixture.gl, 0, gain, NULL);
        theatre.fixture.gl->features.texture_units = 1;
        theatre.fixture.gl->features.texture_arrays = false;
    }
    snapshot_take(&before);
    if (careless)
        cupola_gl_warp(theatre.fixture.gl, 0, &theatre.source, &target, NULL);
    else
        calls(kind, &theatre, gain, &target);
    snapshot_take(&after);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    context_read_pixels(LIGHT_WIDTH, LIGHT_HEIGHT, pixels);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &target.framebuffer);
    glDeleteRenderbuffers(1, &color);
    if (hostile)
        host_release();
    light_release(&theatre);
    return snapshot_differences(&before, &after, true, careless ? NULL : light_name(kind));
}

static void every_unit_is_left_as_it_was(void **state)
{
    (void)state;
    static float expected[4 * PIXELS], pixels[4 * PIXELS];
    GLuint gain = gain_create();
    for (int kind = 0; kind < LIGHT_KINDS; kind++)
        for (int gained = 0; gained < 2; gained++) {
            enum light_kind k = (enum light_kind)kind;
            GLuint texture = gained ? gain : 0;
            if (!light_exists(k))
                continue;
            assert_int_equal(disturbed(k, texture, false, false, expected), 0);
            assert_int_equal(disturbed(k, texture, true, false, pixels), 0);
            assert_memory_equal(pixels, expected, sizeof pixels);
            int lost = disturbed(k, texture, true, true, pixels);
            printf("%s, gain %d: without care %d numbers lost\n", light_name(k), gained, lost);
            /* A picture without gain needs no more than the first unit. */
            check_at_least(lost, k < LIGHT_DOMEMASTER || gained ? 1 : 0);
        }
    glDeleteTextures(1, &gain);
}

/* What a frame does not need it does not ask for. */
static void no_more_units_are_asked_for_than_are_used(void **state)
{
    (void)state;
    GLuint gain = gain_create();
    for (int kind = 0; kind < LIGHT_KINDS; kind++) {
        struct light_theatre theatre;
        if (!light_exists((enum light_kind)kind))
            continue;
        light_make((enum light_kind)kind, NULL, &theatre);
        int views = cupola_plan_view_count(theatre.fixture.plan);
        int used = kind == LIGHT_TEXTURES ? 1 + views : 2;
        const struct host_features *features = &theatre.fixture.gl->features;
        assert_int_equal(features->texture_units, used);
        assert_int_equal(features->texture_arrays, kind == LIGHT_LAYERS);
        cupola_gl_set_gain(theatre.fixture.gl, 0, gain, NULL);
        assert_int_equal(features->texture_units, used + 1);
        cupola_gl_set_gain(theatre.fixture.gl, 0, 0, NULL);
        assert_int_equal(features->texture_units, used);
        light_release(&theatre);
    }
    glDeleteTextures(1, &gain);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_unit_is_left_as_it_was),
        cmocka_unit_test(no_more_units_are_asked_for_than_are_used),
    };
    return run_gpu_group("host_units", tests);
}
