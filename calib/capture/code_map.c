/* From photographs of a series to places in the projector's image. */
#include "capture/code_map.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "angles.h"
#include "capture/code_noise.h"
#include "option_values.h"
#include "order.h"
#include "short_path.h"

/* From here on a number counts as cut off: 250 of 255 by sRGB's curve. */
static const double saturated_light = 0.957;

/* A bit below this part of the contrast may be either; one such is a stripe's border. */
static const double faint_bit = 0.15;
static const double weak_sine = 0.25;
/* Code and phase differ by half a stripe at most; blur at borders adds some. */
static const double most_off = 0.8, surely_off = 0.6;

/* While photographs are read. */
struct reading {
    const struct code_settings *settings;
    struct code_map *map;
    struct photo white, black, previous;
    uint32_t *code;       /* of the axis at work, Gray */
    unsigned char *faint; /* how many of its bits */
    double *sums[4];      /* of its sines: light, its square, times cosine, times sine */
    float *amplitude[2];
    bool cuts_off; /* the files hold no more than 1 */
    struct code_noise noise;
};

static bool is_lit(const struct code_map *map, size_t i)
{
    return map->state[i] == CODE_DECODED || map->state[i] == CODE_UNSURE;
}

const char *code_state_text(enum code_state state)
{
    static const char *const texts[] = {"decoded",     "saturated", "too little contrast",
                                        "code unsure", "too noisy", "no numbers"};

    return texts[state];
}

void code_map_free(struct code_map *map)
{
    for (int axis = 0; axis < 2; axis++) {
        free(map->place_px[axis]);
        free(map->sd_px[axis]);
    }
    free(map->state);
    *map = (struct code_map){0};
}

static void free_reading(struct reading *reading)
{
    photo_free(&reading->white);
    photo_free(&reading->black);
    photo_free(&reading->previous);
    free(reading->code);
    free(reading->faint);
    for (int i = 0; i < 4; i++)
        free(reading->sums[i]);
    free(reading->amplitude[0]);
    free(reading->amplitude[1]);
}

static size_t pixel_count(const struct code_map *map)
{
    return (size_t)map->width * (size_t)map->height;
}

static bool allocate(struct reading *reading, char *message)
{
    struct code_map *map = reading->map;
    size_t count;
    bool done;

    map->width = reading->white.width;
    map->height = reading->white.height;
    count = pixel_count(map);
    reading->code = calloc(count, sizeof *reading->code);
    reading->faint = calloc(count, 1);
    map->state = calloc(count, 1);
    done = reading->code && reading->faint && map->state;
    for (int i = 0; i < 4; i++)
        done = (reading->sums[i] = calloc(count, sizeof **reading->sums)) && done;
    for (int axis = 0; axis < 2; axis++) {
        reading->amplitude[axis] = calloc(count, sizeof **reading->amplitude);
        map->place_px[axis] = calloc(count, sizeof **map->place_px);
        map->sd_px[axis] = calloc(count, sizeof **map->sd_px);
        done = done && reading->amplitude[axis] && map->place_px[axis] && map->sd_px[axis];
    }
    if (!done)
        snprintf(message, MESSAGE_SIZE, "out of memory for photographs of %dx%d pixels", map->width,
                 map->height);
    return done;
}

/* With all light and none known: what can be decoded at all. */
static bool begin(struct reading *reading, char *message)
{
    struct code_map *map = reading->map;

    if (!allocate(reading, message))
        return false;
    map->check.least_contrast = reading->settings->least_contrast;
    reading->cuts_off = photo_cuts_off(reading->settings->paths[0]);
    for (size_t i = 0; i < pixel_count(map); i++) {
        double white = (double)reading->white.light[i], black = (double)reading->black.light[i];
        if (!isfinite(white - black)) {
            map->state[i] = CODE_NO_NUMBER;
            continue;
        }
        if (white - black < reading->settings->least_contrast)
            map->state[i] = CODE_DARK;
        if (white >= saturated_light && reading->cuts_off)
            map->state[i] = CODE_SATURATED;
        code_check_add_light(&map->check, white - black, map->state[i] == CODE_DECODED);
    }
    return true;
}

static void clear_axis(struct reading *reading)
{
    size_t count = pixel_count(reading->map);

    memset(reading->code, 0, count * sizeof *reading->code);
    memset(reading->faint, 0, count);
    code_check_begin_axis(&reading->map->check);
    for (int i = 0; i < 4; i++)
        memset(reading->sums[i], 0, count * sizeof **reading->sums);
}

