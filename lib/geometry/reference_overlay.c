/* Overlays in plain C, pixel by pixel; the shaders are compared with it. */
#include "bilinear.h"
#include "cupola/reference.h"
#include "overlay.h"
#include "vector.h"

struct picture {
    const float *texels; /* NULL: none */
    int width, height;
};

static const float *texel_at(const struct picture *picture, int x, int y)
{
    x = x < 0 ? 0 : x >= picture->width ? picture->width - 1 : x;
    y = y < 0 ? 0 : y >= picture->height ? picture->height - 1 : y;
    return picture->texels + 4 * ((size_t)y * (size_t)picture->width + (size_t)x);
}

static void sample_bilinear(const struct picture *picture, const double place[2], double color[4])
{
    double x = place[0] * picture->width - 0.5, y = place[1] * picture->height - 0.5;
    x = fmin(fmax(x, -1), picture->width);
    y = fmin(fmax(y, -1), picture->height);
    int i = (int)floor(x), j = (int)floor(y);
    const float *corners[4] = {texel_at(picture, i, j), texel_at(picture, i + 1, j),
                               texel_at(picture, i, j + 1), texel_at(picture, i + 1, j + 1)};
    bilinear_mix(corners, x - i, y - j, color);
}

static void draw_pixel(const cupola_dome *dome, int output, const struct overlay_frame *frame,
                       const struct cupola_overlay *overlay, const struct picture *picture, int i,
                       int j, float pixel[4])
{
    const struct projector *projector = &dome->projectors[output];
    double circle[2], place[2], light[4] = {1, 1, 1, 1};
    float color[4];
    struct varying lens, point, inside, ray, direction;
    circle_place(projector, i + 0.5, j + 0.5, circle);
    lens_ray(projector, circle, &lens);
    screen_point(projector, &lens, &point);
    double coverage = pixel_coverage(projector, i + 0.5, j + 0.5, &point);
    point_inside_rim(projector, i + 0.5, j + 0.5, &point, &inside);
    memcpy(inside.at, point.at, sizeof inside.at);
    eye_ray(dome, dome->rig.eye_m, &inside, &ray);
    overlay_direction(frame, &ray, &direction);
    coverage *= overlay_coverage(overlay->kind, &direction);
    if (!(coverage > 0))
        return;
    overlay_place(&direction, place);
    if (picture->texels)
        sample_bilinear(picture, place, light);
    overlay_color(overlay, color);
    double left = 1 - light[3] * (double)color[3] * coverage;
    for (int c = 0; c < 4; c++)
        pixel[c] = (float)(light[c] * (double)color[c] * coverage + left * (double)pixel[c]);
}

int cupola_reference_overlay(const cupola_dome *dome, int output,
                             const struct cupola_overlay *overlay, const float *picture, int width,
                             int height, float *image)
{
    enum { SIDE_MAX = 32768 };
    if (!dome || !overlay || !image || output < 0 || output >= dome->rig.output_count ||
        overlay_check(overlay, NULL) != CUPOLA_OK)
        return CUPOLA_ERROR_ARGUMENT;
    bool flat = overlay->kind == CUPOLA_OVERLAY_PICTURE;
    if (flat && (!picture || width < 1 || width > SIDE_MAX || height < 1 || height > SIDE_MAX))
        return CUPOLA_ERROR_ARGUMENT;
    if (flat && overlay_check_height(overlay, width, height, NULL) != CUPOLA_OK)
        return CUPOLA_ERROR_ARGUMENT;
    const struct cupola_output *size = &dome->rig.outputs[output];
    const struct picture shown = {flat ? picture : NULL, width, height};
    struct overlay_frame frame;
    overlay_frame_prepare(overlay, flat ? (double)width / height : 0, &frame);
    for (int j = 0; j < size->height_px; j++)
        for (int i = 0; i < size->width_px; i++)
            draw_pixel(dome, output, &frame, overlay, &shown, i, j,
                       image + 4 * ((size_t)j * (size_t)size->width_px + (size_t)i));
    return CUPOLA_OK;
}
