/* Photographs into files. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cupola/image_file.h>
#include <png.h>

#include "capture/light.h"
#include "capture/photo.h"
#include "option_values.h"
#include "short_path.h"
#include "whole_file.h"

const char *photo_format_name(int index)
{
    static const char *const names[] = {"png", "png16", "pfm"};

    return index >= 0 && index < (int)(sizeof names / sizeof *names) ? names[index] : NULL;
}

const char *photo_suffix(enum photo_format format)
{
    return format == PHOTO_PFM ? ".pfm" : ".png";
}

static void fill_rgba(const struct photo *photo, enum photo_format format, float *rgba)
{
    size_t count = (size_t)photo->width * (size_t)photo->height;

    for (size_t i = 0; i < count; i++) {
        float light = photo->light[i];
        float value = format == PHOTO_PFM ? light : (float)light_encode((double)light);
        for (int k = 0; k < 3; k++)
            rgba[4 * i + (size_t)k] = value;
        rgba[4 * i + 3] = 1;
    }
}

static bool write_floats(const char *path, const struct photo *photo, enum photo_format format,
                         char *message)
{
    struct cupola_error error = {0};
    float *rgba = malloc((size_t)photo->width * (size_t)photo->height * 4 * sizeof *rgba);
    int status;

    if (!rgba) {
        snprintf(message, MESSAGE_SIZE, "%s: out of memory", short_path(path).text);
        return false;
    }
    fill_rgba(photo, format, rgba);
    status = format == PHOTO_PFM
                 ? cupola_pfm_write(path, rgba, photo->width, photo->height, &error)
                 : cupola_png_write(path, rgba, photo->width, photo->height, &error);
    free(rgba);
    if (status < 0)
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
    return status >= 0;
}

/* Big end first, as PNG has it, without what a compiler knows of the machine. */
static void fill_row(const struct photo *photo, int row, unsigned char *bytes)
{
    const float *light = photo->light + (size_t)row * (size_t)photo->width;

    for (int i = 0; i < photo->width; i++) {
        double encoded = light_encode(fmin(fmax((double)light[i], 0), 1));
        uint16_t number = (uint16_t)lround(65535 * encoded);
        bytes[2 * i] = (unsigned char)(number >> 8);
        bytes[2 * i + 1] = (unsigned char)(number & 0xff);
    }
}

/* libpng jumps out of its calls where it fails. */
static bool write_rows(png_structp png, png_infop info, FILE *file, const struct photo *photo,
                       unsigned char *bytes)
{
    if (setjmp(png_jmpbuf(png)))
        return false;
    png_init_io(png, file);
    png_set_IHDR(png, info, (png_uint_32)photo->width, (png_uint_32)photo->height, 16,
                 PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_RELATIVE);
    png_set_compression_level(png, 3);
    png_write_info(png, info);
    for (int j = photo->height - 1; j >= 0; j--) {
        fill_row(photo, j, bytes);
        png_write_row(png, bytes);
    }
    png_write_end(png, info);
    return true;
}

static bool write_file16(FILE *file, const struct photo *photo)
{
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    unsigned char *bytes = malloc(2 * (size_t)photo->width);
    bool done = info && bytes && write_rows(png, info, file, photo, bytes);

    png_destroy_write_struct(&png, &info);
    free(bytes);
    return done;
}

static bool write_png16(const char *path, const struct photo *photo, char *message)
{
    struct whole_file file;

    if (!whole_file_begin(&file, path, message))
        return false;
    if (write_file16(file.stream, photo))
        return whole_file_end(&file, message);
    whole_file_abort(&file);
    snprintf(message, MESSAGE_SIZE, "%s cannot be written", short_path(path).text);
    return false;
}

bool photo_write(const char *path, const struct photo *photo, enum photo_format format,
                 char *message)
{
    if (format == PHOTO_PNG16)
        return write_png16(path, photo, message);
    return write_floats(path, photo, format, message);
}
