/* The demo's forest: as many triangles as wished, the same for a seed, culled without loss. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cupola/image_file.h>

#include "check.h"
#include "demo_picture.h"

static struct process process;

/* A number of the statistics on the demo's standard output. */
static double stated(const char *key)
{
    char name[60];
    const char *at;

    snprintf(name, sizeof name, "\"%s\": ", key);
    at = strstr(process.out, name);
    if (!at)
        fail_msg("the statistics have no %s", key);
    return strtod(at + strlen(name), NULL);
}

static void the_forest_has_the_triangles_that_are_wished(void **state)
{
    static const int wished[] = {1000, 4321, 70000, 3000000};
    char command[200];

    (void)state;
    for (size_t i = 0; i < sizeof wished / sizeof wished[0]; i++) {
        snprintf(command, sizeof command,
                 "--scene forest --size 32x32 --frames 1 --stats - --output x.png --triangles %d",
                 wished[i]);
        process_run(&process, command, NULL);
        assert_int_equal(process.status, 0);
        check_near(stated("triangles") / wished[i], 1, 0.01);
        check_at_least(stated("triangles_drawn"), 0.1 * wished[i]);
        check_at_least(stated("instances"), 5);
    }
    process_run(&process, "--scene forest --size 32x32 --frames 1 --stats - --output x.png", NULL);
    check_near(stated("triangles") / 1e6, 1, 0.01);
}

static void other_scenes_count_their_triangles(void **state)
{
    (void)state;
    process_write_file("wall.obj", "v -8 -8 -2\nv 8 -8 -2\nv 8 8 -2\nv -8 8 -2\nf 1 2 3 4\n");
    process_run(&process, "--size 32x32 --frames 2 --views 3 --fov 90 --stats - --output x.png",
                NULL);
    check_near(stated("triangles"), 12, 0);
    check_near(stated("triangles_drawn"), 36, 0);
    process_run(&process, "wall.obj --perspective --fov 90 --size 32x32 --stats - --output x.png",
                NULL);
    check_near(stated("triangles_drawn"), 2, 0);
    check_near(stated("instances_drawn"), 1, 0);
    process_run(&process, "--scene directions --size 32x32 --stats - --output x.pfm", NULL);
    check_near(stated("triangles"), 0, 0);
}

static void a_seed_is_a_forest(void **state)
{
    static const char forest[] = "--scene forest --triangles 20000 --size 96x96";
    static const char other_forest[] = "--scene forest --triangles 20000 --size 96x96 --seed 1";
    struct picture once, again, other;

    (void)state;
    once = demo_run_pfm(&process, forest);
    again = demo_run_pfm(&process, forest);
    other = demo_run_pfm(&process, other_forest);
    check_near(picture_difference(&once, &again), 0, 0);
    check_at_least(picture_others(&once, &other, 0, 0), 500);
    cupola_image_free(&once.rgba);
    cupola_image_free(&again.rgba);
    cupola_image_free(&other.rgba);
}

/*
 * The same pixels once alone and once in the middle of a picture that is twice as wide: trees that
 * were left out though something of them shows would be missing at the border.
 */
static void culling_takes_no_tree_away_that_shows(void **state)
{
    static const char *const cameras[] = {"--camera 2,1,-3 --look 30,20,10 --up 0.3,1,0.2",
                                          "--camera 0,0,0 --look -5,-1,9",
                                          "--camera -8,9,4 --look 0,-1,0 --up 1,0.2,0"};
    char command[300];

    (void)state;
    for (int i = 0; i < 3; i++) {
        double instances;
        struct picture small, large;
        snprintf(command, sizeof command,
                 "--scene forest --triangles 50000 --perspective --size 128x128 --fov 60 "
                 "--frames 1 --stats - %s",
                 cameras[i]);
        small = demo_run_pfm(&process, command);
        instances = stated("instances_drawn");
        /* 2 atan(2 tan 30 deg) */
        snprintf(command, sizeof command,
                 "--scene forest --triangles 50000 --perspective --size 256x256 "
                 "--fov 98.213210702 --frames 1 --stats - %s",
                 cameras[i]);
        large = demo_run_pfm(&process, command);
        check_at_least(stated("instances_drawn"), 1.2 * instances);
        check_at_most(picture_others(&small, &large, 64, 64), 50);
        check_at_least(picture_others(&small, &large, 65, 64), 200);
        cupola_image_free(&small.rgba);
        cupola_image_free(&large.rgba);
    }
}

int main(void)
{
    const struct CMUnitTest forest[] = {
        cmocka_unit_test(the_forest_has_the_triangles_that_are_wished),
        cmocka_unit_test(other_scenes_count_their_triangles),
        cmocka_unit_test(a_seed_is_a_forest),
        cmocka_unit_test(culling_takes_no_tree_away_that_shows),
    };
    return cmocka_run_group_tests(forest, process_enter_directory, process_leave_directory);
}
