/* Antialiasing on the command line: every way makes a picture of its own. */
#include <stdio.h>
#include <string.h>

#include <cupola/image_file.h>

#include "check.h"
#include "demo_picture.h"

enum { WAYS = 8 };

static struct process process;

static struct picture run(const char *way)
{
    char command[512];

    snprintf(command, sizeof command, "--size 64x64 --lens hemispheric --fov 180 %s", way);
    return demo_run_pfm(&process, command);
}

static bool same(const struct picture *a, const struct picture *b)
{
    size_t bytes = (size_t)(4 * a->width * a->height) * sizeof *a->rgba;

    return a->width == b->width && a->height == b->height && memcmp(a->rgba, b->rgba, bytes) == 0;
}

static void every_way_is_one_of_its_own(void **state)
{
    static const char *const ways[] = {
        "--aa texture",
        "--aa none",
        "--aa texture --samples 9",
        "--aa cone",
        "--aa cone --pattern blue-noise",
        "--aa cone --turned 1",
        "--aa adaptive",
        "--aa footprint",
    };
    struct picture pictures[WAYS];

    (void)state;
    for (int i = 0; i < WAYS; i++)
        pictures[i] = run(ways[i]);
    for (int i = 0; i < WAYS; i++)
        for (int k = 0; k < i; k++)
            if (same(&pictures[i], &pictures[k]))
                fail_msg("%s makes the picture of %s", ways[i], ways[k]);
    for (int i = 0; i < WAYS; i++)
        cupola_image_free(&pictures[i].rgba);
}

static void nothing_said_is_bilinear(void **state)
{
    struct picture silent = run(""), bilinear = run("--aa texture");

    (void)state;
    assert_true(same(&silent, &bilinear));
    cupola_image_free(&silent.rgba);
    cupola_image_free(&bilinear.rgba);
}

/* It takes the nearest texels unless it is told otherwise. */
static void a_reference_heeds_it_too(void **state)
{
    struct picture silent = run("--reference 2"), none = run("--reference 2 --aa none");
    struct picture cone = run("--reference 2 --aa cone");

    (void)state;
    assert_true(same(&silent, &none));
    assert_false(same(&silent, &cone));
    cupola_image_free(&silent.rgba);
    cupola_image_free(&none.rgba);
    cupola_image_free(&cone.rgba);
}

int main(void)
{
    const struct CMUnitTest filters[] = {
        cmocka_unit_test(every_way_is_one_of_its_own),
        cmocka_unit_test(nothing_said_is_bilinear),
        cmocka_unit_test(a_reference_heeds_it_too),
    };
    return cmocka_run_group_tests(filters, process_enter_directory, process_leave_directory);
}
