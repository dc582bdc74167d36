/* Text as a picture: known letters, sizes, and every byte that there is. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "cupola/text.h"
#include "message.h"

static unsigned char *drawn(const char *text, int scale, int *width, int *height)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    if (cupola_text_size(text, scale, width, height, &error) < 0)
        fail_msg("%s", error.message);
    unsigned char *rgba = malloc(4 * (size_t)*width * (size_t)*height);
    assert_non_null(rgba);
    if (cupola_text_draw(text, scale, rgba, *width, *height, &error) < 0)
        fail_msg("%s", error.message);
    return rgba;
}

/* As many rows as wished from the top, a character for each texel. */
static void check_rows(const char *text, const char *const *rows, int count)
{
    int width, height;
    unsigned char *rgba = drawn(text, 1, &width, &height);
    for (int row = 0; row < count; row++) {
        char shown[64] = "";
        for (int i = 0; i < width && i < 63; i++)
            shown[i] = rgba[4 * ((height - 1 - row) * width + i)] ? '#' : '.';
        if (strcmp(shown, rows[row]) != 0)
            fail_msg("row %d of '%s' is '%s', not '%s'", row, text, shown, rows[row]);
    }
    free(rgba);
}

static void letters_are_upright_and_not_mirrored(void **state)
{
    (void)state;
    static const char *const rows[] = {
        "............", "............", ".####..#....", ".#.....#....",
        ".#.....#....", ".###...#....", ".#.....#....", ".#.....#....",
        ".#.....####.", "............", "............",
    };
    check_rows("FL", rows, 11);
}

/* The least and the greatest place of what is lit, along x and y. */
static void find_ink(const char *text, int scale, int ink[4], int *width, int *height)
{
    unsigned char *rgba = drawn(text, scale, width, height);
    ink[0] = ink[1] = 1 << 20;
    ink[2] = ink[3] = -1;
    for (int i = 0; i < *width * *height; i++) {
        if (!rgba[4 * i])
            continue;
        int at[2] = {i % *width, i / *width};
        for (int k = 0; k < 2; k++) {
            ink[k] = at[k] < ink[k] ? at[k] : ink[k];
            ink[2 + k] = at[k] > ink[2 + k] ? at[k] : ink[2 + k];
        }
    }
    free(rgba);
}

static void capitals_are_in_the_middle(void **state)
{
    (void)state;
    static const char *const texts[] = {"H", "W", "I", "North", "HH\nHI", "H\nM\nH"};
    int ink[4], width, height;
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++)
        for (int scale = 1; scale <= 5; scale += 2) {
            find_ink(texts[i], scale, ink, &width, &height);
            assert_int_equal(ink[0], width - 1 - ink[2]);
            assert_int_equal(ink[1], height - 1 - ink[3]);
            assert_int_equal(ink[1], 2 * scale); /* the baseline */
        }
    find_ink("j", 3, ink, &width, &height);
    assert_int_equal(ink[1], 0); /* and what is below it; so the middle can be missed */
    assert_true(ink[1] != height - 1 - ink[3]);
}

static void a_character_of_many_bytes_is_one_question_mark(void **state)
{
    (void)state;
    static const char *const pairs[][2] = {
        {"\xce\xb1", "?"},                          /* alpha */
        {"N\xe2\x82\xacS", "N?S"},                  /* the euro */
        {"\xf0\x9f\x8c\x8d\xf0\x9f\x8c\x8d", "??"}, /* two globes */
        {"\xc3"
         "A",
         "?A"}, /* cut short */
        {"\xe2\x82", "??"},
        {"a\xe0\x81\x81z", "a???z"},  /* an A in three bytes */
        {"a\xe0\x80\x8a", "a???"},    /* the end of a line */
        {"\xf0\x80\x81\x81", "????"}, /* an A in four */
        {"\xed\xa0\x80", "???"},      /* half of a pair of UTF-16 */
        {"\xf4\x90\x80\x80", "????"}, /* beyond Unicode */
        {"\xf4\x8f\xbf\xbf", "?"},    /* its last one */
        {"\x80\xbf", "??"},           /* no beginning */
        {"\xce\xb1\xb1", "??"},
        {"\xff\x80", "??"},
    };
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        int size[2][2];
        unsigned char *rgba[2];
        for (int k = 0; k < 2; k++)
            rgba[k] = drawn(pairs[i][k], 2, &size[k][0], &size[k][1]);
        assert_memory_equal(size[0], size[1], sizeof size[0]);
        assert_memory_equal(rgba[0], rgba[1], 4 * (size_t)size[0][0] * (size_t)size[0][1]);
        free(rgba[0]);
        free(rgba[1]);
    }
}

