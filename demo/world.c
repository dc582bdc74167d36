/* What the options ask to be drawn, and the camera in it. */
#include "world.h"

#include <math.h>
#include <string.h>

static int place_camera(const struct options *options, const double place[3],
                        struct host_camera *camera, char *message)
{
    const double *look = options->look.given ? options->look.value : NULL;
    const double *up = options->up.given ? options->up.value : NULL;

    return host_camera_set(camera, place, look, up, message, MESSAGE_SIZE) ? STATUS_OK
                                                                           : STATUS_USAGE;
}

int world_check_camera(const struct options *options, char *message)
{
    struct host_camera camera;

    if (options->model && !options->camera.given)
        return STATUS_OK; /* the model will suggest a place */
    return place_camera(options, options->camera.value, &camera, message);
}

static struct scene *create_scene(const struct options *options, const struct cupola_rig *rig,
                                  char *message)
{
    double c = cos(rig->tilt_rad), s = sin(rig->tilt_rad);
    const double camera_to_dome[9] = {1, 0, 0, 0, c, s, 0, -s, c}; /* R_x(-tilt) */
    const struct scene_wishes wishes = options_scene_wishes(options);

    if (options->model)
        return scene_model_create(options->model, &wishes, message, MESSAGE_SIZE);
    switch (options->scene) {
    case SCENE_DIRECTIONS:
        return scene_directions_create(message, MESSAGE_SIZE);
    case SCENE_SCREEN:
        return scene_screen_create(camera_to_dome, rig->eye_m, rig->screen.radius_m, message,
                                   MESSAGE_SIZE);
    case SCENE_FOREST:
        return scene_forest_create(&wishes, message, MESSAGE_SIZE);
    default:
        return scene_cube_create(&wishes, message, MESSAGE_SIZE);
    }
}

int world_create(struct world *world, const struct options *options, const struct cupola_rig *rig,
                 FILE *news, char *message)
{
    int status;
    const double *place = options->camera.value;

    *world = (struct world){.up = {0, 1, 0}};
    if (options->show)
        world->film = film_create(options, message);
    else
        world->scene = create_scene(options, rig, message);
    if (!world->scene && !world->film)
        return STATUS_FAILED;
    if (options->model && !options->camera.given) {
        place = world->scene->suggested;
        fprintf(news, "camera %.9g,%.9g,%.9g (give --camera to choose)\n", place[0], place[1],
                place[2]);
    }
    status = place_camera(options, place, &world->camera, message);
    if (options->up.given)
        memcpy(world->up, options->up.value, sizeof world->up);
    if (status != STATUS_OK)
        world_destroy(world);
    return status;
}

void world_destroy(struct world *world)
{
    if (world->scene)
        world->scene->destroy(world->scene);
    world->scene = NULL;
    film_destroy(world->film);
    world->film = NULL;
}
