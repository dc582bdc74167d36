/* One scene through one lens: every method's picture beside the truth. */
#include "trial.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <epoxy/gl.h>

#include "cut_out.h"
#include "frame.h"
#include "srgb.h"

/* A method that is being judged. */
struct judged {
    cupola_gl *gl;
    unsigned char *picture; /* RGB of 8 bits */
    unsigned char *before;  /* of the step before */
    double squares;         /* of changes that are not the truth's */
};

struct court {
    struct setting *setting;
    const char *name;
    const struct method *methods;
    int count;
    const struct trial_wishes *wishes;
    struct judged judged[METHODS_MAX];
    struct truth *truth;
    float *wished, *wished_before; /* the truth, encoded: RGB, 0 to 255 */
    unsigned char *wished_bytes;
    unsigned char *counts;
    unsigned char *rgba;
    size_t pixels, counting;
    double change_squares;
};

static void court_destroy(struct court *court)
{
    for (int i = 0; i < court->count; i++) {
        cupola_gl_destroy(&court->judged[i].gl);
        free(court->judged[i].picture);
        free(court->judged[i].before);
    }
    truth_destroy(court->truth);
    free(court->wished);
    free(court->wished_before);
    free(court->wished_bytes);
    free(court->counts);
    free(court->rgba);
}

static bool make_memory(struct court *court, char *message)
{
    size_t pixels = court->pixels;
    bool made;

    court->wished = malloc(3 * pixels * sizeof(float));
    court->wished_before = malloc(3 * pixels * sizeof(float));
    court->wished_bytes = malloc(3 * pixels);
    court->counts = malloc(pixels);
    court->rgba = malloc(4 * pixels);
    made = court->wished && court->wished_before && court->wished_bytes && court->counts &&
           court->rgba;
    for (int i = 0; i < court->count; i++) {
        court->judged[i].picture = malloc(3 * pixels);
        court->judged[i].before = malloc(3 * pixels);
        made = made && court->judged[i].picture && court->judged[i].before;
    }
    if (!made)
        snprintf(message, MESSAGE_SIZE, "out of memory");
    return made;
}

/* What is drawn into windows and files: encoded colours, mixed as light. */
static struct cupola_gl_params judged_params(const struct setting *setting,
                                             const struct cupola_filter *filter)
{
    struct cupola_gl_params params = setting->gl;

    params.format = CUPOLA_FORMAT_SRGB8;
    params.encoding = CUPOLA_ENCODING_SRGB;
    params.filter = *filter;
    return params;
}

static bool make_methods(struct court *court, char *message)
{
    const struct cupola_plan_params wishes = {.density = court->setting->density};
    struct cupola_error error = {0};
    cupola_plan *plan = NULL;

    if (cupola_plan_create(court->setting->dome, &wishes, &plan, &error) < 0) {
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
        return false;
    }
    for (int i = 0; i < court->count; i++) {
        struct cupola_gl_params params = judged_params(court->setting, &court->methods[i].filter);
        if (cupola_gl_create(plan, &params, &court->judged[i].gl, &error) < 0) {
            snprintf(message, MESSAGE_SIZE, "%s: %.900s", court->methods[i].name, error.message);
            break;
        }
    }
    cupola_plan_destroy(&plan);
    return court->judged[court->count - 1].gl;
}

/* Pixels whose middle is inside the image circle: r < 1. */
static void find_pixels(struct court *court)
{
    const struct cupola_circle *circle = &cupola_dome_rig(court->setting->dome)->outputs[0].circle;
    int size_px = court->setting->size_px;

    for (int j = 0; j < size_px; j++)
        for (int i = 0; i < size_px; i++) {
            double x = i + 0.5 - circle->center_x_px, y = j + 0.5 - circle->center_y_px;
            bool inside = hypot(x, y) < circle->radius_px;
            court->counts[j * size_px + i] = inside;
            court->counting += inside;
        }
}

static bool court_create(struct court *court, char *message)
{
    court->pixels = (size_t)court->setting->size_px * (size_t)court->setting->size_px;
    if (!make_memory(court, message) || !make_methods(court, message))
        return false;
    find_pixels(court);
    court->truth = truth_create(court->setting, court->wishes->reference_density, message);
    return court->truth;
}

static bool draw_truth(struct court *court, int rays, char *message)
{
    float *before = court->wished;

    court->wished = court->wished_before;
    court->wished_before = before;
    if (!truth_draw(court->truth, rays, court->wished, message))
        return false;
    for (size_t i = 0; i < 3 * court->pixels; i++) {
        court->wished[i] = (float)(255 * light_encoded(fmin((double)court->wished[i], 1)));
        court->wished_bytes[i] = (unsigned char)lround((double)court->wished[i]);
    }
    return true;
}

