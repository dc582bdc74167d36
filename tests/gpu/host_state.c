/*
 * The hostile host: whatever GL state a host leaves, Cupola's calls leave it as it was and give the
 * same pixels. Each way of being hostile is also put before the same kind of work done without any
 * care, so that it is seen to matter.
 */
#include <stdio.h>
#include <stdlib.h>

#include "check.h"
#include "context.h"
#include "fixture.h"
#include "host_objects.h"
#include "host_results.h"
#include "hostilities.h"
#include "rig_random.h"

enum { WIDTH = 48, HEIGHT = 40 };

static struct snapshot clean;

static void be_clean(void)
{
    struct snapshot now;
    state_reset();
    snapshot_take(&now);
    assert_int_equal(snapshot_differences(&clean, &now, true, "state_reset"), 0);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static int setup(void **state)
{
    (void)state;
    context_open();
    state_reset();
    objects_create();
    sampled_create();
    state_reset();
    snapshot_take(&clean);
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    fixture_release(&sampled);
    objects_release();
    context_close();
    return 0;
}

/* The host under test: what it does to the state, and how the state was then. */
struct host {
    const struct hostility *hostility; /* NULL: all of `count` at once */
    int count;
    struct snapshot before;
};

static bool hostility_exists(const struct hostility *hostility)
{
    return context_has(hostility->gl, hostility->gl_extension, hostility->es,
                       hostility->es_extension);
}

static void be_hostile(struct host *host)
{
    if (host->hostility)
        host->hostility->set();
    for (int i = 0; !host->hostility && i < host->count; i++)
        if (hostility_exists(&hostilities[i]))
            hostilities[i].set();
    while (glGetError() != GL_NO_ERROR) /* not all of them go together */
        ;
    snapshot_take(&host->before);
}

/* After each call. */
static void check_host(const struct host *host, bool also_target, int status, const char *call)
{
    struct snapshot now;
    GLenum failure = glGetError();
    char where[128];
    snprintf(where, sizeof where, "%s after %s",
             host->hostility ? host->hostility->name : "everything", call);
    snapshot_take(&now);
    if (status < 0 || failure != GL_NO_ERROR)
        fail_msg("%s: status %d, GL error 0x%x", where, status, failure);
    assert_int_equal(snapshot_differences(&host->before, &now, also_target, where), 0);
}

static cupola_plan *two_outputs(cupola_dome **dome)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 150.0, WIDTH);
    cupola_plan *plan = NULL;
    rig.output_count = 2;
    rig.outputs[0].height_px = HEIGHT;
    rig.outputs[1] = rig.outputs[0];
    rig.outputs[1].aim.yaw_rad = 0.3;
    assert_int_equal(cupola_dome_create(&rig, dome, NULL), CUPOLA_OK);
    assert_int_equal(cupola_plan_create(*dome, NULL, &plan, NULL), CUPOLA_OK);
    return plan;
}

/* In a clean state: a pattern of clears in every view, depth included. */
static unsigned int paint_views(cupola_gl *gl)
{
    struct cupola_gl_view view = {0};
    int views = cupola_gl_frame_begin(gl, NULL, NULL);
    for (int i = 0; i < views; i++) {
        assert_int_equal(cupola_gl_view_begin(gl, i, &view, NULL), CUPOLA_OK);
        const struct cupola_rect *rect = &view.rect;
        for (int part = 0; part < 9; part++) {
            glScissor(rect->x + part % 3 * rect->width / 3, rect->y + part / 3 * rect->height / 3,
                      rect->width / 3 + 1, rect->height / 3 + 1);
            glClearColor(0.1f * (float)part, 0.9f - 0.2f * (float)i, 0.3f, 0.4f);
            context_clear_depth(0.5);
            glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        }
        assert_int_equal(cupola_gl_view_end(gl, NULL), CUPOLA_OK);
    }
    return view.framebuffer;
}

static void begin_views(cupola_gl *gl, const struct host *host)
{
    const struct cupola_frame frame = {.clear_color = {0.3f, 0.6f, 0.9f, 0.7f}};
    int views = cupola_gl_frame_begin(gl, &frame, NULL);
    check_host(host, true, views, "frame_begin");
    for (int i = 0; i < views; i++) {
        struct cupola_gl_view view;
        GLfloat viewport[4];
        GLint framebuffer = 0;
        check_host(host, false, cupola_gl_view_begin(gl, i, &view, NULL), "view_begin");
        glGetFloatv(GL_VIEWPORT, viewport);
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
        assert_int_equal(framebuffer, view.framebuffer);
        assert_int_equal((int)viewport[0], view.rect.x);
        assert_int_equal((int)viewport[3], view.rect.height);
        check_host(host, true, cupola_gl_view_end(gl, NULL), "view_end");
    }
}

