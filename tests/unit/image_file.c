/* Image files: PNG as any reader sees it, PFM bit for bit, broken PFM explained. */
#define _XOPEN_SOURCE 700 /* folder.h */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include "check.h"
#include "cupola/image_file.h"
#include "folder.h"

#pragma GCC diagnostic ignored "-Wunused-function" /* until the end: static and not all used */
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdouble-promotion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wundef"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb_image.h>
#pragma GCC diagnostic pop

static float *random_image(int width, int height, uint64_t seed)
{
    size_t count = 4 * (size_t)width * (size_t)height;
    float *rgba = malloc(count * sizeof *rgba);
    assert_non_null(rgba);
    for (size_t i = 0; i < count; i++)
        rgba[i] = (float)random_between(&seed, -0.2, 1.2);
    return rgba;
}

static int expected_byte(float value)
{
    double clamped = fmin(fmax((double)value, 0), 1);
    return (int)floor(255 * clamped + 0.5);
}

static void check_png(int width, int height)
{
    struct cupola_error error = {0};
    float *rgba = random_image(width, height, (uint64_t)(1000 * width + height));
    if (cupola_png_write(in_folder("x.png"), rgba, width, height, &error) != CUPOLA_OK)
        fail_msg("%s", error.message);
    int read_width, read_height, channels;
    unsigned char *bytes = stbi_load(in_folder("x.png"), &read_width, &read_height, &channels, 0);
    assert_non_null(bytes);
    assert_int_equal(read_width, width);
    assert_int_equal(read_height, height);
    assert_int_equal(channels, 3);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            for (int c = 0; c < 3; c++)
                assert_int_equal(bytes[3 * ((height - 1 - y) * width + x) + c],
                                 expected_byte(rgba[4 * (y * width + x) + c]));
    stbi_image_free(bytes);
    free(rgba);
}

static void a_png_has_the_top_row_first(void **state)
{
    (void)state;
    check_png(1, 1);
    check_png(7, 5);
    check_png(5, 7);
    check_png(317, 241);
    check_png(1, 500);
    check_png(500, 1);
}

static void a_png_clamps_and_rounds(void **state)
{
    (void)state;
    const float rgba[] = {-1.0f,    0.0f, 1.0f,         0, 2.0f,         NAN,  -INFINITY, 0,
                          INFINITY, 0.5f, 0.49f / 255,  0, 0.51f / 255,  -NAN, 1e30f,     0,
                          1e-40f,   -0.f, 254.6f / 255, 0, 254.4f / 255, 1.0f, 0.25f,     0};
    static const unsigned char expected[] = {0, 0, 255, 255, 0, 0,   255, 128, 0,
                                             1, 0, 255, 0,   0, 255, 254, 255, 64};
    int width, height, channels;
    assert_int_equal(cupola_png_write(in_folder("c.png"), rgba, 6, 1, NULL), CUPOLA_OK);
    unsigned char *bytes = stbi_load(in_folder("c.png"), &width, &height, &channels, 0);
    assert_non_null(bytes);
    assert_memory_equal(bytes, expected, sizeof expected);
    stbi_image_free(bytes);
}

/* Compressed at its best, at its worst and between: each must fit into what is set aside for it. */
static void a_png_of_any_content_is_written(void **state)
{
    (void)state;
    for (int content = 0; content < 3; content++)
        for (int trial = 0; trial < 8; trial++) {
            uint64_t seed = (uint64_t)(100 * content + trial);
            int width = 16 << (int)random_between(&seed, 0, 7);
            int height = (1 << 18) / width / (trial + 1) + 1;
            struct cupola_error error = {0};
            float *rgba = random_image(width, height, seed);
            for (int i = 0; i < 4 * width * height; i++)
                rgba[i] = content == 0 ? 0.5f : content == 1 ? rgba[i] : roundf(rgba[i]);
            if (cupola_png_write(in_folder("any.png"), rgba, width, height, &error) != CUPOLA_OK)
                fail_msg("%d x %d: %s", width, height, error.message);
            free(rgba);
        }
}

