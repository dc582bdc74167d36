/* From places of single pixels to fewer and more exact ones. */
#include "capture/patches.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "capture/surface_fit.h"
#include "option_values.h"

/* Squares do not overlap: a cell has room for the smallest. */
enum { HALF_MIN = 4, HALF_MAX = 40, CELL_MIN = 2 * HALF_MIN + 1 };

/* Of a square's pixels, at least this part is decoded and this part kept by the surface. */
static const double least_decoded = 0.6, least_kept = 0.7;

/* Where the noise is as predicted, samples are spread by it; texture of the screen adds some. */
static const double most_spread = 5, allowed_spread_px = 0.5;

void patches_free(struct patches *patches)
{
    free(patches->list);
    *patches = (struct patches){0};
}

static int half_side(const struct code_map *map, double cell)
{
    int longest = map->width > map->height ? map->width : map->height;
    int half = longest / 80;

    if (half > 0.5 * cell - 0.5)
        half = (int)floor(0.5 * cell - 0.5);
    return half < HALF_MIN ? HALF_MIN : half > HALF_MAX ? HALF_MAX : half;
}

static bool is_decoded(const struct code_map *map, int i, int j)
{
    return i >= 0 && j >= 0 && i < map->width && j < map->height &&
           map->state[(size_t)j * (size_t)map->width + (size_t)i] == CODE_DECODED;
}

/* How many pixels of the square round a pixel are decoded. */
static int count_decoded(const struct code_map *map, int i, int j, int half)
{
    int count = 0;

    for (int b = j - half; b <= j + half; b++) {
        for (int a = i - half; a <= i + half; a++)
            count += is_decoded(map, a, b);
    }
    return count;
}

/* The squares of a grid of cells: calls of `visit` until there are no more. */
struct squares {
    const struct code_map *map;
    double cell;
    int half;
    int columns, rows, at;
};

static struct squares squares_begin(const struct code_map *map, double cell)
{
    return (struct squares){
        .map = map,
        .cell = cell,
        .half = half_side(map, cell),
        .columns = (int)fmax(floor(map->width / cell), 1),
        .rows = (int)fmax(floor(map->height / cell), 1),
    };
}

/* The next one that meets decoded pixels; false at the end. */
static bool squares_next(struct squares *squares, int *i, int *j, int *decoded)
{
    while (squares->at < squares->columns * squares->rows) {
        int column = squares->at % squares->columns, row = squares->at / squares->columns;
        squares->at++;
        *i = (int)(squares->map->width * (column + 0.5) / squares->columns);
        *j = (int)(squares->map->height * (row + 0.5) / squares->rows);
        *decoded = count_decoded(squares->map, *i, *j, squares->half);
        if (*decoded > 0)
            return true;
    }
    return false;
}

static bool is_full(const struct squares *squares, int decoded)
{
    int side = 2 * squares->half + 1;

    return decoded >= least_decoded * side * side && decoded >= SURFACE_LEAST;
}

static int count_full(const struct code_map *map, double cell)
{
    struct squares squares = squares_begin(map, cell);
    int count = 0, i, j, decoded;

    while (squares_next(&squares, &i, &j, &decoded))
        count += is_full(&squares, decoded);
    return count;
}

/* The cell by which there are about as many full squares as wanted. */
static double find_cell(const struct code_map *map, int wanted)
{
    double cell = sqrt((double)map->counts[CODE_DECODED] / wanted);
    double most = map->width > map->height ? map->width : map->height;

    for (int round = 0; round < 6; round++) {
        int count = count_full(map, fmax(cell, CELL_MIN));
        double factor = sqrt(fmax(count, 0.25) / wanted);
        if (fabs(factor - 1) < 0.01)
            break;
        cell *= fmin(fmax(factor, 0.5), 2);
    }
    return fmin(fmax(cell, CELL_MIN), most);
}

/* The square's samples, from the middle of those that are decoded, which is `middle`. */
static int collect(const struct squares *squares, int i, int j, double middle[2],
                   struct surface_sample *samples, double predicted[2])
{
    const struct code_map *map = squares->map;
    int half = squares->half, count = 0;

    middle[0] = middle[1] = predicted[0] = predicted[1] = 0;
    for (int b = j - half; b <= j + half; b++) {
        for (int a = i - half; a <= i + half; a++) {
            size_t pixel = (size_t)b * (size_t)map->width + (size_t)a;
            struct surface_sample *sample = &samples[count];
            if (!is_decoded(map, a, b))
                continue;
            count++;
            sample->at[0] = a + 0.5;
            sample->at[1] = b + 0.5;
            for (int k = 0; k < 2; k++) {
                sample->place[k] = (double)map->place_px[k][pixel];
                predicted[k] += (double)map->sd_px[k][pixel];
                middle[k] += sample->at[k];
            }
        }
    }
    for (int k = 0; k < 2; k++) {
        middle[k] /= count;
        predicted[k] /= count;
        for (int s = 0; s < count; s++)
            samples[s].at[k] = (samples[s].at[k] - middle[k]) / half;
    }
    return count;
}

static bool is_smooth(const struct surface_fit *fit, int count, const double predicted[2])
{
    if (fit->kept < least_kept * count)
        return false;
    for (int k = 0; k < 2; k++) {
        if (fit->spread[k] > fmax(most_spread * predicted[k], allowed_spread_px))
            return false;
    }
    return true;
}

static void fit_all(struct squares *squares, struct surface_sample *samples,
                    struct patches *patches)
{
    int i, j, decoded;

    while (squares_next(squares, &i, &j, &decoded) && patches->count < PATCHES_MAX) {
        struct patch *patch = &patches->list[patches->count];
        struct surface_fit fit;
        double predicted[2];
        if (!is_full(squares, decoded)) {
            patches->thin++;
            continue;
        }
        decoded = collect(squares, i, j, patch->camera_px, samples, predicted);
        if (!surface_fit(samples, decoded, &fit) || !is_smooth(&fit, decoded, predicted)) {
            patches->rough++;
            continue;
        }
        for (int k = 0; k < 2; k++) {
            patch->projector_px[k] = fit.middle[k];
            patch->sd_px[k] = fit.sd[k];
        }
        patches->count++;
    }
}

bool patches_find(const struct code_map *map, int wanted, struct patches *patches, char *message)
{
    struct squares squares;
    struct surface_sample *samples;

    *patches = (struct patches){0};
    if (map->counts[CODE_DECODED] == 0)
        return true;
    squares = squares_begin(map, find_cell(map, wanted));
    samples = malloc((size_t)(2 * HALF_MAX + 1) * (2 * HALF_MAX + 1) * sizeof *samples);
    patches->list = calloc(PATCHES_MAX, sizeof *patches->list);
    if (samples && patches->list) {
        fit_all(&squares, samples, patches);
        free(samples);
        return true;
    }
    snprintf(message, MESSAGE_SIZE, "out of memory for %d marks", wanted);
    free(samples);
    patches_free(patches);
    return false;
}
