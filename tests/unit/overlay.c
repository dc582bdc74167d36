/* Overlays: where rays meet them, what they cover of a pixel, which pixels they may change. */
#include <stdio.h>
#include <string.h>

#include "cupola/reference.h"
#include "geometry/overlay.h"
#include "message.h"
#include "oracle.h"

static const double width_max = 5.0 * 3.14159265358979323846 / 6.0;

/* An overlay seen along an aim, which says its frame once more: right, up and back of the lens. */
static struct cupola_overlay overlay_along(const struct cupola_aim *aim, double width,
                                           double height)
{
    struct cupola_overlay overlay = {.kind = CUPOLA_OVERLAY_PICTURE,
                                     .width_rad = width,
                                     .height_rad = height,
                                     .roll_rad = aim->roll_rad};
    long double direction[3];
    oracle_aim(aim, (const long double[3]){0.0L, 0.0L, -1.0L}, direction);
    for (int i = 0; i < 3; i++)
        overlay.direction[i] = (double)(3.7L * direction[i]);
    return overlay;
}

/* The ray to a place on it, -1 to 1, by that aim. */
static struct varying ray_to(const struct cupola_aim *aim, const struct cupola_overlay *overlay,
                             double across, double up)
{
    const long double in_lens[3] = {
        (long double)across * tanl(0.5L * (long double)overlay->width_rad),
        (long double)up * tanl(0.5L * (long double)overlay->height_rad), -1.0L};
    long double direction[3];
    struct varying ray = {{0}, {0}, {0}};
    oracle_aim(aim, in_lens, direction);
    for (int i = 0; i < 3; i++)
        ray.at[i] = 0.3 * (double)direction[i];
    return ray;
}

static struct cupola_aim random_aim(uint64_t *seed)
{
    return (struct cupola_aim){random_between(seed, -3.0, 3.0), random_between(seed, -1.5, 1.5),
                               random_between(seed, -3.0, 3.0)};
}

static void a_ray_meets_the_place_that_it_was_sent_to(void **state)
{
    (void)state;
    uint64_t seed = 8101;
    for (int i = 0; i < 1000; i++) {
        struct cupola_aim aim = random_aim(&seed), turned = aim;
        struct cupola_overlay overlay = overlay_along(&aim, random_between(&seed, 1e-3, width_max),
                                                      random_between(&seed, 1e-3, width_max));
        double across = random_between(&seed, -2.0, 2.0), up = random_between(&seed, -2.0, 2.0);
        struct varying ray = ray_to(&aim, &overlay, across, up);
        struct overlay_frame frame;
        struct varying found;
        double place[2];
        overlay_frame_prepare(&overlay, 0.0, &frame);
        overlay_direction(&frame, &ray, &found);
        overlay_place(&found, place);
        check_near(place[0], 0.5 + 0.5 * across, 1e-9);
        check_near(place[1], 0.5 + 0.5 * up, 1e-9);
        assert_int_equal(overlay_coverage(CUPOLA_OVERLAY_PICTURE, &found) > 0.0,
                         fmax(fabs(across), fabs(up)) < 1.0);
        turned.roll_rad += radians(0.1); /* the control */
        ray = ray_to(&turned, &overlay, 1.0, 0.0);
        overlay_direction(&frame, &ray, &found);
        check_at_least(fabs(found.at[1] * frame.half[1] / (found.at[0] * frame.half[0])), 1e-3);
        for (int k = 0; k < 3; k++)
            ray.at[k] = -ray.at[k];
        overlay_direction(&frame, &ray, &found);
        check_near(overlay_coverage(CUPOLA_OVERLAY_PICTURE, &found), 0.0, 0.0);
    }
}

static void straight_up_and_down_it_is_as_just_before(void **state)
{
    (void)state;
    for (int sign = -1; sign <= 1; sign += 2) {
        struct cupola_aim aim = {.pitch_rad = sign * radians(89.9999)};
        struct cupola_overlay overlay = overlay_along(&aim, 0.1, 0.1);
        struct overlay_frame before, at;
        overlay_frame_prepare(&overlay, 0.0, &before);
        memcpy(overlay.direction, (double[3]){0.0, sign, 0.0}, sizeof overlay.direction);
        overlay_frame_prepare(&overlay, 0.0, &at);
        for (int i = 0; i < 9; i++)
            check_near(at.axes[i], before.axes[i], 1e-5);
    }
}

