/* Scenes that are hard to sample. */
#include "probe.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <epoxy/gl.h>

#include "bench_shaders.h"
#include "load.h"
#include "read_option.h"
#include "scene_views.h"

const char *const probe_names[] = {"zone-plate", "siemens", "checkers", "starfield", "model", NULL};

/* Pixels of the image's middle for each star. */
static const double pixels_per_star = 150;

/* One that is computed from the rays of the world. */
struct sky {
    struct scene scene;
    struct scene_programs programs;
    GLuint vertex_array; /* without any attribute */
};

static void sky_draw(struct scene *base, const struct scene_camera *camera)
{
    struct sky *sky = (struct sky *)base;

    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    scene_backdrop_draw(&sky->programs, camera, sky->vertex_array);
    glBindVertexArray(0);
    glUseProgram(0);
}

static void sky_destroy(struct scene *base)
{
    struct sky *sky = (struct sky *)base;

    scene_programs_destroy(&sky->programs);
    glDeleteVertexArrays(1, &sky->vertex_array);
    free(sky);
}

static struct scene *sky_create(const char *name, const char *fragment,
                                const struct probe_scale *scale, char *message)
{
    struct sky *sky = calloc(1, sizeof *sky);

    if (!sky) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return NULL;
    }
    if (!scene_backdrop_create(&sky->programs, name, fragment, 0, message, MESSAGE_SIZE)) {
        free(sky);
        return NULL;
    }
    GLuint program = sky->programs.one_view;
    glUseProgram(program);
    glUniform1f(glGetUniformLocation(program, "half_fov"), (float)scale->half_fov_rad);
    glUniform1f(glGetUniformLocation(program, "pixel"), (float)scale->pixel_rad);
    glUseProgram(0);
    glGenVertexArrays(1, &sky->vertex_array);
    sky->scene = (struct scene){.draw = sky_draw,
                                .destroy = sky_destroy,
                                .whole = {1, 1},
                                .radius = 4,
                                .clear_color = {0, 0, 0, 1}};
    return &sky->scene;
}

static bool is_checkers(const char *name)
{
    return strcmp(name, "checkers") == 0 || strncmp(name, "checkers:", 9) == 0;
}

/* How wide a check is; false with one line in `message`. */
static bool checkers_width(const char *name, double *wide_px, char *message)
{
    const char *colon = strchr(name, ':');

    *wide_px = 3;
    if (!colon || read_number(colon + 1, 0.1, 10000, wide_px))
        return true;
    snprintf(message, MESSAGE_SIZE, "the scene checkers has '%.40s'; allowed: 0.1 to 10000 px",
             colon + 1);
    return false;
}

static struct scene *checkers_create(const char *name, const struct probe_scale *scale,
                                     char *message)
{
    double wide_px;

    if (!checkers_width(name, &wide_px, message))
        return NULL;
    struct scene *room = sky_create("checkers", shader_checkers_frag, scale, message);
    if (!room)
        return NULL;
    GLuint program = ((struct sky *)room)->programs.one_view;
    glUseProgram(program);
    glUniform1f(glGetUniformLocation(program, "wide"), (float)(2 * wide_px * scale->pixel_rad));
    glUseProgram(0);
    /* Where no symmetry of the room is seen. */
    room->suggested[0] = 0.13;
    room->suggested[1] = -0.07;
    room->suggested[2] = 0.21;
    return room;
}

static struct scene *load_scene(const char *name, char *message)
{
    const struct comparison_wishes wishes = {.frames = 1};
    struct load load;

    return load_find(name, &wishes, 256, &load, message) ? setting_scene(&load, message) : NULL;
}

bool probe_check(const char *name, char *message)
{
    char why[MESSAGE_SIZE];
    double wide_px;

    for (int i = 0; probe_names[i]; i++)
        if (strcmp(name, probe_names[i]) == 0)
            return true;
    if (is_checkers(name))
        return checkers_width(name, &wide_px, message);
    if (load_check(name, why))
        return true;
    snprintf(message, MESSAGE_SIZE,
             "there is no scene '%.40s'; there are zone-plate, siemens, checkers[:PX], starfield, "
             "model and the loads of cupola-bench: %.700s",
             name, why);
    return false;
}

/* All round. */
static int stars_of(const struct probe_scale *scale)
{
    double area_sr = pixels_per_star * scale->pixel_rad * scale->pixel_rad;

    return (int)fmin(4 * 3.14159265358979323846 / area_sr, 1e6) + 1;
}

struct scene *probe_create(const char *name, const struct probe_scale *scale, const char *model,
                           char *message)
{
    const struct scene_wishes sunlit = {.shading = SCENE_LAMBERT};

    if (strcmp(name, "zone-plate") == 0)
        return sky_create(name, shader_zone_plate_frag, scale, message);
    if (strcmp(name, "siemens") == 0)
        return sky_create(name, shader_siemens_frag, scale, message);
    if (strcmp(name, "starfield") == 0)
        return starfield_create(stars_of(scale), 0.5 * scale->pixel_rad, message);
    if (strcmp(name, "model") == 0)
        return scene_model_create(model, &sunlit, message, MESSAGE_SIZE);
    if (is_checkers(name))
        return checkers_create(name, scale, message);
    return load_scene(name, message);
}

bool probe_filters_itself(const char *name)
{
    return strcmp(name, "zone-plate") != 0 && strcmp(name, "siemens") != 0 &&
           strcmp(name, "starfield") != 0 && !is_checkers(name);
}
