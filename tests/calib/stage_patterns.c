/* What patterns look like, beside the rays of the pixels that show them. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "stage_fixture.h"

enum { SIZE = 512 };

static const double PI = 3.14159265358979323846;
static const double RADIANS = 3.14159265358979323846 / 180;

/* Latitude and longitude at a pixel, by calculus of its own. */
struct place {
    double latitude, longitude; /* rad */
    double latitude_px;         /* change per pixel, rad */
    double longitude_px;        /* likewise, as an arc */
};

static double wrapped(double angle)
{
    return angle - 2 * PI * floor(angle / (2 * PI) + 0.5);
}

static void angles(bool about_viewer, const double v[3], double *latitude, double *longitude)
{
    double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);

    *latitude = asin((about_viewer ? v[1] : -v[2]) / length);
    *longitude = about_viewer ? atan2(-v[0], -v[2]) : atan2(v[1], v[0]);
}

/* What the pattern is a function of; false where the pixel or one beside it is at a rim. */
static bool pattern_vector(const cupola_dome *dome, bool about_viewer, double x, double y,
                           double v[3])
{
    struct cupola_ray ray;

    if (cupola_dome_ray(dome, 0, NULL, x, y, &ray) != 1 || ray.coverage < 1)
        return false;
    memcpy(v, about_viewer ? ray.direction : ray.point_m, 3 * sizeof *v);
    return true;
}

static bool find_place(const cupola_dome *dome, bool about_viewer, double x, double y,
                       struct place *place)
{
    double v[3], dx[3], dy[3], a[2], b[2];

    if (!pattern_vector(dome, about_viewer, x, y, v) ||
        !pattern_vector(dome, about_viewer, x + 2, y, dx) ||
        !pattern_vector(dome, about_viewer, x, y + 2, dy) ||
        !pattern_vector(dome, about_viewer, x - 2, y, dx) ||
        !pattern_vector(dome, about_viewer, x, y - 2, dy) ||
        !pattern_vector(dome, about_viewer, x + 0.01, y, dx) ||
        !pattern_vector(dome, about_viewer, x, y + 0.01, dy))
        return false;
    angles(about_viewer, v, &place->latitude, &place->longitude);
    angles(about_viewer, dx, &a[0], &a[1]);
    angles(about_viewer, dy, &b[0], &b[1]);
    place->latitude_px = hypot(a[0] - place->latitude, b[0] - place->latitude) / 0.01;
    place->longitude_px =
        cos(place->latitude) *
        hypot(wrapped(a[1] - place->longitude), wrapped(b[1] - place->longitude)) / 0.01;
    return true;
}

/* Distance from the nearest line whose degrees are a multiple of the step, px. */
static double from_circles(const struct place *place, double step)
{
    return fabs(remainder(place->latitude / RADIANS, step)) * RADIANS / place->latitude_px;
}

static double from_meridians(const struct place *place, double step)
{
    double off = remainder(place->longitude / RADIANS, step) * RADIANS;

    return fabs(sin(off)) * cos(place->latitude) / place->longitude_px;
}

/*
 * Over many pixels: the root mean square of what the lines of 30 degrees that stand alone cover of
 * a pixel, beside what they should; and how much light there is where no line is.
 */
static void compare(const unsigned char *image, const cupola_dome *dome, bool about_viewer,
                    double *rms, int *lit_ground, int *lines)
{
    double sum = 0;
    uint64_t seed = 5;
    int height = 3 * SIZE / 4;

    *lit_ground = *lines = 0;
    for (int n = 0; n < 60000; n++) {
        int i = (int)random_between(&seed, 0, SIZE), j = (int)random_between(&seed, 0, height);
        const unsigned char *pixel = image + 4 * ((size_t)j * SIZE + (size_t)i);
        struct place place;
        double thin, circles, meridians;
        if (!find_place(dome, about_viewer, i + 0.5, j + 0.5, &place) ||
            fabs(place.latitude) > 65 * RADIANS)
            continue;
        circles = from_circles(&place, 30);
        meridians = from_meridians(&place, 30);
        thin = fmin(from_circles(&place, 10), from_meridians(&place, 10));
        if (thin > 2.5)
            *lit_ground += pixel[0] + pixel[1] + pixel[2] > 0;
        /* One strong line of those that have no colour of their own, and nothing else near. */
        if (fabs(place.latitude) < 15 * RADIANS || fabs(place.longitude) < 15 * RADIANS ||
            fmin(circles, meridians) > 2 ||
            (circles < meridians ? from_meridians(&place, 10) : from_circles(&place, 10)) < 4)
            continue;
        circles = stage_light(pixel[1]) / 0.60 - fmax(0, fmin(1, 1.5 - fmin(circles, meridians)));
        sum += circles * circles;
        ++*lines;
    }
    *rms = sqrt(sum / (*lines > 0 ? *lines : 1));
}

