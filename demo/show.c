/* From a rig to pictures. */
#include "show.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include <epoxy/gl.h>

#include "grid.h"
#include "perspective.h"
#include "submission.h"
#include "target.h"
#include "view_wishes.h"

struct show {
    struct show_setup setup;
    cupola_dome *dome;
    cupola_plan *plan; /* NULL in mode SHOW_PERSPECTIVE, like all below */
    cupola_gl *gl;
    unsigned int atlas_framebuffer; /* to read the atlas from */
    cupola_theatre *theatre;        /* previews only, and their images: */
    struct target images[CUPOLA_OUTPUTS_MAX];
};

double now_ms(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec * 1e3 + (double)now.tv_nsec * 1e-6;
}

static bool is_preview(enum show_mode mode)
{
    return mode == SHOW_PREVIEW_EYE || mode == SHOW_PREVIEW_OUTSIDE;
}

static bool setup_has_no_views(const struct show_setup *setup)
{
    return setup->source != CUPOLA_SOURCE_VIEWS;
}

static bool create_theatre(struct show *show, char *message)
{
    struct cupola_error error = {0};
    const struct cupola_rig *rig = cupola_dome_rig(show->dome);
    enum target_kind kind = view_wishes_encoding(&show->setup) == CUPOLA_ENCODING_SRGB ? TARGET_SRGB
                            : show->setup.floats ? TARGET_FLOATS
                                                 : TARGET_BYTES;

    for (int i = 0; i < rig->output_count; i++) {
        const struct cupola_output *output = &rig->outputs[i];
        if (!target_create(&show->images[i], output->width_px, output->height_px, kind, message,
                           MESSAGE_SIZE))
            return false;
    }
    if (cupola_theatre_create(show->dome, &show->theatre, &error) >= 0)
        return true;
    snprintf(message, MESSAGE_SIZE, "%s", error.message);
    return false;
}

static bool create_views(struct show *show, char *message)
{
    struct cupola_error error = {0};
    struct cupola_gl_params params = view_wishes_params(&show->setup);
    GLint largest = 0;

    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (largest > 16384)
        largest = 16384;
    show->setup.plan.max_texture_px = largest;
    if (cupola_plan_create(show->dome, &show->setup.plan, &show->plan, &error) < 0 ||
        cupola_gl_create(show->plan, &params, &show->gl, &error) < 0) {
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
        return false;
    }
    if (setup_has_no_views(&show->setup))
        return true;
    show->setup.plan.earlier = NULL; /* may go before this show does */
    glGenFramebuffers(1, &show->atlas_framebuffer);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, show->atlas_framebuffer);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                           cupola_gl_atlas(show->gl), 0);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    return true;
}

struct show *show_create(const struct show_setup *setup, char *message)
{
    struct cupola_error error = {0};
    struct show *show = calloc(1, sizeof *show);

    if (!show) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return NULL;
    }
    show->setup = *setup;
    if (cupola_dome_create(&setup->rig, &show->dome, &error) < 0) {
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
        goto fail;
    }
    if (setup_has_no_views(setup) && !is_preview(setup->mode) && setup->mode != SHOW_DOME) {
        snprintf(message, MESSAGE_SIZE,
                 "a picture has no views; allowed: the dome's image, or a preview");
        goto fail;
    }
    if (setup->mode == SHOW_PERSPECTIVE)
        return show;
    if (!create_views(show, message))
        goto fail;
    if (is_preview(setup->mode) && !create_theatre(show, message))
        goto fail;
    return show;

fail:
    show_destroy(show);
    return NULL;
}

void show_destroy(struct show *show)
{
    if (!show)
        return;
    for (int i = 0; i < CUPOLA_OUTPUTS_MAX; i++)
        if (show->images[i].framebuffer)
            target_destroy(&show->images[i]);
    cupola_theatre_destroy(&show->theatre);
    if (show->atlas_framebuffer)
        glDeleteFramebuffers(1, &show->atlas_framebuffer);
    cupola_gl_destroy(&show->gl);
    cupola_plan_destroy(&show->plan);
    cupola_dome_destroy(&show->dome);
    free(show);
}

void show_size(const struct show *show, int *width, int *height)
{
    const struct cupola_plan_report *report = show_report(show);

    *width = show->setup.rig.outputs[show->setup.output].width_px;
    *height = show->setup.rig.outputs[show->setup.output].height_px;
    if (show->setup.mode == SHOW_VIEWS) {
        *width = report->atlas_width_px;
        *height = report->atlas_height_px;
    }
}

const cupola_dome *show_dome(const struct show *show)
{
    return show->plan ? cupola_plan_dome(show->plan) : show->dome;
}

const struct cupola_plan_report *show_report(const struct show *show)
{
    return show->plan ? cupola_plan_report(show->plan) : NULL;
}

