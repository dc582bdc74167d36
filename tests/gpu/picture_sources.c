/*
 * Existing pictures in the warp: against the warp in plain C, and by what must be true of them. The
 * pictures are those of painted.h, a texel's colour being its direction, so that a difference of
 * colours is one of angles in rad.
 */
#include <stdio.h>
#include <string.h>

#include "group.h"
#include "oracle.h"
#include "painted.h"
#include "rig_random.h"
#include "worse.h"

static const float border[4] = {0.3f, 0.1f, 0.2f, 0.5f};
static const unsigned int all_pictures =
    1u << CUPOLA_SOURCE_DOMEMASTER | 1u << CUPOLA_SOURCE_EQUIRECTANGULAR | 1u << CUPOLA_SOURCE_CUBE;

enum { HEIGHT = 512, SIDE = 128, RIGS = 18 };

/* A texture of a painted picture, or of any other of its shape. */
static void texture_make(struct cupola_source *source, const float *picture, int height)
{
    GLsizei width = painted_width(source, height);
    bool cube = source->kind == CUPOLA_SOURCE_CUBE;
    GLenum target = cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
    glGenTextures(1, &source->texture);
    glBindTexture(target, source->texture);
    for (int face = 0; face < painted_faces(source); face++)
        glTexImage2D(cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + (GLenum)face : target, 0, GL_RGBA32F,
                     width, height, 0, GL_RGBA, GL_FLOAT,
                     picture + 4 * (size_t)face * (size_t)width * (size_t)height);
    if (source->mipmaps)
        glGenerateMipmap(target);
    glBindTexture(target, 0); /* its filter stays GL's default, which wants mipmaps */
}

/* The image of output 0, freed by the caller. */
static float *image_of(const struct fixture *fixture, const struct cupola_source *source)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_target target = {0, 5, 3};
    GLuint texture = 0;
    float *image = malloc(4 * sizeof *image * (size_t)size->width_px * (size_t)size->height_px);
    assert_non_null(image);
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, size->width_px + 5, size->height_px + 3, 0, GL_RGBA,
                 GL_FLOAT, NULL);
    glGenFramebuffers(1, &target.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (cupola_gl_warp(fixture->gl, 0, source, &target, &error) < 0 ||
        cupola_gl_capture(&target, size->width_px, size->height_px, image, &error) < 0)
        fail_msg("%s", error.message);
    glDeleteFramebuffers(1, &target.framebuffer);
    glDeleteTextures(1, &texture);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    return image;
}

static void make_for_pictures(const struct cupola_rig *rig, struct fixture *fixture)
{
    struct cupola_gl_params params = {.sources = all_pictures};
    memcpy(params.border, border, sizeof border);
    fixture_make(rig, NULL, &params, fixture);
}

static struct cupola_rig rig_number(uint64_t *seed, int number)
{
    struct cupola_rig rig = random_rig(seed, 0.6);
    rig.outputs[0].lens =
        random_lens(seed, (enum cupola_lens_model)(number % 6), radians(170.0 - number));
    rig.outputs[0].width_px = SIDE;
    rig.outputs[0].height_px = SIDE - 9;
    rig.outputs[0].circle = (struct cupola_circle){60.0, 55.0, number % 2 ? 70.0 : 50.0};
    rig.screen.cap_rad = number % 3 ? 0.0 : radians(80.0);
    return rig;
}

/* How far colours are apart, where the pixel is lit in full and where a part of it is. */
struct image_error {
    double inside, edge;
};

static double pixel_error(const float *shown, const float *expected)
{
    double square = 0.0;
    for (int c = 0; c < 4; c++) {
        double off = (double)shown[c] - (double)expected[c];
        square += off * off;
    }
    return sqrt(square);
}

static float *reference_of(const cupola_dome *dome, const struct cupola_source *source,
                           const float *picture, int height)
{
    const struct cupola_output *size = &cupola_dome_rig(dome)->outputs[0];
    float *image = malloc(4 * sizeof *image * (size_t)size->width_px * (size_t)size->height_px);
    assert_non_null(image);
    assert_int_equal(cupola_reference_source(dome, 0, source, picture,
                                             painted_width(source, height), height, border, image),
                     CUPOLA_OK);
    return image;
}

