/*
 * The whole way round: a scene drawn into views, warped, thrown onto the simulated screen and
 * looked at from the eye is the scene itself, in plain perspective.
 *
 * The scene is a room whose walls carry waves in every direction of space. Its finest wave is as
 * long as WAVE_PX pixels of the output where these are coarsest on the walls in sight: of such a
 * wave a bilinear sampling loses 5 percent on average, and there are two on the way (views to
 * output, output to screen). Pictures are floats, so that no rounding to 8 bits is measured.
 */
#include <stdio.h>
#include <stdlib.h>

#include "check.h"
#include "context.h"
#include "fixture.h"
#include "picture_error.h"
#include "sight.h"

enum { RIGS = 10, WAVE_PX = 8, BLOCK = 64 };

static const double psnr_least_db = 40.0;
static const double displacement_most_px = 0.05; /* of the picture's pixels */
static const double room_radii[3] = {2.2, 1.7, 2.6};

static const char *const room_vertex =
    "uniform mat4 projection, view;\n"
    "uniform vec3 half_size;\n"
    "out vec3 place;\n"
    "const int corners[36] = int[](0,1,3,0,3,2, 5,4,6,5,6,7, 4,0,2,4,2,6,\n"
    "                              1,5,7,1,7,3, 2,3,7,2,7,6, 4,5,1,4,1,0);\n"
    "void main() {\n"
    "    int corner = corners[gl_VertexID];\n"
    "    place = half_size * vec3(2 * (corner & 1) - 1, (corner & 2) - 1, (corner >> 1 & 2) - 1);\n"
    "    gl_Position = projection * view * vec4(place, 1.0);\n"
    "}\n";
static const char *const room_fragment =
    "uniform float wave_number;\n"
    "in vec3 place;\n"
    "out vec4 color;\n"
    "void main() {\n"
    "    vec3 p = wave_number * place;\n"
    "    vec3 fine = sin(vec3(dot(p, vec3(0.8, 0.0, 0.6)), dot(p, vec3(-0.6, 0.8, 0.0)),\n"
    "                         dot(p, vec3(0.0, 0.6, -0.8))));\n"
    "    vec3 coarse = sin(0.4 * p.yzx + 0.3 * p.zxy);\n"
    "    color = vec4(0.5 + 0.22 * fine + 0.15 * coarse + 0.1 * fine.gbr, 1.0);\n"
    "}\n";

static GLuint room_program, room_vertex_array;

struct picture {
    GLuint texture, framebuffer;
};

static int setup(void **state)
{
    (void)state;
    context_open();
    room_program = context_program(room_vertex, room_fragment);
    glGenVertexArrays(1, &room_vertex_array);
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    glDeleteProgram(room_program);
    glDeleteVertexArrays(1, &room_vertex_array);
    context_close();
    return 0;
}

static struct picture picture_create(int width, int height)
{
    struct picture picture = {0};
    glGenTextures(1, &picture.texture);
    glBindTexture(GL_TEXTURE_2D, picture.texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, NULL);
    glGenFramebuffers(1, &picture.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, picture.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture.texture, 0);
    return picture;
}

static void picture_release(struct picture *picture)
{
    glDeleteFramebuffers(1, &picture->framebuffer);
    glDeleteTextures(1, &picture->texture);
}

static void draw_room(const struct sight *sight, const float projection[16], const float view[16])
{
    GLfloat half_size[3];
    for (int i = 0; i < 3; i++)
        half_size[i] = (GLfloat)sight->half_size[i];
    glUseProgram(room_program);
    glUniformMatrix4fv(glGetUniformLocation(room_program, "projection"), 1, GL_FALSE, projection);
    glUniformMatrix4fv(glGetUniformLocation(room_program, "view"), 1, GL_FALSE, view);
    glUniform3fv(glGetUniformLocation(room_program, "half_size"), 1, half_size);
    glUniform1f(glGetUniformLocation(room_program, "wave_number"), (GLfloat)sight->wave_number);
    glBindVertexArray(room_vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, 36);
}

