/* The places of the marks on the simulated screen, where the preview shows them. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "stage_fixture.h"

static const int width = 800, height = 400; /* the right half is the preview */
static const double pi = 3.14159265358979323846;

/* The middle of what differs by `least` codes in the right half; false where nothing does. */
static bool find_middle(const unsigned char *frame, const unsigned char *less, int least,
                        double middle[2])
{
    double sum = 0;
    memset(middle, 0, 2 * sizeof *middle);
    for (int y = 0; y < height; y++)
        for (int x = width / 2; x < width; x++) {
            const size_t at = 4 * ((size_t)y * (size_t)width + (size_t)x);
            double weight = abs(frame[at] - less[at]);
            if (weight < least)
                continue;
            sum += weight;
            middle[0] += weight * (x + 0.5);
            middle[1] += weight * (y + 0.5);
        }
    middle[0] /= sum;
    middle[1] /= sum;
    return sum > 0;
}

/* The point of the screen that the viewer sees along a yaw and pitch; independent of the tool. */
static void screen_point(const struct cupola_rig *rig, double yaw, double pitch, double point[3])
{
    const double camera[3] = {-sin(yaw) * cos(pitch), sin(pitch), -cos(yaw) * cos(pitch)};
    double v[3], along = 0, eye2 = 0, t;
    cupola_dome *dome = NULL;
    assert_int_equal(cupola_dome_create(rig, &dome, NULL), CUPOLA_OK);
    cupola_dome_from_camera(dome, camera, v);
    cupola_dome_destroy(&dome);
    for (int i = 0; i < 3; i++) {
        along += rig->eye_m[i] * v[i];
        eye2 += rig->eye_m[i] * rig->eye_m[i];
    }
    t = -along + sqrt(along * along - eye2 + rig->screen.radius_m * rig->screen.radius_m);
    for (int i = 0; i < 3; i++)
        point[i] = rig->eye_m[i] + t * v[i];
}

/* Whether the projector lights a dot and what is round it. */
static bool is_lit(const struct cupola_rig *rig, double yaw, double pitch)
{
    cupola_dome *dome = NULL;
    double pixel[2];
    bool lit = true;
    assert_int_equal(cupola_dome_create(rig, &dome, NULL), CUPOLA_OK);
    for (int i = 0; i < 8; i++) {
        double left = yaw + 0.06 * cos(i * pi / 4), up = pitch + 0.06 * sin(i * pi / 4);
        const double ray[3] = {-sin(left) * cos(up), sin(up), -cos(left) * cos(up)};
        lit = lit && cupola_dome_pixel(dome, 0, NULL, ray, pixel) == 1;
    }
    cupola_dome_destroy(&dome);
    return lit;
}

/* The distance between a dot that is thrown there and the sticker; -1 where it cannot be seen. */
static double distance_px(const struct cupola_rig *rig, double yaw, double pitch, double astray)
{
    struct stage_fixture fixture;
    struct mark mark = {.name = "it"};
    unsigned char *dot, *dark, *sticker;
    double dot_at[2], sticker_at[2];
    bool seen;
    stage_fixture_make(&fixture, rig);
    fixture.tool.theatre = *rig;
    fixture.tool.preview = PREVIEW_EYE;
    fixture.tool.pattern = PATTERN_DOT;
    fixture.tool.group = GROUP_DOT;
    fixture.tool.dot_yaw_rad = yaw;
    fixture.tool.dot_pitch_rad = pitch;
    fixture.tool.dot_size_rad = 0.05;
    fixture.tool.mark = -1; /* no name beside a cross-hair */
    fixture.tool.cross_px[0] = fixture.tool.cross_px[1] = -1e4;
    screen_point(rig, yaw, pitch + astray, mark.place);
    fixture.tool.marks = (struct marks){.kind = MARKS_POINTS, .list = &mark, .count = 1};
    dot = stage_fixture_frame(&fixture, width, height);
    fixture.tool.dot_yaw_rad = pi; /* behind */
    dark = stage_fixture_frame(&fixture, width, height);
    fixture.tool.group = GROUP_MARKS;
    sticker = stage_fixture_frame(&fixture, width, height);
    seen = find_middle(dot, dark, 8, dot_at);
    seen = find_middle(sticker, dark, 8, sticker_at) && seen;
    free(dot);
    free(dark);
    free(sticker);
    memset(&fixture.tool.marks, 0, sizeof fixture.tool.marks);
    stage_fixture_release(&fixture);
    return seen ? hypot(dot_at[0] - sticker_at[0], dot_at[1] - sticker_at[1]) : -1;
}

static void a_sticker_is_where_a_dot_of_its_direction_is_thrown(void **state)
{
    (void)state;
    uint64_t seed = 71;
    int tried = 0;
    double worst = 0;
    for (int i = 0; i < 40 && tried < 8; i++) {
        struct cupola_rig rig;
        stage_random_rig(&seed, 400, &rig);
        double yaw = random_between(&seed, -0.3, 0.3), pitch = random_between(&seed, -0.3, 0.3);
        if (!is_lit(&rig, yaw, pitch))
            continue;
        double apart = distance_px(&rig, yaw, pitch, 0);
        check_at_least(apart, 0);
        worst = fmax(worst, apart);
        /* A degree away, some 3.4 px in the middle of this preview. */
        check_at_least(distance_px(&rig, yaw, pitch, pi / 180), 2.2);
        tried++;
    }
    check_at_least(tried, 8);
    check_at_most(worst, 0.2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sticker_is_where_a_dot_of_its_direction_is_thrown),
    };
    return cmocka_run_group_tests_name("calib-stage_stickers", tests, stage_context_open,
                                       stage_context_close);
}