static void sizes_that_are_left_out_follow(void **state)
{
    (void)state;
    struct cupola_overlay overlay = {.direction = {0.0, 0.0, -1.0}, .width_rad = 0.4};
    struct overlay_frame frame;
    overlay_frame_prepare(&overlay, 2.0, &frame);
    check_near(frame.half[1], 0.5 * tan(0.2), 1e-15);
    overlay_frame_prepare(&overlay, 1e-9, &frame); /* not higher than can be */
    check_near(frame.half[1], tan(0.5 * width_max), 1e-12);
    overlay_frame_prepare(&overlay, 0.0, &frame);
    check_near(frame.half[1], tan(0.5 * width_max), 1e-12);
    overlay.kind = CUPOLA_OVERLAY_DISC;
    overlay_frame_prepare(&overlay, 0.0, &frame);
    check_near(frame.half[1], frame.half[0], 0.0);
}

/* The sum over a grid of pixels of an overlay of half sizes in pixels, turned; and its middle. */
static double covered(enum cupola_overlay_kind kind, const double half_px[2], double roll,
                      const double middle[2], double centroid[2])
{
    enum { SIDE = 40 };
    double c = cos(roll), s = sin(roll), sum = 0.0;
    centroid[0] = centroid[1] = 0.0;
    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < SIDE; i++) {
            double x = i + 0.5 - middle[0], y = j + 0.5 - middle[1];
            const struct varying place = {
                {(c * x + s * y) / half_px[0], (c * y - s * x) / half_px[1], 1.0},
                {c / half_px[0], -s / half_px[1], 0.0},
                {s / half_px[0], c / half_px[1], 0.0},
            };
            double coverage = overlay_coverage(kind, &place);
            check_at_least(coverage, 0.0);
            check_at_most(coverage, 1.0 + 1e-12);
            sum += coverage;
            centroid[0] += coverage * (i + 0.5);
            centroid[1] += coverage * (j + 0.5);
        }
    for (int i = 0; i < 2; i++)
        centroid[i] /= sum;
    return sum;
}

/* Small ones, which lie where they lie: half of a pixel off would be 0.5 below. */
static void what_is_covered_is_the_area_and_lies_in_the_middle(void **state)
{
    (void)state;
    static const double ring =
        1.0 - OVERLAY_RING_INNER * OVERLAY_RING_INNER + OVERLAY_DOT_RADIUS * OVERLAY_DOT_RADIUS;
    uint64_t seed = 8103;
    double worst_area = 0.0, worst_place = 0.0;
    for (int i = 0; i < 600; i++) {
        enum cupola_overlay_kind kind = (enum cupola_overlay_kind)(i % OVERLAY_KINDS);
        double half[2] = {random_between(&seed, 1.0, 9.0), random_between(&seed, 1.0, 9.0)};
        double middle[2] = {random_between(&seed, 19.0, 21.0), random_between(&seed, 19.0, 21.0)};
        double roll = kind == CUPOLA_OVERLAY_PICTURE ? 0.0 : random_between(&seed, -3.0, 3.0);
        double shape = kind == CUPOLA_OVERLAY_PICTURE ? 4.0
                       : kind == CUPOLA_OVERLAY_DISC  ? pi
                                                      : pi * ring;
        double centroid[2];
        double sum = covered(kind, half, roll, middle, centroid);
        worst_area = fmax(worst_area, fabs(sum / (shape * half[0] * half[1]) - 1.0));
        worst_place = fmax(worst_place, hypot(centroid[0] - middle[0], centroid[1] - middle[1]));
    }
    printf("area within %.2g, middle within %.2g px\n", worst_area, worst_place);
    check_at_most(worst_area, 0.02);
    check_at_most(worst_place, 0.08); /* of rings of half a pixel */
}

/* Whether the pixel changes, by the library's own functions without any rectangle. */
static bool is_covered(const cupola_dome *dome, const struct overlay_frame *frame, int i, int j)
{
    const struct projector *projector = &dome->projectors[0];
    struct varying lens, point, inside, ray, direction;
    double circle[2];
    circle_place(projector, i + 0.5, j + 0.5, circle);
    lens_ray(projector, circle, &lens);
    screen_point(projector, &lens, &point);
    if (!(pixel_coverage(projector, i + 0.5, j + 0.5, &point) > 0.0))
        return false;
    point_inside_rim(projector, i + 0.5, j + 0.5, &point, &inside);
    memcpy(inside.at, point.at, sizeof inside.at);
    eye_ray(dome, dome->rig.eye_m, &inside, &ray);
    overlay_direction(frame, &ray, &direction);
    return overlay_coverage(CUPOLA_OVERLAY_PICTURE, &direction) > 0.0;
}

