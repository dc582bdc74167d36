/*
 * Pictures as sources with every filter: each ray of a pixel goes through the picture by itself, as
 * it does here in plain C. The rays' places are those of geometry/filter.h, by the texels per pixel
 * of the picture, which are measured here; from a ray to a texel nothing is the library's.
 */
#include <stdio.h>
#include <stdlib.h>

#include "geometry/filter.h"
#include "geometry/source.h"
#include "geometry/vector.h"
#include "group.h"
#include "painted.h"
#include "picture_fixture.h"
#include "rig_random.h"
#include "worse.h"

enum { SIDE = 96, HEIGHT = 200 };

/* What llvmpipe's own rounding of places makes of noise. */
static const double bar = 0.004;

static const struct cupola_filter shown_filters[] = {
    {.method = CUPOLA_ANTIALIASING_CONE, .samples = 5},
    {.method = CUPOLA_ANTIALIASING_CONE, .samples = 11, .turned = true, .seed = 5},
    {.method = CUPOLA_ANTIALIASING_ADAPTIVE, .samples = 6},
    {.method = CUPOLA_ANTIALIASING_FOOTPRINT, .samples = 8},
};

enum { SHOWN_FILTERS = sizeof shown_filters / sizeof shown_filters[0] };

/* A picture of noise and its frame. */
struct scene {
    struct cupola_source source;
    struct source_frame frame;
    float *texels;
    int width, height;
};

/* Across and up in a face, texels; the face's axes by painted.h. */
static double face_place(const struct scene *scene, int face, const double direction[3],
                         double place[2])
{
    double middle[3], right[3], up[3], ahead = 0.0;
    face_direction(face, 0.5, 0.5, middle);
    face_direction(face, 1.0, 0.5, right);
    face_direction(face, 0.5, 1.0, up);
    place[0] = place[1] = 0.0;
    for (int i = 0; i < 3; i++) {
        ahead += middle[i] * direction[i];
        place[0] += (right[i] - middle[i]) * direction[i];
        place[1] += (up[i] - middle[i]) * direction[i];
    }
    for (int i = 0; i < 2; i++)
        place[i] = 0.5 * scene->width * (1.0 + place[i] / ahead);
    return ahead;
}

static int face_of(const struct scene *scene, const double direction[3])
{
    double most = 0.0, place[2];
    int found = 0;
    for (int face = 0; face < 6; face++) {
        double ahead = face_place(scene, face, direction, place);
        found = ahead > most ? face : found;
        most = fmax(most, ahead);
    }
    return found;
}

/* Texels; of a domemaster as if it had no rim. */
static void place_of(const struct scene *scene, int face, const double at[3], double place[2])
{
    double across = hypot(at[0], at[1]), level = hypot(at[0], at[2]);
    if (scene->source.kind == CUPOLA_SOURCE_CUBE) {
        face_place(scene, face, at, place);
    } else if (scene->source.kind == CUPOLA_SOURCE_DOMEMASTER) {
        double r = atan2(across, -at[2]) / scene->frame.half_fov;
        for (int i = 0; i < 2; i++)
            place[i] = 0.5 * scene->height * (1.0 + (across > 0.0 ? r * at[i] / across : 0.0));
    } else {
        place[0] = scene->width * (0.5 + atan2(at[0], -at[2]) / (2.0 * pi));
        place[1] = scene->height * (0.5 + atan2(at[1], level) / pi);
    }
}

/* By differences; across a picture of the sphere a texel is as wide as at the equator. */
static void measure_jacobian(const struct scene *scene, const struct varying *direction,
                             double jacobian[4])
{
    const double step = 1e-5, *changes[2] = {direction->dx, direction->dy};
    int face = face_of(scene, direction->at);
    for (int k = 0; k < 2; k++) {
        double ends[2][3], places[2][2];
        for (int end = 0; end < 2; end++) {
            for (int i = 0; i < 3; i++)
                ends[end][i] = direction->at[i] + (end ? 0.5 : -0.5) * step * changes[k][i];
            place_of(scene, face, ends[end], places[end]);
        }
        double across = places[1][0] - places[0][0], up = places[1][1] - places[0][1];
        if (scene->source.kind == CUPOLA_SOURCE_EQUIRECTANGULAR)
            across = remainder(across, scene->width) * hypot(direction->at[0], direction->at[2]) /
                     length3(direction->at);
        jacobian[k] = across / step;
        jacobian[2 + k] = up / step;
    }
}

static int within(int i, int count)
{
    return i < 0 ? 0 : i >= count ? count - 1 : i;
}

