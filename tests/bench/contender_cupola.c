/* Cupola as a host uses it, and the same views under a warp that computes nothing. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <epoxy/gl.h>

#include "bench_shaders.h"
#include "contender.h"
#include "footprint.h"
#include "program.h"
#include "scene_views.h"
#include "shaded.h"

struct cupola_frames {
    const struct setting *setting;
    struct cupola_plan_report report;
    cupola_gl *gl;
    double shaded, bytes, tables; /* see contender_facts */
    double eye_m[3], step_m;      /* of a viewer who moves: to and fro */
    GLuint program;               /* of the control */
    GLuint vertex_array;
};

static void frames_release(void *self)
{
    struct cupola_frames *frames = self;

    if (!frames)
        return;
    cupola_gl_destroy(&frames->gl);
    glDeleteProgram(frames->program);
    glDeleteVertexArrays(1, &frames->vertex_array);
    free(frames);
}

/* The plan that was made last: stages side by side have the same. */
static struct {
    struct cupola_rig rig;
    struct cupola_plan_params params;
    cupola_plan *plan;
} last;

static const cupola_plan *plan_of(const cupola_dome *dome, const struct cupola_plan_params *params,
                                  struct cupola_error *error)
{
    const struct cupola_rig *rig = cupola_dome_rig(dome);

    if (last.plan && memcmp(&last.rig, rig, sizeof *rig) == 0 &&
        memcmp(&last.params, params, sizeof *params) == 0)
        return last.plan;
    cupola_plan_destroy(&last.plan);
    last.rig = *rig;
    last.params = *params;
    return cupola_plan_create(dome, params, &last.plan, error) < 0 ? NULL : last.plan;
}

/* What the GL has of it, beyond what there was. */
static bool take_facts(struct cupola_frames *frames, const struct footprint *before, char *message)
{
    struct footprint now = footprint_now();
    double atlas = footprint_texture(cupola_gl_atlas(frames->gl));

    frames->bytes = now.depth - before->depth + atlas;
    frames->tables = now.color - before->color - atlas + now.buffers - before->buffers;
    frames->shaded = shaded_texels(frames->gl, message);
    return frames->shaded >= 0;
}

static struct cupola_frames *prepare(const struct setting *setting,
                                     const struct cupola_plan_params *wishes,
                                     const struct cupola_gl_params *params, char *message)
{
    struct cupola_error error = {0};
    struct cupola_plan_params plan = *wishes;
    struct cupola_frames *frames = calloc(1, sizeof *frames);
    GLint largest = 0;

    if (!frames) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return NULL;
    }
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    plan.max_texture_px = largest > 16384 ? 16384 : largest;
    frames->setting = setting;
    const cupola_plan *made = plan_of(setting->dome, &plan, &error);
    struct footprint before = footprint_now();
    if (!made || cupola_gl_create(made, params, &frames->gl, &error) < 0) {
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
    } else if (take_facts(frames, &before, message)) {
        frames->report = *cupola_plan_report(made);
        return frames;
    }
    frames_release(frames);
    return NULL;
}

static void *variant_prepare(const struct setting *setting, int variant,
                             const struct cupola_gl_params *params, char *message)
{
    struct cupola_plan_params plan = {.unmasked = variant == CUPOLA_UNMASKED};

    if (variant == CUPOLA_SAVES_VERTICES)
        plan.goal = CUPOLA_GOAL_VERTICES;
    if (variant > 0) {
        plan.views = variant;
        plan.layout = CUPOLA_LAYOUT_ROTATED;
    }
    return prepare(setting, &plan, params, message);
}

static void *views_prepare(const struct setting *setting, int variant, char *message)
{
    return variant_prepare(setting, variant, &setting->gl, message);
}

static void *pass_prepare(const struct setting *setting, int variant, char *message)
{
    struct cupola_gl_params params = setting->gl;

    params.one_pass = true;
    return variant_prepare(setting, variant, &params, message);
}

static void *stage_prepare(const struct setting *setting, int variant, char *message)
{
    struct cupola_gl_params params = setting->gl;

    params.table = (enum cupola_table)variant;
    return prepare(setting, &(struct cupola_plan_params){0}, &params, message);
}

enum { SAMPLES_UNIT = 16 }; /* of a variant; the rest is the method */

