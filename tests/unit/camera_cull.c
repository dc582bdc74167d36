/*
 * Culling: no view leaves out what it shows. Against brute force: random points of random objects,
 * drawn with the view's matrices as a host draws them.
 */
#include "plan_pixels.h"

enum { OBJECTS = 400, POINTS = 60 };

struct object {
    float center[3];
    float reach[3]; /* of the sphere or the box round the centre, along each axis */
};

struct tally {
    int shown;  /* views that show some point of an object */
    int missed; /* of those, the ones that left it out */
    int culled; /* views that leave an object out */
    int beyond; /* views one of whose sides has all of the object's points beyond it */
    int spared; /* of those, the ones that let it be drawn nevertheless */
};

static cupola_plan *random_plan(uint64_t *seed, bool rotation_in_projection)
{
    struct cupola_rig rig;
    struct cupola_plan_params params;
    random_plan_case(seed, &rig, &params);
    rig.outputs[0].width_px = 60;
    rig.outputs[0].height_px = 50;
    rig.outputs[0].circle = (struct cupola_circle){30.0, 23.0, 29.0};
    params.rotation_in_projection = rotation_in_projection;
    return plan_of(&rig, &params);
}

/* Some round the eye, some far away, from a thousandth of a metre to many metres wide. */
static struct object random_object(uint64_t *seed, double unit, bool is_sphere)
{
    struct object object;
    double far_off = unit * pow(10.0, random_between(seed, -1.0, 1.5)), place[3];
    random_in_ball(seed, far_off, place);
    for (int i = 0; i < 3; i++) {
        object.center[i] = (float)place[i];
        object.reach[i] = (float)(unit * pow(10.0, random_between(seed, -3.0, 1.0)));
        if (is_sphere)
            object.reach[i] = object.reach[0];
    }
    return object;
}

/* A point of the object; in every third case on its surface. */
static void random_point(uint64_t *seed, const struct object *object, bool is_sphere, int index,
                         double point[4])
{
    double offset[3], length;
    random_in_ball(seed, 1.0, offset);
    length = sqrt(offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2]);
    for (int i = 0; i < 3; i++) {
        if (!is_sphere)
            offset[i] = random_between(seed, -1.0, 1.0);
        else if (index % 3 == 0)
            offset[i] /= length;
    }
    if (!is_sphere && index % 3 == 0)
        offset[index % 9 / 3] = offset[0] < 0.0 ? -1.0 : 1.0;
    for (int i = 0; i < 3; i++)
        point[i] = (double)object->center[i] + offset[i] * (double)object->reach[i];
    point[3] = 1.0;
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void times(const float m[16], const double v[4], double out[4])
{
    for (int i = 0; i < 4; i++) {
        out[i] = 0.0;
        for (int j = 0; j < 4; j++)
            out[i] += (double)m[4 * j + i] * v[j];
    }
}

/* Which of the six sides of clip space have the point beyond them, a bit for each. */
static unsigned int sides_beyond(const struct cupola_camera *camera, const double point[4])
{
    double in_eye[4], clip[4];
    unsigned int sides = 0;
    times(camera->view, point, in_eye);
    times(camera->projection, in_eye, clip);
    for (unsigned int i = 0; i < 6; i++) {
        double value = clip[i / 2];
        sides |= (unsigned int)((i % 2 ? clip[3] - value : clip[3] + value) < 0.0) << i;
    }
    return sides;
}

/* Part: that of the object which the library is asked about; 1 is all of it. */
static int sees(const struct cupola_camera *camera, const struct object *object, bool is_sphere,
                float part)
{
    float least[3], most[3];
    if (is_sphere)
        return cupola_camera_sees_sphere(camera, object->center, part * object->reach[0]);
    for (int i = 0; i < 3; i++) {
        least[i] = object->center[i] - part * object->reach[i];
        most[i] = object->center[i] + part * object->reach[i];
    }
    return cupola_camera_sees_box(camera, least, most);
}

/* Whether a pixel may sample a view at a point, itself or by the taps of a filter. */
static bool is_sampled(const cupola_plan *plan, int view, const double point[4])
{
    const cupola_dome *dome = cupola_plan_dome(plan);
    const struct cupola_rig *rig = cupola_dome_rig(dome);
    const struct cupola_view *v = cupola_plan_view(plan, view);
    double eye[3], ray[3], base[2], step[2];
    cupola_dome_to_camera(dome, rig->eye_m, eye);
    for (int i = 0; i < 3; i++)
        ray[i] = point[i] - rig->units_per_metre * eye[i];
    double depth = -dot(v->rotation + 6, ray);
    base[0] = dot(v->rotation, ray) / depth;
    base[1] = dot(v->rotation + 3, ray) / depth;
    step[0] = 0.999 * (v->right - v->left) / v->rect.width;
    step[1] = 0.999 * (v->top - v->bottom) / v->rect.height;
    for (int k = 0; k < 4; k++) {
        double near_by[3];
        for (int i = 0; i < 3; i++)
            near_by[i] = v->rotation[i] * (base[0] + (k & 1 ? step[0] : -step[0])) +
                         v->rotation[3 + i] * (base[1] + (k & 2 ? step[1] : -step[1])) -
                         v->rotation[6 + i];
        if (cupola_plan_select(plan, near_by) == view)
            return true;
    }
    return cupola_plan_select(plan, ray) == view;
}

