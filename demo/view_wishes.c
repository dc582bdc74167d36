/* What a setup wishes of the views, in the library's terms. */
#include "view_wishes.h"

#include <math.h>

#include <epoxy/gl.h>

static enum cupola_format view_format(const struct show_setup *setup)
{
    if (setup->view_format >= 0)
        return (enum cupola_format)setup->view_format;
    return setup->floats ? CUPOLA_FORMAT_RGBA32F : CUPOLA_FORMAT_SRGB8;
}

bool view_wishes_colors(const struct show_setup *setup)
{
    return setup->source == CUPOLA_SOURCE_VIEWS ? view_format(setup) == CUPOLA_FORMAT_SRGB8
                                                : !setup->picture_of_numbers;
}

enum cupola_encoding view_wishes_encoding(const struct show_setup *setup)
{
    bool encoded = view_wishes_colors(setup) && !setup->reference;

    return encoded ? CUPOLA_ENCODING_SRGB : CUPOLA_ENCODING_LINEAR;
}

struct cupola_gl_params view_wishes_params(const struct show_setup *setup)
{
    struct cupola_filter filter = setup->filter;

    /* Of many frames the nearest texels make the sharpest mean; a picture's do not move. */
    if (setup->reference && setup->source == CUPOLA_SOURCE_VIEWS && !setup->aa_given)
        filter.method = CUPOLA_ANTIALIASING_NONE;
    return (struct cupola_gl_params){
        .format = view_format(setup),
        .depth = setup->mask == CUPOLA_MASK_STENCIL ? CUPOLA_DEPTH_32F_STENCIL_8 : CUPOLA_DEPTH_32F,
        .samples = setup->samples,
        .mask = setup->mask,
        .table = setup->table,
        .filter = filter,
        .dither_bits = setup->floats ? 0 : setup->dither_bits,
        .encoding = view_wishes_encoding(setup),
        .sources = 1u << (unsigned int)setup->source,
        .overlays = setup->overlays,
        .jitters = setup->reference,
        .one_pass = setup->one_pass && setup->source == CUPOLA_SOURCE_VIEWS,
    };
}

static float srgb_decoded(float encoded)
{
    return encoded <= 0.04045f ? encoded / 12.92f : powf((encoded + 0.055f) / 1.055f, 2.4f);
}

/* From 0 to 1 where the GL can: only so does reversed depth keep its precision. */
static bool set_clip_depth(bool zero_to_one)
{
    if (epoxy_gl_version() < 45 && !epoxy_has_gl_extension("GL_ARB_clip_control"))
        return false;
    glClipControl(GL_LOWER_LEFT, zero_to_one ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
    return zero_to_one;
}

struct cupola_frame view_wishes_frame(const struct show_setup *setup, const struct scene *scene,
                                      double near_distance, double far_distance)
{
    bool encoded = view_format(setup) == CUPOLA_FORMAT_SRGB8;
    struct cupola_frame frame = {
        .depth = {.near_distance = near_distance,
                  .far_distance = far_distance,
                  .infinite = setup->reversed_depth,
                  .reversed = setup->reversed_depth,
                  .zero_to_one = setup->reversed_depth && set_clip_depth(true)},
    };

    /* Scenes name their background as it is shown. */
    for (int i = 0; i < 4; i++)
        frame.clear_color[i] =
            encoded && i < 3 ? srgb_decoded(scene->clear_color[i]) : scene->clear_color[i];
    return frame;
}

void view_wishes_done(const struct show_setup *setup)
{
    if (setup->reversed_depth)
        set_clip_depth(false);
}
