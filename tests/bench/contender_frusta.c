/*
 * Three frusta tilted round the axis, set once by hand, and for each a third of the picture as a
 * mesh whose corners know their place in the view: the way of the first dome displays. The tilt is
 * the one of a few that needs the least texels at no loss, which is kind to it.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <epoxy/gl.h>

#include "bench_shaders.h"
#include "contender.h"
#include "density.h"
#include "perspective.h"
#include "program.h"

enum { VIEWS = 3, RINGS = 24, STEPS = 32 /* of a mesh */, GUARD_PX = 2 };

static const double sector_rad = 2 * 3.14159265358979323846 / VIEWS;

struct frustum {
    double rotation[9];
    double left, right, bottom, top;
    double texels_per_unit;
    bool reached; /* all rays of its third */
};

struct frusta {
    const struct setting *setting;
    struct frustum frustum[VIEWS];
    struct target picture[VIEWS];
    GLuint program;
    GLuint vertex_arrays[VIEWS];
    GLuint vertices[VIEWS];
};

struct corner {
    float place[2]; /* clip coordinates */
    float texcoord[2];
};

static void frusta_release(void *self)
{
    struct frusta *frusta = self;

    if (!frusta)
        return;
    for (int i = 0; i < VIEWS; i++)
        target_destroy(&frusta->picture[i]);
    glDeleteProgram(frusta->program);
    glDeleteVertexArrays(VIEWS, frusta->vertex_arrays);
    glDeleteBuffers(VIEWS, frusta->vertices);
    free(frusta);
}

/* Which third a direction falls to: the first is above, the others follow to the left. */
static int third_of(const double direction[3])
{
    double turn = atan2(-direction[0], direction[1]) / sector_rad;
    return ((int)floor(turn + 0.5) + VIEWS) % VIEWS;
}

static void visit(void *context, const struct cupola_ray *ray)
{
    struct frustum *frusta = context, *f = &frusta[third_of(ray->direction)];
    double place[2], texels_per_unit;

    if (!density_needed(ray, f->rotation, place, &texels_per_unit)) {
        f->reached = false;
        return;
    }
    f->left = fmin(f->left, place[0]);
    f->right = fmax(f->right, place[0]);
    f->bottom = fmin(f->bottom, place[1]);
    f->top = fmax(f->top, place[1]);
    f->texels_per_unit = fmax(f->texels_per_unit, texels_per_unit);
}

/* Frusta at one tilt; the texels that they take, infinite where a ray is out of reach. */
static double try_tilt(const struct setting *setting, double tilt, struct frustum frusta[VIEWS])
{
    double texels = 0;

    for (int i = 0; i < VIEWS; i++) {
        double c = cos(i * sector_rad), s = sin(i * sector_rad);
        /* Up on the view points away from the axis. */
        const double rotation[9] = {
            c,        s, 0, -s * cos(tilt), c * cos(tilt), sin(tilt), s * sin(tilt), -c * sin(tilt),
            cos(tilt)};
        frusta[i] = (struct frustum){.reached = true};
        memcpy(frusta[i].rotation, rotation, sizeof rotation);
    }
    density_each_ray(setting->dome, setting->size_px, visit, frusta);
    for (int i = 0; i < VIEWS; i++) {
        struct frustum *f = &frusta[i];
        if (!f->reached)
            return HUGE_VAL;
        texels +=
            f->texels_per_unit * f->texels_per_unit * (f->right - f->left) * (f->top - f->bottom);
    }
    return texels;
}

static bool set_frusta(struct frusta *frusta, char *message)
{
    struct frustum tried[VIEWS];
    double least = HUGE_VAL;

    for (int step = 1; step < 12; step++) {
        double texels = try_tilt(frusta->setting, frusta->setting->fov_rad / 2 * step / 12, tried);
        if (texels >= least)
            continue;
        least = texels;
        memcpy(frusta->frustum, tried, sizeof tried);
    }
    if (isfinite(least))
        return true;
    snprintf(message, MESSAGE_SIZE, "three frusta do not reach %.0f degrees",
             frusta->setting->fov_rad * 180 / 3.14159265358979323846);
    return false;
}

static bool make_picture(struct frusta *frusta, int view, char *message)
{
    struct frustum *f = &frusta->frustum[view];
    double guard = GUARD_PX / f->texels_per_unit;

    f->left -= guard;
    f->right += guard;
    f->bottom -= guard;
    f->top += guard;
    return target_create(
        &frusta->picture[view], (int)ceil((f->right - f->left) * f->texels_per_unit),
        (int)ceil((f->top - f->bottom) * f->texels_per_unit), TARGET_BYTES, message, MESSAGE_SIZE);
}

