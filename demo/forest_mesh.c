/* Meshes of trees: surfaces round a trunk, as fine as wished. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "forest.h"

static const double pi = 3.14159265358979323846;

enum { BARK, SHADE, NEEDLES, UNDERSIDE, LEAVES, BLOSSOM, COLORS };

static const float colors[COLORS][3] = {
    [BARK] = {0.30f, 0.22f, 0.16f},    [SHADE] = {0.10f, 0.19f, 0.12f},
    [NEEDLES] = {0.20f, 0.38f, 0.22f}, [UNDERSIDE] = {0.17f, 0.27f, 0.10f},
    [LEAVES] = {0.38f, 0.52f, 0.20f},  [BLOSSOM] = {0.72f, 0.40f, 0.42f},
};

/* A corner of the outline of a tree, from the foot up. */
struct corner {
    double across;
    double height; /* -1 to 1: the tree lies in the unit sphere */
    int color;
};

/* A spruce has tiers of twigs, a broad tree one crown, and a bush blossoms. */
static const struct corner outlines[FOREST_KINDS][16] = {
    {{0.06, -0.98, BARK},
     {0.05, -0.80, BARK},
     {0.46, -0.84, SHADE},
     {0.25, -0.42, NEEDLES},
     {0.16, -0.42, SHADE},
     {0.38, -0.48, SHADE},
     {0.20, -0.06, NEEDLES},
     {0.12, -0.06, SHADE},
     {0.30, -0.12, SHADE},
     {0.14, 0.28, NEEDLES},
     {0.08, 0.28, SHADE},
     {0.21, 0.22, SHADE},
     {0.08, 0.62, NEEDLES},
     {0.05, 0.60, SHADE},
     {0.13, 0.56, SHADE},
     {0.004, 0.99, NEEDLES}},
    {{0.08, -0.99, BARK},
     {0.06, -0.70, BARK},
     {0.06, -0.45, BARK},
     {0.20, -0.48, UNDERSIDE},
     {0.42, -0.40, UNDERSIDE},
     {0.56, -0.22, LEAVES},
     {0.60, 0.00, LEAVES},
     {0.57, 0.22, LEAVES},
     {0.48, 0.44, LEAVES},
     {0.38, 0.60, LEAVES},
     {0.28, 0.72, LEAVES},
     {0.19, 0.80, LEAVES},
     {0.13, 0.85, LEAVES},
     {0.08, 0.88, LEAVES},
     {0.04, 0.90, LEAVES},
     {0.004, 0.91, LEAVES}},
    {{0.10, -0.70, UNDERSIDE},
     {0.34, -0.66, UNDERSIDE},
     {0.56, -0.50, UNDERSIDE},
     {0.70, -0.30, LEAVES},
     {0.76, -0.08, LEAVES},
     {0.76, 0.12, LEAVES},
     {0.70, 0.30, LEAVES},
     {0.62, 0.42, LEAVES},
     {0.54, 0.52, LEAVES},
     {0.45, 0.60, BLOSSOM},
     {0.36, 0.66, BLOSSOM},
     {0.28, 0.70, BLOSSOM},
     {0.20, 0.73, BLOSSOM},
     {0.13, 0.75, BLOSSOM},
     {0.06, 0.76, BLOSSOM},
     {0.004, 0.76, BLOSSOM}},
};

bool forest_mesh_create(struct forest_mesh *mesh, int vertex_count, int index_count)
{
    mesh->vertices = calloc((size_t)vertex_count, sizeof *mesh->vertices);
    mesh->indices = calloc((size_t)index_count, sizeof *mesh->indices);
    mesh->vertex_count = vertex_count;
    mesh->index_count = index_count;
    return mesh->vertices && mesh->indices;
}

void forest_mesh_destroy(struct forest_mesh *mesh)
{
    free(mesh->vertices);
    free(mesh->indices);
    *mesh = (struct forest_mesh){0};
}

static void add_normal(struct forest_mesh *mesh, const uint32_t corners[3])
{
    const float *a = mesh->vertices[corners[0]].position;
    const float *b = mesh->vertices[corners[1]].position;
    const float *c = mesh->vertices[corners[2]].position;
    float u[3], v[3];

    for (int k = 0; k < 3; k++) {
        u[k] = b[k] - a[k];
        v[k] = c[k] - a[k];
    }
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            int next = (k + 1) % 3, last = (k + 2) % 3;
            mesh->vertices[corners[i]].normal[k] += u[next] * v[last] - u[last] * v[next];
        }
}

void forest_mesh_normals(struct forest_mesh *mesh)
{
    for (int i = 0; i < mesh->index_count; i += 3)
        add_normal(mesh, mesh->indices + i);
    for (int i = 0; i < mesh->vertex_count; i++) {
        float *n = mesh->vertices[i].normal;
        float length = sqrtf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (int k = 0; k < 3; k++)
            n[k] = length > 0 ? n[k] / length : (float)(k == 1);
    }
}

/* The outline at `along`, 0 to 1, every stretch between two corners as long as any other. */
static double outline_at(int kind, double along, double *height, float color[3])
{
    double place = 15 * along;
    int below = (int)fmin(place, 14);
    double part = place - below;
    const struct corner *a = &outlines[kind][below], *b = a + 1;

    for (int k = 0; k < 3; k++)
        color[k] = colors[a->color][k] + (float)part * (colors[b->color][k] - colors[a->color][k]);
    *height = a->height + part * (b->height - a->height);
    return a->across + part * (b->across - a->across);
}

/* Twigs and lumps: how far the surface is from its outline, as a factor, 0.75 to 1.1. */
static double rough(int kind, double along, double turn)
{
    if (kind == 0)
        return 0.92 + 0.10 * sin(9 * turn + 40 * along) + 0.07 * sin(14 * turn - 23 * along);
    return 0.93 + 0.10 * sin(3 * turn + 11 * along) * sin(17 * along + 1) +
           0.07 * sin(7 * turn - 19 * along);
}

static void set_vertex(struct forest_vertex *vertex, int kind, double along, double turn)
{
    double height, across = outline_at(kind, along, &height, vertex->color);

    across *= rough(kind, along, turn);
    vertex->position[0] = (float)(across * cos(turn));
    vertex->position[1] = (float)height;
    vertex->position[2] = (float)(across * sin(turn));
}

bool forest_mesh_tree(struct forest_mesh *mesh, int kind, int sides, int rings)
{
    uint32_t *index;

    if (!forest_mesh_create(mesh, sides * (rings + 1), 6 * sides * rings))
        return false;
    index = mesh->indices;
    for (int ring = 0; ring <= rings; ring++)
        for (int side = 0; side < sides; side++)
            set_vertex(&mesh->vertices[ring * sides + side], kind, (double)ring / rings,
                       2 * pi * side / sides);
    for (int ring = 0; ring < rings; ring++)
        for (int side = 0; side < sides; side++) {
            uint32_t a = (uint32_t)(ring * sides + side);
            uint32_t b = (uint32_t)(ring * sides + (side + 1) % sides);
            uint32_t c = a + (uint32_t)sides, d = b + (uint32_t)sides;
            const uint32_t corners[6] = {a, c, b, b, c, d};
            memcpy(index, corners, sizeof corners);
            index += 6;
        }
    forest_mesh_normals(mesh);
    return true;
}
