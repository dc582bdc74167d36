/* Tiles cover an output once, each is what it says it is, and its polynomial is good everywhere. */
#include <stdio.h>
#include <stdlib.h>

#include "geometry/dome.h"
#include "geometry/tiles.h"
#include "rig_random.h"

enum { RIGS = 18, WIDTH = 203, HEIGHT = 157 };

static struct cupola_rig rig_number(int number)
{
    uint64_t seed = 7101 + (uint64_t)number;
    struct cupola_rig rig = random_rig(&seed, number % 2 ? 0.4 : 0.0);
    enum cupola_lens_model model = (enum cupola_lens_model)(number % 6);
    double fov_deg = model == CUPOLA_LENS_HEMISPHERIC ? 180.0 : 200.0;
    rig.output_count = 1;
    rig.outputs[0].aim.yaw_rad *= 0.2;
    rig.outputs[0].aim.pitch_rad *= 0.2;
    rig.outputs[0].lens = random_lens(&seed, model, radians(fov_deg));
    rig.outputs[0].width_px = WIDTH;
    rig.outputs[0].height_px = HEIGHT;
    rig.outputs[0].circle = (struct cupola_circle){100.0, 80.0, number % 3 ? 77.0 : 120.0};
    rig.screen.cap_rad = number % 4 == 3 ? radians(70.0) : 0.0;
    return rig;
}

static cupola_plan *plan_of_rig(const struct cupola_rig *rig)
{
    struct cupola_plan_params params = {.layout = CUPOLA_LAYOUT_ROTATED, .views = 6};
    cupola_dome *dome = NULL;
    cupola_plan *plan = NULL;
    struct cupola_error error = {CUPOLA_OK, ""};
    if (cupola_dome_create(rig, &dome, &error) < 0 ||
        cupola_plan_create(dome, &params, &plan, &error) < 0)
        fail_msg("%s", error.message);
    cupola_dome_destroy(&dome);
    return plan;
}

struct findings {
    int pixels[TILE_KINDS];
    int not_once, wrong_kind, wrong_view;
    double worst_texels;
};

/* How far the polynomial misses a pixel's place in the view that it falls to. */
static double miss_of(const cupola_plan *plan, const struct tile *tile, int view, int x, int y,
                      const struct cupola_ray *ray)
{
    const cupola_dome *dome = cupola_plan_dome(plan);
    double point[3], direction[3], expected[2], found[2];
    tile_point(tile, x + 0.5, y + 0.5, point);
    for (int i = 0; i < 3; i++)
        point[i] -= cupola_dome_rig(dome)->eye_m[i];
    cupola_dome_to_camera(dome, point, direction);
    if (cupola_plan_texel(plan, view, ray->direction, expected) != 1 ||
        cupola_plan_texel(plan, view, direction, found) != 1)
        return (double)INFINITY;
    return hypot(found[0] - expected[0], found[1] - expected[1]);
}

static void look_at_pixel(const cupola_plan *plan, const struct tile *tile, int kind, int x, int y,
                          struct findings *findings)
{
    struct cupola_ray ray;
    cupola_dome_ray(cupola_plan_dome(plan), 0, NULL, x + 0.5, y + 0.5, &ray);
    int view = cupola_plan_select(plan, ray.direction);
    findings->pixels[kind]++;
    if (kind == TILE_DARK)
        findings->wrong_kind += ray.coverage > 0.0;
    if (kind == TILE_DARK || kind == TILE_EXACT)
        return;
    findings->wrong_kind += ray.coverage < 1.0;
    if (kind == TILE_PURE || kind == TILE_PAIR)
        findings->wrong_view += view != (int)tile->view && view != (int)tile->other;
    if (kind == TILE_PURE)
        findings->wrong_view += tile->view != tile->other;
    double miss = miss_of(plan, tile, view, x, y, &ray);
    findings->worst_texels = miss <= findings->worst_texels ? findings->worst_texels : miss;
}

