/* Overlays land where they are put: against plain C, by their middles, as the viewer sees them. */
#include <stdio.h>

#include "overlay_canvas.h"

enum { SIDE = 200, FINE_SIDE = 600, RIGS = 12, PICKS = 8, TEXELS_X = 512, TEXELS_Y = 256 };

static const float ground[4] = {0.1f, 0.0f, 0.2f, 0.3f};

/* How far an image of bytes may be from one of floats. */
static const double bar = 2.0 / 255.0;

/* Random numbers, premultiplied, smooth enough for any filter's rounding. */
static float *waves(void)
{
    float *picture = malloc(4 * sizeof *picture * TEXELS_X * TEXELS_Y);
    assert_non_null(picture);
    for (int j = 0; j < TEXELS_Y; j++)
        for (int i = 0; i < TEXELS_X; i++) {
            float *texel = picture + 4 * (j * TEXELS_X + i);
            double alpha = 0.6 + 0.4 * cos(0.01 * i + 0.02 * j);
            for (int c = 0; c < 3; c++)
                texel[c] = (float)(alpha * (0.5 + 0.5 * sin(0.03 * i + 0.05 * c * j + c)));
            texel[3] = (float)alpha;
        }
    return picture;
}

static struct cupola_overlay random_overlay(uint64_t *seed, const cupola_dome *dome, int number,
                                            float color[4])
{
    struct cupola_overlay overlay = {.kind = (enum cupola_overlay_kind)(number % 3)};
    struct cupola_ray ray;
    double place[2], largest = number % 5 ? 0.5 : 2.6;
    random_sight(seed, dome, 1.0, place, &ray);
    memcpy(overlay.direction, ray.direction, sizeof overlay.direction);
    overlay.width_rad = random_between(seed, 0.05, largest);
    overlay.height_rad = number % 4 ? random_between(seed, 0.05, largest) : 0.0;
    overlay.roll_rad = random_between(seed, -6.0, 6.0);
    for (int c = 0; c < 4; c++)
        color[c] = (float)random_between(seed, 0.6, 1.0);
    overlay.color = number % 2 ? color : NULL;
    return overlay;
}

static double worst_difference(const float *a, const float *b, size_t count)
{
    double worst = 0.0;
    for (size_t i = 0; i < count; i++)
        worst = worse_of(worst, fabs((double)a[i] - (double)b[i]));
    return worst;
}

static float *reference_of(const struct fixture *fixture, const struct cupola_overlay *overlay,
                           const float *picture, const struct canvas *canvas)
{
    float *image = malloc(sizeof *image * canvas_values(canvas));
    assert_non_null(image);
    for (size_t i = 0; i < canvas_values(canvas); i++)
        image[i] = ground[i % 4];
    assert_int_equal(
        cupola_reference_overlay(fixture->dome, 0, overlay, picture, TEXELS_X, TEXELS_Y, image),
        CUPOLA_OK);
    return image;
}

static void the_image_is_that_of_the_reference(void **state)
{
    (void)state;
    uint64_t seed = 8201;
    double worst = 0.0;
    float *picture = waves();
    GLuint texture = overlay_texture(picture, TEXELS_X, TEXELS_Y);
    for (int number = 0; number < RIGS; number++) {
        struct cupola_rig rig = overlay_rig(&seed, number, SIDE);
        struct fixture fixture;
        make_for_overlays(&rig, CUPOLA_ENCODING_LINEAR, &fixture);
        struct canvas canvas = canvas_make(&fixture, 0);
        float color[4];
        struct cupola_overlay overlay = random_overlay(&seed, fixture.dome, number, color), wrong;
        overlay.texture = texture;
        canvas_fill(&canvas, ground);
        canvas_lay(&fixture, &canvas, &overlay, 1);
        float *shown = canvas_read(&canvas);
        float *expected = reference_of(&fixture, &overlay, picture, &canvas);
        worst = worse_of(worst, worst_difference(shown, expected, canvas_values(&canvas)));
        free(expected);
        wrong = overlay; /* the control: a tenth of a degree */
        wrong.direction[number % 3] += radians(0.1);
        wrong.direction[(number + 1) % 3] += radians(0.1);
        expected = reference_of(&fixture, &wrong, picture, &canvas);
        check_at_least(worst_difference(shown, expected, canvas_values(&canvas)), 2.0 * bar);
        free(expected);
        free(shown);
        canvas_release(&canvas);
        fixture_release(&fixture);
    }
    printf("at most %.2g\n", worst);
    check_at_most(worst, bar);
    glDeleteTextures(1, &texture);
    free(picture);
}

