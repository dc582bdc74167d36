/* Photographs from files. */
#include "capture/photo.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include <cupola/image_file.h>
#include <stb/stb_image.h>

#include "capture/light.h"
#include "option_values.h"
#include "short_path.h"

static const char allowed_text[] = "allowed: PNG, JPEG, PFM";

void photo_free(struct photo *photo)
{
    free(photo->light);
    *photo = (struct photo){0};
}

bool photo_create(struct photo *photo, int width, int height, char *message)
{
    *photo = (struct photo){.width = width, .height = height};
    photo->light = calloc((size_t)width * (size_t)height, sizeof *photo->light);
    if (!photo->light)
        snprintf(message, MESSAGE_SIZE, "out of memory for a photograph of %dx%d pixels", width,
                 height);
    return photo->light != NULL;
}

static bool ends_with(const char *name, const char *suffix)
{
    size_t length = strlen(name), end = strlen(suffix);

    return length > end && strcasecmp(name + length - end, suffix) == 0;
}

bool photo_is_named(const char *name)
{
    return ends_with(name, ".png") || ends_with(name, ".jpg") || ends_with(name, ".jpeg") ||
           ends_with(name, ".pfm");
}

bool photo_cuts_off(const char *name)
{
    return !ends_with(name, ".pfm");
}

bool photo_size_is_allowed(const char *name, int width, int height, char *message)
{
    if (width <= PHOTO_SIDE_MAX && height <= PHOTO_SIDE_MAX &&
        (double)width * height <= PHOTO_PIXELS_MAX)
        return true;
    snprintf(message, MESSAGE_SIZE, "%s is %d x %d px; allowed: up to %d each way and %d in all",
             name, width, height, PHOTO_SIDE_MAX, PHOTO_PIXELS_MAX);
    return false;
}

static bool read_pfm(const char *path, struct photo *photo, char *message)
{
    struct cupola_error error = {0};
    float *rgba = NULL;
    int width = 0, height = 0;

    if (cupola_pfm_read(path, &rgba, &width, &height, &error) < 0) {
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
        return false;
    }
    if (!photo_size_is_allowed(short_path(path).text, width, height, message) ||
        !photo_create(photo, width, height, message)) {
        cupola_image_free(&rgba);
        return false;
    }
    for (size_t i = 0; i < (size_t)width * (size_t)height; i++)
        photo->light[i] = (rgba[4 * i] + rgba[4 * i + 1] + rgba[4 * i + 2]) / 3;
    cupola_image_free(&rgba);
    return true;
}

/* The light of every number that 8 or 16 bits hold; NULL without memory. */
static float *decoding_table(enum photo_encoding encoding, int most)
{
    float *table = malloc(((size_t)most + 1) * sizeof *table);

    for (int i = 0; table && i <= most; i++) {
        double number = (double)i / most;
        table[i] = (float)(encoding == PHOTO_SRGB ? light_decode(number) : number);
    }
    return table;
}

/* Top row first in the file. `shorts` or `bytes` is NULL. */
static bool decode(const uint16_t *shorts, const unsigned char *bytes, enum photo_encoding encoding,
                   struct photo *photo)
{
    float *table = decoding_table(encoding, shorts ? 65535 : 255);

    if (!table)
        return false;
    for (int j = 0; j < photo->height; j++) {
        size_t from = 3 * (size_t)(photo->height - 1 - j) * (size_t)photo->width;
        float *row = photo->light + (size_t)j * (size_t)photo->width;
        for (int i = 0; i < photo->width; i++, from += 3) {
            float sum = 0;
            for (size_t k = from; k < from + 3; k++)
                sum += table[shorts ? shorts[k] : bytes[k]];
            row[i] = sum / 3;
        }
    }
    free(table);
    return true;
}

/* PNG or JPEG by its first bytes: of all that stb reads these alone hold photographs. */
static bool is_known(FILE *file)
{
    static const unsigned char png[] = {0x89, 'P', 'N', 'G'}, jpeg[] = {0xff, 0xd8, 0xff};
    unsigned char first[4] = {0};
    size_t count = fread(first, 1, sizeof first, file);

    rewind(file);
    return count == sizeof first &&
           (memcmp(first, png, sizeof png) == 0 || memcmp(first, jpeg, sizeof jpeg) == 0);
}

static bool read_stb(FILE *file, const char *path, enum photo_encoding encoding,
                     struct photo *photo, char *message)
{
    int width = 0, height = 0;
    unsigned char *bytes = NULL;
    uint16_t *shorts = NULL;
    bool done = false;

    if (!is_known(file) || !stbi_info_from_file(file, &width, &height, NULL)) {
        snprintf(message, MESSAGE_SIZE, "%s cannot be read (no PNG or JPEG); %s",
                 short_path(path).text, allowed_text);
        return false;
    }
    if (!photo_size_is_allowed(short_path(path).text, width, height, message))
        return false;
    if (stbi_is_16_bit_from_file(file))
        shorts = stbi_load_from_file_16(file, &width, &height, NULL, 3);
    else
        bytes = stbi_load_from_file(file, &width, &height, NULL, 3);
    if (!shorts && !bytes) {
        snprintf(message, MESSAGE_SIZE, "%s cannot be read (%s); %s", short_path(path).text,
                 stbi_failure_reason(), allowed_text);
        return false;
    }
    if (photo_create(photo, width, height, message)) {
        done = decode(shorts, bytes, encoding, photo);
        if (!done) {
            photo_free(photo);
            snprintf(message, MESSAGE_SIZE, "%s: out of memory", short_path(path).text);
        }
    }
    stbi_image_free(shorts);
    stbi_image_free(bytes);
    return done;
}

bool photo_read(const char *path, enum photo_encoding encoding, struct photo *photo, char *message)
{
    FILE *file;
    bool done;

    *photo = (struct photo){0};
    if (ends_with(path, ".pfm"))
        return read_pfm(path, photo, message);
    file = fopen(path, "rb");
    if (!file) {
        snprintf(message, MESSAGE_SIZE, "%s cannot be read: %s", short_path(path).text,
                 strerror(errno));
        return false;
    }
    done = read_stb(file, path, encoding, photo, message);
    fclose(file);
    return done;
}
