/* Questions about where a model is: its bounds, its nearest surface, and whether it is a room. */
#include "model.h"

#include <math.h>

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* The corners of the triangle that begins at an index, relative to a place. */
static void corners_from(const struct model *model, uint32_t first, const double place[3],
                         double corners[3][3])
{
    for (int c = 0; c < 3; c++) {
        const float *at = model->vertices[model->indices[first + (uint32_t)c]].position;
        for (int k = 0; k < 3; k++)
            corners[c][k] = (double)at[k] - place[k];
    }
}

void model_bounds(const struct model *model, double center[3], double *radius)
{
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
    double high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (uint32_t i = 0; i < model->vertex_count; i++)
        for (int k = 0; k < 3; k++) {
            low[k] = fmin(low[k], (double)model->vertices[i].position[k]);
            high[k] = fmax(high[k], (double)model->vertices[i].position[k]);
        }
    for (int k = 0; k < 3; k++)
        center[k] = (low[k] + high[k]) / 2;
    double farthest = 0;
    for (uint32_t i = 0; i < model->vertex_count; i++) {
        double squared = 0;
        for (int k = 0; k < 3; k++)
            squared += pow((double)model->vertices[i].position[k] - center[k], 2);
        farthest = fmax(farthest, squared);
    }
    *radius = sqrt(farthest);
}

static double segment_squared(const double a[3], const double b[3])
{
    double along[3], nearest[3];
    for (int k = 0; k < 3; k++)
        along[k] = b[k] - a[k];
    double length = dot(along, along);
    double t = length > 0 ? fmin(fmax(-dot(a, along) / length, 0), 1) : 0;
    for (int k = 0; k < 3; k++)
        nearest[k] = a[k] + t * along[k];
    return dot(nearest, nearest);
}

/* From the origin: to the plane if the foot of the perpendicular lies inside, else to an edge. */
static double triangle_squared(double corners[3][3])
{
    double ab[3], ac[3], normal[3];
    for (int k = 0; k < 3; k++) {
        ab[k] = corners[1][k] - corners[0][k];
        ac[k] = corners[2][k] - corners[0][k];
    }
    cross(ab, ac, normal);
    double area = dot(normal, normal);
    bool inside = area > 0;
    for (int c = 0; c < 3 && inside; c++) {
        double side[3];
        cross(corners[c], corners[(c + 1) % 3], side);
        inside = dot(side, normal) >= 0;
    }
    if (inside) {
        double height = dot(corners[0], normal);
        return height * height / area;
    }
    return fmin(
        segment_squared(corners[0], corners[1]),
        fmin(segment_squared(corners[1], corners[2]), segment_squared(corners[2], corners[0])));
}

double model_distance(const struct model *model, const double place[3])
{
    double nearest = HUGE_VAL;
    for (uint32_t i = 0; i < model->index_count; i += 3) {
        double corners[3][3];
        corners_from(model, i, place, corners);
        nearest = fmin(nearest, triangle_squared(corners));
    }
    return sqrt(nearest);
}

/* Where an axis from the origin meets a triangle: the distance, or HUGE_VAL. *front: it shows its
 * front. */
static double meet(double corners[3][3], int axis, double sign, bool *front)
{
    int u = (axis + 1) % 3, v = (axis + 2) % 3;
    double weights[3], total = 0; /* twice the areas that the axis cuts, seen along it */
    for (int c = 0; c < 3; c++) {
        const double *p = corners[(c + 1) % 3], *q = corners[(c + 2) % 3];
        weights[c] = p[u] * q[v] - p[v] * q[u];
        total += weights[c];
    }
    bool inside = (weights[0] >= 0 && weights[1] >= 0 && weights[2] >= 0) ||
                  (weights[0] <= 0 && weights[1] <= 0 && weights[2] <= 0);
    if (!inside || !(fabs(total) > 0))
        return HUGE_VAL;
    double at = 0;
    for (int c = 0; c < 3; c++)
        at += weights[c] * corners[c][axis];
    at *= sign / total;
    *front = total * sign < 0; /* total is the normal's part along the axis */
    return at > 0 ? at : HUGE_VAL;
}

bool model_is_room(const struct model *model, const double place[3])
{
    double nearest[6];
    bool fronts[6] = {false};
    for (int way = 0; way < 6; way++)
        nearest[way] = HUGE_VAL;
    for (uint32_t i = 0; i < model->index_count; i += 3) {
        double corners[3][3];
        corners_from(model, i, place, corners);
        for (int way = 0; way < 6; way++) {
            bool front = false;
            double at = meet(corners, way / 2, way % 2 ? -1 : 1, &front);
            if (at < nearest[way]) {
                nearest[way] = at;
                fronts[way] = front;
            }
        }
    }
    for (int way = 0; way < 6; way++)
        if (!fronts[way])
            return false;
    return true;
}
