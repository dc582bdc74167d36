/* One plain view, and the plainest pass over a picture: what everything is measured in. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <epoxy/gl.h>

#include "bench_shaders.h"
#include "contender.h"
#include "perspective.h"
#include "program.h"

struct plain_view {
    const struct setting *setting;
    struct cupola_camera camera;
};

static void *plain_prepare(const struct setting *setting, int variant, char *message)
{
    struct plain_view *plain = calloc(1, sizeof *plain);
    double side = tan(setting_plain_fov_rad(setting) / 2);

    (void)variant;
    if (!plain) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return NULL;
    }
    plain->setting = setting;
    perspective_camera(&(struct perspective){.rotation = {1, 0, 0, 0, 1, 0, 0, 0, 1},
                                             .left = -side,
                                             .right = side,
                                             .bottom = -side,
                                             .top = side,
                                             .near_distance = setting->depth.near_distance,
                                             .far_distance = setting->depth.far_distance},
                       &plain->camera);
    return plain;
}

static bool plain_views(void *self)
{
    const struct plain_view *plain = self;
    const struct setting *setting = plain->setting;

    glBindFramebuffer(GL_FRAMEBUFFER, setting->target.framebuffer);
    setting_draw(setting, &plain->camera, setting->size_px, setting->size_px);
    return true;
}

static bool plain_clear(void *self)
{
    const struct plain_view *plain = self;
    const struct setting *setting = plain->setting;

    glBindFramebuffer(GL_FRAMEBUFFER, setting->target.framebuffer);
    setting_clear(setting, setting->size_px, setting->size_px);
    return true;
}

static void plain_facts(const void *self, struct contender_facts *facts)
{
    const struct plain_view *plain = self;
    double pixels = (double)plain->setting->size_px * plain->setting->size_px;

    *facts = (struct contender_facts){.shows = SHOWS_PLAIN_VIEW, .views = 1, .texels = pixels};
    facts->bytes = 4 * pixels; /* its depth: the target's */
}

const struct contender_kind contender_plain_view = {
    .prepare = plain_prepare, .views = plain_views, .facts = plain_facts, .release = free};

static void clear_facts(const void *self, struct contender_facts *facts)
{
    plain_facts(self, facts);
    facts->shows = SHOWS_NOTHING;
}

const struct contender_kind contender_plain_clear = {
    .prepare = plain_prepare, .views = plain_clear, .facts = clear_facts, .release = free};

enum { SMALL_PARTS = 4 }; /* of the output's side that a small picture has one of */

struct blit {
    const struct setting *setting;
    GLuint program;
    GLuint vertex_array;
    struct target picture;
};

static void blit_release(void *self)
{
    struct blit *blit = self;

    if (!blit)
        return;
    glDeleteProgram(blit->program);
    glDeleteVertexArrays(1, &blit->vertex_array);
    target_destroy(&blit->picture);
    free(blit);
}

static void *blit_prepare(const struct setting *setting, int variant, char *message)
{
    struct blit *blit = calloc(1, sizeof *blit);
    int repeats = variant == BLIT_TURNED_SMALL ? SMALL_PARTS : 1;
    int side_px = (setting->size_px + repeats - 1) / repeats;

    if (!blit) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return NULL;
    }
    blit->setting = setting;
    blit->program =
        program_create("blit", variant == BLIT_STRAIGHT ? shader_whole_vert : shader_turned_vert,
                       shader_blit_frag, message, MESSAGE_SIZE);
    if (!blit->program ||
        !target_create(&blit->picture, side_px, side_px, TARGET_BYTES, message, MESSAGE_SIZE)) {
        blit_release(blit);
        return NULL;
    }
    glUseProgram(blit->program);
    glUniform1f(glGetUniformLocation(blit->program, "repeats"), (float)repeats);
    glGenVertexArrays(1, &blit->vertex_array);
    if (variant != BLIT_STRAIGHT) {
        glBindTexture(GL_TEXTURE_2D, blit->picture.texture);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, blit->picture.framebuffer);
    glClearColor(0.3f, 0.5f, 0.7f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    return blit;
}

static bool blit_warp(void *self)
{
    const struct blit *blit = self;

    glBindFramebuffer(GL_FRAMEBUFFER, blit->setting->target.framebuffer);
    glViewport(0, 0, blit->setting->size_px, blit->setting->size_px);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(blit->program);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, blit->picture.texture);
    glBindVertexArray(blit->vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    return true;
}

static void blit_facts(const void *self, struct contender_facts *facts)
{
    (void)self;
    *facts = (struct contender_facts){.shows = SHOWS_NOTHING};
}

const struct contender_kind contender_blit = {
    .prepare = blit_prepare, .warp = blit_warp, .facts = blit_facts, .release = blit_release};
