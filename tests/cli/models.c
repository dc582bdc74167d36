/* Where the demo puts models, and how it lights them: by their shape, however a file has it. */
#include <math.h>
#include <stdio.h>

#include <cupola/image_file.h>

#include "check.h"
#include "demo_picture.h"

static struct process process;

/* From (-1, -1, -1) to (1, 1, 1); triangles as counter-clockwise seen from outside. */
static const double corners[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                     {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
static const int triangles[12][3] = {{4, 5, 6}, {4, 6, 7}, {1, 0, 3}, {1, 3, 2},
                                     {5, 1, 2}, {5, 2, 6}, {0, 4, 7}, {0, 7, 3},
                                     {7, 6, 2}, {7, 2, 3}, {0, 1, 5}, {0, 5, 4}};

/* `flips`: bit i turns the winding of triangle i round. */
static void write_cube_obj(const char *name, unsigned int flips)
{
    FILE *file = fopen(name, "w");

    assert_non_null(file);
    process_write_file("white.mtl", "newmtl white\nKd 1 1 1\n"); /* as a PLY is without a word */
    fputs("mtllib white.mtl\nusemtl white\n", file);
    for (int i = 0; i < 8; i++)
        fprintf(file, "v %g %g %g\n", corners[i][0], corners[i][1], corners[i][2]);
    for (int i = 0; i < 12; i++) {
        const int *corner = triangles[i];
        bool flip = flips >> i & 1;
        fprintf(file, "f %d %d %d\n", corner[0] + 1, corner[flip ? 2 : 1] + 1,
                corner[flip ? 1 : 2] + 1);
    }
    assert_int_equal(fclose(file), 0);
}

static void write_cube_ply(const char *name)
{
    FILE *file = fopen(name, "w");

    assert_non_null(file);
    fputs("ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
          "property float z\nelement face 12\nproperty list uchar int vertex_indices\n"
          "end_header\n",
          file);
    for (int i = 0; i < 8; i++)
        fprintf(file, "%g %g %g\n", corners[i][0], corners[i][1], corners[i][2]);
    for (int i = 0; i < 12; i++)
        fprintf(file, "3 %d %d %d\n", triangles[i][0], triangles[i][1], triangles[i][2]);
    assert_int_equal(fclose(file), 0);
}

/* A sphere of radius 1, 48 x 24 quads, smooth normals on request: 1 outwards, -1 inwards, 0 none.
 */
static void write_sphere_obj(const char *name, int normals)
{
    enum { ROUND = 48, HIGH = 24 };
    const double pi = 3.14159265358979323846;
    FILE *file = fopen(name, "w");

    assert_non_null(file);
    for (int j = 0; j <= HIGH; j++) {
        for (int i = 0; i < ROUND; i++) {
            double up = pi * (j / (double)HIGH - 0.5), round = 2 * pi * i / ROUND;
            double p[3] = {cos(up) * sin(round), sin(up), cos(up) * cos(round)};
            fprintf(file, "v %.9g %.9g %.9g\n", p[0], p[1], p[2]);
            if (normals)
                fprintf(file, "vn %.9g %.9g %.9g\n", normals * p[0], normals * p[1],
                        normals * p[2]);
        }
    }
    for (int j = 0; j < HIGH; j++) {
        for (int i = 0; i < ROUND; i++) {
            int a = ROUND * j + i + 1, b = ROUND * j + (i + 1) % ROUND + 1;
            int quad[4] = {a, b, b + ROUND, a + ROUND};
            fputs("f", file);
            for (int k = 0; k < 4; k++)
                fprintf(file, normals ? " %d//%d" : " %d", quad[k], quad[k]);
            fputs("\n", file);
        }
    }
    assert_int_equal(fclose(file), 0);
}

static const char cube_view[] = "--perspective --fov 60 --size 120x120 --camera 2.5,2,3 "
                                "--look 0,0,0";

static struct picture run(const char *view, const char *model)
{
    char command[300];

    snprintf(command, sizeof command, "%s %s", view, model);
    return demo_run_pfm(&process, command);
}

static void a_cube_has_three_sides_of_one_brightness_each(void **state)
{
    /* Pixels well inside of the three sides that are seen. */
    static const int sides[3][2][2] = {
        {{35, 65}, {55, 45}}, {{75, 60}, {85, 65}}, {{50, 79}, {70, 81}}};
    struct picture picture;
    double brightness[3];

    (void)state;
    write_cube_obj("cube.obj", 0);
    picture = run(cube_view, "cube.obj");
    for (int i = 0; i < 3; i++) {
        const int(*at)[2] = sides[i];
        brightness[i] = (double)picture_pixel(&picture, at[0][0], at[0][1])[1];
        /* The lamp at the eye alone changes over a side. */
        check_near(picture_pixel(&picture, at[1][0], at[1][1])[1], brightness[i], 0.02);
    }
    for (int i = 0; i < 3; i++)
        check_at_least(fabs(brightness[i] - brightness[(i + 1) % 3]), 0.04);
    cupola_image_free(&picture.rgba);
}

static void winding_and_shared_vertices_do_not_change_the_light(void **state)
{
    struct picture picture, other;

    (void)state;
    write_cube_obj("cube.obj", 0);
    write_cube_obj("turned.obj", 0xfff);
    write_cube_obj("mixed.obj", 0x635);
    write_cube_ply("cube.ply");
    picture = run(cube_view, "cube.obj");
    for (int i = 0; i < 3; i++) {
        static const char *const others[] = {"turned.obj", "mixed.obj", "cube.ply"};
        other = run(cube_view, others[i]);
        check_at_most(picture_difference(&picture, &other), 0.005);
        cupola_image_free(&other.rgba);
    }
    cupola_image_free(&picture.rgba);
}

/* Pixels of the model that differ much from the one to the right or above. */
static int count_steps(const struct picture *lit, const struct picture *flat)
{
    int steps = 0;

    for (int y = 0; y + 1 < lit->height; y++) {
        for (int x = 0; x + 1 < lit->width; x++) {
            float here = picture_pixel(lit, x, y)[1];
            if (picture_pixel(flat, x, y)[1] <= 0)
                continue;
            if (picture_pixel(flat, x + 1, y)[1] > 0)
                steps += fabsf(picture_pixel(lit, x + 1, y)[1] - here) > 0.08f;
            if (picture_pixel(flat, x, y + 1)[1] > 0)
                steps += fabsf(picture_pixel(lit, x, y + 1)[1] - here) > 0.08f;
        }
    }
    return steps;
}

static void a_sphere_is_smooth_up_to_its_outline(void **state)
{
    static const char view[] = "--perspective --fov 60 --size 160x160 --camera 0.5,0.7,2.4 "
                               "--look 0,0,0";
    struct picture flat, lit;

    (void)state;
    write_sphere_obj("flat.obj", 0);
    flat = run(view, "--flat flat.obj");
    for (int normals = -1; normals <= 1; normals++) {
        write_sphere_obj("sphere.obj", normals);
        lit = run(view, "sphere.obj");
        /* Between two triangles the back of the sphere may show in a pixel or two. */
        check_at_most(count_steps(&lit, &flat), 6);
        cupola_image_free(&lit.rgba);
    }
    cupola_image_free(&flat.rgba);
}

/* A wall of pure red at x from -3 to 3, y from -3 to 3, z = -2. */
static const char wall[] = "mtllib wall.mtl\nusemtl red\nv -3 -3 -2\nv 3 -3 -2\nv 3 3 -2\n"
                           "v -3 3 -2\nf 1 2 3\nf 1 3 4\n";

static void a_model_stands_where_its_coordinates_say(void **state)
{
    struct picture picture;

    (void)state;
    process_write_file("wall.obj", wall);
    process_write_file("wall.mtl", "newmtl red\nKd 1 0 0\n");
    picture = demo_run_pfm(&process, "wall.obj --flat --camera 0,0,0 --size 100x100");
    assert_string_equal(process.out, "");
    /* The wall's right edge is atan(3 / 2) = 56.3 degrees off the axis: at 81.3 px. */
    check_near((double)picture_pixel(&picture, 79, 50)[0], 1, 1e-6);
    check_near((double)picture_pixel(&picture, 79, 50)[1], 0, 1e-6);
    check_at_most((double)picture_pixel(&picture, 83, 50)[0], 0.9);
    cupola_image_free(&picture.rgba);

    picture = demo_run_pfm(&process, "wall.obj --flat --size 32x32");
    assert_memory_equal(process.out, "camera ", 7);
    cupola_image_free(&picture.rgba);
}

int main(void)
{
    const struct CMUnitTest models[] = {
        cmocka_unit_test(a_model_stands_where_its_coordinates_say),
        cmocka_unit_test(a_cube_has_three_sides_of_one_brightness_each),
        cmocka_unit_test(winding_and_shared_vertices_do_not_change_the_light),
        cmocka_unit_test(a_sphere_is_smooth_up_to_its_outline),
    };
    return cmocka_run_group_tests(models, process_enter_directory, process_leave_directory);
}
