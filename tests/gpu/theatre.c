/* The simulated theatre's own facts: what light is where, who stands where, what is refused. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "context.h"
#include "fixture.h"
#include "oracle.h"
#include "sight.h"

static int setup(void **state)
{
    (void)state;
    context_open();
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    context_close();
    return 0;
}

/* A theatre with its pictures: images to be thrown, and the spectator's. */
struct stage {
    struct sight sight;
    cupola_theatre *theatre;
    GLuint texture, framebuffer;
};

static struct stage stage_create(const struct cupola_rig *rig)
{
    struct stage stage = {0};
    fixture_make(rig, NULL, NULL, &stage.sight.fixture);
    assert_int_equal(cupola_theatre_create(stage.sight.fixture.dome, &stage.theatre, NULL),
                     CUPOLA_OK);
    cupola_spectator_at_eye(stage.sight.fixture.dome, &stage.sight.spectator);
    glGenTextures(1, &stage.texture);
    glBindTexture(GL_TEXTURE_2D, stage.texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, WIDTH, HEIGHT, 0, GL_RGBA, GL_FLOAT, NULL);
    glGenFramebuffers(1, &stage.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, stage.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, stage.texture, 0);
    return stage;
}

static void stage_release(struct stage *stage)
{
    cupola_theatre_destroy(&stage->theatre);
    glDeleteFramebuffers(1, &stage->framebuffer);
    glDeleteTextures(1, &stage->texture);
    fixture_release(&stage->sight.fixture);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static float *stage_draw(const struct stage *stage, const GLuint *images)
{
    struct cupola_target target = {.framebuffer = stage->framebuffer};
    struct cupola_error error = {CUPOLA_OK, ""};
    if (cupola_theatre_draw(stage->theatre, images, &stage->sight.spectator, WIDTH, HEIGHT, &target,
                            &error) < 0)
        fail_msg("%s", error.message);
    return texture_read(stage->texture, WIDTH, HEIGHT);
}

static GLuint screen_image(const struct stage *stage, int output)
{
    unsigned int points = 0;
    assert_int_equal(cupola_gl_points(stage->sight.fixture.gl, output, &points, NULL), CUPOLA_OK);
    return points;
}

static GLuint plain_image(const struct stage *stage, float value)
{
    const struct cupola_output *output = fixture_output(&stage->sight.fixture, 0);
    size_t count = 4 * (size_t)output->width_px * (size_t)output->height_px;
    float *pixels = malloc(count * sizeof *pixels);
    GLuint texture = 0;
    assert_non_null(pixels);
    for (size_t i = 0; i < count; i++)
        pixels[i] = value;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, output->width_px, output->height_px, 0, GL_RGBA,
                 GL_FLOAT, pixels);
    free(pixels);
    return texture;
}

/*
 * Where the spectator's ray through the middle of a pixel leaves the sphere, dome frame, in the
 * textbook's way: |p + t d| = R. 0 where it misses the sphere or leaves it behind the spectator.
 */
