/* The shader text of a pass over all views, and whether a GL can have such. */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "cupola/one_pass.h"
#include "error.h"
#include "guest.h"
#include "one_pass.h"
#include "shaders.h"

static bool has_viewports(bool es)
{
    if (es)
        return epoxy_has_gl_extension("GL_OES_viewport_array") ||
               epoxy_has_gl_extension("GL_NV_viewport_array");
    return epoxy_gl_version() >= 41 || epoxy_has_gl_extension("GL_ARB_viewport_array");
}

/* What lets a vertex shader choose a viewport; NULL: nothing does. */
static const char *vertex_extension(bool es)
{
    static const char *const names[] = {"GL_ARB_shader_viewport_layer_array",
                                        "GL_AMD_vertex_shader_viewport_index"};
    for (int i = 0; !es && i < 2; i++)
        if (epoxy_has_gl_extension(names[i]))
            return names[i];
    return NULL;
}

int pass_way_find(struct cupola_error *error)
{
    bool es = !epoxy_is_desktop_gl();
    if (!has_viewports(es))
        return error_set(error, CUPOLA_ERROR_GL,
                         "all views in one pass need several viewports (%s), which this GL has "
                         "not; allowed: view by view",
                         es ? "GL_OES_viewport_array or GL_NV_viewport_array"
                            : "OpenGL 4.1 or GL_ARB_viewport_array");
    if (vertex_extension(es))
        return CUPOLA_PASS_VERTEX;
    if (!es || epoxy_gl_version() >= 32)
        return CUPOLA_PASS_GEOMETRY;
    return error_set(error, CUPOLA_ERROR_GL,
                     "all views in one pass need a geometry shader (OpenGL ES 3.2), which this GL "
                     "has not; allowed: view by view");
}

int cupola_pass_way(struct cupola_error *error)
{
    int status = context_check(error);
    return status == CUPOLA_OK ? pass_way_find(error) : status;
}

/* A text that grows, or is only measured. */
struct writer {
    char *text; /* NULL: it is only measured */
    size_t size, length;
};

__attribute__((format(printf, 2, 3))) static void put(struct writer *writer, const char *format,
                                                      ...)
{
    va_list arguments;
    va_start(arguments, format);
    int count = vsnprintf(writer->text ? writer->text + writer->length : NULL,
                          writer->text ? writer->size - writer->length : 0, format, arguments);
    va_end(arguments);
    writer->length += count > 0 ? (size_t)count : 0;
}

/* A declaration without `out`: interpolation, type with precision, name. */
struct varying {
    const char *interpolation, *type, *name;
    int interpolation_length, type_length, name_length;
};

static int word_length(const char *text)
{
    return (int)strspn(text, "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_");
}

static bool is_interpolation(const char *word, int length)
{
    static const char *const words[] = {"flat", "smooth", "noperspective", "centroid", "sample"};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        if ((int)strlen(words[i]) == length && strncmp(word, words[i], (size_t)length) == 0)
            return true;
    return false;
}

/* False where it is no such declaration. */
static bool parse(const char *text, struct varying *varying)
{
    const char *at = text + strspn(text, " "), *last = NULL, *type = NULL;
    int length = 0, next;
    *varying = (struct varying){.interpolation = at};
    for (; (next = word_length(at)) > 0; at += next + (int)strspn(at + next, " ")) {
        if (last && !type && is_interpolation(last, length))
            varying->interpolation_length = (int)(last + length - varying->interpolation);
        else if (last && !type)
            type = last;
        if (type)
            varying->type_length = (int)(last + length - type);
        last = at;
        length = next;
    }
    varying->type = type;
    varying->name = last;
    varying->name_length = length;
    return !*at && type && !strchr("0123456789", last[0]) && strncmp(last, "gl_", 3) != 0 &&
           strncmp(last, "cupola_", 7) != 0;
}