static const float *texel_of(const struct scene *scene, int face, int x, int y)
{
    int width = scene->width, height = scene->height;
    bool beyond_x = x < 0 || x >= width, beyond_y = y < 0 || y >= height;
    if (scene->source.kind == CUPOLA_SOURCE_EQUIRECTANGULAR)
        x = (x + width) % width;
    if (scene->source.kind == CUPOLA_SOURCE_CUBE && beyond_x != beyond_y) {
        /* Over the edge: half a texel down the neighbour, as far along it. */
        double edge[3], middle[3], place[2];
        face_direction(face, fmin(fmax((x + 0.5) / width, 0.0), 1.0),
                       fmin(fmax((y + 0.5) / height, 0.0), 1.0), edge);
        face_direction(face, 0.5, 0.5, middle);
        for (int i = 0; i < 3; i++)
            edge[i] -= middle[i] / width;
        face = face_of(scene, edge);
        face_place(scene, face, edge, place);
        x = (int)floor(place[0]);
        y = (int)floor(place[1]);
    }
    return scene->texels + 4 * ((face * height + within(y, height)) * width + within(x, width));
}

/* Bilinear. A domemaster's places stay 1.5 texels inside of its rim. */
static void add_ray(const struct scene *scene, const double direction[3], double weight,
                    double sum[4])
{
    double place[2];
    int face = scene->source.kind == CUPOLA_SOURCE_CUBE ? face_of(scene, direction) : 0;
    place_of(scene, face, direction, place);
    if (scene->source.kind == CUPOLA_SOURCE_DOMEMASTER) {
        double middle = 0.5 * scene->height, most = middle - 1.5;
        double r = hypot(place[0] - middle, place[1] - middle);
        for (int i = 0; i < 2 && r > most; i++)
            place[i] = middle + (place[i] - middle) * most / r;
    }
    double x = place[0] - 0.5, y = place[1] - 0.5;
    int i = (int)floor(x), j = (int)floor(y);
    for (int k = 0; k < 4; k++) {
        double part = (k % 2 ? x - i : 1.0 - x + i) * (k / 2 ? y - j : 1.0 - y + j);
        const float *texel = texel_of(scene, face, i + k % 2, j + k / 2);
        for (int c = 0; c < 4; c++)
            sum[c] += weight * part * (double)texel[c];
    }
}

/* The pixel's middle, its coverage, and the direction in the picture with its changes. */
static void prepare(const struct scene *scene, const cupola_dome *dome, int x, int y,
                    struct filter_pixel *pixel)
{
    const struct projector *projector = &dome->projectors[0];
    struct varying lens, point, inside, direction;
    double unused[2];
    *pixel = (struct filter_pixel){.x = x, .y = y, .projector = projector};
    circle_place(projector, x + 0.5, y + 0.5, pixel->place);
    lens_ray(projector, pixel->place, &lens);
    screen_point(projector, &lens, &point);
    pixel->coverage = pixel_coverage(projector, x + 0.5, y + 0.5, &point);
    point_inside_rim(projector, x + 0.5, y + 0.5, &point, &inside);
    memcpy(inside.at, point.at, sizeof inside.at);
    pixel->ray = inside;
    for (int i = 0; i < 3; i++)
        pixel->ray.at[i] -= dome->rig.eye_m[i];
    source_direction(&scene->frame, &inside, &direction);
    measure_jacobian(scene, &direction, pixel->jacobian);
    if (scene->source.kind == CUPOLA_SOURCE_DOMEMASTER)
        pixel->coverage = fmin(pixel->coverage,
                               domemaster_place(&scene->frame, &direction, scene->height, unused));
}

static void expect_pixel(const struct scene *scene, const cupola_dome *dome,
                         const struct cupola_filter *filter, int index, float color[4])
{
    struct filter_pixel pixel;
    struct pattern pattern;
    struct filter_place places[CUPOLA_RAYS_MAX];
    double sum[4] = {0.0};
    prepare(scene, dome, index % SIDE, index / SIDE, &pixel);
    memcpy(color, picture_border, 4 * sizeof *color);
    if (!(pixel.coverage > 0.0))
        return;
    int count = filter_pattern_count(filter, &pixel);
    if (count > 0)
        filter_pattern(filter, count, &pattern);
    count = filter_places(filter, &pattern, &pixel, places);
    for (int k = 0; k < count; k++) {
        double ray[3], direction[3];
        filter_direction(&pixel, &places[k], ray);
        for (int i = 0; i < 3; i++)
            ray[i] += dome->rig.eye_m[i] - scene->frame.center_m[i];
        transform3(scene->frame.rotation, ray, direction);
        add_ray(scene, direction, places[k].weight, sum);
    }
    for (int c = 0; c < 4; c++)
        color[c] += (float)(pixel.coverage * (sum[c] - (double)picture_border[c]));
}

static int pixels_unlike(const struct scene *scene, const cupola_dome *dome,
                         const struct cupola_filter *filter, const float *shown)
{
    int unlike = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        float expected[4];
        expect_pixel(scene, dome, filter, i, expected);
        unlike += !(picture_pixel_error(shown + 4 * i, expected) <= bar);
    }
    return unlike;
}

