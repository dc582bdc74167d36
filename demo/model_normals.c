/*
 * Normals of a model before its vertices are shared, when three of them in turn are a triangle.
 * Those that the file lacks are made: the mean of the triangles that meet at the place and are
 * turned against the vertex's own by less than the crease angle, weighted by their angles there
 * (Thuermer and Wuethrich, J. Graphics Tools 3(1), 1998), so that hard edges stay hard.
 */
#include "model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Where more triangles than this meet, each keeps its own normal: neighbours hardly differ. */
enum { NEIGHBOURS_MAX = 256 };

static const double crease_cosine = 0.5; /* 60 degrees */

/* Corners by place: the first corner in each slot, and from each the next at the same place. */
struct places {
    uint32_t *slots; /* index of a corner plus 1; 0: free */
    uint32_t *next;  /* likewise; 0: the last */
    uint64_t mask;
};

static void edge(const struct model *model, uint32_t from, uint32_t to, double out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] =
            (double)model->vertices[to].position[k] - (double)model->vertices[from].position[k];
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/*
 * A triangle's own normal by its winding, seen from one of its corners. Returns the angle there; 0
 * and a normal of zero for a triangle without area (coordinates are good to 6e-8 of themselves).
 */
static double face_normal(const struct model *model, uint32_t corner, double normal[3])
{
    uint32_t first = corner - corner % 3;
    double a[3], b[3], length, sine;

    edge(model, corner, first + (corner + 1) % 3, a);
    edge(model, corner, first + (corner + 2) % 3, b);
    for (int k = 0; k < 3; k++)
        normal[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    length = sqrt(dot(normal, normal));
    sine = length / sqrt(dot(a, a) * dot(b, b));
    if (!(sine > 1e-6) || !isfinite(length)) {
        memset(normal, 0, 3 * sizeof *normal);
        return 0;
    }
    for (int k = 0; k < 3; k++)
        normal[k] /= length;
    return atan2(length, dot(a, b));
}

bool model_has_area(const struct model *model)
{
    double normal[3];

    for (uint32_t corner = 0; corner < model->vertex_count; corner += 3)
        if (face_normal(model, corner, normal) > 0)
            return true;
    return false;
}

static uint64_t hash(const float position[3])
{
    uint64_t value = 0xcbf29ce484222325u;

    for (int k = 0; k < 3; k++) {
        float number = position[k] + 0.0f; /* makes one of the two zeros */
        uint32_t word;
        memcpy(&word, &number, sizeof word);
        value = (value ^ word) * 0x100000001b3u;
        value ^= value >> 29;
    }
    return value;
}

static bool same_place(const struct model *model, uint32_t a, uint32_t b)
{
    const float *p = model->vertices[a].position, *q = model->vertices[b].position;
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

static uint32_t *find_slot(const struct places *places, const struct model *model, uint32_t corner)
{
    uint64_t slot = hash(model->vertices[corner].position) & places->mask;

    while (places->slots[slot] && !same_place(model, places->slots[slot] - 1, corner))
        slot = (slot + 1) & places->mask;
    return &places->slots[slot];
}

static bool find_places(const struct model *model, struct places *places)
{
    uint64_t size = 16;

    while (size < 2 * (uint64_t)model->vertex_count)
        size *= 2;
    places->mask = size - 1;
    places->slots = calloc(size, sizeof *places->slots);
    places->next = malloc(model->vertex_count * sizeof *places->next);
    if (!places->slots || !places->next)
        return false;
    for (uint32_t corner = 0; corner < model->vertex_count; corner++) {
        uint32_t *slot = find_slot(places, model, corner);
        places->next[corner] = *slot;
        *slot = corner + 1;
    }
    return true;
}

static void smooth_normal(const struct model *model, const struct places *places, uint32_t corner,
                          const double own[3], double normal[3])
{
    double other[3], sum[3] = {0};
    int neighbours = 0;

    memcpy(normal, own, 3 * sizeof *normal);
    for (uint32_t at = *find_slot(places, model, corner); at; at = places->next[at - 1]) {
        double weight = face_normal(model, at - 1, other);
        if (++neighbours > NEIGHBOURS_MAX)
            return;
        if (dot(own, other) > crease_cosine)
            for (int k = 0; k < 3; k++)
                sum[k] += weight * other[k];
    }
    double length = sqrt(dot(sum, sum));
    if (length > 0)
        for (int k = 0; k < 3; k++)
            normal[k] = sum[k] / length;
}

/*
 * Whatever a file says: a normal is on the side from which its triangle runs counter-clockwise.
 * Where none is known, for a triangle without area, any will do.
 */
static void set_normal(struct model_vertex *vertex, const double own[3], double normal[3])
{
    double sign = dot(normal, own) < 0 ? -1 : 1;

    if (!(dot(normal, normal) > 0))
        normal[1] = 1;
    for (int k = 0; k < 3; k++)
        vertex->normal[k] = (float)(sign * normal[k]);
}

bool model_normals(struct model *model)
{
    struct places places = {0};
    bool found = true;

    for (uint32_t corner = 0; corner < model->vertex_count && found; corner++) {
        struct model_vertex *vertex = &model->vertices[corner];
        double own[3];
        double normal[3] = {(double)vertex->normal[0], (double)vertex->normal[1],
                            (double)vertex->normal[2]};
        face_normal(model, corner, own);
        if (!(dot(normal, normal) > 0)) {
            if (!places.next)
                found = find_places(model, &places);
            if (found)
                smooth_normal(model, &places, corner, own, normal);
        }
        set_normal(vertex, own, normal);
    }
    free(places.slots);
    free(places.next);
    return found;
}
