/*
 * Masks and their hosts: the same whatever state a host is in as a view begins, and as good in a
 * host's own textures, of any size.
 */
#include <stdio.h>

#include "left_house.h"
#include "mask_left.h"
#include "rig_random.h"

enum { SIZE = 64 };

static struct triangles triangles;

static void make(struct fixture *fixture, const struct cupola_gl_params *params)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 150.0, SIZE);
    rig.eye_m[0] = 0.2;
    fixture_make(&rig, NULL, params, fixture);
}

/* Feedback, too, where the state is asked for and so can be paused. */
static void be_bad(int which, bool kept)
{
    for (int i = 0; i < HOSTILITIES; i++)
        if (kept && which == i && hostilities[i].set == set_feedback &&
            context_has(hostilities[i].gl, hostilities[i].gl_extension, hostilities[i].es,
                        hostilities[i].es_extension))
            set_feedback();
    be_hostile(which);
}

/* Every view begun in a bad state, and drawn in a good one. */
static int left_of(const struct fixture *fixture, int which, bool kept,
                   const struct cupola_depth *depth, enum cupola_mask mask)
{
    const struct cupola_frame frame = {.depth = *depth};
    int views = cupola_gl_frame_begin(fixture->gl, &frame, NULL);
    for (int i = 0; i < views; i++) {
        struct cupola_gl_view view;
        be_bad(which, kept);
        assert_int_equal(cupola_gl_view_begin(fixture->gl, i, &view, NULL), CUPOLA_OK);
        state_reset();
        glBindFramebuffer(GL_FRAMEBUFFER, view.framebuffer);
        glViewport(view.rect.x, view.rect.y, view.rect.width, view.rect.height);
        draw_red(&triangles, fixture->plan, i, depth, mask);
        assert_int_equal(cupola_gl_view_end(fixture->gl, NULL), CUPOLA_OK);
        state_reset();
    }
    float *atlas = fixture_atlas(fixture);
    struct texels_left count = texels_count(fixture->plan, atlas, false);
    free(atlas);
    assert_int_equal(count.missing, 0);
    return count.left;
}

static void masks_are_the_same_whatever_state_a_host_is_in(void **state)
{
    (void)state;
    for (int way = 0; way < 6; way++) {
        enum cupola_mask mask = way % 2 ? CUPOLA_MASK_STENCIL : CUPOLA_MASK_DEPTH;
        const struct cupola_depth depth = {.reversed = way / 2 == 1};
        const struct cupola_gl_params params = {.depth = CUPOLA_DEPTH_24_STENCIL_8,
                                                .mask = mask,
                                                .table = CUPOLA_TABLE_NONE,
                                                .leaves_state = way / 2 == 2};
        struct fixture fixture;
        state_reset();
        make(&fixture, &params);
        int left = left_of(&fixture, -1, false, &depth, mask);
        const struct cupola_plan_report *report = cupola_plan_report(fixture.plan);
        check_at_most(left, 0.9 * report->texels_shaded_per_pixel * report->pixels);
        for (int which = 0; which <= HOSTILITIES; which++)
            assert_int_equal(left_of(&fixture, which, !params.leaves_state, &depth, mask), left);
        fixture_release(&fixture);
    }
}

/* ---- textures of the host's ---- */

struct canvas {
    GLuint framebuffer, texture, depth;
    int width, height;
};

