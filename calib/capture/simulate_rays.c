/* A simulated camera by rays. */
#include "capture/simulate_rays.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

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

static struct glimpse look(const struct simulation *simulation, double x_px, double y_px)
{
    const struct cupola_screen *screen = &simulation->rig->screen;
    const struct cupola_output *output = &simulation->rig->outputs[simulation->output];
    const double at[2] = {x_px, y_px};
    double ray[3], point[3], place[2];
    struct glimpse glimpse = {.kind = GLIMPSE_NOTHING};

    if (!camera_ray(simulation->camera, at, ray) ||
        !camera_meets_sphere(simulation->camera->position_m, ray, screen->radius_m, point) ||
        -point[2] < screen->radius_m * cos(screen->cap_rad))
        return glimpse;
    glimpse.kind = GLIMPSE_SCREEN;
    if (cupola_output_pixel(output, point, place, NULL) != 1)
        return glimpse;
    glimpse.kind = GLIMPSE_LIT;
    glimpse.place_px[0] = (float)place[0];
    glimpse.place_px[1] = (float)place[1];
    return glimpse;
}

struct ray_camera *ray_camera_create(const struct simulation *simulation, char *message)
{
    struct ray_camera *camera = calloc(1, sizeof *camera);
    struct glimpse *glimpse;
    size_t count;

    if (camera) {
        camera->width = simulation->camera->width;
        camera->height = simulation->camera->height;
        camera->ambient = simulation->ambient;
        count = (size_t)camera->width * (size_t)camera->height * PARTS * PARTS;
        camera->glimpses = malloc(count * sizeof *camera->glimpses);
    }
    if (!camera || !camera->glimpses) {
        snprintf(message, MESSAGE_SIZE, "out of memory for a camera of %dx%d pixels",
                 simulation->camera->width, simulation->camera->height);
        ray_camera_destroy(camera);
        return NULL;
    }
    glimpse = camera->glimpses;
    for (int j = 0; j < camera->height; j++) {
        for (int i = 0; i < camera->width; i++) {
            for (int part = 0; part < PARTS * PARTS; part++)
                *glimpse++ = look(simulation, i + (part % PARTS + 0.5) / PARTS,
                                  j + (double)(part / PARTS) / PARTS + 0.5 / PARTS);
        }
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
