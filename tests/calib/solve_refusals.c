/* What marks cannot determine is refused, with the reason. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "option_values.h"
#include "solve_theatre.h"

static const double degree = 3.14159265358979323846 / 180;

enum { POSE = SOLVE_POSITION | SOLVE_AIM, MOST = 40 };

/* A projector below the middle, and marks at places of the test's choice. */
struct scene {
    struct cupola_rig rig;
    struct marks marks;
    struct mark list[MOST];
};

static void begin(struct scene *scene)
{
    *scene = (struct scene){.rig = {.screen = {.radius_m = 2}}};
    scene->rig.outputs[0].position_m[1] = -0.6;
    scene->rig.outputs[0].position_m[2] = 0.2;
    scene->rig.outputs[0].aim.pitch_rad = 0.2;
    assert_int_equal(cupola_rig_complete(&scene->rig, &scene->rig, NULL), CUPOLA_OK);
    scene->marks = (struct marks){.list = scene->list};
}

/* A mark at an angle from the dome's axis, on a meridian; its pixel is off by a third or so. */
static void add(struct scene *scene, double angle_deg, double meridian_deg)
{
    struct mark *mark = &scene->list[scene->marks.count];
    double angle = angle_deg * degree, way = meridian_deg * degree;

    *mark = (struct mark){.steered = true};
    snprintf(mark->name, sizeof mark->name, "m%d", scene->marks.count++);
    mark->place[0] = sin(angle) * cos(way);
    mark->place[1] = sin(angle) * sin(way);
    mark->place[2] = -cos(angle);
    theatre_pixel(&scene->rig, mark, MARKS_DIRECTIONS, mark->pixel_px);
    mark->pixel_px[0] += 0.3 * sin(17.0 * scene->marks.count);
    mark->pixel_px[1] += 0.3 * cos(29.0 * scene->marks.count);
}

/* Rings of eight round the axis. */
static void add_rings(struct scene *scene, int rings, double step_deg)
{
    for (int i = 0; i < 8 * rings; i++)
        add(scene, step_deg * (i / 8 + 1), 45 * i + 20 * (i / 8));
}

static void expect_refused(const struct scene *scene, int free, const char *said)
{
    char message[MESSAGE_SIZE] = "";
    struct solve_result result;
    const struct solve_request request = {&scene->rig, 0, &scene->marks, free};

    if (solve(&request, &result, message))
        fail_msg("solved; should be refused for '%s'", said);
    assert_null(result.marks);
    if (!strstr(message, said))
        fail_msg("'%s' does not say '%s'", message, said);
}

static void expect_solved(const struct scene *scene, int free, const char *warning)
{
    char message[MESSAGE_SIZE] = "";
    struct solve_result result;
    const struct solve_request request = {&scene->rig, 0, &scene->marks, free};
    bool warned = !warning;

    if (!solve(&request, &result, message))
        fail_msg("refused: %s", message);
    for (int i = 0; i < result.warning_count; i++)
        warned |= warning && strstr(result.warnings[i], warning);
    if (!warned || (!warning && result.warning_count > 0))
        fail_msg("warnings: %d, first '%s'; wished: '%s'", result.warning_count, result.warnings[0],
                 warning ? warning : "none");
    solve_result_free(&result);
}

static void what_no_marks_can_tell(void **state)
{
    struct scene scene;

    (void)state;
    begin(&scene);
    add_rings(&scene, 3, 25);
    expect_refused(&scene, POSE | SOLVE_RADIUS, "only relative to the radius");
    expect_refused(&scene, SOLVE_LENS | SOLVE_CIRCLE_RADIUS, "lens and circle-radius");
    expect_solved(&scene, SOLVE_RADIUS, NULL);
    memset(scene.rig.outputs[0].position_m, 0, 3 * sizeof(double));
    expect_refused(&scene, SOLVE_RADIUS, "at the centre");
    scene.list[4].steered = false;
    expect_refused(&scene, POSE, "mark 'm4' has no pixel");
}

