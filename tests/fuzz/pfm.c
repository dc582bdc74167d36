/* Any bytes as a PFM: refused in one line, or the very floats that the bytes are. */
#define _GNU_SOURCE /* memfd_create: the reader wants the name of a regular file */

#include <sys/mman.h>
#include <unistd.h>

#include "cupola/image_file.h"
#include "target.h"

static int file_of(const uint8_t *data, size_t size)
{
    static int fd = -1;
    if (fd < 0)
        fd = memfd_create("pfm", 0);
    require(fd >= 0);
    require(ftruncate(fd, 0) == 0);
    require(pwrite(fd, data, size, 0) == (ssize_t)size);
    return fd;
}

static uint32_t bits_at(const uint8_t *bytes, int little_endian)
{
    uint32_t bits = 0;
    for (int i = 0; i < 4; i++)
        bits = bits << 8 | bytes[little_endian ? 3 - i : i];
    return bits;
}

/* One of both byte orders fits every pixel: which, is for the header to say. */
static void require_pixels(const uint8_t *data, size_t size, const float *rgba, size_t count)
{
    int channels = data[1] == 'F' ? 3 : 1, orders = 3;
    require(size >= 4 * count * (size_t)channels);
    const uint8_t *pixels = data + size - 4 * count * (size_t)channels;
    for (size_t i = 0; i < count; i++) {
        require(rgba[4 * i + 3] == 1.0f);
        for (size_t c = 0; c < 3; c++) {
            const uint8_t *bytes = pixels + 4 * ((size_t)channels * i + (channels == 3 ? c : 0));
            uint32_t bits;
            memcpy(&bits, &rgba[4 * i + c], sizeof bits);
            for (int order = 0; order < 2; order++)
                if (bits != bits_at(bytes, order))
                    orders &= ~(1 << order);
        }
    }
    require(orders != 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    char path[64];
    float mark, *rgba = &mark;
    int width = -7, height = -7;
    snprintf(path, sizeof path, "/proc/self/fd/%d", file_of(data, size));
    int status = cupola_pfm_read(path, &rgba, &width, &height, &error);
    if (status == CUPOLA_OK) {
        require(width >= 1 && width <= 32768 && height >= 1 && height <= 32768);
        require_pixels(data, size, rgba, (size_t)width * (size_t)height);
        cupola_image_free(&rgba);
        require(rgba == NULL);
    } else {
        require_message(&error, status);
        require(rgba == &mark && width == -7 && height == -7);
    }
    return 0;
}
