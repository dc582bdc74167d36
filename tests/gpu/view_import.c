/*
 * The host's own textures as views: any size, any rectangle, any layer, against the warp in C from
 * the same texels.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "group.h"
#include "rig_random.h"
#include "view_textures.h"
#include "worse.h"

enum { SIDE = 64 };

/* Off axis, so that no ray falls on the border of two views. */
static void theatre_make(int views, enum cupola_table table, enum cupola_storage storage,
                         struct fixture *fixture)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 200.0, SIDE);
    const struct cupola_plan_params params = {.views = views};
    const struct cupola_gl_params gl_params = {.table = table, .storage = storage};
    rig.outputs[0].circle = (struct cupola_circle){31.3, 32.9, 30.7};
    rig.screen.radius_m = 1.0;
    rig.eye_m[0] = 0.07;
    fixture_make(&rig, &params, &gl_params, fixture);
}

static void import(const struct fixture *fixture, const struct view_textures *textures)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    if (cupola_gl_views_import(fixture->gl, textures->images, &error) < 0)
        fail_msg("%s", error.message);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static double error_of(const struct fixture *fixture, const struct view_textures *textures)
{
    float *shown = fixture_warp(fixture, 0), expected[4 * SIDE * SIDE];
    double worst = 0.0;
    assert_int_equal(cupola_reference_warp(textures->plan, 0, textures->texels, NULL, expected),
                     CUPOLA_OK);
    for (int k = 0; k < 4 * SIDE * SIDE; k++)
        worst = worse_of(worst, fabs((double)shown[k] - (double)expected[k]));
    free(shown);
    return worst;
}

/* Without float targets, half a step of 8 bits. sRGB texels are mixed by weights of 8 bits. */
static double bar_of(GLenum format)
{
    return (format == GL_RGBA16F ? 2e-5 : 2e-3) + (context_has_floats() ? 0.0 : 0.55 / 255.0);
}

static void check_wish(int views, enum cupola_table table, const struct view_wish *wish)
{
    struct fixture fixture;
    struct view_textures textures, wrong;
    theatre_make(views, table, wish->storage, &fixture);
    view_textures_make(fixture.plan, wish, &textures);
    import(&fixture, &textures);
    double error = error_of(&fixture, &textures), bar = bar_of(wish->format);
    printf("%d views, storage %d, table %s, x %g, format 0x%x: within %.2g\n",
           cupola_plan_view_count(textures.plan), (int)wish->storage, cupola_table_name((int)table),
           wish->larger, wish->format, error);
    check_at_most(error, bar);
    if (views)
        assert_int_equal(cupola_plan_view_count(textures.plan), views);

    wrong = textures; /* one view a texel off; two views swapped */
    if (wish->whole)
        wrong.images[1].rect =
            (struct cupola_rect){1, 0, textures.width[1] - 1, textures.height[1]};
    else
        wrong.images[1].rect.x++;
    import(&fixture, &wrong);
    check_at_least(error_of(&fixture, &textures), 2.0 * bar);
    wrong = textures;
    wrong.images[0] = textures.images[1];
    wrong.images[1] = textures.images[0];
    import(&fixture, &wrong);
    check_at_least(error_of(&fixture, &textures), 2.0 * bar);
    view_textures_release(&textures);
    fixture_release(&fixture);
}

static void views_of_any_size_are_shown_as_they_lie(void **state)
{
    (void)state;
    for (int storage = CUPOLA_STORAGE_TEXTURES; storage <= CUPOLA_STORAGE_LAYERS; storage++)
        for (int number = 0; number < 4; number++) {
            static const int views[4] = {4, 0, 8, 5};
            static const enum cupola_table tables[4] = {CUPOLA_TABLE_POINTS, CUPOLA_TABLE_NONE,
                                                        CUPOLA_TABLE_ANGLES, CUPOLA_TABLE_SINES};
            const struct view_wish wish = {.storage = (enum cupola_storage)storage,
                                           .whole = number % 2,
                                           .larger = number == 2 ? 0.7 : 1.3,
                                           .format = number == 3 ? GL_SRGB8_ALPHA8 : GL_RGBA16F};
            check_wish(views[number], tables[number], &wish);
        }
}