int contender_filters(int samples, struct contender contenders[FILTER_CONTENDERS])
{
    static const struct contender all[FILTER_CONTENDERS] = {
        {"aa-none", &contender_filter, CUPOLA_ANTIALIASING_NONE},
        {"aa-texture", &contender_filter, CUPOLA_ANTIALIASING_TEXTURE},
        {"aa-texture-9", &contender_filter, CUPOLA_ANTIALIASING_TEXTURE + 9 * SAMPLES_UNIT},
        {"aa-cone", &contender_filter, CUPOLA_ANTIALIASING_CONE},
        {"aa-adaptive", &contender_filter, CUPOLA_ANTIALIASING_ADAPTIVE},
        {"aa-footprint", &contender_filter, CUPOLA_ANTIALIASING_FOOTPRINT},
    };

    memcpy(contenders, all, sizeof all);
    for (int i = 0; i < FILTER_CONTENDERS; i++)
        if (all[i].variant >= CUPOLA_ANTIALIASING_CONE && all[i].variant < SAMPLES_UNIT)
            contenders[i].variant += samples * SAMPLES_UNIT;
    return FILTER_CONTENDERS;
}

bool contender_filter_found(const char *name)
{
    struct contender all[FILTER_CONTENDERS];

    contender_filters(0, all);
    for (int i = 0; i < FILTER_CONTENDERS; i++)
        if (strcmp(name, all[i].name) == 0)
            return true;
    return false;
}

static void *filter_prepare(const struct setting *setting, int variant, char *message)
{
    struct cupola_gl_params params = setting->gl;

    params.filter.method = (enum cupola_antialiasing)(variant % SAMPLES_UNIT);
    params.filter.samples = variant / SAMPLES_UNIT;
    return prepare(setting, &(struct cupola_plan_params){0}, &params, message);
}

static void *listed_prepare(const struct setting *setting, int variant, char *message)
{
    struct cupola_gl_params params = setting->gl;

    params.filter = setting->filters[variant];
    return prepare(setting, &(struct cupola_plan_params){.density = setting->density}, &params,
                   message);
}

static void *head_prepare(const struct setting *setting, int variant, char *message)
{
    const struct cupola_rig *rig = cupola_dome_rig(setting->dome);
    struct cupola_plan_params plan = {.head_radius_m = 0.1 * rig->screen.radius_m};
    struct cupola_gl_params params = setting->gl;

    params.table = (enum cupola_table)variant;
    struct cupola_frames *frames = prepare(setting, &plan, &params, message);
    if (!frames)
        return NULL;
    for (int i = 0; i < 3; i++)
        frames->eye_m[i] = rig->eye_m[i];
    frames->step_m = 1e-5 * rig->screen.radius_m;
    return frames;
}

static void *control_prepare(const struct setting *setting, int variant, char *message)
{
    struct cupola_frames *frames = views_prepare(setting, variant, message);

    if (!frames)
        return NULL;
    frames->program =
        program_create("control", shader_whole_vert, shader_blit_frag, message, MESSAGE_SIZE);
    if (!frames->program) {
        frames_release(frames);
        return NULL;
    }
    glGenVertexArrays(1, &frames->vertex_array);
    return frames;
}

static bool visit_views(struct cupola_frames *frames, bool drawn)
{
    struct scene *scene = frames->setting->scene;
    struct cupola_frame begin = {.depth = frames->setting->depth};
    struct cupola_gl_view view;
    int views;

    for (int i = 0; i < 4; i++)
        begin.clear_color[i] = scene->clear_color[i];
    views = cupola_gl_frame_begin(frames->gl, &begin, NULL);
    for (int i = 0; i < views; i++) {
        if (cupola_gl_view_begin(frames->gl, i, &view, NULL) < 0)
            return false;
        if (drawn)
            scene->draw(scene, &(struct scene_camera){&view.camera, frames->setting->host, false});
        if (cupola_gl_view_end(frames->gl, NULL) < 0)
            return false;
    }
    return views > 0;
}

static bool pass_views(void *self)
{
    struct cupola_frames *frames = self;
    struct scene *scene = frames->setting->scene;
    struct cupola_frame begin = {.depth = frames->setting->depth};
    struct cupola_gl_pass pass;

    for (int i = 0; i < 4; i++)
        begin.clear_color[i] = scene->clear_color[i];
    if (cupola_gl_frame_begin(frames->gl, &begin, NULL) < 0 ||
        cupola_gl_pass_begin(frames->gl, frames->setting->host, &pass, NULL) < 0)
        return false;
    glBindBufferBase(GL_UNIFORM_BUFFER, SCENE_PASS_BINDING, pass.buffer);
    scene->draw(scene, &(struct scene_camera){.host = frames->setting->host, .pass = &pass});
    return cupola_gl_pass_end(frames->gl, NULL) >= 0;
}

static bool frames_views(void *self)
{
    return visit_views(self, true);
}

/* The views are drawn once, and then only warped. */
static void *warp_prepare(const struct setting *setting, int variant, char *message)
{
    struct cupola_frames *frames = views_prepare(setting, variant, message);

    if (!frames || visit_views(frames, true))
        return frames;
    snprintf(message, MESSAGE_SIZE, "the views cannot be drawn");
    frames_release(frames);
    return NULL;
}