static int check_varyings(const struct cupola_pass_shader *shader, struct cupola_error *error)
{
    if (shader->varying_count < 0 || shader->varying_count > CUPOLA_PASS_VARYINGS_MAX)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "varying_count is %d; allowed: 0 to %d",
                         shader->varying_count, CUPOLA_PASS_VARYINGS_MAX);
    if (shader->varying_count && !shader->varyings)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "varyings is NULL");
    struct varying unused;
    for (int i = 0; i < shader->varying_count; i++)
        if (!shader->varyings[i] || !parse(shader->varyings[i], &unused))
            return error_set(error, CUPOLA_ERROR_ARGUMENT,
                             "varying %d is '%.80s'; allowed: a type and a name as in 'flat vec3 "
                             "normal', no array, and no name that begins with gl_ or cupola_",
                             i, shader->varyings[i] ? shader->varyings[i] : "NULL");
    return CUPOLA_OK;
}

static int check_clip_distances(const struct cupola_pass_shader *shader, struct cupola_error *error)
{
    if (shader->clip_distances < 0 || shader->clip_distances > CUPOLA_PASS_CLIP_DISTANCES_MAX)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "clip_distances is %d; allowed: 0 to %d",
                         shader->clip_distances, CUPOLA_PASS_CLIP_DISTANCES_MAX);
    if (shader->clip_distances && !epoxy_is_desktop_gl() &&
        !epoxy_has_gl_extension("GL_EXT_clip_cull_distance"))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "clip_distances is %d; allowed in this OpenGL ES, which has no "
                         "GL_EXT_clip_cull_distance: 0",
                         shader->clip_distances);
    return CUPOLA_OK;
}

static int check_shader(const struct cupola_pass_shader *shader, enum cupola_pass_way way,
                        struct cupola_error *error)
{
    if (shader->stage != CUPOLA_PASS_STAGE_VERTEX && shader->stage != CUPOLA_PASS_STAGE_GEOMETRY)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "stage is %d; allowed: %d or %d",
                         (int)shader->stage, CUPOLA_PASS_STAGE_VERTEX, CUPOLA_PASS_STAGE_GEOMETRY);
    if (way == CUPOLA_PASS_VERTEX)
        return shader->stage == CUPOLA_PASS_STAGE_VERTEX
                   ? CUPOLA_OK
                   : error_set(error, CUPOLA_ERROR_ARGUMENT,
                               "no geometry shader is needed where the vertex shader chooses the "
                               "view; allowed: the vertex shader's stage");
    if (shader->primitive < CUPOLA_PASS_TRIANGLES || shader->primitive > CUPOLA_PASS_POINTS)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "primitive is %d; allowed: %d to %d",
                         (int)shader->primitive, CUPOLA_PASS_TRIANGLES, CUPOLA_PASS_POINTS);
    if (shader->primitive == CUPOLA_PASS_POINTS && !epoxy_is_desktop_gl())
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "primitive is points; allowed in OpenGL ES: triangles or lines");
    int status = check_clip_distances(shader, error);
    return status == CUPOLA_OK ? check_varyings(shader, error) : status;
}

static void put_vertex(struct writer *writer, const struct cupola_pass_shader *shader,
                       enum cupola_pass_way way)
{
    if (way == CUPOLA_PASS_VERTEX)
        put(writer, "#extension %s : require\n", vertex_extension(!epoxy_is_desktop_gl()));
    else
        put(writer, "#define CUPOLA_BY_GEOMETRY 1\n");
    put(writer, "%s", shader_pass_glsl);
    for (int i = 0; way == CUPOLA_PASS_GEOMETRY && i < shader->varying_count; i++) {
        struct varying v;
        parse(shader->varyings[i], &v);
        put(writer, "#define %.*s cupola_to_%.*s\n", v.name_length, v.name, v.name_length, v.name);
    }
    put(writer, "#line 2\n");
}

/* Interpolation stands before `in` and `out`, as older versions of the language want it. */
static void put_varyings(struct writer *writer, const struct cupola_pass_shader *shader)
{
    for (int i = 0; i < shader->varying_count; i++) {
        struct varying v;
        parse(shader->varyings[i], &v);
        put(writer, "%.*s in %.*s cupola_to_%.*s[];\n", v.interpolation_length, v.interpolation,
            v.type_length, v.type, v.name_length, v.name);
        put(writer, "%.*s out %.*s %.*s;\n", v.interpolation_length, v.interpolation, v.type_length,
            v.type, v.name_length, v.name);
    }
}