static void each_frame_may_bring_others(void **state)
{
    (void)state;
    for (int storage = CUPOLA_STORAGE_TEXTURES; storage <= CUPOLA_STORAGE_LAYERS; storage++) {
        struct view_wish wish = {(enum cupola_storage)storage, false, 1.1, GL_RGBA16F, 0.0};
        struct fixture fixture;
        struct view_textures textures[2];
        theatre_make(4, CUPOLA_TABLE_POINTS, wish.storage, &fixture);
        for (int i = 0; i < 2; i++) {
            wish.larger += 0.3 * i;
            wish.phase = i;
            view_textures_make(fixture.plan, &wish, &textures[i]);
        }
        for (int frame = 0; frame < 6; frame++) {
            import(&fixture, &textures[frame % 2]);
            check_at_most(error_of(&fixture, &textures[frame % 2]), bar_of(GL_RGBA16F));
            check_at_least(error_of(&fixture, &textures[1 - frame % 2]), 0.1);
        }
        view_textures_release(&textures[0]);
        view_textures_release(&textures[1]);
        fixture_release(&fixture);
    }
}

static void expect(const struct fixture *fixture, const struct view_textures *textures, int view,
                   struct cupola_view_image bad, const char *word)
{
    struct cupola_view_image images[CUPOLA_VIEWS_MAX];
    struct cupola_error error = {CUPOLA_OK, ""};
    memcpy(images, textures->images, sizeof images);
    images[view] = bad;
    assert_int_equal(cupola_gl_views_import(fixture->gl, images, &error), CUPOLA_ERROR_ARGUMENT);
    if (!strstr(error.message, word))
        fail_msg("'%s' does not say '%s'", error.message, word);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void check_bad_images(const struct fixture *fixture, const struct view_textures *textures,
                             bool layers, GLuint of_other_kind)
{
    const struct cupola_view_image good = textures->images[2];
    bool sizes_known = !context_is_es() || context_has(0, NULL, 31, NULL);
    struct cupola_view_image bad = good;
    bad.texture = 0;
    expect(fixture, textures, 2, bad,
           "texture of view 2 is 0; allowed: the name of a GL_TEXTURE_2D");
    bad.texture = 4711;
    expect(fixture, textures, 2, bad, "texture of view 2 is 4711");
    bad.texture = of_other_kind;
    expect(fixture, textures, 2, bad, "texture of view 2 is ");
    bad = good;
    bad.layer = layers ? -1 : 1;
    expect(fixture, textures, 2, bad,
           layers ? "layer of view 2 is -1" : "allowed for a GL_TEXTURE_2D: 0");
    bad.layer = layers ? 1 << 20 : -1;
    expect(fixture, textures, 2, bad, "layer of view 2 is ");
    static const struct cupola_rect rects[] = {
        {0, 0, 8, 0}, {0, 0, 0, 8}, {0, 0, -8, 8}, {-1, 0, 8, 8},         {0, -1, 8, 8},
        {5, 0, 0, 0}, {0, 5, 0, 0}, {0, 0, 8, -8}, {2147483647, 0, 8, 8}, {4, 4, 8, 2147483647},
    };
    for (size_t i = 0; i < sizeof rects / sizeof rects[0]; i++) {
        bad = good;
        bad.rect = rects[i];
        expect(fixture, textures, 2, bad, "rectangle of view 2 is ");
    }
    bad.rect = (struct cupola_rect){1, 0, textures->width[2], textures->height[2]};
    if (sizes_known)
        expect(fixture, textures, 2, bad, "allowed: inside of the texture's ");
    bad = good;
    bad.layer = layers ? cupola_plan_view_count(textures->plan) + 1 : 0;
    if (sizes_known && layers)
        expect(fixture, textures, 2, bad, "allowed: 0 to ");
}

static void what_is_no_view_is_refused(void **state)
{
    (void)state;
    for (int storage = CUPOLA_STORAGE_TEXTURES; storage <= CUPOLA_STORAGE_LAYERS; storage++) {
        const struct view_wish wish = {(enum cupola_storage)storage, false, 1.0, GL_RGBA16F, 0.0};
        const struct view_wish other = {(enum cupola_storage)(3 - storage), false, 1.0, GL_RGBA16F,
                                        0.0};
        struct fixture fixture;
        struct view_textures textures, others, more;
        struct cupola_error error = {CUPOLA_OK, ""};
        theatre_make(4, CUPOLA_TABLE_POINTS, wish.storage, &fixture);
        view_textures_make(fixture.plan, &wish, &textures);
        view_textures_make(fixture.plan, &wish, &more);
        view_textures_make(fixture.plan, &other, &others);
        import(&fixture, &textures);
        check_bad_images(&fixture, &textures, storage == CUPOLA_STORAGE_LAYERS, others.names[0]);
        if (storage == CUPOLA_STORAGE_LAYERS)
            expect(&fixture, &textures, 2, more.images[2], "layers of one GL_TEXTURE_2D_ARRAY");
        assert_int_equal(cupola_gl_views_import(fixture.gl, NULL, &error), CUPOLA_ERROR_ARGUMENT);
        assert_int_equal(cupola_gl_views_import(NULL, textures.images, NULL),
                         CUPOLA_ERROR_ARGUMENT);
        check_at_most(error_of(&fixture, &textures), bar_of(GL_RGBA16F)); /* as it was before */
        view_textures_release(&textures);
        assert_int_equal(cupola_gl_warp(fixture.gl, 0, NULL, NULL, &error), CUPOLA_ERROR_ARGUMENT);
        assert_non_null(strstr(error.message, "texture of view 0 is "));
        view_textures_release(&others);
        view_textures_release(&more);
        fixture_release(&fixture);
    }
}

/* A target of which a view is the colour. */
static void a_view_is_no_target(void **state)
{
    (void)state;
    for (int storage = CUPOLA_STORAGE_TEXTURES; storage <= CUPOLA_STORAGE_LAYERS; storage++) {
        const struct view_wish wish = {(enum cupola_storage)storage, false, 1.0, GL_SRGB8_ALPHA8,
                                       0.0};
        struct fixture fixture;
        struct view_textures textures;
        struct cupola_target target = {0, 0, 0};
        struct cupola_error error = {CUPOLA_OK, ""};
        theatre_make(4, CUPOLA_TABLE_POINTS, wish.storage, &fixture);
        view_textures_make(fixture.plan, &wish, &textures);
        import(&fixture, &textures);
        glGenFramebuffers(1, &target.framebuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
        if (storage == CUPOLA_STORAGE_LAYERS)
            glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, textures.names[0], 0,
                                      1);
        else
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                                   textures.names[3], 0);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        assert_int_equal(cupola_gl_warp(fixture.gl, 0, NULL, &target, &error),
                         CUPOLA_ERROR_ARGUMENT);
        assert_non_null(strstr(error.message, "which is sampled, as its color attachment 0"));
        glDeleteFramebuffers(1, &target.framebuffer);
        view_textures_release(&textures);
        fixture_release(&fixture);
    }
}

