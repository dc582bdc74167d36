/* PNG files of 8 bits in three channels, by stb_image_write. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "error.h"
#include "image_file.h"

/*
 * stb_image_write ends the process where it gets no memory, so it draws from one block that is
 * allocated beforehand, large enough for all that it asks for; nothing goes back before the end.
 * Its hooks know no context: the block of the call under way is the thread's.
 */
struct arena {
    unsigned char *next, *end;
    unsigned char *stream; /* the compressed data once they are longer than any chain */
    size_t stream_size;    /* that they may reach */
};

static _Thread_local struct arena arena;

/*
 * What it asks for, with D bytes of rows, each with its filter's number in front:
 *   D, one row, and 2^14 pointers to chains;
 *   a chain each of at most 16 pointers: 2, 5, 11, then 23 places and 8 bytes are asked for;
 *   the compressed stream, 9 bits a byte at worst, which grows to twice its length and a little;
 *   the file, in which data that would not shrink are stored: 5 bytes more every 32767.
 */
enum { CHAINS = 1 << 14, CHAIN_SIZE_MAX = 23 * 8 + 8, CHAIN_SIZES = 32 + 48 + 96 + 192 };
enum { ARENA_ALIGNMENT = 16, ARENA_SLACK = 1 << 16 };

_Static_assert(sizeof(void *) <= 8, "chains of pointers of 8 bytes at most");

static size_t stream_size_max(size_t rows_size)
{
    return 2 * (rows_size + rows_size / 8 + 64);
}

static size_t arena_size(size_t rows_size)
{
    return 3 * rows_size + rows_size / 4096 + stream_size_max(rows_size) +
           (size_t)CHAINS * (sizeof(void *) + CHAIN_SIZES) + ARENA_SLACK;
}

static void *arena_take(size_t size)
{
    unsigned char *block = arena.next;
    size_t rounded = (size + ARENA_ALIGNMENT - 1) / ARENA_ALIGNMENT * ARENA_ALIGNMENT;
    if (rounded > (size_t)(arena.end - block))
        return NULL;
    arena.next += rounded;
    return block;
}

static void *arena_grow(void *block, size_t old_size, size_t size)
{
    void *grown = arena.stream;
    if (size <= CHAIN_SIZE_MAX)
        grown = arena_take(size);
    else if (!arena.stream)
        grown = arena.stream = arena_take(arena.stream_size);
    else if (size > arena.stream_size)
        return NULL;
    if (grown && grown != block && block)
        memcpy(grown, block, old_size);
    return grown;
}

#define STBIW_MALLOC(size) arena_take((size_t)(size))
#define STBIW_REALLOC_SIZED(block, old_size, size)                                                 \
    arena_grow(block, (size_t)(old_size), (size_t)(size))
#define STBIW_FREE(block) ((void)(block))

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
    unsigned char *memory = malloc(arena_size((size_t)size));
    if (!memory) {
        free(bytes);
        return image_file_no_memory(error, path, width, height);
    }
    arena = (struct arena){.next = memory,
                           .end = memory + arena_size((size_t)size),
                           .stream_size = stream_size_max((size_t)size)};

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
    arena = (struct arena){0};
    free(memory);
    free(bytes);
    return status;
}
