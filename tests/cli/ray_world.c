/* Random worlds: a closed room, things in it, and the OBJ file of both. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "ray_tracer.h"

static const double NEAREST = 0.05; /* scene units, from the eye */

enum { ROOM_POINTS = 42, ROOM_TRIANGLES = 80 };

/* Four decimals: what the OBJ file says is what is traced. */
static double rounded(double value)
{
    return round(value * 1e4) / 1e4;
}

static struct vector random_direction(uint64_t *random)
{
    double z = random_between(random, -1, 1), angle = random_between(random, 0, 6.283185307);
    double across = sqrt(1 - z * z);

    return (struct vector){across * cos(angle), across * sin(angle), z};
}

static double random_distance(uint64_t *random, double low, double high)
{
    return low * pow(high / low, random_between(random, 0, 1));
}

static double segment_distance(struct vector a, struct vector b)
{
    struct vector along = vector_add(b, vector_scaled(a, -1));
    double t = fmin(1, fmax(0, -vector_dot(a, along) / vector_dot(along, along)));
    struct vector point = vector_add(a, vector_scaled(along, t));

    return sqrt(vector_dot(point, point));
}

/* From the origin; corners relative to it. */
static double triangle_distance(const struct vector corner[3])
{
    struct vector normal = vector_cross(vector_add(corner[1], vector_scaled(corner[0], -1)),
                                        vector_add(corner[2], vector_scaled(corner[0], -1)));
    struct vector foot;
    double distance = (double)INFINITY;
    bool over = true;

    if (vector_dot(normal, normal) == 0)
        return 0;
    foot = vector_scaled(normal, vector_dot(corner[0], normal) / vector_dot(normal, normal));
    for (int i = 0; i < 3; i++) {
        struct vector from = corner[i], to = corner[(i + 1) % 3];
        struct vector side = vector_add(to, vector_scaled(from, -1));
        struct vector inward = vector_cross(normal, side);

        over &= vector_dot(inward, vector_add(foot, vector_scaled(from, -1))) >= 0;
        distance = fmin(distance, segment_distance(from, to));
    }
    return over ? sqrt(vector_dot(foot, foot)) : distance;
}

static void add_triangle(struct traced_world *world, struct vector a, struct vector b,
                         struct vector c, int colour)
{
    struct triangle *triangle = &world->triangles[world->triangle_count++];

    assert_true(world->triangle_count <= TRIANGLES_MAX);
    *triangle = (struct triangle){{a, b, c}, colour};
    for (int i = 0; i < 3; i++)
        triangle->corner[i] =
            (struct vector){rounded(triangle->corner[i].x), rounded(triangle->corner[i].y),
                            rounded(triangle->corner[i].z)};
}

/* Whether the triangles from `first` on keep their distance from the eye; else they go again. */
static bool keep(struct traced_world *world, int first, struct vector eye)
{
    struct vector corner[3];

    for (int t = first; t < world->triangle_count; t++) {
        for (int i = 0; i < 3; i++)
            corner[i] = vector_add(world->triangles[t].corner[i], vector_scaled(eye, -1));
        if (!(triangle_distance(corner) >= NEAREST)) {
            world->triangle_count = first;
            return false;
        }
    }
    return true;
}

static int random_colour(const struct traced_world *world, uint64_t *random)
{
    return (int)random_between(random, 0, world->colour_count);
}

static int middle_of(struct vector *points, int *count, int a, int b)
{
    struct vector middle = vector_normal(vector_add(points[a], points[b]));

    for (int i = 0; i < *count; i++)
        if (vector_dot(points[i], middle) > 1 - 1e-9)
            return i;
    points[*count] = middle;
    return (*count)++;
}