static void a_gl_for_the_host_s_views_has_none_of_its_own(void **state)
{
    (void)state;
    struct fixture fixture, own;
    struct cupola_error error = {CUPOLA_OK, ""};
    const struct cupola_view_image images[CUPOLA_VIEWS_MAX] = {{0}};
    struct cupola_gl_params bad = {.storage = CUPOLA_STORAGE_LAYERS,
                                   .table = CUPOLA_TABLE_COORDINATES};
    cupola_gl *none = NULL;
    theatre_make(4, CUPOLA_TABLE_NONE, CUPOLA_STORAGE_TEXTURES, &fixture);
    theatre_make(4, CUPOLA_TABLE_NONE, CUPOLA_STORAGE_ATLAS, &own);
    assert_int_equal(cupola_gl_atlas(fixture.gl), 0);
    assert_int_equal(cupola_gl_frame_begin(fixture.gl, NULL, &error), CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "cupola_gl_views_import"));
    assert_int_equal(cupola_gl_view_begin(fixture.gl, 0, NULL, NULL), CUPOLA_ERROR_ORDER);
    assert_int_equal(cupola_gl_warp(fixture.gl, 0, NULL, NULL, &error), CUPOLA_ERROR_ORDER);
    assert_non_null(strstr(error.message, "before the host's views were imported"));
    assert_int_equal(cupola_gl_views_import(own.gl, images, &error), CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "storage textures or layers"));
    assert_int_equal(cupola_gl_create(own.plan, &bad, &none, &error), CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "table stage is coordinates"));
    bad = (struct cupola_gl_params){.storage = (enum cupola_storage)3};
    assert_int_equal(cupola_gl_create(own.plan, &bad, &none, &error), CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "storage is 3; allowed: 0 to 2"));
    assert_null(none);
    fixture_release(&own);
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(views_of_any_size_are_shown_as_they_lie),
        cmocka_unit_test(each_frame_may_bring_others),
        cmocka_unit_test(what_is_no_view_is_refused),
        cmocka_unit_test(a_view_is_no_target),
        cmocka_unit_test(a_gl_for_the_host_s_views_has_none_of_its_own),
    };
    return run_gpu_group("view_import", tests);
}