static int screen_in_sight(const struct sight *sight, int x, int y, double point[3])
{
    const struct cupola_spectator *spectator = &sight->spectator;
    double radius = cupola_dome_rig(sight->fixture.dome)->screen.radius_m;
    double direction[3], along[3], a = 0.0, b = 0.0, c = -radius * radius;
    picture_direction(sight, x + 0.5, y + 0.5, direction);
    cupola_dome_from_camera(sight->fixture.dome, direction, along);
    for (int i = 0; i < 3; i++) {
        a += along[i] * along[i];
        b += 2.0 * along[i] * spectator->position_m[i];
        c += spectator->position_m[i] * spectator->position_m[i];
    }
    if (b * b < 4.0 * a * c)
        return 0;
    double t = (-b + sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
    for (int i = 0; i < 3; i++)
        point[i] = spectator->position_m[i] + t * along[i];
    return t > 0.0;
}

/* The largest distance between light and place, radii; and how many places are lit and dark. */
struct screen_error {
    double radii;
    int lit, dark;
};

static struct screen_error compare_screen(const struct sight *sight, const float *seen)
{
    const struct cupola_rig *rig = cupola_dome_rig(sight->fixture.dome);
    struct screen_error error = {0};
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const float *light = seen + 4 * (y * WIDTH + x);
            double point[3], from_eye[3], direction[3], at[2], square = 0.0;
            struct cupola_ray ray;
            int met = screen_in_sight(sight, x, y, point);
            for (int i = 0; i < 3 && met; i++) {
                from_eye[i] = point[i] - rig->eye_m[i];
                square += pow((double)light[i] - point[i], 2.0);
            }
            if (met)
                cupola_dome_to_camera(sight->fixture.dome, from_eye, direction);
            if (met && lit_in_full(sight->fixture.dome, direction, &ray)) {
                error.radii = fmax(error.radii, sqrt(square) / rig->screen.radius_m);
                error.lit++;
            } else if (!met ||
                       cupola_dome_pixel(sight->fixture.dome, 0, NULL, direction, at) != 1) {
                double brightest = 0.0;
                for (int i = 0; i < 3; i++)
                    brightest = fmax(brightest, fabs((double)light[i]));
                /* Rounding may light a pixel on the very edge of image circle, cap or frame. */
                error.dark += brightest == 0.0;
            }
        }
    return error;
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Stands anywhere at a distance, and looks roughly at the middle of what is lit. */
static void stand_anywhere(uint64_t *seed, struct stage *stage, double distance_radii)
{
    struct cupola_spectator *spectator = &stage->sight.spectator;
    const cupola_dome *dome = stage->sight.fixture.dome;
    double radius = cupola_dome_rig(dome)->screen.radius_m, mean[3], lit[3], gaze[3], direction[3];
    double *position = spectator->position_m;
    mean_direction(&stage->sight.fixture, mean);
    cupola_dome_from_camera(dome, mean, lit);
    random_in_ball(seed, 1.0, position);
    /* From outside one sees the far half of the screen: stand across from what is lit. */
    double scale = distance_radii * radius / sqrt(dot(position, position));
    if (distance_radii > 1.0 && dot(position, lit) > 0.0)
        scale = -scale;
    for (int i = 0; i < 3; i++)
        position[i] *= scale;
    for (int i = 0; i < 3; i++)
        gaze[i] = 0.5 * radius * lit[i] - position[i];
    double length = sqrt(dot(gaze, gaze));
    for (int i = 0; i < 3; i++)
        gaze[i] /= length;
    cupola_dome_to_camera(dome, gaze, direction);
    turn_towards(dome, direction, random_between(seed, -pi, pi), spectator);
    spectator->fov_rad = random_between(seed, 0.8, 1.6);
}

/*
 * A world painted on the screen looks the same from everywhere. The bound is that of bilinear
 * filtering: of pixels up to w = 0.02 radii wide it makes an error of w^2/4 by curvature, and of
 * w/256 because a GL may count places in 1/256 of a pixel.
 */
static void screen_seen_from_anywhere_is_the_screen(void **state)
{
    (void)state;
    for (uint64_t trial = 0; trial < 12; trial++) {
        static const double distances[3] = {0.3, 0.75, 2.5};
        uint64_t seed = 8100 + trial;
        struct cupola_rig rig = random_rig(&seed, 0.4);
        rig.outputs[0].width_px *= 3;
        rig.outputs[0].height_px *= 3;
        rig.outputs[0].circle.center_x_px *= 3.0;
        rig.outputs[0].circle.center_y_px *= 3.0;
        rig.outputs[0].circle.radius_px *= 3.0;
        if (trial % 2) {
            rig.screen.cap_rad = random_between(&seed, 1.4, 2.4);
            rig.outputs[0].aim.yaw_rad *= 0.3; /* not past the screen altogether */
        }
        struct stage stage = stage_create(&rig);
        GLuint image = screen_image(&stage, 0);
        stand_anywhere(&seed, &stage, distances[trial % 3]);
        float *seen = stage_draw(&stage, &image);
        struct screen_error error = compare_screen(&stage.sight, seen);
        printf("  seed %d, at %.2f radii: off by %.1e radii, %d lit, %d dark\n",
               (int)(8100 + trial), distances[trial % 3], error.radii, error.lit, error.dark);
        check_at_most(error.radii, 2e-4);
        check_at_least(error.lit, 500);
        check_at_least(error.lit + error.dark, 0.9 * WIDTH * HEIGHT);
        free(seen);
        stage_release(&stage);
    }
}

static void theatre_of_another_rig_shows_another_screen(void **state)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 512), wrong;
    (void)state;
    for (int fault = 0; fault < 2; fault++) {
        struct stage stage = stage_create(&rig);
        GLuint image = screen_image(&stage, 0);
        wrong = rig;
        assert_int_equal(cupola_rig_complete(&wrong, &wrong, NULL), CUPOLA_OK);
        wrong.outputs[0].aim.pitch_rad += fault ? 0.0 : radians(0.1);
        wrong.outputs[0].circle.center_y_px += fault ? 1.0 : 0.0;
        struct stage other = stage_create(&wrong);
        float *seen = stage_draw(&other, &image);
        check_at_least(compare_screen(&stage.sight, seen).radii, 1e-3);
        free(seen);
        stage_release(&other);
        stage_release(&stage);
    }
}

