/* Matrices and frustum planes of a view, as GL wants them. */
#include <math.h>
#include <string.h>

#include "error.h"
#include "plan.h"
#include "vector.h"

/* Column-major 4x4 matrices of doubles; they become floats at the very end. */
static void multiply4(const double a[16], const double b[16], double product[16])
{
    for (int column = 0; column < 4; column++)
        for (int row = 0; row < 4; row++) {
            double sum = 0;
            for (int i = 0; i < 4; i++)
                sum += a[4 * i + row] * b[4 * column + i];
            product[4 * column + row] = sum;
        }
}

static void rotation4(const double rotation[9], double m[16])
{
    memset(m, 0, 16 * sizeof *m);
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++)
            m[4 * column + row] = rotation[3 * row + column];
    m[15] = 1;
}

static void displacement4(const double eye[3], double m[16])
{
    memset(m, 0, 16 * sizeof *m);
    m[0] = m[5] = m[10] = m[15] = 1;
    for (int i = 0; i < 3; i++)
        m[12 + i] = -eye[i];
}

/* The frustum through the base rectangle; OpenGL 3.3 core, depth -1 to 1. */
static void frustum4(const struct cupola_view *view, double near_distance, double far_distance,
                     double m[16])
{
    double width = view->right - view->left, height = view->top - view->bottom;
    double depth = far_distance - near_distance;
    memset(m, 0, 16 * sizeof *m);
    m[0] = 2 / width;
    m[5] = 2 / height;
    m[8] = (view->right + view->left) / width;
    m[9] = (view->top + view->bottom) / height;
    m[10] = -(far_distance + near_distance) / depth;
    m[11] = -1;
    m[14] = -2 * far_distance * near_distance / depth;
}

/*
 * Planes in the host's camera frame: rows of the whole matrix, added to and taken from its last
 * (Gribb and Hartmann, Fast extraction of viewing frustum planes, 2001).
 */
static void extract_planes(const double clip[16], float planes[6][4])
{
    for (int p = 0; p < 6; p++) {
        double plane[4], sign = p % 2 == 0 ? 1 : -1;
        for (int i = 0; i < 4; i++)
            plane[i] = clip[4 * i + 3] + sign * clip[4 * i + p / 2];
        double length = length3(plane);
        for (int i = 0; i < 4; i++)
            planes[p][i] = (float)(plane[i] / length);
    }
}

int cupola_plan_camera(const cupola_plan *plan, int index, double near_distance,
                       double far_distance, struct cupola_camera *camera,
                       struct cupola_error *error)
{
    if (!plan || !camera)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is NULL", plan ? "camera" : "plan");
    if (index < 0 || index >= plan->view_count)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "view is %d; allowed: 0 to %d", index,
                         plan->view_count - 1);
    if (!(near_distance > 0 && near_distance < far_distance && isfinite(far_distance)))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "near and far are %g and %g; allowed: 0 < near < far, both finite",
                         near_distance, far_distance);
    double eye[3], rotation[16], displacement[16], frustum[16], view[16], projection[16], clip[16];
    cupola_dome_to_camera(&plan->dome, plan->dome.rig.eye_m, eye);
    scale3(eye, plan->dome.rig.units_per_metre);
    rotation4(plan->views[index].rotation, rotation);
    displacement4(eye, displacement);
    frustum4(&plan->views[index], near_distance, far_distance, frustum);
    if (plan->rotation_in_projection) {
        memcpy(view, displacement, sizeof view);
        multiply4(frustum, rotation, projection);
    } else {
        multiply4(rotation, displacement, view);
        memcpy(projection, frustum, sizeof projection);
    }
    multiply4(projection, view, clip);
    for (int i = 0; i < 16; i++) {
        camera->view[i] = (float)view[i];
        camera->projection[i] = (float)projection[i];
    }
    extract_planes(clip, camera->planes);
    return CUPOLA_OK;
}
