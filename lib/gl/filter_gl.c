/* What shaders know of the filter. */
#include "filter_gl.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cupola/source.h"
#include "error.h"
#include "geometry/filter.h"

/* Of so many rays each has its own code; more of them would take compilers too long. */
enum { UNROLLED_MAX = 8, CHOSEN_MAX = 6 };

/* Of adaptive, patterns of one and of two places are not listed: the shader knows the former, and
 * PAIR_PLACE is of the latter. */
enum { LISTED_MIN = 3 };

/* "RAY(-1.12345678e-01, -1.12345678e-01, 1.12345678e-01) " and room for whatever frames it. */
enum { PLACE_LENGTH = 96, FRAME_LENGTH = 96 };

int filter_guard_px(const struct cupola_filter *filter)
{
    return filter->method == CUPOLA_ANTIALIASING_TEXTURE && filter->samples == 9 ? 2 : 1;
}

int filter_params_complete(struct cupola_gl_params *params, int guard_px,
                           struct cupola_error *error)
{
    bool views = !params->sources || params->sources & 1u << CUPOLA_SOURCE_VIEWS;
    int status = filter_check(&params->filter, &params->filter, error);
    if (status != CUPOLA_OK)
        return status;
    if (views && guard_px < filter_guard_px(&params->filter))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "samples of texture are 9 and the plan's guard band is %d; allowed: %d or "
                         "more",
                         guard_px, filter_guard_px(&params->filter));
    if (params->dither_bits != 0 && params->dither_bits != 8)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "dither_bits is %d; allowed: 8, or 0 for none", params->dither_bits);
    return CUPOLA_OK;
}

bool filter_sends_rays(const struct cupola_filter *filter)
{
    return filter->method == CUPOLA_ANTIALIASING_CONE ||
           filter->method == CUPOLA_ANTIALIASING_ADAPTIVE ||
           filter->method == CUPOLA_ANTIALIASING_FOOTPRINT;
}

double filter_reach_px(const struct cupola_filter *filter)
{
    return filter_sends_rays(filter) ? 2 : 0;
}

static bool has_patterns(const struct cupola_filter *filter)
{
    return filter->method == CUPOLA_ANTIALIASING_CONE ||
           filter->method == CUPOLA_ANTIALIASING_ADAPTIVE;
}

static bool is_unrolled(const struct cupola_filter *filter)
{
    return filter->method == CUPOLA_ANTIALIASING_CONE && filter->samples <= UNROLLED_MAX;
}

/* Of a few patterns a place is chosen by comparing. */
static bool is_chosen(const struct cupola_filter *filter)
{
    return filter->method == CUPOLA_ANTIALIASING_ADAPTIVE && filter->samples <= CHOSEN_MAX;
}

static int texels_of_ray(const struct cupola_filter *filter)
{
    if (filter->method == CUPOLA_ANTIALIASING_NONE)
        return 1;
    return filter->method == CUPOLA_ANTIALIASING_TEXTURE ? filter->samples : 4;
}

void filter_lines(const struct cupola_gl_params *params, char lines[FILTER_LINES_MAX])
{
    const struct cupola_filter *filter = &params->filter;
    snprintf(lines, FILTER_LINES_MAX,
             "#define FILTER_CONE %d\n#define FILTER_ADAPTIVE %d\n#define FILTER_FOOTPRINT %d\n"
             "#define FILTER %d\n#define FILTER_SEED %" PRIu32 "u\n#define RAYS %d\n"
             "#define TEXELS %d\n#define SAMPLES %d\n#define FOOTPRINT_RAYS %d\n"
             "#define METRIC %d\n#define TURNED %d\n#define UNROLLED %d\n"
             "#define FOOTPRINT_BLUR (%d.0 / 1000.0)\n#define FOOTPRINT_MORE (%d.0 / 1000.0)\n",
             CUPOLA_ANTIALIASING_CONE, CUPOLA_ANTIALIASING_ADAPTIVE, CUPOLA_ANTIALIASING_FOOTPRINT,
             (int)filter->method, filter->seed, filter_sends_rays(filter), texels_of_ray(filter),
             filter->samples,
             filter->samples < FOOTPRINT_RAYS_MAX ? filter->samples : FOOTPRINT_RAYS_MAX,
             filter->method == CUPOLA_ANTIALIASING_CONE, filter->turned && has_patterns(filter),
             is_unrolled(filter), (int)(1000 * FOOTPRINT_BLUR + 0.5),
             (int)(1000 * FOOTPRINT_MORE + 0.5));
}

