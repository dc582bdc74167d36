/*
 * Reading a model with assimp, and bringing its meshes to their places in the world. Files are not
 * trusted: whatever counts and indices assimp hands over are checked before they are used.
 */
#include "model.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <assimp/cimport.h>
#include <assimp/material.h>
#include <assimp/metadata.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include "short_path.h"

/* Deeper trees are broken files; so many vertices need more memory than a demo should take. */
enum { DEPTH_MAX = 1000, INSTANCES_MAX = 10000000 };
static const uint64_t vertices_max = 200000000;

/* A mesh at a place. */
struct instance {
    const struct aiMesh *mesh;
    double place[3][4]; /* rows: world = place (x, 1) */
    float base[3];
    int picture; /* -1: none */
    unsigned int channel;
    bool vertex_colored;
};

struct loading {
    const char *path;
    const struct aiScene *source;
    bool is_3ds; /* the file's format */
    struct model *model;
    struct instance *instances;
    size_t instance_count;
    size_t instance_room;
    char *message;
    size_t message_size;
};

static bool refuse(struct loading *loading, const char *reason)
{
    snprintf(loading->message, loading->message_size, "%s: %s", short_path(loading->path).text,
             reason);
    for (char *c = loading->message; *c; c++)
        if (*c == '\n' || *c == '\r')
            *c = ' ';
    return false;
}

static bool check_file(struct loading *loading)
{
    struct stat status;
    if (stat(loading->path, &status) != 0)
        return refuse(loading, strerror(errno));
    if (!S_ISREG(status.st_mode))
        return refuse(loading, "is no file; a model is needed (OBJ, PLY, glTF, 3DS ...)");
    FILE *file = fopen(loading->path, "rb");
    if (!file)
        return refuse(loading, strerror(errno));
    fclose(file);
    if (status.st_size == 0)
        return refuse(loading, "is empty; a model is needed (OBJ, PLY, glTF, 3DS ...)");
    return true;
}

/* From what assimp says of a file that it has read. */
static bool is_3ds(const struct aiScene *source)
{
    const struct aiMetadata *data = source->mMetaData;
    for (unsigned int i = 0; data && i < data->mNumProperties; i++) {
        const struct aiMetadataEntry *entry = &data->mValues[i];
        if (entry->mType == AI_AISTRING && entry->mData &&
            strcmp(data->mKeys[i].data, "SourceAsset_Format") == 0 &&
            strstr(((const struct aiString *)entry->mData)->data, "3DS"))
            return true;
    }
    return false;
}

static const struct aiScene *import(struct loading *loading)
{
    /*
     * Not JoinIdenticalVertices: it joins what is nearer than 1e-5 units, so small models break.
     * Not GenSmoothNormals: it takes vertices that triangles share for one triangle's.
     */
    const struct aiScene *source =
        aiImportFile(loading->path, aiProcess_ValidateDataStructure | aiProcess_Triangulate);
    if (source)
        loading->is_3ds = is_3ds(source);
    else {
        char reason[1024];
        snprintf(reason, sizeof reason, "cannot be read as a model (OBJ, PLY, glTF, 3DS ...): %s",
                 aiGetErrorString());
        refuse(loading, reason);
    }
    return source;
}

static void base_color(const struct aiMaterial *material, bool vertex_colored, float base[3])
{
    for (int k = 0; k < 3; k++)
        base[k] = 1;
    /* assimp gives files without materials a grey one; it must not darken the vertices' colours. */
    struct aiString name;
    if (vertex_colored && aiGetMaterialString(material, AI_MATKEY_NAME, &name) == AI_SUCCESS &&
        (name.length == 0 || strcmp(name.data, AI_DEFAULT_MATERIAL_NAME) == 0))
        return;
    struct aiColor4D color;
    if (aiGetMaterialColor(material, AI_MATKEY_BASE_COLOR, &color) != AI_SUCCESS &&
        aiGetMaterialColor(material, AI_MATKEY_COLOR_DIFFUSE, &color) != AI_SUCCESS)
        return;
    base[0] = isfinite(color.r) ? color.r : 0;
    base[1] = isfinite(color.g) ? color.g : 0;
    base[2] = isfinite(color.b) ? color.b : 0;
}

