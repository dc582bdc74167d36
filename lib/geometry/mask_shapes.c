/*
 * Trapezoids over the texels that are not needed: runs of rows that lie over each other, between
 * straight sides. What they leave free of a needed texel is its middle, or all of it where it has
 * several samples or a host's texture has other texels.
 */
#include <math.h>
#include <stdlib.h>

#include "mask.h"

enum { RUNS_MAX = 64, SHAPE_VERTICES = 6 };

/* Sides keep this far from what they leave free: rasterisers round corners to 1/16 at worst. */
static const float apart = 0.0625f;
/* And they lie no farther from it than this where they run straight up. */
static const float loose = 1.0f;
static const float start_apart = 0.75f; /* of a side, from its first run's end */
static const float least_area = 3;      /* of a shape that is worth its triangles, texels */

/*
 * One side of a shape. It leaves `start`, at the first row's lower edge, or at its middle where
 * middles alone are left free, with a slope of a range.
 */
struct side {
    bool middles;
    float sense;    /* 1: the left side, -1: the right one; both look inwards */
    int end;        /* of the run in the last row */
    int border;     /* of the view, */
    bool on_border; /* along which it runs straight up */
    float start, least, most;
};

struct shape {
    int from; /* first row */
    struct side left, right;
};

struct run {
    int left, right;
};

struct shaping {
    struct mask *mask;
    const struct mask_texels *texels;
    int open_count, next_count;
    struct shape open[RUNS_MAX]; /* that may go on in this row, from left to right */
    struct shape next[RUNS_MAX]; /* that may go on in the next one */
};

static struct side side_begin(bool middles, int end, int border, float sense, float center)
{
    float to_center = fabsf(center - (float)end);
    struct side side = {.middles = middles,
                        .sense = sense,
                        .end = end,
                        .border = border,
                        .on_border = end == border,
                        .start = (float)end,
                        .least = -HUGE_VALF,
                        .most = HUGE_VALF};
    if (!side.on_border && !middles)
        side.start += sense * fminf(start_apart, to_center);
    return side;
}

/*
 * Narrows the slopes so that `height` rows above its start the side is beside a place. False, and
 * nothing changes, if none is left.
 */
static bool side_narrow(struct side *side, float height, float place)
{
    float slope = fabsf(place - side->start) / height;
    float near = (place + side->sense * apart - side->start) / height;
    float far = (place + side->sense * loose * (1 + fminf(slope, 4)) - side->start) / height;
    float least = fmaxf(side->least, fminf(near, far)), most = fminf(side->most, fmaxf(near, far));
    if (!(least <= most))
        return false;
    side->least = least;
    side->most = most;
    return true;
}

static bool side_continue(struct side *side, float height, int end)
{
    bool on_border = end == side->border;
    float below = (float)side->end, above = (float)end;
    if (side->on_border || on_border)
        return side->on_border && on_border;
    side->end = end;
    if (side->middles)
        return side_narrow(side, height, above - 0.5f * side->sense);
    return side_narrow(side, height, side->sense * below > side->sense * above ? below : above);
}

/* Where the side is at the lower edge of the first row and, `height` above it, that of the last. */
static void side_finish(struct side *side, float height, float ends[2])
{
    float slope = 0;
    if (!side->on_border && !side->middles && !side_narrow(side, height, (float)side->end)) {
        /* It is looser than wished in some rows. */
        float near = ((float)side->end + side->sense * apart - side->start) / height;
        slope = side->sense > 0 ? fmaxf(near, side->least) : fminf(near, side->most);
    } else if (!side->on_border && side->least > -HUGE_VALF) {
        slope = 0.5f * (side->least + side->most);
    }
    float before = side->middles && !side->on_border ? 0.5f : 0;
    ends[0] = side->start - before * slope;
    ends[1] = side->start + (height - before) * slope;
}

static bool grow(struct mask *mask)
{
    int most = 2 * mask->vertex_most + 1200;
    void *more =
        mask->growing ? realloc(mask->vertices, (size_t)most * sizeof *mask->vertices) : NULL;
    mask->failed |= mask->growing && !more;
    if (!more)
        return false;
    mask->vertices = more;
    mask->vertex_most = most;
    return true;
}

static void add_corner(const struct shaping *shaping, float x, float y)
{
    struct mask *mask = shaping->mask;
    const struct mask_texels *texels = shaping->texels;
    mask->vertices[mask->vertex_count++] =
        (struct mask_vertex){(float)texels->x + x, (float)texels->y + y};
}

