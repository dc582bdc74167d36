/* A camera of unknown pose. */
#include "capture/pose.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cminpack.h>

#include "angles.h"
#include "capture/pose_model.h"
#include "capture/pose_references.h"
#include "option_values.h"
#include "order.h"
#include "random.h"
#include "rotation.h"

/* A fit is one where half of the places are this near; and further starts are tried until then. */
static const double fitting_px = 1;
enum { STARTS = 40, PATCHES_LEAST = 12 };

/* What references weigh while the photographs alone decide: wrong ones must not bend the rest. */
static const double loose_reference_px = 20;

/* Beyond this the photographs do not tell it. */
static const double most_position_sd = 0.05; /* radii */
static const double most_aim_sd_rad = 0.03;

struct fit {
    struct pose_model model;
    int count; /* of residuals */
    double numbers[POSE_UNKNOWNS], trial[POSE_UNKNOWNS];
    double *residuals, *jacobian, *work, *sorted;
    int pivots[POSE_UNKNOWNS];
    double sd[POSE_UNKNOWNS]; /* by unknown */
    bool measured;            /* references, too */
};

bool pose_free_parse(const char *option, const char *text, int *free_list, char *message)
{
    static const struct {
        const char *name;
        int bits;
    } names[] = {
        {"position", POSE_POSITION}, {"aim", POSE_AIM},       {"pose", POSE_POSITION | POSE_AIM},
        {"fov", POSE_FOV},           {"center", POSE_CENTER}, {"centre", POSE_CENTER}};
    const char *at = text;

    *free_list = 0;
    while (*at) {
        size_t length = strcspn(at, ","), i = 0, count = sizeof names / sizeof *names;
        while (i < count &&
               (strlen(names[i].name) != length || strncmp(at, names[i].name, length) != 0))
            i++;
        if (i == count)
            break;
        *free_list |= names[i].bits;
        at += length;
        if (*at == ',' && at[1])
            at++;
    }
    if (*text && !*at)
        return true;
    snprintf(message, MESSAGE_SIZE,
             "%s: '%.100s' is not allowed; allowed: pose (position and aim), position, aim, fov, "
             "center, with commas between them",
             option, text);
    return false;
}

void pose_result_free(struct pose_result *result)
{
    free(result->rejected);
    free(result->reference_px);
    *result = (struct pose_result){0};
}

static bool check(const struct pose_request *request, char *message)
{
    int free_list = request->free;

    if (request->patches->count < PATCHES_LEAST) {
        snprintf(message, MESSAGE_SIZE,
                 "a camera of unknown pose needs %d marks at least, and the photographs give %d",
                 PATCHES_LEAST, request->patches->count);
        return false;
    }
    if (!pose_references_check(request, message))
        return false;
    if (request->camera->kind == CAMERA_EQUIRECTANGULAR && free_list & POSE_FOV) {
        snprintf(message, MESSAGE_SIZE,
                 "--camera-free fov: a panorama's is 360 degrees; allowed: "
                 "with an ordinary camera or a fisheye");
        return false;
    }
    if (request->camera->kind != CAMERA_RECTILINEAR && free_list & POSE_CENTER) {
        snprintf(message, MESSAGE_SIZE,
                 "--camera-free center: allowed with an ordinary camera "
                 "alone, rectilinear:FOV");
        return false;
    }
    return true;
}

static int residuals_of(void *pointer, int m, int n, const double *x, double *residuals, int flag)
{
    const struct fit *fit = pointer;

    (void)m;
    (void)n;
    (void)flag;
    pose_model_residuals(&fit->model, x, residuals);
    return 0;
}

static void descend(struct fit *fit, double *numbers)
{
    double diag[POSE_UNKNOWNS], qtf[POSE_UNKNOWNS], wa[3][POSE_UNKNOWNS];
    int calls, n = fit->model.unknown_count;

    lmdif(residuals_of, fit, fit->count, n, numbers, fit->residuals, 1e-12, 1e-10, 0, 200 * (n + 1),
          1e-14, diag, 1, 1, 0, &calls, fit->jacobian, fit->count, fit->pivots, qtf, wa[0], wa[1],
          wa[2], fit->work);
    pose_model_residuals(&fit->model, numbers, fit->residuals);
}

/* Of the patches that are not rejected. */
static double median_px(struct fit *fit)
{
    int count = 0;

    for (int i = 0; i < fit->model.request->patches->count; i++) {
        if (!fit->model.rejected[i])
            fit->sorted[count++] = pose_model_patch_px(&fit->model, fit->residuals, i);
    }
    order_sort(fit->sorted, count);
    return count > 0 ? fit->sorted[count / 2] : 0;
}

/* -1 to 1 */
static double spread(uint64_t *state)
{
    return (double)(random_next(state) >> 11) * 0x1p-52 - 1;
}

