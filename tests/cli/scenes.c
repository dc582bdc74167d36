/* The shadings of the demo's scenes: three that differ, and the same in every view. */
#include <math.h>
#include <stdio.h>

#include <cupola/image_file.h>

#include "check.h"
#include "demo_picture.h"

static struct process process;

static struct picture run(const char *format, const char *value)
{
    char command[512];

    snprintf(command, sizeof command, format, value);
    return demo_run_pfm(&process, command);
}

/* The mean of the absolute differences of the colours. */
static double mean_difference(const struct picture *a, const struct picture *b)
{
    double sum = 0;
    int pixels = a->width * a->height;

    for (int i = 0; i < 4 * pixels; i++)
        sum += fabs((double)a->rgba[i] - (double)b->rgba[i]);
    return sum / (3.0 * pixels);
}

/* A wall before the camera, wider than it sees. */
static void write_wall(void)
{
    process_write_file("wall.mtl", "newmtl wall\nKd 0.6 0.5 0.4\n");
    process_write_file("wall.obj", "mtllib wall.mtl\nv -8 -8 -2\nv 8 -8 -2\nv 8 8 -2\nv -8 8 -2\n"
                                   "usemtl wall\nf 1 2 3 4\n");
}

static void the_shadings_of_every_scene_differ(void **state)
{
    static const char *const scenes[] = {
        "--size 64x64 --shading %s --scene cube",
        "--size 64x64 --shading %s --scene forest --triangles 20000",
        "--size 64x64 --shading %s --fov 120 --camera 0,0,0 wall.obj",
    };

    (void)state;
    write_wall();
    for (int i = 0; i < 3; i++) {
        struct picture flat = run(scenes[i], "flat"), lambert = run(scenes[i], "lambert");
        struct picture heavy = run(scenes[i], "heavy");
        check_at_least(mean_difference(&flat, &lambert), 0.005);
        check_at_least(mean_difference(&flat, &heavy), 0.005);
        check_at_least(mean_difference(&lambert, &heavy), 0.005);
        cupola_image_free(&flat.rgba);
        cupola_image_free(&lambert.rgba);
        cupola_image_free(&heavy.rgba);
    }
}

static void check_same(const char *one, const char *other)
{
    struct picture a = run("%s", one), b = run("%s", other);

    check_near(picture_difference(&a, &b), 0, 0);
    cupola_image_free(&a.rgba);
    cupola_image_free(&b.rgba);
}

static void lambert_is_the_default_and_flat_has_a_short_name(void **state)
{
    (void)state;
    write_wall();
    check_same("--size 64x64", "--size 64x64 --shading lambert");
    check_same("--size 64x64 --flat", "--size 64x64 --shading flat");
    check_same("--size 64x64 --camera 0,0,0 wall.obj",
               "--size 64x64 --camera 0,0,0 --shading lambert wall.obj");
    check_same("--size 64x64 --camera 0,0,0 wall.obj --flat",
               "--size 64x64 --camera 0,0,0 --shading flat wall.obj");
}

static void flat_walls_have_their_material_s_color(void **state)
{
    static const double color[3] = {0.6, 0.5, 0.4};
    struct picture picture;

    (void)state;
    write_wall();
    picture = run("--size 64x64 --fov 120 --camera 0,0,0 --shading flat %s", "wall.obj");
    for (int c = 0; c < 3; c++)
        check_near(picture_pixel(&picture, 20, 30)[c], color[c], 1e-6);
    cupola_image_free(&picture.rgba);
}

/*
 * Light and bumps are of the world, so the borders between views do not show: other views, the same
 * picture but for the sharpest highlights, which four texels per pixel do not hold. A wall moved by
 * a thirtieth of a bump's width is caught.
 */
static void heavy_shading_is_the_same_in_every_view(void **state)
{
    static const char format[] = "--size 96x96 --fov 120 --density 4 --shading heavy %s wall.obj";
    struct picture few, many, moved;

    (void)state;
    write_wall();
    few = run(format, "--layout asymmetric --views 2 --camera 0,0,0");
    many = run(format, "--layout rotated --views 7 --camera 0,0,0");
    moved = run(format, "--layout rotated --views 7 --camera 0.02,0,0");
    check_at_most(picture_others(&few, &many, 0, 0), 10);
    check_at_least(picture_others(&few, &moved, 0, 0), 100);
    cupola_image_free(&few.rgba);
    cupola_image_free(&many.rgba);
    cupola_image_free(&moved.rgba);
}

int main(void)
{
    const struct CMUnitTest scenes[] = {
        cmocka_unit_test(the_shadings_of_every_scene_differ),
        cmocka_unit_test(lambert_is_the_default_and_flat_has_a_short_name),
        cmocka_unit_test(flat_walls_have_their_material_s_color),
        cmocka_unit_test(heavy_shading_is_the_same_in_every_view),
    };
    return cmocka_run_group_tests(scenes, process_enter_directory, process_leave_directory);
}
