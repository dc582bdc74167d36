/* Prices measured in a host's context: what comes out, what is left behind, what is refused. */
#include <string.h>

#include "gl/clock.h"
#include "group.h"
#include "live_objects.h"
#include "rig_random.h"
#include "state_snapshot.h"

enum { NAMES = 256 };

struct host {
    int views; /* drawn */
};

/* What a simulated host takes, s. */
struct scene {
    double texel, view, direction; /* a direction: all of them round the eye once */
};

static bool simulated;
static double simulated_s;

double __real_clock_now_s(void);
double __wrap_clock_now_s(void);
double __wrap_clock_now_s(void)
{
    return simulated ? simulated_s += 1e-5 : __real_clock_now_s();
}

/* Takes the time of whole rectangles, and of objects of 2 degrees that lie everywhere. */
static void simulate_view(cupola_gl *gl, int index, const struct cupola_gl_view *view, void *user)
{
    enum { OBJECTS = 4000 };
    const struct scene *scene = user;
    int seen = 0;
    (void)gl;
    (void)index;
    for (int i = 0; i < OBJECTS; i++) {
        double z = 1.0 - (2.0 * i + 1.0) / OBJECTS, turn = 2.399963 * i, r = sqrt(1.0 - z * z);
        const float at[3] = {(float)(10.0 * r * cos(turn)), (float)(10.0 * r * sin(turn)),
                             (float)(10.0 * z)};
        seen += cupola_camera_sees_sphere(&view->camera, at, 0.349f);
    }
    simulated_s += scene->view + scene->texel * view->rect.width * view->rect.height +
                   scene->direction * seen / OBJECTS;
}

/* A scene of nothing but colour: the whole rectangle, many times over. */
static void draw_view(cupola_gl *gl, int index, const struct cupola_gl_view *view, void *user)
{
    struct host *host = user;
    assert_non_null(gl);
    check_at_least(index, 0);
    check_at_least(view->rect.width, 1);
    for (int i = 0; i < 8; i++) {
        glClearColor(0.1f * (float)i, 0.0f, 0.0f, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    host->views++;
}

static cupola_dome *dome_of_degrees(double fov_deg)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, fov_deg, 768);
    cupola_dome *dome = NULL;
    assert_int_equal(cupola_dome_create(&rig, &dome, NULL), CUPOLA_OK);
    return dome;
}

static void check_price(double price)
{
    check_at_least(price, 0.0);
    check_at_most(price, 1e6);
}

static struct cupola_cost simulate(const cupola_dome *dome, struct scene *scene)
{
    const struct cupola_plan_params wishes = {.unmasked = true};
    struct cupola_cost cost = {.view = -1.0};
    simulated = true;
    assert_int_equal(
        cupola_gl_measure_cost(dome, &wishes, NULL, NULL, simulate_view, scene, &cost, NULL),
        CUPOLA_OK);
    simulated = false;
    printf("  view %g, allocated %g, vertices %g\n", cost.view, cost.texel_allocated,
           cost.vertices);
    return cost;
}

static double drawn_by(const cupola_dome *dome, const struct cupola_cost *cost)
{
    const struct cupola_plan_params wishes = {.unmasked = true, .cost = *cost};
    cupola_plan *plan = NULL;
    assert_int_equal(cupola_plan_create(dome, &wishes, &plan, NULL), CUPOLA_OK);
    double drawn = cupola_plan_report(plan)->directions_drawn;
    cupola_plan_destroy(&plan);
    return drawn;
}

/* By a clock of the test's: a scene of costly fragments, one of views, one of many triangles. */
static void scenes_have_the_prices_that_they_take(void **state)
{
    (void)state;
    cupola_dome *dome = dome_of_degrees(220.0);
    double pixels = 0.25 * 3.14159265 * 768.0 * 768.0, texel = 0.002 / pixels;
    struct scene fill = {texel, 0.0, 0.0}, views = {texel, 0.0004, 0.0};
    struct scene forest = {texel, 0.0, 0.02};
    struct cupola_cost of_fill = simulate(dome, &fill), of_views = simulate(dome, &views);
    struct cupola_cost of_forest = simulate(dome, &forest);
    check_at_most(of_fill.view, 0.02);
    check_at_most(of_fill.vertices, 0.2);
    check_near(of_views.view, 0.2, 0.05);
    /* Rectangles reach beyond the dome, and guard bands are seen, too. */
    check_near(of_forest.vertices, 10.0, 4.0);
    check_at_least(drawn_by(dome, &of_fill), 1.002 * drawn_by(dome, &of_forest));
    cupola_dome_destroy(&dome);
}

