/* A cube map of the scene, drawn face by face. */
#include "cube_faces.h"

#include <math.h>
#include <stdio.h>

#include <epoxy/gl.h>

#include "density.h"
#include "perspective.h"

/* Right, up and backward of each face, as GL's table of cube-map coordinates has them. */
static const signed char face_axes[6][3][3] = {
    {{0, 0, -1}, {0, -1, 0}, {-1, 0, 0}}, {{0, 0, 1}, {0, -1, 0}, {1, 0, 0}},
    {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}},   {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
    {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}},  {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
};

bool cube_faces_create(struct cube_faces *cube, int size_px, char *message)
{
    GLint largest = 0;

    *cube = (struct cube_faces){.size_px = size_px};
    glGetIntegerv(GL_MAX_CUBE_MAP_TEXTURE_SIZE, &largest);
    if (size_px > largest) {
        snprintf(message, MESSAGE_SIZE, "cube faces of %d px are needed; this GL allows %d",
                 size_px, largest);
        return false;
    }
    while (glGetError() != GL_NO_ERROR)
        continue;
    glGenTextures(1, &cube->texture);
    glBindTexture(GL_TEXTURE_CUBE_MAP, cube->texture);
    for (GLenum face = 0; face < 6; face++)
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8, size_px, size_px, 0,
                     GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glBindTexture(GL_TEXTURE_CUBE_MAP, 0);
    glGenRenderbuffers(1, &cube->depth);
    glBindRenderbuffer(GL_RENDERBUFFER, cube->depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, size_px, size_px);
    glGenFramebuffers(1, &cube->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, cube->framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, cube->depth);
    if (glGetError() == GL_NO_ERROR)
        return true;
    snprintf(message, MESSAGE_SIZE, "the GL refuses cube faces of %d px", size_px);
    cube_faces_destroy(cube);
    return false;
}

void cube_faces_destroy(struct cube_faces *cube)
{
    glDeleteTextures(1, &cube->texture);
    glDeleteRenderbuffers(1, &cube->depth);
    glDeleteFramebuffers(1, &cube->framebuffer);
    *cube = (struct cube_faces){0};
}

void cube_faces_rotation(const double axes[9], int face, double rotation[9])
{
    for (int row = 0; row < 3; row++)
        for (int i = 0; i < 3; i++) {
            rotation[3 * row + i] = 0;
            for (int k = 0; k < 3; k++)
                rotation[3 * row + i] += face_axes[face][row][k] * axes[3 * k + i];
        }
}

int cube_faces_of(const double axes[9], const double direction[3])
{
    int face = 0;
    double most = -1;

    for (int axis = 0; axis < 3; axis++) {
        const double *a = axes + 3 * axis;
        double along = a[0] * direction[0] + a[1] * direction[1] + a[2] * direction[2];
        if (fabs(along) <= most)
            continue;
        most = fabs(along);
        face = 2 * axis + (along < 0);
    }
    return face;
}

void cube_faces_draw(const struct cube_faces *cube, const struct setting *setting,
                     const double axes[9], unsigned int faces)
{
    struct perspective view = {.left = -1,
                               .right = 1,
                               .bottom = -1,
                               .top = 1,
                               .near_distance = setting->depth.near_distance,
                               .far_distance = setting->depth.far_distance};
    struct cupola_camera camera;

    for (int i = 0; i < 3; i++)
        view.eye[i] = setting->eye[i];
    for (int face = 0; face < 6; face++) {
        if (!(faces & 1u << face))
            continue;
        cube_faces_rotation(axes, face, view.rotation);
        perspective_camera(&view, &camera);
        glBindFramebuffer(GL_FRAMEBUFFER, cube->framebuffer);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                               GL_TEXTURE_CUBE_MAP_POSITIVE_X + (GLenum)face, cube->texture, 0);
        setting_draw(setting, &camera, cube->size_px, cube->size_px);
    }
}

struct needs {
    const double *axes;
    double texels_per_unit;
};

static void visit(void *context, const struct cupola_ray *ray)
{
    struct needs *needs = context;
    double rotation[9], texels_per_unit;

    cube_faces_rotation(needs->axes, cube_faces_of(needs->axes, ray->direction), rotation);
    if (density_needed(ray, rotation, NULL, &texels_per_unit))
        needs->texels_per_unit = fmax(needs->texels_per_unit, texels_per_unit);
}

int cube_faces_no_loss_px(const struct setting *setting, const double axes[9])
{
    struct needs needs = {axes, 0};

    density_each_ray(setting->dome, setting->size_px, visit, &needs);
    return (int)ceil(2 * needs.texels_per_unit);
}