static struct findings look_at(const cupola_plan *plan, const struct tiles *tiles)
{
    static unsigned char seen[HEIGHT][WIDTH];
    struct findings findings = {.worst_texels = 0.0};
    memset(seen, 0, sizeof seen);
    for (int kind = 0; kind < TILE_KINDS; kind++)
        for (int i = 0; i < tiles->count[kind]; i++) {
            const struct tile *tile = &tiles->tiles[kind][i];
            for (int y = (int)tile->y_px; y < (int)(tile->y_px + tile->side_px); y++)
                for (int x = (int)tile->x_px; x < (int)(tile->x_px + tile->side_px); x++)
                    if (x < WIDTH && y < HEIGHT) {
                        seen[y][x]++;
                        look_at_pixel(plan, tile, kind, x, y, &findings);
                    }
        }
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        findings.not_once += seen[i / WIDTH][i % WIDTH] != 1;
    return findings;
}

static void check_findings(const struct findings *findings)
{
    assert_int_equal(findings->not_once, 0);
    assert_int_equal(findings->wrong_kind, 0);
    assert_int_equal(findings->wrong_view, 0);
    check_at_most(findings->worst_texels, TILE_ERROR_TEXELS);
}

static void every_pixel_is_in_one_tile_that_is_right_about_it(void **state)
{
    (void)state;
    double worst = 0.0;
    int pure = 0, pairs = 0, choosing = 0;
    for (int number = 0; number < RIGS; number++) {
        struct cupola_rig rig = rig_number(number);
        cupola_plan *plan = plan_of_rig(&rig);
        struct tiles tiles;
        assert_int_equal(tiles_create(plan, 0, number % 5 ? 64 : 16, 0, &tiles, NULL), CUPOLA_OK);
        struct findings findings = look_at(plan, &tiles);
        check_findings(&findings);
        pure += findings.pixels[TILE_PURE];
        pairs += findings.pixels[TILE_PAIR];
        choosing += findings.pixels[TILE_CHOOSING];
        worst = fmax(worst, findings.worst_texels);
        tiles_destroy(&tiles);
        cupola_plan_destroy(&plan);
    }
    check_at_least(pure, 100000);
    check_at_least(pairs, 20000);
    check_at_least(choosing, 1000);
    printf("%d pixels in pure tiles, %d in pairs, %d in choosing ones; polynomials miss places in "
           "views by %.2g texels at most\n",
           pure, pairs, choosing, worst);
}

/* A plan for another eye, with the first one's views: what a head that moves leads to. */
static void tiles_refitted_to_another_eye_are_right_about_it(void **state)
{
    (void)state;
    for (int number = 0; number < RIGS; number += 2) {
        struct cupola_rig rig = rig_number(number);
        double radius = rig.screen.radius_m;
        cupola_plan *plan = plan_of_rig(&rig);
        struct tiles tiles;
        assert_int_equal(tiles_create(plan, 0, 64, 0, &tiles, NULL), CUPOLA_OK);
        struct tile *lists[TILE_KINDS];
        memcpy(lists, tiles.tiles, sizeof lists);
        plan->dome.rig.eye_m[0] += 0.03 * (radius > 0.0 ? radius : 1.0);
        tiles_refit(plan, &tiles);
        for (int kind = 0; kind < TILE_KINDS; kind++)
            assert_ptr_equal(tiles.tiles[kind], lists[kind]);
        struct findings findings = look_at(plan, &tiles);
        assert_int_equal(findings.not_once, 0);
        assert_int_equal(findings.wrong_kind, 0);
        assert_int_equal(findings.wrong_view, 0);
        check_at_most(findings.worst_texels, 2.0 * TILE_ERROR_TEXELS);
        tiles_destroy(&tiles);
        cupola_plan_destroy(&plan);
    }
}

/* How far polynomials miss for eyes near the screen, by plans with a sphere of `head`. */
static double worst_moved(double head, double moved_m[3])
{
    struct cupola_rig rig = {.output_count = 1, .screen.radius_m = 1.0};
    rig.outputs[0].width_px = WIDTH;
    rig.outputs[0].height_px = HEIGHT;
    rig.outputs[0].circle = (struct cupola_circle){100.0, 80.0, 700.0};
    rig.outputs[0].lens.model = CUPOLA_LENS_ANGULAR;
    rig.outputs[0].lens.fov_rad = radians(140.0);
    struct cupola_plan_params params = {.head_radius_m = head};
    cupola_dome *dome = NULL;
    cupola_plan *plan = NULL;
    struct tiles tiles;
    assert_int_equal(cupola_dome_create(&rig, &dome, NULL), CUPOLA_OK);
    assert_int_equal(cupola_plan_create(dome, &params, &plan, NULL), CUPOLA_OK);
    assert_int_equal(tiles_create(plan, 0, 128, 0, &tiles, NULL), CUPOLA_OK);
    memcpy(plan->dome.rig.eye_m, moved_m, sizeof plan->dome.rig.eye_m);
    tiles_refit(plan, &tiles);
    double worst = look_at(plan, &tiles).worst_texels;
    tiles_destroy(&tiles);
    cupola_plan_destroy(&plan);
    cupola_dome_destroy(&dome);
    return worst;
}

