/* A dome, a scene and a framebuffer for one comparison. */
#include "setting.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <epoxy/gl.h>

#include "forest.h"

static const double plain_fov_most_rad = 140 * 3.14159265358979323846 / 180;

static double count_lit_pixels(const struct setting *setting)
{
    struct cupola_ray ray;
    double sum = 0;

    for (int j = 0; j < setting->size_px; j++)
        for (int i = 0; i < setting->size_px; i++)
            if (cupola_dome_ray(setting->dome, 0, NULL, i + 0.5, j + 0.5, &ray) == 1)
                sum += ray.coverage;
    return sum;
}

static void place_camera(struct setting *setting, const struct scene *scene)
{
    double away = 0;

    setting_turn(setting, 0);
    for (int i = 0; i < 3; i++)
        away += pow(scene->suggested[i] - scene->center[i], 2);
    setting->depth.near_distance = 0.1;
    setting->depth.far_distance = 2 + 1.01 * (sqrt(away) + scene->radius);
}

static int compare_numbers(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

/* The median of the trees' angular radii; 0 where memory is short. */
static double median_radius_rad(const struct forest *forest, const double eye[3])
{
    size_t all = 0, count = 0;
    double *radii, median;

    for (int kind = 0; kind < FOREST_KINDS; kind++)
        all += (size_t)forest->tree_count[kind];
    radii = malloc((all + 1) * sizeof *radii);
    if (!radii || all == 0) {
        free(radii);
        return 0;
    }
    for (int kind = 0; kind < FOREST_KINDS; kind++)
        for (int i = 0; i < forest->tree_count[kind]; i++) {
            const struct forest_tree *tree = &forest->trees[kind][i];
            double away = 0;
            for (int k = 0; k < 3; k++)
                away += pow((double)tree->place[k] - eye[k], 2);
            radii[count++] = asin(fmin(1, (double)tree->radius / fmax(sqrt(away), 1e-9)));
        }
    qsort(radii, count, sizeof *radii, compare_numbers);
    median = radii[count / 2];
    free(radii);
    return median;
}

/* The scene's forest once more, in plain arrays. */
static double forest_radius_rad(const struct load *load, const double eye[3])
{
    struct forest forest;
    double radius_rad;

    if (load->kind != SCENE_FOREST ||
        !forest_create(&forest, load->wishes.triangles, load->wishes.seed))
        return 0;
    radius_rad = median_radius_rad(&forest, eye);
    forest_destroy(&forest);
    return radius_rad;
}

bool setting_make_dome(struct setting *setting, double eye_m[3], char *message)
{
    struct cupola_error error = {0};
    struct cupola_rig rig = {0};
    struct cupola_output *output = &rig.outputs[0];

    output->width_px = output->height_px = setting->size_px;
    output->lens.model = setting->lens;
    output->lens.fov_rad = setting->fov_rad;
    if (setting->off_axis) {
        rig.eye_m[1] = 0.1;
        rig.eye_m[2] = 0.2;
        output->position_m[1] = -0.2;
    } else {
        memcpy(rig.eye_m, setting->viewer_m, sizeof rig.eye_m);
    }
    memcpy(eye_m, rig.eye_m, sizeof rig.eye_m);
    if (cupola_dome_create(&rig, &setting->dome, &error) >= 0)
        return true;
    snprintf(message, MESSAGE_SIZE, "%s", error.message);
    return false;
}

bool setting_create(struct setting *setting, struct scene *scene, char *message)
{
    double eye_m[3];

    if (!setting_make_dome(setting, eye_m, message))
        return false;
    if (!target_create(&setting->target, setting->size_px, setting->size_px, TARGET_BYTES, message,
                       MESSAGE_SIZE)) {
        cupola_dome_destroy(&setting->dome);
        return false;
    }
    cupola_dome_to_camera(setting->dome, eye_m, setting->eye);
    setting->scene = scene;
    setting->lit_pixels = count_lit_pixels(setting);
    place_camera(setting, scene);
    setting->object_radius_rad = forest_radius_rad(&setting->load, scene->suggested);
    return true;
}

void setting_destroy(struct setting *setting)
{
    cupola_dome_destroy(&setting->dome);
    target_destroy(&setting->target);
}

struct scene *setting_scene(const struct load *load, char *message)
{
    struct scene_wishes wishes = load->wishes;
    int way = cupola_pass_way(NULL);

    wishes.way = way > 0 ? way : 0;
    if (load->kind == SCENE_FOREST)
        return scene_forest_create(&wishes, message, MESSAGE_SIZE);
    if (load->kind == SCENE_DIRECTIONS)
        return scene_directions_create(wishes.way, message, MESSAGE_SIZE);
    return scene_cube_create(&wishes, message, MESSAGE_SIZE);
}

void setting_turn(struct setting *setting, double yaw_rad)
{
    const double *place = setting->scene->suggested, c = cos(yaw_rad), s = sin(yaw_rad);
    const double rows[3][3] = {{c, 0, -s}, {0, 1, 0}, {s, 0, c}}; /* R_y(-yaw) */

    for (int row = 0; row < 3; row++) {
        double moved = 0;
        for (int k = 0; k < 3; k++) {
            setting->host[4 * k + row] = (float)rows[row][k];
            moved -= rows[row][k] * place[k];
        }
        setting->host[12 + row] = (float)moved;
        setting->host[4 * row + 3] = 0;
    }
    setting->host[15] = 1;
}

double setting_plain_fov_rad(const struct setting *setting)
{
    return fmin(setting->fov_rad, plain_fov_most_rad);
}

void setting_clear(const struct setting *setting, int width, int height)
{
    const struct scene *scene = setting->scene;

    glViewport(0, 0, width, height);
    glDepthMask(GL_TRUE);
    glClearDepth(1);
    glClearColor(scene->clear_color[0], scene->clear_color[1], scene->clear_color[2],
                 scene->clear_color[3]);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void setting_draw(const struct setting *setting, const struct cupola_camera *camera, int width,
                  int height)
{
    struct scene *scene = setting->scene;

    setting_clear(setting, width, height);
    scene->draw(scene, &(struct scene_camera){camera, setting->host, false});
}
