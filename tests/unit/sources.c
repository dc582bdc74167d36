/* Pictures as sources, in plain C: every pixel shows the direction that is its own. */
#include <stdio.h>
#include <string.h>

#include "cupola/reference.h"
#include "message.h"
#include "oracle.h"
#include "painted.h"
#include "rig_random.h"

enum { HEIGHT = 384, SIDE = 96, RIGS = 18 };

/* Bilinear mixing of directions up to 2 pi / 384 rad apart: that squared, over 8, and floats.
 * Across an edge of a cube the four texels lie on two planes: up to a quarter of one texel,
 * 2 / 384. */
static const double bar = 1e-4, bar_edge = 0.5 / HEIGHT;

static struct cupola_rig rig_number(uint64_t *seed, int number)
{
    struct cupola_rig rig = random_rig(seed, 0.6);
    rig.outputs[0].lens =
        random_lens(seed, (enum cupola_lens_model)(number % 6), radians(150.0 - number));
    rig.outputs[0].width_px = rig.outputs[0].height_px = SIDE;
    rig.outputs[0].circle = (struct cupola_circle){0.5 * SIDE, 0.5 * SIDE, 0.5 * SIDE};
    return rig;
}

static int near_cube_edge(const double direction[3])
{
    double size[3] = {fabs(direction[0]), fabs(direction[1]), fabs(direction[2])};
    double most = fmax(size[0], fmax(size[1], size[2]));
    double least = fmin(size[0], fmin(size[1], size[2]));
    double middle = size[0] + size[1] + size[2] - most - least;
    return middle > most * (1.0 - 2.0 / HEIGHT);
}

/* Places where a picture has no neighbours: poles, the corners of a cube, a domemaster's rim. */
static int is_exempt(const struct cupola_source *source, const double direction[3])
{
    double reach = 3.0 * painted_pi / HEIGHT, least = 1.0, most = 0.0;
    if (source->kind == CUPOLA_SOURCE_EQUIRECTANGULAR)
        return hypot(direction[0], direction[2]) < reach;
    for (int i = 0; i < 3; i++) {
        least = fmin(least, fabs(direction[i]));
        most = fmax(most, fabs(direction[i]));
    }
    if (source->kind == CUPOLA_SOURCE_CUBE)
        return most - least < reach;
    double fov = source->fov_rad == 0.0 ? painted_pi : source->fov_rad;
    return atan2(hypot(direction[0], direction[1]), -direction[2]) > 0.5 * fov - reach;
}

static float *image_of(const cupola_dome *dome, const struct cupola_source *source)
{
    float *picture = painted_picture(source, HEIGHT);
    float *image = malloc(4 * sizeof *image * SIDE * SIDE);
    assert_non_null(image);
    assert_int_equal(cupola_reference_source(dome, 0, source, picture,
                                             painted_width(source, HEIGHT), HEIGHT, NULL, image),
                     CUPOLA_OK);
    free(picture);
    return image;
}

/*
 * The largest angle between a pixel's colour and what the rays of `truth` say. Near a cube's edges
 * it may be the bar there and `extra_rad`.
 */
static double direction_error(const float *image, const cupola_dome *truth,
                              const struct cupola_source *source, double extra_rad, int *compared)
{
    double worst = 0.0;
    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < SIDE; i++) {
            struct cupola_ray ray;
            double expected[3];
            const float *pixel = image + 4 * (j * SIDE + i);
            const double shown[3] = {(double)pixel[0], (double)pixel[1], (double)pixel[2]};
            cupola_dome_ray(truth, 0, NULL, i + 0.5, j + 0.5, &ray);
            shown_direction(truth, source, &ray, expected);
            if (ray.coverage < 0.01 || is_exempt(source, expected))
                continue;
            double error = angle_between(shown, expected);
            if (source->kind == CUPOLA_SOURCE_CUBE && near_cube_edge(expected))
                check_at_most(error, bar_edge + extra_rad);
            else
                worst = fmax(worst, error);
            ++*compared;
        }
    return worst;
}

static void every_pixel_shows_the_direction_that_is_its_own(void **state)
{
    (void)state;
    uint64_t seed = 7001;
    double worst = 0.0;
    for (int number = 0; number < RIGS; number++) {
        struct cupola_rig rig = rig_number(&seed, number);
        struct cupola_source source = random_source(&seed, number);
        cupola_dome *dome = dome_of(&rig);
        float *image = image_of(dome, &source);
        int compared = 0;
        double error = direction_error(image, dome, &source, 0.0, &compared);
        check_at_most(error, bar);
        check_at_least(compared, 500);
        worst = fmax(worst, error);
        free(image);
        cupola_dome_destroy(&dome);
    }
    printf("at most %.2g rad\n", worst);
}

static void a_tenth_of_a_degree_or_a_pixel_is_caught(void **state)
{
    (void)state;
    uint64_t seed = 7002;
    for (int number = 0; number < 9; number++) {
        struct cupola_rig rig = rig_number(&seed, number), shifted;
        struct cupola_source source = random_source(&seed, number), turned = source;
        turned.orientation.pitch_rad += radians(0.1);
        shifted = rig;
        shifted.outputs[0].circle.center_x_px += 1.0;
        cupola_dome *dome = dome_of(&rig), *wrong = dome_of(&shifted);
        float *image = image_of(dome, &source);
        int compared = 0;
        check_at_least(direction_error(image, dome, &turned, 1.0, &compared), 2.0 * bar);
        check_at_least(direction_error(image, wrong, &source, 1.0, &compared), 2.0 * bar);
        free(image);
        cupola_dome_destroy(&wrong);
        cupola_dome_destroy(&dome);
    }
}