static bool add_bit(struct reading *reading, const struct photo *inverse, int number, char *message)
{
    struct code_check *check = &reading->map->check;

    code_check_begin_pair(check);
    for (size_t i = 0; i < pixel_count(reading->map); i++) {
        double contrast = (double)reading->white.light[i] - (double)reading->black.light[i];
        double bit = (double)reading->previous.light[i] - (double)inverse->light[i];
        double both = (double)reading->previous.light[i] + (double)inverse->light[i];
        double expected = (double)reading->white.light[i] + (double)reading->black.light[i];
        reading->code[i] = reading->code[i] << 1 | (bit > 0);
        if (!(fabs(bit) >= faint_bit * contrast) && reading->faint[i] < 255)
            reading->faint[i]++;
        if (!is_lit(reading->map, i) || !isfinite(both))
            continue;
        check->contrast += contrast;
        check->mismatch += fabs(both - expected);
    }
    return code_check_pair(check, reading->settings->paths[number - 1],
                           reading->settings->paths[number], message);
}

static void add_step(struct reading *reading, const struct photo *photo, int step)
{
    double angle = 2 * pi * step / reading->settings->series->steps;
    double cosine = cos(angle), sine = sin(angle);

    for (size_t i = 0; i < pixel_count(reading->map); i++) {
        double light = (double)photo->light[i];
        reading->sums[0][i] += light;
        reading->sums[1][i] += light * light;
        reading->sums[2][i] += light * cosine;
        reading->sums[3][i] += light * sine;
    }
}

/* `clear`: its bits and its sine are. */
static void add_to_check(struct code_check *check, double contrast, double variance, bool clear,
                         double off)
{
    check->contrast_square += contrast * contrast;
    check->variance += variance;
    check->judged += 1;
    check->tested += clear;
    check->off += clear && off > surely_off;
}

/* Whether the bits of a pixel and its sine are to be trusted. */
static bool is_clear(const struct reading *reading, size_t i)
{
    double contrast = (double)reading->white.light[i] - (double)reading->black.light[i];
    double amplitude =
        2 * hypot(reading->sums[2][i], reading->sums[3][i]) / reading->settings->series->steps;

    return reading->faint[i] <= 1 && amplitude >= weak_sine * 0.5 * contrast;
}

static struct code_pixel code_pixel(const struct reading *reading, size_t i)
{
    return (struct code_pixel){series_from_gray(reading->code[i]), reading->sums[2][i],
                               reading->sums[3][i]};
}

static void add_border(const struct reading *reading, struct code_borders *borders, size_t i,
                       size_t other)
{
    struct code_pixel pixel = code_pixel(reading, i), neighbour = code_pixel(reading, other);

    if (reading->map->state[i] == CODE_DECODED && reading->map->state[other] == CODE_DECODED &&
        is_clear(reading, i) && is_clear(reading, other))
        code_borders_add(borders, &pixel, &neighbour);
}

static bool find_phase(struct reading *reading, int axis, char *message)
{
    const struct series *series = reading->settings->series;
    size_t width = (size_t)reading->map->width, count = pixel_count(reading->map);
    struct code_borders borders;

    if (!code_borders_begin(&borders, series_bits(series, axis))) {
        snprintf(message, MESSAGE_SIZE, "out of memory for the borders of stripes");
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        if (i % width + 1 < width)
            add_border(reading, &borders, i, i + 1);
        if (i + width < count)
            add_border(reading, &borders, i, i + width);
    }
    reading->map->check.phase = code_borders_end(&borders);
    return true;
}

/* One that has had a place so far. */
static void finish_pixel(struct reading *reading, int axis, size_t i)
{
    const struct series *series = reading->settings->series;
    struct code_map *map = reading->map;
    int steps = series->steps;
    double mean = reading->sums[0][i] / steps;
    double amplitude = 2 * hypot(reading->sums[2][i], reading->sums[3][i]) / steps;
    double contrast = (double)reading->white.light[i] - (double)reading->black.light[i];
    bool clear = is_clear(reading, i);
    double squares =
        reading->sums[1][i] - steps * mean * mean - 0.5 * steps * amplitude * amplitude;
    double off, place = series_place(series, series_from_gray(reading->code[i]),
                                     atan2(reading->sums[3][i], reading->sums[2][i]), &off);

    add_to_check(&map->check, contrast, squares / (steps - 3), clear, off);
    if (!clear || !(off <= most_off) || place < -1 || place > series->size_px[axis] + 1) {
        map->state[i] = CODE_UNSURE;
        return;
    }
    code_noise_add(&reading->noise, mean, squares / (steps - 3));
    map->place_px[axis][i] = (float)place;
    reading->amplitude[axis][i] = (float)amplitude;
}

