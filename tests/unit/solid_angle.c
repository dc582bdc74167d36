/* Derivatives of rays along the image, and the solid angles that pixels cover. */
#include "oracle.h"

static struct cupola_ray ray_at(const cupola_dome *dome, const double eye[3], double x, double y)
{
    struct cupola_ray ray;
    if (cupola_dome_ray(dome, 0, eye, x, y, &ray) < 0)
        fail_msg("no ray at %g, %g", x, y);
    return ray;
}

/* Change of the direction per pixel along (dx, dy): differences of fourth order. */
static void difference(const cupola_dome *dome, double x, double y, double dx, double dy,
                       double change[3])
{
    static const double weights[4] = {1.0, -8.0, 8.0, -1.0};
    static const double places[4] = {-2.0, -1.0, 1.0, 2.0};
    double step = 1e-3;
    for (int i = 0; i < 3; i++)
        change[i] = 0.0;
    for (int j = 0; j < 4; j++) {
        struct cupola_ray ray =
            ray_at(dome, NULL, x + places[j] * step * dx, y + places[j] * step * dy);
        for (int i = 0; i < 3; i++)
            change[i] += weights[j] * ray.direction[i] / (12.0 * step);
    }
}

static double length_of_cross(const double a[3], const double b[3])
{
    return sqrt(pow(a[1] * b[2] - a[2] * b[1], 2.0) + pow(a[2] * b[0] - a[0] * b[2], 2.0) +
                pow(a[0] * b[1] - a[1] * b[0], 2.0));
}

/*
 * The largest difference between the library's derivatives at a place and the differences, as a
 * part of the derivative's length. Rounding: 1e-16 / 1e-3 px against changes of some 1e-2 per px.
 * A table's curve bends suddenly at its samples, where differences see half a step of the bend.
 */
static double derivative_error(const cupola_dome *dome, double x, double y, double skew)
{
    struct cupola_ray ray = ray_at(dome, NULL, x, y);
    double dx[3], dy[3], error = 0.0;
    difference(dome, x, y, 1.0, skew, dx);
    difference(dome, x, y, 0.0, 1.0, dy);
    double scale = 1e-4 + sqrt(dx[0] * dx[0] + dx[1] * dx[1] + dx[2] * dx[2]);
    for (int i = 0; i < 3; i++)
        error =
            fmax(error, fmax(fabs(dx[i] - ray.direction_dx[i]), fabs(dy[i] - ray.direction_dy[i])) /
                            scale);
    error = fmax(error, fabs(ray.solid_angle_sr / length_of_cross(dx, dy) - 1.0));
    return error;
}

static void derivatives_are_those_of_the_ray(void **state)
{
    (void)state;
    uint64_t seed = 51;
    for (int i = 0; i < 300; i++) {
        struct cupola_rig rig = random_rig(&seed, 0.8);
        const struct cupola_circle *circle = &rig.outputs[0].circle;
        cupola_dome *dome = dome_of(&rig);
        double tolerance = rig.outputs[0].lens.model == CUPOLA_LENS_TABLE ? 1e-3 : 1e-7;
        for (int j = 0; j < 10; j++) {
            double r = random_between(&seed, 0.0, 0.95), theta = random_between(&seed, -pi, pi);
            check_at_most(
                derivative_error(dome, circle->center_x_px + r * cos(theta) * circle->radius_px,
                                 circle->center_y_px + r * sin(theta) * circle->radius_px, 0.0),
                tolerance);
        }
        cupola_dome_destroy(&dome);
    }
}

/* There the formulas have 0 / 0. */
static void derivatives_hold_on_the_lens_axis_and_beside_it(void **state)
{
    (void)state;
    uint64_t seed = 52;
    for (int i = 0; i < 60; i++) {
        struct cupola_rig rig = random_rig(&seed, 0.8);
        const struct cupola_circle *circle = &rig.outputs[0].circle;
        cupola_dome *dome = dome_of(&rig);
        double tolerance = rig.outputs[0].lens.model == CUPOLA_LENS_TABLE ? 1e-3 : 1e-7;
        static const double off[] = {0.0, 1e-300, 1e-12, 1e-6, 1e-3};
        for (int j = 0; j < 5; j++)
            check_at_most(derivative_error(dome, circle->center_x_px + off[j],
                                           circle->center_y_px - off[j], 0.0),
                          tolerance);
        cupola_dome_destroy(&dome);
    }
}

static void a_derivative_along_a_wrong_line_is_caught(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 200);
    cupola_dome *dome = dome_of(&rig);
    check_at_most(derivative_error(dome, 130.0, 70.0, 0.0), 1e-7);
    check_at_least(derivative_error(dome, 130.0, 70.0, tan(radians(0.1))), 1e-4);
    cupola_dome_destroy(&dome);
}