static bool frames_clear(void *self)
{
    return visit_views(self, false);
}

static bool frames_warp(void *self)
{
    struct cupola_frames *frames = self;
    struct cupola_target target = {.framebuffer = frames->setting->target.framebuffer};

    return cupola_gl_warp(frames->gl, 0, NULL, &target, NULL) >= 0;
}

static bool step(struct cupola_frames *frames)
{
    frames->eye_m[0] += frames->step_m;
    frames->step_m = -frames->step_m;
    return cupola_gl_set_eye(frames->gl, frames->eye_m, NULL) >= 0;
}

/* So short a step that the picture is that of the eye at rest; all follows as it would far off. */
static bool moving_warp(void *self)
{
    return step(self) && frames_warp(self);
}

static bool moving_clear(void *self)
{
    return step(self) && frames_clear(self);
}

static bool control_warp(void *self)
{
    struct cupola_frames *frames = self;
    int size_px = frames->setting->size_px;

    glBindFramebuffer(GL_FRAMEBUFFER, frames->setting->target.framebuffer);
    glViewport(0, 0, size_px, size_px);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(frames->program);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, cupola_gl_atlas(frames->gl));
    glBindVertexArray(frames->vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    return true;
}

static void frames_facts(const void *self, struct contender_facts *facts)
{
    const struct cupola_frames *frames = self;
    const struct cupola_plan_report *report = &frames->report;

    *facts = (struct contender_facts){.shows = SHOWS_DOME,
                                      .views = report->views,
                                      .texels = report->texels_shaded_per_pixel * report->pixels};
    facts->planned = report->texels_masked_per_pixel * report->pixels;
    facts->shaded = frames->shaded;
    facts->bytes = frames->bytes;
    facts->tables = frames->tables;
    snprintf(facts->note, sizeof facts->note, "table %.20s, %.31s: %.180s",
             cupola_table_name(cupola_gl_table(frames->gl, 0)), report->family, report->reason);
}

/* A part of a frame shows nothing. */
static void part_facts(const void *self, struct contender_facts *facts)
{
    frames_facts(self, facts);
    facts->shows = SHOWS_NOTHING;
}

const struct contender_kind contender_cupola = {.prepare = views_prepare,
                                                .views = frames_views,
                                                .warp = frames_warp,
                                                .facts = frames_facts,
                                                .release = frames_release};
const struct contender_kind contender_one_pass = {.prepare = pass_prepare,
                                                  .views = pass_views,
                                                  .warp = frames_warp,
                                                  .facts = frames_facts,
                                                  .release = frames_release};
const struct contender_kind contender_stage = {.prepare = stage_prepare,
                                               .views = frames_views,
                                               .warp = frames_warp,
                                               .facts = frames_facts,
                                               .release = frames_release};
const struct contender_kind contender_filter = {.prepare = filter_prepare,
                                                .views = frames_views,
                                                .warp = frames_warp,
                                                .facts = frames_facts,
                                                .release = frames_release};
const struct contender_kind contender_listed = {.prepare = listed_prepare,
                                                .views = frames_views,
                                                .warp = frames_warp,
                                                .facts = frames_facts,
                                                .release = frames_release};
const struct contender_kind contender_resting = {.prepare = head_prepare,
                                                 .views = frames_views,
                                                 .warp = frames_warp,
                                                 .facts = frames_facts,
                                                 .release = frames_release};
const struct contender_kind contender_moved = {.prepare = head_prepare,
                                               .before = moving_warp,
                                               .views = frames_views,
                                               .warp = frames_warp,
                                               .facts = frames_facts,
                                               .release = frames_release};
const struct contender_kind contender_moving = {.prepare = head_prepare,
                                                .views = frames_views,
                                                .warp = moving_warp,
                                                .facts = frames_facts,
                                                .release = frames_release};
const struct contender_kind contender_control = {.prepare = control_prepare,
                                                 .views = frames_views,
                                                 .warp = control_warp,
                                                 .facts = frames_facts,
                                                 .release = frames_release};
const struct contender_kind contender_cupola_clear = {.prepare = views_prepare,
                                                      .views = frames_clear,
                                                      .facts = part_facts,
                                                      .release = frames_release};
const struct contender_kind contender_cupola_views = {.prepare = views_prepare,
                                                      .views = frames_views,
                                                      .facts = part_facts,
                                                      .release = frames_release};
const struct contender_kind contender_cupola_warp = {
    .prepare = warp_prepare, .warp = frames_warp, .facts = frames_facts, .release = frames_release};
const struct contender_kind contender_resting_clear = {
    .prepare = head_prepare, .warp = frames_clear, .facts = part_facts, .release = frames_release};
const struct contender_kind contender_moving_clear = {
    .prepare = head_prepare, .warp = moving_clear, .facts = part_facts, .release = frames_release};