/* A text that has room for all that is added. */
struct text {
    char *at;
    size_t length;
};

static void add(struct text *text, const char *words)
{
    size_t length = strlen(words);
    memcpy(text->at + text->length, words, length + 1);
    text->length += length;
}

/* With a point, whatever the host's locale has. */
static void add_numbers(struct text *text, const double *numbers, int count)
{
    for (int i = 0; i < count; i++) {
        char digits[32];
        snprintf(digits, sizeof digits, "%.8e", numbers[i]);
        digits[digits[0] == '-' ? 2 : 1] = '.';
        add(text, i ? ", " : "(");
        add(text, digits);
    }
    add(text, ")");
}

static void add_place(struct text *text, const char *before, const struct pattern_place *place,
                      const char *after)
{
    const double numbers[3] = {place->x, place->y, place->weight};
    add(text, before);
    add_numbers(text, numbers, 3);
    add(text, after);
}

/* What most pixels of adaptive have. */
static void add_pair(struct text *text, const struct cupola_filter *filter)
{
    struct pattern pattern;
    filter_pattern(filter, 2, &pattern);
    const double numbers[2] = {pattern.places[0].x, pattern.places[0].y};
    add(text, "#define PAIR_PLACE vec2");
    add_numbers(text, numbers, 2);
    add(text, "\n");
}

/* A macro that does something with each place. */
static void add_macro(struct text *text, const struct cupola_filter *filter)
{
    struct pattern pattern;
    filter_pattern(filter, filter->samples, &pattern);
    add(text, "#define EACH_PLACE(RAY)");
    for (int i = 0; i < filter->samples; i++)
        add_place(text, " RAY", &pattern.places[i], "");
    add(text, "\n");
}

/*
 * A function that has the patterns one after the other, by comparing: what is indexed by a number
 * that varies is read from memory.
 */
static void add_choice(struct text *text, const struct cupola_filter *filter)
{
    char words[FRAME_LENGTH];
    int index = 0;
    add(text, "vec3 pattern_place(int i)\n{\n    vec3 place = vec3(0.0);\n");
    for (int count = LISTED_MIN; count <= filter->samples; count++) {
        struct pattern pattern;
        filter_pattern(filter, count, &pattern);
        for (int i = 0; i < count; i++) {
            snprintf(words, sizeof words, "    place = i == %d ? vec3", index++);
            add_place(text, words, &pattern.places[i], " : place;\n");
        }
    }
    add(text, "    return place;\n}\n");
}

/* The patterns one after the other. */
static void add_array(struct text *text, const struct cupola_filter *filter, int first, int last)
{
    char words[FRAME_LENGTH];
    int places = (last + first) * (last - first + 1) / 2;
    snprintf(words, sizeof words, "const vec3 pattern_places[%d] = vec3[%d](\n", places, places);
    add(text, words);
    for (int count = first; count <= last; count++) {
        struct pattern pattern;
        filter_pattern(filter, count, &pattern);
        for (int i = 0; i < count; i++)
            add_place(text, "vec3", &pattern.places[i],
                      count == last && i == count - 1 ? ");\n" : ",\n");
    }
    add(text, "vec3 pattern_place(int i)\n{\n    return pattern_places[i];\n}\n");
}

char *filter_places_text(const struct cupola_filter *filter)
{
    int last = has_patterns(filter) ? filter->samples : 0;
    bool adaptive = filter->method == CUPOLA_ANTIALIASING_ADAPTIVE;
    int first = adaptive ? LISTED_MIN : last;
    size_t room = 6 * FRAME_LENGTH;
    for (int count = first; count <= last; count++)
        room += (size_t)count * PLACE_LENGTH;
    struct text text = {malloc(room), 0};
    if (!text.at)
        return NULL;
    text.at[0] = 0;
    if (adaptive)
        add_pair(&text, filter);
    if (is_unrolled(filter))
        add_macro(&text, filter);
    else if (is_chosen(filter))
        add_choice(&text, filter);
    else if (last > 0)
        add_array(&text, filter, first, last);
    return text.at;
}
