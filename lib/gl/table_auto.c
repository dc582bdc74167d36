/*
 * The table stage that is the fastest here, found by drawing: one stage after the other against the
 * fastest so far, the two in turns, so that what else the machine does falls on both, and the loser
 * is given back. All stages meet the same bound of errors.
 */
#include <stdio.h>
#include <string.h>

#include "clock.h"
#include "filter_gl.h"
#include "gl_objects.h"
#include "instance.h"

enum { ROUNDS = 5, WORDS_MAX = 160 };

/* What the measuring of one output may take before the rest goes unmeasured, s. */
static const double budget_s = 0.25;

/* In this order: what is likely to win first. */
static const enum cupola_table stages[] = {CUPOLA_TABLE_TILES,  CUPOLA_TABLE_COORDINATES,
                                           CUPOLA_TABLE_NONE,   CUPOLA_TABLE_POINTS,
                                           CUPOLA_TABLE_ANGLES, CUPOLA_TABLE_SINES};

enum { STAGES = sizeof stages / sizeof stages[0] };

/*
 * Tables by the CPU take seconds, those that depend on the eye are drawn anew whenever it moves,
 * and all have one ray for each pixel, of its middle.
 */
static bool is_candidate(const cupola_gl *gl, enum cupola_table stage)
{
    if (stage == CUPOLA_TABLE_NONE || stage == CUPOLA_TABLE_TILES)
        return true;
    if (gl->params.jitters || !gl->features.float_targets ||
        filter_sends_rays(&gl->params.filter) ||
        (stage == CUPOLA_TABLE_COORDINATES && gl->params.storage != CUPOLA_STORAGE_ATLAS))
        return false;
    return stage == CUPOLA_TABLE_POINTS || !(gl->plan.head_radius_m > 0);
}

/* One warp by a pass, s. */
static double time_of(cupola_gl *gl, int output, const struct warp_pass *pass,
                      const struct cupola_target *place)
{
    gl->passes[output] = *pass;
    glBindFramebuffer(GL_FRAMEBUFFER, place->framebuffer);
    glFinish();
    double begin_s = clock_now_s();
    warp_draw_views(gl, output, place);
    glFinish();
    return clock_now_s() - begin_s;
}

static double median(double *times, int count)
{
    for (int i = 1; i < count; i++)
        for (int k = i; k > 0 && times[k] < times[k - 1]; k--) {
            double swapped = times[k];
            times[k] = times[k - 1];
            times[k - 1] = swapped;
        }
    return times[count / 2];
}

/*
 * What two passes take, s; fewer rounds where the second one is out of the question, or time is up.
 * False where it is up before they were drawn once each.
 */
static bool duel(cupola_gl *gl, int output, const struct warp_pass *passes,
                 const struct cupola_target *place, double end_s, double taken_s[2])
{
    double times[2][ROUNDS];
    int rounds = 0;
    time_of(gl, output, &passes[1], place); /* the first one compiles */
    while (rounds < ROUNDS && clock_now_s() < end_s) {
        for (int i = 0; i < 2; i++)
            times[i][rounds] = time_of(gl, output, &passes[i], place);
        rounds++;
        if (times[1][rounds - 1] >= 1.2 * times[0][rounds - 1])
            break;
    }
    for (int i = 0; i < 2 && rounds > 0; i++)
        taken_s[i] = median(times[i], rounds);
    return rounds > 0;
}

static bool make(cupola_gl *gl, int output, enum cupola_table stage, struct warp_pass *made,
                 struct cupola_error *error)
{
    gl->passes[output] = (struct warp_pass){.stage = stage};
    bool done = warp_views_create(gl, output, error) == CUPOLA_OK;
    if (!done) {
        warp_pass_destroy(&gl->passes[output]);
        gl_errors_drop();
    }
    *made = gl->passes[output];
    gl->passes[output] = (struct warp_pass){.stage = stage};
    return done;
}

static void note(char words[WORDS_MAX], enum cupola_table stage, double taken_s)
{
    size_t length = strlen(words);
    snprintf(words + length, WORDS_MAX - length, "%s%s %.1f ms", length ? ", " : "",
             cupola_table_name((int)stage), 1e3 * taken_s);
}

/* Leaves the fastest stage in passes[0], of which there is one already. */
static void contend(cupola_gl *gl, int output, const struct cupola_target *place,
                    struct warp_pass passes[2], char words[WORDS_MAX])
{
    struct cupola_error unwanted;
    double end_s = clock_now_s() + budget_s;
    time_of(gl, output, &passes[0], place); /* it compiles */
    for (int i = 0; i < STAGES && clock_now_s() < end_s; i++) {
        double taken_s[2];
        if (stages[i] == passes[0].stage || !is_candidate(gl, stages[i]) ||
            !make(gl, output, stages[i], &passes[1], &unwanted))
            continue;
        if (!duel(gl, output, passes, place, end_s, taken_s)) {
            warp_pass_destroy(&passes[1]);
            continue;
        }
        if (!words[0])
            note(words, passes[0].stage, taken_s[0]);
        note(words, stages[i], taken_s[1]);
        int loser = taken_s[1] < taken_s[0] ? 0 : 1;
        warp_pass_destroy(&passes[loser]);
        passes[0] = passes[1 - loser];
    }
}

/* With views of the host's there is nothing to draw yet. */
static void measure(cupola_gl *gl, int output, struct warp_pass passes[2], char words[WORDS_MAX])
{
    const struct cupola_output *size = &gl->plan.dome.rig.outputs[output];
    struct cupola_error unwanted;
    if (gl->params.storage != CUPOLA_STORAGE_ATLAS)
        return;
    GLuint texture =
        texture_create(GL_RGBA8, size->width_px, size->height_px, GL_NEAREST, &unwanted);
    GLuint framebuffer = texture ? framebuffer_create(texture, "a picture", &unwanted) : 0;
    const struct cupola_target place = {.framebuffer = framebuffer};
    if (framebuffer)
        contend(gl, output, &place, passes, words);
    else
        gl_errors_drop();
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
}

int table_choose(cupola_gl *gl, int output, struct cupola_error *error)
{
    struct warp_pass passes[2] = {{0}};
    char words[WORDS_MAX] = "";
    int first = 0;
    while (first < STAGES &&
           !(is_candidate(gl, stages[first]) && make(gl, output, stages[first], &passes[0], error)))
        first++;
    if (first == STAGES)
        return error->status;
    measure(gl, output, passes, words);
    gl->passes[output] = passes[0];
    guest_tell(&gl->guest, CUPOLA_LOG_INFO, CUPOLA_LOG_TABLE_CHOSEN,
               "output %d is warped by table stage %s: %s", output,
               cupola_table_name((int)passes[0].stage), words[0] ? words : "nothing was measured");
    return CUPOLA_OK;
}
