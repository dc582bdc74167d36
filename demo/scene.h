/*
 * What the demo can draw. A scene owns its GL objects; every function runs where a GL context is
 * current. A scene draws with any projection and view; it knows nothing of domes.
 */
#ifndef SCENE_H
#define SCENE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cupola/one_pass.h>

/* Matrices are column-major, as GL has them: clip = projection view host x. */
struct scene_camera {
    /* Of Cupola's, or of perspective.h. Planes are for culling: (0, 0, 0, 1) culls nothing. */
    const struct cupola_camera *view;
    const float *host;   /* world to the host's camera frame; rotation and displacement only */
    bool reversed_depth; /* what is nearer has the greater depth */
    /* All views at once, in place of `view`: with the pass open and its uniform block bound. For
     * scenes that were made with a way to that. NULL: one view */
    const struct cupola_gl_pass *pass;
    const double *eye; /* of all views, world; NULL: what the matrices say */
};

/* How surfaces get their colours, from the cheapest on. */
enum scene_shading {
    SCENE_FLAT = 0, /* the material's colour as it is */
    SCENE_LAMBERT,  /* one lamp or the sun, diffuse */
    SCENE_HEAVY,    /* many lamps, physically based, on procedural bumps: bound by fill */
};

enum { SCENE_LAMPS = 16, SCENE_LAMPS_MAX = 64 };
enum { SCENE_TRIANGLES = 1000000, SCENE_TRIANGLES_MIN = 1000, SCENE_TRIANGLES_MAX = 50000000 };

struct scene_wishes {
    enum scene_shading shading;
    int lamps;         /* of SCENE_HEAVY, up to SCENE_LAMPS_MAX; 0: SCENE_LAMPS; -1: none */
    int triangles;     /* of the forest, from MIN to MAX; 0: SCENE_TRIANGLES */
    unsigned int seed; /* of the forest */
    int way; /* of enum cupola_pass_way, by which all views can be drawn at once; 0: one by one */
    /* To set a load, for whoever measures; the demo leaves them 0. */
    bool smooth;    /* SCENE_HEAVY without bumps */
    int anisotropy; /* of the room's pictures, at most; 0: 8; 1: trilinear filtering */
    bool one_level; /* of detail at a time in those: sampling them costs the same everywhere */
};

/* What drawing costs besides pixels. */
struct scene_counts {
    long triangles;
    long instances; /* objects that are drawn or culled as one */
};

struct scene;

/* The first member of every kind of scene. */
struct scene {
    void (*draw)(struct scene *scene, const struct scene_camera *camera);
    void (*destroy)(struct scene *scene);
    double (*distance)(const struct scene *scene, const double place[3]); /* NULL: not known */
    struct scene_counts whole;                                            /* all that there is */
    struct scene_counts
        drawn;            /* every draw adds to it; whoever wants a sum sets it to zero first */
    double center[3];     /* of a sphere round everything, world */
    double radius;        /* of that sphere; 0: the scene has no place (it is a backdrop) */
    double suggested[3];  /* a sensible place for the camera, world */
    bool needs_float;     /* its colours are numbers, not colours: views and files must be
                                * float */
    float clear_color[4]; /* what the views are cleared to */
    uint64_t contents;    /* all that was read from files, as one number; 0: nothing */
};

/*
 * The room of the paper's figure 3: a cube seen from inside, from -2 to 2 units on each axis, with
 * six differently textured faces and legible marks. Flat: the textures as they are, no lamp.
 */
struct scene *scene_cube_create(const struct scene_wishes *wishes, char *message,
                                size_t message_size);

/*
 * A clearing in a wooded valley: as many triangles as wished, to less than a hundredth, in
 * instances that are seen from the world's origin under a radius of about 2 degrees, each culled
 * per view by the sphere round it. The same for the same seed.
 */
struct scene *scene_forest_create(const struct scene_wishes *wishes, char *message,
                                  size_t message_size);

/* Colour = unit direction of the ray in the host's camera frame. way: as in the wishes. */
struct scene *scene_directions_create(int way, char *message, size_t message_size);

/*
 * Colour = the point of the screen sphere that the ray meets: dome frame, metres.
 * camera_to_dome is a rotation (row-major), eye_m and radius_m as in the rig.
 */
struct scene *scene_screen_create(const double camera_to_dome[9], const double eye_m[3],
                                  double radius_m, int way, char *message, size_t message_size);

/*
 * Whatever assimp reads, at 1:1 in world coordinates: the file's own numbers and axes, except where
 * the file itself says which axis is up and how long its unit is (COLLADA). Flat: material colour
 * as it is, on black; else a sky and a ground, and sunlight or lamps.
 */
struct scene *scene_model_create(const char *path, const struct scene_wishes *wishes, char *message,
                                 size_t message_size);

/* Distance from a place to the nearest surface of a scene; 0 where that is not known. */
double scene_distance(const struct scene *scene, const double place[3]);

#endif
