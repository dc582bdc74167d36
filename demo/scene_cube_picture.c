/*
 * The pictures on the six faces of the cube room. What each has: a pattern of its own, a grid of
 * half a unit, a circle that must look round, one diagonal that shows a mirrored picture, a border,
 * its name, its axis and the names of its neighbours.
 */
#include "scene_cube_picture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <stb/stb_easy_font.h>

enum { SIZE = CUBE_PICTURE_SIZE_PX };

static const float half_root = 0.70710678f; /* sqrt(1/2) */

#define CREAM                                                                                      \
    {                                                                                              \
        253, 246, 227                                                                              \
    }
#define NAVY                                                                                       \
    {                                                                                              \
        24, 43, 73                                                                                 \
    }

const struct cube_face cube_faces[CUBE_FACES] = {
    {"FRONT",
     "-Z",
     {"^ UP", "v DOWN", "< LEFT", "RIGHT >"},
     {0, 0, -1},
     {1, 0, 0},
     {0, 1, 0},
     {47, 102, 144},
     {58, 118, 163},
     {22, 66, 91},
     CREAM},
    {"BACK",
     "+Z",
     {"^ UP", "v DOWN", "< RIGHT", "LEFT >"},
     {0, 0, 1},
     {-1, 0, 0},
     {0, 1, 0},
     {193, 84, 62},
     {174, 70, 51},
     {122, 43, 32},
     CREAM},
    {"LEFT",
     "-X",
     {"^ UP", "v DOWN", "< BACK", "FRONT >"},
     {-1, 0, 0},
     {0, 0, -1},
     {0, 1, 0},
     {233, 185, 94},
     {242, 201, 122},
     {250, 234, 194},
     NAVY},
    {"RIGHT",
     "+X",
     {"^ UP", "v DOWN", "< FRONT", "BACK >"},
     {1, 0, 0},
     {0, 0, 1},
     {0, 1, 0},
     {92, 138, 90},
     {109, 156, 104},
     {45, 84, 52},
     CREAM},
    {"UP",
     "+Y",
     {"^ BACK", "v FRONT", "< LEFT", "RIGHT >"},
     {0, 1, 0},
     {1, 0, 0},
     {0, 0, 1},
     {186, 216, 235},
     {203, 227, 241},
     {236, 246, 250},
     NAVY},
    {"DOWN",
     "-Y",
     {"^ FRONT", "v BACK", "< LEFT", "RIGHT >"},
     {0, -1, 0},
     {1, 0, 0},
     {0, 0, -1},
     {99, 84, 110},
     {113, 98, 124},
     {54, 43, 66},
     CREAM},
};

/* How much of a pixel lies inside of an edge at this signed distance (outside is positive), px. */
static float covered(float distance_px)
{
    return distance_px >= 0.5f ? 0 : distance_px <= -0.5f ? 1 : 0.5f - distance_px;
}

static void blend(unsigned char *pixel, const unsigned char color[3], float amount)
{
    if (amount <= 0) /* most pixels */
        return;
    if (amount >= 1) { /* most others */
        memcpy(pixel, color, 3);
        return;
    }
    for (int k = 0; k < 3; k++)
        pixel[k] =
            (unsigned char)lrintf((float)pixel[k] + amount * ((float)color[k] - (float)pixel[k]));
}

/* A box with round corners; origin bottom left. */
static void paint_box(unsigned char *rgba, float left, float bottom, float width, float height,
                      float corner_px, const unsigned char color[3], float amount)
{
    int first_x = (int)fmaxf(left - 1, 0), last_x = (int)fminf(left + width + 1, SIZE - 1);
    int first_y = (int)fmaxf(bottom - 1, 0), last_y = (int)fminf(bottom + height + 1, SIZE - 1);
    float half_width = width / 2, half_height = height / 2;
    for (int j = first_y; j <= last_y; j++)
        for (int i = first_x; i <= last_x; i++) {
            float x = fabsf((float)i + 0.5f - left - half_width) - half_width + corner_px;
            float y = fabsf((float)j + 0.5f - bottom - half_height) - half_height + corner_px;
            float distance = (x > 0 && y > 0 ? hypotf(x, y) : x > y ? x : y) - corner_px;
            blend(rgba + 4 * (j * SIZE + i), color, amount * covered(distance));
        }
}

/* The outline of a circle round the middle. */
static void paint_ring(unsigned char *rgba, float radius_px, float width_px,
                       const unsigned char color[3], float amount)
{
    for (int j = 0; j < SIZE; j++)
        for (int i = 0; i < SIZE; i++) {
            float x = (float)i + 0.5f - SIZE / 2, y = (float)j + 0.5f - SIZE / 2;
            if (fabsf(x) > radius_px + width_px || fabsf(y) > radius_px + width_px)
                continue;
            float distance = fabsf(sqrtf(x * x + y * y) - radius_px) - width_px / 2;
            blend(rgba + 4 * (j * SIZE + i), color, amount * covered(distance));
        }
}

/* From the lower left to the upper right corner. */
static void paint_diagonal(unsigned char *rgba, float width_px, const unsigned char color[3],
                           float amount)
{
    int reach = (int)width_px + 2;
    for (int j = 0; j < SIZE; j++)
        for (int i = j - reach; i <= j + reach; i++) {
            if (i < 0 || i >= SIZE)
                continue;
            float distance = fabsf((float)(i - j)) * half_root - width_px / 2;
            blend(rgba + 4 * (j * SIZE + i), color, amount * covered(distance));
        }
}

static float text_width(const char *text, float scale)
{
    char copy[32] = "";
    strncpy(copy, text, sizeof copy - 1);
    return ((float)stb_easy_font_width(copy) - 1) * scale; /* Each letter ends with a gap. */
}

