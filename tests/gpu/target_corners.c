/* A target's corner may be outside of its framebuffer, but no farther than pixels are counted. */
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "context.h"
#include "guest_fixture.h"

static struct guest_house house;

static int open_house(void **state)
{
    (void)state;
    context_open();
    guest_house_build(&house);
    assert_int_equal(guest_gl_create(&house, NULL, NULL), CUPOLA_OK);
    return cupola_theatre_create(house.dome, &house.theatre, NULL);
}

static int close_house(void **state)
{
    (void)state;
    guest_house_release(&house);
    context_close();
    return 0;
}

static void check_call(int status, int expected, const struct cupola_error *error, const char *word)
{
    assert_int_equal(status, expected);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    if (!strstr(error->message, word))
        fail_msg("'%s' does not say '%s'", error->message, word);
}

/* By every call that has a target; nothing is drawn. */
static void check_corner(int x, int y, int expected, const char *word)
{
    const struct cupola_target near = house.target;
    struct cupola_error error = {CUPOLA_OK, ""};
    float *before = guest_picture(&house), *pixels = calloc(4, sizeof *pixels);
    assert_non_null(pixels);
    house.target.x = x;
    house.target.y = y;
    check_call(guest_warp(&house, -1, &error), expected, &error, word);
    check_call(guest_warp(&house, 0, &error), expected, &error, word);
    check_call(guest_overlays(&house, &error), expected, &error, word);
    check_call(guest_theatre(&house, &error), expected, &error, word);
    check_call(cupola_gl_capture(&house.target, 1, 1, pixels, &error), expected, &error, word);
    house.target = near;
    float *after = guest_picture(&house);
    assert_memory_equal(after, before, 4 * sizeof *after * GUEST_SIZE * GUEST_SIZE);
    free(after);
    free(pixels);
    free(before);
}

static void corners_too_far_for_any_pixel_are_refused(void **state)
{
    static const int most = 1 << 24;
    (void)state;
    check_corner(INT_MAX, 0, CUPOLA_ERROR_ARGUMENT,
                 "(2147483647, 0) px; allowed: -16777216 to 16777216");
    check_corner(0, INT_MAX - 7, CUPOLA_ERROR_ARGUMENT, "corner");
    check_corner(INT_MIN, 0, CUPOLA_ERROR_ARGUMENT, "corner");
    check_corner(0, -most - 1, CUPOLA_ERROR_ARGUMENT, "corner");
    check_corner(most + 1, 0, CUPOLA_ERROR_ARGUMENT, "corner");
}

static void corners_outside_of_the_framebuffer_are_not(void **state)
{
    static const int most = 1 << 24;
    (void)state;
    check_corner(most, -most, CUPOLA_OK, "");
    check_corner(-GUEST_SIZE, 3, CUPOLA_OK, "");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(corners_too_far_for_any_pixel_are_refused),
        cmocka_unit_test(corners_outside_of_the_framebuffer_are_not),
    };
    return cmocka_run_group_tests_name("target_corners", tests, open_house, close_house);
}
