/* Cameras. */
#include "capture/camera.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include <cupola/projection.h>

#include "angles.h"
#include "option_values.h"
#include "rotation.h"

static bool parse_fov(const char *option, const char *text, struct number_range range, double *fov,
                      char *message)
{
    struct value_context context = {option, message};

    return value_number(&context, text, range, fov);
}

static bool refuse(const char *option, const char *text, char *message)
{
    snprintf(message, MESSAGE_SIZE,
             "%s: '%.100s' is not allowed; allowed: rectilinear:FOV, equirectangular, angular:FOV, "
             "hemispheric:FOV, equisolid:FOV, stereographic:FOV, degrees",
             option, text);
    return false;
}

bool camera_parse(const char *option, const char *text, struct camera *camera, char *message)
{
    const char *colon = strchr(text, ':');
    size_t length = colon ? (size_t)(colon - text) : strlen(text);
    char name[32];
    struct cupola_error error = {0};
    int model;

    *camera = (struct camera){.rotation = {1, 0, 0, 0, 1, 0, 0, 0, 1}};
    if (length >= sizeof name)
        return refuse(option, text, message);
    memcpy(name, text, length);
    name[length] = 0;
    if (strcmp(name, "equirectangular") == 0 && !colon) {
        camera->kind = CAMERA_EQUIRECTANGULAR;
        return true;
    }
    if (strcmp(name, "rectilinear") == 0 && colon) {
        camera->kind = CAMERA_RECTILINEAR;
        return parse_fov(option, colon + 1,
                         (struct number_range){.low = 1, .high = 170, .degrees = true},
                         &camera->fov_rad, message);
    }
    model = cupola_lens_model_find(name);
    if (model < 0 || model == CUPOLA_LENS_POLYNOMIAL || model == CUPOLA_LENS_TABLE || !colon)
        return refuse(option, text, message);
    camera->fisheye.lens.model = (enum cupola_lens_model)model;
    if (!parse_fov(option, colon + 1, (struct number_range){.low = 1, .high = 360, .degrees = true},
                   &camera->fisheye.lens.fov_rad, message))
        return false;
    if (cupola_lens_validate(&camera->fisheye.lens, &error) >= 0)
        return true;
    snprintf(message, MESSAGE_SIZE, "%s: %s", option, error.message);
    return false;
}

bool camera_fit(struct camera *camera, int width, int height, const struct cupola_circle *circle,
                char *message)
{
    struct cupola_rig rig = {0};
    struct cupola_error error = {0};

    camera->width = width;
    camera->height = height;
    camera->center_px[0] = 0.5 * width;
    camera->center_px[1] = 0.5 * height;
    if (camera->kind == CAMERA_EQUIRECTANGULAR && width != 2 * height) {
        snprintf(message, MESSAGE_SIZE,
                 "--camera equirectangular: the photographs are %d x %d px; allowed: twice as wide "
                 "as high",
                 width, height);
        return false;
    }
    if (camera->kind != CAMERA_FISHEYE)
        return true;
    camera->fisheye.width_px = width;
    camera->fisheye.height_px = height;
    if (circle)
        camera->fisheye.circle = *circle;
    rig.output_count = 1;
    rig.outputs[0] = camera->fisheye;
    if (cupola_rig_complete(&rig, &rig, &error) < 0) {
        snprintf(message, MESSAGE_SIZE, "--camera, --camera-circle: %s", error.message);
        return false;
    }
    camera->fisheye = rig.outputs[0];
    return true;
}

void camera_aim(struct camera *camera, double tilt_rad, const struct cupola_aim *aim)
{
    double untilt[9], turn[9];

    rotation_from_tilt(-tilt_rad, untilt);
    rotation_from_aim(aim, turn);
    rotation_multiply(untilt, turn, camera->rotation);
}

void camera_aim_of(const struct camera *camera, double tilt_rad, struct cupola_aim *aim)
{
    double tilt[9], turn[9];

    rotation_from_tilt(tilt_rad, tilt);
    rotation_multiply(tilt, camera->rotation, turn);
    rotation_to_aim(turn, aim);
}

