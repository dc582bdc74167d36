/* The unknowns of a camera and a projector. */
#include "capture/pose_model.h"

#include <math.h>
#include <string.h>

#include <cupola/projection.h>

#include "rotation.h"

static void add_unknowns(struct pose_model *model, int first, int count)
{
    for (int i = first; i < first + count; i++)
        model->unknowns[model->unknown_count++] = i;
}

void pose_model_begin(const struct pose_request *request, const bool *rejected,
                      struct pose_model *model)
{
    const struct cupola_output *output = &request->rig->outputs[request->output];

    *model = (struct pose_model){.request = request,
                                 .rejected = rejected,
                                 .lens = *output,
                                 .patch_sd_px = 0.1,
                                 .left_out = -1,
                                 .reference_sd_px = POSE_REFERENCE_SD_PX};
    memset(model->lens.position_m, 0, sizeof model->lens.position_m);
    model->lens.aim = (struct cupola_aim){0};
    rotation_from_aim(&output->aim, model->start_projector);
    if (request->free & POSE_POSITION)
        add_unknowns(model, POSE_CAMERA_POSITION, 3);
    if (request->free & POSE_AIM)
        add_unknowns(model, POSE_CAMERA_TURN, 3);
    if (request->free & POSE_FOV)
        add_unknowns(model, POSE_CAMERA_FOV, 1);
    if (request->free & POSE_CENTER)
        add_unknowns(model, POSE_CAMERA_CENTER, 2);
    add_unknowns(model, POSE_PROJECTOR_POSITION, 6);
}

int pose_model_residual_count(const struct pose_model *model)
{
    return 2 * model->request->patches->count + 3 * model->request->references->count;
}

void pose_model_apply(const struct pose_model *model, const double *numbers, struct camera *camera,
                      double projector_m[3], double projector_turn[9])
{
    const struct pose_request *request = model->request;
    double all[POSE_UNKNOWNS] = {0}, turn[9];

    for (int i = 0; i < model->unknown_count; i++)
        all[model->unknowns[i]] = numbers[i] - 1;
    *camera = *request->camera;
    rotation_from_vector(all + POSE_CAMERA_TURN, turn);
    rotation_multiply(request->camera->rotation, turn, camera->rotation);
    for (int i = 0; i < 3; i++) {
        camera->position_m[i] += all[POSE_CAMERA_POSITION + i];
        projector_m[i] =
            request->rig->outputs[request->output].position_m[i] + all[POSE_PROJECTOR_POSITION + i];
    }
    camera->fov_rad = fmin(fmax(camera->fov_rad + all[POSE_CAMERA_FOV], 0.01), 3.1);
    if (camera->kind == CAMERA_FISHEYE)
        camera->fisheye.lens.fov_rad =
            fmin(fmax(camera->fisheye.lens.fov_rad + all[POSE_CAMERA_FOV], 0.01), 6.28);
    camera->center_px[0] += all[POSE_CAMERA_CENTER];
    camera->center_px[1] += all[POSE_CAMERA_CENTER + 1];
    rotation_from_vector(all + POSE_PROJECTOR_TURN, turn);
    rotation_multiply(model->start_projector, turn, projector_turn);
}

static void patch_residual(const struct pose_model *model, const struct patch *patch,
                           const struct camera *camera, const double projector_m[3],
                           const double turn[9], double residual[2])
{
    double ray[3], point[3], own[3], place[2] = {1e4, 1e4};

    camera_ray(camera, patch->camera_px, ray);
    camera_meets_sphere(camera->position_m, ray, model->request->rig->screen.radius_m, point);
    for (int i = 0; i < 3; i++)
        point[i] -= projector_m[i];
    rotation_apply_back(turn, point, own);
    cupola_output_pixel(&model->lens, own, place, NULL);
    for (int k = 0; k < 2; k++)
        residual[k] = (place[k] - patch->projector_px[k]) / model->patch_sd_px;
}

/* Of unit vectors, so that it is smooth also where the point lies behind the camera. */
static void reference_residual(const struct pose_model *model, const struct mark *mark,
                               const struct camera *camera, double residual[3])
{
    double radius_m = model->request->rig->screen.radius_m;
    bool directions = model->request->references->kind == MARKS_DIRECTIONS;
    double ray[3], way[3], length = 0;

    camera_ray(camera, mark->pixel_px, ray);
    for (int i = 0; i < 3; i++) {
        way[i] = mark->place[i] * (directions ? radius_m : 1) - camera->position_m[i];
        length += way[i] * way[i];
    }
    length = fmax(sqrt(length), 1e-9);
    for (int i = 0; i < 3; i++)
        residual[i] = (ray[i] - way[i] / length) /
                      (model->reference_sd_px * camera_pixel_rad(model->request->camera));
}

void pose_model_residuals(const struct pose_model *model, const double *numbers, double *residuals)
{
    const struct pose_request *request = model->request;
    struct camera camera;
    double projector_m[3], turn[9];

    pose_model_apply(model, numbers, &camera, projector_m, turn);
    for (int i = 0; i < request->patches->count; i++, residuals += 2) {
        if (model->rejected[i])
            residuals[0] = residuals[1] = 0;
        else
            patch_residual(model, &request->patches->list[i], &camera, projector_m, turn,
                           residuals);
    }
    for (int i = 0; i < request->references->count; i++, residuals += 3) {
        reference_residual(model, &request->references->list[i], &camera, residuals);
        if (i == model->left_out)
            residuals[0] = residuals[1] = residuals[2] = 0;
    }
}

double pose_model_patch_px(const struct pose_model *model, const double *residuals, int patch)
{
    return model->patch_sd_px * hypot(residuals[2 * patch], residuals[2 * patch + 1]);
}

double pose_model_reference_px(const struct pose_model *model, const double *residuals,
                               int reference)
{
    const double *r = residuals + 2 * model->request->patches->count + 3 * reference;

    return model->reference_sd_px * sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
}