static void put_geometry(struct writer *writer, const struct cupola_pass_shader *shader)
{
    static const struct {
        const char *in, *out;
        int count;
    } layouts[] = {
        [CUPOLA_PASS_TRIANGLES] = {"triangles", "triangle_strip", 3},
        [CUPOLA_PASS_LINES] = {"lines", "line_strip", 2},
        [CUPOLA_PASS_POINTS] = {"points", "points", 1},
    };
    bool es = !epoxy_is_desktop_gl(), points = shader->primitive == CUPOLA_PASS_POINTS;
    int count = layouts[shader->primitive].count;
    if (es)
        put(writer, "#extension %s : require\n",
            epoxy_has_gl_extension("GL_OES_viewport_array") ? "GL_OES_viewport_array"
                                                            : "GL_NV_viewport_array");
    else
        put(writer, "#if __VERSION__ < 410\n#extension GL_ARB_viewport_array : require\n#endif\n");
    if (es && shader->clip_distances)
        put(writer, "#extension GL_EXT_clip_cull_distance : require\n");
    put(writer, "layout(%s) in;\nlayout(%s, max_vertices = %d) out;\n",
        layouts[shader->primitive].in, layouts[shader->primitive].out, count);
    put(writer, "flat in int cupola_vertex_view[];\n");
    put_varyings(writer, shader);
    put(writer, "void main()\n{\n    for (int i = 0; i < %d; i++) {\n", count);
    for (int i = 0; i < shader->varying_count; i++) {
        struct varying v;
        parse(shader->varyings[i], &v);
        put(writer, "        %.*s = cupola_to_%.*s[i];\n", v.name_length, v.name, v.name_length,
            v.name);
    }
    put(writer, "        gl_Position = gl_in[i].gl_Position;\n%s",
        points ? "        gl_PointSize = gl_in[i].gl_PointSize;\n" : "");
    /* By constant indices, which say how large the arrays are. */
    for (int i = 0; i < shader->clip_distances; i++)
        put(writer, "        gl_ClipDistance[%d] = gl_in[i].gl_ClipDistance[%d];\n", i, i);
    put(writer, "        gl_PrimitiveID = gl_PrimitiveIDIn;\n"
                "        gl_ViewportIndex = cupola_vertex_view[i];\n"
                "        EmitVertex();\n    }\n    EndPrimitive();\n}\n");
}

static void put_text(struct writer *writer, const struct cupola_pass_shader *shader,
                     enum cupola_pass_way way)
{
    if (shader->stage == CUPOLA_PASS_STAGE_VERTEX)
        put_vertex(writer, shader, way);
    else
        put_geometry(writer, shader);
}

int cupola_pass_glsl(const struct cupola_pass_shader *shader, char *text, size_t size,
                     struct cupola_error *error)
{
    const struct cupola_pass_shader plain = {CUPOLA_PASS_BEST};
    struct writer measured = {NULL, 0, 0}, written = {text, size, 0};
    shader = shader ? shader : &plain;
    if (!text)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "text is NULL");
    if (shader->way < CUPOLA_PASS_BEST || shader->way > CUPOLA_PASS_GEOMETRY)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "way is %d; allowed: %d to %d",
                         (int)shader->way, CUPOLA_PASS_BEST, CUPOLA_PASS_GEOMETRY);
    int best = cupola_pass_way(error);
    if (best < 0)
        return best;
    if (shader->way == CUPOLA_PASS_VERTEX && best != CUPOLA_PASS_VERTEX)
        return error_set(error, CUPOLA_ERROR_GL,
                         "no vertex shader of this GL chooses a viewport "
                         "(GL_ARB_shader_viewport_layer_array, "
                         "GL_AMD_vertex_shader_viewport_index); allowed: a geometry shader");
    enum cupola_pass_way way = shader->way ? shader->way : (enum cupola_pass_way)best;
    int status = check_shader(shader, way, error);
    if (status != CUPOLA_OK)
        return status;
    put_text(&measured, shader, way);
    if (measured.length >= size)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "size is %zu; allowed: %zu or more", size,
                         measured.length + 1);
    put_text(&written, shader, way);
    return (int)written.length;
}
