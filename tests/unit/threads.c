/*
 * Eight threads ask one dome and one plan, and read and write files, at the same time: each gets
 * what one thread alone gets, bit for bit. Under -Db_sanitize=thread this is also the proof that
 * nothing is shared.
 */
#define _XOPEN_SOURCE 700 /* folder.h */
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "cupola/cupola.h"
#include "cupola/image_file.h"
#include "cupola/rig_file.h"
#include "folder.h"
#include "rig_random.h"

enum { THREADS = 8, ROUNDS = 3, PLACES = 400, SIDE_PX = 48 };

/* All that is shared, and never changes. */
struct shared {
    struct cupola_rig rig;
    struct cupola_lens lenses[6];
    cupola_dome *dome;
    cupola_plan *plan;
    float *atlas;
};

/* All answers; zeroed before, so that padding compares equal. */
struct answers {
    struct cupola_ray rays[PLACES];
    double pixels[PLACES][2];
    int views[PLACES];
    double texels[PLACES][2];
    struct cupola_camera cameras[CUPOLA_VIEWS_MAX];
    double lens_radius[6][32], lens_angle[6][32];
    float image[4 * SIDE_PX * SIDE_PX];
    float file_image[4 * SIDE_PX * SIDE_PX];
    char rig_text[8192];
    char message[1024];
    double plan_texels, plan_opening_rad;
};

struct worker {
    const struct shared *shared;
    struct answers answers;
    char path[512];
    int failed; /* cmocka's assertions belong to the main thread */
};

static void color_of(const double direction[3], float rgba[4], void *user)
{
    (void)user;
    for (int i = 0; i < 3; i++)
        rgba[i] = (float)direction[i];
    rgba[3] = 1;
}

static void ask_dome(struct worker *worker)
{
    const struct shared *shared = worker->shared;
    struct answers *answers = &worker->answers;
    uint64_t seed = 7;
    for (int i = 0; i < PLACES; i++) {
        struct cupola_ray *ray = &answers->rays[i];
        double x = random_between(&seed, 0, SIDE_PX), y = random_between(&seed, 0, SIDE_PX);
        worker->failed |= cupola_dome_ray(shared->dome, 0, NULL, x, y, ray) < 0;
        worker->failed |=
            cupola_dome_pixel(shared->dome, 0, NULL, ray->direction, answers->pixels[i]) < 0;
        answers->views[i] = cupola_plan_select(shared->plan, ray->direction);
        worker->failed |= cupola_plan_texel(shared->plan, answers->views[i], ray->direction,
                                            answers->texels[i]) != 1;
    }
}

static void ask_lenses(struct worker *worker)
{
    for (int model = 0; model < 6; model++)
        for (int i = 0; i < 32; i++) {
            const struct cupola_lens *lens = &worker->shared->lenses[model];
            worker->answers.lens_radius[model][i] = cupola_lens_radius(lens, 0.04 * i);
            worker->answers.lens_angle[model][i] = cupola_lens_angle(lens, i / 31.0);
        }
}

/* A dome and a plan of the thread's own. */
static void plan_anew(struct worker *worker)
{
    cupola_dome *dome = NULL;
    cupola_plan *plan = NULL;
    if (cupola_dome_create(&worker->shared->rig, &dome, NULL) != CUPOLA_OK ||
        cupola_plan_create(dome, NULL, &plan, NULL) != CUPOLA_OK) {
        worker->failed = 1;
    } else {
        worker->answers.plan_texels = cupola_plan_report(plan)->texels_shaded_per_pixel;
        worker->answers.plan_opening_rad = cupola_plan_report(plan)->seen_fov_rad;
    }
    cupola_plan_destroy(&plan);
    cupola_dome_destroy(&dome);
}

static void warp(struct worker *worker)
{
    const struct shared *shared = worker->shared;
    for (int i = 0; i < cupola_plan_view_count(shared->plan); i++)
        worker->failed |= cupola_plan_camera(shared->plan, i, NULL, &worker->answers.cameras[i],
                                             NULL) != CUPOLA_OK;
    worker->failed |= cupola_reference_warp(shared->plan, 0, shared->atlas, NULL,
                                            worker->answers.image) != CUPOLA_OK;
}

