/*
 * A GL, or a process, that runs out of something at any moment: the first, second, ... of what a
 * call makes fails until the call succeeds. Each failure says so, gives back what was made, and
 * leaves the host's state and the caller's pointers as they were.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "context.h"
#include "cupola/cost.h"
#include "guest_fixture.h"
#include "interposed.h"
#include "live_objects.h"
#include "state_snapshot.h"

enum { NAMES = 512, MANY = 1000 };

static int allocations_to_go; /* up to the one that fails; 0: none will, or it has */

static bool runs_out(void)
{
    return allocations_to_go > 0 && --allocations_to_go == 0;
}

#define WRAP(name, parameters, arguments)                                                          \
    void *__real_##name parameters;                                                                \
    void *__wrap_##name parameters;                                                                \
    void *__wrap_##name parameters                                                                 \
    {                                                                                              \
        return runs_out() ? NULL : __real_##name arguments;                                        \
    }

WRAP(malloc, (size_t size), (size))
WRAP(calloc, (size_t count, size_t size), (count, size))
WRAP(realloc, (void *block, size_t size), (block, size))

static struct guest_house house;
static struct cupola_gl_params params;

static int open_house(void **state)
{
    (void)state;
    context_open();
    guest_house_build(&house);
    return 0;
}

static int close_house(void **state)
{
    (void)state;
    guest_house_release(&house);
    context_close();
    return 0;
}

/* Calls that make something, each from nothing and, where it succeeds, given back by undo. */
struct maker {
    const char *name;
    int (*make)(struct cupola_error *error);
    void (*undo)(void);
    int least; /* things that can fail */
    int step; /* every how many of them does; 0: each. A call that leaves nothing has one above 1 */
};

static int make_gl(struct cupola_error *error)
{
    house.gl = NULL;
    int status = guest_gl_create(&house, &params, error);
    assert_int_equal(house.gl != NULL, status == CUPOLA_OK);
    return status;
}

static void undo_gl(void)
{
    cupola_gl_destroy(&house.gl);
}

static int make_theatre(struct cupola_error *error)
{
    house.theatre = NULL;
    int status = cupola_theatre_create(house.dome, &house.theatre, error);
    assert_int_equal(house.theatre != NULL, status == CUPOLA_OK);
    return status;
}

static void undo_theatre(void)
{
    cupola_theatre_destroy(&house.theatre);
}

static cupola_points *points_alone;

static int make_points_alone(struct cupola_error *error)
{
    points_alone = NULL;
    int status = cupola_points_create(house.dome, 0, &points_alone, error);
    assert_int_equal(points_alone != NULL, status == CUPOLA_OK);
    return status;
}

static void undo_points_alone(void)
{
    cupola_points_destroy(&points_alone);
}

/* The texture that several projectors' light is added up in, made in a frame. */
static int make_sum(struct cupola_error *error)
{
    return guest_theatre_encoded(&house, CUPOLA_ENCODING_SRGB, error);
}

static int make_points(struct cupola_error *error)
{
    unsigned int points = 7;
    int status = cupola_gl_points(house.gl, 0, &points, error);
    assert_int_equal(points == 7, status != CUPOLA_OK);
    return status;
}

static int make_density(struct cupola_error *error)
{
    unsigned int density = 7;
    int status = cupola_gl_density(house.gl, 0, &density, error);
    assert_int_equal(density == 7, status != CUPOLA_OK);
    return status;
}

static int make_gain(struct cupola_error *error)
{
    return cupola_gl_set_gain(house.gl, 0, house.gain, error);
}

static void undo_nothing(void)
{
}

static void draw_nothing(cupola_gl *gl, int index, const struct cupola_gl_view *view, void *user)
{
    (void)gl;
    (void)index;
    (void)view;
    (void)user;
}

/* What takes no time may have no price. */
static int make_prices(struct cupola_error *error)
{
    struct cupola_cost cost = {.view = -1.0};
    int status =
        cupola_gl_measure_cost(house.dome, NULL, NULL, NULL, draw_nothing, NULL, &cost, error);
    assert_true(cost.view >= 0.0 || status != CUPOLA_OK);
    return status == CUPOLA_ERROR_ARGUMENT && strstr(error->message, "cannot tell") ? CUPOLA_OK
                                                                                    : status;
}

/* One try; whether something failed in it. */
static bool try_once(const struct maker *maker, int n, bool memory)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    struct snapshot before, after;
    int objects = live_objects(NAMES);
    snapshot_take(&before);
    interposed_begin();
    *(memory ? &allocations_to_go : &interposed.to_go) = n;
    int status = maker->make(&error);
    bool reached = (memory ? allocations_to_go : interposed.to_go) == 0;
    allocations_to_go = interposed.to_go = 0;
    GLenum pending = glGetError();
    interposed_end();
    snapshot_take(&after);
    assert_int_equal(snapshot_differences(&before, &after, true, maker->name), 0);
    if (pending != GL_NO_ERROR)
        fail_msg("%s, failure %d: leaves GL error 0x%x", maker->name, n, pending);
    if (!reached) {
        if (status != CUPOLA_OK)
            fail_msg("%s: %s", maker->name, error.message);
        /* The control: they are seen. */
        assert_true(memory || maker->step > 1 || live_objects(NAMES) > objects);
        maker->undo();
        return false;
    }
    int expected = memory || interposed.out_of_memory ? CUPOLA_ERROR_MEMORY : CUPOLA_ERROR_GL;
    if (status != expected || error.status != (enum cupola_status)status || !error.message[0])
        fail_msg("%s, failure %d: status %d instead of %d: %s", maker->name, n, status, expected,
                 error.message);
    if (live_objects(NAMES) != objects)
        fail_msg("%s, failure %d: %d objects, not %d (%s)", maker->name, n, live_objects(NAMES),
                 objects, error.message);
    return true;
}