/* An icosahedron, each face cut into four. */
static int make_sphere(struct vector *points, int faces[ROOM_TRIANGLES][3])
{
    static const int ICOSAHEDRON[20][3] = {
        {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
        {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
        {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    const double g = 1.61803398874989485;
    const struct vector corners[12] = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                       {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                       {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
    int count = 12, made = 0;

    for (int i = 0; i < 12; i++)
        points[i] = vector_normal(corners[i]);
    for (int f = 0; f < 20; f++) {
        const int *face = ICOSAHEDRON[f];
        int middle[3];

        for (int i = 0; i < 3; i++)
            middle[i] = middle_of(points, &count, face[i], face[(i + 1) % 3]);
        for (int i = 0; i < 3; i++) {
            faces[made][0] = face[i];
            faces[made][1] = middle[i];
            faces[made++][2] = middle[(i + 2) % 3];
        }
        memcpy(faces[made++], middle, sizeof middle);
    }
    return count;
}

/* Three random directions at right angles. */
static struct rotation random_rotation(uint64_t *random)
{
    struct vector x = random_direction(random);
    struct vector y = vector_normal(vector_cross(x, random_direction(random)));

    return (struct rotation){x, y, vector_cross(x, y)};
}

/*
 * Seen from the eye the room has no hole, because its points keep their directions. It is turned,
 * because an edge along a row of texels would be as far off as the row is, all along.
 */
static void add_room(struct traced_world *world, struct vector eye, uint64_t *random)
{
    struct vector points[ROOM_POINTS];
    int faces[ROOM_TRIANGLES][3];
    double size = random_distance(random, 0.5, 6);
    int count = make_sphere(points, faces);
    struct rotation turn = random_rotation(random);

    assert_int_equal(count, ROOM_POINTS);
    for (int i = 0; i < count; i++)
        points[i] = vector_add(eye, vector_scaled(vector_rotated(&turn, points[i]),
                                                  size * random_distance(random, 0.7, 1.6)));
    for (int f = 0; f < ROOM_TRIANGLES; f++)
        add_triangle(world, points[faces[f][0]], points[faces[f][1]], points[faces[f][2]],
                     random_colour(world, random));
}

static void add_loose_triangle(struct traced_world *world, struct vector eye, double distance,
                               uint64_t *random)
{
    struct vector corner[3], middle = vector_scaled(random_direction(random), distance);
    int first = world->triangle_count;

    middle = vector_add(eye, middle);
    for (int i = 0; i < 3; i++) {
        double apart = distance * random_between(random, 0.1, 0.9);

        corner[i] = vector_add(middle, vector_scaled(random_direction(random), apart));
    }
    add_triangle(world, corner[0], corner[1], corner[2], random_colour(world, random));
    keep(world, first, eye);
}

static void add_box(struct traced_world *world, struct vector eye, double distance,
                    uint64_t *random)
{
    static const int FACES[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                    {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
    struct vector middle = vector_scaled(random_direction(random), distance), corner[8];
    struct rotation turn = random_rotation(random);
    struct vector x = vector_scaled(turn.x, distance * random_between(random, 0.05, 0.4));
    struct vector y = vector_scaled(turn.y, distance * random_between(random, 0.05, 0.4));
    struct vector z = vector_scaled(turn.z, distance * random_between(random, 0.05, 0.4));
    int first = world->triangle_count;

    middle = vector_add(eye, middle);
    for (int i = 0; i < 8; i++) {
        corner[i] = vector_add(middle, vector_scaled(x, i & 1 ? 1 : -1));
        corner[i] = vector_add(corner[i], vector_scaled(y, i & 2 ? 1 : -1));
        corner[i] = vector_add(corner[i], vector_scaled(z, i & 4 ? 1 : -1));
    }
    for (int f = 0; f < 6; f++) {
        const int *face = FACES[f];
        int colour = random_colour(world, random);

        add_triangle(world, corner[face[0]], corner[face[1]], corner[face[2]], colour);
        add_triangle(world, corner[face[0]], corner[face[2]], corner[face[3]], colour);
    }
    keep(world, first, eye);
}

void traced_world_make(struct traced_world *world, struct vector eye, uint64_t *random)
{
    int wished = (int)random_between(random, 0, 180);
    double farthest = random_distance(random, 0.3, 5);

    world->triangle_count = 0;
    world->colour_count = (int)random_between(random, 8, COLOURS_MAX + 1);
    for (int i = 0; i < world->colour_count; i++)
        for (int c = 0; c < 3; c++)
            world->colours[i][c] = round(random_between(random, 0, 1) * 1e3) / 1e3;
    add_room(world, eye, random);
    for (int i = 0; i < 3; i++) /* as near as it may be */
        add_loose_triangle(world, eye, random_between(random, 0.06, 0.1), random);
    while (world->triangle_count < ROOM_TRIANGLES + wished) {
        double distance = random_distance(random, 0.15, farthest);

        if (random_between(random, 0, 1) < 0.08)
            add_box(world, eye, distance, random);
        else
            add_loose_triangle(world, eye, distance, random);
    }
}

static void write_materials(const struct traced_world *world, const char *name)
{
    char path[64];
    FILE *file;

    snprintf(path, sizeof path, "%s.mtl", name);
    file = fopen(path, "w");
    assert_non_null(file);
    for (int i = 0; i < world->colour_count; i++)
        fprintf(file, "newmtl paint%d\nKd %.3f %.3f %.3f\n", i, world->colours[i][0],
                world->colours[i][1], world->colours[i][2]);
    assert_int_equal(fclose(file), 0);
}

/* Either winding; counted from the first vertex of the file or back from the last one. */
static void write_face(FILE *file, int first_vertex, bool turned, bool counted_back)
{
    int a = first_vertex, b = first_vertex + (turned ? 2 : 1), c = first_vertex + (turned ? 1 : 2);

    if (counted_back)
        fprintf(file, "f %d %d %d\n", a - first_vertex - 3, b - first_vertex - 3,
                c - first_vertex - 3);
    else
        fprintf(file, "f %d %d %d\n", a, b, c);
}

void traced_world_write(const struct traced_world *world, const char *name, uint64_t *random)
{
    char path[64];
    FILE *file;
    int colour = -1;

    write_materials(world, name);
    snprintf(path, sizeof path, "%s.obj", name);
    file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "mtllib %s.mtl\n", name);
    for (int t = 0; t < world->triangle_count; t++) {
        const struct triangle *triangle = &world->triangles[t];
        bool turned;

        if (random_between(random, 0, 1) < 0.04)
            fprintf(file, "%s part%d\n", random_between(random, 0, 1) < 0.5 ? "o" : "g", t);
        for (int i = 0; i < 3; i++)
            fprintf(file, "v %.4f %.4f %.4f\n", triangle->corner[i].x, triangle->corner[i].y,
                    triangle->corner[i].z);
        if (triangle->colour != colour)
            fprintf(file, "usemtl paint%d\n", colour = triangle->colour);
        turned = random_between(random, 0, 1) < 0.5;
        write_face(file, 3 * t + 1, turned, random_between(random, 0, 1) < 0.5);
    }
    assert_int_equal(fclose(file), 0);
}