const struct show_setup *show_setup_of(const struct show *show)
{
    return &show->setup;
}

const char *show_table(const struct show *show)
{
    int table = show->gl ? cupola_gl_table(show->gl, show->setup.output) : -1;

    return table >= 0 ? cupola_table_name(table) : NULL;
}

const cupola_plan *show_plan(const struct show *show)
{
    return show->plan;
}

double show_time_tables_ms(const struct show *show)
{
    struct cupola_gl_params params = view_wishes_params(&show->setup);
    cupola_gl *gl = NULL;
    double start_ms, time_ms;
    int status;

    if (!show->plan)
        return 0;
    glFinish();
    start_ms = now_ms();
    status = cupola_gl_create(show->plan, &params, &gl, NULL);
    glFinish();
    time_ms = now_ms() - start_ms;
    cupola_gl_destroy(&gl);
    return status >= 0 ? time_ms : -1;
}

static bool draw_views(struct show *show, const struct show_frame *frame, const float host[16],
                       const double eye[3], double near_distance, double far_distance,
                       struct cupola_error *error)
{
    const struct cupola_frame begin =
        view_wishes_frame(&show->setup, frame->scene, near_distance, far_distance);
    const struct submission submission = {.gl = show->gl,
                                          .plan = show->plan,
                                          .dome = show_dome(show),
                                          .stencil = show->setup.mask == CUPOLA_MASK_STENCIL,
                                          .one_pass = show->setup.one_pass,
                                          .scene = frame->scene,
                                          .grid = frame->grid};
    const struct scene_camera camera = {
        .host = host, .reversed_depth = show->setup.reversed_depth, .eye = eye};
    bool drawn = submission_draw(&submission, &begin, camera, error);

    view_wishes_done(&show->setup);
    return drawn;
}

/* The opening of the lens spans the diameter of the image circle, as it does on the dome. */
static void draw_perspective(struct show *show, const struct show_frame *frame,
                             const float host[16], const double eye[3], double n, double f)
{
    const struct cupola_output *output = &show->setup.rig.outputs[show->setup.output];
    double per_px = tan(output->lens.fov_rad / 2) / output->circle.radius_px;
    double left = -output->circle.center_x_px * per_px;
    double bottom = -output->circle.center_y_px * per_px;
    struct cupola_camera camera;

    perspective_camera(&(struct perspective){.rotation = {1, 0, 0, 0, 1, 0, 0, 0, 1},
                                             .eye = {eye[0], eye[1], eye[2]},
                                             .left = left,
                                             .right = left + frame->width * per_px,
                                             .bottom = bottom,
                                             .top = bottom + frame->height * per_px,
                                             .near_distance = n,
                                             .far_distance = f},
                       &camera);
    glBindFramebuffer(GL_FRAMEBUFFER, frame->framebuffer);
    glViewport(0, 0, frame->width, frame->height);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glClearDepth(1);
    glClearColor(frame->scene->clear_color[0], frame->scene->clear_color[1],
                 frame->scene->clear_color[2], frame->scene->clear_color[3]);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    frame->scene->draw(frame->scene, &(struct scene_camera){&camera, host, false});
}

