/* GL programs from embedded shader files. */
#include "program.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "error.h"
#include "geometry/vector.h"
#include "geometry/views.h"
#include "guest.h"
#include "shaders.h"

enum { FILES_MAX = 10, LINES_PER_FILE = 1000 };

/*
 * Compilers say where an error is as "0:17(3)", "0(17)" or "0:17:", the line last, and not all keep
 * the number of the file that #line may give before it. So the lines of file i are numbered from
 * (i + 1) LINES_PER_FILE + 1, and each such number is put into words: "0:warp.frag:17(3)".
 */
static void name_lines(const char *log, const struct shader_file *files, int count, char *text,
                       size_t size)
{
    size_t length = 0;
    char before = '\n';
    while (*log && length + 1 < size) {
        char *end = NULL;
        long number = *log >= '0' && *log <= '9' ? strtol(log, &end, 10) : 0;
        bool place = number > LINES_PER_FILE && number < (count + 1L) * LINES_PER_FILE &&
                     (before == ':' || before == '(');
        size_t step = end ? (size_t)(end - log) : 1;
        int written =
            place ? snprintf(text + length, size - length, "%s:%ld",
                             files[number / LINES_PER_FILE - 1].name, number % LINES_PER_FILE)
                  : snprintf(text + length, size - length, "%.*s", (int)step, log);
        length += (size_t)written;
        before = log[step - 1];
        log += step;
    }
}

static void describe_failure(GLuint object, bool program, const struct shader_file *files,
                             int count, struct cupola_error *error)
{
    char log[512] = "", text[800] = "";
    if (program)
        glGetProgramInfoLog(object, sizeof log, NULL, log);
    else
        glGetShaderInfoLog(object, sizeof log, NULL, log);
    log[sizeof log - 1] = 0; /* whatever a lost context has written there */
    name_lines(log, files, count, text, sizeof text);
    for (char *c = text; *c; c++)
        if (*c == '\n')
            *c = ' ';
    error_set(error, CUPOLA_ERROR_GL, "the GL's compiler refused %s: %s", files[count - 1].name,
              text);
}

/* Full precision for all that is declared without one. */
static const char version_es[] = "#version 300 es\n"
                                 "precision highp float;\n"
                                 "precision highp int;\n"
                                 "precision highp sampler2D;\n"
                                 "precision highp sampler2DArray;\n"
                                 "precision highp samplerCube;\n";

static GLuint compile(GLenum kind, const char *defines, const struct shader_file *files, int count,
                      struct cupola_error *error)
{
    const char *texts[2 * FILES_MAX + 2] = {
        epoxy_is_desktop_gl() ? "#version 330 core\n" : version_es, defines};
    char lines[FILES_MAX][32];
    for (int i = 0; i < count; i++) {
        snprintf(lines[i], sizeof lines[i], "\n#line %d\n", (i + 1) * LINES_PER_FILE + 1);
        texts[2 * i + 2] = lines[i];
        texts[2 * i + 3] = files[i].text;
    }
    GLuint shader = glCreateShader(kind);
    GLint compiled = GL_FALSE;
    if (!shader) {
        gl_refused(glGetError(), error, "a shader for %s", files[count - 1].name);
        return 0;
    }
    glShaderSource(shader, 2 * count + 2, texts, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled)
        return shader;
    describe_failure(shader, false, files, count, error);
    glDeleteShader(shader);
    return 0;
}

GLuint program_create(const char *defines, const struct shader_file *files, int count,
                      struct cupola_error *error)
{
    static const struct shader_file triangle = {"fullscreen.vert", shader_fullscreen_vert};
    return program_create_by(&triangle, defines, files, count, error);
}

GLuint program_create_by(const struct shader_file *vertex_file, const char *defines,
                         const struct shader_file *files, int count, struct cupola_error *error)
{
    GLuint vertex = compile(GL_VERTEX_SHADER, defines, vertex_file, 1, error);
    if (!vertex)
        return 0;
    GLuint fragment = compile(GL_FRAGMENT_SHADER, defines, files, count, error);
    if (!fragment) {
        glDeleteShader(vertex);
        return 0;
    }
    GLuint program = glCreateProgram();
    GLint linked = GL_FALSE;
    if (!program) {
        gl_refused(glGetError(), error, "a program for %s", files[count - 1].name);
        glDeleteShader(vertex);
        glDeleteShader(fragment);
        return 0;
    }
    glAttachShader(program, vertex);
    glAttachShader(program, fragment);
    glLinkProgram(program);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked)
        return program;
    describe_failure(program, true, files, count, error);
    glDeleteProgram(program);
    return 0;
}

void program_defines(const cupola_dome *dome, int output, int view_count, int stage,
                     char defines[PROGRAM_DEFINES_MAX])
{
    snprintf(defines, PROGRAM_DEFINES_MAX,
             "#define LENS_ANGULAR %d\n#define LENS_HEMISPHERIC %d\n#define LENS_EQUISOLID %d\n"
             "#define LENS_STEREOGRAPHIC %d\n#define LENS_POLYNOMIAL %d\n#define LENS_TABLE %d\n"
             "#define LENS_KNOTS_MAX %d\n#define OUTPUTS_MAX %d\n"
             "#define STAGE_POINTS %d\n#define STAGE_NONE %d\n#define STAGE_ANGLES %d\n"
             "#define STAGE_SINES %d\n#define STAGE_COORDINATES %d\n"
             "#define LENS_MODEL %d\n#define VIEW_COUNT %d\n#define STAGE %d\n#define CAPPED %d\n",
             CUPOLA_LENS_ANGULAR, CUPOLA_LENS_HEMISPHERIC, CUPOLA_LENS_EQUISOLID,
             CUPOLA_LENS_STEREOGRAPHIC, CUPOLA_LENS_POLYNOMIAL, CUPOLA_LENS_TABLE, LENS_KNOTS_MAX,
             CUPOLA_OUTPUTS_MAX, CUPOLA_TABLE_POINTS, CUPOLA_TABLE_NONE, CUPOLA_TABLE_ANGLES,
             CUPOLA_TABLE_SINES, CUPOLA_TABLE_COORDINATES, (int)dome->projectors[output].lens.model,
             view_count, stage, dome->projectors[output].capped);
}

