/*
 * The demo's scenes in one pass over all views: what they show view by view. Floats may differ in
 * their last digits, and single pixels at outlines, where a GL rounds a vertex's place otherwise.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cupola/image_file.h>

#include "check.h"
#include "demo_picture.h"

static struct process process;

static const char *const scenes[] = {
    "--scene cube --fov 180 --views 4",
    "--scene cube --fov 140 --layout asymmetric --depth reversed --viewer 0.2,0.1,0",
    "--scene forest --triangles 5000",
    "--scene screen --viewer 0.3,0,0 --tilt 20",
    "tent.obj --camera 0,0.5,3 --look 0,0,0",
    "--scene cube --shading heavy --preset domemaster --size 64x64",
    "--scene forest --triangles 5000 --msaa 4 --shading flat --views-only",
    "--scene directions",
    "tent.obj --camera 0,0.5,3 --look 0,0,0 --flat --depth reversed",
};

enum { SCENES = sizeof scenes / sizeof scenes[0], FEW = 5 };

static struct picture draw(const char *scene, const char *submission)
{
    char command[300];

    snprintf(command, sizeof command, "--size 96x96 %s --submission %s", scene, submission);
    return demo_run_pfm(&process, command);
}

static void check_scenes(int count)
{
    for (int i = 0; i < count; i++) {
        struct picture looped = draw(scenes[i], "loop"), once = draw(scenes[i], "once");
        int pixels = looped.width * looped.height;
        check_at_most(picture_others(&looped, &once, 0, 0), pixels / 2000);
        cupola_image_free(&looped.rgba);
        cupola_image_free(&once.rgba);
    }
}

static void write_tent(void)
{
    process_write_file("tent.obj", "v -1 -1 1\nv 1 -1 1\nv 0 1 0\nv 1 -1 -1\nv -1 -1 -1\n"
                                   "f 1 2 3\nf 2 4 3\nf 4 5 3\nf 5 1 3\nf 1 2 4\nf 1 4 5\n");
}

static void one_pass_shows_what_a_loop_shows(void **state)
{
    (void)state;
    write_tent();
    check_scenes(SCENES);
    /* The control: pictures that differ are seen to. */
    struct picture one = draw("--scene forest --triangles 5000", "once");
    struct picture other = draw("--scene forest --triangles 5000 --seed 1", "once");
    check_at_least(picture_others(&one, &other, 0, 0), 100);
    cupola_image_free(&one.rgba);
    cupola_image_free(&other.rgba);
}

/* Mesa understands the wish; on other GLs this is the test above once more. */
static void a_geometry_shader_shows_it_too(void **state)
{
    (void)state;
    write_tent();
    setenv("MESA_EXTENSION_OVERRIDE",
           "-GL_ARB_shader_viewport_layer_array -GL_AMD_vertex_shader_viewport_index", 1);
    check_scenes(FEW);
    unsetenv("MESA_EXTENSION_OVERRIDE");
}

static void where_a_gl_cannot_the_demo_loops_and_says_so(void **state)
{
    (void)state;
    setenv("MESA_GL_VERSION_OVERRIDE", "3.3", 1);
    setenv("MESA_GLSL_VERSION_OVERRIDE", "330", 1);
    setenv("MESA_EXTENSION_OVERRIDE", "-GL_ARB_viewport_array", 1);
    process_run(&process, "--size 32x32 --submission once --output x.png", NULL);
    assert_int_equal(process.status, 0);
    if (!strstr(process.err, "one by one"))
        printf("  this GL can\n");
    demo_run(&process, "--size 32x32 --output x.png"); /* without a word */
    demo_run(&process, "--size 32x32 --submission loop --output x.png");
    unsetenv("MESA_GL_VERSION_OVERRIDE");
    unsetenv("MESA_GLSL_VERSION_OVERRIDE");
    unsetenv("MESA_EXTENSION_OVERRIDE");
}

static void wrong_wishes_are_refused(void **state)
{
    (void)state;
    process_run(&process, "--submission twice --output x.png", NULL);
    assert_int_equal(process.status, 2);
    assert_non_null(strstr(process.err, "auto"));
    process_run(&process, "--show x.png --as domemaster --submission once --output y.png", NULL);
    assert_int_equal(process.status, 2);
    assert_non_null(strstr(process.err, "--submission"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_pass_shows_what_a_loop_shows),
        cmocka_unit_test(a_geometry_shader_shows_it_too),
        cmocka_unit_test(where_a_gl_cannot_the_demo_loops_and_says_so),
        cmocka_unit_test(wrong_wishes_are_refused),
    };
    return cmocka_run_group_tests(tests, process_enter_directory, process_leave_directory);
}
