/*
 * Memory that runs out at any moment: the first, second, ... allocation of a call fails until the
 * call succeeds. Each failure says so, frees what it had, changes nothing and leaves no file.
 *
 * The linker puts the functions below in the place of those that the library calls (--wrap, see
 * meson.build), so this works under AddressSanitizer too, which sees the leaks. Out of reach:
 *   - what libconfig allocates: 1.5 uses it without looking, nothing above it could help;
 *   - what libc allocates inside of other calls (the growth of a stream in memory, fopen's buffer);
 *     the calls themselves are made to fail instead;
 *   - stb_image_write: it gets all its memory from one block, which is allocated beforehand.
 */
#define _XOPEN_SOURCE 700 /* folder.h */
#include <errno.h>
#include <locale.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "cupola/image_file.h"
#include "cupola/plan.h"
#include "cupola/reference.h"
#include "cupola/resolution.h"
#include "cupola/rig_file.h"
#include "folder.h"

static int to_go;           /* allocations up to the one that fails; 0: none will, or it has */
static int expected_status; /* of the call in which it failed */

static int runs_out(int status)
{
    if (to_go == 0 || --to_go > 0)
        return 0;
    expected_status = status;
    errno = ENOMEM;
    return 1;
}

#define WRAP(type, status, name, parameters, arguments)                                            \
    type __real_##name parameters;                                                                 \
    type __wrap_##name parameters;                                                                 \
    type __wrap_##name parameters                                                                  \
    {                                                                                              \
        return runs_out(status) ? 0 : __real_##name arguments;                                     \
    }

WRAP(void *, CUPOLA_ERROR_MEMORY, malloc, (size_t size), (size))
WRAP(void *, CUPOLA_ERROR_MEMORY, calloc, (size_t count, size_t size), (count, size))
WRAP(void *, CUPOLA_ERROR_MEMORY, realloc, (void *block, size_t size), (block, size))
WRAP(char *, CUPOLA_ERROR_MEMORY, strdup, (const char *text), (text))
WRAP(FILE *, CUPOLA_ERROR_MEMORY, open_memstream, (char **text, size_t *size), (text, size))
WRAP(locale_t, CUPOLA_ERROR_MEMORY, newlocale, (int mask, const char *name, locale_t base),
     (mask, name, base))
/* These fail for many reasons and are reported with that which they give. */
WRAP(FILE *, CUPOLA_ERROR_FILE, fdopen, (int fd, const char *mode), (fd, mode))
WRAP(char *, CUPOLA_ERROR_FILE, realpath, (const char *path, char *resolved), (path, resolved))

enum { SIDE_PX = 4 };

static cupola_dome *dome;
static float picture[4 * SIDE_PX * SIDE_PX];

static int make_all(void **state)
{
    struct cupola_rig rig = {.outputs[0] = {.width_px = 24, .height_px = 24}};
    if (make_folder(state) != 0 || cupola_dome_create(&rig, &dome, NULL) != CUPOLA_OK)
        return -1;
    for (int i = 0; i < 4 * SIDE_PX * SIDE_PX; i++)
        picture[i] = 0.01f * (float)i;
    return 0;
}

static int remove_all(void **state)
{
    cupola_dome_destroy(&dome);
    return remove_folder(state);
}

/*
 * A call, made again and again: succeeds in the end, and before fails as its allocation did. The
 * file of the call, if it has one, stays what it was. Returns how many allocations could fail.
 */
static int try_each_allocation(int (*call)(const char *path, struct cupola_error *error),
                               const char *path)
{
    enum { MANY = 2000 };
    for (int n = 1; n < MANY; n++) {
        struct cupola_error error = {CUPOLA_OK, ""};
        char *before = path ? content_of(path) : NULL;
        int entries = entries_in_folder();
        to_go = n;
        int status = call(path, &error);
        int reached = to_go == 0;
        to_go = 0;
        if (!reached) {
            free(before);
            assert_int_equal(status, CUPOLA_OK);
            return n - 1;
        }
        if (status != expected_status)
            fail_msg("allocation %d: status %d instead of %d: %s", n, status, expected_status,
                     error.message);
        assert_int_equal(error.status, status);
        assert_true(error.message[0] != 0);
        assert_int_equal(entries_in_folder(), entries);
        char *after = path ? content_of(path) : NULL;
        if (path)
            assert_string_equal(after, before);
        free(before);
        free(after);
    }
    fail_msg("still fails at allocation %d", MANY);
    return 0;
}

static int create_dome(const char *path, struct cupola_error *error)
{
    (void)path;
    cupola_dome *made = NULL;
    struct cupola_rig rig = {.tilt_rad = 1};
    int status = cupola_dome_create(&rig, &made, error);
    assert_int_equal(made != NULL, status == CUPOLA_OK);
    cupola_dome_destroy(&made);
    return status;
}

static int create_plan(enum cupola_layout layout, int views, struct cupola_error *error)
{
    cupola_plan *made = NULL;
    struct cupola_plan_params params = {.layout = layout, .views = views};
    int status = cupola_plan_create(dome, &params, &made, error);
    assert_int_equal(made != NULL, status == CUPOLA_OK);
    cupola_plan_destroy(&made);
    return status;
}

