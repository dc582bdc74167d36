/*
 * Lives of all that there is, and rigs in a row, leave nothing behind: with CUPOLA_LONG=1 1,000
 * and 200 of them.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
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

enum { LIVES = 1000, RIGS = 200, LEAKS = 200, WARM_UP = 100, NAMES = 2048 };
enum { SLACK = 2 << 20, PER_LIFE = 2 << 10 }; /* bytes that the GL may keep for itself */

static struct guest_house house;

static long blocks; /* that the library has, and this test: not those of the GL */

void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *block, size_t size);
void __real_free(void *block);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *block, size_t size);
void __wrap_free(void *block);

void *__wrap_malloc(size_t size)
{
    void *made = __real_malloc(size);
    blocks += made != NULL;
    return made;
}

void *__wrap_calloc(size_t count, size_t size)
{
    void *made = __real_calloc(count, size);
    blocks += made != NULL;
    return made;
}

void *__wrap_realloc(void *block, size_t size)
{
    bool fresh = !block;
    void *made = __real_realloc(block, size);
    blocks += fresh && made;
    return made;
}

void __wrap_free(void *block)
{
    blocks -= block != NULL;
    __real_free(block);
}

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

/* Less what is free: a leak that fits into that would not be seen. */
static long resident_bytes(void)
{
    long pages = 0, resident = 0;
#ifdef __GLIBC__
    malloc_trim(0);
#endif
    FILE *file = fopen("/proc/self/statm", "r");
    if (file && fscanf(file, "%ld %ld", &pages, &resident) != 2)
        resident = 0;
    if (file)
        fclose(file);
    return resident * sysconf(_SC_PAGESIZE);
}

static double bytes_allowed(int count)
{
    return SLACK + (double)count * PER_LIFE;
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
        .table = draws ? (enum cupola_table)(number / 10 % 6) : CUPOLA_TABLE_NONE,
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

/* What a number of lives leaves behind. */
struct growth {
    int objects;
    long most_blocks; /* after any of them */
    long bytes;
};

static struct growth growth_of(void (*cycle)(int number), int count)
{
    struct growth growth = {0, 0, 0};
    for (int i = 0; i < WARM_UP && i < count; i++) /* the GL's own caches */
        cycle(i);
    glFinish();
    int objects = live_objects(NAMES);
    long bytes = resident_bytes(), before = blocks;
    for (int i = 0; i < count; i++) {
        cycle(i);
        if (labs(blocks - before) > labs(growth.most_blocks))
            growth.most_blocks = blocks - before;
    }
    glFinish();
    growth.bytes = resident_bytes() - bytes;
    growth.objects = live_objects(NAMES) - objects;
    printf("  after %d: %d objects, %ld blocks, %ld KiB more\n", count, growth.objects,
           growth.most_blocks, growth.bytes / 1024);
    return growth;
}

static void check_growth(void (*cycle)(int number), int count)
{
    struct growth growth = growth_of(cycle, count);
    assert_int_equal(growth.objects, 0);
    assert_int_equal(growth.most_blocks, 0);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    if (!SANITIZED)
        check_at_most(growth.bytes, bytes_allowed(count));
}

/* What the suite has time for. */
static int share_of(int count)
{
    const char *wish = getenv("CUPOLA_LONG");
    bool all = wish && strcmp(wish, "1") == 0;
    return all ? count : count / (context_is_es() ? 10 : 5);
}

static void lives_leave_nothing_behind(void **state)
{
    (void)state;
    check_growth(live, share_of(LIVES));
}

static void rigs_leave_nothing_behind(void **state)
{
    (void)state;
    check_growth(change_rig, share_of(RIGS));
}

/* The controls: one small block, and one that is large enough to be seen from outside. */
static void *leaked[2 * LEAKS];
static int leaks;

static void leak_block(int number)
{
    (void)number;
    leaked[leaks++] = malloc(8);
}

static void leak_pages(int number)
{
    leaked[leaks++] = memset(malloc(8 * PER_LIFE), number, 8 * PER_LIFE);
}

static void a_leak_would_be_seen(void **state)
{
    (void)state;
    for (int large = 0; large < 2; large++) {
        struct growth growth = growth_of(large ? leak_pages : leak_block, LEAKS);
        while (leaks > 0)
            free(leaked[--leaks]);
        assert_int_equal(growth.most_blocks, LEAKS);
        if (large && !SANITIZED)
            check_at_least(growth.bytes, bytes_allowed(LEAKS));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_leak_would_be_seen),
        cmocka_unit_test(lives_leave_nothing_behind),
        cmocka_unit_test(rigs_leave_nothing_behind),
    };
    return cmocka_run_group_tests_name("lives", tests, open_house, close_house);
}