/* Larger than the rigs of the tests without GL, and with a cap on every other screen. */
static struct cupola_rig theatre_rig(uint64_t *seed)
{
    struct cupola_rig rig = random_rig(seed, 0.5);
    struct cupola_output *output = &rig.outputs[0];
    struct cupola_error error = {CUPOLA_OK, ""};
    output->width_px *= 4;
    output->height_px *= 4;
    output->circle.center_x_px *= 4.0;
    output->circle.center_y_px *= 4.0;
    output->circle.radius_px *= 4.0;
    if (random_int(seed, 0, 1))
        rig.screen.cap_rad = random_between(seed, 1.6, 3.0);
    if (cupola_rig_complete(&rig, &rig, &error) < 0)
        fail_msg("%s", error.message);
    return rig;
}

static struct sight sight_create(const struct cupola_rig *rig, uint64_t *seed)
{
    const struct cupola_gl_params floats = {.format = CUPOLA_FORMAT_RGBA32F};
    struct sight sight = {0};
    fixture_make(rig, NULL, &floats, &sight.fixture);
    look_at_lit_part(&sight, random_between(seed, -pi, pi));
    assert_true(picture_lit(&sight, 1));
    for (int i = 0; i < 3; i++)
        sight.half_size[i] = room_radii[i] * rig->screen.radius_m * rig->units_per_metre;
    sight.wave_number = 2.0 * pi / (WAVE_PX * coarsest_pixel(&sight));
    return sight;
}

/* The image of the output, by views and warp. */
static struct picture draw_output(const struct sight *sight)
{
    const struct cupola_output *output = fixture_output(&sight->fixture, 0);
    struct picture image = picture_create(output->width_px, output->height_px);
    struct cupola_frame frame = {.depth = {.near_distance = 0.02 * sight->half_size[0],
                                           .far_distance = 20.0 * sight->half_size[0]}};
    int views = cupola_gl_frame_begin(sight->fixture.gl, &frame, NULL);
    glEnable(GL_DEPTH_TEST);
    for (int i = 0; i < views; i++) {
        struct cupola_gl_view view;
        assert_int_equal(cupola_gl_view_begin(sight->fixture.gl, i, &view, NULL), CUPOLA_OK);
        draw_room(sight, view.camera.projection, view.camera.view);
        assert_int_equal(cupola_gl_view_end(sight->fixture.gl, NULL), CUPOLA_OK);
    }
    struct cupola_target target = {.framebuffer = image.framebuffer};
    assert_int_equal(cupola_gl_warp(sight->fixture.gl, 0, NULL, &target, NULL), CUPOLA_OK);
    return image;
}

/* What the spectator sees in the theatre of a rig, which need not be the right one. */
static float *draw_theatre(const struct sight *sight, const struct cupola_rig *rig, GLuint image)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    cupola_dome *dome = NULL;
    cupola_theatre *theatre = NULL;
    struct picture picture = picture_create(WIDTH, HEIGHT);
    struct cupola_target target = {.framebuffer = picture.framebuffer};
    if (cupola_dome_create(rig, &dome, &error) < 0 ||
        cupola_theatre_create(dome, &theatre, &error) < 0 ||
        cupola_theatre_draw(theatre, &image, &sight->spectator, WIDTH, HEIGHT, &target, &error) < 0)
        fail_msg("%s", error.message);
    float *pixels = texture_read(picture.texture, WIDTH, HEIGHT);
    cupola_theatre_destroy(&theatre);
    cupola_dome_destroy(&dome);
    picture_release(&picture);
    return pixels;
}

