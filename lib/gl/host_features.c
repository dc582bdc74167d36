/* What a context has, by its version or by an extension. */
#include "host_origin.h"

bool host_has(const struct host_features *features, struct origin origin)
{
    int since = features->es ? origin.es : origin.gl;
    const char *extension = features->es ? origin.es_extension : origin.gl_extension;
    return epoxy_gl_version() >= since || (extension && epoxy_has_gl_extension(extension));
}

/* Some extensions of OpenGL ES come from two makers and do the same. */
static bool has_either(const struct host_features *features, struct origin origin,
                       const char *es_extension)
{
    return host_has(features, origin) || (features->es && epoxy_has_gl_extension(es_extension));
}

static bool has_compatibility(void)
{
    GLint profile = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    return (profile & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) ||
           epoxy_has_gl_extension("GL_ARB_compatibility");
}

void host_features_find(struct host_features *features)
{
    const struct origin blending = {40, "GL_ARB_draw_buffers_blend", 32,
                                    "GL_OES_draw_buffers_indexed"};
    features->es = !epoxy_is_desktop_gl();
    features->compatibility = !features->es && has_compatibility();
    features->viewport_array = has_either(
        features, (struct origin){41, "GL_ARB_viewport_array", NEVER, "GL_OES_viewport_array"},
        "GL_NV_viewport_array");
    features->viewport_array_nv = features->es &&
                                  !epoxy_has_gl_extension("GL_OES_viewport_array") &&
                                  epoxy_has_gl_extension("GL_NV_viewport_array");
    features->clip_control = host_has(
        features, (struct origin){45, "GL_ARB_clip_control", NEVER, "GL_EXT_clip_control"});
    features->blend_per_buffer = has_either(features, blending, "GL_EXT_draw_buffers_indexed");
    features->mask_per_buffer = !features->es || features->blend_per_buffer;
    features->transform_feedback =
        host_has(features, (struct origin){40, "GL_ARB_transform_feedback2", 30, NULL});
    features->polygon_mode = host_has(features, (struct origin)DESKTOP("GL_NV_polygon_mode"));
    features->float_targets =
        host_has(features, (struct origin){33, NULL, 32, "GL_EXT_color_buffer_float"});
    features->half_float_targets =
        features->float_targets || epoxy_has_gl_extension("GL_EXT_color_buffer_half_float");
    features->float_filter =
        host_has(features, (struct origin)DESKTOP("GL_OES_texture_float_linear"));
    features->float_blend = host_has(features, (struct origin)DESKTOP("GL_EXT_float_blend"));
    features->srgb_always = features->es && !epoxy_has_gl_extension("GL_EXT_sRGB_write_control");
    features->texture_sizes = host_has(features, (struct origin){33, NULL, 31, NULL});
    features->texture_units = 2;
    features->texture_arrays = false;
    glGetIntegerv(GL_MAX_DRAW_BUFFERS, &features->draw_buffers);
    if (features->draw_buffers > HOST_DRAW_BUFFERS_MAX)
        features->draw_buffers = HOST_DRAW_BUFFERS_MAX;
    host_capabilities_find(features);
    host_debug_find(features);
}
