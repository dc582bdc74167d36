/*
 * The resolution of a plan against independent counts: rays a little apart, met by the views as the
 * plan says.
 */
#include <stdlib.h>

#include "message.h"
#include "resolution_of.h"

static struct cupola_rig rig_number(int number)
{
    static const double fovs[3] = {140.0, 180.0, 220.0};
    uint64_t seed = 7100 + (uint64_t)number;
    struct cupola_rig rig = random_rig(&seed, number % 2 ? 0.5 : 0.0);
    enum cupola_lens_model model = (enum cupola_lens_model)(number % 6);
    double fov_deg = model == CUPOLA_LENS_HEMISPHERIC ? 170.0 : fovs[number % 3];
    rig.output_count = 1 + number % 2;
    for (int i = 0; i < rig.output_count; i++) {
        rig.outputs[i] = rig.outputs[0];
        rig.outputs[i].lens = random_lens(&seed, model, radians(fov_deg));
        rig.outputs[i].width_px = 91;
        rig.outputs[i].height_px = 73;
        rig.outputs[i].circle = (struct cupola_circle){44.0, 38.0, number % 3 ? 36.0 : 50.0};
        rig.outputs[i].aim.yaw_rad += i;
    }
    rig.screen.cap_rad = number % 4 == 3 ? radians(120.0) : 0.0;
    return rig;
}

/* ---- pixels, one by one ---- */

/* What one pixel has of its view. */
struct found {
    int view;
    double coverage, solid_angle_sr, area, least, most;
};

/* Its middle, or half a pixel inside of the rim. */
static void place_of(const struct cupola_output *output, int x, int y, double place_px[2])
{
    const struct cupola_circle *circle = &output->circle;
    double dx = x + 0.5 - circle->center_x_px, dy = y + 0.5 - circle->center_y_px;
    double part = fmin(1.0, (circle->radius_px - 0.5) / hypot(dx, dy));
    place_px[0] = circle->center_x_px + part * dx;
    place_px[1] = circle->center_y_px + part * dy;
}

/* By differences: texels between two rays that are 1/500 px apart, both in the middle's view. */
static bool find_pixel(const cupola_plan *plan, int output, int x, int y, struct found *found)
{
    const cupola_dome *dome = cupola_plan_dome(plan);
    double place[2], j[4], step = 1e-3;
    struct cupola_ray ray;
    if (cupola_dome_ray(dome, output, NULL, x + 0.5, y + 0.5, &ray) != 1)
        return false;
    found->coverage = ray.coverage;
    place_of(&cupola_dome_rig(dome)->outputs[output], x, y, place);
    cupola_dome_ray(dome, output, NULL, place[0], place[1], &ray);
    found->solid_angle_sr = ray.solid_angle_sr;
    found->view = cupola_plan_select(plan, ray.direction);
    for (int axis = 0; axis < 2; axis++) {
        double from[2], to[2];
        cupola_dome_ray(dome, output, NULL, place[0] - (axis ? 0 : step),
                        place[1] - (axis ? step : 0), &ray);
        assert_int_equal(cupola_plan_texel(plan, found->view, ray.direction, from), 1);
        cupola_dome_ray(dome, output, NULL, place[0] + (axis ? 0 : step),
                        place[1] + (axis ? step : 0), &ray);
        assert_int_equal(cupola_plan_texel(plan, found->view, ray.direction, to), 1);
        for (int i = 0; i < 2; i++)
            j[2 * i + axis] = (to[i] - from[i]) / (2.0 * step);
    }
    double trace = j[0] * j[0] + j[1] * j[1] + j[2] * j[2] + j[3] * j[3];
    found->area = fabs(j[0] * j[3] - j[1] * j[2]);
    double apart = sqrt(fmax(trace * trace - 4.0 * found->area * found->area, 0.0));
    found->most = sqrt((trace + apart) / 2.0);
    found->least = found->area / found->most;
    return true;
}

/* How far a spread is from some numbers, as a part of them: ends, and the middle by counting. */
static double spread_error(const struct cupola_spread *spread, const struct found *all, int count,
                           int view, size_t member)
{
    double least = HUGE_VAL, most = 0.0, below = 0.0, above = 0.0, total = 0.0, slack = 1e-4;
    for (int i = 0; i < count; i++) {
        double value = *(const double *)((const char *)&all[i] + member);
        if (all[i].view != view)
            continue;
        least = fmin(least, value);
        most = fmax(most, value);
        below += value < spread->median * (1.0 - slack);
        above += value > spread->median * (1.0 + slack);
        total += 1.0;
    }
    if (!(total > 0.0))
        return spread->max;
    double middle = below <= total / 2.0 && above <= total / 2.0 ? 0.0 : 1.0;
    return fmax(middle, fmax(fabs(spread->min / least - 1.0), fabs(spread->max / most - 1.0)));
}