static struct canvas canvas_create(int width, int height)
{
    struct canvas canvas = {.width = width, .height = height};
    glGenFramebuffers(1, &canvas.framebuffer);
    glGenTextures(1, &canvas.texture);
    glGenRenderbuffers(1, &canvas.depth);
    glBindTexture(GL_TEXTURE_2D, canvas.texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glBindRenderbuffer(GL_RENDERBUFFER, canvas.depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, canvas.texture, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                              canvas.depth);
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    return canvas;
}

static void canvas_release(const struct canvas *canvas)
{
    glDeleteFramebuffers(1, &canvas->framebuffer);
    glDeleteTextures(1, &canvas->texture);
    glDeleteRenderbuffers(1, &canvas->depth);
}

static void canvas_clear(bool reversed)
{
    const GLfloat black[4] = {0, 0, 0, 0};
    glClearBufferfv(GL_COLOR, 0, black);
    glClearBufferfi(GL_DEPTH_STENCIL, 0, reversed ? 0 : 1, 0);
}

/* Needed texels of a view that are not red in the host's rectangle, and all that are. */
static struct texels_left compare(const struct fixture *fixture, int view,
                                  const unsigned char *needed, const struct canvas *canvas,
                                  const struct cupola_rect *at)
{
    const struct cupola_rect *rect = &cupola_plan_view(fixture->plan, view)->rect;
    int width = cupola_plan_report(fixture->plan)->atlas_width_px;
    struct texels_left count = {0, 0, 0};
    float *texels = texture_read(canvas->texture, canvas->width, canvas->height);
    for (int i = 0; i < at->width * at->height; i++) {
        int x = i % at->width, y = i / at->width;
        int u = (int)((x + 0.5) * rect->width / at->width);
        int v = (int)((y + 0.5) * rect->height / at->height);
        bool red = texels[4 * ((at->y + y) * canvas->width + at->x + x)] > 0.999f;
        bool wanted = needed[(rect->y + v) * width + rect->x + u];
        count.needed += wanted;
        count.left += red;
        count.missing += wanted && !red;
    }
    free(texels);
    return count;
}

/* Where a host may have a view: a rectangle of its own, of a size in quarters of the plan's. */
struct place {
    int x, y, quarters;
    bool given;
};

static void check_place(const struct fixture *fixture, const unsigned char *needed, int view,
                        const struct place *place, enum cupola_mask mask, bool reversed)
{
    const struct cupola_rect *rect = &cupola_plan_view(fixture->plan, view)->rect;
    const struct cupola_rect at = {place->x, place->y, rect->width * place->quarters / 4,
                                   rect->height * place->quarters / 4};
    const struct cupola_depth depth = {.reversed = reversed};
    struct canvas canvas = canvas_create(at.x + at.width + 3, at.y + at.height + 3);
    struct cupola_error error = {CUPOLA_OK, ""};
    struct snapshot before, after;
    canvas_clear(reversed);
    snapshot_take(&before);
    check_ok(cupola_gl_mask(fixture->gl, view, mask, place->given ? &at : NULL, reversed, &error),
             "mask", &error);
    snapshot_take(&after);
    assert_int_equal(snapshot_differences(&before, &after, true, "mask"), 0);
    glViewport(at.x, at.y, at.width, at.height);
    draw_red(&triangles, fixture->plan, view, &depth, mask);
    struct texels_left count = compare(fixture, view, needed, &canvas, &at);
    assert_int_equal(count.missing, 0);
    check_at_most(count.left, 0.95 * at.width * at.height);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    canvas_release(&canvas);
    state_reset();
}

static void a_hosts_textures_are_masked_wherever_its_views_are(void **state)
{
    static const struct place places[] = {
        {0, 0, 4, false}, {5, 9, 4, true}, {2, 3, 7, true}, {1, 0, 3, true}};
    (void)state;
    for (int i = 0; i < 4; i++) {
        struct fixture fixture;
        state_reset();
        make(&fixture, &(struct cupola_gl_params){.storage = CUPOLA_STORAGE_TEXTURES});
        unsigned char *needed = texels_needed(fixture.plan);
        for (int view = 0; view < cupola_plan_view_count(fixture.plan); view++)
            for (int way = 0; way < 3; way++)
                check_place(&fixture, needed, view, &places[i],
                            way == 1 ? CUPOLA_MASK_STENCIL : CUPOLA_MASK_DEPTH, way == 2);
        free(needed);
        fixture_release(&fixture);
    }
}

static void refused(const struct fixture *fixture, int view, int mask,
                    const struct cupola_rect *rect, int status, const char *part)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    assert_int_equal(cupola_gl_mask(fixture ? fixture->gl : NULL, view, (enum cupola_mask)mask,
                                    rect, false, &error),
                     status);
    if (!strstr(error.message, part))
        fail_msg("'%s' does not say '%s'", error.message, part);
}

