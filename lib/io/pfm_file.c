/* PFM files: floats, bit for bit. */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "c_locale.h"
#include "error.h"
#include "image_file.h"
#include "input_file.h"

static void little_endian_of(float value, unsigned char bytes[4])
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    for (int i = 0; i < 4; i++)
        bytes[i] = (unsigned char)(bits >> (8 * i));
}

static float float_of(const unsigned char bytes[4], bool little_endian)
{
    uint32_t bits = 0;
    float value;
    for (int i = 0; i < 4; i++)
        bits |= (uint32_t)bytes[little_endian ? i : 3 - i] << (8 * i);
    memcpy(&value, &bits, sizeof value);
    return value;
}

int cupola_pfm_write(const char *path, const float *rgba, int width, int height,
                     struct cupola_error *error)
{
    int status = image_file_check(path, rgba, width, height, error);
    if (status != CUPOLA_OK)
        return status;
    size_t row_size = (size_t)width * IMAGE_CHANNELS * sizeof(float);
    unsigned char *row = malloc(row_size);
    if (!row)
        return image_file_no_memory(error, path, width, height);
    struct atomic_file file;
    status = atomic_file_begin(&file, path, error);
    if (status == CUPOLA_OK) {
        char header[64];
        int length = snprintf(header, sizeof header, "PF\n%d %d\n-1.0\n", width, height);
        status = atomic_file_add(&file, header, (size_t)length, error);
        for (int y = 0; y < height && status == CUPOLA_OK; y++) {
            const float *pixel = rgba + 4 * (size_t)y * (size_t)width;
            for (int x = 0; x < width; x++, pixel += 4)
                for (int channel = 0; channel < IMAGE_CHANNELS; channel++)
                    little_endian_of(pixel[channel], row + 4 * (IMAGE_CHANNELS * x + channel));
            status = atomic_file_add(&file, row, row_size, error);
        }
        status = image_file_finish(&file, status, error);
    }
    free(row);
    return status;
}

struct pfm_header {
    int channels;
    int width;
    int height;
    bool little_endian;
    size_t size; /* bytes up to the first float */
};