static bool in_area(const struct overlay_area *area, int i, int j, int shrunk)
{
    return i >= area->x + shrunk && j >= area->y + shrunk && i < area->x + area->width - shrunk &&
           j < area->y + area->height - shrunk;
}

struct count {
    long covered, area, missed, missed_shrunk, pixels;
};

static void compare_area(const struct cupola_rig *rig, const struct cupola_overlay *overlay,
                         struct count *count)
{
    cupola_dome *dome = dome_of(rig);
    struct overlay_frame frame;
    overlay_frame_prepare(overlay, 1.7, &frame);
    struct overlay_area area = overlay_area_find(dome, 0, &frame);
    for (int j = 0; j < rig->outputs[0].height_px; j++)
        for (int i = 0; i < rig->outputs[0].width_px; i++) {
            bool hit = is_covered(dome, &frame, i, j);
            count->covered += hit;
            count->area += in_area(&area, i, j, 0);
            count->missed += hit && !in_area(&area, i, j, 0);
            count->missed_shrunk += hit && !in_area(&area, i, j, 6);
            count->pixels++;
        }
    cupola_dome_destroy(&dome);
}

/* Of the lenses that go round, equisolid and angular, up to 360 degrees. */
static struct cupola_rig rig_of_any_opening(uint64_t *seed, int number)
{
    struct cupola_rig rig = random_rig(seed, 0.8);
    struct cupola_output *output = &rig.outputs[0];
    if (number % 3 == 0) {
        bool whole = number % 2;
        output->lens = random_lens(seed, number % 4 ? CUPOLA_LENS_ANGULAR : CUPOLA_LENS_EQUISOLID,
                                   radians(whole ? 360.0 : random_between(seed, 20.0, 360.0)));
    }
    if (number % 5 == 0)
        output->lens = random_lens(seed, CUPOLA_LENS_HEMISPHERIC, radians(180.0));
    output->width_px = output->height_px = 72;
    output->circle = (struct cupola_circle){36.0, 30.0, random_between(seed, 20.0, 50.0)};
    return rig;
}

static void no_pixel_outside_of_the_area_is_hit(void **state)
{
    (void)state;
    uint64_t seed = 8104;
    struct count count = {0, 0, 0, 0, 0};
    for (int number = 0; number < 800; number++) {
        struct cupola_rig rig = rig_of_any_opening(&seed, number);
        struct cupola_aim aim = random_aim(&seed);
        double largest = number % 2 ? width_max : 0.3;
        struct cupola_overlay overlay =
            overlay_along(&aim, random_between(&seed, 0.002, largest),
                          number % 7 ? random_between(&seed, 0.002, largest) : 0.0);
        long before = count.missed;
        compare_area(&rig, &overlay, &count);
        if (count.missed != before)
            print_error("rig %d: %ld pixels missed\n", number, count.missed - before);
    }
    printf("%.1f %% of the pixels covered, %.1f %% in the area\n",
           100.0 * (double)count.covered / (double)count.pixels,
           100.0 * (double)count.area / (double)count.pixels);
    assert_int_equal(count.missed, 0);
    check_at_least(count.missed_shrunk, 500); /* the control */
    check_at_least(count.covered, 5000);
}

/* What is small stays cheap, and what lies behind the lens costs nothing. */
static void the_area_is_not_much_larger_than_the_overlay(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 1024);
    cupola_dome *dome = dome_of(&rig);
    for (int yaw = 0; yaw < 360; yaw += 10) {
        struct cupola_aim aim = {.yaw_rad = radians(yaw)};
        struct cupola_overlay overlay = overlay_along(&aim, radians(10.0), radians(4.0));
        struct overlay_frame frame;
        overlay_frame_prepare(&overlay, 0.0, &frame);
        struct overlay_area area = overlay_area_find(dome, 0, &frame);
        /* 5.7 px a degree, at the sides stretched by pi/2 upwards */
        check_at_most(area.width * area.height,
                      yaw > 110 && yaw < 250 ? 0.0 : 57.0 * 23.0 * 1.6 * 3.0);
    }
    cupola_dome_destroy(&dome);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ray_meets_the_place_that_it_was_sent_to),
        cmocka_unit_test(straight_up_and_down_it_is_as_just_before),
        cmocka_unit_test(sizes_that_are_left_out_follow),
        cmocka_unit_test(what_is_covered_is_the_area_and_lies_in_the_middle),
        cmocka_unit_test(no_pixel_outside_of_the_area_is_hit),
        cmocka_unit_test(the_area_is_not_much_larger_than_the_overlay),
    };
    return cmocka_run_group_tests_name("overlay", tests, NULL, NULL);
}