static int create_usual_plan(const char *path, struct cupola_error *error)
{
    (void)path;
    return create_plan(CUPOLA_LAYOUT_AUTO, 3, error);
}

static cupola_plan *measured_plan;

/* Has no message of its own. */
static int warp_in_c(const char *path, struct cupola_error *error)
{
    (void)path;
    enum { TEXELS_MAX = 128 * 128 };
    static float atlas[4 * TEXELS_MAX], image[4 * 24 * 24];
    const struct cupola_plan_report *report = cupola_plan_report(measured_plan);
    assert_true(report->atlas_width_px * report->atlas_height_px <= TEXELS_MAX);
    for (int i = 0; i < 4 * 24 * 24; i++)
        image[i] = 7.0f;
    int status = cupola_reference_filter(measured_plan, 0, NULL, atlas, NULL, image);
    error->status = (enum cupola_status)status;
    snprintf(error->message, sizeof error->message, "%s", cupola_status_text(status));
    for (int i = 0; i < 4 * 24 * 24 && status != CUPOLA_OK; i++)
        assert_true(image[i] == 7.0f);
    return status;
}

static int measure_resolution(const char *path, struct cupola_error *error)
{
    (void)path;
    struct cupola_resolution resolution = {.views = -7};
    int status = cupola_resolution_measure(measured_plan, 0, &resolution, error);
    assert_int_equal(resolution.views == -7, status != CUPOLA_OK);
    return status;
}

static void fill(struct cupola_rig *rig)
{
    memset(rig, 0x5a, sizeof *rig);
}

static void check_filled(const struct cupola_rig *rig, int status)
{
    struct cupola_rig untouched;
    fill(&untouched);
    assert_int_equal(memcmp(rig, &untouched, sizeof untouched) == 0, status != CUPOLA_OK);
}

static int parse_rig(const char *path, struct cupola_error *error)
{
    (void)path;
    struct cupola_rig rig;
    fill(&rig);
    int status = cupola_rig_parse("tilt_deg = 30;", NULL, NULL, &rig, error);
    check_filled(&rig, status);
    return status;
}

static int read_rig(const char *path, struct cupola_error *error)
{
    struct cupola_rig rig;
    fill(&rig);
    int status = cupola_rig_read(path, NULL, &rig, error);
    check_filled(&rig, status);
    return status;
}

static int write_rig(const char *path, struct cupola_error *error)
{
    struct cupola_rig rig = {.tilt_rad = 0.5};
    return cupola_rig_write(path, &rig, error);
}

static int write_png(const char *path, struct cupola_error *error)
{
    return cupola_png_write(path, picture, SIDE_PX, SIDE_PX, error);
}

static int write_pfm(const char *path, struct cupola_error *error)
{
    return cupola_pfm_write(path, picture, SIDE_PX, SIDE_PX, error);
}

static int read_pfm(const char *path, struct cupola_error *error)
{
    float *rgba = NULL;
    int width = -7, height = -7;
    int status = cupola_pfm_read(path, &rgba, &width, &height, error);
    assert_int_equal(rgba != NULL, status == CUPOLA_OK);
    assert_int_equal(width, status == CUPOLA_OK ? SIDE_PX : -7);
    assert_int_equal(height, status == CUPOLA_OK ? SIDE_PX : -7);
    cupola_image_free(&rgba);
    return status;
}

static void domes_and_plans_survive(void **state)
{
    (void)state;
    check_at_least(try_each_allocation(create_dome, NULL), 1);
    check_at_least(try_each_allocation(create_usual_plan, NULL), 10);
    assert_int_equal(cupola_plan_create(dome, NULL, &measured_plan, NULL), CUPOLA_OK);
    check_at_least(try_each_allocation(measure_resolution, NULL), 7);
    check_at_least(try_each_allocation(warp_in_c, NULL), 1);
    cupola_plan_destroy(&measured_plan);
}

static void rig_files_survive(void **state)
{
    (void)state;
    const char *path = in_folder("rig.cfg");
    char kept[512];
    snprintf(kept, sizeof kept, "%s", path);
    check_at_least(try_each_allocation(parse_rig, NULL), 3);
    check_at_least(try_each_allocation(write_rig, kept), 4); /* a new file */
    check_at_least(try_each_allocation(write_rig, kept), 8); /* with a backup, itself new */
    check_at_least(try_each_allocation(write_rig, kept), 8);
    check_at_least(try_each_allocation(read_rig, kept), 4);
}

static void pictures_survive(void **state)
{
    (void)state;
    char png[512], pfm[512];
    snprintf(png, sizeof png, "%s", in_folder("picture.png"));
    snprintf(pfm, sizeof pfm, "%s", in_folder("picture.pfm"));
    for (int i = 0; i < 2; i++) {
        check_at_least(try_each_allocation(write_png, png), 4);
        check_at_least(try_each_allocation(write_pfm, pfm), 3);
    }
    check_at_least(try_each_allocation(read_pfm, pfm), 3);
}

int main(void)
{
    const struct CMUnitTest allocations[] = {
        cmocka_unit_test(domes_and_plans_survive),
        cmocka_unit_test(rig_files_survive),
        cmocka_unit_test(pictures_survive),
    };
    return cmocka_run_group_tests(allocations, make_all, remove_all);
}
