/* Matrices and planes of a plain perspective view. */
#include "perspective.h"

#include <math.h>
#include <string.h>

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void set_matrices(const struct perspective *p, struct cupola_camera *camera)
{
    double width = p->right - p->left, height = p->top - p->bottom;
    double n = p->near_distance, f = p->far_distance;

    memset(camera, 0, sizeof *camera);
    for (int row = 0; row < 3; row++) {
        const double *axis = p->rotation + 3 * row;
        for (int column = 0; column < 3; column++)
            camera->view[4 * column + row] = (float)axis[column];
        camera->view[12 + row] = (float)-dot(axis, p->eye);
    }
    camera->view[15] = 1;
    camera->projection[0] = (float)(2 / width);
    camera->projection[5] = (float)(2 / height);
    camera->projection[8] = (float)((2 * p->left + width) / width);
    camera->projection[9] = (float)((2 * p->bottom + height) / height);
    camera->projection[10] = (float)(-(f + n) / (f - n));
    camera->projection[11] = -1;
    camera->projection[14] = (float)(-2 * f * n / (f - n));
}

void perspective_camera(const struct perspective *p, struct cupola_camera *camera)
{
    const double normals[6][3] = {{1, 0, p->left},  {-1, 0, -p->right}, {0, 1, p->bottom},
                                  {0, -1, -p->top}, {0, 0, -1},         {0, 0, 1}};
    const double offsets[6] = {0, 0, 0, 0, -p->near_distance, p->far_distance};

    set_matrices(p, camera);
    for (int plane = 0; plane < 6; plane++) {
        double length = sqrt(dot(normals[plane], normals[plane])), turned[3] = {0};
        for (int row = 0; row < 3; row++)
            for (int i = 0; i < 3; i++)
                turned[i] += p->rotation[3 * row + i] * normals[plane][row] / length;
        for (int i = 0; i < 3; i++)
            camera->planes[plane][i] = (float)turned[i];
        camera->planes[plane][3] = (float)(offsets[plane] - dot(turned, p->eye));
    }
}
