/* How much of a pixel is lit: the rim, the frame and the edge of the screen. */
#include "oracle.h"

/*
 * Where a pixel's part of an arc counts as a straight line, the area between both is what is
 * wrong: over the diagonal of a pixel and with a radius of rho px, at most 2/3 sqrt(2) / (4 rho).
 */
static double straight_line_error(double rho_px)
{
    return 0.25 / rho_px;
}

static double overlap(double low, double high, double from, double to)
{
    return fmax(0.0, fmin(high, to) - fmax(low, from));
}

/* A square of side 1 round a place, cut by a circle and a frame: 256 rows of exact chords. */
static double chord_coverage(const struct cupola_output *output, double x, double y)
{
    double sum = 0.0;
    for (int i = 0; i < 256; i++) {
        double row = y - 0.5 + (i + 0.5) / 256.0, dy = row - output->circle.center_y_px;
        double square = output->circle.radius_px * output->circle.radius_px - dy * dy;
        if (row < 0.0 || row > output->height_px || square <= 0.0)
            continue;
        double low = fmax(0.0, output->circle.center_x_px - sqrt(square));
        double high = fmin(output->width_px, output->circle.center_x_px + sqrt(square));
        sum += overlap(low, high, x - 0.5, x + 0.5) / 256.0;
    }
    return sum;
}

static double coverage_at(const cupola_dome *dome, double x, double y)
{
    struct cupola_ray ray;
    int lit = cupola_dome_ray(dome, 0, NULL, x, y, &ray);
    assert_int_equal(lit, ray.coverage > 0.0);
    check_at_least(ray.coverage, 0.0);
    check_at_most(ray.coverage, 1.0);
    return ray.coverage;
}

/* A full circle of 100 px, one that is truncated and off-centre, and one larger than its frame. */
static const struct cupola_circle circles[] = {
    {100.0, 100.0, 100.0}, {131.3, 77.7, 99.1}, {40.0, -60.0, 210.5}};

static struct cupola_rig rig_of_circle(int i)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 200);
    rig.outputs[0].height_px = 201;
    rig.outputs[0].circle = circles[i];
    return rig;
}

static void a_pixel_is_covered_as_much_as_circle_and_frame_cover_it(void **state)
{
    (void)state;
    for (int i = 0; i < 3; i++) {
        struct cupola_rig rig = rig_of_circle(i);
        cupola_dome *dome = dome_of(&rig);
        double tolerance = straight_line_error(circles[i].radius_px) + 1.0 / 256.0;
        for (int y = 0; y < 201; y++) {
            for (int x = 0; x < 200; x++)
                check_near(coverage_at(dome, x + 0.5, y + 0.5),
                           chord_coverage(&rig.outputs[0], x + 0.5, y + 0.5), tolerance);
        }
        cupola_dome_destroy(&dome);
    }
}

/* The same for squares round any place, as long as they lie in the frame or quite outside. */
static void a_place_between_pixels_has_a_square_of_its_own(void **state)
{
    (void)state;
    uint64_t seed = 41;
    for (int i = 0; i < 3; i++) {
        struct cupola_rig rig = rig_of_circle(i);
        cupola_dome *dome = dome_of(&rig);
        double tolerance = straight_line_error(circles[i].radius_px) + 1.0 / 256.0;
        for (int j = 0; j < 5000; j++) {
            double x = random_between(&seed, -2.0, 202.0), y = random_between(&seed, -2.0, 203.0);
            double edge = fmin(fmin(x, 200.0 - x), fmin(y, 201.0 - y));
            if (edge >= 0.5 || edge <= -0.5)
                check_near(coverage_at(dome, x, y), chord_coverage(&rig.outputs[0], x, y),
                           tolerance);
        }
        cupola_dome_destroy(&dome);
    }
}

static void a_circle_wrong_by_a_tenth_of_a_pixel_is_caught(void **state)
{
    (void)state;
    struct cupola_rig rig = rig_of_circle(1);
    cupola_dome *dome = dome_of(&rig);
    double most = 0.0;
    rig.outputs[0].circle.radius_px += 0.1;
    for (int x = 0; x < 200; x++)
        most = fmax(most, fabs(coverage_at(dome, x + 0.5, 100.5) -
                               chord_coverage(&rig.outputs[0], x + 0.5, 100.5)));
    check_at_least(most, 0.05);
    cupola_dome_destroy(&dome);
}

/*
 * Straight lines in place of arcs lose, along the whole rim, 2 pi rho px times the mean of
 * s^2 / (2 rho) over a pixel, and that is 2 pi / 24 px whatever the radius.
 */
static void the_coverages_add_up_to_the_area_of_the_disc(void **state)
{
    (void)state;
    static const double radii[] = {4.0, 31.4, 100.0, 250.0};
    for (int i = 0; i < 4; i++) {
        struct cupola_rig rig = plain_rig(CUPOLA_LENS_HEMISPHERIC, 180.0, 512);
        rig.outputs[0].circle = (struct cupola_circle){255.7, 256.4, radii[i]};
        cupola_dome *dome = dome_of(&rig);
        double sum = 0.0;
        for (int y = 0; y < 512; y++) {
            for (int x = 0; x < 512; x++)
                sum += coverage_at(dome, x + 0.5, y + 0.5);
        }
        check_near(sum, pi * radii[i] * radii[i], 2.0 * pi / 24.0 + 0.1);
        cupola_dome_destroy(&dome);
    }
}