static void use_rig_files(struct worker *worker)
{
    struct cupola_rig read, parsed;
    struct cupola_error error = {CUPOLA_OK, ""};
    FILE *file;
    worker->failed |= cupola_rig_write(worker->path, &worker->shared->rig, NULL) != CUPOLA_OK ||
                      cupola_rig_read(worker->path, NULL, &read, NULL) != CUPOLA_OK ||
                      cupola_rig_complete(&read, &read, NULL) != CUPOLA_OK ||
                      cupola_rig_write(worker->path, &read, NULL) != CUPOLA_OK;
    if (worker->failed || !(file = fopen(worker->path, "r")))
        return;
    fread(worker->answers.rig_text, 1, sizeof worker->answers.rig_text - 1, file);
    fclose(file);
    worker->failed |=
        cupola_rig_parse(worker->answers.rig_text, NULL, NULL, &parsed, NULL) != CUPOLA_OK ||
        cupola_rig_parse("tilt_deg = 500;", NULL, NULL, &parsed, &error) != CUPOLA_ERROR_ARGUMENT;
    strcpy(worker->answers.message, error.message);
}

static void use_image_files(struct worker *worker)
{
    float *rgba = NULL;
    int width, height;
    worker->failed |= cupola_png_write(worker->path, worker->answers.image, SIDE_PX, SIDE_PX,
                                       NULL) != CUPOLA_OK ||
                      cupola_pfm_write(worker->path, worker->answers.image, SIDE_PX, SIDE_PX,
                                       NULL) != CUPOLA_OK ||
                      cupola_pfm_read(worker->path, &rgba, &width, &height, NULL) != CUPOLA_OK;
    if (rgba)
        memcpy(worker->answers.file_image, rgba, sizeof worker->answers.file_image);
    cupola_image_free(&rgba);
}

static void *work(void *user)
{
    struct worker *worker = user;
    for (int round = 0; round < ROUNDS && !worker->failed; round++) {
        ask_dome(worker);
        ask_lenses(worker);
        warp(worker);
        use_rig_files(worker);
        use_image_files(worker);
    }
    plan_anew(worker);
    return NULL;
}

static void make_shared(struct shared *shared)
{
    uint64_t seed = 3;
    shared->rig = random_rig(&seed, 0.5);
    shared->rig.outputs[0].width_px = shared->rig.outputs[0].height_px = SIDE_PX;
    shared->rig.outputs[0].circle.radius_px = 0;
    for (int model = 0; model < 6; model++)
        shared->lenses[model] = random_lens(&seed, (enum cupola_lens_model)model, radians(150));
    assert_int_equal(cupola_dome_create(&shared->rig, &shared->dome, NULL), CUPOLA_OK);
    assert_int_equal(cupola_plan_create(shared->dome, NULL, &shared->plan, NULL), CUPOLA_OK);
    const struct cupola_plan_report *report = cupola_plan_report(shared->plan);
    size_t texels = (size_t)report->atlas_width_px * (size_t)report->atlas_height_px;
    shared->atlas = calloc(4 * texels, sizeof *shared->atlas);
    assert_non_null(shared->atlas);
    assert_int_equal(cupola_reference_views(shared->plan, color_of, NULL, shared->atlas),
                     CUPOLA_OK);
}

static void eight_threads_get_what_one_gets(void **state)
{
    (void)state;
    static struct shared shared;
    static struct worker alone, workers[THREADS];
    pthread_t threads[THREADS];
    make_shared(&shared);
    alone.shared = &shared;
    snprintf(alone.path, sizeof alone.path, "%s", in_folder("alone"));
    work(&alone);
    assert_int_equal(alone.failed, 0);
    for (int i = 0; i < THREADS; i++) {
        workers[i].shared = &shared;
        snprintf(workers[i].path, sizeof workers[i].path, "%s/thread-%d", folder, i);
        assert_int_equal(pthread_create(&threads[i], NULL, work, &workers[i]), 0);
    }
    for (int i = 0; i < THREADS; i++)
        assert_int_equal(pthread_join(threads[i], NULL), 0);
    for (int i = 0; i < THREADS; i++) {
        assert_int_equal(workers[i].failed, 0);
        assert_memory_equal(&workers[i].answers, &alone.answers, sizeof alone.answers);
    }
    free(shared.atlas);
    cupola_plan_destroy(&shared.plan);
    cupola_dome_destroy(&shared.dome);
}

int main(void)
{
    const struct CMUnitTest threads[] = {
        cmocka_unit_test(eight_threads_get_what_one_gets),
    };
    return cmocka_run_group_tests(threads, make_folder, remove_folder);
}
