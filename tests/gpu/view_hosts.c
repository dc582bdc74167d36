/*
 * What hosts do between view_begin and view_end: they delete what was bound before, they change
 * what the view's framebuffer is read from, and they begin a view once more.
 */
#include <stdio.h>
#include <stdlib.h>

#include "group.h"
#include "rig_random.h"
#include "triangles.h"

enum { SIZE = 48 };

static void make(struct fixture *fixture, int samples)
{
    const struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 90.0, SIZE);
    const struct cupola_gl_params params = {.samples = samples, .table = CUPOLA_TABLE_NONE};
    fixture_make(&rig, NULL, &params, fixture);
    assert_true(cupola_gl_frame_begin(fixture->gl, NULL, NULL) > 0);
}

static GLint binding(GLenum name)
{
    GLint value = -1;
    glGetIntegerv(name, &value);
    return value;
}

/* Which of the two, bound for drawing and for reading, the host deletes; what is bound then. */
static void check_deleted(int samples, bool draw, bool read)
{
    struct fixture fixture;
    GLuint own[2];
    make(&fixture, samples);
    glGenFramebuffers(2, own);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, own[0]);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, own[1]);
    assert_int_equal(cupola_gl_view_begin(fixture.gl, 0, NULL, NULL), CUPOLA_OK);
    if (draw)
        glDeleteFramebuffers(1, &own[0]);
    if (read)
        glDeleteFramebuffers(1, &own[1]);
    assert_int_equal(cupola_gl_view_end(fixture.gl, NULL), CUPOLA_OK);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    assert_int_equal(binding(GL_DRAW_FRAMEBUFFER_BINDING), draw ? 0 : own[0]);
    assert_int_equal(binding(GL_READ_FRAMEBUFFER_BINDING), read ? 0 : own[1]);
    assert_int_equal(glIsFramebuffer(own[0]), !draw);
    assert_int_equal(glIsFramebuffer(own[1]), !read);
    glDeleteFramebuffers(2, own);
    fixture_release(&fixture);
}

static void a_framebuffer_deleted_within_a_view_is_bound_no_more(void **state)
{
    (void)state;
    for (int samples = 1; samples <= 2; samples++)
        for (int which = 0; which < 4; which++)
            check_deleted(samples, which & 1, which & 2);
}

/* The view's middle has this colour. */
static void check_view(struct fixture *fixture, int view, const GLfloat color[4])
{
    const struct cupola_rect *rect = &cupola_plan_view(fixture->plan, view)->rect;
    int x = rect->x + rect->width / 2, y = rect->y + rect->height / 2;
    int width = cupola_plan_report(fixture->plan)->atlas_width_px;
    float *atlas = fixture_atlas(fixture);
    for (int c = 0; c < 4; c++)
        check_near(atlas[4 * (y * width + x) + c], color[c], 1e-6);
    free(atlas);
}

/* A wall over all of the view. */
static void draw_wall(struct fixture *fixture, const struct triangles *triangles, int view,
                      double distance, const GLfloat color[4])
{
    const double nearness[3] = {1 / distance, 0, 0};
    struct cupola_gl_view begun;
    float points[6][3];
    plane_over_view(fixture->plan, view, nearness, points);
    assert_int_equal(cupola_gl_view_begin(fixture->gl, view, &begun, NULL), CUPOLA_OK);
    glEnable(GL_DEPTH_TEST);
    triangles_draw(triangles, &begun.camera, color, points, 6);
    glDisable(GL_DEPTH_TEST);
    assert_int_equal(cupola_gl_view_end(fixture->gl, NULL), CUPOLA_OK);
}

static void a_view_that_begins_again_is_cleared_alone(void **state)
{
    static const GLfloat red[] = {1, 0, 0, 1}, green[] = {0, 1, 0, 1}, none[] = {0, 0, 0, 0};
    struct fixture fixture;
    (void)state;
    make(&fixture, 1);
    const struct triangles triangles = triangles_create();
    for (int frame = 0; frame < 2; frame++) {
        assert_true(cupola_gl_frame_begin(fixture.gl, NULL, NULL) > 1);
        draw_wall(&fixture, &triangles, 1, 3, green);
        draw_wall(&fixture, &triangles, 0, 2, red);
        check_view(&fixture, 0, red);
        check_view(&fixture, 1, green);
        draw_wall(&fixture, &triangles, 0, 4, green); /* behind what was there */
        check_view(&fixture, 0, green);
        assert_int_equal(cupola_gl_view_begin(fixture.gl, 1, NULL, NULL), CUPOLA_OK);
        assert_int_equal(cupola_gl_view_end(fixture.gl, NULL), CUPOLA_OK);
        check_view(&fixture, 0, green);
        check_view(&fixture, 1, none);
    }
    triangles_release(&triangles);
    fixture_release(&fixture);
}

static void a_view_is_resolved_whatever_the_host_reads(void **state)
{
    static const GLenum buffers[] = {GL_COLOR_ATTACHMENT0, GL_NONE, GL_COLOR_ATTACHMENT1};
    const GLfloat colors[3][4] = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
    struct fixture fixture;
    (void)state;
    make(&fixture, 2);
    for (int i = 0; i < 3; i++) {
        assert_int_equal(cupola_gl_view_begin(fixture.gl, 0, NULL, NULL), CUPOLA_OK);
        glClearBufferfv(GL_COLOR, 0, colors[i]);
        glReadBuffer(buffers[i]);
        assert_int_equal(cupola_gl_view_end(fixture.gl, NULL), CUPOLA_OK);
        assert_int_equal(glGetError(), GL_NO_ERROR);
        check_view(&fixture, 0, colors[i]);
    }
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_framebuffer_deleted_within_a_view_is_bound_no_more),
        cmocka_unit_test(a_view_that_begins_again_is_cleared_alone),
        cmocka_unit_test(a_view_is_resolved_whatever_the_host_reads),
    };
    return run_gpu_group("view_hosts", tests);
}
