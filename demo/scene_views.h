/* What the scenes do alike for one view and for all views in one pass. */
#ifndef SCENE_VIEWS_H
#define SCENE_VIEWS_H

#include "program.h"
#include "scene.h"

/* The binding of the uniform block of a pass, in all programs. */
enum { SCENE_PASS_BINDING = 0 };

/* Of a scene's program: for one view, and for all of them where there is a way to that; else 0. */
struct scene_programs {
    unsigned int one_view;
    unsigned int all_views;
};

/*
 * Programs that cover views with what `fragment` computes from `ray`; their rays are set by
 * scene_set_rays. False with one line in `message`, and nothing made.
 */
bool scene_backdrop_create(struct scene_programs *programs, const char *name, const char *fragment,
                           int way, char *message, size_t message_size);

/* Only deletes; 0 is allowed. */
void scene_programs_destroy(struct scene_programs *programs);

/* The one that the camera needs. */
unsigned int scene_program(const struct scene_programs *programs,
                           const struct scene_camera *camera);

/* How many views are drawn, 1 or more: instances of everything. */
int scene_view_count(const struct scene_camera *camera);
const struct cupola_camera *scene_view(const struct scene_camera *camera, int index);

/*
 * Fills the views by the program that is in use, before all else: it hides nothing and leaves out
 * what is masked. The vertex array has no attribute.
 */
void scene_fill(const struct scene_camera *camera, unsigned int vertex_array);

/* The same by the backdrop's program, with the rays of the world. */
void scene_backdrop_draw(const struct scene_programs *backdrop, const struct scene_camera *camera,
                         unsigned int vertex_array);

/*
 * Sets clip_from_world and eye of the program that is in use. False for a matrix that is no
 * perspective.
 */
bool scene_set_camera(unsigned int program, const struct scene_camera *camera);

/*
 * Sets ray_basis of the program that is in use: the rays of each view in the world, or in the frame
 * that `turn` (rows; NULL: none) leads to from the host's camera frame. False likewise.
 */
bool scene_set_rays(unsigned int program, const struct scene_camera *camera, bool of_world,
                    const double turn[9]);

#endif