static void lights_of_two_projectors_add_up(void **state)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 120.0, 256);
    (void)state;
    rig.output_count = 2;
    rig.outputs[1] = rig.outputs[0];
    rig.outputs[0].aim.yaw_rad = 0.3;
    rig.outputs[1].aim.yaw_rad = -0.4;
    rig.outputs[1].position_m[0] = 0.2;
    struct stage stage = stage_create(&rig);
    GLuint black = plain_image(&stage, 0.0f), grey = plain_image(&stage, 0.25f);
    GLuint both[2] = {screen_image(&stage, 0), grey}, first[2] = {both[0], black};
    GLuint second[2] = {black, both[1]};
    stage.sight.spectator.fov_rad = 1.8;
    float *sum = stage_draw(&stage, both), *a = stage_draw(&stage, first);
    float *b = stage_draw(&stage, second);
    int overlap = 0;
    for (int i = 0; i < 4 * WIDTH * HEIGHT; i++) {
        double alone[2] = {(double)a[i], (double)b[i]};
        overlap += i % 4 != 3 && fabs(alone[0]) > 0.1 && fabs(alone[1]) > 0.1;
        check_near(sum[i], i % 4 == 3 ? 1.0 : alone[0] + alone[1], 1e-6);
    }
    check_at_least(overlap, WIDTH * HEIGHT / 4);
    free(sum);
    free(a);
    free(b);
    glDeleteTextures(1, &black);
    glDeleteTextures(1, &grey);
    stage_release(&stage);
}

static void ambient_light_falls_on_the_screen_once(void **state)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 120.0, 64);
    (void)state;
    rig.output_count = 2;
    rig.outputs[1] = rig.outputs[0];
    struct stage stage = stage_create(&rig);
    GLuint black = plain_image(&stage, 0.0f), images[2] = {black, black};
    stage.sight.spectator.ambient_rgb[1] = 0.3f;
    float *seen = stage_draw(&stage, images);
    check_near(seen[1], 0.3, 1e-6);
    check_near(seen[0], 0.0, 0.0);
    free(seen);
    glDeleteTextures(1, &black);
    stage_release(&stage);
}

