/* Picture files as texels. */
#include "film_picture.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <stb/stb_image.h>

#include <cupola/image_file.h>

#include "options.h"
#include "output_file.h"
#include "short_path.h"

enum { SIDE_MAX = 32768 };

static void swap_bytes(unsigned char *a, unsigned char *b, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        unsigned char kept = a[i];
        a[i] = b[i];
        b[i] = kept;
    }
}

/* In items of `size` bytes: rows, or texels. */
static void reverse(void *items, size_t count, size_t size)
{
    unsigned char *bytes = items;

    for (size_t i = 0; i < count / 2; i++)
        swap_bytes(bytes + i * size, bytes + (count - 1 - i) * size, size);
}

/* NULL with one line in `message`. */
static FILE *open_picture(const char *path, char *message)
{
    FILE *file = fopen(path, "rb");
    struct stat status;
    int problem = errno;

    if (file && fstat(fileno(file), &status) == 0 && S_ISDIR(status.st_mode)) {
        fclose(file); /* Linux opens directories for reading */
        file = NULL;
        problem = EISDIR;
    }
    if (!file)
        snprintf(message, MESSAGE_SIZE, "--show: %s cannot be opened: %s", short_path(path).text,
                 strerror(problem));
    return file;
}

static bool read_bytes(const char *path, struct film_picture *picture, char *message)
{
    FILE *file = open_picture(path, message);

    if (!file)
        return false;
    if (stbi_info_from_file(file, &picture->width, &picture->height, NULL) &&
        (picture->width > SIDE_MAX || picture->height > SIDE_MAX)) {
        snprintf(message, MESSAGE_SIZE, "--show: %s is %d x %d px; allowed: up to %d each way",
                 short_path(path).text, picture->width, picture->height, SIDE_MAX);
        fclose(file);
        return false;
    }
    picture->bytes = stbi_load_from_file(file, &picture->width, &picture->height, NULL, 4);
    fclose(file);
    if (picture->bytes) {
        reverse(picture->bytes, (size_t)picture->height, 4 * (size_t)picture->width);
        return true;
    }
    snprintf(
        message, MESSAGE_SIZE,
        "--show: %s cannot be read (%s); allowed: PNG, JPEG, PFM and what else stb_image reads",
        short_path(path).text, stbi_failure_reason());
    return false;
}

bool film_picture_read(const char *path, struct film_picture *picture, char *message)
{
    struct cupola_error error = {0};

    *picture = (struct film_picture){0};
    if (!output_file_is_pfm(path))
        return read_bytes(path, picture, message);
    if (cupola_pfm_read(path, &picture->floats, &picture->width, &picture->height, &error) >= 0)
        return true;
    snprintf(message, MESSAGE_SIZE, "--show: %s", error.message);
    return false;
}

void film_picture_free(struct film_picture *picture)
{
    stbi_image_free(picture->bytes);
    cupola_image_free(&picture->floats);
    picture->bytes = NULL;
}

void film_picture_turn(struct film_picture *picture)
{
    size_t count = (size_t)picture->width * (size_t)picture->height;

    if (picture->bytes)
        reverse(picture->bytes, count, 4);
    else
        reverse(picture->floats, count, 4 * sizeof *picture->floats);
}
