/*
 * What the demo can draw. A scene owns its GL objects; every function runs where a GL context is
 * current. A scene draws with any projection and view; it knows nothing of domes.
 */
#ifndef SCENE_H
#define SCENE_H

#include <stdbool.h>
#include <stddef.h>

/* Matrices are column-major, as GL has them. */
struct scene_camera {
    const float *projection; /* clip = projection view host x */
    const float *view;       /* of one of Cupola's views: rotation and the eye's displacement */
    const float *host;       /* world to the host's camera frame */
    bool reversed_depth;     /* what is nearer has the greater depth */
};

struct scene;

/* The first member of every kind of scene. */
struct scene {
    void (*draw)(struct scene *scene, const struct scene_camera *camera);
    void (*destroy)(struct scene *scene);
    double (*distance)(const struct scene *scene, const double place[3]); /* NULL: not known */
    double center[3];     /* of a sphere round everything, world */
    double radius;        /* of that sphere; 0: the scene has no place (it is a backdrop) */
    double suggested[3];  /* a sensible place for the camera, world */
    bool needs_float;     /* its colours are numbers, not colours: views and files must be float */
    float clear_color[4]; /* what the views are cleared to */
};

/*
 * The room of the paper's figure 3: a cube seen from inside, from -2 to 2 units on each axis, with
 * six differently textured faces and legible marks. flat: the textures as they are, no lamp.
 */
struct scene *scene_cube_create(bool flat, char *message, size_t message_size);

/* Colour = unit direction of the ray in the host's camera frame. */
struct scene *scene_directions_create(char *message, size_t message_size);

/*
 * Colour = the point of the screen sphere that the ray meets: dome frame, metres.
 * camera_to_dome is a rotation (row-major), eye_m and radius_m as in the rig.
 */
struct scene *scene_screen_create(const double camera_to_dome[9], const double eye_m[3],
                                  double radius_m, char *message, size_t message_size);

/*
 * Whatever assimp reads, at 1:1 in world coordinates: the file's own numbers and axes, except where
 * the file itself says which axis is up and how long its unit is (COLLADA). flat: material colour
 * as it is, unlit, on black; else sunlight, a sky and a ground.
 */
struct scene *scene_model_create(const char *path, bool flat, char *message, size_t message_size);

/* Distance from a place to the nearest surface of a scene; 0 where that is not known. */
double scene_distance(const struct scene *scene, const double place[3]);

#endif
