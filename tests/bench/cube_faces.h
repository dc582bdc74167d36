/* A cube map of the scene, drawn face by face. */
#ifndef CUBE_FACES_H
#define CUBE_FACES_H

#include "setting.h"

struct cube_faces {
    unsigned int texture; /* GL_TEXTURE_CUBE_MAP */
    unsigned int framebuffer;
    unsigned int depth;
    int size_px;
};

/* Of RGBA8 with linear filtering. False with one line in `message`; then all zero. */
bool cube_faces_create(struct cube_faces *cube, int size_px, char *message);
void cube_faces_destroy(struct cube_faces *cube);

/*
 * Draws the faces whose bits, 1 << (face - GL_TEXTURE_CUBE_MAP_POSITIVE_X), are set. The rows of
 * `axes` are the cube's own axes in the camera's frame.
 */
void cube_faces_draw(const struct cube_faces *cube, const struct setting *setting,
                     const double axes[9], unsigned int faces);

/* The face that a ray meets, and the view's right, up and backward axes as rows. */
int cube_faces_of(const double axes[9], const double direction[3]);
void cube_faces_rotation(const double axes[9], int face, double rotation[9]);

/* The side at which no pixel of the setting gets less than one texel. */
int cube_faces_no_loss_px(const struct setting *setting, const double axes[9]);

#endif
