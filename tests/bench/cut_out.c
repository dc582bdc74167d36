/* Parts of pictures as files. */
#include "cut_out.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <cupola/image_file.h>

/* The first row or column of a part round `middle` that stays within the picture. */
static int first_of(double middle, int side_px, int size_px)
{
    int first = (int)lround(middle * size_px - 0.5 * side_px);

    first = first < size_px - side_px ? first : size_px - side_px;
    return first > 0 ? first : 0;
}

static void enlarge(const struct cut_out *cut_out, const unsigned char *rgb, int size_px,
                    int side_px, float *rgba)
{
    int left = first_of(cut_out->x, side_px, size_px), low = first_of(cut_out->y, side_px, size_px);
    int wide_px = side_px * cut_out->scale;

    for (int j = 0; j < wide_px; j++)
        for (int i = 0; i < wide_px; i++) {
            int column = left + i / cut_out->scale, row = low + j / cut_out->scale;
            const unsigned char *from = rgb + 3 * ((size_t)row * (size_t)size_px + (size_t)column);
            float *to = rgba + 4 * ((size_t)j * (size_t)wide_px + (size_t)i);
            for (int k = 0; k < 3; k++)
                to[k] = (float)from[k] / 255.0f;
        }
}

bool cut_out_write(const struct cut_out *cut_out, const char *name, const char *method,
                   const unsigned char *rgb, int size_px, char *message)
{
    int side_px = cut_out->side_px > 0 && cut_out->side_px < size_px ? cut_out->side_px : size_px;
    int wide_px = side_px * cut_out->scale;
    struct cupola_error error = {0};
    char path[1024];
    float *rgba;

    if (!cut_out->folder)
        return true;
    int start = snprintf(path, sizeof path, "%.700s/", cut_out->folder);
    snprintf(path + start, sizeof path - (size_t)start, "%.200s-%.64s.png", name, method);
    for (char *letter = path + start; *letter; letter++)
        if (*letter == ':')
            *letter = '-';
    rgba = calloc((size_t)wide_px * (size_t)wide_px, 4 * sizeof *rgba);
    if (!rgba) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return false;
    }
    enlarge(cut_out, rgb, size_px, side_px, rgba);
    bool written = cupola_png_write(path, rgba, wide_px, wide_px, &error) >= 0;
    free(rgba);
    if (!written)
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
    return written;
}
