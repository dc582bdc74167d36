/*
 * Textures that no warp could show: integers, depth, missing levels, another size. They are refused
 * where the GL can be asked, by calls that leave no error in it.
 */
#include <string.h>

#include "cupola/overlay.h"
#include "cupola/theatre.h"
#include "group.h"
#include "oracle.h"
#include "rig_random.h"

enum { SIDE = 32, KINDS = 5 };

static const struct {
    GLint internal;
    GLenum format, type;
    const char *word; /* NULL: it is allowed */
} kinds[KINDS] = {
    {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, NULL},
    {GL_RGBA8UI, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE, "holds integers; allowed: "},
    {GL_R32I, GL_RED_INTEGER, GL_INT, "holds integers; allowed: "},
    {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, "holds depth; allowed: "},
    {GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, "holds depth; allowed: "},
};

static GLuint texture_of(GLenum target, int kind, int side)
{
    GLuint texture = 0;
    int images = target == GL_TEXTURE_CUBE_MAP ? 6 : 1;
    glGenTextures(1, &texture);
    glBindTexture(target, texture);
    for (int i = 0; i < images; i++)
        glTexImage2D(images == 6 ? (GLenum)(GL_TEXTURE_CUBE_MAP_POSITIVE_X + i) : target, 0,
                     kinds[kind].internal, side, side, 0, kinds[kind].format, kinds[kind].type,
                     NULL);
    glBindTexture(target, 0);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    return texture;
}

/* Pictures and overlays; for the host's own views where the storage is theirs. */
struct house {
    struct fixture fixture;
    struct cupola_target target;
    GLuint drawn_into;
};

static void house_build(enum cupola_storage storage, bool leaves_state, struct house *house)
{
    const struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, SIDE);
    const struct cupola_gl_params params = {
        .storage = storage, .sources = 0xf, .overlays = true, .leaves_state = leaves_state};
    fixture_make(&rig, NULL, &params, &house->fixture);
    house->drawn_into = texture_of(GL_TEXTURE_2D, 0, SIDE);
    house->target = (struct cupola_target){0, 0, 0};
    glGenFramebuffers(1, &house->target.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, house->target.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, house->drawn_into,
                           0);
}

static void house_release(struct house *house)
{
    glDeleteFramebuffers(1, &house->target.framebuffer);
    glDeleteTextures(1, &house->drawn_into);
    fixture_release(&house->fixture);
}

/* Refused with both words, or taken if the second is NULL; no GL error in either case. */
static void check_answer(int status, const struct cupola_error *error, const char *who,
                         const char *word)
{
    assert_int_equal(glGetError(), GL_NO_ERROR);
    assert_int_equal(status, word ? CUPOLA_ERROR_ARGUMENT : CUPOLA_OK);
    if (word && !(strstr(error->message, who) && strstr(error->message, word)))
        fail_msg("'%s' does not say '%s' and '%s'", error->message, who, word);
}

static int warp(const struct house *house, enum cupola_source_kind kind, GLuint texture,
                bool mipmaps, struct cupola_error *error)
{
    const struct cupola_source source = {.kind = kind, .texture = texture, .mipmaps = mipmaps};
    return cupola_gl_warp(house->fixture.gl, 0, &source, &house->target, error);
}

static int overlay(const struct house *house, GLuint texture, bool mipmaps, double width_rad,
                   struct cupola_error *error)
{
    const struct cupola_overlay one = {.direction = {0.0, 0.0, -1.0},
                                       .width_rad = width_rad,
                                       .texture = texture,
                                       .mipmaps = mipmaps};
    return cupola_gl_overlay(house->fixture.gl, 0, &one, 1, &house->target, error);
}

static int import(const struct house *house, GLuint texture, struct cupola_error *error)
{
    struct cupola_view_image images[CUPOLA_VIEWS_MAX] = {{0}};
    for (int i = 0; i < CUPOLA_VIEWS_MAX; i++)
        images[i].texture = texture;
    return cupola_gl_views_import(house->fixture.gl, images, error);
}

static bool can_be_asked(void)
{
    return context_has(33, NULL, 31, NULL);
}