/* Section 3's table, per area of a circle of radius 1. */
static double closed_form(enum cupola_lens_model model, double angle, double h)
{
    switch (model) {
    case CUPOLA_LENS_ANGULAR:
        return angle > 0.0 ? h * h * sin(angle) / angle : h * h;
    case CUPOLA_LENS_HEMISPHERIC:
        return sin(h) * sin(h) / cos(angle);
    case CUPOLA_LENS_EQUISOLID:
        return 4.0 * sin(h / 2.0) * sin(h / 2.0);
    default:
        return 4.0 * pow(tan(h / 2.0), 2.0) * pow(cos(angle / 2.0), 4.0);
    }
}

static void on_axis_a_solid_angle_is_the_closed_form(void **state)
{
    (void)state;
    uint64_t seed = 53;
    for (int i = 0; i < 400; i++) {
        enum cupola_lens_model model = (enum cupola_lens_model)(i % 4);
        double fov = random_between(&seed, 60.0, model == CUPOLA_LENS_HEMISPHERIC ? 180.0 : 300.0);
        struct cupola_rig rig = plain_rig(model, fov, 200);
        cupola_dome *dome = dome_of(&rig);
        double x = random_between(&seed, 30.0, 170.0), y = random_between(&seed, 31.0, 169.0);
        if (i < 4)
            x = y = 100.0;
        struct cupola_ray ray = ray_at(dome, NULL, x, y);
        double angle = atan2(hypot(ray.direction[0], ray.direction[1]), -ray.direction[2]);
        double expected = closed_form(model, angle, radians(fov) / 2.0) / 1e4;
        check_near(ray.solid_angle_sr / expected, 1.0, 1e-10);
        cupola_dome_destroy(&dome);
    }
}

static void off_axis_a_solid_angle_is_that_of_a_patch_of_the_screen(void **state)
{
    (void)state;
    uint64_t seed = 54;
    for (int i = 0; i < 300; i++) {
        struct cupola_rig rig = random_rig(&seed, 0.8);
        const struct cupola_circle *circle = &rig.outputs[0].circle;
        static const double centre[3] = {0.0, 0.0, 0.0};
        cupola_dome *dome = dome_of(&rig);
        double r = random_between(&seed, 0.0, 1.0), theta = random_between(&seed, -pi, pi);
        double x = circle->center_x_px + r * cos(theta) * circle->radius_px;
        double y = circle->center_y_px + r * sin(theta) * circle->radius_px;
        struct cupola_ray ray = ray_at(dome, NULL, x, y), from_centre = ray_at(dome, centre, x, y);
        double v[3], normal[3], radius = rig.screen.radius_m, square = 0.0;
        for (int j = 0; j < 3; j++) {
            v[j] = ray.point_m[j] - rig.eye_m[j];
            normal[j] = ray.point_m[j] / radius;
            square += v[j] * v[j];
        }
        double expected =
            from_centre.solid_angle_sr * radius * radius * cos(angle_between(v, normal)) / square;
        check_near(ray.solid_angle_sr / expected, 1.0, 1e-10);
        cupola_dome_destroy(&dome);
    }
}

/* Sum of solid angle times coverage, seen from the lens, over the pixels of a full circle. */
static double sum_of_pixels(const struct cupola_rig *rig, double without_rim_px)
{
    cupola_dome *dome = dome_of(rig);
    const struct cupola_output *output = &cupola_dome_rig(dome)->outputs[0];
    double rho = output->circle.radius_px - without_rim_px, sum = 0.0;
    for (int j = 0; j < output->height_px; j++) {
        for (int i = 0; i < output->width_px; i++) {
            double x = i + 0.5, y = j + 0.5, part = 0.0;
            struct cupola_ray ray = ray_at(dome, output->position_m, x, y);
            /* Chords, as the smaller disc is not the dome's own. */
            for (int k = 0; k < 64 && without_rim_px > 0.0; k++) {
                double dy = y - 0.5 + (k + 0.5) / 64.0 - output->circle.center_y_px;
                double half = sqrt(fmax(0.0, rho * rho - dy * dy));
                double dx = x - output->circle.center_x_px;
                part += fmax(0.0, fmin(dx + 0.5, half) - fmax(dx - 0.5, -half)) / 64.0;
            }
            sum += ray.solid_angle_sr * (without_rim_px > 0.0 ? part : ray.coverage);
        }
    }
    cupola_dome_destroy(&dome);
    return sum;
}

static double cap_of_sphere(double h)
{
    return 2.0 * pi * (1.0 - cos(h));
}

