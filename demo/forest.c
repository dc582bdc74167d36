/* Ground and places of the forest. */
#include "forest.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

static const double eye_height = 1.7;
static const double garden = 3;    /* radius from which on there are bushes */
static const double clearing = 15; /* radius from which on there are trees */
static const double valley = 200;  /* radius up to which there are trees */
static const double ground_end = 240;
static const double tree_radius_rad = 2 * 3.14159265358979323846 / 180;

/* splitmix64 (Steele et al. 2014), as a number from 0 to 1. */
static double random_number(uint64_t *state)
{
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);

    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/* Flat in the middle, then slopes of 0.4 to 0.9 that are highest in the direction of ridges. */
double forest_ground(const struct forest *forest, double x, double z)
{
    const double bend = 25;
    double across = hypot(x, z), turn = atan2(z, x);
    double slope = 0.65 + 0.12 * sin(3 * turn + forest->phases[0]) +
                   0.08 * sin(5 * turn + forest->phases[1]) +
                   0.05 * sin(9 * turn + forest->phases[2]);

    return slope * (hypot(across, bend) - bend) - eye_height;
}

static void ground_vertex(const struct forest *forest, double across, double turn,
                          struct forest_vertex *vertex)
{
    static const float meadow[3] = {0.46f, 0.55f, 0.26f}, soil[3] = {0.34f, 0.36f, 0.20f};
    double x = across * cos(turn), z = across * sin(turn);
    float part = (float)fmin(across / (2 * clearing), 1);
    float patch = 1 + 0.10f * (float)(sin(0.9 * x + sin(0.7 * z)) * sin(0.8 * z + sin(0.6 * x)));

    vertex->position[0] = (float)x;
    vertex->position[1] = (float)forest_ground(forest, x, z);
    vertex->position[2] = (float)z;
    for (int k = 0; k < 3; k++)
        vertex->color[k] = patch * (meadow[k] + part * (soil[k] - meadow[k]));
}

/* Rings that widen outwards round a vertex in the middle: sides (2 rings - 1) triangles. */
static bool create_ground(struct forest *forest, int rings, int sides)
{
    struct forest_mesh *mesh = &forest->ground;
    uint32_t *index;

    if (!forest_mesh_create(mesh, rings * sides + 1, 3 * sides * (2 * rings - 1)))
        return false;
    index = mesh->indices;
    ground_vertex(forest, 0, 0, &mesh->vertices[0]);
    for (int ring = 0; ring < rings; ring++)
        for (int side = 0; side < sides; side++) {
            uint32_t here = (uint32_t)(1 + ring * sides + side);
            uint32_t beside = (uint32_t)(1 + ring * sides + (side + 1) % sides);
            double across = pow(ground_end, (ring + 1.0) / rings);
            ground_vertex(forest, across, 2 * pi * side / sides, &mesh->vertices[here]);
            uint32_t inner = ring ? here - (uint32_t)sides : 0;
            const uint32_t corners[6] = {here,   inner, beside,
                                         beside, inner, beside - (uint32_t)sides};
            memcpy(index, corners, (ring ? 6 : 3) * sizeof *index);
            index += ring ? 6 : 3;
        }
    forest_mesh_normals(mesh);
    return true;
}

/*
 * Tree `index` of all, evenly over the directions (a sequence of two irrational steps) but for some
 * chance. As wide as it must be to be seen under 2 degrees from the origin; `foot` is how far its
 * ground lies below its centre, of its radius.
 */