/* Where a point of the dome frame stands in the spectator's picture; continuous px. */
static void picture_place(const struct cupola_spectator *spectator, const double point[3],
                          int place[2])
{
    double q[3] = {0, 0, 0}, half = tan(0.5 * spectator->fov_rad);
    for (int row = 0; row < 3; row++)
        for (int i = 0; i < 3; i++)
            q[row] += spectator->rotation[3 * row + i] * (point[i] - spectator->position_m[i]);
    place[0] = (int)(0.5 * (WIDTH + q[0] / -q[2] / half * HEIGHT));
    place[1] = (int)(0.5 * HEIGHT * (1.0 + q[1] / -q[2] / half));
}

static void viewer_and_projector_stand_where_the_rig_says(void **state)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 64);
    (void)state;
    rig.screen.radius_m = 4.0;
    rig.eye_m[0] = -1.5;
    rig.outputs[0].position_m[1] = -1.2;
    rig.tilt_rad = 0.4;
    struct stage stage = stage_create(&rig);
    GLuint black = plain_image(&stage, 0.0f);
    cupola_spectator_outside(stage.sight.fixture.dome, &stage.sight.spectator);
    int viewer[2], projector[2];
    picture_place(&stage.sight.spectator, rig.eye_m, viewer);
    picture_place(&stage.sight.spectator, rig.outputs[0].position_m, projector);
    float *seen = stage_draw(&stage, &black);
    const float *orange = seen + 4 * (viewer[1] * WIDTH + viewer[0]);
    const float *blue = seen + 4 * (projector[1] * WIDTH + projector[0]);
    check_at_least(orange[0] - orange[2], 0.2);
    check_at_least(blue[2] - blue[0], 0.2);
    free(seen);
    stage.sight.spectator.furniture = false;
    seen = stage_draw(&stage, &black);
    check_at_most(seen[4 * (viewer[1] * WIDTH + viewer[0])], 0.15);
    free(seen);
    glDeleteTextures(1, &black);
    stage_release(&stage);
}

static void spectator_at_the_eye_looks_ahead(void **state)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 64);
    struct cupola_spectator spectator;
    double axis[3];
    (void)state;
    rig.tilt_rad = 1.1;
    rig.eye_m[1] = 0.3;
    cupola_dome *dome = dome_of(&rig);
    cupola_spectator_at_eye(dome, &spectator);
    for (int row = 0; row < 3; row++) {
        cupola_dome_to_camera(dome, spectator.rotation + 3 * row, axis);
        for (int i = 0; i < 3; i++)
            check_near(axis[i], i == row, 1e-15);
    }
    check_near(spectator.position_m[1], 0.3, 0.0);
    check_near(spectator.fov_rad, radians(60.0), 1e-15);
    cupola_dome_destroy(&dome);
}

static void spectator_without_a_rotation_looks_as_the_camera_does(void **state)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 64);
    (void)state;
    rig.tilt_rad = 0.7;
    struct stage stage = stage_create(&rig);
    GLuint image = screen_image(&stage, 0);
    size_t bytes = (size_t)(4 * WIDTH * HEIGHT) * sizeof(float);
    float *turned = stage_draw(&stage, &image);
    memset(stage.sight.spectator.rotation, 0, sizeof stage.sight.spectator.rotation);
    float *plain = stage_draw(&stage, &image);
    assert_memory_equal(plain, turned, bytes);
    check_at_least(fabs((double)plain[4 * (HEIGHT / 2 * WIDTH + WIDTH / 2) + 2]), 0.5);
    free(plain);
    free(turned);
    stage_release(&stage);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(screen_seen_from_anywhere_is_the_screen),
        cmocka_unit_test(theatre_of_another_rig_shows_another_screen),
        cmocka_unit_test(lights_of_two_projectors_add_up),
        cmocka_unit_test(ambient_light_falls_on_the_screen_once),
        cmocka_unit_test(viewer_and_projector_stand_where_the_rig_says),
        cmocka_unit_test(spectator_at_the_eye_looks_ahead),
        cmocka_unit_test(spectator_without_a_rotation_looks_as_the_camera_does),
    };
    return cmocka_run_group_tests_name("theatre", tests, setup, teardown);
}