static bool add_instance(struct loading *loading, unsigned int mesh_index, double place[3][4])
{
    if (mesh_index >= loading->source->mNumMeshes)
        return refuse(loading, "is broken: it places a mesh that is not there");
    const struct aiMesh *mesh = loading->source->mMeshes[mesh_index];
    bool triangles = mesh->mPrimitiveTypes & (aiPrimitiveType_TRIANGLE | aiPrimitiveType_POLYGON);
    if (!triangles || mesh->mNumFaces == 0 || !mesh->mVertices)
        return true;
    if (loading->instance_count == loading->instance_room) {
        size_t room = loading->instance_room ? 2 * loading->instance_room : 64;
        if (room > INSTANCES_MAX)
            return refuse(loading, "has more than ten million parts, which is too many");
        struct instance *grown = realloc(loading->instances, room * sizeof *grown);
        if (!grown)
            return refuse(loading, "out of memory");
        loading->instances = grown;
        loading->instance_room = room;
    }
    struct instance *instance = &loading->instances[loading->instance_count++];
    *instance = (struct instance){.mesh = mesh, .picture = -1, .base = {1, 1, 1}};
    memcpy(instance->place, place, sizeof instance->place);
    instance->vertex_colored = mesh->mColors[0] != NULL;
    if (mesh->mMaterialIndex < loading->source->mNumMaterials) {
        const struct aiMaterial *material = loading->source->mMaterials[mesh->mMaterialIndex];
        base_color(material, instance->vertex_colored, instance->base);
        instance->picture = model_picture_find(loading->model, loading->path, loading->source,
                                               material, &instance->channel);
    }
    bool mapped = instance->channel < AI_MAX_NUMBER_OF_TEXTURECOORDS &&
                  mesh->mTextureCoords[instance->channel];
    if (!mapped)
        instance->picture = -1;
    return true;
}

/* Goes down the tree of nodes, as assimp itself does. */
static bool add_node(struct loading *loading, const struct aiNode *node, double parent[3][4],
                     int depth)
{
    if (depth > DEPTH_MAX)
        return refuse(loading, "has parts nested deeper than 1000 levels");
    const struct aiMatrix4x4 *m = &node->mTransformation;
    const double own[4][4] = {{(double)m->a1, (double)m->a2, (double)m->a3, (double)m->a4},
                              {(double)m->b1, (double)m->b2, (double)m->b3, (double)m->b4},
                              {(double)m->c1, (double)m->c2, (double)m->c3, (double)m->c4},
                              {0, 0, 0, 1}};
    double place[3][4];
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 4; column++) {
            place[row][column] = 0;
            for (int k = 0; k < 4; k++)
                place[row][column] += parent[row][k] * own[k][column];
        }
    for (unsigned int i = 0; i < node->mNumMeshes; i++)
        if (!add_instance(loading, node->mMeshes[i], place))
            return false;
    for (unsigned int i = 0; i < node->mNumChildren; i++)
        if (!add_node(loading, node->mChildren[i], place, depth + 1))
            return false;
    return true;
}

static int batch_order(const void *a, const void *b)
{
    const struct instance *p = a, *q = b;
    if (p->picture != q->picture)
        return p->picture < q->picture ? -1 : 1;
    if (p->vertex_colored != q->vertex_colored)
        return p->vertex_colored ? 1 : -1;
    return 0;
}

/*
 * The normal's own transformation is the matrix of cofactors, which also serves where places are
 * flat or mirrored. Zero where the file's normal is none.
 */
static void place_normal(const double m[3][4], const struct aiVector3D *from, float normal[3])
{
    const double n[3] = {(double)from->x, (double)from->y, (double)from->z};
    double turned[3], squared = 0;
    for (int i = 0; i < 3; i++) {
        const double *p = m[(i + 1) % 3], *q = m[(i + 2) % 3];
        turned[i] = (p[1] * q[2] - p[2] * q[1]) * n[0] + (p[2] * q[0] - p[0] * q[2]) * n[1] +
                    (p[0] * q[1] - p[1] * q[0]) * n[2];
        squared += turned[i] * turned[i];
    }
    double length = sqrt(squared);
    bool usable = isfinite(length) && length > 0;
    for (int i = 0; i < 3; i++)
        normal[i] = usable ? (float)(turned[i] / length) : 0;
}

static bool fill_vertex(const struct instance *instance, unsigned int index, bool take_normals,
                        struct model_vertex *vertex)
{
    const struct aiMesh *mesh = instance->mesh;
    const struct aiVector3D *at = &mesh->mVertices[index];
    memset(vertex, 0, sizeof *vertex);
    for (int row = 0; row < 3; row++) {
        const double *m = instance->place[row];
        vertex->position[row] =
            (float)(m[0] * (double)at->x + m[1] * (double)at->y + m[2] * (double)at->z + m[3]);
        if (!isfinite(vertex->position[row]))
            return false;
    }
    if (take_normals && mesh->mNormals)
        place_normal(instance->place, &mesh->mNormals[index], vertex->normal);
    memcpy(vertex->base, instance->base, sizeof vertex->base);
    for (int k = 0; k < 3; k++)
        vertex->color[k] = 1;
    if (instance->vertex_colored) {
        const struct aiColor4D *color = &mesh->mColors[0][index];
        vertex->color[0] = isfinite(color->r) ? color->r : 0;
        vertex->color[1] = isfinite(color->g) ? color->g : 0;
        vertex->color[2] = isfinite(color->b) ? color->b : 0;
    }
    if (instance->picture >= 0) {
        const struct aiVector3D *uv = &mesh->mTextureCoords[instance->channel][index];
        vertex->texcoord[0] = isfinite(uv->x) ? uv->x : 0;
        vertex->texcoord[1] = isfinite(uv->y) ? uv->y : 0;
    }
    return true;
}

