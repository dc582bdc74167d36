/* From marks to a rig. */
#include "solve.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "angles.h"
#include "option_values.h"
#include "solve/arrangement.h"
#include "solve/certainty.h"
#include "solve/consensus.h"
#include "solve/misfit.h"
#include "solve/refusal.h"

/* Everything on the way from a request to its result. */
struct solving {
    struct solve_request request; /* its start complete */
    struct cupola_rig start;
    struct solve_result *result;
    struct model model;
    bool *rejected;
    double *weights;
    double error_px; /* which most marks keep to */
    char *message;
};

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
static bool
refuse(const struct solving *solving, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(solving->message, MESSAGE_SIZE, format, arguments);
    va_end(arguments);
    return false;
}

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
static void
warn(struct solve_result *result, const char *format, ...)
{
    va_list arguments;

    if (result->warning_count == SOLVE_WARNINGS_MAX)
        return;
    va_start(arguments, format);
    vsnprintf(result->warnings[result->warning_count++], SOLVE_WARNING_SIZE, format, arguments);
    va_end(arguments);
}

/* Pixels so near to each other are the same place. */
static double near_px(const struct solving *solving)
{
    return 0.005 * solving->model.radius_px;
}

static bool begin(struct solving *solving)
{
    const struct solve_request *request = &solving->request;
    int every =
        SOLVE_CIRCLE | SOLVE_CIRCLE_RADIUS | SOLVE_LENS | SOLVE_POSITION | SOLVE_AIM | SOLVE_RADIUS;
    int free = request->free ? request->free : SOLVE_POSITION | SOLVE_AIM;
    struct cupola_error error = {0};

    *solving->result = (struct solve_result){.rig = *request->start, .free = free};
    if (cupola_rig_complete(request->start, &solving->start, &error) < 0)
        return refuse(solving, "%s", error.message);
    solving->result->rig = solving->start;
    solving->request.start = &solving->start;
    if (request->output < 0 || request->output >= solving->result->rig.output_count)
        return refuse(solving, "projector %d is not in the rig; allowed: 0 to %d", request->output,
                      solving->result->rig.output_count - 1);
    if (free & ~every)
        return refuse(solving, "free is %d; allowed: of enum solve_free", free);
    model_begin(&solving->model, request, free);
    if (!refusal_check(request, free, solving->model.count, near_px(solving), solving->message))
        return false;
    size_t count = (size_t)request->marks->count;
    solving->rejected = calloc(count, sizeof *solving->rejected);
    solving->result->marks = calloc(count, sizeof *solving->result->marks);
    solving->weights = calloc(count, sizeof *solving->weights);
    if (!solving->rejected || !solving->weights || !solving->result->marks)
        return refuse(solving, "out of memory for %d marks", request->marks->count);
    return true;
}

/* Mirrored both ways is turned by 180 degrees: the same with the least change of roll. */
static void turn_least(const struct solving *solving, struct cupola_output *output)
{
    double from_rad = solving->start.outputs[solving->request.output].aim.roll_rad;

    if (fabs(remainder(output->aim.roll_rad - from_rad, 2 * pi)) <= 0.5 * pi)
        return;
    output->flip ^= CUPOLA_FLIP_X | CUPOLA_FLIP_Y;
    output->aim.roll_rad = remainder(output->aim.roll_rad + pi, 2 * pi);
}

/* With the picture mirrored otherwise. Turned by 180 degrees is mirrored both ways. */
static bool better_mirrored(const struct solving *solving, struct model *best, double *best_px)
{
    int flip = solving->model.base.output.flip;
    bool turns = solving->model.free & SOLVE_AIM;

    *best_px = HUGE_VAL;
    for (int other = 1; other < 4; other++) {
        struct model trial;
        double error_px;
        if (turns && other != CUPOLA_FLIP_X)
            continue;
        model_begin(&trial, &solving->request, solving->model.free);
        trial.base.output.flip = flip ^ other;
        if (!consensus_find(&trial, &error_px) || !(error_px < *best_px))
            continue;
        *best_px = error_px;
        *best = trial;
    }
    if (turns && isfinite(*best_px))
        turn_least(solving, &best->base.output);
    return *best_px < 0.25 * solving->error_px;
}

static bool find(struct solving *solving)
{
    double poor_px = 0.02 * solving->model.radius_px, mirrored_px;
    struct model mirrored;

    if (!consensus_find(&solving->model, &solving->error_px))
        return refuse(solving, "the marks fit nowhere: no position and aim lead to their pixels");
    if (!(solving->error_px > poor_px) || !better_mirrored(solving, &mirrored, &mirrored_px))
        return true;
    int was = solving->model.base.output.flip, is = mirrored.base.output.flip;
    char same[80] = "";
    if (solving->model.free & SOLVE_AIM)
        snprintf(same, sizeof same, " (the same as \"%s\" with 180 degrees more of roll)",
                 solve_flip_name(is ^ (CUPOLA_FLIP_X | CUPOLA_FLIP_Y)));
    if (!solving->request.flips)
        return refuse(solving,
                      "the marks fit %.3g times better with the picture mirrored otherwise, flip "
                      "\"%s\" instead of \"%s\"%s; allowed: that flip in the rig, or --flips",
                      solving->error_px / fmax(mirrored_px, 1e-6), solve_flip_name(is),
                      solve_flip_name(was), same);
    warn(solving->result, "the picture is mirrored: flip \"%s\" instead of \"%s\"%s",
         solve_flip_name(is), solve_flip_name(was), same);
    solving->model = mirrored;
    solving->error_px = mirrored_px;
    return true;
}

