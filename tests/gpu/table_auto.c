/* The table stage that a cupola_gl chooses: it says which, and nothing of the others stays. */
#include <stdio.h>
#include <stdlib.h>

#include "group.h"
#include "host_objects.h"
#include "hostilities.h"
#include "live_objects.h"
#include "rig_random.h"
#include "worse.h"

enum { NAMES = 4000, RIGS = 3, OUTPUTS = 2 };

/* As of the stages among themselves: tests/gpu/stages.c. */
static const double bar_rad = 1e-5;

struct heard {
    int chosen;
    char text[512];
};

static void listen(int level, int id, const char *text, void *user)
{
    struct heard *heard = user;
    if (id != CUPOLA_LOG_TABLE_CHOSEN)
        return;
    assert_int_equal(level, CUPOLA_LOG_INFO);
    heard->chosen++;
    snprintf(heard->text, sizeof heard->text, "%s", text);
}

static struct cupola_rig rig_number(int number)
{
    uint64_t seed = 9301 + (uint64_t)number;
    struct cupola_rig rig = random_rig(&seed, number % 2 ? 0.5 : 0.0);
    rig.output_count = OUTPUTS;
    for (int i = 0; i < OUTPUTS; i++) {
        rig.outputs[i] = rig.outputs[0];
        rig.outputs[i].width_px = 131 + 20 * i;
        rig.outputs[i].height_px = 122;
        rig.outputs[i].circle = (struct cupola_circle){70.0, 61.0, 58.0};
        rig.outputs[i].aim.yaw_rad *= 0.2;
        rig.outputs[i].lens =
            random_lens(&seed, (enum cupola_lens_model)(number % 6), radians(150.0));
    }
    return rig;
}

static void make(const struct cupola_rig *rig, enum cupola_table table, struct heard *heard,
                 struct fixture *fixture)
{
    struct cupola_gl_params params = {.format = CUPOLA_FORMAT_RGBA32F, .table = table};
    params.log = (struct cupola_log){listen, heard, CUPOLA_LOG_INFO};
    fixture_make(rig, NULL, &params, fixture);
}

static float *image_of(const struct fixture *fixture, int output)
{
    fixture_paint(fixture, PAINT_DIRECTIONS);
    return fixture_warp(fixture, output);
}

static double apart(const struct fixture *fixture, int output, const float *a, const float *b)
{
    const struct cupola_output *size = fixture_output(fixture, output);
    double worst = 0.0;
    for (int i = 0; i < 4 * size->width_px * size->height_px; i++)
        worst = worse_of(worst, fabs((double)a[i] - (double)b[i]));
    return worst;
}

/* The images of a gl that chose, against those of the stage none; control: the other output. */
static void check_images(const struct cupola_rig *rig, const struct fixture *chosen)
{
    struct fixture plain;
    struct heard heard = {0};
    float *found[OUTPUTS], *expected[OUTPUTS];
    make(rig, CUPOLA_TABLE_NONE, &heard, &plain);
    assert_int_equal(heard.chosen, 0);
    for (int i = 0; i < OUTPUTS; i++) {
        assert_int_equal(cupola_gl_table(plain.gl, i), CUPOLA_TABLE_NONE);
        found[i] = image_of(chosen, i);
        expected[i] = image_of(&plain, i);
        check_at_most(apart(&plain, i, found[i], expected[i]), bar_rad);
    }
    check_at_least(apart(&plain, 0, found[1], expected[0]), 100.0 * bar_rad);
    for (int i = 0; i < OUTPUTS; i++) {
        free(found[i]);
        free(expected[i]);
    }
    fixture_release(&plain);
}

static void what_was_chosen_is_told_and_right(void **state)
{
    (void)state;
    for (int number = 0; number < RIGS; number++) {
        struct cupola_rig rig = rig_number(number);
        struct fixture fixture;
        struct heard heard = {0};
        make(&rig, CUPOLA_TABLE_AUTO, &heard, &fixture);
        assert_int_equal(heard.chosen, OUTPUTS);
        for (int i = 0; i < OUTPUTS; i++) {
            int table = cupola_gl_table(fixture.gl, i);
            assert_in_range(table, 0, CUPOLA_TABLE_TILES);
        }
        char words[64];
        snprintf(words, sizeof words, "output %d is warped by table stage %s: ", OUTPUTS - 1,
                 cupola_table_name(cupola_gl_table(fixture.gl, OUTPUTS - 1)));
        assert_int_equal(strncmp(heard.text, words, strlen(words)), 0);
        assert_non_null(strstr(heard.text, " ms"));
        printf("%s\n", heard.text);
        check_images(&rig, &fixture);
        fixture_release(&fixture);
    }
}

