/*
 * Frames that leave the host's state: the pictures are those of frames that keep it, whatever state
 * the host was in before each call. Warps of every source and overlays that keep it do keep it.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "left_house.h"

/* What the host draws into a view, once it has set its state. */
static void draw_view(const struct cupola_gl_view *view, int index)
{
    const struct cupola_rect *rect = &view->rect;
    const GLfloat color[4] = {0.2f * (float)index, 0.5f, 0.7f, 1};
    state_reset();
    glBindFramebuffer(GL_FRAMEBUFFER, view->framebuffer);
    glEnable(GL_SCISSOR_TEST);
    glScissor(rect->x, rect->y, rect->width / 2, rect->height);
    glClearBufferfv(GL_COLOR, 0, color);
}

/* A frame, each call of it in the same bad state; its pictures after every warp, in a row. */
static float *frame(int which, bool kept)
{
    enum { PICTURE = 4 * GUEST_SIZE * GUEST_SIZE, PICTURES = GUEST_PICTURES + 2 };
    const struct cupola_frame wished = {.clear_color = {0.9f, 0.2f, 0.1f, 0.6f}};
    struct cupola_error error = {CUPOLA_OK, ""};
    float *pictures = calloc(PICTURES * PICTURE, sizeof *pictures);
    assert_non_null(pictures);
    int views = cupola_gl_frame_begin(house.gl, &wished, &error);
    for (int i = 0; i < views; i++) {
        struct cupola_gl_view view;
        be_hostile(which);
        check_ok(cupola_gl_view_begin(house.gl, i, &view, &error), "view_begin", &error);
        draw_view(&view, i);
        be_hostile(which);
        check_ok(cupola_gl_view_end(house.gl, &error), "view_end", &error);
        state_reset();
    }
    for (int i = -1; i <= GUEST_PICTURES; i++) {
        struct snapshot before, after;
        be_hostile(which);
        snapshot_take(&before);
        check_ok(i < GUEST_PICTURES ? guest_warp(&house, i, &error)
                                    : guest_overlays(&house, &error),
                 "warp or overlay", &error);
        snapshot_take(&after);
        if (kept)
            assert_int_equal(snapshot_differences(&before, &after, true, "warp or overlay"), 0);
        state_reset();
        float *picture = guest_picture(&house);
        memcpy(pictures + (i + 1) * PICTURE, picture, PICTURE * sizeof *picture);
        free(picture);
    }
    return pictures;
}

static void check_pictures(const struct cupola_gl_params *params, const char *name)
{
    enum { FLOATS = (GUEST_PICTURES + 2) * 4 * GUEST_SIZE * GUEST_SIZE };
    struct cupola_gl_params wished = *params;
    struct cupola_error error = {CUPOLA_OK, ""};
    int tried = 0;
    state_reset();
    check_ok(guest_gl_create(&house, &wished, &error), "create", &error);
    float *kept = frame(-1, true);
    for (int which = 0; which <= HOSTILITIES; which++) {
        float *again = frame(which, true);
        assert_memory_equal(again, kept, FLOATS * sizeof *again);
        free(again);
    }
    cupola_gl_destroy(&house.gl);
    wished.leaves_state = true;
    check_ok(guest_gl_create(&house, &wished, &error), "create", &error);
    for (int which = -1; which <= HOSTILITIES; which++) {
        float *left = frame(which, false);
        tried++;
        if (memcmp(left, kept, FLOATS * sizeof *left) != 0)
            fail_msg("%s: other pictures after '%s'", name,
                     which < 0              ? "nothing"
                     : which == HOSTILITIES ? "everything"
                                            : hostilities[which].name);
        free(left);
    }
    int differing = 0; /* the control: the picture has something to lose */
    for (int i = 4; i < FLOATS; i++)
        differing += kept[i] != kept[i - 4];
    check_at_least(differing, 500);
    printf("  %s: %d hosts\n", name, tried);
    free(kept);
    cupola_gl_destroy(&house.gl);
}

static void pictures_are_those_of_frames_that_keep_the_state(void **state)
{
    const struct cupola_gl_params plain = {.table = CUPOLA_TABLE_SINES};
    const struct cupola_gl_params rich = {
        .format = CUPOLA_FORMAT_SRGB8, .depth = CUPOLA_DEPTH_24_STENCIL_8, .samples = 2};
    (void)state;
    check_pictures(&plain, "plain");
    check_pictures(&rich, "sRGB, stencil, several samples");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_are_those_of_frames_that_keep_the_state),
    };
    return cmocka_run_group_tests_name("state_left", tests, open_house, close_house);
}
