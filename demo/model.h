/* A model in plain arrays: what assimp reads from a file, with every part at its place in the
 * world. */
#ifndef MODEL_H
#define MODEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct model_vertex {
    float position[3]; /* world */
    float normal[3];   /* world, unit length, on the side from which the triangle runs
                        * counter-clockwise; zero where it was not wished for */
    float base[3];     /* the material's diffuse colour, as the file has it */
    float color[3];    /* of the vertex alone; to be multiplied with the material's */
    float texcoord[2]; /* origin bottom left */
};

/* A run of triangles that are drawn alike. */
struct model_batch {
    int picture;         /* index; -1: none */
    bool vertex_colored; /* else `color` is white */
    uint32_t first;      /* index into the indices */
    uint32_t count;
};

struct model_picture {
    char *name; /* as the material has it */
    int width;
    int height;
    unsigned char *rgba; /* rows from the bottom up; NULL: it could not be read */
};

struct model {
    struct model_vertex *vertices;
    uint32_t vertex_count;
    uint32_t *indices; /* three per triangle */
    uint32_t index_count;
    struct model_batch *batches;
    int batch_count;
    struct model_picture *pictures;
    int picture_count;
    int missing_pictures; /* those that could not be read; the material's colour stands alone */
};

/*
 * Reads a model. Triangles only: points and lines are left out. Nothing is rescaled or moved.
 *
 * want_normals  makes normals where the file has none, smooth but for hard edges
 * returns       NULL on failure, with one line in `message` that names the file
 */
struct model *model_load(const char *path, bool want_normals, char *message, size_t message_size);

/* Destroys it; NULL is allowed. */
void model_destroy(struct model *model);

/*
 * For model_load, before model_weld: makes the normals that are zero, and turns every normal to the
 * side from which its triangle runs counter-clockwise. False: out of memory.
 */
bool model_normals(struct model *model);

/* Likewise before model_weld: whether any triangle has an area. */
bool model_has_area(const struct model *model);

/* Makes one of all vertices that are the same to the last bit. False: out of memory. */
bool model_weld(struct model *model);

struct aiScene;
struct aiMaterial;

/*
 * The picture of a material's colour: its index, or -1 if there is none that can be read. Sets the
 * channel of texture coordinates that goes with it. For model_load.
 */
int model_picture_find(struct model *model, const char *model_path, const struct aiScene *source,
                       const struct aiMaterial *material, unsigned int *channel);

/*
 * All that is drawn of a model as one number: what its file holds, and the files that this names.
 * Before anybody takes its pictures away.
 */
uint64_t model_contents(const struct model *model);

/* The sphere round the box round all vertices that triangles use. */
void model_bounds(const struct model *model, double center[3], double *radius);

/* Exact distance from a place to the nearest triangle. */
double model_distance(const struct model *model, const double place[3]);

/*
 * Whether a place is inside of a closed room: along all six axes, the nearest triangle turns its
 * front towards the place. (From within a solid body one sees the backs of its triangles.)
 */
bool model_is_room(const struct model *model, const double place[3]);

#endif