/* A direction's alpha is 1: what is not is a mixture with the border. */
static struct image_error error_of(const float *shown, const cupola_dome *dome,
                                   const struct cupola_source *source, const float *picture)
{
    const struct cupola_output *size = &cupola_dome_rig(dome)->outputs[0];
    float *expected = reference_of(dome, source, picture, HEIGHT);
    struct image_error error = {0.0, 0.0};
    for (int i = 0; i < size->width_px * size->height_px; i++) {
        const float *wish = expected + 4 * i;
        double *part = wish[3] > 0.99999f ? &error.inside : &error.edge;
        *part = worse_of(*part, pixel_error(shown + 4 * i, wish));
    }
    free(expected);
    return error;
}

/*
 * 1e-5 rad; at edges beside that the coverage, times the difference of colours, at most 2: floats
 * know it within 1e-4, of a domemaster's rim within the 2e-4 px that llvmpipe's atan errs by.
 */
static const double bar = 1e-5, bar_edge = 5e-4;

static void the_image_is_that_of_the_reference(void **state)
{
    (void)state;
    uint64_t seed = 7101;
    struct image_error worst = {0.0, 0.0};
    for (int number = 0; number < RIGS; number++) {
        struct cupola_rig rig = rig_number(&seed, number);
        struct cupola_source source = random_source(&seed, number);
        struct fixture fixture;
        make_for_pictures(&rig, &fixture);
        float *picture = painted_picture(&source, HEIGHT);
        texture_make(&source, picture, HEIGHT);
        float *shown = image_of(&fixture, &source);
        struct image_error error = error_of(shown, fixture.dome, &source, picture);
        worst.inside = worse_of(worst.inside, error.inside);
        worst.edge = worse_of(worst.edge, error.edge);
        glDeleteTextures(1, &source.texture);
        free(shown);
        free(picture);
        fixture_release(&fixture);
    }
    printf("at most %.2g rad apart, at edges %.2g\n", worst.inside, worst.edge);
    check_at_most(worst.inside, bar);
    check_at_most(worst.edge, bar_edge);
}

static void a_tenth_of_a_degree_or_a_pixel_is_caught(void **state)
{
    (void)state;
    uint64_t seed = 7102;
    for (int number = 0; number < 9; number++) {
        struct cupola_rig rig = rig_number(&seed, number), shifted = rig;
        struct cupola_source source = random_source(&seed, number), turned = source;
        struct fixture fixture;
        cupola_dome *wrong = NULL;
        turned.orientation.yaw_rad += radians(0.1);
        shifted.outputs[0].circle.center_x_px += 1.0;
        make_for_pictures(&rig, &fixture);
        assert_int_equal(cupola_dome_create(&shifted, &wrong, NULL), CUPOLA_OK);
        float *picture = painted_picture(&source, HEIGHT);
        texture_make(&source, picture, HEIGHT);
        float *shown = image_of(&fixture, &source);
        struct image_error by_turn = error_of(shown, fixture.dome, &turned, picture);
        struct image_error by_shift = error_of(shown, wrong, &source, picture);
        check_at_least(by_turn.inside, 10.0 * bar);
        check_at_least(by_shift.inside, 10.0 * bar);
        check_at_least(by_shift.edge, 2.0 * bar_edge);
        cupola_dome_destroy(&wrong);
        glDeleteTextures(1, &source.texture);
        free(shown);
        free(picture);
        fixture_release(&fixture);
    }
}

/* Random numbers, RGBA. */
static float *noise_picture(size_t texels)
{
    uint64_t seed = 7103;
    float *picture = malloc(4 * sizeof *picture * texels);
    assert_non_null(picture);
    for (size_t i = 0; i < 4 * texels; i++)
        picture[i] = (float)random_between(&seed, 0.0, 1.0);
    return picture;
}

/* The largest difference in pixels all of which lie inside of the rim, `dx` pixels beside. */
static double difference_inside(const float *image, const float *picture, int side, int dx)
{
    double worst = 0.0, middle = 0.5 * side;
    for (int j = 0; j < side; j++)
        for (int i = 0; i < side; i++)
            if (hypot(i + 0.5 - middle, j + 0.5 - middle) < middle - 1.5)
                worst = worse_of(worst, pixel_error(image + 4 * (j * side + i),
                                                    picture + 4 * (j * side + i + dx)));
    return worst;
}

