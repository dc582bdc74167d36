/* PNG files of 8 bits in three channels, by stb_image_write. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "error.h"
#include "image_file.h"

#pragma GCC diagnostic ignored "-Wunused-function" /* until the end: static and not all used */
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdouble-promotion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wundef"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>
#pragma GCC diagnostic pop

/* stb_image_write counts bytes in ints and doubles its buffers. */
static const uint64_t png_bytes_max = 900000000;

/* The comparison is false for NaN. */
static unsigned char byte_of(float value)
{
    if (!(value > 0))
        return 0;
    return value >= 1 ? 255 : (unsigned char)lrint(255.0 * (double)value);
}

struct sink {
    struct atomic_file *file;
    struct cupola_error *error;
    int status;
};

static void add_to_sink(void *context, void *bytes, int size)
{
    struct sink *sink = context;
    if (sink->status == CUPOLA_OK)
        sink->status = atomic_file_add(sink->file, bytes, (size_t)size, sink->error);
}

/* Top row first, as PNG has it. */
static unsigned char *bytes_of_image(const float *rgba, int width, int height)
{
    size_t count = (size_t)width * (size_t)height;
    unsigned char *bytes = malloc(count * IMAGE_CHANNELS);
    if (!bytes)
        return NULL;
    unsigned char *byte = bytes;
    for (int row = height - 1; row >= 0; row--)
        for (int column = 0; column < width; column++)
            for (int channel = 0; channel < IMAGE_CHANNELS; channel++)
                *byte++ = byte_of(
                    rgba[4 * ((size_t)row * (size_t)width + (size_t)column) + (size_t)channel]);
    return bytes;
}

int cupola_png_write(const char *path, const float *rgba, int width, int height,
                     struct cupola_error *error)
{
    int status = image_file_check(path, rgba, width, height, error);
    if (status != CUPOLA_OK)
        return status;
    uint64_t size = ((uint64_t)width * IMAGE_CHANNELS + 1) * (uint64_t)height;
    if (size > png_bytes_max)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "%s: image is %d x %d px; allowed for PNG: up to %d million pixels", path,
                         width, height, (int)(png_bytes_max / IMAGE_CHANNELS / 1000000));
    unsigned char *bytes = bytes_of_image(rgba, width, height);
    if (!bytes)
        return image_file_no_memory(error, path, width, height);
    /* stb_image_write ends the process when it gets no memory, so ask for as much beforehand. */
    void *reserve = malloc((size_t)size * 4 + (1 << 20));
    free(reserve);
    if (!reserve) {
        free(bytes);
        return image_file_no_memory(error, path, width, height);
    }

    struct atomic_file file;
    status = atomic_file_begin(&file, path, error);
    if (status == CUPOLA_OK) {
        struct sink sink = {&file, error, CUPOLA_OK};
        if (!stbi_write_png_to_func(add_to_sink, &sink, width, height, IMAGE_CHANNELS, bytes,
                                    width * IMAGE_CHANNELS) &&
            sink.status == CUPOLA_OK)
            sink.status = image_file_no_memory(error, path, width, height);
        status = image_file_finish(&file, sink.status, error);
    }
    free(bytes);
    return status;
}
