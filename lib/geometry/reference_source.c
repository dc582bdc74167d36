/* The warp of a picture in plain C, pixel by pixel; the shaders are compared with it. */
#include <math.h>
#include <string.h>

#include "bilinear.h"
#include "cupola/reference.h"
#include "source.h"
#include "vector.h"

/* The picture, or one face of it. */
struct picture {
    enum cupola_source_kind kind;
    const float *texels;
    int width, height;
};

static const float *texel_of_face(const struct picture *picture, int face, int x, int y)
{
    size_t width = (size_t)picture->width, height = (size_t)picture->height;
    return picture->texels + 4 * (((size_t)face * height + (size_t)y) * width + (size_t)x);
}

static int clamp_index(int i, int count)
{
    return i < 0 ? 0 : i >= count ? count - 1 : i;
}

/* The direction of a place on a face, components from -1 to 1; the way back from cube_place. */
static void cube_direction(int face, double u, double v, double direction[3])
{
    double s = 2 * u - 1, t = 2 * v - 1, sign = face % 2 ? -1 : 1;
    double faces[3][3] = {{sign, -t, -sign * s}, {s, sign, sign * t}, {sign * s, -t, sign}};
    memcpy(direction, faces[face / 2], sizeof faces[0]);
}

/*
 * A texel of a cube; one beyond an edge is the neighbouring face's nearest to it. At a corner,
 * where three faces meet and the GL may do as it likes, the face's own.
 */
static const float *texel_of_cube(const struct picture *picture, int face, int x, int y)
{
    int size = picture->width;
    bool beyond_x = x < 0 || x >= size, beyond_y = y < 0 || y >= size;
    if (beyond_x == beyond_y)
        return texel_of_face(picture, face, clamp_index(x, size), clamp_index(y, size));
    double direction[3], place[2];
    cube_direction(face, (x + 0.5) / size, (y + 0.5) / size, direction);
    for (int i = 0; i < 3; i++) {
        double reach = fabs(direction[i]);
        if (i == face / 2)
            direction[i] *= 1 - 1.0 / size; /* half a texel inside of the neighbour */
        else if (reach > 1)
            direction[i] /= reach;
    }
    face = cube_place(direction, place);
    return texel_of_face(picture, face, clamp_index((int)floor(place[0] * size), size),
                         clamp_index((int)floor(place[1] * size), size));
}

static const float *texel_at(const struct picture *picture, int face, int x, int y)
{
    if (picture->kind == CUPOLA_SOURCE_CUBE)
        return texel_of_cube(picture, face, x, y);
    if (picture->kind == CUPOLA_SOURCE_EQUIRECTANGULAR)
        x = (x % picture->width + picture->width) % picture->width;
    return texel_of_face(picture, 0, clamp_index(x, picture->width),
                         clamp_index(y, picture->height));
}

static void sample_bilinear(const struct picture *picture, int face, const double place[2],
                            double color[4])
{
    double x = place[0] * picture->width - 0.5, y = place[1] * picture->height - 0.5;
    int i = (int)floor(x), j = (int)floor(y);
    const float *corners[4] = {
        texel_at(picture, face, i, j),
        texel_at(picture, face, i + 1, j),
        texel_at(picture, face, i, j + 1),
        texel_at(picture, face, i + 1, j + 1),
    };
    bilinear_mix(corners, x - i, y - j, color);
}

static void show_pixel(const struct projector *projector, const struct source_frame *frame,
                       const struct picture *picture, const float border[4], double x_px,
                       double y_px, float color[4])
{
    double circle[2], place[2], sampled[4];
    struct varying lens, point, inside, direction;
    int face = 0, side = picture->width < picture->height ? picture->width : picture->height;
    circle_place(projector, x_px, y_px, circle);
    lens_ray(projector, circle, &lens);
    screen_point(projector, &lens, &point);
    double coverage = pixel_coverage(projector, x_px, y_px, &point);
    point_inside_rim(projector, x_px, y_px, &point, &inside);
    memcpy(inside.at, point.at, sizeof inside.at);
    source_direction(frame, &inside, &direction);
    if (picture->kind == CUPOLA_SOURCE_DOMEMASTER)
        coverage = fmin(coverage, domemaster_place(frame, &direction, side, place));
    else if (picture->kind == CUPOLA_SOURCE_EQUIRECTANGULAR)
        equirectangular_place(direction.at, place);
    else
        face = cube_place(direction.at, place);
    memcpy(color, border, 4 * sizeof *color);
    if (!(coverage > 0))
        return;
    sample_bilinear(picture, face, place, sampled);
    for (int c = 0; c < 4; c++)
        color[c] = (float)((double)border[c] + coverage * (sampled[c] - (double)border[c]));
}

int cupola_reference_source(const cupola_dome *dome, int output, const struct cupola_source *source,
                            const float *picture, int width, int height, const float border[4],
                            float *image)
{
    static const float black[4] = {0, 0, 0, 0};
    enum { SIDE_MAX = 32768 };
    if (!dome || !source || !picture || !image || output < 0 || output >= dome->rig.output_count ||
        source->kind == CUPOLA_SOURCE_VIEWS || source_check(source, NULL) != CUPOLA_OK ||
        width < 1 || width > SIDE_MAX || height < 1 || height > SIDE_MAX ||
        (source->kind == CUPOLA_SOURCE_CUBE && width != height))
        return CUPOLA_ERROR_ARGUMENT;
    const struct cupola_output *size = &dome->rig.outputs[output];
    const struct picture shown = {source->kind, picture, width, height};
    struct source_frame frame;
    source_frame_prepare(dome, source, &frame);
    for (int y = 0; y < size->height_px; y++)
        for (int x = 0; x < size->width_px; x++)
            show_pixel(&dome->projectors[output], &frame, &shown, border ? border : black, x + 0.5,
                       y + 0.5, image + 4 * ((size_t)y * (size_t)size->width_px + (size_t)x));
    return CUPOLA_OK;
}