static bool is_space(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/* Copies the next word of a text; NULL where there is none or it is longer than a number is. */
static const char *take_word(const char *text, char word[32])
{
    size_t length = 0;
    while (is_space(*text))
        text++;
    while (text[length] && !is_space(text[length]))
        length++;
    if (length == 0 || length >= 32)
        return NULL;
    memcpy(word, text, length);
    word[length] = 0;
    return text + length;
}

static int side_of(const char *word)
{
    int side = 0;
    for (; *word >= '0' && *word <= '9' && side <= IMAGE_SIDE_MAX_PX; word++)
        side = 10 * side + (*word - '0');
    return *word || side > IMAGE_SIDE_MAX_PX ? 0 : side;
}

/* Expects the C locale. */
static bool scale_of(const char *word, double *scale)
{
    char *end;
    *scale = strtod(word, &end);
    return !*end && isfinite(*scale) && *scale != 0;
}

/*
 * "PF" or "Pf", width, height and scale with white space between, and one white space behind.
 * Expects the C locale.
 */
static int parse_header(const char *path, const char *text, struct pfm_header *header,
                        struct cupola_error *error)
{
    static const char *const names[] = {"width", "height"};
    int sides[2];
    char word[32];
    double scale;
    if (strncmp(text, "PF", 2) != 0 && strncmp(text, "Pf", 2) != 0)
        return error_set(error, CUPOLA_ERROR_SYNTAX,
                         "%s: does not begin with PF or Pf, so it is no PFM file", path);
    header->channels = text[1] == 'F' ? IMAGE_CHANNELS : 1;
    const char *next = text + 2;
    if (!is_space(*next))
        return error_set(error, CUPOLA_ERROR_SYNTAX,
                         "%s: white space is missing after %.2s in the PFM header", path, text);
    for (int i = 0; i < 2; i++) {
        next = take_word(next, word);
        sides[i] = next ? side_of(word) : 0;
        if (sides[i] == 0)
            return error_set(error, CUPOLA_ERROR_SYNTAX,
                             "%s: %s in the PFM header is '%s'; allowed: 1 to %d", path, names[i],
                             next ? word : "", (int)IMAGE_SIDE_MAX_PX);
    }
    next = take_word(next, word);
    if (!next || !scale_of(word, &scale))
        return error_set(error, CUPOLA_ERROR_SYNTAX,
                         "%s: scale in the PFM header is '%s'; allowed: a finite number other "
                         "than 0, below 0 for little-endian data",
                         path, next ? word : "");
    if (!is_space(*next))
        return error_set(error, CUPOLA_ERROR_SYNTAX,
                         "%s: white space is missing after the scale in the PFM header", path);
    header->width = sides[0];
    header->height = sides[1];
    header->little_endian = scale < 0;
    header->size = (size_t)(next + 1 - text);
    return CUPOLA_OK;
}

static int read_header(const char *path, FILE *file, struct pfm_header *header,
                       struct cupola_error *error)
{
    char text[257];
    size_t length = fread(text, 1, sizeof text - 1, file);
    text[length] = 0;
    if (ferror(file))
        return error_set(error, CUPOLA_ERROR_FILE, "%s: cannot be read", path);
    struct c_locale locale;
    if (c_locale_enter(&locale) != 0)
        return error_set(error, CUPOLA_ERROR_MEMORY, "%s: out of memory", path);
    int status = parse_header(path, text, header, error);
    c_locale_leave(&locale);
    return status;
}

static int read_pixels(const char *path, FILE *file, const struct pfm_header *header, float **rgba,
                       struct cupola_error *error)
{
    size_t count = (size_t)header->width * (size_t)header->height;
    size_t pixel_size = (size_t)header->channels * sizeof(float);
    size_t row_size = (size_t)header->width * pixel_size;
    float *pixels =
        count > SIZE_MAX / (4 * sizeof(float)) ? NULL : malloc(count * 4 * sizeof(float));
    unsigned char *row = malloc(row_size);
    int status = CUPOLA_OK;
    if (!pixels || !row) {
        status = image_file_no_memory(error, path, header->width, header->height);
        goto fail;
    }
    float *pixel = pixels;
    for (int y = 0; y < header->height; y++) {
        if (fread(row, 1, row_size, file) != row_size) {
            status = error_set(error, CUPOLA_ERROR_FILE, "%s: cannot be read", path);
            goto fail;
        }
        for (int x = 0; x < header->width; x++, pixel += 4) {
            const unsigned char *bytes = row + (size_t)x * pixel_size;
            for (int channel = 0; channel < IMAGE_CHANNELS; channel++)
                pixel[channel] = float_of(bytes + (header->channels == 1 ? 0 : 4 * channel),
                                          header->little_endian);
            pixel[3] = 1;
        }
    }
    *rgba = pixels;
    free(row);
    return CUPOLA_OK;

fail:
    free(pixels);
    free(row);
    return status;
}

int cupola_pfm_read(const char *path, float **rgba, int *width, int *height,
                    struct cupola_error *error)
{
    struct pfm_header header = {0};
    uint64_t size;
    FILE *file;
    if (!rgba || !width || !height)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "place for the image is NULL; allowed: pointers to pixels, width, height");
    int status = input_file_open(path, &file, &size, error);
    if (status != CUPOLA_OK)
        return status;
    status = read_header(path, file, &header, error);
    if (status != CUPOLA_OK)
        goto done;
    /* Before anything is allocated: a small file must not ask for gigabytes. */
    uint64_t expected = (uint64_t)header.width * (uint64_t)header.height *
                        (uint64_t)header.channels * sizeof(float);
    if (size - header.size != expected) {
        status = error_set(error, CUPOLA_ERROR_SYNTAX,
                           "%s: %llu bytes of pixels follow the header; allowed for %d x %d px of "
                           "%d channel%s: %llu",
                           path, (unsigned long long)(size - header.size), header.width,
                           header.height, header.channels, header.channels == 1 ? "" : "s",
                           (unsigned long long)expected);
        goto done;
    }
    if (fseek(file, (long)header.size, SEEK_SET) != 0)
        status = error_set(error, CUPOLA_ERROR_FILE, "%s: cannot be read", path);
    else
        status = read_pixels(path, file, &header, rgba, error);
    if (status == CUPOLA_OK) {
        *width = header.width;
        *height = header.height;
    }

done:
    fclose(file);
    return status;
}
