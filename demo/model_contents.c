/* One number for all that is drawn of a model (FNV-1a, by words of 32 bits). */
#include "model.h"

#include <string.h>

static uint64_t take(uint64_t number, const void *words, size_t count)
{
    uint32_t word;

    for (size_t i = 0; i < count; i++) {
        memcpy(&word, (const char *)words + i * sizeof word, sizeof word);
        number = (number ^ word) * 1099511628211u;
        number ^= number >> 29;
    }
    return number;
}

uint64_t model_contents(const struct model *model)
{
    const uint32_t counts[4] = {model->vertex_count, model->index_count,
                                (uint32_t)model->batch_count, (uint32_t)model->picture_count};
    uint64_t number = take(14695981039346656037u, counts, 4);

    number = take(number, model->vertices, model->vertex_count * (sizeof *model->vertices / 4));
    number = take(number, model->indices, model->index_count);
    for (int i = 0; i < model->batch_count; i++) {
        const struct model_batch *batch = &model->batches[i];
        const uint32_t words[4] = {(uint32_t)batch->picture, batch->vertex_colored, batch->first,
                                   batch->count};
        number = take(number, words, 4);
    }
    for (int i = 0; i < model->picture_count; i++) {
        const struct model_picture *picture = &model->pictures[i];
        const uint32_t size[2] = {(uint32_t)picture->width, (uint32_t)picture->height};
        number = take(number, size, 2);
        if (picture->rgba)
            number = take(number, picture->rgba, (size_t)size[0] * size[1]);
    }
    return number;
}
