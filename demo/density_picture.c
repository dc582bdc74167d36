/* The density map of an output as a picture: false colours and a scale, the paper's figure 8. */
#include "density_picture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cupola/image_file.h>
#include <cupola/resolution.h>
#include <cupola/text.h>

#include "options.h"
#include "output_file.h"
#include "short_path.h"

/* Of the scale, in units of its letters; TICKS numbers along a bar of STEPS colours. */
enum {
    PANEL_WIDTH = 240,
    PANEL_HEIGHT = 66,
    BAR_WIDTH = 192,
    BAR_HEIGHT = 12,
    LINE_HEIGHT = 12,
    MARGIN = 4,
    TICKS = 5,
    STEPS = 16,
    PX_PER_LETTER = 350, /* of the picture's shorter side, for each texel of a unit */
};

struct canvas {
    float *rgba;
    int width, height;
};

/* Solid angles, sr, that the first and the last colour stand for; between them by ratios. */
struct scale {
    double low, high;
};

static struct scale scale_of(const float *map, size_t count)
{
    struct scale scale = {HUGE_VAL, 0};

    for (size_t i = 0; i < count; i++) {
        if (!(map[i] > 0))
            continue;
        scale.low = fmin(scale.low, (double)map[i]);
        scale.high = fmax(scale.high, (double)map[i]);
    }
    if (!(scale.high > 0))
        return (struct scale){1e-6, 1e-5}; /* nothing is lit */
    if (scale.high < 1.02 * scale.low)
        scale = (struct scale){scale.low / 1.1, scale.high * 1.12}; /* in the middle of a step */
    return scale;
}

static double value_at(const struct scale *scale, double part)
{
    return scale->low * pow(scale->high / scale->low, part);
}

/* From dark blue, fine, to light yellow, coarse, in steps that can be told apart. */
static void color_at(double part, float *rgba)
{
    static const double ramp[][3] = {{0.12, 0.08, 0.35}, {0.13, 0.33, 0.62}, {0.10, 0.58, 0.58},
                                     {0.40, 0.76, 0.33}, {0.96, 0.80, 0.22}, {1.00, 0.97, 0.78}};
    enum { LAST = sizeof ramp / sizeof *ramp - 1 };
    double step = fmin(fmax(floor(part * STEPS), 0), STEPS - 1);
    double at = step / (STEPS - 1) * LAST;
    int from = (int)fmin(at, LAST - 1);

    for (int c = 0; c < 3; c++)
        rgba[c] = (float)(ramp[from][c] + (at - from) * (ramp[from + 1][c] - ramp[from][c]));
    rgba[3] = 1;
}

static void paint_map(const float *map, const struct scale *scale, struct canvas *canvas)
{
    double octaves = log(scale->high / scale->low);
    size_t count = (size_t)canvas->width * (size_t)canvas->height;

    for (size_t i = 0; i < count; i++) {
        static const float unlit[4] = {0, 0, 0, 1};
        if (map[i] > 0)
            color_at(log((double)map[i] / scale->low) / octaves, canvas->rgba + 4 * i);
        else
            memcpy(canvas->rgba + 4 * i, unlit, sizeof unlit);
    }
}

/* ---- the scale ---- */

/* Text with its middle at x and its lower edge at y, px. */
static bool write_text(struct canvas *canvas, const char *text, int letter, int x, int y)
{
    int width, height;
    unsigned char *letters;

    if (cupola_text_size(text, letter, &width, &height, NULL) < 0)
        return false;
    letters = malloc(4 * (size_t)width * (size_t)height);
    if (!letters || cupola_text_draw(text, letter, letters, width, height, NULL) < 0) {
        free(letters);
        return false;
    }
    for (int v = 0; v < height; v++)
        for (int u = 0; u < width; u++) {
            int to_x = x - width / 2 + u, to_y = y + v;
            if (to_x < 0 || to_x >= canvas->width || to_y < 0 || to_y >= canvas->height)
                continue;
            float *pixel = canvas->rgba + 4 * ((size_t)to_y * (size_t)canvas->width + (size_t)to_x);
            const unsigned char *texel = letters + 4 * ((size_t)v * (size_t)width + (size_t)u);
            for (int c = 0; c < 3; c++)
                pixel[c] = pixel[c] * (1 - texel[3] / 255.0f) + texel[c] / 255.0f;
        }
    free(letters);
    return true;
}

static void fill(struct canvas *canvas, const int box[4], const struct scale *scale)
{
    for (int y = box[2]; y < box[3]; y++)
        for (int x = box[0]; x < box[1]; x++) {
            float *pixel = canvas->rgba + 4 * ((size_t)y * (size_t)canvas->width + (size_t)x);
            if (scale)
                color_at((x + 0.5 - box[0]) / (box[1] - box[0]), pixel);
            else
                pixel[0] = pixel[1] = pixel[2] = 0.1f;
        }
}