/* Sanitizers themselves need more than any limit. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
enum { SANITIZED = 1 };
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
enum { SANITIZED = 1 };
#else
enum { SANITIZED = 0 };
#endif
#else
enum { SANITIZED = 0 };
#endif

static rlim_t address_space(void)
{
    unsigned long pages = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    if (!file || fscanf(file, "%lu", &pages) != 1)
        pages = 0;
    if (file)
        fclose(file);
    return (rlim_t)pages * (rlim_t)sysconf(_SC_PAGESIZE);
}

/* In a child that gets so much memory and no more. */
static int status_with_memory(const float *rgba, int side, rlim_t bytes)
{
    int outcome = 0;
    fflush(stdout);
    pid_t child = fork();
    assert_int_not_equal(child, -1);
    if (child == 0) {
        const struct rlimit limit = {address_space() + bytes, address_space() + bytes};
        if (setrlimit(RLIMIT_AS, &limit) != 0)
            _exit(1);
        _exit(-cupola_png_write(in_folder("little.png"), rgba, side, side, NULL));
    }
    assert_int_equal(waitpid(child, &outcome, 0), child);
    if (!WIFEXITED(outcome))
        fail_msg("with %lu KiB the process was ended", (unsigned long)bytes / 1024);
    return -WEXITSTATUS(outcome);
}

static void too_little_memory_for_a_png_is_an_error(void **state)
{
    enum { SIDE = 800, STEP = 1 << 20, STEPS_MAX = 64 };
    int written = 0, refused = 0;
    (void)state;
    if (SANITIZED || address_space() == 0)
        skip();
    float *rgba = random_image(SIDE, SIDE, 3);
    for (rlim_t bytes = 0; bytes < STEPS_MAX * STEP && written < 2; bytes += STEP) {
        int entries = entries_in_folder();
        int status = status_with_memory(rgba, SIDE, bytes);
        written += status == CUPOLA_OK;
        refused += status == CUPOLA_ERROR_MEMORY;
        assert_true(status == CUPOLA_OK || status == CUPOLA_ERROR_MEMORY);
        assert_int_equal(entries_in_folder(), entries + (status == CUPOLA_OK && written == 1));
    }
    assert_int_equal(written, 2);
    check_at_least(refused, 4);
    free(rgba);
}

static void the_same_picture_gives_the_same_png(void **state)
{
    (void)state;
    float *rgba = random_image(64, 48, 7);
    assert_int_equal(cupola_png_write(in_folder("1.png"), rgba, 64, 48, NULL), CUPOLA_OK);
    assert_int_equal(cupola_png_write(in_folder("2.png"), rgba, 64, 48, NULL), CUPOLA_OK);
    char *first = content_of(in_folder("1.png")), *second = content_of(in_folder("2.png"));
    assert_memory_equal(first, second, 1 << 16);
    free(first);
    free(second);
    free(rgba);
}

static void a_pfm_comes_back_bit_for_bit(void **state)
{
    (void)state;
    static const int sizes[][2] = {{1, 1}, {7, 5}, {5, 7}, {317, 241}};
    for (int i = 0; i < 4; i++) {
        int width = sizes[i][0], height = sizes[i][1], read_width = 0, read_height = 0;
        size_t pixels = (size_t)width * (size_t)height;
        float *rgba = random_image(width, height, (uint64_t)i), *read;
        rgba[0] = -0.0f;
        rgba[1] = 1e-45f;
        rgba[2] = -INFINITY;
        struct cupola_error error = {0};
        if (cupola_pfm_write(in_folder("x.pfm"), rgba, width, height, &error) != CUPOLA_OK ||
            cupola_pfm_read(in_folder("x.pfm"), &read, &read_width, &read_height, &error) !=
                CUPOLA_OK)
            fail_msg("%s", error.message);
        assert_int_equal(read_width, width);
        assert_int_equal(read_height, height);
        for (size_t p = 0; p < pixels; p++) {
            assert_memory_equal(read + 4 * p, rgba + 4 * p, 3 * sizeof *rgba);
            check_near(read[4 * p + 3], 1, 0);
        }
        cupola_image_free(&read);
        assert_null(read);
        free(rgba);
    }
}

