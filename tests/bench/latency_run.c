/*
 * Frames that follow a tracker. Each frame shows the directions of its rays, as floats; one pixel
 * that is read back then says where the eye was that the frame was drawn for.
 */
#include "latency_run.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <epoxy/gl.h>

#include <cupola/cupola.h>

#include "scene.h"
#include "target.h"
#include "tracker.h"
#include "viewer_osc.h"

static const double HEAD_M = 0.2;
static const double PROOF_M = 2e-4; /* what interpolation between texels may add to the pixel */
enum { WARM_UP = 5 };

struct frame {
    double start_s, polled_s, finished_s;
    double eye_m; /* along x, read out of the picture */
    double set_m; /* the same, as it was set */
    int newest;   /* index of the newest report that was taken */
    bool is_proven;
};

struct run {
    const struct latency_wishes *wishes;
    cupola_dome *dome;
    cupola_plan *plan;
    cupola_gl *gl;
    struct scene *scene;
    struct target target;
    struct viewer_osc *osc;
    struct cupola_viewer viewer;
    struct tracker *tracker;
    double point_m[3]; /* of the screen, lit by the pixel that is read */
    struct frame *frames;
    int count;
};

static bool fail(char *message, const struct cupola_error *error)
{
    snprintf(message, MESSAGE_SIZE, "%s", error->message);
    return false;
}

static bool create_dome(struct run *run, char *message)
{
    int size = run->wishes->size_px;
    struct cupola_rig rig = {.outputs[0] = {.width_px = size,
                                            .height_px = size,
                                            .lens.fov_rad = 140 * 3.14159265358979323846 / 180}};
    struct cupola_plan_params plan = {.head_radius_m = HEAD_M};
    struct cupola_gl_params params = {.format = CUPOLA_FORMAT_RGBA32F, .table = CUPOLA_TABLE_TILES};
    struct cupola_error error = {0};
    struct cupola_ray ray;

    if (cupola_dome_create(&rig, &run->dome, &error) < 0 ||
        cupola_plan_create(run->dome, &plan, &run->plan, &error) < 0 ||
        cupola_gl_create(run->plan, &params, &run->gl, &error) < 0)
        return fail(message, &error);
    cupola_dome_ray(run->dome, 0, NULL, size / 2 + 0.5, size / 2 + 0.5, &ray);
    memcpy(run->point_m, ray.point_m, sizeof run->point_m);
    run->scene = scene_directions_create(0, message, MESSAGE_SIZE);
    return run->scene &&
           target_create(&run->target, size, size, TARGET_FLOATS, message, MESSAGE_SIZE);
}

static bool create_tracker(struct run *run, char *message)
{
    struct cupola_viewer_params params = {.radius_m = HEAD_M, .reach = 0.999, .horizon_s = 0.3};
    struct tracker_wishes wishes = {.rate_hz = run->wishes->rate_hz,
                                    .flood_hz = run->wishes->flood_hz};

    if (!run->wishes->predicted) {
        params.memory_s = 1e-4; /* nothing is filtered, either */
        params.horizon_s = -1;
    }
    cupola_viewer_start(&run->viewer, &params, NULL);
    run->osc = viewer_osc_create("127.0.0.1:0", message);
    if (!run->osc)
        return false;
    wishes.port = atoi(strrchr(viewer_osc_address(run->osc), ':') + 1);
    run->tracker = tracker_create(&wishes, message);
    return run->tracker != NULL;
}

static void destroy(struct run *run)
{
    tracker_destroy(run->tracker);
    viewer_osc_destroy(run->osc);
    free(run->frames);
    target_destroy(&run->target);
    if (run->scene)
        run->scene->destroy(run->scene);
    cupola_gl_destroy(&run->gl);
    cupola_plan_destroy(&run->plan);
    cupola_dome_destroy(&run->dome);
}

