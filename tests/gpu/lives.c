/* A thousand lives of all that there is, and two hundred rigs in a row, leave nothing behind. */
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "check.h"
#include "context.h"
#include "guest_fixture.h"
#include "live_objects.h"
#include "rig_random.h"

/* AddressSanitizer keeps what was freed for a while, and finds leaks by itself. */
#if defined(__SANITIZE_ADDRESS__)
enum { SANITIZED = 1 };
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
enum { SANITIZED = 1 };
#else
enum { SANITIZED = 0 };
#endif
#else
enum { SANITIZED = 0 };
#endif

enum { LIVES = 1000, RIGS = 200, WARM_UP = 200, NAMES = 2048 };

static struct guest_house house;

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

static long resident_bytes(void)
{
    long pages = 0, resident = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    if (file && fscanf(file, "%ld %ld", &pages, &resident) != 2)
        resident = 0;
    if (file)
        fclose(file);
    return resident * sysconf(_SC_PAGESIZE);
}

static void check_ok(int status, const struct cupola_error *error, int number)
{
    if (status < 0)
        fail_msg("number %d: %s", number, error->message);
}

/*
 * With and without samples; each tenth draws with a table of any stage, each fortieth all there is.
 * A software rasteriser compiles what is drawn for the first time, which takes longer than a life.
 */
static void live(int number)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    bool draws = number % 10 == 0, whole = number % 40 == 0;
    unsigned int points = 0;
    const struct cupola_gl_params params = {
        .table = draws ? (enum cupola_table)(number / 10 % 5) : CUPOLA_TABLE_NONE,
        .samples = number % 3 == 0 ? 2 : 0,
        .sources = whole ? 0 : 1u << CUPOLA_SOURCE_VIEWS,
    };
    check_ok(guest_gl_create(&house, &params, &error), &error, number);
    check_ok(guest_views(&house, &error), &error, number);
    if (draws) {
        check_ok(guest_warp(&house, -1, &error), &error, number);
        check_ok(cupola_gl_points(house.gl, 0, &points, &error), &error, number);
    }
    if (whole) {
        check_ok(cupola_theatre_create(house.dome, &house.theatre, &error), &error, number);
        check_ok(cupola_gl_set_gain(house.gl, 0, house.gain, &error), &error, number);
        check_ok(guest_frame(&house, &error), &error, number);
        check_ok(guest_theatre(&house, &error), &error, number);
    }
    cupola_theatre_destroy(&house.theatre);
    cupola_gl_destroy(&house.gl);
}

/* Another theatre in the same context, as when a rig is edited; it replays by its number. */
static void change_rig(int number)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    uint64_t seed = (uint64_t)number + 1;
    struct cupola_rig rig = random_rig(&seed, 0.8);
    const struct cupola_plan_params params = {.view_size_px = 16};
    for (int i = 0; i < rig.output_count || i == 0; i++) {
        rig.outputs[i].width_px = random_int(&seed, 8, 24);
        rig.outputs[i].height_px = random_int(&seed, 8, 24);
        rig.outputs[i].circle = (struct cupola_circle){0};
    }
    cupola_plan_destroy(&house.plan);
    cupola_dome_destroy(&house.dome);
    check_ok(cupola_dome_create(&rig, &house.dome, &error), &error, number);
    check_ok(cupola_plan_create(house.dome, &params, &house.plan, &error), &error, number);
    const struct cupola_gl_params gl_params = {
        .table = number % 4 ? CUPOLA_TABLE_NONE : CUPOLA_TABLE_POINTS,
        .sources = 1u << CUPOLA_SOURCE_VIEWS,
    };
    check_ok(guest_gl_create(&house, &gl_params, &error), &error, number);
    check_ok(guest_views(&house, &error), &error, number);
    check_ok(guest_warp(&house, -1, &error), &error, number);
    cupola_gl_destroy(&house.gl);
}

static void check_growth(void (*cycle)(int number), int count)
{
    for (int i = 0; i < WARM_UP && i < count; i++) /* the GL's own caches */
        cycle(i);
    glFinish();
    int objects = live_objects(NAMES);
    long bytes = resident_bytes();
    for (int i = 0; i < count; i++)
        cycle(i);
    glFinish();
    long more = resident_bytes() - bytes;
    printf("  %d objects before, %d after %d; %ld KiB more\n", objects, live_objects(NAMES), count,
           more / 1024);
    assert_int_equal(live_objects(NAMES), objects);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    if (!SANITIZED)
        check_at_most(more, 12 << 20);
}

static void a_thousand_lives_leave_nothing_behind(void **state)
{
    (void)state;
    check_growth(live, context_is_es() ? LIVES / 5 : LIVES);
}

static void two_hundred_rigs_leave_nothing_behind(void **state)
{
    (void)state;
    check_growth(change_rig, RIGS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_thousand_lives_leave_nothing_behind),
        cmocka_unit_test(two_hundred_rigs_leave_nothing_behind),
    };
    return cmocka_run_group_tests_name("lives", tests, open_house, close_house);
}