/* On a planetarium as well: that its front is at the bottom holds for what is shown and shows. */
static void a_domemaster_on_its_own_rig_comes_out_as_it_is(void **state)
{
    (void)state;
    for (int number = 0; number < 4; number++) {
        struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, number % 2 ? 180.0 : 210.0, SIDE);
        struct cupola_source source = {.kind = CUPOLA_SOURCE_DOMEMASTER};
        struct fixture fixture;
        rig.tilt_rad = number / 2 ? radians(90.0) : 0.0;
        source.fov_rad = rig.outputs[0].lens.fov_rad;
        make_for_pictures(&rig, &fixture);
        float *picture = noise_picture(SIDE * SIDE);
        texture_make(&source, picture, SIDE);
        float *image = image_of(&fixture, &source);
        check_at_most(difference_inside(image, picture, SIDE, 0), 1e-3); /* 0.0005 texels */
        check_at_least(difference_inside(image, picture, SIDE, 1), 0.5);
        glDeleteTextures(1, &source.texture);
        free(image);
        free(picture);
        fixture_release(&fixture);
    }
}

static void a_domemaster_of_the_views_is_what_the_views_show(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, HEIGHT);
    struct cupola_source source = {.kind = CUPOLA_SOURCE_DOMEMASTER};
    const struct cupola_gl_params params = {.format = CUPOLA_FORMAT_RGBA32F,
                                            .sources = 1u << CUPOLA_SOURCE_VIEWS |
                                                       1u << CUPOLA_SOURCE_DOMEMASTER};
    struct fixture maker, shower;
    rig.tilt_rad = radians(90.0);
    fixture_make(&rig, NULL, &params, &maker);
    fixture_paint(&maker, PAINT_DIRECTIONS);
    float *domemaster = fixture_warp(&maker, 0);
    texture_make(&source, domemaster, HEIGHT);
    /* Another theatre altogether, with its eye and its projector off the centre. */
    rig.outputs[0].lens = (struct cupola_lens){CUPOLA_LENS_EQUISOLID, radians(150.0)};
    rig.outputs[0].position_m[1] = -0.2;
    rig.eye_m[0] = 0.1;
    fixture_make(&rig, NULL, &params, &shower);
    float *shown = image_of(&shower, &source);
    double worst = 0.0;
    for (int j = 0; j < HEIGHT; j++)
        for (int i = 0; i < HEIGHT; i++) {
            struct cupola_ray ray;
            double expected[3];
            const float *pixel = shown + 4 * (j * HEIGHT + i);
            const double direction[3] = {(double)pixel[0], (double)pixel[1], (double)pixel[2]};
            cupola_dome_ray(shower.dome, 0, NULL, i + 0.5, j + 0.5, &ray);
            if (ray.coverage < 1.0 || -ray.point_m[2] < 0.05)
                continue; /* beyond the domemaster's rim, or beside it */
            cupola_dome_to_camera(shower.dome, ray.point_m, expected);
            worst = worse_of(worst, angle_between(direction, expected));
        }
    check_at_most(worst, radians(0.01));
    glDeleteTextures(1, &source.texture);
    free(shown);
    free(domemaster);
    fixture_release(&shower);
    fixture_release(&maker);
}

/* How far the shown directions are from those of the rays, over all lit pixels. */
static double blurred_error(const struct fixture *fixture, const struct cupola_source *source)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    float *shown = image_of(fixture, source);
    double worst = 0.0;
    for (int j = 0; j < size->height_px; j++)
        for (int i = 0; i < size->width_px; i++) {
            struct cupola_ray ray;
            double expected[3];
            const float *pixel = shown + 4 * (j * size->width_px + i);
            const double direction[3] = {(double)pixel[0], (double)pixel[1], (double)pixel[2]};
            cupola_dome_ray(fixture->dome, 0, NULL, i + 0.5, j + 0.5, &ray);
            shown_direction(fixture->dome, source, &ray, expected);
            if (ray.coverage < 1.0)
                continue;
            worst = worse_of(worst, angle_between(direction, expected));
        }
    free(shown);
    return worst;
}

/*
 * A pixel is 3 degrees wide and 16 texels. Where a gradient jumps, as the longitude does behind the
 * viewer, or a level is far too coarse, as at a pole, directions are off by tens of degrees.
 */