static bool draw(struct run *run, const double eye_m[3], char *message)
{
    static const float host[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    struct cupola_frame begin = {.depth = {.near_distance = 0.1, .far_distance = 10}};
    struct cupola_target target = {.framebuffer = run->target.framebuffer};
    struct cupola_error error = {0};
    struct cupola_gl_view view;
    int views;

    if (!run->wishes->control && cupola_gl_set_eye(run->gl, eye_m, &error) < 0)
        return fail(message, &error);
    views = cupola_gl_frame_begin(run->gl, &begin, &error);
    for (int i = 0; i < views; i++) {
        if (cupola_gl_view_begin(run->gl, i, &view, &error) < 0)
            return fail(message, &error);
        run->scene->draw(run->scene, &(struct scene_camera){&view.camera, host, false});
        if (cupola_gl_view_end(run->gl, &error) < 0)
            return fail(message, &error);
    }
    if (views < 0 || cupola_gl_warp(run->gl, 0, NULL, &target, &error) < 0)
        return fail(message, &error);
    glFinish();
    return true;
}

/* The eye, along x, from which the pixel's direction leads to its point; y and z are known. */
static double read_eye_m(const struct run *run, const double eye_m[3])
{
    int middle = run->wishes->size_px / 2;
    float v[4];

    glBindFramebuffer(GL_READ_FRAMEBUFFER, run->target.framebuffer);
    glReadPixels(middle, middle, 1, 1, GL_RGBA, GL_FLOAT, v);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    return run->point_m[0] - (run->point_m[2] - eye_m[2]) / (double)v[2] * (double)v[0];
}

/* By the moment at which the kernel got it: the last that was sent before. */
static int newest_report(const struct run *run, int from)
{
    int count = tracker_count(run->tracker);

    while (from + 1 < count && tracker_sent_s(run->tracker, from + 1) <= run->viewer.time_s + 20e-6)
        from++;
    return from;
}

static bool draw_frame(struct run *run, double ahead_s, const struct frame *before, char *message)
{
    struct frame frame = {.start_s = viewer_osc_now_s()};
    double eye_m[3] = {0};

    viewer_osc_poll(run->osc, &run->viewer);
    frame.polled_s = viewer_osc_now_s();
    cupola_viewer_eye(&run->viewer, frame.start_s + ahead_s, eye_m);
    frame.newest = run->viewer.reports > 0 ? newest_report(run, before ? before->newest : -1) : -1;
    if (!draw(run, eye_m, message))
        return false;
    frame.finished_s = viewer_osc_now_s();
    frame.eye_m = read_eye_m(run, eye_m);
    frame.set_m = eye_m[0];
    frame.is_proven = fabs(frame.eye_m - frame.set_m) <= PROOF_M;
    if (!run->wishes->predicted && frame.newest >= 0)
        frame.is_proven &=
            fabs(frame.eye_m - (double)tracker_x_m(run->tracker, frame.newest)) <= PROOF_M;
    run->frames[run->count++] = frame;
    return true;
}

static int by_size(const void *a, const void *b)
{
    double left = *(const double *)a, right = *(const double *)b;
    return (left > right) - (left < right);
}

static struct spread spread_of(double *values, int count)
{
    if (count == 0)
        return (struct spread){(double)NAN, (double)NAN};
    qsort(values, (size_t)count, sizeof *values, by_size);
    return (struct spread){values[count / 2], values[(int)(0.95 * (count - 1) + 0.5)]};
}

/* The shift of time by which the head's way fits the eyes shown best, to a tenth of a ms. */
static double lag_ms(const struct frame *frames, int count)
{
    double best = (double)NAN, least = (double)INFINITY;

    for (double lag = -100; lag < 300; lag += 0.1) {
        double sum = 0;
        for (int i = 0; i < count; i++) {
            double off = frames[i].eye_m - tracker_head_x_m(frames[i].finished_s - 1e-3 * lag);
            sum += off * off;
        }
        if (sum < least) {
            least = sum;
            best = lag;
        }
    }
    return best;
}

static void take_messages(const struct run *run, double *values, struct latency_result *result)
{
    const struct frame *frames = run->frames;
    int count = 0, first = frames[WARM_UP - 1].newest;

    for (int i = WARM_UP; i < run->count; i++)
        for (int k = frames[i - 1].newest + 1; k <= frames[i].newest; k++)
            values[count++] = 1e3 * (frames[i].finished_s - tracker_sent_s(run->tracker, k));
    result->reports = frames[run->count - 1].newest - first;
    result->message_ms = spread_of(values, count);
}

static void take_frames(const struct run *run, double *values, struct latency_result *result)
{
    const struct frame *frames = run->frames + WARM_UP;
    int count = run->count - WARM_UP, aged = 0;
    double sum = 0;

    for (int i = 0; i < count; i++) {
        double off = frames[i].eye_m - tracker_head_x_m(frames[i].finished_s);
        sum += off * off;
        result->unproven += !frames[i].is_proven;
        if (frames[i].newest >= 0)
            values[aged++] =
                1e3 * (frames[i].finished_s - tracker_sent_s(run->tracker, frames[i].newest));
    }
    result->frames = count;
    result->error_mm = 1e3 * sqrt(sum / count);
    result->age_ms = spread_of(values, aged);
    for (int i = 0; i < count; i++)
        values[i] = 1e3 * (frames[i].polled_s - frames[i].start_s);
    result->poll_ms = spread_of(values, count);
    for (int i = 0; i < count; i++)
        values[i] = 1e3 * (frames[i].finished_s - frames[i].start_s);
    result->frame_ms = spread_of(values, count);
    result->lag_ms = lag_ms(frames, count);
}

static bool measure(struct run *run, struct latency_result *result, char *message)
{
    double ahead_s = 0, *values;
    long taken = 0;
    int total = run->wishes->frames + WARM_UP;

    run->frames = calloc((size_t)total, sizeof *run->frames);
    if (!run->frames) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return false;
    }
    for (int i = 0; i < total; i++) {
        const struct frame *last = i > 0 ? &run->frames[i - 1] : NULL;
        if (i == WARM_UP)
            taken = run->viewer.reports;
        if (!draw_frame(run, ahead_s, last, message))
            return false;
        last = &run->frames[i];
        ahead_s += (i < WARM_UP ? 1 : 0.1) * (last->finished_s - last->start_s - ahead_s);
    }
    values = calloc((size_t)(tracker_count(run->tracker) + total), sizeof *values);
    if (!values) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return false;
    }
    take_messages(run, values, result);
    take_frames(run, values, result);
    free(values);
    result->lost = result->reports - (int)(run->viewer.reports - taken);
    result->flooded = tracker_flooded(run->tracker);
    return true;
}

bool latency_run(const struct latency_wishes *wishes, struct latency_result *result, char *message)
{
    struct run run = {.wishes = wishes};
    bool done;

    *result = (struct latency_result){0};
    done = create_dome(&run, message) && create_tracker(&run, message) &&
           measure(&run, result, message);
    destroy(&run);
    return done;
}