static void count(const cupola_plan *plan, int view, const struct cupola_camera *camera,
                  const struct object *object, bool is_sphere, float part, uint64_t *seed,
                  struct tally *tally)
{
    unsigned int all_beyond = 63;
    bool shown = false;
    for (int i = 0; i < POINTS; i++) {
        double point[4];
        random_point(seed, object, is_sphere, i, point);
        unsigned int sides = sides_beyond(camera, point);
        shown |= sides == 0 && is_sampled(plan, view, point);
        all_beyond &= sides;
    }
    int seen = sees(camera, object, is_sphere, part);
    assert_in_range(seen, 0, 1);
    tally->shown += shown;
    tally->missed += shown && !seen;
    tally->culled += !seen;
    tally->beyond += all_beyond != 0;
    tally->spared += all_beyond && seen;
}

static struct tally tally_of(uint64_t seed, bool is_sphere, float part)
{
    struct tally tally = {0};
    for (int i = 0; i < 12; i++) {
        cupola_plan *plan = random_plan(&seed, i % 2);
        double unit = cupola_dome_rig(cupola_plan_dome(plan))->units_per_metre;
        const struct cupola_depth depth = {.near_distance = 0.2 * unit,
                                           .far_distance = 20.0 * unit};
        for (int k = 0; k < cupola_plan_view_count(plan); k++) {
            struct cupola_camera camera;
            assert_int_equal(cupola_plan_camera(plan, k, &depth, &camera, NULL), CUPOLA_OK);
            for (int n = 0; n < OBJECTS; n++) {
                struct object object = random_object(&seed, unit, is_sphere);
                count(plan, k, &camera, &object, is_sphere, part, &seed, &tally);
            }
        }
        cupola_plan_destroy(&plan);
    }
    return tally;
}

/*
 * Random points miss the outermost bit of an object, so a few that reach over a side count as
 * beyond it here; an object that lies beyond it for certain is left out.
 */
static void check_tally(struct tally tally)
{
    check_at_least(tally.shown, 1000);
    assert_int_equal(tally.missed, 0);
    check_at_least(tally.culled, 5000);
    check_at_most((double)tally.spared / tally.beyond, 0.05);
}

static void a_sphere_is_never_left_out_where_a_point_of_it_shows(void **state)
{
    (void)state;
    check_tally(tally_of(501, true, 1.0f));
}

static void a_box_is_never_left_out_where_a_point_of_it_shows(void **state)
{
    (void)state;
    check_tally(tally_of(502, false, 1.0f));
}

static void objects_taken_for_smaller_than_they_are_are_caught(void **state)
{
    (void)state;
    check_at_least(tally_of(501, true, 0.9f).missed, 10);
    check_at_least(tally_of(502, false, 0.9f).missed, 10);
}

/* Points at the rim of a view, where the last digit decides, are drawn. */
static void points_on_the_border_of_a_view_are_seen(void **state)
{
    (void)state;
    uint64_t seed = 503;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 64);
    cupola_plan *plan = plan_of(&rig, NULL);
    for (int k = 0; k < cupola_plan_view_count(plan); k++) {
        const struct cupola_view *view = cupola_plan_view(plan, k);
        struct cupola_camera camera;
        assert_int_equal(cupola_plan_camera(plan, k, NULL, &camera, NULL), CUPOLA_OK);
        camera.border_count = 0; /* the frustum alone */
        for (int n = 0; n < 4000; n++) {
            double far_off = random_between(&seed, 0.2, 900.0);
            double a = n % 2 ? view->left : random_between(&seed, view->left, view->right);
            double b = n % 2 ? random_between(&seed, view->bottom, view->top) : view->top;
            float point[3];
            for (int i = 0; i < 3; i++)
                point[i] = (float)(far_off * (view->rotation[i] * a + view->rotation[3 + i] * b -
                                              view->rotation[6 + i]));
            assert_int_equal(cupola_camera_sees_sphere(&camera, point, 0.0f), 1);
            assert_int_equal(cupola_camera_sees_box(&camera, point, point), 1);
        }
    }
    cupola_plan_destroy(&plan);
}

/* Moves a ray onto the border between two views; false where other views lie between them. */
static bool move_to_border(const cupola_plan *plan, int k, int w, double ray[3], double across[3])
{
    const double *own = cupola_plan_view(plan, k)->selector;
    const double *other = cupola_plan_view(plan, w)->selector;
    for (int i = 0; i < 3; i++)
        across[i] = own[i] - other[i];
    double ahead = dot(across, ray) / dot(across, across);
    for (int i = 0; i < 3; i++)
        ray[i] -= ahead * across[i];
    int selected = cupola_plan_select(plan, ray);
    return selected == k || selected == w;
}

