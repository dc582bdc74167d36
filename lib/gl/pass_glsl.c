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

static const char varying_types[] =
    " float vec2 vec3 vec4 int ivec2 ivec3 ivec4 uint uvec2 uvec3 uvec4 mat2 mat3 mat4 mat2x2 "
    "mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 ";
static const char double_types[] =
    " double dvec2 dvec3 dvec4 dmat2 dmat3 dmat4 dmat2x2 dmat2x3 dmat2x4 dmat3x2 dmat3x3 dmat3x4 "
    "dmat4x2 dmat4x3 dmat4x4 ";

/* Words of the language that are no names, besides types and qualifiers; some are reserved. */
static const char keywords[] =
    " main attribute const uniform varying buffer shared coherent volatile restrict readonly "
    "writeonly layout patch subroutine break continue do for while switch case default if else "
    "in out inout true false invariant precise discard return struct void bool bvec2 bvec3 bvec4 "
    "precision common partition active asm class union enum typedef template this resource goto "
    "inline noinline public static extern external interface long short half fixed unsigned "
    "superp input output hvec2 hvec3 hvec4 fvec2 fvec3 fvec4 filter sizeof cast namespace using "
    "atomic_uint sampler1D sampler2D sampler3D samplerCube sampler1DShadow sampler2DShadow "
    "samplerCubeShadow sampler1DArray sampler2DArray sampler1DArrayShadow sampler2DArrayShadow "
    "samplerCubeArray samplerCubeArrayShadow sampler2DRect sampler2DRectShadow samplerBuffer "
    "sampler2DMS sampler2DMSArray sampler3DRect ";

static int word_length(const char *text)
{
    return (int)strspn(text, "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_");
}

/* Of words between spaces. */
static bool has_word(const char *list, const char *word, int length)
{
    for (const char *at = list; *at; at += 1 + word_length(at + 1))
        if (length > 0 && word_length(at + 1) == length &&
            strncmp(at + 1, word, (size_t)length) == 0)
            return true;
    return false;
}

static bool is_name(const char *word, int length)
{
    static const char qualifiers[] =
        " flat smooth noperspective centroid sample highp mediump lowp ";
    return length > 0 && !strchr("0123456789", word[0]) && strncmp(word, "gl_", 3) != 0 &&
           strncmp(word, "cupola_", 7) != 0 && !has_word(keywords, word, length) &&
           !has_word(qualifiers, word, length) && !has_word(varying_types, word, length) &&
           !has_word(double_types, word, length);
}

/* The next word, and what is behind it and its spaces. */
static const char *take_word(const char **text, int *length)
{
    const char *word = *text;
    *length = word_length(word);
    *text = word + *length + strspn(word + *length, " ");
    return word;
}

/* One way to interpolate at most, and one place to do so. */
static void take_interpolation(const char **text, struct varying *varying)
{
    bool es = !epoxy_is_desktop_gl();
    bool plain = !es || epoxy_has_gl_extension("GL_NV_shader_noperspective_interpolation");
    bool sampled = epoxy_gl_version() >= (es ? 32 : 40);
    const char *ways = plain ? " flat smooth noperspective " : " flat smooth ";
    const char *places = sampled ? " centroid sample " : " centroid ";
    int way = 0, place = 0, length;
    varying->interpolation = *text;
    for (;;) {
        const char *rest = *text, *word = take_word(&rest, &length);
        way += has_word(ways, word, length);
        place += has_word(places, word, length);
        if (way > 1 || place > 1 ||
            !(has_word(ways, word, length) || has_word(places, word, length)))
            return;
        varying->interpolation_length = (int)(word + length - varying->interpolation);
        *text = rest;
    }
}

/* False where it is no such declaration. */
static bool parse(const char *text, struct varying *varying)
{
    const char *at = text + strspn(text, " ");
    int length;
    *varying = (struct varying){.interpolation_length = 0};
    take_interpolation(&at, varying);
    const char *word = varying->type = take_word(&at, &length);
    bool precise = has_word(" highp mediump lowp ", word, length);
    if (precise)
        word = take_word(&at, &length);
    varying->type_length = (int)(word + length - varying->type);
    bool doubles = has_word(double_types, word, length);
    if (!doubles && !has_word(varying_types, word, length))
        return false;
    if (doubles && (precise || !epoxy_is_desktop_gl() || epoxy_gl_version() < 40))
        return false;
    varying->name = take_word(&at, &varying->name_length);
    return !*at && is_name(varying->name, varying->name_length);
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
