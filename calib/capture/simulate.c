/* Photographs of a simulated theatre: light from the screen, then what a camera makes of it. */
#include "capture/simulate.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "angles.h"
#include "capture/simulate_gl.h"
#include "capture/simulate_rays.h"
#include "option_values.h"
#include "random.h"

/* Of the noise's variance at full white, what is there without light. */
static const double read_part = 0.25;

enum { BLUR_REACH_MAX = 64 };

struct simulator {
    struct simulation simulation;
    struct ray_camera *rays; /* one of the two */
    struct gl_camera *gl;
    uint64_t state;
};

static struct simulator *create(const struct simulation *simulation, bool rays, char *message)
{
    struct simulator *simulator = calloc(1, sizeof *simulator);

    if (!simulator) {
        snprintf(message, MESSAGE_SIZE, "out of memory for a camera");
        return NULL;
    }
    simulator->simulation = *simulation;
    simulator->state = simulation->seed;
    if (!rays && simulation->camera->kind == CAMERA_RECTILINEAR)
        simulator->gl = gl_camera_create(simulation, message);
    if (!simulator->gl)
        simulator->rays = ray_camera_create(simulation, message);
    if (simulator->gl || simulator->rays)
        return simulator;
    free(simulator);
    return NULL;
}

struct simulator *simulator_create(const struct simulation *simulation, char *message)
{
    return create(simulation, false, message);
}

struct simulator *simulator_create_by_rays(const struct simulation *simulation, char *message)
{
    return create(simulation, true, message);
}

bool simulator_uses_gl(const struct simulator *simulator)
{
    return simulator->gl != NULL;
}

void simulator_destroy(struct simulator *simulator)
{
    if (!simulator)
        return;
    ray_camera_destroy(simulator->rays);
    gl_camera_destroy(simulator->gl);
    free(simulator);
}

/* By cos^4 of an angle that grows from the middle, as a thin lens has it. */
static double vignette(const struct simulation *simulation, int i, int j)
{
    double x = (i + 0.5) / simulation->camera->width - 0.5;
    double y = (j + 0.5) / simulation->camera->height - 0.5;
    double corner = 1 / sqrt(1 - simulation->vignetting) - 1; /* square of its tangent */
    double square = 2 * (x * x + y * y) * corner;

    return 1 / ((1 + square) * (1 + square));
}

static void expose(const struct simulation *simulation, struct photo *photo)
{
    for (int j = 0; j < photo->height; j++) {
        for (int i = 0; i < photo->width; i++)
            photo->light[(size_t)j * (size_t)photo->width + (size_t)i] *=
                (float)(simulation->exposure * vignette(simulation, i, j));
    }
}

/* One line of `count` numbers, `stride` apart, blurred by weights to both sides. */
static void blur_line(float *line, int count, size_t stride, const double *weights, int reach,
                      float *copy)
{
    for (int i = 0; i < count; i++)
        copy[i] = line[(size_t)i * stride];
    for (int i = 0; i < count; i++) {
        double sum = 0;
        for (int k = -reach; k <= reach; k++) {
            int at = i + k < 0 ? 0 : i + k >= count ? count - 1 : i + k;
            sum += weights[k < 0 ? -k : k] * (double)copy[at];
        }
        line[(size_t)i * stride] = (float)sum;
    }
}

static bool blur(double sd_px, struct photo *photo, char *message)
{
    double weights[BLUR_REACH_MAX + 1], sum = 0;
    int reach = (int)ceil(3.5 * sd_px);
    int longest = photo->width > photo->height ? photo->width : photo->height;
    float *copy;

    if (!(sd_px > 0))
        return true;
    reach = reach > BLUR_REACH_MAX ? BLUR_REACH_MAX : reach;
    copy = malloc((size_t)longest * sizeof *copy);
    if (!copy) {
        snprintf(message, MESSAGE_SIZE, "out of memory for a photograph");
        return false;
    }
    for (int k = 0; k <= reach; k++) {
        weights[k] = exp(-0.5 * k * k / (sd_px * sd_px));
        sum += k ? 2 * weights[k] : weights[k];
    }
    for (int k = 0; k <= reach; k++)
        weights[k] /= sum;
    for (int j = 0; j < photo->height; j++)
        blur_line(photo->light + (size_t)j * (size_t)photo->width, photo->width, 1, weights, reach,
                  copy);
    for (int i = 0; i < photo->width; i++)
        blur_line(photo->light + i, photo->height, (size_t)photo->width, weights, reach, copy);
    free(copy);
    return true;
}

/* 0 to 1, without 0. */
static double uniform(uint64_t *state)
{
    return ((double)(random_next(state) >> 11) + 0.5) * 0x1p-53;
}

static void add_noise(struct simulator *simulator, struct photo *photo)
{
    double variance = simulator->simulation.noise * simulator->simulation.noise;
    size_t count = (size_t)photo->width * (size_t)photo->height;

    if (!(variance > 0))
        return;
    for (size_t i = 0; i < count; i++) {
        double light = (double)photo->light[i];
        double sd = sqrt(variance * (read_part + (1 - read_part) * fmax(light, 0)));
        /* Box and Muller 1958. */
        double far = sqrt(-2 * log(uniform(&simulator->state)));
        photo->light[i] = (float)(light + sd * far * cos(2 * pi * uniform(&simulator->state)));
    }
}

bool simulator_take(struct simulator *simulator, const struct photo *shown, struct photo *photo,
                    char *message)
{
    const struct simulation *simulation = &simulator->simulation;
    bool done = true;

    if (!photo_create(photo, simulation->camera->width, simulation->camera->height, message))
        return false;
    if (simulator->gl)
        done = gl_camera_take(simulator->gl, shown, photo, message);
    else
        ray_camera_take(simulator->rays, shown, photo);
    if (done) {
        expose(simulation, photo);
        done = blur(simulation->blur_px, photo, message);
    }
    if (done)
        add_noise(simulator, photo);
    else
        photo_free(photo);
    return done;
}