static void check_grid(uint64_t seed, bool about_viewer)
{
    struct cupola_rig rig, wrong;
    struct stage_fixture fixture;
    cupola_dome *dome = NULL;
    unsigned char *image;
    double rms;
    int lit, lines;

    stage_random_rig(&seed, SIZE, &rig);
    stage_fixture_make(&fixture, &rig);
    fixture.tool.pattern = PATTERN_GRID;
    fixture.tool.about = about_viewer ? ABOUT_VIEWER : ABOUT_DOME;
    image = stage_fixture_image(&fixture);
    assert_int_equal(cupola_dome_create(&rig, &dome, NULL), CUPOLA_OK);
    compare(image, dome, about_viewer, &rms, &lit, &lines);
    check_at_least(lines, 200);
    check_at_most(lit, 0);
    check_at_most(rms, 0.06);
    cupola_dome_destroy(&dome);

    /* The same picture beside a projector that is turned by 0.2 degrees. */
    wrong = rig;
    wrong.outputs[0].aim.yaw_rad += 0.2 * RADIANS;
    assert_int_equal(cupola_dome_create(&wrong, &dome, NULL), CUPOLA_OK);
    compare(image, dome, about_viewer, &rms, &lit, &lines);
    check_at_least(rms, 0.15);
    cupola_dome_destroy(&dome);
    free(image);
    stage_fixture_release(&fixture);
}

static void the_grid_is_where_the_rays_say(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 4; seed++) {
        print_message("seed %d\n", (int)seed);
        check_grid(seed, true);
        check_grid(seed, false);
    }
}

/*
 * The field of a direction: area-true disc, then Shirley and Chiu's square, by polar angles. The
 * control is a disc whose radius is the angle, which is not area-true.
 */
static int field_of(const double v[3], bool control, double *edge)
{
    double off = acos(-v[2]), round = atan2(v[1], v[0]);
    double radius = control ? 6 * off / (PI / 2) : 6 * sqrt(2) * sin(off / 2), side[2];
    int quarter = (int)floor((round + PI / 4) / (PI / 2));
    double within = (round - quarter * PI / 2) / (PI / 4) * radius;

    quarter = (quarter + 4) % 4;
    side[0] = quarter == 0 ? radius : quarter == 2 ? -radius : quarter == 1 ? -within : within;
    side[1] = quarter == 1 ? radius : quarter == 3 ? -radius : quarter == 0 ? within : -within;
    *edge = fmin(fabs(remainder(side[0], 1)), fabs(remainder(side[1], 1)));
    return off > PI / 2 ? -1 : (int)floor(side[1] + 6) * 12 + (int)floor(side[0] + 6);
}

/* What 600 x 600 pixels say of fields. */
struct fields {
    double solid[144], control[144]; /* sr */
    double white;                    /* sr that the shader painted white */
    int seen, wrong; /* pixels well within a field, and those of the colour of its neighbours */
};

static void add_fields(const unsigned char *image, const cupola_dome *dome, struct fields *fields)
{
    for (int k = 0; k < 600 * 600; k++) {
        struct cupola_ray ray;
        double edge, light = stage_light(image[4 * k]), solid;
        int field;
        if (cupola_dome_ray(dome, 0, NULL, k % 600 + 0.5, k / 600 + 0.5, &ray) != 1)
            continue;
        solid = ray.solid_angle_sr * ray.coverage;
        fields->white += (light / ray.coverage - 0.02) / 0.73 * solid;
        field = field_of(ray.point_m, true, &edge);
        if (field >= 0 && field < 144)
            fields->control[field] += solid;
        field = field_of(ray.point_m, false, &edge);
        if (field < 0 || field >= 144)
            continue;
        fields->solid[field] += solid;
        if (edge > 0.1 && ray.coverage == 1) {
            fields->seen++;
            fields->wrong += (light > 0.3) != ((field / 12 + field % 12) % 2 == 0);
        }
    }
}

static double worst_of(const double solid[144])
{
    double worst = 0;

    for (int field = 0; field < 144; field++)
        worst = fmax(worst, fabs(solid[field] / (2 * PI / 144) - 1));
    return worst;
}