/* The shape as it is before a row; where its sides cross it ends. */
static void shape_end(struct shaping *shaping, struct shape *shape, int row)
{
    struct mask *mask = shaping->mask;
    float bottom = (float)shape->from, top = (float)row, left[2], right[2], width[2];
    side_finish(&shape->left, top - bottom, left);
    side_finish(&shape->right, top - bottom, right);
    for (int i = 0; i < 2; i++)
        width[i] = right[i] - left[i];
    for (int i = 0; i < 2; i++) {
        float part = width[i] / (width[i] - width[1 - i]); /* from this end to where they cross */
        if (!(width[i] < 0))
            continue;
        left[i] = right[i] = left[i] + part * (left[1 - i] - left[i]);
        width[i] = 0;
        if (i)
            top += part * (bottom - top);
        else
            bottom += part * (top - bottom);
    }
    if (!(0.5f * (top - bottom) * (width[0] + width[1]) > least_area))
        return;
    if (mask->vertex_count + SHAPE_VERTICES > mask->vertex_most && !grow(mask))
        return;
    add_corner(shaping, left[0], bottom);
    add_corner(shaping, right[0], bottom);
    add_corner(shaping, right[1], top);
    add_corner(shaping, left[0], bottom);
    add_corner(shaping, right[1], top);
    add_corner(shaping, left[1], top);
}

static struct shape shape_begin(const struct shaping *shaping, struct run run, int row)
{
    float center = 0.5f * (float)(run.left + run.right);
    bool middles = shaping->mask->middles;
    struct shape shape = {.from = row,
                          .left = side_begin(middles, run.left, 0, 1, center),
                          .right =
                              side_begin(middles, run.right, shaping->texels->width, -1, center)};
    return shape;
}

static bool shape_continue(struct shape *shape, struct run run, int row)
{
    float height = (float)(row - shape->from);
    return side_continue(&shape->left, height, run.left) &&
           side_continue(&shape->right, height, run.right);
}

/* Each run of a row continues the shape that it lies over, or begins one. */
static void add_row(struct shaping *shaping, const struct run *runs, int run_count, int row)
{
    int open = 0;
    shaping->next_count = 0;
    for (int i = 0; i < run_count; i++) {
        struct shape next = shape_begin(shaping, runs[i], row);
        while (open < shaping->open_count && shaping->open[open].right.end <= runs[i].left)
            shape_end(shaping, &shaping->open[open++], row);
        if (open < shaping->open_count && shaping->open[open].left.end < runs[i].right) {
            struct shape longer = shaping->open[open];
            if (shape_continue(&longer, runs[i], row))
                next = longer;
            else
                shape_end(shaping, &shaping->open[open], row);
            open++;
        }
        shaping->next[shaping->next_count++] = next;
    }
    while (open < shaping->open_count)
        shape_end(shaping, &shaping->open[open++], row);
    shaping->open_count = shaping->next_count;
    for (int i = 0; i < shaping->next_count; i++)
        shaping->open[i] = shaping->next[i];
}

/* The first texel from x on that is needed, or that is not; the width if there is none. */
static int find(const struct mask_texels *texels, const uint64_t *row, int x, bool needed)
{
    while (x < texels->width) {
        uint64_t word = (needed ? row[x / 64] : ~row[x / 64]) >> (x % 64);
        if (word) {
            x += __builtin_ctzll(word);
            return x < texels->width ? x : texels->width;
        }
        x = (x / 64 + 1) * 64;
    }
    return texels->width;
}

/* Takes away what lies beyond the lines. */
static void trim_row(const struct mask_texels *texels, uint64_t *row, int y)
{
    double least = 0.5, most = texels->width - 0.5;
    for (int i = 0; i < texels->line_count; i++) {
        const double *line = texels->lines[i];
        double rest = line[1] * (y + 0.5) + line[2];
        if (line[0] > 0)
            least = fmax(least, -rest / line[0]);
        else if (line[0] < 0)
            most = fmin(most, -rest / line[0]);
        else if (rest < 0)
            most = -1;
    }
    int first = (int)ceil(fmin(least, texels->width + 1.0) - 0.5);
    int last = (int)floor(fmax(most, -1) - 0.5);
    for (int w = 0; w < texels->words; w++) {
        int from = first - 64 * w, to = last - 64 * w; /* bits that may stay */
        if (from >= 64 || to < 0)
            row[w] = 0;
        else {
            row[w] &= from > 0 ? ~(uint64_t)0 << from : ~(uint64_t)0;
            row[w] &= to < 63 ? ~(uint64_t)0 >> (63 - to) : ~(uint64_t)0;
        }
    }
}

void mask_shapes_add(struct mask *mask, int view)
{
    struct mask_texels *texels = &mask->texels[view];
    struct shaping shaping = {.mask = mask, .texels = texels};
    mask->first[view] = mask->vertex_count;
    for (int y = 0; y < texels->height; y++) {
        uint64_t *row = texels->bits + (size_t)y * (size_t)texels->words;
        struct run runs[RUNS_MAX];
        int count = 0;
        trim_row(texels, row, y);
        for (int x = find(texels, row, 0, false); x < texels->width && count < RUNS_MAX;) {
            runs[count].left = x;
            runs[count++].right = x = find(texels, row, x, true);
            x = find(texels, row, x, false);
        }
        add_row(&shaping, runs, count, y);
    }
    add_row(&shaping, NULL, 0, texels->height);
    mask->count[view] = mask->vertex_count - mask->first[view];
}