/* Whether the oracle sees a place of the image light the screen. */
static int lights_the_screen(const struct cupola_rig *rig, double x, double y)
{
    const struct cupola_output *output = &rig->outputs[0];
    if (x < 0.0 || y < 0.0 || x > output->width_px || y > output->height_px ||
        hypot(x - output->circle.center_x_px, y - output->circle.center_y_px) >
            output->circle.radius_px)
        return 0;
    struct oracle_ray ray = oracle_ray_at(rig, rig->eye_m, x, y);
    return -(double)ray.point[2] >= rig->screen.radius_m * cos(rig->screen.cap_rad);
}

/* 64 x 64 places of a pixel, one in each cell at random so that no edge runs along a row. */
static double counted_coverage(const struct cupola_rig *rig, uint64_t *seed, double x, double y)
{
    int count = 0;
    for (int i = 0; i < 64; i++) {
        for (int j = 0; j < 64; j++)
            count += lights_the_screen(rig, x - 0.5 + (i + random_between(seed, 0.0, 1.0)) / 64.0,
                                       y - 0.5 + (j + random_between(seed, 0.0, 1.0)) / 64.0);
    }
    return count / 4096.0;
}

/*
 * The screen's edge as the lens sees it, for a lens that is off the axis and aims elsewhere: a
 * curve of about the circle's radius. Counted: of 4096 places some 90 lie on the edge, each of
 * them is right with even chance, so 0.003 at three standard deviations.
 */
static void the_edge_of_the_screen_cuts_pixels_like_the_rim(void **state)
{
    (void)state;
    uint64_t seed = 42;
    int on_the_edge = 0;
    for (int i = 0; i < 6; i++) {
        struct cupola_rig rig = random_rig(&seed, 0.3);
        rig.outputs[0].circle.radius_px = 120.0;
        rig.outputs[0].lens.model = CUPOLA_LENS_EQUISOLID;
        rig.outputs[0].lens.fov_rad = radians(180.0);
        rig.outputs[0].aim = (struct cupola_aim){0.2, -0.3, 1.0};
        rig.screen.cap_rad = radians(random_between(&seed, 40.0, 70.0));
        cupola_dome *dome = dome_of(&rig);
        for (int j = 0; j < 400; j++) {
            double x = floor(random_between(&seed, 0.0, rig.outputs[0].width_px)) + 0.5;
            double y = floor(random_between(&seed, 0.0, rig.outputs[0].height_px)) + 0.5;
            int corners = 0;
            for (int k = 0; k < 4; k++)
                corners +=
                    lights_the_screen(&rig, x + (k % 2 ? 0.5 : -0.5), y + (k / 2 ? 0.5 : -0.5));
            double covered = coverage_at(dome, x, y);
            double r =
                hypot(x - rig.outputs[0].circle.center_x_px, y - rig.outputs[0].circle.center_y_px);
            if (corners % 4 == 0 || fabs(r - 120.0) < 1.5) {
                check_near(covered, corners / 4.0, fabs(r - 120.0) < 1.5 ? 1.0 : 0.01);
                continue;
            }
            on_the_edge++;
            check_near(covered, counted_coverage(&rig, &seed, x, y),
                       4.0 * straight_line_error(120.0) + 0.003);
        }
        cupola_dome_destroy(&dome);
    }
    check_at_least(on_the_edge, 10);
}

/* Projector at the centre: the edge of the screen is a circle round that of the image. */
static void a_cap_within_the_lens_is_a_smaller_circle(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 300);
    rig.screen.cap_rad = radians(72.0);
    cupola_dome *dome = dome_of(&rig);
    struct cupola_output smaller = {.width_px = 300, .height_px = 300, .circle = {150, 150, 120}};
    for (int y = 0; y < 300; y++) {
        for (int x = 0; x < 300; x++)
            check_near(coverage_at(dome, x + 0.5, y + 0.5),
                       chord_coverage(&smaller, x + 0.5, y + 0.5),
                       straight_line_error(120.0) + 1.0 / 256.0);
    }
    cupola_dome_destroy(&dome);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pixel_is_covered_as_much_as_circle_and_frame_cover_it),
        cmocka_unit_test(a_place_between_pixels_has_a_square_of_its_own),
        cmocka_unit_test(a_circle_wrong_by_a_tenth_of_a_pixel_is_caught),
        cmocka_unit_test(the_coverages_add_up_to_the_area_of_the_disc),
        cmocka_unit_test(the_edge_of_the_screen_cuts_pixels_like_the_rim),
        cmocka_unit_test(a_cap_within_the_lens_is_a_smaller_circle),
    };
    return cmocka_run_group_tests_name("coverage", tests, NULL, NULL);
}