static void keep_residuals(struct solving *solving)
{
    struct solve_result *result = solving->result;
    double sum = 0;
    int kept = 0, all = solving->request.marks->count;

    for (int i = 0; i < all; i++) {
        struct solve_mark *mark = &result->marks[i];
        mark->rejected = solving->rejected[i];
        if (!model_residuals(&solving->model, &solving->model.base, &i, 1, false,
                             mark->residual_px))
            mark->residual_px[0] = mark->residual_px[1] = 1e7;
        double length = hypot(mark->residual_px[0], mark->residual_px[1]);
        if (mark->rejected) {
            result->rejected++;
            continue;
        }
        kept++;
        sum += length * length;
        result->worst_px = fmax(result->worst_px, length);
    }
    result->rms_px = sqrt(sum / fmax(kept, 1));
}

/* Half of the marks and less are no majority. */
static bool settle(struct solving *solving)
{
    int all = solving->request.marks->count;

    if (!consensus_settle(&solving->model, solving->error_px, solving->weights, solving->rejected))
        return refuse(solving, "the marks lead to no solution, or memory is short");
    keep_residuals(solving);
    int kept = all - solving->result->rejected;
    if (2 * kept <= all)
        return refuse(solving,
                      "only %d of %d marks agree with each other; allowed: more than half. The "
                      "lens, the image circle or the kind of the marks may be wrong",
                      kept, all);
    if (!(solving->result->rms_px <= 0.1 * solving->model.radius_px))
        return refuse(solving,
                      "the marks do not fit: their pixels are off by %.3g px (rms); allowed: a "
                      "tenth of the image circle's radius. The lens, the image circle or the kind "
                      "of the marks may be wrong",
                      solving->result->rms_px);
    return refusal_enough(solving->request.marks, solving->rejected, kept, near_px(solving),
                          solving->model.count, solving->message);
}

static bool check_certainty(const struct solving *solving, const struct certainty *certainty)
{
    const double circle_rad = 0.035; /* 2 degrees */
    struct arrangement arrangement;
    const char *hint = "more marks, over all that the projector lights, or fewer free values";

    arrangement_measure(solving->request.marks, solving->rejected, &arrangement);
    if (arrangement.off_circle_rad < circle_rad)
        hint = "marks aside of the one circle on which all of these lie";
    if (!certainty_suffices(&solving->model, certainty, hint, solving->message))
        return false;
    return solving->model.count <= 3 || arrangement_suffices(&arrangement, solving->message);
}

/* Points lie on the screen: their distances from its centre are its radius. */
static void measure_radius(struct solving *solving)
{
    const struct marks *marks = solving->request.marks;
    struct solve_result *result = solving->result;
    double sum = 0, squares = 0;
    int kept = 0;

    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; i < marks->count; i++) {
            const double *p = marks->list[i].place;
            double length = hypot(hypot(p[0], p[1]), p[2]);
            if (solving->rejected[i])
                continue;
            kept += pass == 0;
            sum += pass == 0 ? length : 0;
            squares += pass == 1 ? (length - sum / kept) * (length - sum / kept) : 0;
        }
    }
    double mean = sum / kept, spread = sqrt(squares / fmax(kept - 1, 1));
    if (spread > 0.02 * mean)
        warn(result, "the points lie %.3g m from the centre, but for %.2g m: not on one sphere",
             mean, spread);
    if (result->free & SOLVE_RADIUS && spread < 1e-9 * mean)
        warn(result,
             "the points lie at one distance from the centre: the radius's sd says nothing");
    if (result->free & SOLVE_RADIUS) {
        result->rig.screen.radius_m = mean;
        result->radius_sd_m = spread / sqrt(kept);
    } else if (fabs(mean - result->rig.screen.radius_m) >
               fmax(0.01 * mean, 4 * spread / sqrt(kept))) {
        warn(result, "the points lie %.4g m from the centre, the screen of the rig %.4g m", mean,
             result->rig.screen.radius_m);
    }
}

static void warn_of_pixels(struct solving *solving)
{
    const struct cupola_output *output = &solving->model.base.output;
    const struct marks *marks = solving->request.marks;
    int outside = 0;

    for (int i = 0; i < marks->count; i++) {
        const double *pixel = marks->list[i].pixel_px;
        outside += pixel[0] < 0 || pixel[1] < 0 || pixel[0] > output->width_px ||
                   pixel[1] > output->height_px;
    }
    if (outside > 0)
        warn(solving->result, "%d of %d marks have pixels outside of the projector's %dx%d",
             outside, marks->count, output->width_px, output->height_px);
}