/* Normals of 3DS files are assimp's own, smooth over every edge: the format has none. */
static bool fill_triangles(struct loading *loading, const struct instance *instance,
                           bool want_normals)
{
    bool take_normals = want_normals && !loading->is_3ds;
    struct model *model = loading->model;
    const struct aiMesh *mesh = instance->mesh;
    for (unsigned int f = 0; f < mesh->mNumFaces; f++) {
        const struct aiFace *face = &mesh->mFaces[f];
        if (face->mNumIndices != 3)
            continue;
        for (int corner = 0; corner < 3; corner++) {
            if (face->mIndices[corner] >= mesh->mNumVertices)
                return refuse(loading, "is broken: a triangle uses a vertex that is not there");
            struct model_vertex *vertex = &model->vertices[model->vertex_count];
            if (!fill_vertex(instance, face->mIndices[corner], take_normals, vertex))
                return refuse(loading, "is broken: a vertex has a coordinate that is no finite "
                                       "number");
            model->indices[model->index_count++] = model->vertex_count++;
        }
    }
    return true;
}

static bool fill(struct loading *loading, bool want_normals)
{
    struct model *model = loading->model;
    uint64_t corners = 0;
    for (size_t i = 0; i < loading->instance_count; i++)
        corners += 3 * (uint64_t)loading->instances[i].mesh->mNumFaces;
    if (corners > vertices_max)
        return refuse(loading, "has more than 66 million triangles, which is too many");
    if (corners == 0)
        return refuse(loading, "has no triangles");
    qsort(loading->instances, loading->instance_count, sizeof *loading->instances, batch_order);
    model->vertices = malloc(corners * sizeof *model->vertices);
    model->indices = malloc(corners * sizeof *model->indices);
    model->batches = calloc(loading->instance_count, sizeof *model->batches);
    if (!model->vertices || !model->indices || !model->batches)
        return refuse(loading, "out of memory");
    for (size_t i = 0; i < loading->instance_count; i++) {
        const struct instance *instance = &loading->instances[i];
        if (i == 0 || batch_order(&loading->instances[i - 1], instance) != 0)
            model->batches[model->batch_count++] =
                (struct model_batch){.picture = instance->picture,
                                     .vertex_colored = instance->vertex_colored,
                                     .first = model->index_count};
        if (!fill_triangles(loading, instance, want_normals))
            return false;
        struct model_batch *batch = &model->batches[model->batch_count - 1];
        batch->count = model->index_count - batch->first;
    }
    if (model->index_count == 0)
        return refuse(loading, "has no triangles");
    if (!model_has_area(model))
        return refuse(loading, "has no triangle to draw: the corners of each lie on a line or in "
                               "one point");
    if ((want_normals && !model_normals(model)) || !model_weld(model))
        return refuse(loading, "out of memory");
    return true;
}

/*
 * The inverse of what assimp did to a file's coordinates: it turns every 3DS file's Z axis up, as
 * the format's first program had it, though files do not say which axis is up.
 */
static void undo_turn(bool turned, double place[3][4])
{
    static const double upright[3][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
    static const double turned_back[3][4] = {{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}};
    memcpy(place, turned ? turned_back : upright, sizeof upright);
}

struct model *model_load(const char *path, bool want_normals, char *message, size_t message_size)
{
    struct loading loading = {.path = path, .message = message, .message_size = message_size};
    double place[3][4];
    bool loaded = false;
    if (!check_file(&loading))
        return NULL;
    loading.model = calloc(1, sizeof *loading.model);
    if (!loading.model) {
        refuse(&loading, "out of memory");
        return NULL;
    }
    loading.source = import(&loading);
    if (loading.source && !loading.source->mRootNode)
        refuse(&loading, "is broken: nothing in it is placed anywhere");
    else if (loading.source) {
        undo_turn(loading.is_3ds, place);
        loaded =
            add_node(&loading, loading.source->mRootNode, place, 0) && fill(&loading, want_normals);
    }
    free(loading.instances);
    aiReleaseImport(loading.source);
    if (loaded)
        return loading.model;
    model_destroy(loading.model);
    return NULL;
}

void model_destroy(struct model *model)
{
    if (!model)
        return;
    for (int i = 0; i < model->picture_count; i++) {
        free(model->pictures[i].name);
        free(model->pictures[i].rgba);
    }
    free(model->pictures);
    free(model->batches);
    free(model->indices);
    free(model->vertices);
    free(model);
}