/* From the start, and where that leads nowhere from places round it. */
static bool search(struct fit *fit, char *message)
{
    uint64_t state = 1;
    double best = HUGE_VAL, radius_m = fit->model.request->rig->screen.radius_m;

    for (int start = 0; start < STARTS && best > fitting_px; start++) {
        for (int i = 0; i < fit->model.unknown_count; i++) {
            int unknown = fit->model.unknowns[i];
            bool length = unknown < POSE_CAMERA_TURN ||
                          (unknown >= POSE_PROJECTOR_POSITION && unknown < POSE_PROJECTOR_TURN);
            bool turn = !length && unknown != POSE_CAMERA_FOV && unknown < POSE_CAMERA_CENTER;
            double size = length                                   ? 0.3 * radius_m
                          : turn || unknown >= POSE_PROJECTOR_TURN ? 0.4
                                                                   : 0;
            fit->trial[i] = start == 0 ? 1 : 1 + size * spread(&state);
        }
        descend(fit, fit->trial);
        if (!(median_px(fit) < best))
            continue;
        best = median_px(fit);
        memcpy(fit->numbers, fit->trial, sizeof fit->numbers);
    }
    if (best <= fitting_px)
        return true;
    snprintf(message, MESSAGE_SIZE,
             "no pose of the camera explains the photographs: the best one is off by %.3g px of "
             "the projector for half of the marks, allowed: %g; look at --camera, the lens in "
             "--rig, the references, and the start given by --camera-position, --camera-aim",
             best, fitting_px);
    return false;
}

static bool reject(struct fit *fit, bool *rejected)
{
    double limit;
    bool changed = false;
    int count = fit->model.request->patches->count;

    descend(fit, fit->numbers);
    limit = fmax(5 * median_px(fit) / 1.1774, 0.05);
    for (int i = 0; i < count; i++) {
        if (!rejected[i] && pose_model_patch_px(&fit->model, fit->residuals, i) > limit)
            changed = rejected[i] = true;
    }
    return changed;
}

/*
 * Weighs patches and references by their own residuals. A few references say little of their noise:
 * what is usual counts as much as four numbers.
 */
static void weigh(struct fit *fit)
{
    struct pose_model *model = &fit->model;
    const double usual_count = 4;
    double patches = 0, references = usual_count * POSE_REFERENCE_SD_PX * POSE_REFERENCE_SD_PX;
    int kept = 0, count = model->request->references->count;

    for (int i = 0; i < model->request->patches->count; i++) {
        if (model->rejected[i])
            continue;
        kept++;
        patches += pow(pose_model_patch_px(model, fit->residuals, i), 2);
    }
    for (int i = 0; i < count; i++)
        references += pow(pose_model_reference_px(model, fit->residuals, i), 2);
    model->patch_sd_px = fmax(sqrt(patches / fmax(2 * kept - model->unknown_count, 1)), 1e-3);
    model->reference_sd_px = sqrt(references / (2 * count - 3 + usual_count));
}

static void deviations(struct fit *fit)
{
    int n = fit->model.unknown_count;

    covar(n, fit->jacobian, fit->count, fit->pivots, 1e-12, fit->work);
    memset(fit->sd, 0, sizeof fit->sd);
    for (int i = 0; i < n; i++) {
        double variance = fit->jacobian[(size_t)i * (size_t)fit->count + (size_t)i];
        /* covar leaves 0 where nothing is known. */
        fit->sd[fit->model.unknowns[i]] = variance > 0 ? sqrt(variance) : HUGE_VAL;
    }
}

static double largest(const double *three)
{
    return fmax(three[0], fmax(three[1], three[2]));
}

static void describe(struct fit *fit, struct pose_result *result)
{
    const struct pose_request *request = fit->model.request;
    int patches = request->patches->count, kept = 0;
    double turn[9];

    result->projector = request->rig->outputs[request->output];
    pose_model_apply(&fit->model, fit->numbers, &result->camera, result->projector.position_m,
                     turn);
    rotation_to_aim(turn, &result->projector.aim);
    result->camera_position_sd_m = largest(fit->sd + POSE_CAMERA_POSITION);
    result->camera_aim_sd_rad = largest(fit->sd + POSE_CAMERA_TURN);
    result->projector_position_sd_m = largest(fit->sd + POSE_PROJECTOR_POSITION);
    result->projector_aim_sd_rad = largest(fit->sd + POSE_PROJECTOR_TURN);
    for (int i = 0; i < patches; i++) {
        double px = pose_model_patch_px(&fit->model, fit->residuals, i);
        result->rejected_count += result->rejected[i];
        if (result->rejected[i])
            continue;
        kept++;
        result->rms_px += px * px;
        result->worst_px = fmax(result->worst_px, px);
    }
    result->rms_px = sqrt(result->rms_px / fmax(kept, 1));
    result->reference_rms_px =
        pose_references_measure(request, &result->camera, -1, result->reference_px);
    for (int i = 0; i < request->references->count; i++) {
        if (result->reference_px[i] > result->reference_px[result->worst_reference])
            result->worst_reference = i;
    }
}