static void only_colours_are_sampled(void **state)
{
    (void)state;
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_spectator spectator;
    cupola_theatre *theatre = NULL;
    struct house house, own;
    if (!can_be_asked())
        skip();
    house_build(CUPOLA_STORAGE_ATLAS, false, &house);
    house_build(CUPOLA_STORAGE_TEXTURES, false, &own);
    assert_int_equal(cupola_theatre_create(house.fixture.dome, &theatre, NULL), CUPOLA_OK);
    cupola_spectator_at_eye(house.fixture.dome, &spectator);
    for (int k = 0; k < KINDS; k++) {
        const char *word = kinds[k].word;
        GLuint flat = texture_of(GL_TEXTURE_2D, k, SIDE);
        GLuint cube = texture_of(GL_TEXTURE_CUBE_MAP, k, SIDE);
        check_answer(warp(&house, CUPOLA_SOURCE_DOMEMASTER, flat, false, &error), &error,
                     "source: texture ", word);
        check_answer(warp(&house, CUPOLA_SOURCE_CUBE, cube, false, &error), &error,
                     "source: texture ", word);
        check_answer(overlay(&house, flat, false, 0.5, &error), &error, "overlay 0: texture ",
                     word);
        check_answer(import(&own, flat, &error), &error, "view 0: texture ", word);
        check_answer(
            cupola_theatre_draw(theatre, &flat, &spectator, SIDE, SIDE, &house.target, &error),
            &error, "image 0: texture ", word);
        check_answer(cupola_gl_set_gain(house.fixture.gl, 0, flat, &error), &error,
                     "gain of output 0: texture ", word);
        assert_int_equal(cupola_gl_set_gain(house.fixture.gl, 0, 0, NULL), CUPOLA_OK);
        glDeleteTextures(1, &flat);
        glDeleteTextures(1, &cube);
    }
    cupola_theatre_destroy(&theatre);
    house_release(&own);
    house_release(&house);
}

/* By glTexImage2D with levels and without, by a highest level, and all at once. */
static void mipmaps_are_there_or_not_wished_for(void **state)
{
    (void)state;
    struct cupola_error error = {CUPOLA_OK, ""};
    struct house house;
    const char *word = "lacks levels; allowed: ";
    if (!can_be_asked())
        skip();
    house_build(CUPOLA_STORAGE_ATLAS, false, &house);
    GLuint flat = texture_of(GL_TEXTURE_2D, 0, 20), cube = texture_of(GL_TEXTURE_CUBE_MAP, 0, SIDE);
    check_answer(warp(&house, CUPOLA_SOURCE_DOMEMASTER, flat, true, &error), &error, "source",
                 word);
    check_answer(warp(&house, CUPOLA_SOURCE_CUBE, cube, true, &error), &error, "source", word);
    check_answer(overlay(&house, flat, true, 0.5, &error), &error, "overlay 0", word);
    glBindTexture(GL_TEXTURE_2D, flat);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    check_answer(warp(&house, CUPOLA_SOURCE_DOMEMASTER, flat, true, &error), &error, "", NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 1000);
    glGenerateMipmap(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_CUBE_MAP, cube);
    glGenerateMipmap(GL_TEXTURE_CUBE_MAP);
    check_answer(warp(&house, CUPOLA_SOURCE_DOMEMASTER, flat, true, &error), &error, "", NULL);
    check_answer(warp(&house, CUPOLA_SOURCE_CUBE, cube, true, &error), &error, "", NULL);
    check_answer(overlay(&house, flat, true, 0.5, &error), &error, "", NULL);
    glDeleteTextures(1, &flat);
    glGenTextures(1, &flat);
    glBindTexture(GL_TEXTURE_2D, flat);
    if (context_has(42, "GL_ARB_texture_storage", 30, NULL)) {
        glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, SIDE, SIDE);
        check_answer(warp(&house, CUPOLA_SOURCE_DOMEMASTER, flat, true, &error), &error, "", NULL);
    }
    glDeleteTextures(1, &flat);
    glDeleteTextures(1, &cube);
    house_release(&house);
}

