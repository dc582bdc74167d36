/* An ordinary camera that looks at the library's simulated theatre. */
#include "capture/simulate_gl.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <cupola/theatre.h>
#include <epoxy/gl.h>

#include "headless.h"
#include "option_values.h"
#include "target.h"

enum { PARTS = 2 /* of a pixel, each way */ };

struct gl_camera {
    struct headless *headless;
    cupola_theatre *theatre;
    struct cupola_spectator spectator;
    struct target target; /* PARTS times the photograph */
    GLuint images[CUPOLA_OUTPUTS_MAX];
    int output;
    float *pixels; /* of the target */
    float *shown;
};

static void describe(const struct simulation *simulation, struct cupola_spectator *spectator)
{
    const struct camera *camera = simulation->camera;

    *spectator = (struct cupola_spectator){0};
    for (int i = 0; i < 3; i++) {
        spectator->position_m[i] = camera->position_m[i];
        spectator->ambient_rgb[i] = (float)simulation->ambient;
        for (int k = 0; k < 3; k++)
            spectator->rotation[3 * i + k] = camera->rotation[3 * k + i];
    }
    spectator->fov_rad = 2 * atan(tan(0.5 * camera->fov_rad) * camera->height / camera->width);
}

/* Black, but for the one that is photographed. */
static bool make_images(struct gl_camera *camera, const struct cupola_rig *rig, char *message)
{
    glGenTextures(rig->output_count, camera->images);
    for (int i = 0; i < rig->output_count; i++) {
        size_t count = (size_t)rig->outputs[i].width_px * (size_t)rig->outputs[i].height_px;
        float *black = calloc(4 * count, sizeof *black);
        if (!black) {
            snprintf(message, MESSAGE_SIZE, "out of memory for the projectors' pictures");
            return false;
        }
        glBindTexture(GL_TEXTURE_2D, camera->images[i]);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, rig->outputs[i].width_px,
                     rig->outputs[i].height_px, 0, GL_RGBA, GL_FLOAT, black);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        if (i == camera->output)
            camera->shown = black;
        else
            free(black);
    }
    return true;
}

static bool make_theatre(struct gl_camera *camera, const struct cupola_rig *rig, char *message)
{
    struct cupola_error error = {0};
    cupola_dome *dome = NULL;
    bool done = cupola_dome_create(rig, &dome, &error) >= 0 &&
                cupola_theatre_create(dome, &camera->theatre, &error) >= 0;

    if (!done)
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
    cupola_dome_destroy(&dome);
    return done;
}

struct gl_camera *gl_camera_create(const struct simulation *simulation, char *message)
{
    struct gl_camera *camera = calloc(1, sizeof *camera);
    int width = PARTS * simulation->camera->width, height = PARTS * simulation->camera->height;
    bool done = camera != NULL;

    if (!done) {
        snprintf(message, MESSAGE_SIZE, "out of memory for a camera");
        return NULL;
    }
    camera->output = simulation->output;
    describe(simulation, &camera->spectator);
    camera->headless = headless_create(message, MESSAGE_SIZE);
    done = camera->headless && make_theatre(camera, simulation->rig, message) &&
           target_create(&camera->target, width, height, TARGET_FLOATS, message, MESSAGE_SIZE) &&
           make_images(camera, simulation->rig, message);
    if (done && !(camera->pixels = malloc((size_t)width * (size_t)height * 4 * sizeof(float)))) {
        snprintf(message, MESSAGE_SIZE, "out of memory for a photograph");
        done = false;
    }
    if (done)
        return camera;
    gl_camera_destroy(camera);
    return NULL;
}

void gl_camera_destroy(struct gl_camera *camera)
{
    if (!camera)
        return;
    if (camera->headless) {
        cupola_theatre_destroy(&camera->theatre);
        target_destroy(&camera->target);
        glDeleteTextures(CUPOLA_OUTPUTS_MAX, camera->images);
    }
    headless_destroy(camera->headless);
    free(camera->pixels);
    free(camera->shown);
    free(camera);
}

static void upload(struct gl_camera *camera, const struct photo *shown)
{
    size_t count = (size_t)shown->width * (size_t)shown->height;

    for (size_t i = 0; i < count; i++) {
        for (size_t k = 0; k < 4; k++)
            camera->shown[4 * i + k] = k < 3 ? shown->light[i] : 1;
    }
    glBindTexture(GL_TEXTURE_2D, camera->images[camera->output]);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, shown->width, shown->height, GL_RGBA, GL_FLOAT,
                    camera->shown);
}

static void average(const struct gl_camera *camera, struct photo *photo)
{
    size_t row = (size_t)camera->target.width;

    for (int j = 0; j < photo->height; j++) {
        for (int i = 0; i < photo->width; i++) {
            double light = 0;
            for (int part = 0; part < PARTS * PARTS; part++) {
                size_t x = (size_t)(PARTS * i + part % PARTS);
                size_t y = (size_t)(PARTS * j + part / PARTS);
                light += (double)camera->pixels[4 * (y * row + x)];
            }
            photo->light[(size_t)j * (size_t)photo->width + (size_t)i] =
                (float)(light / (PARTS * PARTS));
        }
    }
}

bool gl_camera_take(struct gl_camera *camera, const struct photo *shown, struct photo *photo,
                    char *message)
{
    struct cupola_error error = {0};
    const struct cupola_target target = {.framebuffer = camera->target.framebuffer};
    int width = camera->target.width, height = camera->target.height;

    upload(camera, shown);
    if (cupola_theatre_draw(camera->theatre, camera->images, &camera->spectator, width, height,
                            &target, &error) < 0 ||
        cupola_gl_capture(&target, width, height, camera->pixels, &error) < 0) {
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
        return false;
    }
    average(camera, photo);
    return true;
}
