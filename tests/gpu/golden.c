/*
 * Small pictures of whole theatres, kept in tests/golden. A picture that differs fails, and the
 * shot and the difference (grey where there is none, eightfold) are written into the folder
 * GOLDEN_OUTPUT and named.
 *
 * To make them anew after a wished change: CUPOLA_GOLDEN_WRITE=FOLDER writes all of them there and
 * compares nothing. Look at each before it is kept.
 */
#include <stdio.h>
#include <stdlib.h>

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb_image.h>

#include "cupola/image_file.h"
#include "group.h"
#include "rig_random.h"

/*
 * Shot minus golden picture, of 255, per channel: filters with weights of 8 bits and renderers that
 * round in other places differ by up to 1 in the views and 1 in the warp. Views are three times as
 * dense as need be, so that a plan that lays their texels elsewhere changes nothing else.
 */
static const int least_difference = -3, most_difference = 3;

struct picture {
    const char *name;
    void (*arrange)(struct cupola_rig *rig, struct cupola_plan_params *plan,
                    struct cupola_gl_params *gl);
};

static void arrange_domemaster(struct cupola_rig *rig, struct cupola_plan_params *plan,
                               struct cupola_gl_params *gl)
{
    (void)plan;
    (void)gl;
    assert_int_equal(cupola_rig_preset("domemaster", rig, NULL), CUPOLA_OK);
    assert_int_equal(cupola_output_resize(&rig->outputs[0], 256, 256, NULL), CUPOLA_OK);
}

static void arrange_visionstation(struct cupola_rig *rig, struct cupola_plan_params *plan,
                                  struct cupola_gl_params *gl)
{
    (void)gl;
    assert_int_equal(cupola_rig_preset("visionstation", rig, NULL), CUPOLA_OK);
    assert_int_equal(cupola_output_resize(&rig->outputs[0], 256, 192, NULL), CUPOLA_OK);
    plan->rotation_in_projection = true;
}

/* Eye and projector off the centre, a rim of its own colour, every table in the shader. */
static void arrange_off_axis(struct cupola_rig *rig, struct cupola_plan_params *plan,
                             struct cupola_gl_params *gl)
{
    static const float border[4] = {0.3f, 0.3f, 0.5f, 1.0f};
    *rig = plain_rig(CUPOLA_LENS_EQUISOLID, 200.0, 256);
    rig->eye_m[0] = 0.4;
    rig->eye_m[1] = -0.2;
    rig->outputs[0].position_m[0] = -0.3;
    rig->outputs[0].position_m[2] = 0.3;
    rig->outputs[0].aim = (struct cupola_aim){0.2, 0.1, -0.3};
    rig->screen.cap_rad = radians(80.0);
    plan->layout = CUPOLA_LAYOUT_ROTATED;
    plan->views = 5;
    gl->table = CUPOLA_TABLE_NONE;
    memcpy(gl->border, border, sizeof border);
}

/* Mirrored for rear projection; three views on one plane, finished coordinates. */
static void arrange_mirrored(struct cupola_rig *rig, struct cupola_plan_params *plan,
                             struct cupola_gl_params *gl)
{
    *rig = plain_rig(CUPOLA_LENS_POLYNOMIAL, 140.0, 256);
    rig->outputs[0].lens.k[0] = 1.0;
    rig->outputs[0].lens.k[1] = -0.05;
    rig->outputs[0].flip = CUPOLA_FLIP_X;
    rig->tilt_rad = radians(20.0);
    plan->layout = CUPOLA_LAYOUT_ASYMMETRIC;
    plan->views = 3;
    gl->table = CUPOLA_TABLE_COORDINATES;
}

static const struct picture pictures[] = {
    {"domemaster", arrange_domemaster},
    {"visionstation", arrange_visionstation},
    {"off_axis", arrange_off_axis},
    {"mirrored", arrange_mirrored},
};

enum { PICTURES = sizeof pictures / sizeof pictures[0], PATH_MAX_HERE = 1024 };

struct shot {
    float *rgba;
    int width, height;
};

/* The room in a picture's theatre; `turned_rad` turns its projector. */
static struct shot take(const struct picture *picture, double turned_rad)
{
    struct cupola_rig rig = {.output_count = 1};
    struct cupola_plan_params plan = {.density = 3.0};
    struct cupola_gl_params gl = {.border = {0}};
    struct fixture fixture;
    picture->arrange(&rig, &plan, &gl);
    rig.outputs[0].aim.yaw_rad += turned_rad;
    fixture_make(&rig, &plan, &gl, &fixture);
    fixture_paint(&fixture, PAINT_ROOM);
    const struct cupola_output *output = fixture_output(&fixture, 0);
    struct shot shot = {fixture_warp(&fixture, 0), output->width_px, output->height_px};
    fixture_release(&fixture);
    return shot;
}