static void put_bytes(const char *header, const void *data, size_t size)
{
    FILE *file = fopen(in_folder("in.pfm"), "wb");
    assert_non_null(file);
    fwrite(header, 1, strlen(header), file);
    fwrite(data, 1, size, file);
    assert_int_equal(fclose(file), 0);
}

static void both_byte_orders_and_grey_are_read(void **state)
{
    (void)state;
    static const unsigned char big[] = {0x3f, 0x80, 0, 0, 0xc0, 0x20, 0, 0};
    static const unsigned char little[] = {0, 0, 0x80, 0x3f, 0, 0, 0x20, 0xc0};
    static const float expected[] = {1, 1, 1, 1, -2.5f, -2.5f, -2.5f, 1};
    static const char *const headers[] = {"Pf 2 1 1.0\n", "Pf\n2\t1\r\n-7.5e-1\n"};
    for (int i = 0; i < 2; i++) {
        float *rgba;
        int width, height;
        put_bytes(headers[i], i ? little : big, sizeof big);
        assert_int_equal(cupola_pfm_read(in_folder("in.pfm"), &rgba, &width, &height, NULL),
                         CUPOLA_OK);
        assert_int_equal(width, 2);
        assert_int_equal(height, 1);
        assert_memory_equal(rgba, expected, sizeof expected);
        cupola_image_free(&rgba);
    }
}

static void a_broken_pfm_is_explained(void **state)
{
    (void)state;
    static const struct {
        const char *header;
        size_t size;
        const char *message;
    } broken[] = {
        {"", 0, "does not begin with PF or Pf, so it is no PFM file"},
        {"P", 0, "does not begin with PF or Pf"},
        {"P6 1 1 255\n", 12, "does not begin with PF or Pf"},
        {"PF4 1 1 -1\n", 12, "white space is missing after PF"},
        {"PF", 0, "white space is missing after PF"},
        {"PF\n", 0, "width in the PFM header is ''; allowed: 1 to 32768"},
        {"PF\n0 1\n-1.0\n", 12, "width in the PFM header is '0'"},
        {"PF\n-1 1\n-1.0\n", 12, "width in the PFM header is '-1'"},
        {"PF\n32769 1\n-1.0\n", 12, "width in the PFM header is '32769'"},
        {"PF\n99999999999999999999 1\n-1.0\n", 12, "width in the PFM header is '9999"},
        {"PF\n1.0 1\n-1.0\n", 12, "width in the PFM header is '1.0'"},
        {"PF\n1 x\n-1.0\n", 12, "height in the PFM header is 'x'"},
        {"PF\n1 1\n", 0, "scale in the PFM header is ''"},
        {"PF\n1 1\n0\n", 12, "scale in the PFM header is '0'; allowed: a finite number"},
        {"PF\n1 1\n-inf\n", 12, "scale in the PFM header is '-inf'"},
        {"PF\n1 1\nnan\n", 12, "scale in the PFM header is 'nan'"},
        {"PF\n1 1\n1,0\n", 12, "scale in the PFM header is '1,0'"},
        {"PF\n1 1\n-1.0", 0, "white space is missing after the scale"},
        {"PF\n1 1\n-1.0\n", 0,
         "0 bytes of pixels follow the header; allowed for 1 x 1 px of 3 "
         "channels: 12"},
        {"PF\n1 1\n-1.0\n", 11, "11 bytes of pixels follow"},
        {"PF\n1 1\n-1.0\n", 13, "13 bytes of pixels follow"},
        {"Pf\n2 2\n-1.0\n", 12, "allowed for 2 x 2 px of 1 channel: 16"},
        {"PF\n32768 32768\n-1.0\n", 12, "3 channels: 12884901888"},
    };
    for (size_t i = 0; i < sizeof broken / sizeof broken[0]; i++) {
        float *rgba = NULL;
        int width = -7, height = -7;
        struct cupola_error error = {0};
        put_bytes(broken[i].header, "0123456789abcdef", broken[i].size);
        assert_int_equal(cupola_pfm_read(in_folder("in.pfm"), &rgba, &width, &height, &error),
                         CUPOLA_ERROR_SYNTAX);
        if (!strstr(error.message, "in.pfm: ") || !strstr(error.message, broken[i].message))
            fail_msg("'%s' does not say '%s'", error.message, broken[i].message);
        assert_null(rgba);
        assert_int_equal(width, -7);
        assert_int_equal(height, -7);
    }
}