static bool draw_method(struct court *court, int index, char *message)
{
    struct judged *judged = &court->judged[index];
    unsigned char *before = judged->picture;
    const struct setting *setting = court->setting;
    const struct cupola_target target = {.framebuffer = setting->target.framebuffer};

    judged->picture = judged->before;
    judged->before = before;
    if (!frame_draw(judged->gl, setting, &target, message))
        return false;
    glBindFramebuffer(GL_FRAMEBUFFER, setting->target.framebuffer);
    glReadPixels(0, 0, setting->size_px, setting->size_px, GL_RGBA, GL_UNSIGNED_BYTE, court->rgba);
    for (size_t i = 0; i < court->pixels; i++)
        memcpy(judged->picture + 3 * i, court->rgba + 4 * i, 3);
    return true;
}

/* Adds the squares of what changed since the step before. */
static void add_changes(struct court *court)
{
    for (size_t at = 0; at < 3 * court->pixels; at++) {
        if (!court->counts[at / 3])
            continue;
        double wished = (double)court->wished[at] - (double)court->wished_before[at];
        court->change_squares += wished * wished;
        for (int i = 0; i < court->count; i++) {
            const struct judged *judged = &court->judged[i];
            double error = judged->picture[at] - judged->before[at] - wished;
            court->judged[i].squares += error * error;
        }
    }
}

static bool judge_pictures(struct court *court, struct trial *trial, char *message)
{
    int size_px = court->setting->size_px;
    const struct cut_out *cut_out = &court->wishes->cut_out;

    if (!cut_out_write(cut_out, court->name, "reference", court->wished_bytes, size_px, message))
        return false;
    for (int i = 0; i < court->count; i++) {
        const struct picture_pair pair = {size_px, size_px, court->wished_bytes,
                                          court->judged[i].picture, court->counts};
        if (!similarity_of(&pair, &trial->verdicts[i].likeness)) {
            snprintf(message, MESSAGE_SIZE, "out of memory");
            return false;
        }
        if (!cut_out_write(cut_out, court->name, court->methods[i].name, court->judged[i].picture,
                           size_px, message))
            return false;
    }
    return true;
}

static bool draw_all(struct court *court, int rays, char *message)
{
    if (!draw_truth(court, rays, message))
        return false;
    for (int i = 0; i < court->count; i++)
        if (!draw_method(court, i, message))
            return false;
    return true;
}

static bool turn_camera(struct court *court, struct trial *trial, char *message)
{
    int steps = court->wishes->steps, rays = court->wishes->shimmer_rays;
    double changes = 3.0 * (double)court->counting * (steps > 0 ? steps : 1);

    trial->pixels = (double)court->counting;
    if (!draw_all(court, court->wishes->rays, message) || !judge_pictures(court, trial, message) ||
        (steps > 0 && !draw_truth(court, rays, message)))
        return false;
    for (int step = 1; step <= steps; step++) {
        setting_turn(court->setting, court->wishes->yaw_rad * step / steps);
        if (!draw_all(court, rays, message))
            return false;
        add_changes(court);
    }
    setting_turn(court->setting, 0);
    trial->change = sqrt(court->change_squares / changes);
    for (int i = 0; i < court->count; i++)
        trial->verdicts[i].shimmer = sqrt(court->judged[i].squares / changes);
    return true;
}

/* The warps, in blits, and the whole frames, in those of the first method. */
static bool measure(struct setting *setting, const struct method *methods, int count,
                    const struct trial_wishes *wishes, struct trial *trial, char *message)
{
    struct contender contenders[METHODS_MAX + 1] = {{"blit", &contender_blit, 0}};
    struct cupola_filter filters[METHODS_MAX];
    struct comparison_wishes cost = wishes->cost;
    struct result warps[METHODS_MAX + 1], frames[METHODS_MAX];

    for (int i = 0; i < count; i++) {
        filters[i] = methods[i].filter;
        contenders[1 + i] = (struct contender){.kind = &contender_listed, .variant = i};
        snprintf(contenders[1 + i].name, sizeof contenders[1 + i].name, "%.31s", methods[i].name);
    }
    setting->filters = filters;
    cost.warp_alone = true;
    bool done = compare_contenders(setting, contenders, 1 + count, &cost, NULL, warps, message);
    cost.warp_alone = false;
    done = done && compare_contenders(setting, contenders + 1, count, &cost, NULL, frames, message);
    setting->filters = NULL;
    if (!done)
        return false;
    trial->blit_ms = warps[0].time_ms.median;
    for (int i = 0; i < count; i++) {
        trial->verdicts[i].warp_ms = warps[1 + i].time_ms.median;
        trial->verdicts[i].warp_blits = warps[1 + i].ratio;
        trial->verdicts[i].frame_ms = frames[i].time_ms.median;
        trial->verdicts[i].frame_ratio = frames[i].ratio;
    }
    return true;
}

bool trial_run(struct setting *setting, const char *name, const struct method *methods, int count,
               const struct trial_wishes *wishes, struct trial *trial, char *message)
{
    struct court court = {
        .setting = setting, .name = name, .methods = methods, .count = count, .wishes = wishes};

    *trial = (struct trial){.pixels = 0};
    bool done = court_create(&court, message) && turn_camera(&court, trial, message);
    court_destroy(&court);
    done = done && (!wishes->check || truth_check_run(setting, wishes->reference_density,
                                                      wishes->rays, &trial->check, message));
    return done &&
           (wishes->cost.frames == 0 || measure(setting, methods, count, wishes, trial, message));
}