void show_draw_atlas(const struct show *show, unsigned int framebuffer,
                     const struct cupola_rect *rect)
{
    const struct cupola_plan_report *report = show_report(show);
    double x_scale, y_scale;

    if (!report || !show->atlas_framebuffer)
        return;
    x_scale = (double)rect->width / report->atlas_width_px;
    y_scale = (double)rect->height / report->atlas_height_px;
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, show->atlas_framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    for (int i = 0; i < report->views; i++) {
        const struct cupola_rect *from = &cupola_plan_view(show->plan, i)->rect;
        int left = rect->x + (int)lround(from->x * x_scale);
        int bottom = rect->y + (int)lround(from->y * y_scale);
        int right = rect->x + (int)lround((from->x + from->width) * x_scale);
        int top = rect->y + (int)lround((from->y + from->height) * y_scale);
        bool same = right - left == from->width && top - bottom == from->height;
        glBlitFramebuffer(from->x, from->y, from->x + from->width, from->y + from->height, left,
                          bottom, right, top, GL_COLOR_BUFFER_BIT, same ? GL_NEAREST : GL_LINEAR);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

/* All views, as large as they fit into the framebuffer. */
static void draw_views_only(struct show *show, const struct show_frame *frame)
{
    const struct cupola_plan_report *report = show_report(show);
    double scale = fmin((double)frame->width / report->atlas_width_px,
                        (double)frame->height / report->atlas_height_px);
    struct cupola_rect rect = {.width = (int)lround(scale * report->atlas_width_px),
                               .height = (int)lround(scale * report->atlas_height_px)};

    rect.x = (frame->width - rect.width) / 2;
    rect.y = (frame->height - rect.height) / 2;
    glBindFramebuffer(GL_FRAMEBUFFER, frame->framebuffer);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    show_draw_atlas(show, frame->framebuffer, &rect);
}

/* One output's image: the warp, and what lies over it. */
static bool draw_output(struct show *show, const struct show_frame *frame, int output,
                        unsigned int framebuffer, struct cupola_error *error)
{
    struct cupola_target target = {.framebuffer = framebuffer};

    return cupola_gl_warp(show->gl, output, frame->source, &target, error) >= 0 &&
           (!show->setup.overlays || cupola_gl_overlay(show->gl, output, frame->overlays,
                                                       frame->overlay_count, &target, error) >= 0);
}

static bool draw_outputs(struct show *show, const struct show_frame *frame,
                         struct cupola_error *error)
{
    if (!is_preview(show->setup.mode))
        return draw_output(show, frame, show->setup.output, frame->framebuffer, error);
    for (int i = 0; i < cupola_dome_rig(show->dome)->output_count; i++)
        if (!draw_output(show, frame, i, show->images[i].framebuffer, error))
            return false;
    return true;
}

static bool draw_theatre(struct show *show, const struct show_frame *frame,
                         struct cupola_error *error)
{
    unsigned int images[CUPOLA_OUTPUTS_MAX];
    struct cupola_spectator spectator;
    struct cupola_target target = {.framebuffer = frame->framebuffer};

    for (int i = 0; i < CUPOLA_OUTPUTS_MAX; i++)
        images[i] = show->images[i].texture;
    if (show->setup.mode == SHOW_PREVIEW_EYE)
        cupola_spectator_at_eye(show_dome(show), &spectator);
    else
        cupola_spectator_outside(show->dome, &spectator);
    spectator.encoding = view_wishes_encoding(&show->setup);
    return cupola_theatre_draw(show->theatre, images, &spectator, frame->width, frame->height,
                               &target, error) >= 0;
}

/* The time since `start_ms`, once the GL has finished; 0 where nobody wants it. */
static double phase_ms(const struct show_frame *frame, double start_ms)
{
    if (!frame->times)
        return 0;
    glFinish();
    return now_ms() - start_ms;
}

/* Into the views, or straight to where it is seen. */
static bool draw_scene(struct show *show, const struct show_frame *frame,
                       struct cupola_error *error)
{
    float host[16];
    double eye[3], world[3], near_distance, far_distance;

    host_camera_matrix(frame->camera, host);
    host_camera_eye(frame->camera, show_dome(show), eye, world);
    scene_range_update(frame->range, frame->scene, world, &near_distance, &far_distance);
    if (show->setup.mode != SHOW_PERSPECTIVE)
        return draw_views(show, frame, host, world, near_distance, far_distance, error);
    draw_perspective(show, frame, host, eye, near_distance, far_distance);
    return true;
}

/* The eye that the GL draws for and the one that the demo itself asks, and where samples lie. */
static bool move(struct show *show, const struct show_frame *frame, struct cupola_error *error)
{
    const double *eye_m = show->plan ? frame->eye_m : NULL;
    const struct show_jitter *jitter = frame->jitter;

    return (!eye_m || (cupola_gl_set_eye(show->gl, eye_m, error) >= 0 &&
                       cupola_plan_set_eye(show->plan, eye_m, error) >= 0)) &&
           (!jitter || cupola_gl_set_jitter(show->gl, jitter->texels, jitter->pixels, error) >= 0);
}

bool show_draw(struct show *show, const struct show_frame *frame, char *message)
{
    struct cupola_error error = {0};
    struct frame_times times = {0};
    double start_ms;

    if (frame->scene)
        frame->scene->drawn = (struct scene_counts){0, 0};
    phase_ms(frame, 0);
    start_ms = now_ms();
    if (!move(show, frame, &error) || (!frame->source && !draw_scene(show, frame, &error)))
        goto fail;
    times.views_ms = phase_ms(frame, start_ms);
    if (show->setup.mode == SHOW_VIEWS) {
        draw_views_only(show, frame);
    } else if (show->setup.mode != SHOW_PERSPECTIVE) {
        if (!draw_outputs(show, frame, &error))
            goto fail;
        times.warp_ms = phase_ms(frame, start_ms) - times.views_ms;
        if (is_preview(show->setup.mode) && !draw_theatre(show, frame, &error))
            goto fail;
    }
    times.frame_ms = phase_ms(frame, start_ms);
    if (frame->times)
        *frame->times = times;
    return true;

fail:
    snprintf(message, MESSAGE_SIZE, "%s", error.message);
    return false;
}