/* As check_host, but viewports and scissor rectangles of all views are the pass's by now. */
static void check_host_in_pass(const struct host *host, int views, int status)
{
    struct host inside = *host;
    struct snapshot now;
    snapshot_take(&now);
    for (int i = 0; i < now.count; i++) {
        GLenum name = now.entries[i].name;
        int at = now.entries[i].index / (name == GL_SCISSOR_TEST ? 1 : 4);
        bool area = name == GL_VIEWPORT || name == GL_SCISSOR_BOX || name == GL_SCISSOR_TEST;
        if (area && at < views)
            inside.before.entries[i].value = now.entries[i].value;
    }
    check_host(&inside, false, status, "pass_begin");
}

/* By clears of other colours than those of the views. */
static void begin_pass(cupola_gl *gl, const struct host *host)
{
    const struct cupola_frame frame = {.clear_color = {0.8f, 0.2f, 0.4f, 0.6f}};
    struct cupola_gl_pass pass;
    int views = cupola_gl_frame_begin(gl, &frame, NULL);
    if (cupola_pass_way(NULL) < 0)
        return;
    check_host_in_pass(host, views, cupola_gl_pass_begin(gl, NULL, &pass, NULL));
    assert_int_equal(pass.view_count, views);
    for (int i = 0; i < views; i++) {
        GLfloat viewport[4];
        GLint scissor[4];
        glGetFloati_v(GL_VIEWPORT, (GLuint)i, viewport);
        glGetIntegeri_v(GL_SCISSOR_BOX, (GLuint)i, scissor);
        assert_int_equal((int)viewport[0], pass.views[i].rect.x);
        assert_int_equal((int)viewport[2], pass.views[i].rect.width);
        assert_int_equal(scissor[1], pass.views[i].rect.y);
        assert_true(glIsEnabledi(GL_SCISSOR_TEST, (GLuint)i));
    }
    check_host(host, true, cupola_gl_pass_end(gl, NULL), "pass_end");
}

static void draw_targets(cupola_gl *gl, cupola_theatre *theatre, const cupola_dome *dome,
                         const GLuint images[2], const struct host *host)
{
    struct cupola_spectator spectator;
    cupola_spectator_at_eye(dome, &spectator);
    for (int i = 0; i < TARGETS; i++) {
        struct cupola_target left = {target_framebuffer(i), 3, 5};
        struct cupola_target right = {target_framebuffer(i), WIDTH + 7, 9};
        check_host(host, true, cupola_gl_warp(gl, 0, NULL, &left, NULL), "warp");
        check_host(host, true, cupola_gl_overlay(gl, 0, &laid_over, 1, &left, NULL), "overlay");
        check_host(host, true,
                   cupola_theatre_draw(theatre, images, &spectator, WIDTH, HEIGHT, &right, NULL),
                   "theatre_draw");
    }
}

/* Every call of the library that touches the GL, and all that comes out of them. */
static struct results all_calls(struct host *host)
{
    struct results results = results_create();
    cupola_dome *dome = NULL;
    cupola_plan *plan = two_outputs(&dome);
    cupola_gl *gl = NULL;
    cupola_theatre *theatre = NULL;
    GLuint images[2] = {0, 0}, map = 0;
    const struct cupola_gl_params params = {.table = fixture_stage(CUPOLA_TABLE_SINES),
                                            .overlays = true};
    const struct cupola_plan_report *report = cupola_plan_report(plan);
    struct cupola_target target = {target_framebuffer(TARGET_FLOAT), 1, 2};

    be_clean();
    targets_fill();
    be_clean();
    be_hostile(host);
    check_host(host, true, cupola_gl_create(plan, &params, &gl, NULL), "create");
    check_host(host, true, cupola_theatre_create(dome, &theatre, NULL), "theatre_create");
    be_clean();
    GLuint views = paint_views(gl);
    be_clean();
    be_hostile(host);
    begin_views(gl, host);
    begin_views(sampled.gl, host);
    be_clean();
    add_sampled(&results);
    be_clean();
    be_hostile(host);
    begin_pass(sampled.gl, host);
    be_clean();
    add_sampled(&results);
    be_clean();
    add_pixels(&results, views, GL_RGBA, report->atlas_width_px, report->atlas_height_px);
    add_pixels(&results, views, GL_DEPTH_COMPONENT, report->atlas_width_px,
               report->atlas_height_px);
    paint_views(gl);
    be_clean();
    be_hostile(host);
    for (int i = 0; i < 2; i++)
        check_host(host, true, cupola_gl_points(gl, i, &images[i], NULL), "points");
    check_host(host, true, cupola_gl_density(gl, 0, &map, NULL), "density");
    draw_targets(gl, theatre, dome, images, host);
    check_host(host, true,
               cupola_gl_capture(&target, WIDTH, HEIGHT, results.values + results.count, NULL),
               "capture");
    results.count += 4 * WIDTH * HEIGHT;
    be_clean();
    add_targets(&results);
    be_clean();
    be_hostile(host);
    cupola_gl_destroy(&gl);
    check_host(host, true, 0, "destroy");
    cupola_theatre_destroy(&theatre);
    check_host(host, true, 0, "theatre_destroy");
    be_clean();
    cupola_plan_destroy(&plan);
    cupola_dome_destroy(&dome);
    return results;
}