static double views_error(const struct cupola_resolution *resolution, const struct found *all,
                          int count)
{
    double worst = 0.0;
    for (int v = 0; v < resolution->views; v++) {
        const struct cupola_view_resolution *view = &resolution->view[v];
        double pixels = 0.0;
        for (int i = 0; i < count; i++)
            pixels += all[i].view == v ? all[i].coverage : 0.0;
        worst = fmax(worst, fabs(view->pixels - pixels) / fmax(pixels, 1.0));
        worst = fmax(worst, spread_error(&view->texels_per_pixel, all, count, v,
                                         offsetof(struct found, area)));
        worst = fmax(worst, spread_error(&view->least_texels_per_pixel, all, count, v,
                                         offsetof(struct found, least)));
        worst = fmax(worst, spread_error(&view->most_texels_per_pixel, all, count, v,
                                         offsetof(struct found, most)));
    }
    return worst;
}

/* Ends by the largest and smallest solid angle, the middle by how much of them is coarser. */
static double degrees_error(const struct cupola_resolution *resolution, const struct found *all,
                            int count)
{
    const struct cupola_spread *spread = &resolution->pixels_per_degree;
    double largest = 0.0, smallest = HUGE_VAL, sum = 0.0, coarser = 0.0, finer = 0.0;
    for (int i = 0; i < count; i++) {
        double per_degree = 1.0 / (sqrt(all[i].solid_angle_sr) * 180.0 / pi);
        largest = fmax(largest, per_degree);
        smallest = fmin(smallest, per_degree);
        sum += all[i].solid_angle_sr;
        coarser += per_degree < spread->median * (1.0 - 1e-4) ? all[i].solid_angle_sr : 0.0;
        finer += per_degree > spread->median * (1.0 + 1e-4) ? all[i].solid_angle_sr : 0.0;
    }
    double middle = coarser <= sum / 2.0 && finer <= sum / 2.0 ? 0.0 : 1.0;
    return fmax(middle,
                fmax(fabs(spread->min / smallest - 1.0), fabs(spread->max / largest - 1.0)));
}

static void check_place(const cupola_plan *plan, const struct cupola_resolution_place *at,
                        double per_degree)
{
    struct cupola_ray ray;
    double place[2];
    const cupola_dome *dome = cupola_plan_dome(plan);
    place_of(&cupola_dome_rig(dome)->outputs[at->output], (int)at->pixel_px[0],
             (int)at->pixel_px[1], place);
    cupola_dome_ray(dome, at->output, NULL, place[0], place[1], &ray);
    check_near(1.0 / (sqrt(ray.solid_angle_sr) * 180.0 / pi) / per_degree, 1.0, 1e-6);
    check_at_most(angle_between(ray.direction, at->direction), 1e-9);
}

static void numbers_are_those_of_pixels_asked_one_by_one(void **state)
{
    (void)state;
    for (int number = 0; number < 12; number++) {
        struct cupola_rig rig = rig_number(number);
        struct cupola_plan_params params = {.layout = CUPOLA_LAYOUT_ROTATED,
                                            .density = number % 5 == 4 ? 1.7 : 0.0};
        cupola_plan *plan = plan_of_rig(&rig, &params);
        int output = number % 4 == 1 ? -1 : rig.output_count - 1, count = 0;
        struct found *all = malloc(2 * 91 * 73 * sizeof *all);
        assert_non_null(all);
        for (int o = output < 0 ? 0 : output; o < rig.output_count; o++)
            for (int i = 0; i < 91 * 73; i++)
                count += find_pixel(plan, o, i % 91, i / 91, &all[count]);
        struct cupola_resolution resolution = measured(plan, output);
        /* Differences over 2e-3 px: 1e-6 of the bend of a coarse lens. */
        check_at_most(views_error(&resolution, all, count), 2e-4);
        check_at_most(degrees_error(&resolution, all, count), 1e-6);
        check_place(plan, &resolution.coarsest, resolution.pixels_per_degree.min);
        check_place(plan, &resolution.finest, resolution.pixels_per_degree.max);
        for (int i = 0; i < count; i++) { /* the control */
            all[i].least *= 1.001;
            all[i].solid_angle_sr *= 1.0001;
        }
        check_at_least(views_error(&resolution, all, count), 5e-4);
        check_at_least(degrees_error(&resolution, all, count), 1e-5);
        free(all);
        cupola_plan_destroy(&plan);
    }
}

/* ---- texels that nothing touches ---- */

