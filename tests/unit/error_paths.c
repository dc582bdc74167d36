/*
 * Failures that no other test meets: each is reported, says what is allowed, and changes nothing.
 * Those of missing memory are in allocations.c, those of files in rig_save.c and image_file.c.
 */
#define _XOPEN_SOURCE 700 /* folder.h */
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

#include "cupola/cupola.h"
#include "cupola/image_file.h"
#include "cupola/rig_file.h"
#include "error.h"
#include "folder.h"

static void check_says(const struct cupola_error *error, int status, const char *what)
{
    assert_true(status < 0);
    assert_int_equal(error->status, status);
    if (!strstr(error->message, what) || strchr(error->message, '\n'))
        fail_msg("'%s' does not say '%s'", error->message, what);
}

static cupola_dome *dome_of(const struct cupola_rig *rig)
{
    cupola_dome *dome = NULL;
    assert_int_equal(cupola_dome_create(rig, &dome, NULL), CUPOLA_OK);
    return dome;
}

static void every_status_has_a_text_of_its_own(void **state)
{
    (void)state;
    assert_string_equal(cupola_status_text(CUPOLA_OK), "success");
    assert_string_equal(cupola_status_text(7), "success");
    for (int a = CUPOLA_ERROR_LOST - 1; a <= CUPOLA_OK; a++)
        for (int b = CUPOLA_ERROR_LOST - 1; b < a; b++)
            assert_string_not_equal(cupola_status_text(a), cupola_status_text(b));
    assert_string_equal(cupola_status_text(-1000), cupola_status_text(CUPOLA_ERROR_LOST - 1));
}

static void the_version_that_runs_is_the_one_compiled_against(void **state)
{
    (void)state;
    char expected[32];
    snprintf(expected, sizeof expected, "%d.%d.%d", CUPOLA_VERSION_MAJOR, CUPOLA_VERSION_MINOR,
             CUPOLA_VERSION_PATCH);
    assert_string_equal(cupola_version(), expected);
}

static void long_messages_are_cut_off(void **state)
{
    (void)state;
    struct cupola_error error = {CUPOLA_OK, ""};
    char name[2000];
    memset(name, 'x', sizeof name);
    name[sizeof name - 1] = 0;
    assert_int_equal(error_set(&error, CUPOLA_ERROR_FILE, "%s", name), CUPOLA_ERROR_FILE);
    assert_int_equal(strlen(error.message), sizeof error.message - 1);
    error_context(&error, "first");
    assert_memory_equal(error.message, "first: xxx", 10);
    assert_int_equal(strlen(error.message), sizeof error.message - 1);
    error_context(&error, "%s", name);
    assert_int_equal(strlen(error.message), sizeof error.message - 1);
    error_context(NULL, "nobody listens");
    assert_int_equal(error_set(NULL, CUPOLA_ERROR_FILE, "nobody listens"), CUPOLA_ERROR_FILE);
}

static void null_is_refused_everywhere(void **state)
{
    (void)state;
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_rig rig = {.output_count = 1};
    struct cupola_camera camera;
    float texel[4];
    double vector[3] = {1, 2, 3}, same[3] = {1, 2, 3};
    cupola_dome *dome = dome_of(&rig);
    cupola_plan *plan = NULL;
    check_says(&error, cupola_dome_create(&rig, NULL, &error), "dome is NULL");
    check_says(&error, cupola_dome_create(NULL, &dome, &error), "rig is NULL");
    check_says(&error, cupola_plan_create(NULL, NULL, &plan, &error), "dome is NULL");
    check_says(&error, cupola_plan_create(dome, NULL, NULL, &error), "plan is NULL");
    check_says(&error, cupola_output_resize(NULL, 2, 2, &error), "output is NULL");
    check_says(&error, cupola_lens_validate(NULL, &error), "lens is NULL");
    check_says(&error, cupola_rig_parse(NULL, NULL, NULL, &rig, &error), "text is NULL");
    check_says(&error, cupola_rig_parse("", NULL, NULL, NULL, &error), "rig is NULL");
    assert_null(plan);
    assert_true(cupola_plan_camera(NULL, 0, NULL, &camera, NULL) == CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_plan_select(NULL, vector), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_plan_texel(NULL, 0, vector, same), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_reference_warp(NULL, 0, texel, NULL, texel), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_reference_views(NULL, NULL, NULL, texel), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_plan_view_count(NULL), 0);
    assert_null(cupola_plan_view(NULL, 0));
    assert_null(cupola_plan_report(NULL));
    assert_null(cupola_plan_dome(NULL));
    assert_null(cupola_dome_rig(NULL));
    cupola_dome_to_camera(NULL, vector, same);
    cupola_dome_from_camera(dome, NULL, same);
    assert_memory_equal(vector, same, sizeof same);
    cupola_dome_destroy(NULL);
    cupola_plan_destroy(NULL);
    cupola_image_free(NULL);
    cupola_dome_destroy(&dome);
    cupola_dome_destroy(&dome);
    assert_null(dome);
}

static void refuse_plan(const struct cupola_rig *rig, const struct cupola_plan_params *params,
                        const char *what)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    cupola_dome *dome = dome_of(rig);
    cupola_plan *plan = NULL;
    check_says(&error, cupola_plan_create(dome, params, &plan, &error), what);
    assert_null(plan);
    cupola_dome_destroy(&dome);
}