static void latin_letters_lose_their_accents(void **state)
{
    (void)state;
    static const struct {
        const char *text, *letters;
        int unknown;
    } cases[] = {
        {"\xc3\x80\xc3\xbf\xc4\x80\xc5\xbf", "AyAs", 0}, /* the table's ends */
        {"se\xc3\xb1"
         "al \xc3\xa9l\xc3\xa8ve",
         "senal eleve", 0},
        {"\xc5\x81\xc3\xb3"
         "d\xc5\xba \xc4\xb0zm",
         "Lodz Izm", 0},
        {"Stra\xc3\x9f"
         "e \xc5\x98\xc3\xad"
         "p",
         "Strase Rip", 0},
        {"e\xcc\x81t\xcc\xa3\xcc\x88?", "et?", 0}, /* combining ones, two on one letter */
        {"\xcc\x81"
         "e",
         "?e", 1},                             /* on none */
        {"\xe5\x8f\xb3 1\nb", "? 1\nb", 1},    /* right, in Japanese */
        {"\xc6\x80\xc2\xbf\x7f\t", "????", 4}, /* what stands beside the table */
        {"", "", 0},
        {NULL, "", 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char letters[32];
        assert_int_equal(cupola_text_letters(cases[i].text, letters, sizeof letters),
                         cases[i].unknown);
        assert_string_equal(letters, cases[i].letters);
    }
    char cut[4] = "xyz";
    assert_int_equal(cupola_text_letters("\xc3\x80"
                                         "bcd\xe2\x82\xac",
                                         cut, 3),
                     1);
    assert_memory_equal(cut, "Ab\0", 4);
    assert_int_equal(cupola_text_letters("a", cut, 0), 0);
    assert_int_equal(cupola_text_letters("\xe2\x82\xac", NULL, 3), 1);
    assert_memory_equal(cut, "Ab\0", 4);
}

static void texels_are_white_or_clear(void **state)
{
    (void)state;
    int width, height, lit = 0;
    unsigned char *rgba = drawn("North\nEast", 3, &width, &height);
    assert_int_equal(height, (2 * 12 - 1) * 3);
    for (int i = 0; i < width * height; i++) {
        for (int c = 1; c < 4; c++)
            assert_int_equal(rgba[4 * i + c], rgba[4 * i]);
        assert_true(rgba[4 * i] == 0 || rgba[4 * i] == 255);
        lit += rgba[4 * i] == 255;
    }
    check_at_least(lit, 200);
    free(rgba);
}

static void every_scale_is_the_same_picture(void **state)
{
    (void)state;
    static const char text[] = "The quick\nbrown fox 0123!";
    int width, height, large_width, large_height;
    unsigned char *small = drawn(text, 1, &width, &height);
    for (int scale = 2; scale <= 64; scale *= 2) {
        unsigned char *large = drawn(text, scale, &large_width, &large_height);
        assert_int_equal(large_width, scale * width);
        assert_int_equal(large_height, scale * height);
        for (int j = 0; j < large_height; j++)
            for (int i = 0; i < large_width; i++)
                assert_int_equal(large[4 * (j * large_width + i)],
                                 small[4 * (j / scale * width + i / scale)]);
        free(large);
    }
    free(small);
}

static void lines_are_ended_and_not_begun(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        int lines;
    } cases[] = {{"A", 1}, {"A\n", 1}, {"A\nB", 2}, {"A\n\nB", 3}, {"\n", 1}, {"\n\n", 2}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        int width, height;
        free(drawn(cases[i].text, 1, &width, &height));
        assert_int_equal(height, 12 * cases[i].lines - 1);
        check_at_least(width, 1);
    }
}

