/*
 * Frames whose samples lie beside the middles of texels and pixels. The base rectangles of the plan
 * are moved by a part of a texel, and all that looks at them follows as it does an eye that moves;
 * rays are moved where a warp begins.
 */
#include <math.h>
#include <string.h>

#include "cupola/jitter.h"
#include "error.h"
#include "instance.h"

static const double most = 0.5;

/* Texels that filters reach stay within the guard band. */
enum { GUARD_LEAST_PX = 2 };

void jitter_lift(cupola_gl *gl)
{
    if (!gl->jitter.laid)
        return;
    for (int v = 0; v < gl->plan.view_count; v++) {
        struct cupola_view *view = &gl->plan.views[v];
        const double *base = gl->jitter.bases[v];
        view->left = base[0];
        view->right = base[1];
        view->bottom = base[2];
        view->top = base[3];
    }
    gl->jitter.laid = false;
}

void jitter_lay(cupola_gl *gl)
{
    const double *texels = gl->jitter.texels;
    if (texels[0] == 0 && texels[1] == 0)
        return;
    for (int v = 0; v < gl->plan.view_count; v++) {
        struct cupola_view *view = &gl->plan.views[v];
        const double base[4] = {view->left, view->right, view->bottom, view->top};
        double right = texels[0] * (base[1] - base[0]) / view->rect.width;
        double up = texels[1] * (base[3] - base[2]) / view->rect.height;
        memcpy(gl->jitter.bases[v], base, sizeof base);
        view->left += right;
        view->right += right;
        view->bottom += up;
        view->top += up;
    }
    gl->jitter.laid = true;
}

static int check_number(const char *name, int index, double value, struct cupola_error *error)
{
    if (fabs(value) <= most)
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s[%d] is %g; allowed: %g to %g", name, index,
                     value, -most, most);
}

static int check(const cupola_gl *gl, const double texels[2], const double pixels[2],
                 struct cupola_error *error)
{
    if (!gl->params.jitters)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "gl was made without jitters; allowed: one that was made with them");
    if (open_kind(gl))
        return error_set(error, CUPOLA_ERROR_ORDER, "set_jitter inside of a %s; end it first",
                         open_kind(gl));
    for (int i = 0; i < 2; i++) {
        int status = check_number("texels", i, texels[i], error);
        if (status == CUPOLA_OK)
            status = check_number("pixels", i, pixels[i], error);
        if (status != CUPOLA_OK)
            return status;
    }
    if (gl->params.storage != CUPOLA_STORAGE_ATLAS && (texels[0] != 0 || texels[1] != 0))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "texels are (%g, %g), and the views are textures of the host's, of which "
                         "Cupola knows no texels; allowed: 0",
                         texels[0], texels[1]);
    return CUPOLA_OK;
}

static int set_jitter(cupola_gl *gl, const double texels[2], const double pixels[2],
                      struct cupola_error *error)
{
    static const double none[2] = {0, 0};
    if (!gl)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "gl is NULL");
    if (guest_check_seen(&gl->guest, error) != CUPOLA_OK)
        return CUPOLA_ERROR_LOST;
    texels = texels ? texels : none;
    pixels = pixels ? pixels : none;
    int status = check(gl, texels, pixels, error);
    if (status != CUPOLA_OK)
        return status;
    memcpy(gl->jitter.pixels, pixels, sizeof gl->jitter.pixels);
    if (texels[0] == gl->jitter.texels[0] && texels[1] == gl->jitter.texels[1])
        return CUPOLA_OK;
    jitter_lift(gl);
    memcpy(gl->jitter.texels, texels, sizeof gl->jitter.texels);
    jitter_lay(gl);
    gl->moves++;
    return CUPOLA_OK;
}

int cupola_gl_set_jitter(cupola_gl *gl, const double texels[2], const double pixels[2],
                         struct cupola_error *error)
{
    struct cupola_error unwanted;
    error = error ? error : &unwanted;
    return call_ended(gl, __func__, set_jitter(gl, texels, pixels, error), error);
}

int jitter_check_params(const struct cupola_gl_params *params, int guard_px,
                        struct cupola_error *error)
{
    bool views = !params->sources || params->sources & 1u << CUPOLA_SOURCE_VIEWS;
    if (!params->jitters || !views)
        return CUPOLA_OK;
    if (params->table != CUPOLA_TABLE_NONE && params->table != CUPOLA_TABLE_TILES &&
        params->table != CUPOLA_TABLE_AUTO)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "jitters is true and the table stage %s, which is of the middles of "
                         "pixels; allowed: none, tiles, auto",
                         cupola_table_name((int)params->table));
    if (guard_px < GUARD_LEAST_PX)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "jitters is true and the plan's guard band is %d; allowed: %d or more",
                         guard_px, GUARD_LEAST_PX);
    return CUPOLA_OK;
}

/* Half a pixel each way, and some more. */
double jitter_reach_px(const cupola_gl *gl)
{
    return gl->params.jitters ? 0.75 : 0;
}