static struct corner corner_at(const struct frusta *frusta, int view, int ring, int step)
{
    const struct frustum *f = &frusta->frustum[view];
    double turn = (view + (double)step / STEPS - 0.5) * sector_rad;
    double half = 0.5 * frusta->setting->size_px, radius = (double)ring / RINGS, place[2] = {0, 0};
    double x = -sin(turn) * radius, y = cos(turn) * radius, ignored;
    struct cupola_ray ray;

    cupola_dome_ray(frusta->setting->dome, 0, NULL, half + half * x, half + half * y, &ray);
    density_needed(&ray, f->rotation, place, &ignored);
    return (struct corner){{(float)x, (float)y},
                           {(float)((place[0] - f->left) / (f->right - f->left)),
                            (float)((place[1] - f->bottom) / (f->top - f->bottom))}};
}

static void make_mesh(struct frusta *frusta, int view)
{
    static const int order[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
    struct corner corners[RINGS * STEPS * 6], *corner = corners;

    for (int ring = 0; ring < RINGS; ring++)
        for (int step = 0; step < STEPS; step++)
            for (int c = 0; c < 6; c++)
                *corner++ = corner_at(frusta, view, ring + order[c][0], step + order[c][1]);
    glBindVertexArray(frusta->vertex_arrays[view]);
    glBindBuffer(GL_ARRAY_BUFFER, frusta->vertices[view]);
    glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof *corner, NULL);
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof *corner,
                          (const void *)offsetof(struct corner, texcoord));
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

static void *frusta_prepare(const struct setting *setting, int variant, char *message)
{
    struct frusta *frusta;

    (void)variant;
    if (setting->off_axis) {
        snprintf(message, MESSAGE_SIZE, "knows no eye off the axis");
        return NULL;
    }
    frusta = calloc(1, sizeof *frusta);
    if (!frusta) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return NULL;
    }
    frusta->setting = setting;
    if (!set_frusta(frusta, message))
        goto fail;
    frusta->program =
        program_create("frusta", shader_mesh_flat_vert, shader_blit_frag, message, MESSAGE_SIZE);
    if (!frusta->program)
        goto fail;
    glGenVertexArrays(VIEWS, frusta->vertex_arrays);
    glGenBuffers(VIEWS, frusta->vertices);
    for (int i = 0; i < VIEWS; i++) {
        if (!make_picture(frusta, i, message))
            goto fail;
        make_mesh(frusta, i);
    }
    return frusta;

fail:
    frusta_release(frusta);
    return NULL;
}

static bool frusta_views(void *self)
{
    struct frusta *frusta = self;
    const struct setting *setting = frusta->setting;

    for (int i = 0; i < VIEWS; i++) {
        const struct frustum *f = &frusta->frustum[i];
        struct perspective view = {.left = f->left,
                                   .right = f->right,
                                   .bottom = f->bottom,
                                   .top = f->top,
                                   .near_distance = setting->depth.near_distance,
                                   .far_distance = setting->depth.far_distance};
        struct cupola_camera camera;
        memcpy(view.rotation, f->rotation, sizeof view.rotation);
        perspective_camera(&view, &camera);
        glBindFramebuffer(GL_FRAMEBUFFER, frusta->picture[i].framebuffer);
        setting_draw(setting, &camera, frusta->picture[i].width, frusta->picture[i].height);
    }
    return true;
}

static bool frusta_warp(void *self)
{
    const struct frusta *frusta = self;

    glBindFramebuffer(GL_FRAMEBUFFER, frusta->setting->target.framebuffer);
    glViewport(0, 0, frusta->setting->size_px, frusta->setting->size_px);
    glDisable(GL_DEPTH_TEST);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(frusta->program);
    glActiveTexture(GL_TEXTURE0);
    for (int i = 0; i < VIEWS; i++) {
        glBindTexture(GL_TEXTURE_2D, frusta->picture[i].texture);
        glBindVertexArray(frusta->vertex_arrays[i]);
        glDrawArrays(GL_TRIANGLES, 0, RINGS * STEPS * 6);
    }
    glBindVertexArray(0);
    return true;
}

static void frusta_facts(const void *self, struct contender_facts *facts)
{
    const struct frusta *frusta = self;

    *facts = (struct contender_facts){.shows = SHOWS_DOME, .views = VIEWS};
    for (int i = 0; i < VIEWS; i++)
        facts->texels += (double)frusta->picture[i].width * frusta->picture[i].height;
    facts->bytes = 8 * facts->texels;
    snprintf(facts->note, sizeof facts->note, "the first view has %dx%d px",
             frusta->picture[0].width, frusta->picture[0].height);
}

const struct contender_kind contender_frusta = {.prepare = frusta_prepare,
                                                .views = frusta_views,
                                                .warp = frusta_warp,
                                                .facts = frusta_facts,
                                                .release = frusta_release};
