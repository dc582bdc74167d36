/* Blending of draw buffer 0, of all of them where the GL has no other. */
#include "host_blend.h"

void host_blend_set(const struct host_features *features, GLboolean on)
{
    if (!features->mask_per_buffer && on)
        glEnable(GL_BLEND);
    else if (!features->mask_per_buffer)
        glDisable(GL_BLEND);
    else if (on)
        glEnablei(GL_BLEND, 0);
    else
        glDisablei(GL_BLEND, 0);
}

void host_blend_equations_set(const struct host_features *features, GLenum rgb, GLenum alpha)
{
    if (features->blend_per_buffer)
        glBlendEquationSeparatei(0, rgb, alpha);
    else
        glBlendEquationSeparate(rgb, alpha);
}

/*
 * Advanced equations (GL_KHR_blend_equation_advanced) cannot be set for colour and alpha apart. No
 * function is called here for the first time: in a context that is lost by now libepoxy would not
 * find it.
 */
void host_blend_equations_restore(const struct host_features *features, const GLint equation[2])
{
    GLenum rgb = (GLenum)equation[0], alpha = (GLenum)equation[1];
    if (features->blend_per_buffer)
        glBlendEquationi(0, rgb);
    else
        glBlendEquation(rgb);
    if (alpha != rgb)
        host_blend_equations_set(features, rgb, alpha);
}

void host_blend_factors_set(const struct host_features *features, const GLint factors[4])
{
    GLenum f[4] = {(GLenum)factors[0], (GLenum)factors[1], (GLenum)factors[2], (GLenum)factors[3]};
    if (features->blend_per_buffer)
        glBlendFuncSeparatei(0, f[0], f[1], f[2], f[3]);
    else
        glBlendFuncSeparate(f[0], f[1], f[2], f[3]);
}

void host_set_adding(const struct host_features *features, bool adding)
{
    const GLint factors[4] = {GL_ONE, GL_ONE, GL_ZERO, GL_ONE};
    if (adding)
        host_blend_factors_set(features, factors);
    host_blend_set(features, adding);
}

void host_set_over(const struct host_features *features, bool linear)
{
    const GLint factors[4] = {GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA};
    host_blend_factors_set(features, factors);
    host_blend_set(features, GL_TRUE);
    if (linear && !features->srgb_always)
        glEnable(GL_FRAMEBUFFER_SRGB);
}