/* Numbers above the bar in units of 10^exponent sr, below it in pixels per degree. */
static bool write_ticks(struct canvas *canvas, const struct scale *scale, const int bar[4],
                        int letter, int exponent)
{
    static const double degree = 3.14159265358979323846 / 180;

    for (int i = 0; i < TICKS; i++) {
        double part = (double)i / (TICKS - 1), value = value_at(scale, part);
        int x = bar[0] + (int)(part * (bar[1] - bar[0]));
        char text[32];
        snprintf(text, sizeof text, "%.3g", value * pow(10, -exponent));
        if (!write_text(canvas, text, letter, x, bar[3] + letter / 2))
            return false;
        snprintf(text, sizeof text, "%.3g", degree / sqrt(value));
        if (!write_text(canvas, text, letter, x, bar[2] - LINE_HEIGHT * letter))
            return false;
    }
    return true;
}

/* In the middle of the lower edge; nothing in pictures that are too small for it. */
static bool paint_scale(struct canvas *canvas, const struct scale *scale)
{
    int shorter = canvas->width < canvas->height ? canvas->width : canvas->height;
    int letter = shorter > 2 * PX_PER_LETTER ? shorter / PX_PER_LETTER : 1, middle;
    int exponent = 3 * (int)floor(log10(sqrt(scale->low * scale->high)) / 3);
    char title[64];

    if (letter > 64)
        letter = 64;
    if (canvas->width < PANEL_WIDTH * letter || canvas->height < 3 * PANEL_HEIGHT * letter)
        return true;
    middle = canvas->width / 2;
    const int panel[4] = {middle - PANEL_WIDTH * letter / 2, middle + PANEL_WIDTH * letter / 2,
                          MARGIN * letter, (MARGIN + PANEL_HEIGHT) * letter};
    const int low = panel[2] + (MARGIN + 2 * LINE_HEIGHT) * letter;
    const int bar[4] = {middle - BAR_WIDTH * letter / 2, middle + BAR_WIDTH * letter / 2, low,
                        low + BAR_HEIGHT * letter};
    fill(canvas, panel, NULL);
    fill(canvas, bar, scale);
    snprintf(title, sizeof title, "solid angle of a pixel, 1e%d sr", exponent);
    return write_ticks(canvas, scale, bar, letter, exponent) &&
           write_text(canvas, title, letter, middle, bar[3] + LINE_HEIGHT * letter) &&
           write_text(canvas, "pixels per degree", letter, middle, panel[2] + MARGIN * letter);
}

/* ---- files ---- */

static void copy_numbers(const float *map, struct canvas *canvas)
{
    size_t count = (size_t)canvas->width * (size_t)canvas->height;

    for (size_t i = 0; i < count; i++) {
        float *pixel = canvas->rgba + 4 * i;
        pixel[0] = pixel[1] = pixel[2] = map[i];
        pixel[3] = 1;
    }
}

static int write_file(const char *path, const float *map, struct canvas *canvas,
                      struct cupola_error *error)
{
    struct scale scale = scale_of(map, (size_t)canvas->width * (size_t)canvas->height);

    if (output_file_is_pfm(path)) {
        copy_numbers(map, canvas);
        return cupola_pfm_write(path, canvas->rgba, canvas->width, canvas->height, error);
    }
    paint_map(map, &scale, canvas);
    if (!paint_scale(canvas, &scale)) {
        snprintf(error->message, sizeof error->message, "out of memory for the scale");
        return CUPOLA_ERROR_MEMORY;
    }
    return cupola_png_write(path, canvas->rgba, canvas->width, canvas->height, error);
}

bool density_picture_write(const char *path, const cupola_dome *dome, int output, char *message)
{
    const struct cupola_output *size = &cupola_dome_rig(dome)->outputs[output];
    struct canvas canvas = {NULL, size->width_px, size->height_px};
    struct cupola_error error = {0};
    size_t count = (size_t)canvas.width * (size_t)canvas.height;
    float *map = malloc(count * sizeof *map);
    int status = CUPOLA_ERROR_MEMORY;

    canvas.rgba = malloc(4 * count * sizeof *canvas.rgba);
    if (!map || !canvas.rgba)
        snprintf(error.message, sizeof error.message, "%s: out of memory for %dx%d pixels",
                 short_path(path).text, canvas.width, canvas.height);
    else if ((status = cupola_density_map(dome, output, NULL, map, &error)) >= 0)
        status = write_file(path, map, &canvas, &error);
    free(canvas.rgba);
    free(map);
    if (status < 0)
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
    return status >= 0;
}
