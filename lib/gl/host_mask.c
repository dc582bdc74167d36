/* Saving and restoring of what laying a mask changes. */
#include "host_mask.h"

enum { MASKED_BIT = 128, ALL_BITS = 255 };

static const struct {
    GLenum face, function, reference, value_mask, write_mask, fail, depth_fail, pass;
} faces[2] = {
    {GL_FRONT, GL_STENCIL_FUNC, GL_STENCIL_REF, GL_STENCIL_VALUE_MASK, GL_STENCIL_WRITEMASK,
     GL_STENCIL_FAIL, GL_STENCIL_PASS_DEPTH_FAIL, GL_STENCIL_PASS_DEPTH_PASS},
    {GL_BACK, GL_STENCIL_BACK_FUNC, GL_STENCIL_BACK_REF, GL_STENCIL_BACK_VALUE_MASK,
     GL_STENCIL_BACK_WRITEMASK, GL_STENCIL_BACK_FAIL, GL_STENCIL_BACK_PASS_DEPTH_FAIL,
     GL_STENCIL_BACK_PASS_DEPTH_PASS},
};

/* Of draw buffer 0: no other is written to anyway, or all have one mask. */
static void write_color(const struct host_features *features, GLboolean written)
{
    if (features->mask_per_buffer)
        glColorMaski(0, written, written, written, written);
    else
        glColorMask(written, written, written, written);
}

/* Of viewport 0 alone, as set_viewport of host_state.c. */
static void set_depth_range(const struct host_features *features, const GLdouble range[2])
{
    if (features->viewport_array && !features->es)
        glDepthRangeIndexed(0, range[0], range[1]);
    else if (features->viewport_array && features->viewport_array_nv)
        glDepthRangeIndexedfNV(0, (GLfloat)range[0], (GLfloat)range[1]);
    else if (features->viewport_array)
        glDepthRangeIndexedfOES(0, (GLfloat)range[0], (GLfloat)range[1]);
    else if (features->es)
        glDepthRangef((GLfloat)range[0], (GLfloat)range[1]);
    else
        glDepthRange(range[0], range[1]);
}

static void save_depth(struct host_mask *mask, const struct host_features *features)
{
    GLfloat range[2];
    glGetIntegerv(GL_DEPTH_FUNC, &mask->depth_function);
    if (!features->es) {
        glGetDoublev(GL_DEPTH_RANGE, mask->depth_range);
        return;
    }
    glGetFloatv(GL_DEPTH_RANGE, range);
    for (int i = 0; i < 2; i++)
        mask->depth_range[i] = (GLdouble)range[i];
}

static void save_stencil(struct host_mask *mask)
{
    for (int i = 0; i < 2; i++) {
        struct host_stencil *face = &mask->faces[i];
        glGetIntegerv(faces[i].function, &face->function);
        glGetIntegerv(faces[i].reference, &face->reference);
        glGetInteger64v(faces[i].value_mask, &face->value_mask);
        glGetInteger64v(faces[i].write_mask, &face->write_mask);
        glGetIntegerv(faces[i].fail, &face->fail);
        glGetIntegerv(faces[i].depth_fail, &face->depth_fail);
        glGetIntegerv(faces[i].pass, &face->pass);
    }
}

void host_mask_begin(struct host_mask *mask, const struct host_features *features, bool stencil,
                     bool kept)
{
    const GLdouble all[2] = {0, 1};
    mask->kept = kept;
    mask->stencil = stencil;
    write_color(features, GL_FALSE);
    if (stencil) {
        if (kept)
            save_stencil(mask);
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_ALWAYS, MASKED_BIT, ALL_BITS);
        glStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
        glStencilMask(~0u);
        return;
    }
    if (kept)
        save_depth(mask, features);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    set_depth_range(features, all);
}

static void restore_stencil(const struct host_mask *mask)
{
    for (int i = 0; i < 2; i++) {
        const struct host_stencil *face = &mask->faces[i];
        GLenum side = faces[i].face;
        glStencilFuncSeparate(side, (GLenum)face->function, face->reference,
                              (GLuint)face->value_mask);
        glStencilOpSeparate(side, (GLenum)face->fail, (GLenum)face->depth_fail, (GLenum)face->pass);
        glStencilMaskSeparate(side, (GLuint)face->write_mask);
    }
}

void host_mask_end(const struct host_mask *mask, const struct host_features *features)
{
    write_color(features, GL_TRUE);
    if (mask->stencil)
        glDisable(GL_STENCIL_TEST);
    else
        glDisable(GL_DEPTH_TEST);
    if (!mask->kept)
        return;
    if (mask->stencil) {
        restore_stencil(mask);
        return;
    }
    glDepthFunc((GLenum)mask->depth_function);
    set_depth_range(features, mask->depth_range);
}
