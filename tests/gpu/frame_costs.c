/*
 * What a frame costs besides drawing: no memory, no GL object, no shader; and, where the host's
 * state is left, no question to the GL.
 *
 * The linker puts the functions below in the place of those that the library's objects call
 * (--wrap, see meson.build): what the GL allocates for itself is not seen.
 */
#include <stdio.h>
#include <stdlib.h>

#include "check.h"
#include "context.h"
#include "guest_fixture.h"
#include "interposed.h"

enum { FRAMES = 50 };

static int allocations;

#define WRAP(name, parameters, arguments)                                                          \
    void *__real_##name parameters;                                                                \
    void *__wrap_##name parameters;                                                                \
    void *__wrap_##name parameters                                                                 \
    {                                                                                              \
        allocations++;                                                                             \
        return __real_##name arguments;                                                            \
    }

WRAP(malloc, (size_t size), (size))
WRAP(calloc, (size_t count, size_t size), (count, size))
WRAP(realloc, (void *block, size_t size), (block, size))

static int open_context(void **state)
{
    (void)state;
    context_open();
    return 0;
}

static int close_context(void **state)
{
    (void)state;
    context_close();
    return 0;
}

static void check_frame(struct guest_house *house)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    if (guest_frame(house, &error) < 0)
        fail_msg("%s", error.message);
}

static void build(struct guest_house *house, bool moving)
{
    if (moving)
        guest_house_build_moving(house);
    else
        guest_house_build(house);
}

static void check_costs(const struct cupola_gl_params *params, bool moving, const char *name)
{
    struct guest_house house;
    struct cupola_error error = {CUPOLA_OK, ""};
    unsigned int points = 0;
    build(&house, moving);
    allocations = 0;
    interposed_begin();
    if (guest_gl_create(&house, params, &error) != CUPOLA_OK ||
        cupola_theatre_create(house.dome, &house.theatre, &error) != CUPOLA_OK ||
        cupola_gl_set_gain(house.gl, 0, house.gain, &error) != CUPOLA_OK)
        fail_msg("%s: %s", name, error.message);
    assert_int_equal(cupola_gl_points(house.gl, 0, &points, NULL), CUPOLA_OK);
    int made = interposed.made, allocated = allocations;
    check_at_least(made, 10); /* the control: making is seen */
    check_at_least(allocated, 2);
    allocations = interposed.made = 0;
    for (int i = 0; i < FRAMES; i++) {
        assert_int_equal(cupola_gl_set_gain(house.gl, 0, i % 2 ? house.gain : 0, NULL), CUPOLA_OK);
        check_frame(&house);
        assert_int_equal(cupola_gl_points(house.gl, 0, &points, NULL), CUPOLA_OK);
        assert_int_equal(guest_theatre(&house, NULL), CUPOLA_OK);
    }
    interposed_end();
    printf("  %s: %d allocations and %d things to make them; in %d frames %d and %d\n", name,
           allocated, made, FRAMES, allocations, interposed.made);
    assert_int_equal(allocations, 0);
    assert_int_equal(interposed.made, 0);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    guest_house_release(&house);
}

static void frames_allocate_and_compile_nothing(void **state)
{
    (void)state;
    for (int table = CUPOLA_TABLE_POINTS; table <= CUPOLA_TABLE_TILES; table++) {
        const struct cupola_gl_params params = {.table = (enum cupola_table)table};
        check_costs(&params, false, cupola_table_name(table));
    }
    const struct cupola_gl_params rich = {.format = CUPOLA_FORMAT_SRGB8,
                                          .depth = CUPOLA_DEPTH_24_STENCIL_8,
                                          .samples = 2,
                                          .encoding = CUPOLA_ENCODING_SRGB};
    check_costs(&rich, false, "several samples");
    for (int storage = CUPOLA_STORAGE_TEXTURES; storage <= CUPOLA_STORAGE_LAYERS; storage++) {
        const struct cupola_gl_params host = {.storage = (enum cupola_storage)storage};
        check_costs(&host, false,
                    storage == CUPOLA_STORAGE_LAYERS ? "host's layers" : "host's textures");
    }
}

static void eyes_that_move_allocate_and_compile_nothing(void **state)
{
    (void)state;
    for (int table = CUPOLA_TABLE_POINTS; table <= CUPOLA_TABLE_TILES; table++) {
        const struct cupola_gl_params params = {.table = (enum cupola_table)table};
        char name[80];
        snprintf(name, sizeof name, "%s, a moving eye", cupola_table_name(table));
        if (guest_moving_table(params.table) == params.table)
            check_costs(&params, true, name);
    }
}

static int questions_of_a_frame(enum cupola_storage storage, enum cupola_table table, bool moving,
                                bool leaves_state)
{
    const struct cupola_gl_params params = {.depth = CUPOLA_DEPTH_24_STENCIL_8,
                                            .samples = 2,
                                            .storage = storage,
                                            .table = table,
                                            .leaves_state = leaves_state};
    struct guest_house house;
    build(&house, moving);
    assert_int_equal(guest_gl_create(&house, &params, NULL), CUPOLA_OK);
    assert_int_equal(cupola_gl_set_gain(house.gl, 0, house.gain, NULL), CUPOLA_OK);
    interposed_begin();
    for (int i = 0; i < 2; i++)
        check_frame(&house);
    interposed_end();
    assert_int_equal(glGetError(), GL_NO_ERROR);
    guest_house_release(&house);
    return interposed.asked / 2;
}

static void frames_that_leave_the_state_ask_for_nothing(void **state)
{
    (void)state;
    for (int i = CUPOLA_STORAGE_ATLAS; i <= CUPOLA_STORAGE_LAYERS; i++) {
        enum cupola_storage storage = (enum cupola_storage)i;
        int asked = questions_of_a_frame(storage, CUPOLA_TABLE_POINTS, false, false);
        printf("  %d questions to the GL in a frame that keeps the host's state\n", asked);
        check_at_least(asked, 100); /* the control */
        assert_int_equal(questions_of_a_frame(storage, CUPOLA_TABLE_POINTS, false, true), 0);
        assert_int_equal(questions_of_a_frame(storage, CUPOLA_TABLE_TILES, false, true), 0);
    }
    for (int table = CUPOLA_TABLE_POINTS; table <= CUPOLA_TABLE_TILES; table++) {
        enum cupola_table stage = guest_moving_table((enum cupola_table)table);
        assert_int_equal(questions_of_a_frame(CUPOLA_STORAGE_ATLAS, stage, true, true), 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_allocate_and_compile_nothing),
        cmocka_unit_test(eyes_that_move_allocate_and_compile_nothing),
        cmocka_unit_test(frames_that_leave_the_state_ask_for_nothing),
    };
    return cmocka_run_group_tests_name("frame_costs", tests, open_context, close_context);
}
