/*
 * The filters on the GPU against those in plain C, whole images from one and the same atlas of
 * noise: random rigs, lenses and eyes, by tiles, without tables, and with a table where methods of
 * several rays shall do without.
 *
 * What may differ is what warp_reference.c says. Beyond that, where a number of rays is rounded up,
 * or a place down to the nearest texel, either may be the right one within rounding: of some
 * thousand pixels a few.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cupola/antialiasing.h"
#include "geometry/pattern.h"
#include "group.h"
#include "rig_random.h"
#include "worse.h"

static const float border[4] = {0.1f, 0.9f, 0.3f, 0.6f};
/* As for one ray; llvmpipe weighs floats by floats. */
static double bar = 0.004;

static struct cupola_rig rig_number(int number)
{
    uint64_t seed = 7001 + (uint64_t)number;
    struct cupola_rig rig = random_rig(&seed, 0.5);
    enum cupola_lens_model model = (enum cupola_lens_model)(number % 6);
    rig.outputs[0].lens = random_lens(&seed, model, radians(random_between(&seed, 100.0, 170.0)));
    rig.outputs[0].width_px = 120;
    rig.outputs[0].height_px = 100;
    rig.outputs[0].circle = (struct cupola_circle){60.0, 52.0, number % 2 ? 70.0 : 44.0};
    rig.outputs[0].aim.yaw_rad *= 0.2;
    rig.outputs[0].aim.pitch_rad *= 0.2;
    rig.outputs[0].flip = number % 3 == 1 ? CUPOLA_FLIP_X : CUPOLA_FLIP_NONE;
    rig.screen.cap_rad = number % 3 == 0 ? 0.0 : radians(60.0);
    return rig;
}

struct found {
    double worst; /* of all pixels that are compared */
    int unlike;   /* pixels beyond the bar */
    int compared;
};

static float *image_room(const struct cupola_output *size)
{
    float *image = malloc(4 * sizeof *image * (size_t)size->width_px * (size_t)size->height_px);
    assert_non_null(image);
    return image;
}

static struct found compare(const struct cupola_output *size, const float *shown,
                            const float *expected)
{
    struct found found = {0.0, 0, 0};
    for (int i = 0; i < size->width_px * size->height_px; i++) {
        double off = 0.0;
        for (int c = 0; c < 4; c++)
            off = worse_of(off, fabs((double)shown[4 * i + c] - (double)expected[4 * i + c]));
        found.worst = worse_of(found.worst, off);
        found.unlike += !(off <= bar);
        found.compared++;
    }
    return found;
}

static struct found found_with(const struct fixture *fixture, const struct cupola_filter *filter)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    float *atlas = fixture_atlas(fixture), *shown = fixture_warp(fixture, 0);
    float *expected = image_room(size);
    assert_int_equal(cupola_reference_filter(fixture->plan, 0, filter, atlas, border, expected),
                     CUPOLA_OK);
    struct found found = compare(size, shown, expected);
    free(expected);
    free(shown);
    free(atlas);
    return found;
}

static void set_filter(struct fixture *fixture, const struct cupola_filter *filter,
                       enum cupola_table table)
{
    struct cupola_gl_params params = {
        .format = CUPOLA_FORMAT_RGBA32F, .table = table, .filter = *filter};
    memcpy(params.border, border, sizeof params.border);
    fixture_replace_gl(fixture, &params);
    fixture_paint(fixture, PAINT_NOISE);
}

static bool has_several_rays(const struct cupola_filter *filter)
{
    return filter->method >= CUPOLA_ANTIALIASING_CONE;
}

/* Of so many pixels how many may be on the other side of a step. */
static int tolerated(const struct cupola_filter *filter, int pixels)
{
    bool steps =
        filter->method != CUPOLA_ANTIALIASING_TEXTURE && filter->method != CUPOLA_ANTIALIASING_CONE;
    return steps ? 2 + pixels / 2000 : 0;
}