static void too_few(void **state)
{
    struct scene scene;

    (void)state;
    begin(&scene);
    add(&scene, 10, 0);
    expect_refused(&scene, SOLVE_AIM, "1 mark cannot determine 3 values");
    add(&scene, 50, 130);
    add(&scene, 60, 250);
    expect_refused(&scene, POSE, "3 marks cannot determine 6 values");
    expect_refused(&scene, POSE, "allowed: 4 at least");
    expect_refused(&scene, POSE | SOLVE_CIRCLE | SOLVE_LENS, "allowed: 6 at least");
    add(&scene, 40, 10);
    expect_solved(&scene, POSE, "their sd are rough");
    scene.rig.outputs[0].circle = (struct cupola_circle){0}; /* its default, as before */
    expect_solved(&scene, POSE, "their sd are rough");
}

/* Places of a mark that count once, however often they are measured, and whether exactly. */
static void few_places_measured_often(void **state)
{
    struct scene scene;

    (void)state;
    for (int exact = 1; exact >= 0; exact--) {
        begin(&scene);
        for (int i = 0; i < 15; i++) {
            add(&scene, 20 + 25 * (i % 3) + 0.1 * (i % 5), 120 * (i % 3));
            if (exact)
                theatre_pixel(&scene.rig, &scene.list[i], MARKS_DIRECTIONS, scene.list[i].pixel_px);
        }
        expect_refused(&scene, POSE, "15 marks at 3 different places");
        expect_refused(&scene, POSE, "allowed: 4 places at least");
        expect_refused(&scene, POSE | SOLVE_CIRCLE | SOLVE_LENS, "allowed: 6 places at least");
        if (exact)
            expect_solved(&scene, SOLVE_AIM, "the residuals are 0");
        else
            expect_solved(&scene, SOLVE_AIM, "15 marks at 3 different places for 3 values");
    }
    add(&scene, 50, 60);
    expect_solved(&scene, POSE, "16 marks at 4 different places for 6 values: their sd are rough");
    /* A wrong mark is no further place. */
    scene.list[15].pixel_px[1] += 150;
    expect_refused(&scene, POSE, "15 marks that agree at 3 different places");
}

/* Without noise nothing can be said about it. */
static void marks_without_errors_do_not_tell_how_good_they_are(void **state)
{
    struct scene scene;

    (void)state;
    begin(&scene);
    add_rings(&scene, 3, 25);
    expect_solved(&scene, POSE, NULL);
    for (int i = 0; i < scene.marks.count; i++)
        theatre_pixel(&scene.rig, &scene.list[i], MARKS_DIRECTIONS, scene.list[i].pixel_px);
    expect_solved(&scene, POSE, "the residuals are 0");
    scene.marks.kind = MARKS_POINTS;
    for (int i = 0; i < 3 * scene.marks.count; i++)
        scene.list[i / 3].place[i % 3] *= 2;
    expect_solved(&scene, POSE | SOLVE_RADIUS, "the radius's sd says nothing");
}

/* Not the marks are wrong then. */
static void another_lens_than_that_of_the_start(void **state)
{
    struct scene scene;

    (void)state;
    begin(&scene);
    scene.rig.outputs[0].lens.model = CUPOLA_LENS_EQUISOLID;
    add_rings(&scene, 3, 25);
    expect_solved(&scene, POSE, NULL);
    scene.rig.outputs[0].lens.model = CUPOLA_LENS_ANGULAR;
    expect_solved(&scene, POSE, "are larger than usual, 2.6 px: the lens model");
    expect_solved(&scene, POSE, "systematic: with the lens model \"equisolid\"");
    begin(&scene);
    add_rings(&scene, 3, 25);
    scene.rig.outputs[0].lens.fov_rad *= 1.02;
    expect_solved(&scene, POSE, "systematic: with lens free");
    scene.rig.outputs[0].lens.fov_rad /= 1.02;
    scene.rig.outputs[0].circle.center_x_px += 5;
    expect_solved(&scene, POSE, "systematic: with circle free");
}

static void all_on_one_meridian(void **state)
{
    struct scene scene;

    (void)state;
    for (int meridian = 0; meridian < 180; meridian += 30) {
        begin(&scene);
        for (int i = 0; i < 12; i++)
            add(&scene, -70 + 12 * i, meridian + 0.9 * sin(5 * i));
        expect_refused(&scene, POSE, "one meridian");
        expect_solved(&scene, SOLVE_AIM, NULL);
    }
    /* A wrong mark beside it does not make it better. */
    add(&scene, 60, 70);
    scene.list[12].pixel_px[0] += 200;
    expect_refused(&scene, POSE, "one meridian");
}

