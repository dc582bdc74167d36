/*
 * The pictures on a model's surfaces: files beside the model, or inside of it. A picture that
 * cannot be read is counted and the material's colour stands alone.
 */
#include "model.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <assimp/material.h>
#include <assimp/scene.h>
#include <stb/stb_image.h>

enum { PATH_SIZE = 4096 };

static void flip_rows(unsigned char *rgba, int width, int height)
{
    size_t row_size = 4 * (size_t)width;
    for (int j = 0; j < height / 2; j++) {
        unsigned char *low = rgba + row_size * (size_t)j;
        unsigned char *high = rgba + row_size * (size_t)(height - 1 - j);
        for (size_t i = 0; i < row_size; i++) {
            unsigned char swapped = low[i];
            low[i] = high[i];
            high[i] = swapped;
        }
    }
}

/* Texels of 8 bits, blue first. */
static bool copy_texels(const struct aiTexture *texture, struct model_picture *picture)
{
    const unsigned int most = 16384;
    if (texture->mWidth == 0 || texture->mWidth > most || texture->mHeight > most)
        return false;
    size_t count = (size_t)texture->mWidth * texture->mHeight;
    picture->rgba = malloc(4 * count);
    if (!picture->rgba)
        return false;
    for (size_t i = 0; i < count; i++) {
        const struct aiTexel *texel = &texture->pcData[i];
        const unsigned char rgba[4] = {texel->r, texel->g, texel->b, texel->a};
        memcpy(picture->rgba + 4 * i, rgba, 4);
    }
    picture->width = (int)texture->mWidth;
    picture->height = (int)texture->mHeight;
    return true;
}

static const struct aiTexture *find_inside(const struct aiScene *source, const char *name)
{
    if (name[0] == '*') {
        unsigned long index = strtoul(name + 1, NULL, 10);
        return index < source->mNumTextures ? source->mTextures[index] : NULL;
    }
    for (unsigned int i = 0; i < source->mNumTextures; i++)
        if (source->mTextures[i]->mFilename.length > 0 &&
            strcmp(source->mTextures[i]->mFilename.data, name) == 0)
            return source->mTextures[i];
    return NULL;
}

static bool read_file(const char *path, struct model_picture *picture)
{
    picture->rgba = stbi_load(path, &picture->width, &picture->height, NULL, 4);
    return picture->rgba != NULL;
}

/* As the model names it, seen from the model; else the same file name beside the model. */
static bool read_beside(const char *model_path, const char *name, struct model_picture *picture)
{
    char clean[PATH_SIZE], path[2 * PATH_SIZE];
    snprintf(clean, sizeof clean, "%s", name);
    for (char *c = clean; *c; c++)
        if (*c == '\\')
            *c = '/';
    if (clean[0] == '/' && read_file(clean, picture))
        return true;
    const char *slash = strrchr(model_path, '/');
    int folder = slash ? (int)(slash - model_path) + 1 : 0;
    snprintf(path, sizeof path, "%.*s%s", folder, model_path, clean);
    if (read_file(path, picture))
        return true;
    const char *last = strrchr(clean, '/');
    if (!last)
        return false;
    snprintf(path, sizeof path, "%.*s%s", folder, model_path, last + 1);
    return read_file(path, picture);
}

static void read_picture(struct model_picture *picture, const char *model_path,
                         const struct aiScene *source)
{
    const struct aiTexture *inside = find_inside(source, picture->name);
    bool found;
    if (inside && inside->mHeight > 0)
        found = copy_texels(inside, picture);
    else if (inside)
        found = inside->mWidth <= INT32_MAX &&
                (picture->rgba = stbi_load_from_memory((const unsigned char *)inside->pcData,
                                                       (int)inside->mWidth, &picture->width,
                                                       &picture->height, NULL, 4));
    else
        found = read_beside(model_path, picture->name, picture);
    if (found)
        flip_rows(picture->rgba, picture->width, picture->height);
}

static char *copy_of(const char *text)
{
    size_t size = strlen(text) + 1;
    char *copy = malloc(size);
    if (copy)
        memcpy(copy, text, size);
    return copy;
}

int model_picture_find(struct model *model, const char *model_path, const struct aiScene *source,
                       const struct aiMaterial *material, unsigned int *channel)
{
    struct aiString name;
    *channel = 0;
    if (aiGetMaterialTexture(material, aiTextureType_BASE_COLOR, 0, &name, NULL, channel, NULL,
                             NULL, NULL, NULL) != AI_SUCCESS &&
        aiGetMaterialTexture(material, aiTextureType_DIFFUSE, 0, &name, NULL, channel, NULL, NULL,
                             NULL, NULL) != AI_SUCCESS)
        return -1;
    for (int i = 0; i < model->picture_count; i++)
        if (strcmp(model->pictures[i].name, name.data) == 0)
            return model->pictures[i].rgba ? i : -1;

    size_t count = (size_t)model->picture_count + 1;
    struct model_picture *grown = realloc(model->pictures, count * sizeof *grown);
    if (!grown)
        return -1;
    model->pictures = grown;
    struct model_picture *picture = &grown[model->picture_count];
    *picture = (struct model_picture){.name = copy_of(name.data)};
    if (!picture->name)
        return -1;
    read_picture(picture, model_path, source);
    int index = model->picture_count++;
    if (picture->rgba)
        return index;
    model->missing_pictures++;
    return -1;
}