static void the_eye_may_move_a_picture_on_the_screen_may_not(void **state)
{
    (void)state;
    for (int kind = 1; kind <= CUPOLA_SOURCE_CUBE; kind++) {
        struct cupola_source source = {.kind = (enum cupola_source_kind)kind,
                                       .place = CUPOLA_PLACE_SCREEN};
        struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 160.0, SIDE);
        cupola_dome *centred = dome_of(&rig);
        rig.eye_m[0] = 0.3;
        cupola_dome *moved = dome_of(&rig);
        float *from_centre = image_of(centred, &source), *from_side = image_of(moved, &source);
        assert_memory_equal(from_centre, from_side, 4 * sizeof *from_side * SIDE * SIDE);
        free(from_side);
        source.place = CUPOLA_PLACE_INFINITY;
        from_side = image_of(moved, &source);
        assert_memory_not_equal(from_centre, from_side, 4 * sizeof *from_side * SIDE * SIDE);
        free(from_side);
        free(from_centre);
        cupola_dome_destroy(&moved);
        cupola_dome_destroy(&centred);
    }
}

static void beyond_the_rim_of_a_domemaster_is_the_border(void **state)
{
    (void)state;
    const struct cupola_source source = {.kind = CUPOLA_SOURCE_DOMEMASTER, .fov_rad = 1.5};
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 170.0, SIDE);
    cupola_dome *dome = dome_of(&rig);
    float *image = image_of(dome, &source);
    double rim_px = 0.5 * SIDE * 1.5 / radians(170.0), lit = 0.0;
    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < SIDE; i++) {
            double r = hypot(i + 0.5 - 0.5 * SIDE, j + 0.5 - 0.5 * SIDE);
            float alpha = image[4 * (j * SIDE + i) + 3];
            if (fabs(r - rim_px) > 0.8)
                check_near(alpha, r < rim_px ? 1.0 : 0.0, 1e-6);
            lit += (double)alpha;
        }
    check_near(lit, painted_pi * rim_px * rim_px, 1.0); /* a rim moved by 0.01 px is 1.3 */
    free(image);
    cupola_dome_destroy(&dome);
}

static void impossible_sources_are_refused(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 160.0, 4);
    cupola_dome *dome = dome_of(&rig);
    const struct cupola_source bad[] = {
        {.kind = CUPOLA_SOURCE_VIEWS},
        {.kind = (enum cupola_source_kind)4},
        {.kind = CUPOLA_SOURCE_CUBE, .place = (enum cupola_source_place)3},
        {.kind = CUPOLA_SOURCE_DOMEMASTER, .fov_rad = -0.1},
        {.kind = CUPOLA_SOURCE_DOMEMASTER, .fov_rad = 6.3},
        {.kind = CUPOLA_SOURCE_DOMEMASTER, .fov_rad = (double)NAN},
        {.kind = CUPOLA_SOURCE_CUBE, .orientation = {.yaw_rad = 7.0}},
        {.kind = CUPOLA_SOURCE_CUBE, .orientation = {.pitch_rad = (double)INFINITY}},
        {.kind = CUPOLA_SOURCE_CUBE, .orientation = {.roll_rad = -7.0}},
    };
    const struct cupola_source good = {.kind = CUPOLA_SOURCE_CUBE};
    float picture[24] = {0.0f}, image[64] = {[0] = 5.0f};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
        assert_int_equal(cupola_reference_source(dome, 0, &bad[i], picture, 1, 1, NULL, image),
                         CUPOLA_ERROR_ARGUMENT);
    const int sizes[4][2] = {{0, 1}, {1, 0}, {2, 1}, {40000, 40000}};
    for (int i = 0; i < 4; i++)
        assert_int_equal(
            cupola_reference_source(dome, 0, &good, picture, sizes[i][0], sizes[i][1], NULL, image),
            CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_reference_source(dome, 1, &good, picture, 1, 1, NULL, image),
                     CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_reference_source(NULL, 0, &good, picture, 1, 1, NULL, image),
                     CUPOLA_ERROR_ARGUMENT);
    check_near(image[0], 5.0, 0.0);
    assert_int_equal(cupola_reference_source(dome, 0, &good, picture, 1, 1, NULL, image),
                     CUPOLA_OK);
    cupola_dome_destroy(&dome);
}

static void every_kind_has_a_name(void **state)
{
    (void)state;
    for (int kind = 0; kind <= CUPOLA_SOURCE_CUBE; kind++)
        assert_int_equal(cupola_source_find(cupola_source_name(kind)), kind);
    assert_null(cupola_source_name(CUPOLA_SOURCE_CUBE + 1));
    assert_null(cupola_source_name(-1));
    assert_int_equal(cupola_source_find("film"), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(cupola_source_find(NULL), CUPOLA_ERROR_ARGUMENT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_pixel_shows_the_direction_that_is_its_own),
        cmocka_unit_test(a_tenth_of_a_degree_or_a_pixel_is_caught),
        cmocka_unit_test(the_eye_may_move_a_picture_on_the_screen_may_not),
        cmocka_unit_test(beyond_the_rim_of_a_domemaster_is_the_border),
        cmocka_unit_test(impossible_sources_are_refused),
        cmocka_unit_test(every_kind_has_a_name),
    };
    return cmocka_run_group_tests_name("sources", tests, NULL, NULL);
}
