/* What the views of a scene cost on this machine, measured for the planner. */
#include "prices.h"

#include <epoxy/gl.h>
#include <stdio.h>

#include <cupola/cost.h>

#include "view_wishes.h"

struct sitter {
    struct scene *scene;
    struct scene_camera camera;
};

static void draw_view(cupola_gl *gl, int index, const struct cupola_gl_view *view, void *user)
{
    struct sitter *sitter = user;

    (void)gl;
    (void)index;
    sitter->camera.view = &view->camera;
    sitter->scene->draw(sitter->scene, &sitter->camera);
}

static int measure(struct show_setup *setup, struct scene *scene, const struct host_camera *camera,
                   const cupola_dome *dome, struct cupola_error *error)
{
    float host[16];
    double eye[3], world[3], near_distance, far_distance;
    struct scene_range range = {0};
    struct sitter sitter = {.scene = scene};
    struct cupola_gl_params params = view_wishes_params(setup);
    struct cupola_frame frame;
    int status;

    host_camera_matrix(camera, host);
    host_camera_eye(camera, dome, eye, world);
    scene_range_update(&range, scene, world, &near_distance, &far_distance);
    frame = view_wishes_frame(setup, scene, near_distance, far_distance);
    sitter.camera =
        (struct scene_camera){.host = host, .reversed_depth = setup->reversed_depth, .eye = world};
    status = cupola_gl_measure_cost(dome, &setup->plan, &params, &frame, draw_view, &sitter,
                                    &setup->plan.cost, error);
    view_wishes_done(setup);
    return status;
}

bool prices_measure(struct show_setup *setup, struct scene *scene, const struct host_camera *camera,
                    char *message)
{
    struct cupola_error error = {0};
    cupola_dome *dome = NULL;
    int status = cupola_dome_create(&setup->rig, &dome, &error);

    if (status >= 0)
        status = measure(setup, scene, camera, dome, &error);
    cupola_dome_destroy(&dome);
    if (status >= 0)
        return true;
    if (status == CUPOLA_ERROR_ARGUMENT) {
        fprintf(stderr, "cupola-demo: --goal auto: %s; usual prices are taken\n", error.message);
        setup->measures_prices = false;
        return true;
    }
    snprintf(message, MESSAGE_SIZE, "--goal auto: %s", error.message);
    return false;
}
