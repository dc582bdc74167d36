/*
 * Vertices that are the same to the last bit become one, so that a mesh's vertices are shaded once
 * and not six times. No tolerance: nothing moves.
 */
#include "model.h"

#include <stdlib.h>
#include <string.h>

/* FNV-1a over 32-bit words (Fowler, Noll, Vo), mixed once more for its low bits. */
static uint64_t hash(const struct model_vertex *vertex)
{
    uint32_t words[sizeof *vertex / sizeof(uint32_t)];
    memcpy(words, vertex, sizeof words);
    uint64_t value = 0xcbf29ce484222325u;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        value = (value ^ words[i]) * 0x100000001b3u;
    return value ^ (value >> 29);
}

bool model_weld(struct model *model)
{
    uint64_t size = 16;
    while (size < 2 * (uint64_t)model->vertex_count)
        size *= 2;
    uint32_t *slots = calloc(size, sizeof *slots); /* number of a kept vertex plus 1; 0: free */
    uint32_t *renamed = malloc(model->vertex_count * sizeof *renamed);
    if (!slots || !renamed) {
        free(slots);
        free(renamed);
        return false;
    }
    uint32_t kept = 0;
    for (uint32_t i = 0; i < model->vertex_count; i++) {
        const struct model_vertex *vertex = &model->vertices[i];
        uint64_t slot = hash(vertex) & (size - 1);
        while (slots[slot] &&
               memcmp(&model->vertices[slots[slot] - 1], vertex, sizeof *vertex) != 0)
            slot = (slot + 1) & (size - 1);
        if (!slots[slot]) {
            if (kept != i)
                model->vertices[kept] = *vertex;
            slots[slot] = ++kept;
        }
        renamed[i] = slots[slot] - 1;
    }
    for (uint32_t i = 0; i < model->index_count; i++)
        model->indices[i] = renamed[model->indices[i]];
    free(slots);
    free(renamed);
    model->vertex_count = kept;
    struct model_vertex *shrunk = realloc(model->vertices, kept * sizeof *shrunk);
    if (shrunk)
        model->vertices = shrunk;
    return true;
}
