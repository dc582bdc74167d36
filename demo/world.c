/* What the options ask to be drawn, and the camera in it. */
#include "world.h"

#include <math.h>
#include <string.h>

#include <epoxy/gl.h>

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

static bool renderer_is_software(void)
{
    static const char *const names[] = {"llvmpipe", "softpipe", "SWR", "lavapipe", "Software"};
    const char *renderer = (const char *)glGetString(GL_RENDERER);

    for (size_t i = 0; renderer && i < sizeof names / sizeof *names; i++)
        if (strstr(renderer, names[i]))
            return true;
    return false;
}

/*
 * A geometry shader costs more than it saves, and so do viewports on software rasterisers, where
 * there are no commands to be saved: they must be wished for.
 */
static int choose_way(const struct options *options)
{
    struct cupola_error error = {0};
    bool automatic = options->submission == SUBMISSION_AUTO;
    int way = 0;

    if (options->show || options->submission == SUBMISSION_LOOP ||
        (automatic && (options_time_views(options) || renderer_is_software())))
        return 0;
    if (options_time_views(options)) {
        fputs("cupola-demo: --submission once: --goal auto times views one by one; the views are "
              "drawn one by one\n",
              stderr);
        return 0;
    }
    way = cupola_pass_way(&error);
    if (options->submission == SUBMISSION_ONCE && way < 0)
        fprintf(stderr, "cupola-demo: --submission once: %s; the views are drawn one by one\n",
                error.message);
    return way < 0 || (automatic && way != CUPOLA_PASS_VERTEX) ? 0 : way;
}

static struct scene *create_scene(const struct options *options, const struct cupola_rig *rig,
                                  int way, char *message)
{
    double c = cos(rig->tilt_rad), s = sin(rig->tilt_rad);
    const double camera_to_dome[9] = {1, 0, 0, 0, c, s, 0, -s, c}; /* R_x(-tilt) */
    struct scene_wishes wishes = options_scene_wishes(options);

    wishes.way = way;
    if (options->model)
        return scene_model_create(options->model, &wishes, message, MESSAGE_SIZE);
    switch (options->scene) {
    case SCENE_DIRECTIONS:
        return scene_directions_create(way, message, MESSAGE_SIZE);
    case SCENE_SCREEN:
        return scene_screen_create(camera_to_dome, rig->eye_m, rig->screen.radius_m, way, message,
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

    *world = (struct world){.up = {0, 1, 0}, .way = choose_way(options)};
    if (options->show)
        world->film = film_create(options, message);
    else
        world->scene = create_scene(options, rig, world->way, message);
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