/* What a file holds no number for is not seen, and tells nothing of the others. */
static void leave_out(struct code_map *map, const struct photo *photo)
{
    for (size_t i = 0; i < pixel_count(map); i++) {
        if (map->state[i] == CODE_DECODED && !isfinite(photo->light[i]))
            map->state[i] = CODE_NO_NUMBER;
    }
}

static bool add(struct reading *reading, int number, const struct photo *photo, char *message)
{
    const struct series *series = reading->settings->series;
    struct series_picture picture = series_picture(series, number);

    if (picture.kind == SERIES_BLACK)
        return begin(reading, message);
    leave_out(reading->map, photo);
    if (picture.kind == SERIES_CODE && picture.index == 0)
        clear_axis(reading);
    if (picture.kind == SERIES_INVERSE)
        return add_bit(reading, photo, number, message);
    if (picture.kind == SERIES_SINE)
        add_step(reading, photo, picture.index);
    if (picture.kind == SERIES_SINE && picture.index == series->steps - 1) {
        if (!find_phase(reading, picture.axis, message))
            return false;
        for (size_t i = 0; i < pixel_count(reading->map); i++) {
            if (reading->map->state[i] == CODE_DECODED)
                finish_pixel(reading, picture.axis, i);
        }
        return code_check_axis(&reading->map->check, picture.axis, series->steps, message);
    }
    return true;
}

static bool read_one(struct reading *reading, int number, char *message)
{
    const char *path = reading->settings->paths[number];
    struct photo photo;
    struct photo *kept = number == 0   ? &reading->white
                         : number == 1 ? &reading->black
                                       : &reading->previous;
    bool done;

    if (!photo_read(path, reading->settings->encoding, &photo, message))
        return false;
    if (number > 0 &&
        (photo.width != reading->white.width || photo.height != reading->white.height)) {
        snprintf(message, MESSAGE_SIZE, "%s is %d x %d px; allowed: %d x %d as the first one",
                 short_path(path).text, photo.width, photo.height, reading->white.width,
                 reading->white.height);
        photo_free(&photo);
        return false;
    }
    if (number < 2)
        *kept = photo;
    done = number == 0 || add(reading, number, &photo, message);
    if (number >= 2) {
        photo_free(kept);
        *kept = photo;
    }
    return done;
}

/* With ambient light it is more than half of the contrast. */
static float mid_grey(const struct reading *reading, size_t i)
{
    return 0.5f * (reading->white.light[i] + reading->black.light[i]);
}

static void predict(struct reading *reading)
{
    const struct series *series = reading->settings->series;
    struct code_map *map = reading->map;
    double factor = series->period_px / (2 * pi) * sqrt(2.0 / series->steps);

    code_noise_fit(&reading->noise);
    for (size_t i = 0; i < pixel_count(map); i++) {
        double light = (double)mid_grey(reading, i);
        if (map->state[i] != CODE_DECODED)
            continue;
        for (int axis = 0; axis < 2; axis++)
            map->sd_px[axis][i] = (float)(factor * code_noise_at(&reading->noise, light) /
                                          (double)reading->amplitude[axis][i]);
        if ((double)fmaxf(map->sd_px[0][i], map->sd_px[1][i]) > series->period_px / 8.0)
            map->state[i] = CODE_NOISY;
    }
}

static float median(float *numbers, int count)
{
    order_sort_floats(numbers, count);
    return numbers[count / 2];
}

static void count_states(struct reading *reading)
{
    struct code_map *map = reading->map;
    /* No longer needed for what they were. */
    float *contrasts = reading->amplitude[0], *greys = reading->amplitude[1];
    int decoded = 0;

    for (size_t i = 0; i < pixel_count(map); i++) {
        map->counts[map->state[i]]++;
        if (map->state[i] != CODE_DECODED)
            continue;
        contrasts[decoded] = reading->white.light[i] - reading->black.light[i];
        greys[decoded++] = mid_grey(reading, i);
    }
    if (decoded == 0)
        return;
    map->contrast = (double)median(contrasts, decoded);
    map->noise = code_noise_at(&reading->noise, (double)median(greys, decoded));
}

bool code_map_read(const struct code_settings *settings, struct code_map *map, char *message)
{
    struct reading reading = {.settings = settings, .map = map};
    int count = series_count(settings->series);
    bool done = true;

    *map = (struct code_map){0};
    for (int i = 0; done && i < count; i++)
        done = read_one(&reading, i, message);
    if (done) {
        predict(&reading);
        count_states(&reading);
    } else {
        code_map_free(map);
    }
    free_reading(&reading);
    return done;
}