static void check_write(int (*write)(const char *, const float *, int, int, struct cupola_error *))
{
    const float rgba[4] = {0};
    struct cupola_error error = {0};
    int entries = entries_in_folder();
    assert_int_equal(write(NULL, rgba, 1, 1, NULL), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(write("", rgba, 1, 1, NULL), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(write(in_folder("w"), NULL, 1, 1, NULL), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(write(in_folder("w"), rgba, 0, 1, &error), CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "image is 0 x 1 px; allowed: 1 to 32768 each"));
    assert_int_equal(write(in_folder("w"), rgba, 1, 32769, NULL), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(write(in_folder("w"), rgba, -1, 1, NULL), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(write(in_folder("no/w"), rgba, 1, 1, &error), CUPOLA_ERROR_FILE);
    assert_non_null(strstr(error.message, "no/w: cannot be written: No such file"));
    assert_int_equal(write("/dev/full", rgba, 1, 1, &error), CUPOLA_ERROR_FILE);
    assert_int_equal(entries_in_folder(), entries);
    assert_int_equal(write(in_folder("w"), rgba, 1, 1, NULL), CUPOLA_OK);
    assert_int_equal(write(in_folder("w"), rgba, 1, 1, NULL), CUPOLA_OK);
    assert_int_equal(entries_in_folder(), entries + 1);
    assert_int_equal(remove(in_folder("w")), 0);
}

static void what_cannot_be_written_leaves_nothing(void **state)
{
    (void)state;
    check_write(cupola_png_write);
    check_write(cupola_pfm_write);
}

static void what_is_no_file_is_not_read(void **state)
{
    (void)state;
    float *rgba;
    int width, height;
    assert_int_equal(cupola_pfm_read(NULL, &rgba, &width, &height, NULL), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_pfm_read("x", NULL, &width, &height, NULL), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_pfm_read(folder, &rgba, &width, &height, NULL), CUPOLA_ERROR_FILE);
    assert_int_equal(cupola_pfm_read("/dev/zero", &rgba, &width, &height, NULL), CUPOLA_ERROR_FILE);
    assert_int_equal(cupola_pfm_read(in_folder("none"), &rgba, &width, &height, NULL),
                     CUPOLA_ERROR_FILE);
    cupola_image_free(NULL);
}

int main(void)
{
    const struct CMUnitTest image_file[] = {
        /* The first: what was freed before would serve again. */
        cmocka_unit_test(too_little_memory_for_a_png_is_an_error),
        cmocka_unit_test(a_png_has_the_top_row_first),
        cmocka_unit_test(a_png_clamps_and_rounds),
        cmocka_unit_test(a_png_of_any_content_is_written),
        cmocka_unit_test(the_same_picture_gives_the_same_png),
        cmocka_unit_test(a_pfm_comes_back_bit_for_bit),
        cmocka_unit_test(both_byte_orders_and_grey_are_read),
        cmocka_unit_test(a_broken_pfm_is_explained),
        cmocka_unit_test(what_cannot_be_written_leaves_nothing),
        cmocka_unit_test(what_is_no_file_is_not_read),
    };
    return cmocka_run_group_tests(image_file, make_folder, remove_folder);
}