static void try_each(const struct maker *maker, bool memory)
{
    int failures = 0, step = maker->step > 1 ? maker->step : 1;
    while (failures < MANY && try_once(maker, failures + 1, memory))
        failures += step;
    printf("  %s: %d %s\n", maker->name, failures, memory ? "allocations" : "things of the GL");
    check_at_most(failures, MANY - 1);
    check_at_least(failures, memory ? 1 : maker->least);
}

static void creation_survives(void **state)
{
    const struct maker maker = {"create", make_gl, undo_gl, 25};
    (void)state;
    params = (struct cupola_gl_params){.table = CUPOLA_TABLE_SINES};
    try_each(&maker, false);
    try_each(&maker, true);
}

static void creation_of_tiles_survives(void **state)
{
    const struct maker maker = {"create, tiles", make_gl, undo_gl, 20};
    (void)state;
    params = (struct cupola_gl_params){.table = CUPOLA_TABLE_TILES,
                                       .sources = 1u << CUPOLA_SOURCE_VIEWS};
    try_each(&maker, false);
    try_each(&maker, true);
}

static void creation_for_a_moving_eye_survives(void **state)
{
    const struct maker maker = {"create, a moving eye", make_gl, undo_gl, 8};
    (void)state;
    guest_house_release(&house);
    guest_house_build_moving(&house);
    params = (struct cupola_gl_params){.table = guest_moving_table(CUPOLA_TABLE_ANGLES),
                                       .sources = 1u << CUPOLA_SOURCE_VIEWS};
    try_each(&maker, false);
    try_each(&maker, true);
    guest_house_release(&house);
    guest_house_build(&house);
}

static void creation_with_samples_survives(void **state)
{
    const struct maker maker = {"create, several samples", make_gl, undo_gl, 15};
    (void)state;
    params = (struct cupola_gl_params){.format = CUPOLA_FORMAT_SRGB8,
                                       .samples = 2,
                                       .depth = CUPOLA_DEPTH_24_STENCIL_8,
                                       .sources = 1u << CUPOLA_SOURCE_VIEWS};
    try_each(&maker, false);
}

static void creation_for_the_hosts_textures_survives(void **state)
{
    const struct maker textures = {"create, the host's textures", make_gl, undo_gl, 10};
    const struct maker layers = {"create, the host's layers", make_gl, undo_gl, 10};
    (void)state;
    params = (struct cupola_gl_params){.storage = CUPOLA_STORAGE_TEXTURES,
                                       .sources = 1u << CUPOLA_SOURCE_VIEWS};
    try_each(&textures, false);
    params.storage = CUPOLA_STORAGE_LAYERS;
    try_each(&layers, false);
    try_each(&layers, true);
}

static void theatres_survive(void **state)
{
    const struct maker maker = {"theatre", make_theatre, undo_theatre, 7};
    (void)state;
    try_each(&maker, false);
    try_each(&maker, true);
}

static void frames_that_make_something_survive(void **state)
{
    const struct maker maker = {"light of several projectors", make_sum, undo_nothing, 4};
    (void)state;
    guest_house_release(&house);
    guest_house_build_for(&house, 3);
    assert_int_equal(make_theatre(NULL), CUPOLA_OK);
    try_each(&maker, false);
    guest_house_release(&house);
    guest_house_build(&house);
}

static void points_and_gain_survive(void **state)
{
    const struct maker alone = {"points alone", make_points_alone, undo_points_alone, 3};
    const struct maker points = {"points", make_points, undo_nothing, 2};
    const struct maker density = {"density", make_density, undo_nothing, 2};
    const struct maker gain = {"gain", make_gain, undo_nothing, 7};
    (void)state;
    params = (struct cupola_gl_params){.table = CUPOLA_TABLE_NONE};
    assert_int_equal(make_gl(NULL), CUPOLA_OK);
    try_each(&alone, false);
    try_each(&alone, true);
    try_each(&points, false);
    try_each(&density, false);
    try_each(&gain, false);
    undo_gl();
}

static void measuring_survives(void **state)
{
    const struct maker maker = {"prices", make_prices, undo_nothing, 50, 7};
    (void)state;
    try_each(&maker, false);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(creation_survives),
        cmocka_unit_test(creation_of_tiles_survives),
        cmocka_unit_test(creation_for_a_moving_eye_survives),
        cmocka_unit_test(creation_with_samples_survives),
        cmocka_unit_test(creation_for_the_hosts_textures_survives),
        cmocka_unit_test(theatres_survive),
        cmocka_unit_test(frames_that_make_something_survive),
        cmocka_unit_test(points_and_gain_survive),
        cmocka_unit_test(measuring_survives),
    };
    return cmocka_run_group_tests_name("gl_failures", tests, open_house, close_house);
}