/* By the real clock: the default or a price, or the refusal is that one. */
static void prices_are_finite_and_nothing_is_left_behind(void **state)
{
    (void)state;
    static const double fovs[] = {100.0, 220.0};
    static struct snapshot before, after;
    for (int i = 0; i < 2; i++) {
        cupola_dome *dome = dome_of_degrees(fovs[i]);
        const struct cupola_plan_params wishes = {.unmasked = true};
        struct cupola_cost cost = {.view = -1.0};
        struct cupola_error error = {CUPOLA_OK, ""};
        struct host host = {.views = 0};
        glClearColor(0.1f * 7.0f, 0.0f, 0.0f, 1.0f); /* what draw_view leaves */
        int objects = live_objects(NAMES);
        snapshot_take(&before);
        int status =
            cupola_gl_measure_cost(dome, &wishes, NULL, NULL, draw_view, &host, &cost, &error);
        snapshot_take(&after);
        assert_int_equal(snapshot_differences(&before, &after, true, "measure_cost"), 0);
        assert_int_equal(live_objects(NAMES), objects);
        assert_int_equal(glGetError(), GL_NO_ERROR);
        check_at_least(host.views, 30);
        if (status == CUPOLA_OK) {
            check_price(cost.view);
            check_price(cost.texel_allocated);
            check_price(cost.vertices);
        } else {
            assert_int_equal(status, CUPOLA_ERROR_ARGUMENT);
            assert_non_null(strstr(error.message, "cannot tell"));
            printf("  %s\n", error.message);
            check_near(cost.view, -1.0, 0.0);
        }
        cupola_dome_destroy(&dome);
    }
}

static void what_cannot_be_measured_is_refused(void **state)
{
    (void)state;
    cupola_dome *dome = dome_of_degrees(140.0);
    struct cupola_cost cost = {.view = -1.0};
    struct host host = {.views = 0};
    const struct cupola_plan_params dense = {.density = 17.0};
    const struct cupola_gl_params samples = {.samples = -1};
    assert_int_equal(cupola_gl_measure_cost(NULL, NULL, NULL, NULL, draw_view, &host, &cost, NULL),
                     CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_gl_measure_cost(dome, NULL, NULL, NULL, NULL, &host, &cost, NULL),
                     CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_gl_measure_cost(dome, NULL, NULL, NULL, draw_view, &host, NULL, NULL),
                     CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(
        cupola_gl_measure_cost(dome, &dense, NULL, NULL, draw_view, &host, &cost, NULL),
        CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(
        cupola_gl_measure_cost(dome, NULL, &samples, NULL, draw_view, &host, &cost, NULL),
        CUPOLA_ERROR_ARGUMENT);
    const struct cupola_frame behind = {.depth = {.near_distance = -1.0}};
    assert_int_equal(
        cupola_gl_measure_cost(dome, NULL, NULL, &behind, draw_view, &host, &cost, NULL),
        CUPOLA_ERROR_ARGUMENT);
    for (int storage = CUPOLA_STORAGE_TEXTURES; storage <= CUPOLA_STORAGE_LAYERS; storage++) {
        const struct cupola_gl_params textures = {.storage = (enum cupola_storage)storage};
        struct cupola_error error = {CUPOLA_OK, ""};
        assert_int_equal(
            cupola_gl_measure_cost(dome, NULL, &textures, NULL, draw_view, &host, &cost, &error),
            CUPOLA_ERROR_ARGUMENT);
        assert_non_null(strstr(error.message, "storage is"));
    }
    assert_int_equal(host.views, 0);
    check_near(cost.view, -1.0, 0.0);
    cupola_dome_destroy(&dome);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scenes_have_the_prices_that_they_take),
        cmocka_unit_test(prices_are_finite_and_nothing_is_left_behind),
        cmocka_unit_test(what_cannot_be_measured_is_refused),
    };
    return run_gpu_group("measure", tests);
}