static struct cupola_rig shown_rig(void)
{
    struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 170.0, SIDE);
    rig.outputs[0].circle = (struct cupola_circle){46.0, 49.0, 44.0};
    rig.outputs[0].position_m[0] = 0.2;
    rig.screen.radius_m = 1.0;
    rig.screen.cap_rad = radians(80.0);
    rig.eye_m[1] = 0.3;
    rig.tilt_rad = 0.4;
    return rig;
}

static void scene_make(const cupola_dome *dome, int kind, struct scene *scene)
{
    *scene = (struct scene){.source = {.kind = (enum cupola_source_kind)kind,
                                       .fov_rad = radians(160.0),
                                       .orientation = {0.3, 0.2, 0.1}},
                            .height = HEIGHT};
    scene->width = painted_width(&scene->source, HEIGHT);
    scene->texels = picture_noise((size_t)painted_faces(&scene->source) * (size_t)scene->width *
                                  (size_t)HEIGHT);
    source_frame_prepare(dome, &scene->source, &scene->frame);
    picture_upload(&scene->source, scene->texels, HEIGHT);
}

static void set_gl(struct fixture *fixture, const struct cupola_filter *filter, int kind)
{
    struct cupola_gl_params params = {.sources = 1u << (unsigned int)kind, .filter = *filter};
    memcpy(params.border, picture_border, sizeof params.border);
    fixture_replace_gl(fixture, &params);
}

/* As in filter_reference.c; and where three faces of a cube meet, GLs may do as they like. */
static const int tolerated = 2 + SIDE * SIDE / 2000;

static void scene_release(struct scene *scene)
{
    glDeleteTextures(1, &scene->source.texture);
    free(scene->texels);
}

/* Another number of rays, and a picture that is turned by a tenth of a degree. */
static void check_controls(const struct scene *scene, const cupola_dome *dome, int number,
                           const float *shown)
{
    struct cupola_filter other = shown_filters[number];
    struct scene turned = *scene;
    other.samples = 3 - number / 2;
    check_at_least(pixels_unlike(scene, dome, &other, shown), 200);
    turned.source.orientation.yaw_rad += radians(0.1);
    source_frame_prepare(dome, &turned.source, &turned.frame);
    check_at_least(pixels_unlike(&turned, dome, &shown_filters[number], shown), 2000);
}

/* A check of a picture of each kind, with a GL side to be made. */
static void check_each_kind(void (*check)(struct fixture *, struct scene *))
{
    struct cupola_rig rig = shown_rig();
    struct fixture fixture;
    if (!context_has_floats())
        skip();
    picture_fixture_make(&rig, &fixture);
    for (int kind = CUPOLA_SOURCE_DOMEMASTER; kind <= CUPOLA_SOURCE_CUBE; kind++) {
        struct scene scene;
        scene_make(fixture.dome, kind, &scene);
        check(&fixture, &scene);
        scene_release(&scene);
    }
    fixture_release(&fixture);
}

static void check_filters(struct fixture *fixture, struct scene *scene)
{
    int kind = (int)scene->source.kind;
    for (int i = 0; i < SHOWN_FILTERS; i++) {
        set_gl(fixture, &shown_filters[i], kind);
        float *shown = picture_shown(fixture, &scene->source);
        int unlike = pixels_unlike(scene, fixture->dome, &shown_filters[i], shown);
        printf("%s, %s: %d pixels unlike\n", cupola_source_name(kind),
               cupola_antialiasing_name((int)shown_filters[i].method), unlike);
        check_at_most(unlike, tolerated);
        check_controls(scene, fixture->dome, i, shown);
        free(shown);
    }
}

static void every_ray_goes_through_the_picture(void **state)
{
    (void)state;
    check_each_kind(check_filters);
}

static void check_color(struct fixture *fixture, struct scene *scene)
{
    const struct cupola_filter *filter = &shown_filters[scene->source.kind];
    double worst = 0.0;
    for (int i = 0; i < 4 * painted_faces(&scene->source) * scene->width * HEIGHT; i++)
        scene->texels[i] = 0.75f;
    glDeleteTextures(1, &scene->source.texture);
    scene->source.mipmaps = true;
    picture_upload(&scene->source, scene->texels, HEIGHT);
    set_gl(fixture, filter, (int)scene->source.kind);
    float *shown = picture_shown(fixture, &scene->source);
    for (int i = 0; i < SIDE * SIDE; i++) {
        float expected[4];
        expect_pixel(scene, fixture->dome, filter, i, expected);
        worst = worse_of(worst, picture_pixel_error(shown + 4 * i, expected));
    }
    check_at_most(worst, 5e-4); /* what floats know of coverages */
    free(shown);
}

/* With mipmaps, of which each ray takes a level of its own; at rims mixed with the border once. */
static void a_picture_of_one_color_stays_that_color(void **state)
{
    (void)state;
    check_each_kind(check_color);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_ray_goes_through_the_picture),
        cmocka_unit_test(a_picture_of_one_color_stays_that_color),
    };
    return run_gpu_group("filter_pictures", tests);
}