static void plans_that_cannot_be_are_refused(void **state)
{
    (void)state;
    struct cupola_rig rig = {.outputs[0] = {.width_px = 64, .height_px = 64}};
    refuse_plan(&rig, &(struct cupola_plan_params){.density = 1, .view_size_px = 64}, "one of");
    refuse_plan(&rig, &(struct cupola_plan_params){.view_size_px = 64, .max_texture_px = 64},
                "up to 64 each way");
    /* Each view fits, all of them do not. */
    refuse_plan(
        &rig,
        &(struct cupola_plan_params){
            .layout = CUPOLA_LAYOUT_ROTATED, .views = 5, .view_size_px = 60, .max_texture_px = 64},
        "do not fit into an atlas");
    refuse_plan(&rig, &(struct cupola_plan_params){.layout = CUPOLA_LAYOUT_ASYMMETRIC},
                "layout rotated can");
}

/* The error says how many would do. */
static void one_view_for_all_directions_is_refused(void **state)
{
    (void)state;
    struct cupola_rig rig = {
        .outputs[0] = {.width_px = 64, .height_px = 64, .lens.fov_rad = 6.283}};
    refuse_plan(&rig, &(struct cupola_plan_params){.layout = CUPOLA_LAYOUT_ROTATED, .views = 1},
                "allowed: at least");
}

/* Whoever looks straight up still has an upright picture: the host's right stays at the right. */
static void a_planetarium_keeps_the_hosts_right(void **state)
{
    (void)state;
    struct cupola_rig rig = {.tilt_rad = 1.5707963267948966,
                             .outputs[0] = {.width_px = 64, .height_px = 64}};
    rig.outputs[0].lens.fov_rad = 1.5;
    cupola_dome *dome = dome_of(&rig);
    cupola_plan *plan = NULL;
    struct cupola_plan_params params = {.layout = CUPOLA_LAYOUT_ASYMMETRIC, .views = 1};
    assert_int_equal(cupola_plan_create(dome, &params, &plan, NULL), CUPOLA_OK);
    const double *rotation = cupola_plan_view(plan, 0)->rotation;
    const double expected[9] = {1, 0, 0, 0, 0, 1, 0, -1, 0};
    for (int i = 0; i < 9; i++)
        check_near(rotation[i], expected[i], 1e-9);
    cupola_plan_destroy(&plan);
    cupola_dome_destroy(&dome);
}

static void a_base_that_is_no_rig_is_refused(void **state)
{
    (void)state;
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_rig base = {.tilt_rad = 100}, rig;
    check_says(&error, cupola_rig_parse("", NULL, &base, &rig, &error), "tilt is 100");
    base = (struct cupola_rig){.eye_m = {0.5, 0, 0}};
    check_says(&error, cupola_rig_parse("screen: { radius_m = 0.25; };", "x", &base, &rig, &error),
               "allowed: inside of the screen sphere");
}

static void pictures_too_large_for_png_are_refused(void **state)
{
    (void)state;
    struct cupola_error error = {CUPOLA_OK, ""};
    float pixel[4] = {0};
    check_says(&error, cupola_png_write(in_folder("x.png"), pixel, 32768, 32768, &error),
               "allowed for PNG: up to 300 million pixels");
    check_says(&error, cupola_png_write(in_folder("x.png"), NULL, 1, 1, &error), "image is NULL");
    check_says(&error, cupola_pfm_write("", pixel, 1, 1, &error), "file name is empty");
    check_says(&error, cupola_pfm_write(in_folder("x.pfm"), pixel, 0, 1, &error), "0 x 1 px");
    assert_int_equal(entries_in_folder(), 0);
}

/* A limit of the file size stands for the full disk, as in rig_save.c. */
static void a_full_disk_leaves_no_picture(void **state)
{
    (void)state;
    enum { SIDE_PX = 256 };
    struct rlimit before, tight;
    struct cupola_error error = {CUPOLA_OK, ""};
    float *rgba = calloc(4 * SIDE_PX * SIDE_PX, sizeof *rgba);
    assert_non_null(rgba);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    tight = before;
    tight.rlim_cur = 40;
    void (*handler)(int) = signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &tight), 0);
    int png = cupola_png_write(in_folder("full.png"), rgba, SIDE_PX, SIDE_PX, &error);
    int pfm = cupola_pfm_write(in_folder("full.pfm"), rgba, SIDE_PX, SIDE_PX, &error);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
    signal(SIGXFSZ, handler);
    free(rgba);
    assert_int_equal(png, CUPOLA_ERROR_FILE);
    check_says(&error, pfm, "File too large");
    assert_int_equal(entries_in_folder(), 0);
}

int main(void)
{
    const struct CMUnitTest error_paths[] = {
        cmocka_unit_test(every_status_has_a_text_of_its_own),
        cmocka_unit_test(the_version_that_runs_is_the_one_compiled_against),
        cmocka_unit_test(long_messages_are_cut_off),
        cmocka_unit_test(null_is_refused_everywhere),
        cmocka_unit_test(plans_that_cannot_be_are_refused),
        cmocka_unit_test(one_view_for_all_directions_is_refused),
        cmocka_unit_test(a_planetarium_keeps_the_hosts_right),
        cmocka_unit_test(a_base_that_is_no_rig_is_refused),
        cmocka_unit_test(pictures_too_large_for_png_are_refused),
        cmocka_unit_test(a_full_disk_leaves_no_picture),
    };
    return cmocka_run_group_tests(error_paths, make_folder, remove_folder);
}