/* In the camera's own frame, any length. */
static bool own_ray(const struct camera *camera, const double place_px[2], double ray[3])
{
    const struct cupola_circle *circle = &camera->fisheye.circle;
    double x, y, r, angle;

    if (camera->kind == CAMERA_RECTILINEAR) {
        double focal_px = 0.5 * camera->width / tan(0.5 * camera->fov_rad);
        ray[0] = (place_px[0] - camera->center_px[0]) / focal_px;
        ray[1] = (place_px[1] - camera->center_px[1]) / focal_px;
        ray[2] = -1;
        return true;
    }
    if (camera->kind == CAMERA_EQUIRECTANGULAR) {
        double right = 2 * pi * (place_px[0] / camera->width - 0.5);
        double up = pi * (place_px[1] / camera->height - 0.5);
        ray[0] = sin(right) * cos(up);
        ray[1] = sin(up);
        ray[2] = -cos(right) * cos(up);
        return true;
    }
    x = (place_px[0] - circle->center_x_px) / circle->radius_px;
    y = (place_px[1] - circle->center_y_px) / circle->radius_px;
    r = hypot(x, y);
    angle = cupola_lens_angle(&camera->fisheye.lens, r);
    ray[0] = r > 0 ? sin(angle) * x / r : 0;
    ray[1] = r > 0 ? sin(angle) * y / r : 0;
    ray[2] = -cos(angle);
    return r <= 1;
}

bool camera_ray(const struct camera *camera, const double place_px[2], double ray[3])
{
    double own[3], length;
    bool inside = own_ray(camera, place_px, own);

    length = sqrt(own[0] * own[0] + own[1] * own[1] + own[2] * own[2]);
    rotation_apply(camera->rotation, own, ray);
    for (int i = 0; i < 3; i++)
        ray[i] /= length;
    return inside;
}

bool camera_place(const struct camera *camera, const double point_m[3], double place_px[2])
{
    double way_m[3], own[3];

    for (int i = 0; i < 3; i++)
        way_m[i] = point_m[i] - camera->position_m[i];
    rotation_apply_back(camera->rotation, way_m, own);
    if (camera->kind == CAMERA_FISHEYE)
        return cupola_output_pixel(&camera->fisheye, own, place_px, NULL) == 1;
    if (camera->kind == CAMERA_RECTILINEAR) {
        double focal_px = 0.5 * camera->width / tan(0.5 * camera->fov_rad);
        if (!(own[2] < 0))
            return false;
        place_px[0] = camera->center_px[0] - focal_px * own[0] / own[2];
        place_px[1] = camera->center_px[1] - focal_px * own[1] / own[2];
    } else {
        place_px[0] = camera->width * (0.5 + atan2(own[0], -own[2]) / (2 * pi));
        place_px[1] = camera->height * (0.5 + atan2(own[1], hypot(own[0], own[2])) / pi);
    }
    return place_px[0] >= 0 && place_px[0] <= camera->width && place_px[1] >= 0 &&
           place_px[1] <= camera->height;
}

bool camera_meets_sphere(const double position_m[3], const double ray[3], double radius_m,
                         double point_m[3])
{
    double along = 0, square = 0, rest, t;

    for (int i = 0; i < 3; i++) {
        along += position_m[i] * ray[i];
        square += position_m[i] * position_m[i];
    }
    rest = along * along - square + radius_m * radius_m;
    t = -along + sqrt(fmax(rest, 0));
    for (int i = 0; i < 3; i++)
        point_m[i] = position_m[i] + t * ray[i];
    return rest > 0 && t > 0;
}

double camera_pixel_rad(const struct camera *camera)
{
    double cosine = 0, a[3], b[3];
    const struct cupola_circle *circle = &camera->fisheye.circle;
    double middle[2] = {camera->center_px[0], camera->center_px[1]}, beside[2];

    if (camera->kind == CAMERA_FISHEYE) {
        middle[0] = circle->center_x_px;
        middle[1] = circle->center_y_px;
    }
    beside[0] = middle[0] + 1;
    beside[1] = middle[1];
    camera_ray(camera, middle, a);
    camera_ray(camera, beside, b);
    for (int i = 0; i < 3; i++)
        cosine += (a[i] - b[i]) * (a[i] - b[i]);
    return sqrt(cosine);
}