/* So few that their scatter hardly tells the noise, or none at all. */
static void warn_of_sd(struct solving *solving, const struct certainty *certainty)
{
    const double exact = 1e-6; /* of the radius of the image circle */
    struct solve_result *result = solving->result;
    int kept = solving->request.marks->count - result->rejected, freedoms = 6;
    int enough = (certainty->count + freedoms + 1) / 2;
    int places =
        arrangement_places(solving->request.marks, solving->rejected, near_px(solving), enough);

    if (certainty->count > 0 && certainty->noise_px < exact * solving->model.radius_px)
        warn(result, "the residuals are 0, to %.1g px: they show no noise, and the sd say nothing",
             exact * solving->model.radius_px);
    else if (places < enough && places < kept)
        warn(result, "%d marks at %d different places for %d values: their sd are rough", kept,
             places, certainty->count);
    else if (places < enough)
        warn(result, "%d marks for %d values: their sd are rough", kept, certainty->count);
}

/* Near a pitch of +-90 degrees yaw and roll are one turn, which the marks may tell well. */
static void warn_of_pole(struct solving *solving)
{
    struct solve_result *result = solving->result;
    const struct cupola_aim *aim = &solving->model.base.output.aim;
    const double much_better = 5;
    bool above = aim->pitch_rad > 0;
    double turn_rad = remainder(aim->yaw_rad + (above ? -1 : 1) * aim->roll_rad, 2 * pi);

    if (fmin(result->aim_sd_rad[0], result->aim_sd_rad[2]) > much_better * result->turn_sd_rad)
        warn(
            result,
            "at a pitch of %.3g degrees yaw and roll turn about nearly the same axis: their sd are "
            "large, and what counts is yaw %s roll, %.6g degrees (sd %.3g)",
            aim->pitch_rad * deg_per_rad, above ? "less" : "plus", turn_rad * deg_per_rad,
            result->turn_sd_rad * deg_per_rad);
}

/* Marks that fit badly because of what is not free. */
static void warn_of_misfit(struct solving *solving)
{
    struct solve_result *result = solving->result;
    int all = solving->request.marks->count;
    struct misfit misfit;
    const double most_px = 0.005 * solving->model.radius_px;

    if (3 * result->rejected > all)
        warn(result,
             "%d of %d marks are rejected, more than a third: the lens, the image circle "
             "or the radius of the screen may be wrong rather than these marks",
             result->rejected, all);
    else if (5 * result->rejected > all)
        warn(result, "%d of %d marks are rejected: more than a few", result->rejected, all);
    if (misfit_find(&solving->request, &solving->model, solving->rejected, &misfit))
        warn(result,
             "the residuals are systematic: with %s they would be %.3g px (rms) "
             "instead of %.3g px; something is not as the rig says",
             misfit.what, misfit.freed_px, misfit.rms_px);
    if (result->rms_px > most_px)
        warn(result,
             "residuals of %.3g px (rms) are larger than usual, %.2g px: the lens model, "
             "the image circle or the radius of the screen may be wrong",
             result->rms_px, most_px);
}

static void warn_all(struct solving *solving, const struct certainty *certainty)
{
    int at = 0;
    const char *name;

    warn_of_pixels(solving);
    while ((name = certainty_weak(&solving->model, certainty, &at)))
        warn(solving->result, "the marks tell %s only roughly: see its sd", name);
    warn_of_sd(solving, certainty);
    warn_of_pole(solving);
    warn_of_misfit(solving);
}

static bool finish(struct solving *solving)
{
    struct solve_result *result = solving->result;
    struct certainty certainty;
    struct cupola_error error = {0};

    if (!certainty_find(&solving->model, solving->rejected, &certainty))
        return refuse(solving, "out of memory for %d marks", solving->request.marks->count);
    if (!check_certainty(solving, &certainty))
        return false;
    result->rig.outputs[solving->request.output] = solving->model.base.output;
    result->rig.screen.radius_m = solving->model.base.radius_m;
    if (solving->request.marks->kind == MARKS_POINTS)
        measure_radius(solving);
    if (cupola_rig_complete(&result->rig, &result->rig, &error) < 0)
        return refuse(solving, "the marks lead to an impossible rig: %s", error.message);
    if (!certainty_report(&solving->model, &certainty, result, solving->request.output))
        return refuse(solving, "out of memory");
    warn_all(solving, &certainty);
    return true;
}

bool solve(const struct solve_request *request, struct solve_result *result, char *message)
{
    struct solving solving = {.request = *request, .result = result, .message = message};
    bool solved = begin(&solving) && find(&solving) && settle(&solving) && finish(&solving);

    free(solving.rejected);
    free(solving.weights);
    if (!solved)
        solve_result_free(result);
    return solved;
}

void solve_result_free(struct solve_result *result)
{
    free(result->marks);
    result->marks = NULL;
}
