/* Programs are made and draw the same whatever the host's locale: GLSL knows no decimal comma. */
#define _XOPEN_SOURCE 700 /* comma_locale.h */
#include "comma_locale.h"
#include "context.h"
#include "guest_fixture.h"

static struct guest_house house;

static int open_house(void **state)
{
    context_open();
    guest_house_build_for(&house, 2);
    return make_folder(state);
}

static int close_house(void **state)
{
    guest_house_release(&house);
    context_close();
    return remove_folder(state);
}

static void check_ok(int status, const struct cupola_error *error, const char *what, int number)
{
    if (status < 0)
        fail_msg("%s %d: %s", what, number, error->message);
}

/* All programs of one gl, without gain and with it, and its tables. */
static void make_with(const struct cupola_gl_params *params, const char *what, int number)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    unsigned int points = 0;
    check_ok(guest_gl_create(&house, params, &error), &error, what, number);
    check_ok(cupola_gl_set_gain(house.gl, 0, house.gain, &error), &error, what, number);
    check_ok(cupola_gl_points(house.gl, 0, &points, &error), &error, what, number);
}

/* Every kind of program there is. */
static void make_all(void)
{
    const unsigned int views = 1u << CUPOLA_SOURCE_VIEWS;
    struct cupola_error error = {CUPOLA_OK, ""};
    for (int i = 0; i < 5; i++) {
        make_with(&(struct cupola_gl_params){.table = (enum cupola_table)i, .sources = views},
                  "table", i);
        cupola_gl_destroy(&house.gl);
    }
    for (int i = CUPOLA_STORAGE_TEXTURES; i <= CUPOLA_STORAGE_LAYERS; i++) {
        make_with(&(struct cupola_gl_params){.storage = (enum cupola_storage)i, .sources = views},
                  "storage", i);
        cupola_gl_destroy(&house.gl);
    }
    check_ok(cupola_theatre_create(house.dome, &house.theatre, &error), &error, "theatre", 0);
    check_ok(guest_theatre_encoded(&house, CUPOLA_ENCODING_SRGB, &error), &error, "theatre", 0);
    cupola_theatre_destroy(&house.theatre);
}

/* Of views and overlays on top; all sources are there. */
static float *frame_picture(void)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    make_with(&(struct cupola_gl_params){.encoding = CUPOLA_ENCODING_SRGB}, "encoding", 1);
    check_ok(guest_views(&house, &error), &error, "views", 0);
    check_ok(guest_warp(&house, -1, &error), &error, "warp", 0);
    check_ok(guest_overlays(&house, &error), &error, "overlays", 0);
    cupola_gl_destroy(&house.gl);
    return guest_picture(&house);
}

static void a_decimal_comma_changes_nothing(void **state)
{
    char sample[16];
    (void)state;
    float *expected = frame_picture();
    locale_t locale = comma_locale();
    if (!locale) {
        free(expected);
        skip();
    }
    locale_t before = uselocale(locale);
    snprintf(sample, sizeof sample, "%.1f", 0.5);
    make_all();
    float *shown = frame_picture();
    assert_ptr_equal(uselocale(before), locale);
    freelocale(locale);
    assert_string_equal(sample, "0,5"); /* the control */
    assert_memory_equal(shown, expected, 4 * sizeof *shown * GUEST_SIZE * GUEST_SIZE);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    free(shown);
    free(expected);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_decimal_comma_changes_nothing),
    };
    return cmocka_run_group_tests_name("locale", tests, open_house, close_house);
}