static void coarse_pixels_have_no_seam_behind_and_none_at_the_poles(void **state)
{
    (void)state;
    for (int kind = CUPOLA_SOURCE_DOMEMASTER; kind <= CUPOLA_SOURCE_CUBE; kind++)
        for (int turn = 0; turn < 4; turn++) {
            struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 200.0, 64);
            struct cupola_source source = {
                .kind = (enum cupola_source_kind)kind, .mipmaps = true, .fov_rad = radians(300.0)};
            struct fixture fixture;
            rig.tilt_rad = turn % 2 ? radians(90.0) : 0.0;
            source.orientation.yaw_rad = turn / 2 && kind != 1 ? radians(180.0) : 0.0;
            make_for_pictures(&rig, &fixture);
            float *picture = painted_picture(&source, 2 * HEIGHT);
            texture_make(&source, picture, 2 * HEIGHT);
            double error = blurred_error(&fixture, &source);
            printf("%s, turn %d: %.2g degrees\n", cupola_source_name(kind), turn,
                   error / radians(1.0));
            check_at_most(error, radians(1.0));
            glDeleteTextures(1, &source.texture);
            free(picture);
            fixture_release(&fixture);
        }
}

/* The root mean square distance from the mean, 0.5, of one channel of lit pixels. */
static double spread(const struct fixture *fixture, const struct cupola_source *source)
{
    const struct cupola_output *size = fixture_output(fixture, 0);
    float *shown = image_of(fixture, source);
    double square = 0.0, middle = 0.5 * size->width_px;
    int count = 0;
    for (int j = 0; j < size->height_px; j++)
        for (int i = 0; i < size->width_px; i++) {
            double off = (double)shown[4 * (j * size->width_px + i)] - 0.5;
            if (hypot(i + 0.5 - middle, j + 0.5 - middle) > middle - 1.0)
                continue;
            square += off * off;
            count++;
        }
    free(shown);
    return sqrt(square / count);
}

static void fine_pictures_are_averaged_where_they_have_mipmaps(void **state)
{
    (void)state;
    for (int kind = CUPOLA_SOURCE_DOMEMASTER; kind <= CUPOLA_SOURCE_CUBE; kind++) {
        struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 64);
        struct cupola_source source = {.kind = (enum cupola_source_kind)kind, .mipmaps = true};
        struct fixture fixture;
        make_for_pictures(&rig, &fixture);
        float *picture = noise_picture((size_t)12 * HEIGHT * HEIGHT);
        texture_make(&source, picture, HEIGHT);
        double averaged = spread(&fixture, &source);
        source.mipmaps = false;
        double sampled = spread(&fixture, &source);
        printf("%s: spread %.3f, without mipmaps %.3f\n", cupola_source_name(kind), averaged,
               sampled);
        check_at_most(averaged, 0.4 * sampled);
        glDeleteTextures(1, &source.texture);
        free(picture);
        fixture_release(&fixture);
    }
}

static void check_refused(const struct fixture *fixture, const struct cupola_source *source,
                          const struct cupola_target *target, const char *word)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    assert_int_equal(cupola_gl_warp(fixture->gl, 0, source, target, &error), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(error.status, CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    if (!strstr(error.message, word))
        fail_msg("'%s' does not say '%s'", error.message, word);
}

static void what_cannot_be_shown_is_refused(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 16);
    struct cupola_source flat = {.kind = CUPOLA_SOURCE_DOMEMASTER};
    struct cupola_source cube = {.kind = CUPOLA_SOURCE_CUBE}, bad;
    struct fixture fixture;
    make_for_pictures(&rig, &fixture);
    float *picture = noise_picture(6 * 16 * 16);
    texture_make(&flat, picture, 16);
    texture_make(&cube, picture, 16);
    check_refused(&fixture, NULL, NULL, "kind views");
    bad = flat;
    bad.kind = (enum cupola_source_kind)9;
    check_refused(&fixture, &bad, NULL, "is 9; allowed: 0 to 3");
    bad.kind = CUPOLA_SOURCE_CUBE;
    check_refused(&fixture, &bad, NULL, "GL_TEXTURE_CUBE_MAP");
    bad = cube;
    bad.kind = CUPOLA_SOURCE_EQUIRECTANGULAR;
    check_refused(&fixture, &bad, NULL, "GL_TEXTURE_2D");
    bad = (struct cupola_source){.kind = CUPOLA_SOURCE_DOMEMASTER};
    check_refused(&fixture, &bad, NULL, "texture is 0");
    bad.texture = 4711;
    check_refused(&fixture, &bad, NULL, "texture is 4711");
    bad = flat;
    bad.fov_rad = 7.0;
    check_refused(&fixture, &bad, NULL, "field of view is 7 rad");
    bad = flat;
    bad.orientation.roll_rad = (double)NAN;
    check_refused(&fixture, &bad, NULL, "roll");
    bad = flat;
    bad.place = (enum cupola_source_place)5;
    check_refused(&fixture, &bad, NULL, "place of the source is 5");
    struct cupola_target target = {0};
    glGenFramebuffers(1, &target.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, flat.texture, 0);
    check_refused(&fixture, &flat, &target, "color attachment 0");
    glDeleteFramebuffers(1, &target.framebuffer);
    glDeleteTextures(1, &flat.texture);
    glDeleteTextures(1, &cube.texture);
    free(picture);
    fixture_release(&fixture);
}