/*
 * The sum over squares of 1 px is a midpoint rule: wrong by the density's second derivative / 24,
 * summed some (1 px / rho)^2. At the rim the coverage is of the part inside, but the density that
 * of the middle of the square, and straight lines lose 0.26 px of area: some 1 px^2 of the disc's
 * 3 rho^2. Together 2 / rho^2 of the whole, times what density the rim has over the mean.
 */
static void the_solid_angles_add_up_to_the_cap_that_the_lens_throws(void **state)
{
    (void)state;
    uint64_t seed = 55;
    for (int model = 0; model <= CUPOLA_LENS_TABLE; model++) {
        struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 301);
        double fov = radians(model == CUPOLA_LENS_HEMISPHERIC ? 150.0 : 200.0);
        rig.outputs[0].lens = random_lens(&seed, (enum cupola_lens_model)model, fov);
        rig.outputs[0].circle = (struct cupola_circle){150.2, 150.7, 149.9};
        random_in_ball(&seed, 0.8, rig.outputs[0].position_m);
        rig.outputs[0].aim.pitch_rad = 0.4;
        /* Stereographic at 200 degrees: the middle is 5.9 times the rim; hemispheric: the rim is
         * 3.9 times the middle. */
        check_near(sum_of_pixels(&rig, 0.0) / cap_of_sphere(fov / 2.0), 1.0,
                   4.0 * 2.0 / (150.0 * 150.0));
        /* The bound is finer than a tenth of a degree. */
        check_at_least(
            fabs(cap_of_sphere(fov / 2.0 + radians(0.1)) / cap_of_sphere(fov / 2.0) - 1.0),
            8.0 / (150.0 * 150.0));
    }
}

/*
 * The density at the rim of this one is infinite: the outer 4 px are integrated in polar
 * coordinates with r = sin u, which takes the singularity out: dA = rho^2 sin u cos u du dtheta.
 */
static void a_hemispheric_lens_of_180_degrees_adds_up_with_its_rim_integrated(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_HEMISPHERIC, 180.0, 300);
    double rho = 150.0, from = asin((rho - 4.0) / rho), rim = 0.0;
    cupola_dome *dome = dome_of(&rig);
    for (int i = 0; i < 200; i++) {
        double u = from + (pi / 2.0 - from) * (i + 0.5) / 200.0;
        for (int j = 0; j < 64; j++) {
            double theta = 2.0 * pi * j / 64.0;
            struct cupola_ray ray = ray_at(dome, NULL, rho + rho * sin(u) * cos(theta),
                                           rho + rho * sin(u) * sin(theta));
            rim += ray.solid_angle_sr * rho * rho * sin(u) * cos(u);
        }
    }
    rim *= (pi / 2.0 - from) / 200.0 * (2.0 * pi / 64.0);
    cupola_dome_destroy(&dome);
    /* Midpoints where the density falls by half within 4 px of the edge: 1e-4. */
    check_near((sum_of_pixels(&rig, 4.0) + rim) / (2.0 * pi), 1.0, 3e-4);
    check_at_least(rim / (2.0 * pi), 0.1);
}

static void a_pixel_on_a_singular_rim_has_a_finite_solid_angle(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_HEMISPHERIC, 180.0, 100);
    cupola_dome *dome = dome_of(&rig);
    for (int i = 0; i < 100; i++) {
        struct cupola_ray ray = ray_at(dome, NULL, 50.0 + 60.0 * cos(i), 50.0 + 60.0 * sin(i));
        check_at_least(ray.solid_angle_sr, 0.0);
        assert_true(isfinite(ray.solid_angle_sr));
        for (int j = 0; j < 3; j++)
            assert_true(isfinite(ray.direction_dx[j]) && isfinite(ray.direction_dy[j]));
    }
    cupola_dome_destroy(&dome);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(derivatives_are_those_of_the_ray),
        cmocka_unit_test(derivatives_hold_on_the_lens_axis_and_beside_it),
        cmocka_unit_test(a_derivative_along_a_wrong_line_is_caught),
        cmocka_unit_test(on_axis_a_solid_angle_is_the_closed_form),
        cmocka_unit_test(off_axis_a_solid_angle_is_that_of_a_patch_of_the_screen),
        cmocka_unit_test(the_solid_angles_add_up_to_the_cap_that_the_lens_throws),
        cmocka_unit_test(a_hemispheric_lens_of_180_degrees_adds_up_with_its_rim_integrated),
        cmocka_unit_test(a_pixel_on_a_singular_rim_has_a_finite_solid_angle),
    };
    return cmocka_run_group_tests_name("solid_angle", tests, NULL, NULL);
}
