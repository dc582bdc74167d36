/*
 * What all contenders of a comparison share: the dome, the scene, the picture's size and the
 * framebuffer that it lands in.
 */
#ifndef SETTING_H
#define SETTING_H

#include <stdbool.h>

#include <cupola/gl.h>

#include "scene.h"
#include "target.h"

enum { MESSAGE_SIZE = 1024 };

enum scene_kind { SCENE_ROOM, SCENE_FOREST, SCENE_DIRECTIONS };

/* A scene and how dear its pixels and vertices are. */
struct load {
    char name[32];
    enum scene_kind kind;
    struct scene_wishes wishes;
};

/* How a comparison is set up; what follows from it is made by setting_create. */
struct setting {
    int size_px; /* of the square output */
    enum cupola_lens_model lens;
    double fov_rad;
    bool off_axis;      /* viewer and projector away from the dome's centre */
    double viewer_m[3]; /* the viewer alone, where they are not; dome frame, 1 m is the radius */
    struct load load;
    struct cupola_gl_params gl;          /* of Cupola's contenders */
    double density;                      /* of those with a filter, as in plan.h */
    const struct cupola_filter *filters; /* of contender_listed, by its variant; the caller's */

    cupola_dome *dome;
    struct scene *scene; /* the caller's */
    struct target target;
    double eye[3];             /* of every view, camera frame, scene units */
    float host[16];            /* world to camera frame, column-major */
    struct cupola_depth depth; /* near and far for every view */
    double object_radius_rad;  /* median of the forest's trees from the camera; else 0 */
    double lit_pixels;         /* of the image circle, those at the rim in part */
};

/* The dome alone, and where the viewer is, dome frame. False with one line in `message`. */
bool setting_make_dome(struct setting *setting, double eye_m[3], char *message);

/* Makes dome and target for a scene that the caller keeps. False with one line in `message`. */
bool setting_create(struct setting *setting, struct scene *scene, char *message);
void setting_destroy(struct setting *setting);

/* A load's scene, for one pass, too, where the GL can; NULL with one line in `message`. */
struct scene *setting_scene(const struct load *load, char *message);

/* Turns the host's camera to the left of where it looks first. */
void setting_turn(struct setting *setting, double yaw_rad);

/* Fov of the plain view that a dome's frame is compared with: the dome's, at most 140 degrees. */
double setting_plain_fov_rad(const struct setting *setting);

/* Clears the framebuffer that is bound, and sets its viewport. */
void setting_clear(const struct setting *setting, int width, int height);
/* Draws the scene into a cleared part of the framebuffer that is bound. */
void setting_draw(const struct setting *setting, const struct cupola_camera *camera, int width,
                  int height);

#endif