/* Marks what a filter that reaches `reach` texels touches from places all over each pixel. */
static double never_sampled(const cupola_plan *plan, double reach)
{
    enum { PLACES = 6 };
    const cupola_dome *dome = cupola_plan_dome(plan);
    const struct cupola_rig *rig = cupola_dome_rig(dome);
    const struct cupola_plan_report *report = cupola_plan_report(plan);
    int width = report->atlas_width_px;
    unsigned char *touched = calloc((size_t)(width * report->atlas_height_px), 1);
    double all = 0.0, sum = 0.0;
    assert_non_null(touched);
    for (int o = 0; o < rig->output_count; o++)
        for (int i = 0; i < 91 * 73 * PLACES * PLACES; i++) {
            double x = (i % (91 * PLACES) + 0.5) / PLACES, y = (i / (91 * PLACES) + 0.5) / PLACES;
            struct cupola_ray ray;
            double texel[2];
            if (cupola_dome_ray(dome, o, NULL, floor(x) + 0.5, floor(y) + 0.5, &ray) != 1 ||
                cupola_dome_ray(dome, o, NULL, x, y, &ray) < 0)
                continue;
            int view = cupola_plan_select(plan, ray.direction);
            const struct cupola_rect *rect = &cupola_plan_view(plan, view)->rect;
            assert_int_equal(cupola_plan_texel(plan, view, ray.direction, texel), 1);
            int top = (int)fmin(floor(texel[1] + reach - 0.5), rect->y + rect->height - 1.0);
            int right = (int)fmin(floor(texel[0] + reach - 0.5), rect->x + rect->width - 1.0);
            for (int v = (int)fmax(ceil(texel[1] - reach - 0.5), rect->y); v <= top; v++)
                for (int u = (int)fmax(ceil(texel[0] - reach - 0.5), rect->x); u <= right; u++)
                    touched[v * width + u] = 1;
        }
    for (int i = 0; i < width * report->atlas_height_px; i++)
        sum += touched[i];
    for (int v = 0; v < cupola_plan_view_count(plan); v++) {
        const struct cupola_rect *rect = &cupola_plan_view(plan, v)->rect;
        all += (double)rect->width * rect->height;
    }
    free(touched);
    return all - sum;
}

static void texels_that_no_pixel_touches_are_counted(void **state)
{
    (void)state;
    for (int number = 0; number < 6; number++) {
        struct cupola_rig rig = rig_number(2 * number);
        struct cupola_plan_params params = {.layout = CUPOLA_LAYOUT_ROTATED, .guard_px = 2};
        cupola_plan *plan = plan_of_rig(&rig, &params);
        struct cupola_resolution resolution = measured(plan, -1);
        double texels = 0.0, counted = 0.0, unused = never_sampled(plan, 2.05);
        for (int v = 0; v < resolution.views; v++) {
            const struct cupola_rect *rect = &cupola_plan_view(plan, v)->rect;
            check_near(resolution.view[v].texels, (double)rect->width * rect->height, 0.0);
            texels += resolution.view[v].texels;
            counted += resolution.view[v].texels_never_sampled;
        }
        check_near(resolution.texels, texels, 0.0);
        check_near(resolution.texels_never_sampled, counted, 0.0);
        /* The mask widens the boxes of its squares: to some 3 % of the texels, never fewer. */
        check_at_most(counted, unused);
        check_at_least(counted, unused - 0.03 * texels);
        check_at_least(fabs(never_sampled(plan, 4.05) - unused), 0.04 * texels); /* the control */
        cupola_plan_destroy(&plan);
    }
}

/* ---- large images, wrong questions ---- */

/* An equisolid lens has the same everywhere: h half of 180 degrees, rho 1100 px. */
static void large_images_are_asked_in_part(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_EQUISOLID, 180.0, 2400);
    cupola_plan *plan = plan_of_rig(&rig, NULL);
    struct cupola_resolution resolution = measured(plan, 0);
    double expected = pi / 180.0 * 1200.0 / (2.0 * sin(pi / 4.0));
    check_near(resolution.pixels_per_degree.min / expected, 1.0, 1e-6);
    check_near(resolution.pixels_per_degree.median / expected, 1.0, 1e-6);
    check_near(resolution.pixels_per_degree.max / expected, 1.0, 1e-6);
    check_near(resolution.pixels / (pi * 1200.0 * 1200.0), 1.0, 1e-3);
    assert_string_equal(resolution.advice, "views and projector match");
    cupola_plan_destroy(&plan);
}

static void what_makes_no_sense_is_refused_and_changes_nothing(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 140.0, 40);
    struct cupola_resolution resolution = {.views = -7};
    struct cupola_error error = {CUPOLA_OK, ""};
    cupola_plan *plan = plan_of_rig(&rig, NULL);
    assert_int_equal(cupola_resolution_measure(NULL, 0, &resolution, &error),
                     CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_resolution_measure(plan, 0, NULL, &error), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_resolution_measure(plan, 1, &resolution, &error),
                     CUPOLA_ERROR_ARGUMENT);
    check_message(&error, 1.0);
    assert_int_equal(cupola_resolution_measure(plan, -2, &resolution, NULL), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(resolution.views, -7);
    cupola_plan_destroy(&plan);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_are_those_of_pixels_asked_one_by_one),
        cmocka_unit_test(texels_that_no_pixel_touches_are_counted),
        cmocka_unit_test(large_images_are_asked_in_part),
        cmocka_unit_test(what_makes_no_sense_is_refused_and_changes_nothing),
    };
    return cmocka_run_group_tests_name("resolution", tests, NULL, NULL);
}