static void a_gl_for_pictures_has_no_views(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 16);
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_gl_params params = {.sources = 1u << 4};
    struct fixture fixture;
    cupola_gl *none = NULL;
    unsigned int points = 0;
    make_for_pictures(&rig, &fixture);
    assert_int_equal(cupola_gl_frame_begin(fixture.gl, NULL, &error), CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "without views"));
    assert_int_equal(cupola_gl_atlas(fixture.gl), 0);
    assert_int_equal(cupola_gl_points(fixture.gl, 0, &points, NULL), CUPOLA_OK);
    assert_true(glIsTexture(points));
    assert_int_equal(cupola_gl_create(fixture.plan, &params, &none, &error), CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "sources is 0x10"));
    assert_null(none);
    fixture_release(&fixture);
}

/* What of the host's state only a cube map touches; the test host_state has the rest. */
static void the_host_keeps_its_cube_map(void **state)
{
    (void)state;
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 180.0, 16);
    struct cupola_source cube = {.kind = CUPOLA_SOURCE_CUBE}, host = cube, flat = cube;
    struct fixture fixture;
    make_for_pictures(&rig, &fixture);
    flat.kind = CUPOLA_SOURCE_DOMEMASTER;
    float *picture = noise_picture(6 * 16 * 16);
    texture_make(&cube, picture, 16);
    texture_make(&host, picture, 16);
    texture_make(&flat, picture, 16);
    glBindTexture(GL_TEXTURE_CUBE_MAP, host.texture);
    glBindTexture(GL_TEXTURE_2D, flat.texture);
    bool es = context_is_es(); /* always seamless, without a switch */
    for (int seamless = 0; seamless < (es ? 1 : 2); seamless++) {
        GLint bound = 0, bound_flat = 0, sampler = -1;
        if (!es)
            (seamless ? glEnable : glDisable)(GL_TEXTURE_CUBE_MAP_SEAMLESS);
        free(image_of(&fixture, &cube));
        glBindTexture(GL_TEXTURE_2D, flat.texture); /* image_of has one of its own */

        struct cupola_source bad = flat;
        bad.kind = CUPOLA_SOURCE_CUBE;
        check_refused(&fixture, &bad, NULL, "CUBE");
        glGetIntegerv(GL_TEXTURE_BINDING_CUBE_MAP, &bound);
        glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound_flat);
        glGetIntegerv(GL_SAMPLER_BINDING, &sampler);
        assert_int_equal(bound, host.texture);
        assert_int_equal(bound_flat, flat.texture);
        assert_int_equal(sampler, 0);
        if (!es)
            assert_int_equal(glIsEnabled(GL_TEXTURE_CUBE_MAP_SEAMLESS), seamless);
        assert_int_equal(glGetError(), GL_NO_ERROR);
    }
    if (!es)
        glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glDeleteTextures(1, &cube.texture);
    glDeleteTextures(1, &host.texture);
    glDeleteTextures(1, &flat.texture);
    free(picture);
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_image_is_that_of_the_reference),
        cmocka_unit_test(a_tenth_of_a_degree_or_a_pixel_is_caught),
        cmocka_unit_test(a_domemaster_on_its_own_rig_comes_out_as_it_is),
        cmocka_unit_test(a_domemaster_of_the_views_is_what_the_views_show),
        cmocka_unit_test(coarse_pixels_have_no_seam_behind_and_none_at_the_poles),
        cmocka_unit_test(fine_pictures_are_averaged_where_they_have_mipmaps),
        cmocka_unit_test(what_cannot_be_shown_is_refused),
        cmocka_unit_test(a_gl_for_pictures_has_no_views),
        cmocka_unit_test(the_host_keeps_its_cube_map),
    };
    return run_gpu_group("picture_sources", tests);
}
