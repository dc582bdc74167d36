/* Text as a picture, by stb_easy_font: every letter is a handful of rectangles. */
#include "cupola/text.h"

#include <stdbool.h>
#include <string.h>

#include "error.h"

#pragma GCC diagnostic ignored "-Wunused-function" /* until the end: static and not all used */
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdouble-promotion"
#pragma GCC diagnostic ignored "-Wmissing-braces"
#include <stb_easy_font.h>
#pragma GCC diagnostic pop

/* Units. Letters are 2 apart: half of that stands before the first and after the last. */
enum {
    LINE_HEIGHT = 12,
    GAP_LEFT = 1,
    GAP_ABOVE = 2,    /* as much as descenders take below capitals, so that capitals are centred */
    PICTURE_LESS = 1, /* the picture's height, less than its lines' */
    SCALE_MAX = 64,
    SIDE_MAX = 16384,
    QUADS_MAX = 64, /* of a letter; most have fewer than 20 */
};

/* A corner of a rectangle, as stb_easy_font writes it. */
struct corner {
    float x, y, z;
    unsigned char color[4];
};

_Static_assert(sizeof(struct corner) == 16, "as stb_easy_font writes it");

/* U+00C0 to U+017F of Unicode without what stands above and below them. */
enum { LATIN_BEGIN = 0xc0, LATIN_END = 0x180 };
static const char latin[LATIN_END - LATIN_BEGIN + 1] =
    "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYPsaaaaaaaceeeeiiiidnooooo/ouuuuypy"
    "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIiIiJjKkkLlLlLlL"
    "lLlNnNnNnnNnOoOoOoOoRrRrRrSsSsSsSsTtTtTtUuUuUuUuUuUuWwYyYZzZzZzs";

/* How many bytes follow the first one of a character in UTF-8. */
static int following(unsigned char first)
{
    if (first < 0xc2 || first > 0xf4)
        return 0;
    return first < 0xe0 ? 1 : (first < 0xf0 ? 2 : 3);
}

/*
 * The number of the next character in Unicode, behind which `text` goes on; -1 and one byte on for
 * what is none, such as a longer form than is needed (RFC 3629).
 */
static int next_character(const char **text)
{
    static const int least[] = {0, 0x80, 0x800, 0x10000};
    const unsigned char *at = (const unsigned char *)(*text)++;
    int more = following(at[0]);
    int number = more > 0 ? at[0] & (0x3f >> more) : (at[0] < 0x80 ? at[0] : -1);

    for (int i = 1; i <= more; i++) {
        if ((at[i] & 0xc0) != 0x80)
            return -1;
        number = number << 6 | (at[i] & 0x3f);
    }
    if (number < least[more] || number > 0x10ffff || (number >= 0xd800 && number <= 0xdfff))
        return -1;
    *text += more;
    return number;
}

/* Accents that Unicode has as characters of their own, behind the letter. */
static void skip_combining(const char **text)
{
    const char *next = *text;

    while (*next) {
        int number = next_character(&next);
        if (number < 0x300 || number > 0x36f)
            break;
        *text = next;
    }
}

/* What the next character is drawn as; `text` goes on behind it. */
static char next_letter(const char **text)
{
    int number = next_character(text);

    skip_combining(text);
    if (number >= LATIN_BEGIN && number < LATIN_END)
        return latin[number - LATIN_BEGIN];
    return (number >= ' ' && number <= '~') || number == '\n' ? (char)number : '?';
}

int cupola_text_letters(const char *text, char *letters, size_t size)
{
    int unknown = 0;
    size_t count = 0;

    while (text && *text) {
        bool asked = *text == '?';
        char letter = next_letter(&text);
        unknown += letter == '?' && !asked;
        if (letters && count + 1 < size)
            letters[count++] = letter;
    }
    if (letters && size > 0)
        letters[count] = 0;
    return unknown;
}

static int advance_of(char letter)
{
    return stb_easy_font_charinfo[letter - ' '].advance & 15;
}

static size_t count_letters(const char *text)
{
    size_t count = 0;

    for (; *text; count++)
        next_letter(&text);
    return count;
}

/* Units; false as soon as one of them is more than `most`. A last '\n' begins no further line. */
static bool measure(const char *text, int most, int *width, int *height)
{
    int across = 0;
    *width = 1;
    *height = LINE_HEIGHT - PICTURE_LESS;
    while (*text) {
        char letter = next_letter(&text);
        if (letter != '\n') {
            across += advance_of(letter);
        } else if (*text) {
            across = 0;
            *height += LINE_HEIGHT;
        }
        if (across > *width)
            *width = across;
        if (*width > most || *height > most)
            return false;
    }
    return true;
}

int cupola_text_size(const char *text, int scale, int *width, int *height,
                     struct cupola_error *error)
{
    int units[2];
    if (!text || !width || !height)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is NULL",
                         !text ? "text" : (!width ? "width" : "height"));
    if (!*text)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "text is empty; allowed: 1 character or "
                         "more");
    if (scale < 1 || scale > SCALE_MAX)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "scale of text is %d; allowed: 1 to %d",
                         scale, (int)SCALE_MAX);
    if (!measure(text, SIDE_MAX / scale, &units[0], &units[1]))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "text of %zu characters is too large for a picture at scale %d; allowed: "
                         "up to %d texels each way",
                         count_letters(text), scale, (int)SIDE_MAX);
    *width = units[0] * scale;
    *height = units[1] * scale;
    return CUPOLA_OK;
}

/* From `x` and `y` to `right` and `bottom`, texels from the upper left corner. */
static void fill(unsigned char *rgba, int width, int height, int x, int y, int right, int bottom)
{
    x = x < 0 ? 0 : x;
    right = right > width ? width : right;
    for (int row = y < 0 ? 0 : y; row < bottom && row < height; row++)
        if (right > x)
            memset(rgba + 4 * ((size_t)(height - 1 - row) * (size_t)width + (size_t)x), 255,
                   4 * (size_t)(right - x));
}

/* `x` and `y` in units, of the letter's upper left corner. */
static void draw_letter(char letter, int x, int y, int scale, unsigned char *rgba, int width,
                        int height)
{
    struct corner corners[4 * QUADS_MAX];
    char text[2] = {letter, 0};
    int quads = stb_easy_font_print(0, 0, text, NULL, corners, sizeof corners);
    for (int i = 0; i < quads; i++) {
        const struct corner *first = &corners[4 * i], *opposite = first + 2;
        fill(rgba, width, height, (x + (int)first->x) * scale, (y + (int)first->y) * scale,
             (x + (int)opposite->x) * scale, (y + (int)opposite->y) * scale);
    }
}

int cupola_text_draw(const char *text, int scale, unsigned char *rgba, int width, int height,
                     struct cupola_error *error)
{
    int size[2], x = GAP_LEFT, y = GAP_ABOVE;
    int status = cupola_text_size(text, scale, &size[0], &size[1], error);
    if (status != CUPOLA_OK)
        return status;
    if (!rgba)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "rgba is NULL");
    if (width != size[0] || height != size[1])
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "picture of the text is %d x %d texels; allowed: %d x %d, as "
                         "cupola_text_size says",
                         width, height, size[0], size[1]);
    memset(rgba, 0, 4 * (size_t)width * (size_t)height);
    while (*text) {
        char letter = next_letter(&text);
        if (letter == '\n') {
            x = GAP_LEFT;
            y += LINE_HEIGHT;
            continue;
        }
        draw_letter(letter, x, y, scale, rgba, width, height);
        x += advance_of(letter);
    }
    return CUPOLA_OK;
}