/* The middle of what was added to one channel of a black image. */
static double added(const float *image, const struct canvas *canvas, int channel, double middle[2])
{
    double sum = 0.0;
    middle[0] = middle[1] = 0.0;
    for (int j = 0; j < canvas->height_px; j++)
        for (int i = 0; i < canvas->width_px; i++) {
            double weight = (double)image[4 * (j * canvas->width_px + i) + channel];
            sum += weight;
            middle[0] += weight * (i + 0.5);
            middle[1] += weight * (j + 0.5);
        }
    for (int i = 0; i < 2; i++)
        middle[i] /= sum;
    return sum;
}

/* From the pixel under a mouse to its direction, to a cursor there, and back to the pixel. */
static void a_small_one_lands_on_the_pixel_that_was_picked(void **state)
{
    (void)state;
    static const float black[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    uint64_t seed = 8202;
    double worst = 0.0;
    for (int number = 0; number < RIGS / 2; number++) {
        struct cupola_rig rig = overlay_rig(&seed, number, FINE_SIDE);
        struct fixture fixture;
        make_for_overlays(&rig, CUPOLA_ENCODING_LINEAR, &fixture);
        struct canvas canvas = canvas_make(&fixture, 0);
        for (int i = 0; i < PICKS; i++) {
            struct cupola_overlay overlay = {.kind = i % 2 ? CUPOLA_OVERLAY_DISC
                                                           : CUPOLA_OVERLAY_CURSOR};
            struct cupola_ray ray;
            double mouse[2], back[2], middle[2];
            random_sight(&seed, fixture.dome, 12.0, mouse, &ray);
            memcpy(overlay.direction, ray.direction, sizeof overlay.direction);
            overlay.width_rad = 4.0 * sqrt(ray.solid_angle_sr);
            assert_int_equal(cupola_dome_pixel(fixture.dome, 0, NULL, overlay.direction, back), 1);
            canvas_fill(&canvas, black);
            canvas_lay(&fixture, &canvas, &overlay, 1);
            float *shown = canvas_read(&canvas);
            added(shown, &canvas, 0, middle);
            worst = worse_of(worst, hypot(middle[0] - back[0], middle[1] - back[1]));
            worst = worse_of(worst, hypot(middle[0] - mouse[0], middle[1] - mouse[1]));
            free(shown);
        }
        canvas_release(&canvas);
        fixture_release(&fixture);
    }
    printf("at most %.2g px from the pixel\n", worst);
    check_at_most(worst, 0.1);
}

/* Red and green above blue and alpha: what the viewer must see, by nothing but the rays. */
static float *quadrants(void)
{
    float *picture = calloc(4 * TEXELS_X * TEXELS_Y, sizeof *picture);
    assert_non_null(picture);
    for (int j = 0; j < TEXELS_Y; j++)
        for (int i = 0; i < TEXELS_X; i++) {
            bool right = i >= TEXELS_X / 2, up = j >= TEXELS_Y / 2;
            float *texel = picture + 4 * (j * TEXELS_X + i);
            texel[up ? (right ? 1 : 0) : (right ? 3 : 2)] = 1.0f;
        }
    return picture;
}

/* The quadrant that a ray meets as the viewer has it: -1 for none. Level and +Y upwards, rolled. */
static int seen_quadrant(const struct cupola_overlay *overlay, const double ray[3], bool mirrored)
{
    const double *n = overlay->direction;
    double level = hypot(n[0], n[2]), c = cos(overlay->roll_rad), s = sin(overlay->roll_rad);
    double right[3] = {-n[2] / level, 0.0, n[0] / level};
    double up[3] = {-n[0] * n[1] / level, level, -n[2] * n[1] / level};
    double far = 0.0, across = 0.0, above = 0.0;
    for (int i = 0; i < 3; i++) {
        far += n[i] * ray[i];
        across += right[i] * ray[i];
        above += up[i] * ray[i];
    }
    double x = (c * across + s * above) / (far * tan(0.5 * overlay->width_rad));
    double y = (c * above - s * across) / (far * tan(0.5 * overlay->height_rad));
    if (far <= 0.0 || fabs(x) > 1.0 || fabs(y) > 1.0)
        return -1;
    if (mirrored)
        x = -x;
    return y > 0.0 ? (x > 0.0 ? 1 : 0) : (x > 0.0 ? 3 : 2);
}

/* The image by 6 x 6 rays in each pixel, one after the other. */
static float *seen_image(const cupola_dome *dome, const struct cupola_overlay *overlay,
                         const struct canvas *canvas, bool mirrored)
{
    enum { RAYS = 4 };
    float *image = calloc(canvas_values(canvas), sizeof *image);
    assert_non_null(image);
    for (int j = 0; j < canvas->height_px; j++)
        for (int i = 0; i < canvas->width_px; i++)
            for (int k = 0; k < RAYS * RAYS; k++) {
                struct cupola_ray ray;
                cupola_dome_ray(dome, 0, NULL, i + 0.5, j + 0.5, &ray);
                if (angle_between(ray.direction, overlay->direction) > 0.6)
                    break; /* far beside, and many */
                cupola_dome_ray(dome, 0, NULL, i + (k % RAYS + 0.5) / RAYS,
                                j + ((int)(k / RAYS) + 0.5) / RAYS, &ray);
                int quadrant = seen_quadrant(overlay, ray.direction, mirrored);
                if (quadrant >= 0)
                    image[4 * (j * canvas->width_px + i) + quadrant] += 1.0f / (RAYS * RAYS);
            }
    return image;
}

static double worst_middle(const float *a, const float *b, const struct canvas *canvas)
{
    double worst = 0.0;
    for (int channel = 0; channel < 4; channel++) {
        double one[2], other[2];
        added(a, canvas, channel, one);
        added(b, canvas, channel, other);
        worst = worse_of(worst, hypot(one[0] - other[0], one[1] - other[1]));
    }
    return worst;
}

static void the_viewer_sees_a_picture_upright_and_not_mirrored(void **state)
{
    (void)state;
    static const float black[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    uint64_t seed = 8203;
    double worst = 0.0;
    float *picture = quadrants();
    GLuint texture = overlay_texture(picture, TEXELS_X, TEXELS_Y);
    for (int number = 0; number < 6; number++) {
        struct cupola_rig rig = overlay_rig(&seed, number, 120);
        struct cupola_overlay overlay = {.texture = texture,
                                         .mipmaps = true,
                                         .width_rad = 0.5,
                                         .height_rad = 0.35,
                                         .roll_rad = number % 2 ? 0.7 * number : 0.0};
        struct cupola_ray ray;
        struct fixture fixture;
        double place[2];
        make_for_overlays(&rig, CUPOLA_ENCODING_LINEAR, &fixture);
        struct canvas canvas = canvas_make(&fixture, 0);
        random_sight(&seed, fixture.dome, 25.0, place, &ray);
        memcpy(overlay.direction, ray.direction, sizeof overlay.direction);
        canvas_fill(&canvas, black);
        canvas_lay(&fixture, &canvas, &overlay, 1);
        float *shown = canvas_read(&canvas);
        float *seen = seen_image(fixture.dome, &overlay, &canvas, false);
        /* Over black, blending keeps the premultiplied colours of parts without alpha. */
        worst = worse_of(worst, worst_middle(shown, seen, &canvas));
        free(seen);
        seen = seen_image(fixture.dome, &overlay, &canvas, true); /* the control */
        check_at_least(worst_middle(shown, seen, &canvas), 3.0);
        free(seen);
        free(shown);
        canvas_release(&canvas);
        fixture_release(&fixture);
    }
    printf("quadrants at most %.2g px from where they are seen\n", worst);
    check_at_most(worst, 0.1);
    glDeleteTextures(1, &texture);
    free(picture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_image_is_that_of_the_reference),
        cmocka_unit_test(a_small_one_lands_on_the_pixel_that_was_picked),
        cmocka_unit_test(the_viewer_sees_a_picture_upright_and_not_mirrored),
    };
    return run_gpu_group("overlay_images", tests);
}