static struct forest_tree place_tree(const struct forest *forest, int index, double nearest,
                                     double farthest, double foot, uint64_t *seed)
{
    double turn = 2 * pi * (0.7548776662466927 * index + 0.03 * random_number(seed));
    double part = fmod(0.5698402909980532 * index + 0.03 * random_number(seed), 1);
    double across = nearest * pow(farthest / nearest, part);
    double x = across * cos(turn), z = across * sin(turn), y = forest_ground(forest, x, z);
    double size = sin(tree_radius_rad) * (0.8 + 0.4 * random_number(seed));
    double spin = 2 * pi * random_number(seed), radius = size * hypot(across, y);

    /* The higher the centre, the farther away; twice is near enough. */
    for (int i = 0; i < 2; i++)
        radius = size * hypot(across, y + foot * radius);
    return (struct forest_tree){.place = {(float)x, (float)(y + foot * radius), (float)z},
                                .radius = (float)radius,
                                .turn = {(float)cos(spin), (float)sin(spin)},
                                .tint = (float)random_number(seed)};
}

/* One in seven is a bush in the clearing, and of the trees behind it one in three is broad. */
static bool create_trees(struct forest *forest, int count, uint64_t *seed)
{
    for (int kind = 0; kind < FOREST_KINDS; kind++) {
        forest->trees[kind] = calloc((size_t)count, sizeof *forest->trees[kind]);
        if (!forest->trees[kind])
            return false;
    }
    for (int i = 0; i < count; i++) {
        int kind = i % 7 == 0 ? 2 : random_number(seed) < 1.0 / 3;
        forest->trees[kind][forest->tree_count[kind]++] =
            kind == 2 ? place_tree(forest, i / 7, garden, clearing, 0.6, seed)
                      : place_tree(forest, i - i / 7, clearing, valley, 0.93, seed);
    }
    return true;
}

bool forest_create(struct forest *forest, int triangles, unsigned int seed)
{
    const int trees_wished = 2000, least_of_tree = 100;
    uint64_t state = seed;
    int rings = (int)fmax(4, fmin(48, sqrt(triangles / 150.0))), left, wished, sides;

    *forest = (struct forest){0};
    for (int i = 0; i < 3; i++)
        forest->phases[i] = 2 * pi * random_number(&state);
    if (!create_ground(forest, rings, rings * 4 / 3))
        goto fail;
    left = triangles - forest->ground.index_count / 3;
    wished = left / trees_wished > least_of_tree ? left / trees_wished : least_of_tree;
    sides = (int)fmax(5, round(sqrt(wished / 2.0 / 1.5)));
    rings = (int)fmax(7, round(wished / 2.0 / sides));
    for (int kind = 0; kind < FOREST_KINDS; kind++)
        if (!forest_mesh_tree(&forest->kinds[kind], kind, sides, rings))
            goto fail;
    if (!create_trees(forest, (int)round(left / (2.0 * sides * rings)), &state))
        goto fail;
    return true;

fail:
    forest_destroy(forest);
    return false;
}

void forest_destroy(struct forest *forest)
{
    forest_mesh_destroy(&forest->ground);
    for (int kind = 0; kind < FOREST_KINDS; kind++) {
        forest_mesh_destroy(&forest->kinds[kind]);
        free(forest->trees[kind]);
    }
    *forest = (struct forest){0};
}

long forest_triangles(const struct forest *forest)
{
    long triangles = forest->ground.index_count / 3;

    for (int kind = 0; kind < FOREST_KINDS; kind++)
        triangles += (long)forest->tree_count[kind] * (forest->kinds[kind].index_count / 3);
    return triangles;
}

double forest_distance(const struct forest *forest, const double place[3])
{
    /* The ground is nowhere steeper than 1.5: 0.9 outwards, 1.2 along its rings. */
    const double steepest = 1.5;
    double above = fabs(place[1] - forest_ground(forest, place[0], place[2]));
    double nearest = above / hypot(1, steepest);

    for (int kind = 0; kind < FOREST_KINDS; kind++)
        for (int i = 0; i < forest->tree_count[kind]; i++) {
            const struct forest_tree *tree = &forest->trees[kind][i];
            double squared = 0;
            for (int k = 0; k < 3; k++)
                squared += pow(place[k] - (double)tree->place[k], 2);
            nearest = fmin(nearest, fmax(sqrt(squared) - (double)tree->radius, 0));
        }
    return nearest;
}