static void fields_of_the_checker_cover_the_same_solid_angle(void **state)
{
    struct cupola_rig rig = {.tilt_rad = 0.3};
    struct stage_fixture fixture;
    struct fields fields = {0};
    cupola_dome *dome = NULL;
    unsigned char *image;

    (void)state;
    rig.outputs[0].width_px = rig.outputs[0].height_px = 600;
    assert_int_equal(cupola_rig_complete(&rig, &rig, NULL), CUPOLA_OK);
    stage_fixture_make(&fixture, &rig);
    fixture.tool.pattern = PATTERN_CHECKER;
    fixture.tool.about = ABOUT_DOME;
    image = stage_fixture_image(&fixture);
    assert_int_equal(cupola_dome_create(&rig, &dome, NULL), CUPOLA_OK);
    add_fields(image, dome, &fields);
    check_at_least(fields.seen, 100000);
    assert_true(fields.wrong == 0 || fields.wrong == fields.seen);
    check_at_most(worst_of(fields.solid), 0.03);
    check_at_least(worst_of(fields.control), 0.1);
    check_near(fields.white, PI, 0.01 * PI);
    cupola_dome_destroy(&dome);
    free(image);
    stage_fixture_release(&fixture);
}

/* Numbers of the ramps are those that the projector gets. */
static void steps_of_grey_are_their_numbers(void **state)
{
    static const struct {
        double up_deg;
        int first, step;
    } bands[] = {{39, 240, 1}, {23, 0, 17}, {-23, 0, 1}};
    struct cupola_rig rig = {.eye_m = {0.1, 0.1, 0.2}};
    struct stage_fixture fixture;
    cupola_dome *dome = NULL;
    unsigned char *image;

    (void)state;
    assert_int_equal(cupola_rig_complete(&rig, &rig, NULL), CUPOLA_OK);
    stage_fixture_make(&fixture, &rig);
    fixture.tool.pattern = PATTERN_RAMPS;
    fixture.tool.about = ABOUT_VIEWER;
    image = stage_fixture_image(&fixture);
    assert_int_equal(cupola_dome_create(&rig, &dome, NULL), CUPOLA_OK);
    for (int k = 0; k < 48; k++) {
        double up = bands[k / 16].up_deg * RADIANS, right = (-60 + 8 * (k % 16)) * RADIANS, at[2];
        double direction[3] = {cos(up) * sin(right), sin(up), -cos(up) * cos(right)};
        const unsigned char *pixel;
        assert_int_equal(cupola_dome_pixel(dome, 0, NULL, direction, at), 1);
        pixel = image + 4 * ((size_t)at[1] * 1024 + (size_t)at[0]);
        for (int i = 0; i < 3; i++)
            assert_int_equal(pixel[i], bands[k / 16].first + bands[k / 16].step * (k % 16));
    }
    cupola_dome_destroy(&dome);
    free(image);
    stage_fixture_release(&fixture);
}

static void the_dot_is_where_it_is_steered_to(void **state)
{
    struct cupola_rig rig;
    struct stage_fixture fixture;
    cupola_dome *dome = NULL;
    unsigned char *image;
    double mean[3] = {0}, solid = 0, wanted[3], angle;
    uint64_t seed = 9;

    (void)state;
    stage_random_rig(&seed, SIZE, &rig);
    stage_fixture_make(&fixture, &rig);
    assert_int_equal(cupola_dome_create(&rig, &dome, NULL), CUPOLA_OK);
    struct cupola_ray ray;
    assert_int_equal(cupola_dome_ray(dome, 0, NULL, 300, 200, &ray), 1);
    memcpy(wanted, ray.direction, sizeof wanted);
    fixture.tool.pattern = PATTERN_DOT;
    fixture.tool.about = ABOUT_DOME; /* does not matter */
    fixture.tool.dot_yaw_rad = atan2(-wanted[0], -wanted[2]);
    fixture.tool.dot_pitch_rad = asin(wanted[1]);
    fixture.tool.dot_size_rad = 0.12;
    image = stage_fixture_image(&fixture);
    for (int k = 0; k < SIZE * (3 * SIZE / 4); k++) {
        double weight = stage_light(image[4 * k]);
        if (cupola_dome_ray(dome, 0, NULL, k % SIZE + 0.5, k / SIZE + 0.5, &ray) != 1)
            continue;
        solid += weight * ray.solid_angle_sr;
        for (int i = 0; i < 3; i++)
            mean[i] += weight * ray.solid_angle_sr * ray.direction[i];
    }
    angle = acos(fmin(1, (mean[0] * wanted[0] + mean[1] * wanted[1] + mean[2] * wanted[2]) /
                             sqrt(mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2])));
    check_at_most(angle, 0.05 * RADIANS);
    check_near(solid, 2 * PI * (1 - cos(0.06)), 0.02 * 2 * PI * (1 - cos(0.06)));
    cupola_dome_destroy(&dome);
    free(image);
    stage_fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_grid_is_where_the_rays_say),
        cmocka_unit_test(fields_of_the_checker_cover_the_same_solid_angle),
        cmocka_unit_test(steps_of_grey_are_their_numbers),
        cmocka_unit_test(the_dot_is_where_it_is_steered_to),
    };

    return cmocka_run_group_tests_name("calib-stage_patterns", tests, stage_context_open,
                                       stage_context_close);
}