static const char *folder(const char *variable)
{
    const char *value = getenv(variable);
    if (!value)
        fail_msg("the environment has no %s", variable);
    return value;
}

static void path_of(char path[PATH_MAX_HERE], const char *folder, const char *name,
                    const char *kind)
{
    int length = snprintf(path, PATH_MAX_HERE, "%s/%s%s.png", folder, name, kind);
    assert_true(length > 0 && length < PATH_MAX_HERE);
}

static void write_png(const char *path, const float *rgba, int width, int height)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    if (cupola_png_write(path, rgba, width, height, &error) < 0)
        fail_msg("%s", error.message);
}

/* A kept picture as RGBA floats, rows from the bottom up. */
static float *read_png(const char *path, const struct shot *shot)
{
    int width = 0, height = 0, channels = 0;
    stbi_set_flip_vertically_on_load(1);
    unsigned char *bytes = stbi_load(path, &width, &height, &channels, 4);
    if (!bytes)
        fail_msg("%s: %s", path, stbi_failure_reason());
    if (width != shot->width || height != shot->height)
        fail_msg("%s is %d x %d px, the shot %d x %d", path, width, height, shot->width,
                 shot->height);
    float *rgba = malloc(4 * sizeof *rgba * (size_t)width * (size_t)height);
    assert_non_null(rgba);
    for (int i = 0; i < 4 * width * height; i++)
        rgba[i] = (float)bytes[i] / 255.0f;
    stbi_image_free(bytes);
    return rgba;
}

/* Colour channels outside of the tolerance; *difference becomes the picture of them. */
static int count_wrong(const struct shot *shot, const float *golden, float *difference)
{
    int wrong = 0;
    for (int i = 0; i < 4 * shot->width * shot->height; i++) {
        double off = round(255.0 * (double)shot->rgba[i]) - round(255.0 * (double)golden[i]);
        difference[i] = (float)(0.5 + 8.0 * off / 255.0);
        if (i % 4 != 3 && !(off >= least_difference && off <= most_difference))
            wrong++;
    }
    return wrong;
}

/* Writes shot and difference and names them. */
static void report(const struct picture *picture, const struct shot *shot, const float *difference,
                   const char *golden_path, int wrong)
{
    char shot_path[PATH_MAX_HERE], difference_path[PATH_MAX_HERE];
    path_of(shot_path, folder("GOLDEN_OUTPUT"), picture->name, "-shot");
    path_of(difference_path, folder("GOLDEN_OUTPUT"), picture->name, "-difference");
    write_png(shot_path, shot->rgba, shot->width, shot->height);
    write_png(difference_path, difference, shot->width, shot->height);
    print_error("%d values of %s differ by less than %d or more than %d from %s; see %s and %s\n",
                wrong, picture->name, least_difference, most_difference, golden_path, shot_path,
                difference_path);
}

/* Values outside of the tolerance in a picture whose projector is turned; reported if wished. */
static int compare(const struct picture *picture, double turned_rad, bool reported)
{
    char path[PATH_MAX_HERE];
    struct shot shot = take(picture, turned_rad);
    path_of(path, folder("GOLDEN_PICTURES"), picture->name, "");
    float *golden = read_png(path, &shot);
    float *difference = malloc(4 * sizeof *difference * (size_t)shot.width * (size_t)shot.height);
    assert_non_null(difference);
    int wrong = count_wrong(&shot, golden, difference);
    if (wrong > 0 && reported)
        report(picture, &shot, difference, path, wrong);
    free(difference);
    free(golden);
    free(shot.rgba);
    return wrong;
}

static void pictures_are_those_that_were_looked_at(void **state)
{
    (void)state;
    int wrong = 0;
    for (int i = 0; i < PICTURES; i++)
        wrong += compare(&pictures[i], 0.0, true);
    assert_int_equal(wrong, 0);
}

static void a_projector_turned_by_a_tenth_of_a_degree_is_caught(void **state)
{
    (void)state;
    for (int i = 0; i < PICTURES; i++)
        check_at_least(compare(&pictures[i], radians(0.1), false), 100);
}

static void write_pictures(void **state)
{
    (void)state;
    for (int i = 0; i < PICTURES; i++) {
        char path[PATH_MAX_HERE];
        struct shot shot = take(&pictures[i], 0.0);
        path_of(path, folder("CUPOLA_GOLDEN_WRITE"), pictures[i].name, "");
        write_png(path, shot.rgba, shot.width, shot.height);
        printf("%s\n", path);
        free(shot.rgba);
    }
}

int main(void)
{
    const struct CMUnitTest writing[] = {cmocka_unit_test(write_pictures)};
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_are_those_that_were_looked_at),
        cmocka_unit_test(a_projector_turned_by_a_tenth_of_a_degree_is_caught),
    };
    if (getenv("CUPOLA_GOLDEN_WRITE"))
        return run_gpu_group("golden", writing);
    return run_gpu_group("golden", tests);
}