/* The control: tiles of a plan whose eye rests, looked at from as near. */
static void tiles_do_for_every_eye_of_a_sphere(void **state)
{
    (void)state;
    double near_m[3] = {0.0, 0.0, -0.79}, worst = worst_moved(0.8, near_m);
    double at_rest = worst_moved(0.0, near_m);
    printf("near the screen %.2g texels, of a plan for an eye at rest %.2g\n", worst, at_rest);
    check_at_most(worst, TILE_ERROR_TEXELS);
    check_at_least(at_rest, TILE_ERROR_TEXELS);
}

static void where_there_is_no_room_larger_tiles_choose(void **state)
{
    (void)state;
    struct cupola_rig rig = rig_number(1);
    cupola_plan *plan = plan_of_rig(&rig);
    struct tiles tiles;
    assert_int_equal(tiles_create(plan, 0, 64, 0, &tiles, NULL), CUPOLA_OK);
    int before = tiles.count[TILE_CHOOSING];
    for (int kind = TILE_PURE; kind <= TILE_CHOOSING; kind++)
        tiles.most[kind] = tiles.piece_count;
    tiles_refit(plan, &tiles);
    struct findings findings = look_at(plan, &tiles);
    check_findings(&findings);
    for (int kind = TILE_PURE; kind <= TILE_CHOOSING; kind++)
        assert_int_equal(tiles.most[kind], tiles.piece_count);
    assert_true(before > 0);
    tiles_destroy(&tiles);
    cupola_plan_destroy(&plan);
}

static void a_wrong_term_view_or_tile_is_caught(void **state)
{
    (void)state;
    struct cupola_rig rig = rig_number(0);
    cupola_plan *plan = plan_of_rig(&rig);
    struct tiles tiles;
    assert_int_equal(tiles_create(plan, 0, 64, 0, &tiles, NULL), CUPOLA_OK);
    struct tile *tile = &tiles.tiles[TILE_PURE][tiles.count[TILE_PURE] / 2], kept = *tile;
    for (int k = 0; k < TILE_TERMS; k++) {
        double farthest = k < 1 ? 1.0 : pow(0.5 * (double)tile->side_px, k < 3 ? 1 : k < 6 ? 2 : 3);
        tile->terms[k][k % 2] += (float)(0.01 * rig.screen.radius_m / farthest);
        check_at_least(look_at(plan, &tiles).worst_texels, 2.0 * TILE_ERROR_TEXELS);
        *tile = kept;
    }
    tile->view = (float)(((int)tile->view + 1) % plan->view_count);
    assert_true(look_at(plan, &tiles).wrong_view > 0);
    *tile = kept;
    for (int i = 0; i < tiles.count[TILE_PAIR]; i++)
        tiles.tiles[TILE_PAIR][i].other = tiles.tiles[TILE_PAIR][i].view;
    assert_true(look_at(plan, &tiles).wrong_view > 100);
    tiles_refit(plan, &tiles);
    assert_int_equal(look_at(plan, &tiles).wrong_view, 0);
    *tile = kept;
    tile->side_px -= 1.0f;
    assert_true(look_at(plan, &tiles).not_once > 0);
    *tile = kept;
    tiles.tiles[TILE_DARK][0] = kept;
    assert_true(look_at(plan, &tiles).wrong_kind > 0);
    tiles_destroy(&tiles);
    cupola_plan_destroy(&plan);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_pixel_is_in_one_tile_that_is_right_about_it),
        cmocka_unit_test(tiles_refitted_to_another_eye_are_right_about_it),
        cmocka_unit_test(tiles_do_for_every_eye_of_a_sphere),
        cmocka_unit_test(where_there_is_no_room_larger_tiles_choose),
        cmocka_unit_test(a_wrong_term_view_or_tile_is_caught),
    };
    return cmocka_run_group_tests_name("tiles", tests, NULL, NULL);
}
