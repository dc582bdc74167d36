/* The light of the scenes: from their colours as they are to many lamps on bumpy surfaces. */
#include "shading.h"

#include <math.h>

#include <epoxy/gl.h>

#include "demo_shaders.h"
#include "program.h"

/* (-0.48, 0.72, 0.50), unit length */
const float shading_sun[3] = {-0.4803845f, 0.7205767f, 0.5004005f};

/*
 * Lamp `index` of `count` on a spiral of equal areas from the top down. The first is warm and as
 * strong as half of all others together, so that there are shapes to see.
 */
static void set_lamp(const struct shading_lamps *lamps, int index, int count, float place[3],
                     float color[3])
{
    static const float tints[4][3] = {
        {1.00f, 0.85f, 0.65f}, {0.60f, 0.80f, 1.00f}, {0.95f, 0.95f, 0.90f}, {1.00f, 0.70f, 0.75f}};
    const double golden_angle = 2.399963229728653, pi = 3.14159265358979;
    double height = 1 - (1 - lamps->lowest) * (index + 0.5) / count;
    double across = sqrt(fmax(1 - height * height, 0)), turn = golden_angle * index + 2.3;
    double share = index == 0 ? 1.0 / 3 : 2.0 / 3 / (count - 1);
    double light = lamps->light > 0 ? lamps->light : 1;
    double power = 4.5 * pi * light * lamps->radius * lamps->radius * (count == 1 ? 1 : share);
    const double offset[3] = {across * cos(turn), height, across * sin(turn)};

    for (int k = 0; k < 3; k++) {
        place[k] = (float)(lamps->center[k] + lamps->radius * offset[k]);
        color[k] = (float)power * tints[index % 4][k];
    }
}

static void set_lamps(GLuint program, const struct shading_lamps *lamps, int count, bool smooth)
{
    float places[SCENE_LAMPS_MAX][3], colors[SCENE_LAMPS_MAX][3];

    if (count > SCENE_LAMPS_MAX)
        count = SCENE_LAMPS_MAX;
    for (int i = 0; i < count; i++)
        set_lamp(lamps, i, count, places[i], colors[i]);
    glUniform1i(glGetUniformLocation(program, "lamp_count"), count);
    if (count > 0) {
        glUniform3fv(glGetUniformLocation(program, "lamp_places"), count, places[0]);
        glUniform3fv(glGetUniformLocation(program, "lamp_colors"), count, colors[0]);
    }
    glUniform1f(glGetUniformLocation(program, "bump_size"), lamps->bump_size);
    glUniform1i(glGetUniformLocation(program, "octaves"), smooth ? 0 : 2);
    glUniform1f(glGetUniformLocation(program, "smoothest"),
                lamps->smoothest > 0 ? lamps->smoothest : 0.25f);
}

static bool create(int way, unsigned int *program, const struct program_source *source,
                   const struct shading_lamps *lamps, const struct scene_wishes *wishes,
                   char *message, size_t message_size)
{
    const char *const shaded[] = {shader_flat_glsl, source->functions, shader_heavy_glsl};
    struct program_source lit = *source;
    int count = wishes->lamps ? wishes->lamps : SCENE_LAMPS;

    lit.functions = shaded[wishes->shading];
    *program = program_create_of(way, &lit, message, message_size);
    if (!*program)
        return false;
    glUseProgram(*program);
    glUniform3fv(glGetUniformLocation(*program, "sun"), 1, shading_sun);
    if (wishes->shading == SCENE_HEAVY)
        set_lamps(*program, lamps, count < 0 ? 0 : count, wishes->smooth);
    glUseProgram(0);
    return true;
}

bool shading_programs_create(struct scene_programs *programs, const struct program_source *source,
                             const struct shading_lamps *lamps, const struct scene_wishes *wishes,
                             char *message, size_t message_size)
{
    *programs = (struct scene_programs){0, 0};
    if (create(0, &programs->one_view, source, lamps, wishes, message, message_size) &&
        (!wishes->way ||
         create(wishes->way, &programs->all_views, source, lamps, wishes, message, message_size)))
        return true;
    scene_programs_destroy(programs);
    *programs = (struct scene_programs){0, 0};
    return false;
}