/* The scene itself by the spectator's camera, from nothing but its place, rotation and opening. */
static float *draw_plain(const struct sight *sight)
{
    const struct cupola_rig *rig = cupola_dome_rig(sight->fixture.dome);
    const struct cupola_spectator *spectator = &sight->spectator;
    double n = 0.02 * sight->half_size[0], f = 20.0 * sight->half_size[0], place[3];
    double steepness = 1.0 / tan(0.5 * spectator->fov_rad);
    float view[16] = {[15] = 1.0f}, projection[16] = {0};
    cupola_dome_to_camera(sight->fixture.dome, spectator->position_m, place);
    for (int row = 0; row < 3; row++) {
        double axis[3], offset = 0.0;
        cupola_dome_to_camera(sight->fixture.dome, spectator->rotation + 3 * row, axis);
        for (int i = 0; i < 3; i++) {
            view[4 * i + row] = (float)axis[i];
            offset -= axis[i] * place[i] * rig->units_per_metre;
        }
        view[12 + row] = (float)offset;
    }
    projection[0] = (float)(steepness * HEIGHT / WIDTH);
    projection[5] = (float)steepness;
    projection[10] = (float)((f + n) / (n - f));
    projection[11] = -1.0f;
    projection[14] = (float)(2.0 * f * n / (n - f));
    struct picture picture = picture_create(WIDTH, HEIGHT);
    glBindFramebuffer(GL_FRAMEBUFFER, picture.framebuffer);
    glViewport(0, 0, WIDTH, HEIGHT);
    glDisable(GL_DEPTH_TEST);
    draw_room(sight, projection, view);
    float *pixels = texture_read(picture.texture, WIDTH, HEIGHT);
    picture_release(&picture);
    return pixels;
}

static double contrast(const float *pixels)
{
    double sum = 0.0, squares = 0.0, count = WIDTH * HEIGHT;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        sum += (double)pixels[4 * i];
        squares += (double)pixels[4 * i] * (double)pixels[4 * i];
    }
    return sqrt(squares / count - sum / count * (sum / count));
}

/* A theatre that is not the one the image was made for is seen by both measures. */
static void check_wrong(const struct sight *sight, const struct cupola_rig *wrong, GLuint image,
                        const float *plain, double right_psnr_db)
{
    int blocks;
    float *seen = draw_theatre(sight, wrong, image);
    double psnr = psnr_db(plain, seen, WIDTH, HEIGHT);
    double moved = displacement_px(plain, seen, WIDTH, HEIGHT, BLOCK, &blocks);
    printf("      wrong: %5.1f dB, displaced by %.3f px\n", psnr, moved);
    check_at_most(psnr, right_psnr_db - 3.0);
    check_at_least(moved, 2.0 * displacement_most_px);
    free(seen);
}

static void compare(uint64_t *seed)
{
    struct cupola_rig rig = theatre_rig(seed), wrong = rig;
    struct sight sight = sight_create(&rig, seed);
    struct picture image = draw_output(&sight);
    float *plain = draw_plain(&sight), *seen = draw_theatre(&sight, &rig, image.texture);
    int blocks;
    double psnr = psnr_db(plain, seen, WIDTH, HEIGHT);
    double moved = displacement_px(plain, seen, WIDTH, HEIGHT, BLOCK, &blocks);
    printf("%-13s %4.0f deg, opening %2.0f deg: %5.1f dB, displaced by %.4f px, contrast %.2f\n",
           cupola_lens_model_name(rig.outputs[0].lens.model),
           rig.outputs[0].lens.fov_rad * 180.0 / pi, sight.spectator.fov_rad * 180.0 / pi, psnr,
           moved, contrast(plain));
    check_at_least(psnr, psnr_least_db);
    check_at_most(moved, displacement_most_px);
    check_at_least(blocks, WIDTH / BLOCK * (HEIGHT / BLOCK) / 2);
    check_at_least(contrast(plain), 0.1);
    wrong.outputs[0].aim.yaw_rad += radians(0.1);
    check_wrong(&sight, &wrong, image.texture, plain, psnr);
    wrong = rig;
    wrong.outputs[0].circle.center_x_px += 1.0;
    check_wrong(&sight, &wrong, image.texture, plain, psnr);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    free(plain);
    free(seen);
    picture_release(&image);
    fixture_release(&sight.fixture);
}

static void theatre_seen_from_the_eye_is_the_scene_in_plain_perspective(void **state)
{
    (void)state;
    for (uint64_t rig = 0; rig < RIGS; rig++) {
        uint64_t seed = 7000 + rig;
        printf("seed %d: ", (int)seed);
        compare(&seed);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(theatre_seen_from_the_eye_is_the_scene_in_plain_perspective),
    };
    return cmocka_run_group_tests_name("end_to_end", tests, setup, teardown);
}
