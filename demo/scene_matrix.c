/* Products of camera matrices, and the rays of a view. */
#include "scene_matrix.h"

#include <math.h>

static void product(const double a[16], const float b[16], double out[16])
{
    for (int column = 0; column < 4; column++)
        for (int row = 0; row < 4; row++) {
            double sum = 0;
            for (int k = 0; k < 4; k++)
                sum += a[k * 4 + row] * (double)b[column * 4 + k];
            out[column * 4 + row] = sum;
        }
}

void scene_clip_from_camera(const struct scene_camera *camera, double clip[16])
{
    double projection[16];
    for (int i = 0; i < 16; i++)
        projection[i] = (double)camera->view->projection[i];
    product(projection, camera->view->view, clip);
}

void scene_clip_from_world(const struct scene_camera *camera, double clip[16])
{
    double from_camera[16];
    scene_clip_from_camera(camera, from_camera);
    product(from_camera, camera->host, clip);
}

/*
 * A point X has clip x, y and w of A X + t, with A and t from the rows 0, 1 and 3 of the matrix. It
 * is at (x, y) of the view if A X + t = w (x, y, 1), so X = inverse(A) (x, y, 1) w - inverse(A) t:
 * a ray from the eye, forward for w > 0.
 */
bool scene_rays(const double clip[16], double basis[9], double eye[3])
{
    static const int rows[3] = {0, 1, 3};
    double a[3][3]; /* rows of A */
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            a[i][k] = clip[k * 4 + rows[i]];
    for (int i = 0; i < 3; i++) { /* Column i of the inverse, times the determinant. */
        const double *p = a[(i + 1) % 3];
        const double *q = a[(i + 2) % 3];
        basis[i * 3 + 0] = p[1] * q[2] - p[2] * q[1];
        basis[i * 3 + 1] = p[2] * q[0] - p[0] * q[2];
        basis[i * 3 + 2] = p[0] * q[1] - p[1] * q[0];
    }
    double determinant = a[0][0] * basis[0] + a[0][1] * basis[1] + a[0][2] * basis[2];
    if (!(fabs(determinant) > 0))
        return false;
    for (int i = 0; i < 9; i++)
        basis[i] /= determinant;
    for (int k = 0; k < 3; k++) {
        eye[k] = 0;
        for (int i = 0; i < 3; i++)
            eye[k] -= basis[i * 3 + k] * clip[12 + rows[i]];
    }
    return true;
}

void scene_to_float(const double *from, int count, float *to)
{
    for (int i = 0; i < count; i++)
        to[i] = (float)from[i];
}
