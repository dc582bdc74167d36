/* Existing pictures in the warp: what is refused, and what the host keeps. */
#include <string.h>

#include "group.h"
#include "oracle.h"
#include "painted.h"
#include "picture_fixture.h"
#include "rig_random.h"

static void check_refused(const struct fixture *fixture, const struct cupola_source *source,
                          const struct cupola_target *target, const char *word)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    assert_int_equal(cupola_gl_warp(fixture->gl, 0, source, target, &error), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(error.status, CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    if (!strstr(error.message, word))
        fail_msg("'%s' does not say '%s'", error.message, word);
}

static void what_cannot_be_shown_is_refused(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 16);
    struct cupola_source flat = {.kind = CUPOLA_SOURCE_DOMEMASTER};
    struct cupola_source cube = {.kind = CUPOLA_SOURCE_CUBE}, bad;
    struct fixture fixture;
    picture_fixture_make(&rig, &fixture);
    float *picture = picture_noise(6 * 16 * 16);
    picture_upload(&flat, picture, 16);
    picture_upload(&cube, picture, 16);
    check_refused(&fixture, NULL, NULL, "kind views");
    bad = flat;
    bad.kind = (enum cupola_source_kind)9;
    check_refused(&fixture, &bad, NULL, "is 9; allowed: 0 to 3");
    bad.kind = CUPOLA_SOURCE_CUBE;
    check_refused(&fixture, &bad, NULL, "GL_TEXTURE_CUBE_MAP");
    bad = cube;
    bad.kind = CUPOLA_SOURCE_EQUIRECTANGULAR;
    check_refused(&fixture, &bad, NULL, "GL_TEXTURE_2D");
    bad = (struct cupola_source){.kind = CUPOLA_SOURCE_DOMEMASTER};
    check_refused(&fixture, &bad, NULL, "texture is 0");
    bad.texture = 4711;
    check_refused(&fixture, &bad, NULL, "texture is 4711");
    bad = flat;
    bad.fov_rad = 7.0;
    check_refused(&fixture, &bad, NULL, "field of view is 7 rad");
    bad = flat;
    bad.orientation.roll_rad = (double)NAN;
    check_refused(&fixture, &bad, NULL, "roll");
    bad = flat;
    bad.place = (enum cupola_source_place)5;
    check_refused(&fixture, &bad, NULL, "place of the source is 5");
    struct cupola_target target = {0};
    glGenFramebuffers(1, &target.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, flat.texture, 0);
    check_refused(&fixture, &flat, &target, "color attachment 0");
    glDeleteFramebuffers(1, &target.framebuffer);
    glDeleteTextures(1, &flat.texture);
    glDeleteTextures(1, &cube.texture);
    free(picture);
    fixture_release(&fixture);
}

static void a_gl_for_pictures_has_no_views(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 16);
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_gl_params params = {.sources = 1u << 4};
    struct fixture fixture;
    cupola_gl *none = NULL;
    unsigned int points = 0;
    picture_fixture_make(&rig, &fixture);
    assert_int_equal(cupola_gl_frame_begin(fixture.gl, NULL, &error), CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "without views"));
    assert_int_equal(cupola_gl_atlas(fixture.gl), 0);
    assert_int_equal(cupola_gl_points(fixture.gl, 0, &points, NULL), CUPOLA_OK);
    assert_true(glIsTexture(points));
    assert_int_equal(cupola_gl_create(fixture.plan, &params, &none, &error), CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "sources is 0x10"));
    assert_null(none);
    fixture_release(&fixture);
}

/* What of the host's state only a cube map touches; the test host_state has the rest. */
static void the_host_keeps_its_cube_map(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 16);
    struct cupola_source cube = {.kind = CUPOLA_SOURCE_CUBE}, host = cube, flat = cube;
    struct fixture fixture;
    picture_fixture_make(&rig, &fixture);
    flat.kind = CUPOLA_SOURCE_DOMEMASTER;
    float *picture = picture_noise(6 * 16 * 16);
    picture_upload(&cube, picture, 16);
    picture_upload(&host, picture, 16);
    picture_upload(&flat, picture, 16);
    glBindTexture(GL_TEXTURE_CUBE_MAP, host.texture);
    glBindTexture(GL_TEXTURE_2D, flat.texture);
    bool es = context_is_es(); /* always seamless, without a switch */
    for (int seamless = 0; seamless < (es ? 1 : 2); seamless++) {
        GLint bound = 0, bound_flat = 0, sampler = -1;
        if (!es)
            (seamless ? glEnable : glDisable)(GL_TEXTURE_CUBE_MAP_SEAMLESS);
        free(picture_shown(&fixture, &cube));
        glBindTexture(GL_TEXTURE_2D, flat.texture); /* image_of has one of its own */

        struct cupola_source bad = flat;
        bad.kind = CUPOLA_SOURCE_CUBE;
        check_refused(&fixture, &bad, NULL, "CUBE");
        glGetIntegerv(GL_TEXTURE_BINDING_CUBE_MAP, &bound);
        glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound_flat);
        glGetIntegerv(GL_SAMPLER_BINDING, &sampler);
        assert_int_equal(bound, host.texture);
        assert_int_equal(bound_flat, flat.texture);
        assert_int_equal(sampler, 0);
        if (!es)
            assert_int_equal(glIsEnabled(GL_TEXTURE_CUBE_MAP_SEAMLESS), seamless);
        assert_int_equal(glGetError(), GL_NO_ERROR);
    }
    if (!es)
        glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glDeleteTextures(1, &cube.texture);
    glDeleteTextures(1, &host.texture);
    glDeleteTextures(1, &flat.texture);
    free(picture);
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_cannot_be_shown_is_refused),
        cmocka_unit_test(a_gl_for_pictures_has_no_views),
        cmocka_unit_test(the_host_keeps_its_cube_map),
    };
    return run_gpu_group("picture_manners", tests);
}