void program_set_vector(GLuint program, const char *name, const double *values, int count)
{
    GLfloat v[4] = {0};
    GLint location = glGetUniformLocation(program, name);
    for (int i = 0; i < count; i++)
        v[i] = (GLfloat)values[i];
    if (count == 1)
        glUniform1fv(location, 1, v);
    else if (count == 2)
        glUniform2fv(location, 1, v);
    else if (count == 3)
        glUniform3fv(location, 1, v);
    else
        glUniform4fv(location, 1, v);
}

void program_set_rotation(GLuint program, const char *name, const double rotation[9])
{
    GLfloat m[9];
    for (int i = 0; i < 9; i++)
        m[i] = (GLfloat)rotation[i];
    glUniformMatrix3fv(glGetUniformLocation(program, name), 1, GL_TRUE, m);
}

static void set_knots(GLuint program, const struct lens_table *table)
{
    glUniform1i(glGetUniformLocation(program, "lens_knot_count"), table->count);
    for (int i = 0; i < table->count; i++) {
        char name[32];
        const double knot[3] = {table->angle[i], table->radius[i], table->slope[i]};
        snprintf(name, sizeof name, "lens_knots[%d]", i);
        program_set_vector(program, name, knot, 3);
    }
}

static struct shader_value value_of(const char *type, const char *name, const double *numbers,
                                    int count)
{
    struct shader_value value = {type, name, {0}, count};
    memcpy(value.numbers, numbers, (size_t)count * sizeof *numbers);
    return value;
}

void program_projector_values(const cupola_dome *dome, int output,
                              struct shader_value values[PROJECTOR_VALUES])
{
    const struct projector *projector = &dome->projectors[output];
    const struct lens *lens = &projector->lens;
    const double size[2] = {projector->width_px, projector->height_px};
    const double *position_m = projector->position_m, radius_m = projector->screen_radius_m;
    const double room = radius_m * radius_m - dot3(position_m, position_m);
    const double cap_cosine = projector->capped ? projector->cap_cosine : -2;
    const struct shader_value all[PROJECTOR_VALUES] = {
        value_of("float", "lens_half_fov", &lens->half_fov, 1),
        value_of("float", "lens_scale", &lens->scale, 1),
        value_of("vec4", "lens_k", lens->k, 4),
        value_of("vec2", "output_size", size, 2),
        value_of("vec2", "circle_center", projector->center_px, 2),
        value_of("vec2", "circle_sign", projector->sign, 2),
        value_of("mat3", "aim", projector->aim, 9),
        value_of("vec3", "projector_position", position_m, 3),
        value_of("float", "screen_radius", &radius_m, 1),
        value_of("float", "screen_room", &room, 1),
        value_of("float", "cap_cosine", &cap_cosine, 1),
        value_of("mat3", "tilt", dome->tilt, 9),
    };
    memcpy(values, all, sizeof all);
}

void program_set_projector(GLuint program, const cupola_dome *dome, int output)
{
    const struct projector *projector = &dome->projectors[output];
    struct shader_value values[PROJECTOR_VALUES];
    program_projector_values(dome, output, values);
    for (int i = 0; i < PROJECTOR_VALUES; i++) {
        const struct shader_value *value = &values[i];
        if (value->count == 9)
            program_set_rotation(program, value->name, value->numbers);
        else
            program_set_vector(program, value->name, value->numbers, value->count);
    }
    program_set_vector(program, "circle_radius", &projector->radius_px, 1);
    if (projector->lens.model == CUPOLA_LENS_TABLE)
        set_knots(program, &projector->lens.table);
    program_place_eye(glGetUniformLocation(program, "eye"), dome);
}

void program_place_eye(GLint location, const cupola_dome *dome)
{
    const double *eye_m = dome->rig.eye_m;
    glUniform3f(location, (GLfloat)eye_m[0], (GLfloat)eye_m[1], (GLfloat)eye_m[2]);
}

void program_place_bases(GLint location, const cupola_plan *plan)
{
    GLfloat bases[4 * CUPOLA_VIEWS_MAX];
    for (int v = 0; v < plan->view_count; v++) {
        double base[4];
        view_base(&plan->views[v], base);
        for (int i = 0; i < 4; i++)
            bases[4 * v + i] = (GLfloat)base[i];
    }
    glUniform4fv(location, plan->view_count, bases);
}

void program_set_views(GLuint program, const cupola_plan *plan)
{
    for (int v = 0; v < plan->view_count; v++) {
        const struct cupola_view *view = &plan->views[v];
        double rect[4];
        char name[32];
        view_share(view, &plan->report, rect);
        snprintf(name, sizeof name, "view_selector[%d]", v);
        program_set_vector(program, name, view->selector, 3);
        snprintf(name, sizeof name, "view_rotation[%d]", v);
        program_set_rotation(program, name, view->rotation);
        snprintf(name, sizeof name, "view_rect[%d]", v);
        program_set_vector(program, name, rect, 4);
    }
    const double size[2] = {plan->report.atlas_width_px, plan->report.atlas_height_px};
    program_set_vector(program, "atlas_size", size, 2);
    program_place_bases(glGetUniformLocation(program, "view_base"), plan);
}