static void all_close_together(void **state)
{
    struct scene scene;

    (void)state;
    begin(&scene);
    add_rings(&scene, 3, 3);
    expect_refused(&scene, POSE, "close together, within 9.0 degrees");
    expect_solved(&scene, SOLVE_CIRCLE, NULL);
    begin(&scene);
    add_rings(&scene, 3, 3.5);
    expect_solved(&scene, POSE, "only roughly");
    expect_refused(&scene, POSE | SOLVE_CIRCLE | SOLVE_LENS, "do not determine");
}

/* Of a ring round the axis a projector on the axis sees its angle alone. */
static void all_on_one_circle(void **state)
{
    struct scene scene;
    struct cupola_output *output = &scene.rig.outputs[0];

    (void)state;
    begin(&scene);
    memset(output->position_m, 0, sizeof output->position_m);
    output->position_m[2] = 0.3;
    output->aim.pitch_rad = 0;
    for (int i = 0; i < 16; i++)
        add(&scene, 60, 22.5 * i);
    expect_refused(&scene, POSE | SOLVE_LENS, "the one circle on which all of these lie");
    expect_refused(&scene, POSE | SOLVE_LENS, "lens fov");
    expect_refused(&scene, POSE | SOLVE_LENS, "position z");
    add_rings(&scene, 2, 30);
    expect_solved(&scene, POSE | SOLVE_LENS, NULL);
}

static void contradictions(void **state)
{
    struct scene scene;
    uint64_t seed = 3;

    (void)state;
    begin(&scene);
    add_rings(&scene, 3, 25);
    for (int i = 0; i < scene.marks.count; i++) {
        scene.list[i].pixel_px[0] = random_between(&seed, 0, 1024);
        scene.list[i].pixel_px[1] = random_between(&seed, 0, 1024);
    }
    expect_refused(&scene, POSE, "allowed: ");
}

/* Mirrored one way or the other; the same but for half a turn, and the near one is told. */
static void a_mirrored_picture_is_named(void **state)
{
    static const char *const said[] = {
        "flip \"x\" instead of \"none\" (the same as \"y\" with 180",
        "flip \"y\" instead of \"none\" (the same as \"x\" with 180"};

    (void)state;
    for (int way = 0; way < 2; way++) {
        struct scene scene;
        struct solve_result result;
        char message[MESSAGE_SIZE] = "";
        begin(&scene);
        add_rings(&scene, 3, 25);
        for (int i = 0; i < scene.marks.count; i++)
            scene.list[i].pixel_px[way] = 1024 - scene.list[i].pixel_px[way];
        expect_refused(&scene, POSE, said[way]);
        const struct solve_request request = {&scene.rig, 0, &scene.marks, POSE, .flips = true};
        assert_true(solve(&request, &result, message));
        assert_non_null(strstr(result.warnings[0], said[way]));
        assert_int_equal(result.rig.outputs[0].flip, way ? CUPOLA_FLIP_Y : CUPOLA_FLIP_X);
        check_near(result.rig.outputs[0].aim.pitch_rad, 0.2, 0.5 * degree);
        check_near(result.rig.outputs[0].aim.roll_rad, 0, 0.5 * degree);
        assert_int_equal(result.rejected, 0);
        assert_true(result.rms_px < 1);
        solve_result_free(&result);
    }
}

/* Points that nothing but a projector beyond the screen could light so. */
static void a_projector_outside_of_the_screen(void **state)
{
    struct scene scene;

    (void)state;
    begin(&scene);
    scene.rig.outputs[0].position_m[2] = 2.5;
    add_rings(&scene, 3, 25);
    scene.rig.outputs[0].position_m[2] = 0;
    expect_refused(&scene, POSE, "impossible rig: ");
    expect_refused(&scene, POSE, "position");
}

