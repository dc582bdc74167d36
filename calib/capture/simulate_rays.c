/* A simulated camera by rays. */
#include "capture/simulate_rays.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cupola/projection.h>

#include "option_values.h"

enum { PARTS = 2 /* of a pixel, each way */ };

/* What a part of a pixel sees. */
struct glimpse {
    float place_px[2];
    enum { GLIMPSE_NOTHING, GLIMPSE_SCREEN, GLIMPSE_LIT } kind;
};

struct ray_camera {
    int width, height;
    double ambient;
    struct glimpse *glimpses; /* those of a pixel one after the other */
};

/* Whether a place sees the screen, and its point. */
static bool look(const struct simulation *simulation, double x_px, double y_px, double point_m[3])
{
    const struct cupola_screen *screen = &simulation->rig->screen;
    const double at[2] = {x_px, y_px};
    double ray[3];

    return camera_ray(simulation->camera, at, ray) &&
           camera_meets_sphere(simulation->camera->position_m, ray, screen->radius_m, point_m) &&
           -point_m[2] >= screen->radius_m * cos(screen->cap_rad);
}

static bool is_lit(const struct cupola_output *output, const double place_px[2])
{
    double x = place_px[0] - output->circle.center_x_px;
    double y = place_px[1] - output->circle.center_y_px;

    return hypot(x, y) <= output->circle.radius_px && place_px[0] >= 0 && place_px[1] >= 0 &&
           place_px[0] <= output->width_px && place_px[1] <= output->height_px;
}

/* Row j of the picture's pixels. points_m and places_px have room for all of its parts. */
static void look_along(const struct simulation *simulation, int j, struct glimpse *glimpses,
                       double *points_m, double *places_px)
{
    const struct cupola_output *output = &simulation->rig->outputs[simulation->output];
    int count = simulation->camera->width * PARTS * PARTS;

    for (int k = 0; k < count; k++) {
        int i = k / (PARTS * PARTS), part = k % (PARTS * PARTS);
        double *point = points_m + 3 * (size_t)k;
        bool seen = look(simulation, i + (part % PARTS + 0.5) / PARTS,
                         j + (double)(part / PARTS) / PARTS + 0.5 / PARTS, point);
        glimpses[k].kind = seen ? GLIMPSE_SCREEN : GLIMPSE_NOTHING;
        if (!seen) /* any point that is possible */
            memcpy(point, (double[3]){0, 0, -2 * simulation->rig->screen.radius_m},
                   3 * sizeof *point);
    }
    cupola_output_pixels(output, count, points_m, places_px, NULL);
    for (int k = 0; k < count; k++) {
        const double *place = places_px + 2 * (size_t)k;
        if (glimpses[k].kind == GLIMPSE_SCREEN && is_lit(output, place))
            glimpses[k].kind = GLIMPSE_LIT;
        glimpses[k].place_px[0] = (float)place[0];
        glimpses[k].place_px[1] = (float)place[1];
    }
}

static bool look_everywhere(const struct simulation *simulation, struct ray_camera *camera)
{
    size_t row = (size_t)camera->width * PARTS * PARTS;
    double *points_m = malloc(3 * row * sizeof *points_m);
    double *places_px = calloc(2 * row, sizeof *places_px);
    bool done = points_m && places_px;

    for (int j = 0; done && j < camera->height; j++)
        look_along(simulation, j, camera->glimpses + (size_t)j * row, points_m, places_px);
    free(points_m);
    free(places_px);
    return done;
}

struct ray_camera *ray_camera_create(const struct simulation *simulation, char *message)
{
    struct ray_camera *camera = calloc(1, sizeof *camera);
    size_t count;

    if (camera) {
        camera->width = simulation->camera->width;
        camera->height = simulation->camera->height;
        camera->ambient = simulation->ambient;
        count = (size_t)camera->width * (size_t)camera->height * PARTS * PARTS;
        camera->glimpses = malloc(count * sizeof *camera->glimpses);
    }
    if (!camera || !camera->glimpses || !look_everywhere(simulation, camera)) {
        snprintf(message, MESSAGE_SIZE, "out of memory for a camera of %dx%d pixels",
                 simulation->camera->width, simulation->camera->height);
        ray_camera_destroy(camera);
        return NULL;
    }
    return camera;
}

void ray_camera_destroy(struct ray_camera *camera)
{
    if (!camera)
        return;
    free(camera->glimpses);
    free(camera);
}

static int clamp(int value, int most)
{
    return value < 0 ? 0 : value > most ? most : value;
}

static double bilinear(const struct photo *shown, const float place_px[2])
{
    double x = (double)place_px[0] - 0.5, y = (double)place_px[1] - 0.5, light = 0;
    int i = (int)floor(x), j = (int)floor(y);

    for (int corner = 0; corner < 4; corner++) {
        int a = i + corner % 2, b = j + corner / 2;
        double weight = (1 - fabs(x - a)) * (1 - fabs(y - b));
        light += weight *
                 (double)shown->light[(size_t)clamp(b, shown->height - 1) * (size_t)shown->width +
                                      (size_t)clamp(a, shown->width - 1)];
    }
    return light;
}

void ray_camera_take(const struct ray_camera *camera, const struct photo *shown,
                     struct photo *photo)
{
    const struct glimpse *glimpse = camera->glimpses;
    size_t count = (size_t)camera->width * (size_t)camera->height;

    for (size_t i = 0; i < count; i++) {
        double light = 0;
        for (int part = 0; part < PARTS * PARTS; part++, glimpse++) {
            if (glimpse->kind != GLIMPSE_NOTHING)
                light += camera->ambient;
            if (glimpse->kind == GLIMPSE_LIT)
                light += bilinear(shown, glimpse->place_px);
        }
        photo->light[i] = (float)(light / (PARTS * PARTS));
    }
}
