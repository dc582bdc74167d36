/* What is said of good photographs that show too little, and of others: the reason must be true. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <cupola/rig_file.h>

#include "capture_fixture.h"
#include "check.h"
#include "option_values.h"
#include "random.h"

enum { FAILED = 1 };

#define DECODE "decode --rig r.cfg --camera rectilinear:60 --output m.csv --folder photos "

static const struct series series = {.size_px = {200, 72}, .period_px = 16, .steps = 4};

/* Photographs of the projector's image, pixel by pixel. */
struct scene {
    double lit, noise;
    int clear[4];        /* out of focus but for pixels from x, y on and below x, y */
    double turned;       /* the sines of x, in turns */
    double holes;        /* part of all pixels that is no number */
    bool dark_beside;    /* lit in `clear` only, and in focus everywhere */
    bool pair_exchanged; /* the first one of x */
    uint64_t state;
};

static bool is_clear(const struct scene *scene, int i, int j)
{
    return i >= scene->clear[0] && i < scene->clear[2] && j >= scene->clear[1] &&
           j < scene->clear[3];
}

static double normal(uint64_t *state)
{
    double sum = -6;

    for (int i = 0; i < 12; i++)
        sum += random_between(state, 0, 1);
    return sum;
}

static double scene_light(const struct series_picture *wanted, int i, int j, void *data)
{
    struct scene *scene = data;
    struct series_picture picture = *wanted;
    bool stripes = picture.kind == SERIES_CODE || picture.kind == SERIES_INVERSE;
    double place = (picture.axis ? j : i) + 0.5, shown, lit = scene->lit;
    double turned = picture.axis ? 0 : scene->turned;

    if (stripes && scene->pair_exchanged && picture.axis == 0 && picture.index == 0)
        picture.kind = picture.kind == SERIES_CODE ? SERIES_INVERSE : SERIES_CODE;
    shown = series_light(&series, &picture, i, j);
    if (picture.kind == SERIES_SINE)
        shown =
            0.5 +
            0.5 * cos(2 * 3.14159265358979 *
                      (place / series.period_px + turned - (double)picture.index / series.steps));
    if (!is_clear(scene, i, j) && scene->dark_beside)
        lit = 0;
    else if (!is_clear(scene, i, j) && (stripes || picture.kind == SERIES_SINE))
        shown = 0.5 + 0.1 * (shown - 0.5);
    if (scene->holes > 0 && random_between(&scene->state, 0, 1) < scene->holes)
        return (double)NAN;
    return 0.1 + lit * shown + (scene->noise > 0 ? scene->noise * normal(&scene->state) : 0);
}

/* Refused for one reason, without another being named. */
static void refuse(struct scene scene, const char *options, const char *reason, const char *unsaid)
{
    char message[MESSAGE_SIZE], line[300];

    capture_write_photos("photos", &series, 200, 72, scene_light, &scene);
    snprintf(line, sizeof line, DECODE "%s", options);
    assert_int_equal(capture_run(line, message), FAILED);
    if (!strstr(message, reason) || (unsaid && strstr(message, unsaid)))
        fail_msg("'%s' does not say '%s', or says '%s'", message, reason, unsaid ? unsaid : "");
}

/* Light that falls off moves the phase at the one border that is clear. */
static void test_one_border_does_not_tell_an_order(void **state)
{
    (void)state;
    refuse((struct scene){.lit = 0.7, .clear = {50, 10, 64, 60}, .turned = 0.15}, "",
           "degrees; allowed: up to 45; it may be blur: of what is lit 5 % shows clear", "order");
    /* The control: four do, also where most is out of focus, and then both are named. */
    refuse((struct scene){.lit = 0.7, .clear = {50, 10, 92, 60}, .turned = 0.15}, "",
           "the sines of x do not lie as their stripes do: their phase is off by 54 degrees", NULL);
    refuse((struct scene){.lit = 0.7, .clear = {50, 10, 92, 60}, .turned = 0.15}, "",
           "exchanged; or it is blur: of what is lit 15 % shows clear stripes and sines", NULL);
    refuse((struct scene){.lit = 0.7, .clear = {0, 0, 200, 72}, .turned = 0.15}, "",
           "the sines of x do not lie as their stripes do", "blur");
}

static void test_few_pixels_do_not_tell_an_order(void **state)
{
    (void)state;
    refuse((struct scene){.lit = 0.7, .clear = {50, 10, 59, 19}, .turned = 0.5}, "",
           "99.8 % code unsure", "exchanged");
    /* The control: so many do. */
    refuse((struct scene){.lit = 0.7, .clear = {50, 10, 120, 60}, .turned = 0.5}, "",
           "stripes and sines of x disagree at 76 % of what shows both", NULL);
}

static void test_noise_that_passes_for_light_is_called_so(void **state)
{
    struct scene scene = {.lit = 0, .noise = 0.02};

    (void)state;
    refuse(scene, "", "noise of the photographs passes for light", "order");
    refuse(scene, "--contrast 0.3", "100.0 % too little contrast", "order");
    /* Beside something that is lit, too. */
    scene =
        (struct scene){.lit = 0.2, .noise = 0.03, .clear = {90, 20, 110, 40}, .dark_beside = true};
    refuse(scene, "", "noise of the photographs passes for light", "order");
    /* The control: what is lit well is in a wrong order. */
    scene =
        (struct scene){.lit = 0.7, .noise = 0.01, .clear = {0, 0, 200, 72}, .pair_exchanged = true};
    refuse(scene, "", "stripes and sines of x disagree", "noise");
}

static void test_pixels_that_are_no_numbers_are_named(void **state)
{
    (void)state;
    refuse((struct scene){.lit = 0.7, .clear = {0, 0, 200, 72}, .holes = 0.06}, "",
           "0.0 % too noisy, 8", "order");
    refuse((struct scene){.lit = 0.7, .clear = {0, 0, 200, 72}, .holes = 0.06}, "",
           " % no numbers; NaN and infinity are no numbers: look at what wrote the files", NULL);
}

static int begin(void **state)
{
    struct cupola_rig rig = {.outputs = {{.width_px = 200, .height_px = 72}}};

    if (capture_enter_directory(state) != 0)
        return -1;
    capture_write_rig("r.cfg", &rig);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_one_border_does_not_tell_an_order),
        cmocka_unit_test(test_few_pixels_do_not_tell_an_order),
        cmocka_unit_test(test_noise_that_passes_for_light_is_called_so),
        cmocka_unit_test(test_pixels_that_are_no_numbers_are_named),
    };
    return cmocka_run_group_tests_name("calib capture_reasons", tests, begin,
                                       capture_leave_directory);
}