/* There the curve of a hemispheric lens does not change with it. */
static void an_opening_at_its_limit_is_known_only_roughly(void **state)
{
    struct scene scene;

    (void)state;
    begin(&scene);
    scene.rig.outputs[0].lens.model = CUPOLA_LENS_HEMISPHERIC;
    add_rings(&scene, 2, 25);
    expect_solved(&scene, POSE | SOLVE_LENS, "lens fov only roughly");
    expect_solved(&scene, POSE, NULL);
}

static void random_lens(uint64_t *seed, struct cupola_lens *lens)
{
    lens->model = (enum cupola_lens_model)(int)random_between(seed, 0, 6);
    lens->fov_rad = random_between(seed, 0.3, 3.1);
    if (lens->model == CUPOLA_LENS_POLYNOMIAL)
        memcpy(lens->k, (double[]){0, 1, random_between(seed, -0.05, 0.1), 0}, sizeof lens->k);
    if (lens->model != CUPOLA_LENS_TABLE)
        return;
    lens->table_count = 3;
    for (int i = 0; i < 3; i++)
        lens->table[i] =
            (struct cupola_lens_sample){0.6 * (i + 1), i + random_between(seed, 0.5, 1)};
}

/* Half of them from a theatre, half of them anything. */
static void random_marks(uint64_t *seed, struct scene *scene)
{
    int count = (int)random_between(seed, 0, MOST);

    for (int i = 0; i < count; i++) {
        struct mark *mark = &scene->list[i];
        add(scene, random_between(seed, 0, 120), random_between(seed, 0, 360));
        if (random_between(seed, 0, 1) < 0.5)
            continue;
        for (int k = 0; k < 2; k++)
            mark->pixel_px[k] =
                random_between(seed, 0, 1) < 0.1 ? 1e7 : random_between(seed, -500, 1500);
        if (random_between(seed, 0, 1) < 0.1)
            memcpy(mark->place, scene->list[0].place, sizeof mark->place);
    }
    scene->marks.kind = random_between(seed, 0, 1) < 0.5 ? MARKS_POINTS : MARKS_DIRECTIONS;
}

static void whatever_comes_is_solved_or_refused_in_one_line(void **state)
{
    int solved = 0;

    (void)state;
    for (uint64_t i = 0; i < 400; i++) {
        struct scene scene;
        struct solve_result result;
        char message[MESSAGE_SIZE] = "";
        uint64_t seed = i;
        begin(&scene);
        random_marks(&seed, &scene);
        random_lens(&seed, &scene.rig.outputs[0].lens);
        scene.rig.outputs[0].flip = (int)random_between(&seed, 0, 4);
        const struct solve_request request = {
            &scene.rig, 0, &scene.marks, (int)random_between(&seed, 0, 64), .flips = i % 3 == 0};
        if (!solve(&request, &result, message)) {
            assert_true(*message && !strchr(message, '\n'));
            assert_null(result.marks);
            continue;
        }
        solved++;
        assert_int_equal(cupola_rig_complete(&result.rig, NULL, NULL), CUPOLA_OK);
        assert_true(isfinite(result.rms_px) && isfinite(result.worst_direction_sd_rad));
        assert_in_range(result.rejected, 0, scene.marks.count / 2);
        solve_result_free(&result);
    }
    print_message("%d of 400 solved\n", solved);
    assert_in_range(solved, 10, 300);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_no_marks_can_tell),
        cmocka_unit_test(too_few),
        cmocka_unit_test(few_places_measured_often),
        cmocka_unit_test(marks_without_errors_do_not_tell_how_good_they_are),
        cmocka_unit_test(another_lens_than_that_of_the_start),
        cmocka_unit_test(all_on_one_meridian),
        cmocka_unit_test(all_close_together),
        cmocka_unit_test(all_on_one_circle),
        cmocka_unit_test(contradictions),
        cmocka_unit_test(a_mirrored_picture_is_named),
        cmocka_unit_test(a_projector_outside_of_the_screen),
        cmocka_unit_test(an_opening_at_its_limit_is_known_only_roughly),
        cmocka_unit_test(whatever_comes_is_solved_or_refused_in_one_line),
    };

    return cmocka_run_group_tests_name("solve_refusals", tests, NULL, NULL);
}