/* What is no printable ASCII is drawn as a question mark; nothing is written beside the picture. */
static void every_byte_is_drawn(void **state)
{
    (void)state;
    int wish_width, wish_height, width, height;
    unsigned char *wish = drawn("?", 2, &wish_width, &wish_height);
    for (int byte = 1; byte < 256; byte++) {
        char text[2] = {(char)byte, 0};
        unsigned char *rgba = drawn(text, 2, &width, &height);
        int blank = 1;
        for (int i = 0; i < 4 * width * height; i++)
            blank &= rgba[i] == 0;
        assert_int_equal(blank, byte == ' ' || byte == '\n');
        if (byte != '\n' && (byte < 32 || byte > 126)) {
            assert_int_equal(width, wish_width);
            assert_memory_equal(rgba, wish, 4 * (size_t)width * (size_t)height);
        }
        free(rgba);
    }
    free(wish);
}

static void random_bytes_stay_in_their_picture(void **state)
{
    (void)state;
    enum { TEXTS = 300, LENGTH_MAX = 90, GUARD = 64 };
    uint64_t seed = 8301;
    for (int n = 0; n < TEXTS; n++) {
        char text[LENGTH_MAX + 1];
        int width, height, length = (int)random_between(&seed, 1, LENGTH_MAX);
        int scale = (int)random_between(&seed, 1, 5);
        for (int i = 0; i < length; i++)
            text[i] = (char)random_between(&seed, 1, 256);
        text[length] = 0;
        assert_int_equal(cupola_text_size(text, scale, &width, &height, NULL), CUPOLA_OK);
        size_t size = 4 * (size_t)width * (size_t)height;
        unsigned char *rgba = malloc(size + GUARD);
        assert_non_null(rgba);
        memset(rgba, 0x5a, size + GUARD);
        assert_int_equal(cupola_text_draw(text, scale, rgba, width, height, NULL), CUPOLA_OK);
        for (size_t i = 0; i < size + GUARD; i++)
            assert_true(i < size ? rgba[i] == 0 || rgba[i] == 255 : rgba[i] == 0x5a);
        free(rgba);
    }
}

static void check_refused(const char *text, int scale, const char *word)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    int width = -7, height = -8;
    assert_int_equal(cupola_text_size(text, scale, &width, &height, &error), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(width, -7);
    assert_int_equal(height, -8);
    if (!strstr(error.message, word))
        fail_msg("'%s' does not say '%s'", error.message, word);
}

static void what_cannot_be_drawn_is_refused(void **state)
{
    (void)state;
    struct cupola_error error = {CUPOLA_OK, ""};
    unsigned char rgba[4] = {9, 9, 9, 9};
    int side;
    char *longest = calloc(1, 100000);
    assert_non_null(longest);
    memset(longest, 'x', 99999);
    check_refused(NULL, 1, "text is NULL");
    check_refused("", 1, "text is empty");
    check_refused("a", 0, "is 0; allowed: 1 to 64");
    check_refused("a", 65, "is 65; allowed: 1 to 64");
    check_refused(longest, 1, "99999 characters");
    longest[300] = 0;
    check_refused(longest, 64, "300 characters");
    memset(longest, '\n', 2000);
    check_refused(longest, 1, "too large");
    free(longest);
    assert_int_equal(cupola_text_size("a", 1, NULL, &side, &error), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_text_size("a", 1, &side, NULL, &error), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_text_draw("a", 1, NULL, 6, 11, &error), CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "rgba is NULL"));
    assert_int_equal(cupola_text_draw("a", 1, rgba, 1, 1, &error), CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "1 x 1 texels; allowed: 6 x 11"));
    assert_int_equal(rgba[0], 9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(letters_are_upright_and_not_mirrored),
        cmocka_unit_test(capitals_are_in_the_middle),
        cmocka_unit_test(latin_letters_lose_their_accents),
        cmocka_unit_test(a_character_of_many_bytes_is_one_question_mark),
        cmocka_unit_test(texels_are_white_or_clear),
        cmocka_unit_test(every_scale_is_the_same_picture),
        cmocka_unit_test(lines_are_ended_and_not_begun),
        cmocka_unit_test(every_byte_is_drawn),
        cmocka_unit_test(random_bytes_stay_in_their_picture),
        cmocka_unit_test(what_cannot_be_drawn_is_refused),
    };
    return cmocka_run_group_tests_name("text", tests, NULL, NULL);
}