/* One line of capitals, 7 scale px high; x_px and y_px are its lower left corner. */
static void paint_text(unsigned char *rgba, const char *text, float x_px, float y_px, float scale,
                       const unsigned char color[3])
{
    struct {
        float x, y, z;
        unsigned char color[4];
    } corners[4 * 256];
    char copy[32] = "";
    strncpy(copy, text, sizeof copy - 1);
    int boxes = stb_easy_font_print(0, 0, copy, NULL, corners, sizeof corners);
    float bold = 0.12f * scale; /* so that strokes that touch at their corners join */
    for (int b = 0; b < boxes; b++) {
        float left = corners[4 * b].x, right = corners[4 * b + 2].x;
        float top = corners[4 * b].y, bottom = corners[4 * b + 2].y; /* downwards; base line: 7 */
        paint_box(rgba, x_px + left * scale - bold, y_px + (7 - bottom) * scale - bold,
                  (right - left) * scale + 2 * bold, (bottom - top) * scale + 2 * bold,
                  0.3f * scale, color, 1);
    }
}

static float triangle_wave(float x, float period)
{
    float phase = x / period - floorf(x / period);
    return (phase < 0.5f ? phase : 1 - phase) * period;
}

/* How far a place lies inside of the lighter part of a face's pattern, px. */
static float pattern(int face, float x, float y)
{
    float u = x - SIZE / 2, v = y - SIZE / 2;
    switch (face) {
    case 0: { /* checker */
        float a = triangle_wave(x, 128) - 32, b = triangle_wave(y, 128) - 32;
        return fminf(fabsf(a), fabsf(b)) * (a * b > 0 ? 1.0f : -1.0f);
    }
    case 1: { /* bricks: their joints */
        float row = floorf(y / 64);
        float across = triangle_wave(x + (fmodf(row, 2) > 0 ? 64 : 0), 128);
        return 3 - fminf(across, triangle_wave(y, 64));
    }
    case 2: /* stripes */
        return (triangle_wave(x - y, 128) - 32) * half_root;
    case 3: { /* dots */
        float a = 32 - triangle_wave(x, 64), b = 32 - triangle_wave(y, 64);
        return 18 - sqrtf(a * a + b * b);
    }
    case 4: /* rings */
        return triangle_wave(sqrtf(u * u + v * v), 128) - 32;
    default: { /* planks: every other one is lighter, and their ends are dark */
        float plank = floorf(x / 128), end = triangle_wave(y + 171 * plank, 512) - 3;
        float inside = triangle_wave(x, 256) - 64;
        return fminf(inside, end);
    }
    }
}

static void paint_ground(const struct cube_face *face, int index, unsigned char *rgba)
{
    for (int j = 0; j < SIZE; j++)
        for (int i = 0; i < SIZE; i++) {
            unsigned char *pixel = rgba + 4 * (j * SIZE + i);
            memcpy(pixel, face->ground, 3);
            pixel[3] = 255;
            blend(pixel, face->shade, covered(-pattern(index, (float)i + 0.5f, (float)j + 0.5f)));
        }
}

/* Lines every half unit, an eighth of the face; those through the middle are stronger. */
static void paint_grid(unsigned char *rgba, const unsigned char ink[3])
{
    for (int line = 1; line < 8; line++) {
        float width = line == 4 ? 6.0f : 3.0f, amount = line == 4 ? 0.6f : 0.4f;
        float at = (float)line * SIZE / 8 - width / 2;
        paint_box(rgba, at, 0, width, SIZE, 0, ink, amount);
        paint_box(rgba, 0, at, SIZE, width, 0, ink, amount);
    }
}

static void paint_neighbours(unsigned char *rgba, const struct cube_face *face)
{
    static const float gap = 36;
    const float middle = SIZE / 2.0f;
    for (int side = 0; side < 4; side++) {
        float scale = side < 2 ? 6 : 4; /* Left and right of the plate is little room. */
        float half_height = 3.5f * scale;
        float half = text_width(face->beyond[side], scale) / 2;
        float x = middle, y = middle;
        if (side == 0)
            y = SIZE - gap - half_height;
        else if (side == 1)
            y = gap + half_height;
        else if (side == 2)
            x = gap + half;
        else
            x = SIZE - gap - half;
        paint_box(rgba, x - half - 14, y - half_height - 12, 2 * half + 28, 2 * half_height + 24,
                  14, face->plate, 0.9f);
        paint_text(rgba, face->beyond[side], x - half, y - half_height, scale, face->ink);
    }
}

void cube_picture_paint(int index, unsigned char *rgba)
{
    const struct cube_face *face = &cube_faces[index];
    const float middle = SIZE / 2.0f, border = 18;
    paint_ground(face, index, rgba);
    paint_grid(rgba, face->ink);
    paint_diagonal(rgba, 8, face->ink, 0.7f);
    paint_ring(rgba, 0.375f * SIZE, 10, face->ink, 0.9f);

    paint_box(rgba, 0, 0, SIZE, border, 0, face->plate, 1);
    paint_box(rgba, 0, SIZE - border, SIZE, border, 0, face->plate, 1);
    paint_box(rgba, 0, 0, border, SIZE, 0, face->plate, 1);
    paint_box(rgba, SIZE - border, 0, border, SIZE, 0, face->plate, 1);

    paint_box(rgba, middle - 290, middle - 150, 580, 300, 36, face->plate, 0.93f);
    paint_text(rgba, face->name, middle - text_width(face->name, 18) / 2, middle - 8, 18,
               face->ink);
    paint_text(rgba, face->axis, middle - text_width(face->axis, 10) / 2, middle - 112, 10,
               face->ink);
    paint_neighbours(rgba, face);
}
