/* Rounds of interleaved frames, and their medians. */
#include "comparison.h"

#include <stdio.h>
#include <stdlib.h>

#include <epoxy/gl.h>

struct field {
    const struct setting *setting;
    const struct contender *contenders;
    int count;
    const struct comparison_wishes *wishes;
    void *ready[CONTENDERS_MAX];
    double *times_ms[CONTENDERS_MAX]; /* as many by the wall clock follow */
    struct stopwatch watch;
};

static void field_destroy(struct field *field)
{
    for (int i = 0; i < field->count; i++) {
        if (field->ready[i])
            field->contenders[i].kind->release(field->ready[i]);
        free(field->times_ms[i]);
    }
    stopwatch_destroy(&field->watch);
}

static bool field_create(struct field *field, struct result *results, char *message)
{
    for (int i = 0; i < field->count; i++) {
        const struct contender *contender = &field->contenders[i];
        results[i] = (struct result){{0}};
        field->times_ms[i] = calloc(2 * (size_t)field->wishes->frames, sizeof(double));
        if (!field->times_ms[i]) {
            snprintf(message, MESSAGE_SIZE, "out of memory");
            return false;
        }
        field->ready[i] =
            contender->kind->prepare(field->setting, contender->variant, results[i].skipped);
        if (field->ready[i])
            contender->kind->facts(field->ready[i], &results[i].facts);
    }
    if (!field->ready[0])
        snprintf(message, MESSAGE_SIZE, "%s: %.900s", field->contenders[0].name,
                 results[0].skipped);
    return field->ready[0];
}

/* One frame; its time, or below 0 where it fails. */
static double frame_ms(struct field *field, int index, bool views)
{
    const struct contender_kind *kind = field->contenders[index].kind;
    bool drawn = !kind->before || kind->before(field->ready[index]);

    stopwatch_start(&field->watch);
    if (drawn && views && kind->views)
        drawn = kind->views(field->ready[index]);
    if (drawn && kind->warp)
        drawn = kind->warp(field->ready[index]);
    double time_ms = stopwatch_stop_ms(&field->watch);
    return drawn && glGetError() == GL_NO_ERROR ? time_ms : -1;
}

static bool warm_up(struct field *field, const struct reference *reference, struct result *results,
                    char *message)
{
    for (int i = 0; i < field->count; i++) {
        if (!field->ready[i])
            continue;
        for (int frame = 0; frame <= field->wishes->warm_up; frame++)
            if (frame_ms(field, i, true) < 0) {
                snprintf(message, MESSAGE_SIZE, "%s: a frame fails", field->contenders[i].name);
                return false;
            }
        if (reference)
            results[i].psnr_db =
                reference_psnr_db(reference, field->setting, results[i].facts.shows);
    }
    return true;
}

static bool draw_rounds(struct field *field, char *message)
{
    for (int round = 0; round < field->wishes->frames; round++)
        for (int turn = 0; turn < field->count; turn++) {
            int i = (round + turn) % field->count;
            if (!field->ready[i])
                continue;
            field->times_ms[i][round] = frame_ms(field, i, !field->wishes->warp_alone);
            field->times_ms[i][field->wishes->frames + round] = field->watch.wall_ms;
            if (field->times_ms[i][round] < 0) {
                snprintf(message, MESSAGE_SIZE, "%s: a frame fails", field->contenders[i].name);
                return false;
            }
        }
    return true;
}

static bool sum_up(struct field *field, struct result *results, char *message)
{
    int frames = field->wishes->frames;
    double *ratios = malloc((size_t)frames * sizeof *ratios);

    if (!ratios) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return false;
    }
    /* From the last to the first, whose times are not to be sorted before. */
    for (int i = field->count - 1; i >= 0; i--) {
        if (!field->ready[i])
            continue;
        for (int k = 0; k < frames; k++)
            ratios[k] = field->times_ms[i][k] / field->times_ms[0][k];
        results[i].round_ratio = quartiles_of(ratios, frames);
        results[i].time_ms = quartiles_of(field->times_ms[i], frames);
        results[i].wall_ms = quartiles_of(field->times_ms[i] + frames, frames);
    }
    for (int i = 0; i < field->count; i++)
        if (field->ready[i])
            results[i].ratio = results[i].time_ms.median / results[0].time_ms.median;
    free(ratios);
    return true;
}

bool compare_contenders(const struct setting *setting, const struct contender *contenders,
                        int count, const struct comparison_wishes *wishes,
                        const struct reference *reference, struct result *results, char *message)
{
    struct field field = {
        .setting = setting, .contenders = contenders, .count = count, .wishes = wishes};

    stopwatch_create(&field.watch, wishes->clock);
    bool done = field_create(&field, results, message) &&
                warm_up(&field, reference, results, message) && draw_rounds(&field, message) &&
                sum_up(&field, results, message);
    field_destroy(&field);
    return done;
}
