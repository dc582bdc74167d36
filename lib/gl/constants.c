/*
 * What does not change while a cupola_gl lives, as constants of its shaders: a software rasteriser
 * reads a uniform anew for every pixel.
 */
#include "constants.h"

#include <stdio.h>
#include <string.h>

#include "error.h"
#include "geometry/views.h"
#include "program.h"

/* A text that grows up to CONSTANTS_MAX. */
struct text {
    char *at;
    size_t length;
    bool cut;
};

static void add(struct text *text, const char *words)
{
    size_t left = CONSTANTS_MAX - text->length, length = strlen(words);
    text->cut = text->cut || length >= left;
    if (text->cut)
        return;
    memcpy(text->at + text->length, words, length + 1);
    text->length += length;
}

/* A number as GLSL has them, with a point whatever the host's locale has. */
static void add_number(struct text *text, double number)
{
    char digits[40], word[40];
    size_t length = 0;
    snprintf(digits, sizeof digits, "%.8e", number);
    for (const char *c = digits; *c; c++) {
        bool plain = (*c >= '0' && *c <= '9') || *c == '-' || *c == '+' || *c == 'e';
        if (plain || !length || word[length - 1] != '.')
            word[length++] = plain ? *c : '.';
    }
    word[length] = 0;
    add(text, word);
}

/* vec2, vec3, vec4, or mat3 of numbers row by row. */
static void add_value(struct text *text, const char *type, const double *values, int count)
{
    bool matrix = count == 9;
    add(text, type);
    for (int i = 0; i < count; i++) {
        add(text, i ? ", " : "(");
        add_number(text, values[matrix ? 3 * (i % 3) + i / 3 : i]);
    }
    add(text, ")");
}

static void add_constant(struct text *text, const char *type, const char *name,
                         const double *values, int count)
{
    add(text, "const ");
    add(text, type);
    add(text, " ");
    add(text, name);
    add(text, " = ");
    add_value(text, type, values, count);
    add(text, ";\n");
}

static void add_array(struct text *text, const char *type, const char *name, const double *values,
                      int count, int elements)
{
    char size[16];
    snprintf(size, sizeof size, "[%d]", elements);
    const char *const words[] = {"const ", type, " ", name, size, " = ", type, size};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        add(text, words[i]);
    for (int i = 0; i < elements; i++) {
        add(text, i ? ",\n    " : "(\n    ");
        add_value(text, type, values + count * i, count);
    }
    add(text, ");\n");
}

static void add_projector(struct text *text, const cupola_dome *dome, int output)
{
    struct shader_value values[PROJECTOR_VALUES];
    program_projector_values(dome, output, values);
    for (int i = 0; i < PROJECTOR_VALUES; i++)
        add_constant(text, values[i].type, values[i].name, values[i].numbers, values[i].count);
}

/* What follows the views' bases is left out where those may move. */
static void add_views(struct text *text, const cupola_plan *plan, bool resting)
{
    double selectors[3 * CUPOLA_VIEWS_MAX], rotations[9 * CUPOLA_VIEWS_MAX];
    const double size[2] = {plan->report.atlas_width_px, plan->report.atlas_height_px};
    double bases[4 * CUPOLA_VIEWS_MAX], rects[4 * CUPOLA_VIEWS_MAX], fits[4 * CUPOLA_VIEWS_MAX];
    for (int v = 0; v < plan->view_count; v++) {
        const struct cupola_view *view = &plan->views[v];
        double *base = bases + 4 * v, *rect = rects + 4 * v;
        view_base(view, base);
        view_share(view, &plan->report, rect);
        memcpy(selectors + 3 * v, view->selector, sizeof view->selector);
        memcpy(rotations + 9 * v, view->rotation, sizeof view->rotation);
        for (int i = 0; i < 2; i++) {
            fits[4 * v + 2 + i] = rect[2 + i] / base[2 + i];
            fits[4 * v + i] = rect[i] - base[i] * fits[4 * v + 2 + i];
        }
    }
    add_array(text, "vec3", "view_selector", selectors, 3, plan->view_count);
    add_array(text, "mat3", "view_rotation", rotations, 9, plan->view_count);
    add_array(text, "vec4", "view_rect", rects, 4, plan->view_count);
    add_constant(text, "vec2", "atlas_size", size, 2);
    if (!resting)
        return;
    add_array(text, "vec4", "view_base", bases, 4, plan->view_count);
    add_array(text, "vec4", "view_fit", fits, 4, plan->view_count);
}

int constants_write(const cupola_gl *gl, int output, char words[CONSTANTS_MAX],
                    struct cupola_error *error)
{
    const cupola_dome *dome = &gl->plan.dome;
    const double border[4] = {(double)gl->params.border[0], (double)gl->params.border[1],
                              (double)gl->params.border[2], (double)gl->params.border[3]};
    struct text text = {words, 0, false};
    bool resting = !(gl->plan.head_radius_m > 0) && !gl->params.jitters;
    add(&text, "#define RIG_BAKED\n");
    add_projector(&text, dome, output);
    add_constant(&text, "vec4", "border", border, 4);
    add_views(&text, &gl->plan, resting);
    if (resting) {
        add(&text, "#define EYE_BAKED\n");
        add_constant(&text, "vec3", "eye", dome->rig.eye_m, 3);
    }
    return text.cut ? error_set(error, CUPOLA_ERROR_GL,
                                "the constants of a shader are longer than %d characters",
                                (int)CONSTANTS_MAX - 1)
                    : CUPOLA_OK;
}
