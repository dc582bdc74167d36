/* Prices measured in a host's context: what comes out, what is left behind, what is refused. */
#include <string.h>

#include "group.h"
#include "live_objects.h"
#include "rig_random.h"
#include "state_snapshot.h"

enum { NAMES = 256 };

struct host {
    int views; /* drawn */
};

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
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, fov_deg, 192);
    cupola_dome *dome = NULL;
    assert_int_equal(cupola_dome_create(&rig, &dome, NULL), CUPOLA_OK);
    return dome;
}

static void check_price(double price)
{
    check_at_least(price, 1e-9);
    check_at_most(price, 1e6);
}

/* Times are what they are: prices are only asked to be some, or the refusal to be that one. */
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
    assert_int_equal(host.views, 0);
    check_near(cost.view, -1.0, 0.0);
    cupola_dome_destroy(&dome);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(prices_are_finite_and_nothing_is_left_behind),
        cmocka_unit_test(what_cannot_be_measured_is_refused),
    };
    return run_gpu_group("measure", tests);
}
