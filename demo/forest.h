/*
 * The forest in plain arrays: a clearing round the origin, 1.7 units above its ground, in a valley
 * whose slopes rise to all sides, and trees on them. No GL.
 */
#ifndef FOREST_H
#define FOREST_H

#include <stdbool.h>
#include <stdint.h>

/* Spruces, broad trees and bushes. */
enum { FOREST_KINDS = 3 };

struct forest_vertex {
    float position[3];
    float normal[3]; /* unit length, outwards */
    float color[3];
};

struct forest_mesh {
    struct forest_vertex *vertices;
    int vertex_count;
    uint32_t *indices; /* three per triangle, counter-clockwise from outside */
    int index_count;
};

/* A mesh inside of the unit sphere round its origin, put into the world. */
struct forest_tree {
    float place[3]; /* of the sphere's centre, world */
    float radius;
    float turn[2]; /* cosine and sine of a turn round the trunk */
    float tint;    /* 0 to 1 */
};

struct forest {
    struct forest_mesh ground; /* world */
    struct forest_mesh kinds[FOREST_KINDS];
    struct forest_tree *trees[FOREST_KINDS];
    int tree_count[FOREST_KINDS];
    double phases[3]; /* of the ridges */
};

/* False: out of memory, and nothing is made. The same for the same numbers. */
bool forest_create(struct forest *forest, int triangles, unsigned int seed);

void forest_destroy(struct forest *forest);

long forest_triangles(const struct forest *forest);

/* How high the ground lies under a place. */
double forest_ground(const struct forest *forest, double x, double z);

/* No more than the distance from a place to the nearest surface. */
double forest_distance(const struct forest *forest, const double place[3]);

/*
 * A tree of a kind as a surface round its trunk, of 2 sides rings triangles, or nearly so. For
 * forest_create. False: out of memory.
 */
bool forest_mesh_tree(struct forest_mesh *mesh, int kind, int sides, int rings);

/* For forest_create and forest_mesh_tree: room for a mesh, and its normals from its triangles. */
bool forest_mesh_create(struct forest_mesh *mesh, int vertex_count, int index_count);
void forest_mesh_destroy(struct forest_mesh *mesh);
void forest_mesh_normals(struct forest_mesh *mesh);

#endif