/* Beyond its border a view is sampled by the taps of its neighbour's last pixels. */
static void borders_leave_room_for_the_guard_band_and_no_more(void **state)
{
    (void)state;
    uint64_t seed = 504;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 140.0, 256);
    cupola_plan *plan = plan_of(&rig, NULL);
    int seen[3] = {0}, asked[3] = {0};
    for (int n = 0; n < 20000; n++) {
        struct cupola_camera camera;
        double ray[3], across[3];
        random_in_ball(&seed, 1.0, ray);
        int k = cupola_plan_select(plan, ray), w = random_int(&seed, 0, 7);
        if (w == k || ray[2] > -0.3 || !move_to_border(plan, k, w, ray, across))
            continue;
        const struct cupola_view *v = cupola_plan_view(plan, k);
        double depth = -dot(v->rotation + 6, ray);
        double step_u = copysign((v->right - v->left) / v->rect.width, dot(v->rotation, across));
        double step_v =
            copysign((v->top - v->bottom) / v->rect.height, dot(v->rotation + 3, across));
        assert_int_equal(cupola_plan_camera(plan, k, NULL, &camera, NULL), CUPOLA_OK);
        memset(camera.planes, 0, sizeof camera.planes);
        for (int step = 0; step < 3; step++) {
            float point[3];
            for (int i = 0; i < 3; i++)
                point[i] =
                    (float)(ray[i] / depth - (2.0 * step - 0.2) * (step_u * v->rotation[i] +
                                                                   step_v * v->rotation[3 + i]));
            asked[step]++;
            seen[step] += cupola_camera_sees_sphere(&camera, point, 0.0f);
        }
    }
    check_at_least(asked[0], 1000);
    assert_int_equal(seen[0], asked[0]); /* 0.2 texels inside */
    assert_int_equal(seen[1], asked[1]); /* 1.8 beyond, of 2 */
    assert_int_equal(seen[2], 0);        /* 3.8 beyond */
    cupola_plan_destroy(&plan);
}

static void what_makes_no_sense_is_seen_and_null_is_refused(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 120.0, 64);
    cupola_plan *plan = plan_of(&rig, NULL);
    struct cupola_camera camera;
    const float ahead[3] = {0, 0, -5}, behind[3] = {0, 0, 5}, more[3] = {1, 1, 7};
    const float unknown[3] = {NAN, 0, 5}, endless[3] = {-INFINITY, 0, 5};
    assert_int_equal(cupola_plan_camera(plan, 0, NULL, &camera, NULL), CUPOLA_OK);
    assert_int_equal(cupola_camera_sees_sphere(&camera, behind, 1), 0);
    assert_int_equal(cupola_camera_sees_sphere(&camera, behind, -1e9f), 0);
    assert_int_equal(cupola_camera_sees_sphere(&camera, behind, INFINITY), 1);
    assert_int_equal(cupola_camera_sees_sphere(&camera, behind, NAN), 1);
    assert_int_equal(cupola_camera_sees_sphere(&camera, unknown, 1), 1);
    assert_int_equal(cupola_camera_sees_box(&camera, behind, more), 0);
    assert_int_equal(cupola_camera_sees_box(&camera, more, behind), 0);
    assert_int_equal(cupola_camera_sees_box(&camera, behind, ahead), 1);
    assert_int_equal(cupola_camera_sees_box(&camera, unknown, more), 1);
    assert_int_equal(cupola_camera_sees_box(&camera, endless, more), 1);
    assert_int_equal(cupola_camera_sees_sphere(NULL, ahead, 1), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_camera_sees_sphere(&camera, NULL, 1), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_camera_sees_box(NULL, ahead, more), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_camera_sees_box(&camera, NULL, more), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_camera_sees_box(&camera, ahead, NULL), CUPOLA_ERROR_ARGUMENT);
    camera.border_count = 0;
    for (int p = 0; p < 6; p++)
        for (int i = 0; i < 4; i++)
            camera.planes[p][i] = i == 3 ? 1.0f : 0.0f;
    assert_int_equal(cupola_camera_sees_sphere(&camera, behind, 1), 1);
    cupola_plan_destroy(&plan);
}

int main(void)
{
    const struct CMUnitTest camera_cull[] = {
        cmocka_unit_test(a_sphere_is_never_left_out_where_a_point_of_it_shows),
        cmocka_unit_test(a_box_is_never_left_out_where_a_point_of_it_shows),
        cmocka_unit_test(objects_taken_for_smaller_than_they_are_are_caught),
        cmocka_unit_test(points_on_the_border_of_a_view_are_seen),
        cmocka_unit_test(borders_leave_room_for_the_guard_band_and_no_more),
        cmocka_unit_test(what_makes_no_sense_is_seen_and_null_is_refused),
    };
    return cmocka_run_group_tests(camera_cull, NULL, NULL);
}