static void what_cannot_be_masked_is_refused(void **state)
{
    const struct cupola_rect far = {1 << 25, 0, 64, 64}, small = {0, 0, 3, 64};
    const int argument = CUPOLA_ERROR_ARGUMENT;
    struct fixture fixture;
    struct canvas canvas;
    (void)state;
    state_reset();
    refused(NULL, 0, CUPOLA_MASK_DEPTH, NULL, argument, "gl is NULL");
    make(&fixture, NULL);
    refused(&fixture, 0, CUPOLA_MASK_DEPTH, NULL, argument, "views of its own");
    fixture_release(&fixture);
    make(&fixture,
         &(struct cupola_gl_params){.storage = CUPOLA_STORAGE_LAYERS, .mask = CUPOLA_MASK_NONE});
    refused(&fixture, 0, CUPOLA_MASK_DEPTH, NULL, argument, "without masks");
    fixture_release(&fixture);
    make(&fixture, &(struct cupola_gl_params){.storage = CUPOLA_STORAGE_LAYERS});
    refused(&fixture, 99, CUPOLA_MASK_DEPTH, NULL, argument, "view is 99");
    refused(&fixture, 0, CUPOLA_MASK_AUTO, NULL, argument, "mask is 0");
    refused(&fixture, 0, CUPOLA_MASK_DEPTH, &far, argument, "33554432");
    refused(&fixture, 0, CUPOLA_MASK_DEPTH, &small, argument, "in 3 x 64");
    canvas = canvas_create(8, 8);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 0, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, 0);
    refused(&fixture, 0, CUPOLA_MASK_DEPTH, NULL, CUPOLA_ERROR_GL, "not complete");
    canvas_release(&canvas);
    fixture_release(&fixture);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void masks_that_the_views_cannot_have_are_refused(void **state)
{
    static const struct {
        struct cupola_gl_params params;
        const char *part;
    } wrong[] = {
        {{.mask = (enum cupola_mask)4}, "mask is 4"},
        {{.mask = (enum cupola_mask) - 1}, "mask is -1"},
        {{.mask = CUPOLA_MASK_DEPTH, .depth = CUPOLA_DEPTH_NONE}, "mask is depth"},
        {{.mask = CUPOLA_MASK_STENCIL, .depth = CUPOLA_DEPTH_24}, "mask is stencil"},
        {{.mask = CUPOLA_MASK_STENCIL, .depth = CUPOLA_DEPTH_NONE}, "mask is stencil"},
    };
    struct fixture fixture;
    (void)state;
    make(&fixture, NULL);
    for (int i = 0; i < 5; i++) {
        struct cupola_error error = {CUPOLA_OK, ""};
        cupola_gl *gl = NULL;
        assert_int_equal(cupola_gl_create(fixture.plan, &wrong[i].params, &gl, &error),
                         CUPOLA_ERROR_ARGUMENT);
        assert_null(gl);
        if (!strstr(error.message, wrong[i].part))
            fail_msg("'%s' does not say '%s'", error.message, wrong[i].part);
    }
    fixture_release(&fixture);
}

static int open_all(void **state)
{
    int status = open_house(state);
    triangles = triangles_create();
    return status;
}

static int close_all(void **state)
{
    triangles_release(&triangles);
    return close_house(state);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(masks_are_the_same_whatever_state_a_host_is_in),
        cmocka_unit_test(a_hosts_textures_are_masked_wherever_its_views_are),
        cmocka_unit_test(what_cannot_be_masked_is_refused),
        cmocka_unit_test(masks_that_the_views_cannot_have_are_refused),
    };
    return cmocka_run_group_tests_name("mask_hosts", tests, open_all, close_all);
}