static void as_much_stays_as_of_the_stage_that_was_chosen(void **state)
{
    (void)state;
    struct cupola_rig rig = rig_number(1);
    struct fixture fixture;
    struct heard heard = {0};
    make(&rig, CUPOLA_TABLE_AUTO, &heard, &fixture);
    int stages[OUTPUTS], objects = live_objects(NAMES);
    for (int i = 0; i < OUTPUTS; i++)
        stages[i] = cupola_gl_table(fixture.gl, i);
    fixture_release(&fixture);
    int none = live_objects(NAMES);
    check_at_least(objects - none, 5); /* the control: objects are seen */
    if (stages[0] != stages[1])
        return;
    make(&rig, (enum cupola_table)stages[0], &heard, &fixture);
    assert_int_equal(live_objects(NAMES), objects);
    fixture_release(&fixture);
    assert_int_equal(live_objects(NAMES), none);
}

/* Whatever the host has set, all at once. */
static void choosing_leaves_a_hosts_state(void **state)
{
    (void)state;
    struct cupola_rig rig = rig_number(2);
    struct fixture fixture;
    struct heard heard = {0};
    struct snapshot clean, before, after;
    make(&rig, CUPOLA_TABLE_NONE, &heard, &fixture);
    state_reset();
    objects_create();
    state_reset();
    snapshot_take(&clean);
    for (int i = 0; i < HOSTILITIES; i++)
        if (context_has(hostilities[i].gl, hostilities[i].gl_extension, hostilities[i].es,
                        hostilities[i].es_extension))
            hostilities[i].set();
    while (glGetError() != GL_NO_ERROR) /* not all of them go together */
        ;
    snapshot_take(&before);
    assert_int_not_equal(snapshot_differences(&clean, &before, true, NULL), 0);
    struct cupola_gl_params params = {.table = CUPOLA_TABLE_AUTO};
    params.log = (struct cupola_log){listen, &heard, CUPOLA_LOG_INFO};
    cupola_gl *gl = NULL;
    assert_int_equal(cupola_gl_create(fixture.plan, &params, &gl, NULL), CUPOLA_OK);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    snapshot_take(&after);
    assert_int_equal(snapshot_differences(&before, &after, true, "auto"), 0);
    assert_int_equal(heard.chosen, OUTPUTS);
    state_reset();
    cupola_gl_destroy(&gl);
    objects_release();
    fixture_release(&fixture);
}

static void nonsense_has_no_stage(void **state)
{
    (void)state;
    struct cupola_rig rig = rig_number(0);
    struct cupola_gl_params pictures = {.sources = 1u << CUPOLA_SOURCE_DOMEMASTER,
                                        .table = CUPOLA_TABLE_AUTO};
    struct fixture fixture;
    struct heard heard = {0};
    make(&rig, CUPOLA_TABLE_AUTO, &heard, &fixture);
    assert_int_equal(cupola_gl_table(NULL, 0), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_gl_table(fixture.gl, -1), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_gl_table(fixture.gl, OUTPUTS), CUPOLA_ERROR_ARGUMENT);
    fixture_replace_gl(&fixture, &pictures);
    assert_int_equal(cupola_gl_table(fixture.gl, 0), CUPOLA_ERROR_ARGUMENT);
    fixture_release(&fixture);
}

static void with_the_hosts_textures_nothing_is_measured(void **state)
{
    (void)state;
    struct cupola_rig rig = rig_number(0);
    struct heard heard = {0};
    struct cupola_gl_params params = {.storage = CUPOLA_STORAGE_TEXTURES,
                                      .table = CUPOLA_TABLE_AUTO};
    struct fixture fixture;
    params.log = (struct cupola_log){listen, &heard, CUPOLA_LOG_INFO};
    fixture_make(&rig, NULL, &params, &fixture);
    assert_int_equal(cupola_gl_table(fixture.gl, 0), CUPOLA_TABLE_TILES);
    assert_non_null(strstr(heard.text, "nothing was measured"));
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_was_chosen_is_told_and_right),
        cmocka_unit_test(as_much_stays_as_of_the_stage_that_was_chosen),
        cmocka_unit_test(choosing_leaves_a_hosts_state),
        cmocka_unit_test(nonsense_has_no_stage),
        cmocka_unit_test(with_the_hosts_textures_nothing_is_measured),
    };
    return run_gpu_group("table_auto", tests);
}
