/* The table stage that a cupola_gl chooses: it says which, and nothing of the others stays. */
#include <stdio.h>
#include <stdlib.h>

#include "gl/clock.h"
#include "gl/instance.h"
#include "group.h"
#include "host_objects.h"
#include "hostilities.h"
#include "live_objects.h"
#include "rig_random.h"
#include "worse.h"

enum { NAMES = 4000, RIGS = 3, OUTPUTS = 2 };

/* As of the stages among themselves: tests/gpu/stages.c. */
static const double bar_rad = 1e-5;

/* Simulated: the stage that is fast, and the time; a draw by another stage takes twice as long. */
static int fast = -1;
static double simulated_s, draw_s = 0.001;

double __real_clock_now_s(void);
double __wrap_clock_now_s(void);
double __wrap_clock_now_s(void)
{
    return fast < 0 ? __real_clock_now_s() : simulated_s;
}

void __real_warp_draw_views(cupola_gl *gl, int output, const struct cupola_target *place);
void __wrap_warp_draw_views(cupola_gl *gl, int output, const struct cupola_target *place);
void __wrap_warp_draw_views(cupola_gl *gl, int output, const struct cupola_target *place)
{
    simulated_s += (int)gl->passes[output].stage == fast ? draw_s : 2.0 * draw_s;
    __real_warp_draw_views(gl, output, place);
}

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

static void make_for_head(const struct cupola_rig *rig, double head_radius_m,
                          enum cupola_table table, struct heard *heard, struct fixture *fixture)
{
    const struct cupola_plan_params wishes = {.head_radius_m = head_radius_m};
    struct cupola_gl_params params = {.format = CUPOLA_FORMAT_RGBA32F, .table = table};
    params.log = (struct cupola_log){listen, heard, CUPOLA_LOG_INFO};
    fixture_make(rig, &wishes, &params, fixture);
}

static void make(const struct cupola_rig *rig, enum cupola_table table, struct heard *heard,
                 struct fixture *fixture)
{
    make_for_head(rig, 0.0, table, heard, fixture);
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
        /* On a machine that is busy enough the time is up before anything was measured. */
        assert_true(strstr(heard.text, " ms") || strstr(heard.text, "nothing was measured"));
        printf("%s\n", heard.text);
        check_images(&rig, &fixture);
        fixture_release(&fixture);
    }
}

/* Light that falls off from left to right, of an output's size. */
static GLuint make_gain(const struct cupola_output *size)
{
    unsigned char *levels = malloc((size_t)(4 * size->width_px * size->height_px));
    GLuint gain = 0;
    assert_non_null(levels);
    for (int i = 0; i < 4 * size->width_px * size->height_px; i++)
        levels[i] = (unsigned char)(200 - i / 4 % size->width_px);
    glGenTextures(1, &gain);
    glBindTexture(GL_TEXTURE_2D, gain);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size->width_px, size->height_px, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, levels);
    glBindTexture(GL_TEXTURE_2D, 0);
    free(levels);
    return gain;
}

static void alter(const struct fixture *fixture, const GLuint *gains, const double eye_m[3])
{
    for (int i = 0; i < OUTPUTS && gains; i++)
        assert_int_equal(cupola_gl_set_gain(fixture->gl, i, gains[i], NULL), CUPOLA_OK);
    if (eye_m)
        assert_int_equal(cupola_gl_set_eye(fixture->gl, eye_m, NULL), CUPOLA_OK);
}

/* Chosen stages against none, both altered alike; the control: none, not altered. */
static void check_altered(const struct cupola_rig *rig, double head_radius_m, const GLuint *gains,
                          const double eye_m[3], const struct fixture *chosen)
{
    struct fixture plain;
    struct heard heard = {0};
    make_for_head(rig, head_radius_m, CUPOLA_TABLE_NONE, &heard, &plain);
    float *before = image_of(&plain, 0);
    alter(&plain, gains, eye_m);
    alter(chosen, gains, eye_m);
    for (int i = 0; i < OUTPUTS; i++) {
        float *found = image_of(chosen, i), *expected = image_of(&plain, i);
        check_at_most(apart(&plain, i, found, expected), bar_rad);
        if (i == 0)
            check_at_least(apart(&plain, 0, found, before), 100.0 * bar_rad);
        free(found);
        free(expected);
    }
    free(before);
    fixture_release(&plain);
}

static void check_winner(int stage, double head_radius_m, bool with_gain)
{
    struct cupola_rig rig = rig_number(1);
    const double eye_m[3] = {rig.eye_m[0] + 0.5 * head_radius_m, rig.eye_m[1],
                             rig.eye_m[2] - 0.3 * head_radius_m};
    struct fixture fixture;
    struct heard heard = {0};
    fast = stage;
    simulated_s = 0.0;
    make_for_head(&rig, head_radius_m, CUPOLA_TABLE_AUTO, &heard, &fixture);
    fast = -1;
    for (int i = 0; i < OUTPUTS; i++)
        assert_int_equal(cupola_gl_table(fixture.gl, i), stage);
    GLuint gains[OUTPUTS] = {0};
    for (int i = 0; i < OUTPUTS && with_gain; i++)
        gains[i] = make_gain(&rig.outputs[i]);
    if (head_radius_m == 0.0 && !with_gain)
        check_images(&rig, &fixture);
    else
        check_altered(&rig, head_radius_m, with_gain ? gains : NULL,
                      head_radius_m > 0.0 ? eye_m : NULL, &fixture);
    fixture_release(&fixture);
    glDeleteTextures(OUTPUTS, gains);
}

static void each_stage_wins_where_it_is_fast(void **state)
{
    (void)state;
    for (int stage = 0; stage < CUPOLA_TABLE_AUTO; stage++) {
        check_winner(stage, 0.0, false);
        check_winner(stage, 0.0, true);
    }
    /* The others are not asked where the eye moves. */
    check_winner(CUPOLA_TABLE_TILES, 0.3, false);
    check_winner(CUPOLA_TABLE_NONE, 0.3, true);
    check_winner(CUPOLA_TABLE_POINTS, 0.3, true);
}

/* Each draw of 0.2 s or 0.1 s: what is begun is ended, and nothing more. */
static void slow_draws_end_the_search(void **state)
{
    (void)state;
    struct cupola_rig rig = rig_number(1);
    struct fixture fixture;
    struct heard heard = {0};
    fast = CUPOLA_TABLE_SINES; /* the last one, which is not reached */
    draw_s = 0.1;
    simulated_s = 0.0;
    make(&rig, CUPOLA_TABLE_AUTO, &heard, &fixture);
    fast = -1;
    draw_s = 0.001;
    printf("  %g s for %d outputs\n", simulated_s, OUTPUTS);
    check_at_most(simulated_s, OUTPUTS * (0.25 + 2.0 * 0.2));
    for (int i = 0; i < OUTPUTS; i++)
        assert_int_equal(cupola_gl_table(fixture.gl, i), CUPOLA_TABLE_TILES);
    check_images(&rig, &fixture);
    fixture_release(&fixture);
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
        cmocka_unit_test(each_stage_wins_where_it_is_fast),
        cmocka_unit_test(slow_draws_end_the_search),
        cmocka_unit_test(as_much_stays_as_of_the_stage_that_was_chosen),
        cmocka_unit_test(choosing_leaves_a_hosts_state),
        cmocka_unit_test(nonsense_has_no_stage),
        cmocka_unit_test(with_the_hosts_textures_nothing_is_measured),
    };
    return run_gpu_group("table_auto", tests);
}