static void a_texture_without_texels_is_refused(void **state)
{
    (void)state;
    struct cupola_error error = {CUPOLA_OK, ""};
    struct house house;
    const char *word = "no texels in its base level";
    GLint largest = 0;
    if (!can_be_asked())
        skip();
    house_build(CUPOLA_STORAGE_ATLAS, false, &house);
    GLuint flat = texture_of(GL_TEXTURE_2D, 0, SIDE);
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    const GLint bases[] = {1, 10, largest, 1 << 30};
    glBindTexture(GL_TEXTURE_2D, flat);
    for (int i = 0; i < 4; i++) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, bases[i]);
        check_answer(warp(&house, CUPOLA_SOURCE_DOMEMASTER, flat, false, &error), &error, "source",
                     word);
        check_answer(overlay(&house, flat, false, 0.5, &error), &error, "overlay 0", word);
        check_answer(cupola_gl_set_gain(house.fixture.gl, 0, flat, &error), &error, "gain", word);
    }
    glDeleteTextures(1, &flat);
    house_release(&house);
}

/* The host may give the texture another size while it is set. */
static void a_gain_of_another_size_is_noticed_by_the_warp(void **state)
{
    (void)state;
    struct cupola_error error = {CUPOLA_OK, ""};
    struct house house, leaving;
    if (!can_be_asked())
        skip();
    house_build(CUPOLA_STORAGE_ATLAS, false, &house);
    house_build(CUPOLA_STORAGE_ATLAS, true, &leaving);
    GLuint gain = texture_of(GL_TEXTURE_2D, 0, SIDE), flat = texture_of(GL_TEXTURE_2D, 0, SIDE);
    assert_int_equal(cupola_gl_set_gain(house.fixture.gl, 0, gain, NULL), CUPOLA_OK);
    assert_int_equal(cupola_gl_set_gain(leaving.fixture.gl, 0, gain, NULL), CUPOLA_OK);
    check_answer(warp(&house, CUPOLA_SOURCE_DOMEMASTER, flat, false, &error), &error, "", NULL);
    glBindTexture(GL_TEXTURE_2D, gain);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, SIDE / 2, SIDE, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    check_answer(warp(&house, CUPOLA_SOURCE_DOMEMASTER, flat, false, &error), &error,
                 "gain of output 0 is texture", "16 x 32 texels; allowed: 32 x 32");
    check_answer(overlay(&house, flat, false, 0.5, &error), &error, "gain of output 0 is texture",
                 "16 x 32 texels; allowed: 32 x 32");
    check_answer(warp(&leaving, CUPOLA_SOURCE_DOMEMASTER, flat, false, &error), &error, "", NULL);
    glDeleteTextures(1, &gain);
    glDeleteTextures(1, &flat);
    house_release(&leaving);
    house_release(&house);
}

/* A height that is left to the texture has the same limit as one that is given. */
static void a_picture_is_no_higher_than_may_be(void **state)
{
    (void)state;
    struct cupola_error error = {CUPOLA_OK, ""};
    struct house house;
    if (!can_be_asked())
        skip();
    house_build(CUPOLA_STORAGE_ATLAS, false, &house);
    GLuint tall = texture_of(GL_TEXTURE_2D, 0, 1);
    glBindTexture(GL_TEXTURE_2D, tall);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 400, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    check_answer(overlay(&house, tall, false, 0.5, &error), &error, "overlay 0: height is 0",
                 "1 x 400 texels");
    const double most = 2.0 * atan(tan(radians(75.0)) / 400.0);
    check_answer(overlay(&house, tall, false, 1.001 * most, &error), &error, "overlay 0",
                 "allowed");
    check_answer(overlay(&house, tall, false, 0.999 * most, &error), &error, "", NULL);
    glDeleteTextures(1, &tall);
    house_release(&house);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(only_colours_are_sampled),
        cmocka_unit_test(mipmaps_are_there_or_not_wished_for),
        cmocka_unit_test(a_texture_without_texels_is_refused),
        cmocka_unit_test(a_gain_of_another_size_is_noticed_by_the_warp),
        cmocka_unit_test(a_picture_is_no_higher_than_may_be),
    };
    return run_gpu_group("sampled", tests);
}