static struct camera camera_of(const struct fit *fit, const double *numbers)
{
    struct camera camera;
    double projector_m[3], turn[9];

    pose_model_apply(&fit->model, numbers, &camera, projector_m, turn);
    return camera;
}

/* The one reference without which the others fit best, and how well; -1: too few to tell. */
static int find_wrong(struct fit *fit, double *rest_px)
{
    const struct pose_request *request = fit->model.request;
    int count = request->references->count, wrong = -1;

    for (int i = 0; i < count && count > 3; i++) {
        struct camera camera;
        double rms_px;
        memcpy(fit->trial, fit->numbers, sizeof fit->trial);
        fit->model.left_out = i;
        descend(fit, fit->trial);
        camera = camera_of(fit, fit->trial);
        rms_px = pose_references_measure(request, &camera, i, NULL);
        if (wrong >= 0 && !(rms_px < *rest_px))
            continue;
        wrong = i;
        *rest_px = rms_px;
    }
    fit->model.left_out = -1;
    return wrong;
}

/* While the photographs alone say how camera and projector stand to each other. */
static bool references_fit(struct fit *fit, double *off_px, char *message)
{
    const struct pose_request *request = fit->model.request;
    struct camera camera = camera_of(fit, fit->numbers);
    double rms_px = pose_references_measure(request, &camera, -1, off_px);
    double allowed_px = pose_references_allowed_px(&camera), rest_px = HUGE_VAL;
    int wrong;

    fit->measured = true;
    if (rms_px <= allowed_px)
        return true;
    wrong = find_wrong(fit, &rest_px);
    pose_references_refuse(request, off_px, rms_px, rest_px <= allowed_px ? wrong : -1, rest_px,
                           message);
    return false;
}

static bool check_result(const struct pose_request *request, const struct pose_result *result,
                         char *message)
{
    double radius_m = request->rig->screen.radius_m;
    double position = fmax(result->camera_position_sd_m, result->projector_position_sd_m);
    double aim = fmax(result->camera_aim_sd_rad, result->projector_aim_sd_rad);
    const double *at = result->projector.position_m;

    if (!(position <= most_position_sd * radius_m) || !(aim <= most_aim_sd_rad)) {
        snprintf(message, MESSAGE_SIZE,
                 "photographs and references leave positions open by %.3g m and aims by %.3g "
                 "degrees; allowed: up to %.3g m and %.3g degrees; more references, further apart, "
                 "help, and so does less in --camera-free",
                 position, aim * deg_per_rad, most_position_sd * radius_m,
                 most_aim_sd_rad * deg_per_rad);
        return false;
    }
    if (sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]) < radius_m)
        return true;
    snprintf(message, MESSAGE_SIZE,
             "the projector would stand at (%g, %g, %g) m, outside of the screen; look at --camera "
             "and at the references",
             at[0], at[1], at[2]);
    return false;
}

static bool solve(struct fit *fit, struct pose_result *result, char *message)
{
    fit->model.reference_sd_px = loose_reference_px;
    if (!search(fit, message))
        return false;
    for (int round = 0; round < 5 && reject(fit, result->rejected); round++)
        continue;
    if (!references_fit(fit, result->reference_px, message))
        return false;
    fit->model.reference_sd_px = POSE_REFERENCE_SD_PX;
    descend(fit, fit->numbers);
    weigh(fit);
    descend(fit, fit->numbers);
    deviations(fit);
    describe(fit, result);
    return check_result(fit->model.request, result, message);
}

bool pose_solve(const struct pose_request *request, struct pose_result *result, char *message)
{
    struct fit fit = {0};
    size_t count;
    bool done = false;

    *result = (struct pose_result){0};
    if (!check(request, message))
        return false;
    result->rejected = calloc((size_t)request->patches->count, sizeof *result->rejected);
    result->reference_px = calloc((size_t)request->references->count, sizeof *result->reference_px);
    pose_model_begin(request, result->rejected, &fit.model);
    fit.count = pose_model_residual_count(&fit.model);
    count = (size_t)fit.count;
    fit.residuals = calloc(count, sizeof *fit.residuals);
    fit.work = calloc(count, sizeof *fit.work);
    fit.sorted = calloc(count, sizeof *fit.sorted);
    fit.jacobian = calloc(count * POSE_UNKNOWNS, sizeof *fit.jacobian);
    if (!result->rejected || !result->reference_px || !fit.residuals || !fit.work || !fit.sorted ||
        !fit.jacobian)
        snprintf(message, MESSAGE_SIZE, "out of memory for %d marks", request->patches->count);
    else
        done = solve(&fit, result, message);
    free(fit.residuals);
    free(fit.work);
    free(fit.sorted);
    free(fit.jacobian);
    if (!done && !fit.measured)
        pose_result_free(result);
    return done;
}