/* A clear, a new texture, a picture and one added to it, a reading: as naively as can be. */
static struct results naive_work(struct host *host, struct snapshot *after, GLenum *failure)
{
    struct results results = results_create();
    const GLfloat color[4] = {0.3f, 0.6f, 0.9f, 0.4f}, farthest = 1;
    GLuint texture = 0;
    be_clean();
    targets_fill();
    be_clean();
    be_hostile(host);
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, HOSTILE_SIZE, HOSTILE_SIZE, 0, GL_RGBA, GL_FLOAT,
                 NULL);
    for (int i = 0; i < TARGETS; i++) {
        glBindFramebuffer(GL_FRAMEBUFFER, target_framebuffer(i));
        glViewport(2, 2, WIDTH, HEIGHT);
        glScissor(2, 2, WIDTH, HEIGHT);
        glEnable(GL_SCISSOR_TEST);
        glClearBufferfv(GL_COLOR, 0, color);
        glClearBufferfv(GL_DEPTH, 0, &farthest);
        glUseProgram(naive_program);
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, naive_texture);
        glBindVertexArray(naive_vertex_array);
        glViewport(8, 8, WIDTH - 16, HEIGHT - 16);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glViewport(20, 8, WIDTH, HEIGHT);
        glBlendEquation(GL_FUNC_ADD);
        glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
        glEnable(GL_BLEND);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glDisable(GL_BLEND);
    }
    glReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, context_has_floats() ? GL_FLOAT : GL_UNSIGNED_BYTE,
                 results.values);
    results.count = 4 * (4 * WIDTH * HEIGHT); /* room for rows and pixels to be skipped */
    *failure = glGetError();
    snapshot_take(after);
    be_clean();
    add_targets(&results);
    for (int i = 0; i < TARGETS; i++)
        if (i != TARGET_SAMPLES)
            add_pixels(&results, target_framebuffer(i), GL_DEPTH_COMPONENT, WIDTH, HEIGHT);
    glDeleteTextures(1, &texture);
    be_clean();
    return results;
}

/* Whether something that the host had set is not as it was. */
static bool host_lost(const struct snapshot *before, const struct snapshot *after)
{
    for (int i = 0; i < before->count; i++)
        if (before->entries[i].value != clean.entries[i].value &&
            before->entries[i].value != after->entries[i].value)
            return true;
    return false;
}

static void what_a_host_sets_stays_and_changes_no_pixel(void **state)
{
    struct host calm = {.count = 0}, all = {.count = HOSTILITIES};
    struct results expected = all_calls(&calm);
    int tried = 0;
    (void)state;
    for (int i = 0; i < HOSTILITIES; i++) {
        struct host host = {.hostility = &hostilities[i]};
        if (!hostility_exists(&hostilities[i]))
            continue;
        struct results results = all_calls(&host);
        if (!results_equal(&results, &expected))
            fail_msg("%s: other pixels", hostilities[i].name);
        assert_int_not_equal(snapshot_differences(&clean, &host.before, true, NULL), 0);
        free(results.values);
        tried++;
    }
    struct results results = all_calls(&all);
    if (!results_equal(&results, &expected))
        fail_msg("everything: other pixels");
    free(results.values);
    free(expected.values);
    printf("%d hosts tried, %d of %d numbers differ at most\n", tried,
           snapshot_differences(&clean, &all.before, true, NULL), clean.count);
    check_at_least(tried, context_is_es() ? 24 : 34);
}

static void without_care_each_of_them_would_matter(void **state)
{
    struct snapshot after;
    struct host calm = {.count = 0};
    GLenum failure;
    struct results expected = naive_work(&calm, &after, &failure);
    (void)state;
    assert_int_equal(failure, GL_NO_ERROR);
    for (int i = 0; i < HOSTILITIES; i++) {
        struct host host = {.hostility = &hostilities[i]};
        if (!hostility_exists(&hostilities[i]))
            continue;
        struct results results = naive_work(&host, &after, &failure);
        bool pixels = !results_equal(&results, &expected);
        bool lost = host_lost(&host.before, &after);
        bool matters = pixels || lost || failure != GL_NO_ERROR;
        bool unseen = hostilities[i].set == set_depth_mask && !depth_is_readable();
        printf("%-36s%s%s%s\n", hostilities[i].name, pixels ? " pixels" : "", lost ? " lost" : "",
               failure != GL_NO_ERROR ? " error" : "");
        if (hostilities[i].matters == MATTERS && !matters && !unseen)
            fail_msg("%s: did not matter", hostilities[i].name);
        free(results.values);
    }
    free(expected.values);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_a_host_sets_stays_and_changes_no_pixel),
        cmocka_unit_test(without_care_each_of_them_would_matter),
    };
    return cmocka_run_group_tests_name("host_state", tests, setup, teardown);
}
