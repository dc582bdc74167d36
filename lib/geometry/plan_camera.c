/* Matrices, frustum planes and borders of a view, as GL wants them. */
#include <math.h>
#include <string.h>

#include "error.h"
#include "plan.h"
#include "vector.h"

/* 4x4 matrices are column-major; they become floats at the very end. */
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

/* The window's depth at the near and the far end, in clip space after the division by w. */
static void depth_ends(const struct cupola_depth *depth, double *near_end, double *far_end)
{
    double lower = depth->zero_to_one ? 0 : -1;
    *near_end = depth->reversed ? 1 : lower;
    *far_end = depth->reversed ? lower : 1;
}

/*
 * The frustum through the base rectangle. A point at distance d of the axis has the depth
 * -a + b / d, of which the ends give a and b; so no difference of large numbers is taken, and
 * reversed depth keeps the far end's precision.
 */
static void frustum4(const struct cupola_view *view, const struct cupola_depth *depth, double m[16])
{
    double width = view->right - view->left, height = view->top - view->bottom;
    double near_end, far_end;
    depth_ends(depth, &near_end, &far_end);
    double near_of_far = depth->infinite ? 0 : depth->near_distance / depth->far_distance;
    double b_of_near = (near_end - far_end) / (1 - near_of_far);
    memset(m, 0, 16 * sizeof *m);
    m[0] = 2 / width;
    m[5] = 2 / height;
    m[8] = (view->right + view->left) / width;
    m[9] = (view->top + view->bottom) / height;
    m[10] = b_of_near * near_of_far - far_end;
    m[11] = -1;
    m[14] = b_of_near * depth->near_distance;
}

/*
 * Planes from the base rectangle, not from the matrix: what is near is the same however depth runs.
 * They are made in the view's frame and turned into the host's camera frame, the eye at `eye`.
 */
static void frustum_planes(const struct cupola_view *view, const double eye[3],
                           const struct cupola_depth *depth, float planes[6][4])
{
    const double normals[6][3] = {{1, 0, view->left},   {-1, 0, -view->right},
                                  {0, 1, view->bottom}, {0, -1, -view->top},
                                  {0, 0, -1},           {0, 0, 1}};
    const double offsets[6] = {0, 0, 0, 0, -depth->near_distance, depth->far_distance};
    for (int p = 0; p < 6; p++) {
        double normal[3];
        transform3_back(view->rotation, normals[p], normal);
        scale3(normal, 1 / length3(normals[p]));
        for (int i = 0; i < 3; i++)
            planes[p][i] = (float)normal[i];
        planes[p][3] = (float)(offsets[p] - dot3(normal, eye));
    }
    if (depth->infinite)
        memcpy(planes[5], (const float[4]){0, 0, 0, 1}, sizeof planes[5]);
}

/*
 * Where the view ends for the sake of others: selector . x >= other . x, as the line a u + b v >= c
 * of the base plane, moved outwards by the guard band.
 */
static void border_plane(const struct cupola_view *view, const struct cupola_view *other,
                         const double eye[3], int guard_px, float plane[4])
{
    double apart[3], line[3], normal[3];
    for (int i = 0; i < 3; i++)
        apart[i] = view->selector[i] - other->selector[i];
    transform3(view->rotation, apart, line);
    double guard_u = guard_px * (view->right - view->left) / view->rect.width;
    double guard_v = guard_px * (view->top - view->bottom) / view->rect.height;
    line[2] -= fabs(line[0]) * guard_u + fabs(line[1]) * guard_v;
    transform3_back(view->rotation, line, normal);
    scale3(normal, 1 / length3(normal));
    for (int i = 0; i < 3; i++)
        plane[i] = (float)normal[i];
    plane[3] = (float)-dot3(normal, eye);
}

static void border_planes(const cupola_plan *plan, int index, const double eye[3],
                          struct cupola_camera *camera)
{
    int count = 0;
    for (int v = 0; v < plan->view_count; v++)
        if (v != index)
            border_plane(&plan->views[index], &plan->views[v], eye, plan->guard_px,
                         camera->borders[count++]);
    camera->border_count = count;
}

/* In place of zero what it stands for; what is left is such that floats hold the matrices. */
static int complete_depth(const struct cupola_depth *wished, struct cupola_depth *depth,
                          struct cupola_error *error)
{
    const double least = 1e-20, most = 1e20;
    *depth = wished ? *wished : (struct cupola_depth){0};
    if (depth->near_distance == 0)
        depth->near_distance = 0.1;
    if (depth->far_distance == 0)
        depth->far_distance = 1000;
    double near_distance = depth->near_distance, far_distance = depth->far_distance;
    if (!(near_distance >= least && near_distance <= most))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "near distance is %g; allowed: %g to %g scene units, or 0 for 0.1",
                         near_distance, least, most);
    if (!depth->infinite && !(far_distance > near_distance && far_distance <= most))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "far distance is %g and near distance %g; allowed: beyond near and up to "
                         "%g scene units, 0 for 1000, or infinite",
                         far_distance, near_distance, most);
    return CUPOLA_OK;
}

int cupola_plan_camera(const cupola_plan *plan, int index, const struct cupola_depth *depth,
                       struct cupola_camera *camera, struct cupola_error *error)
{
    struct cupola_depth complete;
    if (!plan || !camera)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is NULL", plan ? "camera" : "plan");
    if (index < 0 || index >= plan->view_count)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "view is %d; allowed: 0 to %d", index,
                         plan->view_count - 1);
    int status = complete_depth(depth, &complete, error);
    if (status != CUPOLA_OK)
        return status;
    double eye[3], rotation[16], displacement[16], frustum[16], view[16], projection[16];
    cupola_dome_to_camera(&plan->dome, plan->dome.rig.eye_m, eye);
    scale3(eye, plan->dome.rig.units_per_metre);
    rotation4(plan->views[index].rotation, rotation);
    displacement4(eye, displacement);
    frustum4(&plan->views[index], &complete, frustum);
    if (plan->rotation_in_projection) {
        memcpy(view, displacement, sizeof view);
        multiply4(frustum, rotation, projection);
    } else {
        multiply4(rotation, displacement, view);
        memcpy(projection, frustum, sizeof projection);
    }
    for (int i = 0; i < 16; i++) {
        camera->view[i] = (float)view[i];
        camera->projection[i] = (float)projection[i];
    }
    frustum_planes(&plan->views[index], eye, &complete, camera->planes);
    border_planes(plan, index, eye, camera);
    return CUPOLA_OK;
}