static const struct cupola_filter filters[] = {
    {.method = CUPOLA_ANTIALIASING_TEXTURE, .samples = 9},
    {.method = CUPOLA_ANTIALIASING_NONE},
    {.method = CUPOLA_ANTIALIASING_CONE},
    {.method = CUPOLA_ANTIALIASING_CONE, .samples = 3, .pattern = CUPOLA_PATTERN_BLUE_NOISE},
    {.method = CUPOLA_ANTIALIASING_CONE, .samples = 11, .turned = true, .seed = 77},
    {.method = CUPOLA_ANTIALIASING_ADAPTIVE},
    {.method = CUPOLA_ANTIALIASING_ADAPTIVE,
     .samples = 20,
     .pattern = CUPOLA_PATTERN_ROTATED_GRID,
     .turned = true},
    {.method = CUPOLA_ANTIALIASING_FOOTPRINT},
    {.method = CUPOLA_ANTIALIASING_FOOTPRINT, .samples = 2},
};

enum { FILTERS = sizeof filters / sizeof filters[0] };

static void each_method_is_that_of_the_reference(void **state)
{
    (void)state;
    static const enum cupola_table tables[] = {CUPOLA_TABLE_TILES, CUPOLA_TABLE_NONE,
                                               CUPOLA_TABLE_POINTS};
    if (strstr((const char *)glGetString(GL_RENDERER), "llvmpipe"))
        bar = 0.0008;
    for (int i = 0; i < FILTERS; i++) {
        struct cupola_rig rig = rig_number(i);
        struct fixture fixture;
        fixture_make(&rig, NULL, NULL, &fixture);
        printf("%s, %d samples:", cupola_antialiasing_name((int)filters[i].method),
               filters[i].samples);
        for (int t = 0; t < 3; t++) {
            bool tabled = tables[t] == CUPOLA_TABLE_POINTS && !has_several_rays(&filters[i]);
            if (t == 2 && i % 4 != 0)
                continue; /* the same as none, or as in other tests */
            set_filter(&fixture, &filters[i], tables[t]);
            assert_int_equal(cupola_gl_table(fixture.gl, 0),
                             t < 2 || tabled ? (int)tables[t] : CUPOLA_TABLE_NONE);
            struct found found = found_with(&fixture, &filters[i]);
            printf(" %s %.2g", cupola_table_name((int)tables[t]), found.worst);
            check_at_most(found.unlike, tolerated(&filters[i], found.compared));
        }
        printf("\n");
        fixture_release(&fixture);
    }
}

static double places_scale = 1.0, weights_scale = 1.0;

void __real_pattern_make(enum cupola_pattern kind, int count, struct pattern *pattern);
void __wrap_pattern_make(enum cupola_pattern kind, int count, struct pattern *pattern);

void __wrap_pattern_make(enum cupola_pattern kind, int count, struct pattern *pattern)
{
    __real_pattern_make(kind, count, pattern);
    for (int i = 0; i < count; i++) {
        pattern->places[i].x *= places_scale;
        pattern->places[i].y *= places_scale;
    }
    pattern->places[0].weight *= weights_scale;
}

static void a_place_or_a_weight_off_by_a_hundredth_is_caught(void **state)
{
    (void)state;
    struct cupola_rig rig = rig_number(0);
    struct fixture fixture;
    if (bar > 0.001)
        skip(); /* this GL's own weights are no better */
    fixture_make(&rig, NULL, NULL, &fixture);
    for (int i = 0; i < FILTERS; i++)
        for (int what = 0; what < 2 && has_several_rays(&filters[i]); what++) {
            struct cupola_filter wrong = filters[i];
            if (wrong.method != CUPOLA_ANTIALIASING_CONE && what == 1)
                continue; /* two rays across from each other weigh the same */
            if (wrong.method == CUPOLA_ANTIALIASING_FOOTPRINT)
                wrong.samples = 1; /* it has no pattern */
            places_scale = what ? 1.0 : 1.01;
            weights_scale = what ? 1.01 : 1.0;
            if (wrong.samples > 4)
                continue; /* one of so many may weigh less than the bar */
            set_filter(&fixture, &wrong, CUPOLA_TABLE_NONE);
            places_scale = weights_scale = 1.0;
            struct found found = found_with(&fixture, &filters[i]);
            check_at_least(found.unlike, 20);
        }
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_method_is_that_of_the_reference),
        cmocka_unit_test(a_place_or_a_weight_off_by_a_hundredth_is_caught),
    };
    return run_gpu_group("filter_reference", tests);
}
