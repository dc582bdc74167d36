/* A framebuffer of the demo's own. */
#include "target.h"

#include <stdio.h>

#include <epoxy/gl.h>

static const struct {
    GLint internal_format;
    GLenum type;
    const char *name;
} kinds[] = {
    [TARGET_BYTES] = {GL_RGBA8, GL_UNSIGNED_BYTE, "RGBA8"},
    [TARGET_SRGB] = {GL_SRGB8_ALPHA8, GL_UNSIGNED_BYTE, "SRGB8_ALPHA8"},
    [TARGET_FLOATS] = {GL_RGBA32F, GL_FLOAT, "RGBA32F"},
};

static void attach(struct target *target, enum target_kind kind)
{
    glGenTextures(1, &target->texture);
    glBindTexture(GL_TEXTURE_2D, target->texture);
    glTexImage2D(GL_TEXTURE_2D, 0, kinds[kind].internal_format, target->width, target->height, 0,
                 GL_RGBA, kinds[kind].type, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glBindTexture(GL_TEXTURE_2D, 0);

    glGenRenderbuffers(1, &target->depth);
    glBindRenderbuffer(GL_RENDERBUFFER, target->depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, target->width, target->height);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);

    glGenFramebuffers(1, &target->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target->texture, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target->depth);
}

bool target_create(struct target *target, int width, int height, enum target_kind kind,
                   char *message, size_t message_size)
{
    GLint allowed = 0;
    GLenum status, error;

    *target = (struct target){.width = width, .height = height};
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &allowed);
    if (width > allowed || height > allowed) {
        snprintf(message, message_size, "a picture of %dx%d is too large; this GL allows %dx%d",
                 width, height, allowed, allowed);
        goto fail;
    }
    while (glGetError() != GL_NO_ERROR)
        continue;
    attach(target, kind);
    error = glGetError();
    status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (error == GL_NO_ERROR && status == GL_FRAMEBUFFER_COMPLETE)
        return true;
    snprintf(message, message_size,
             "the GL refuses a framebuffer of %dx%d (%s; error 0x%04x, status 0x%04x)", width,
             height, kinds[kind].name, error, status);
fail:
    target_destroy(target);
    return false;
}

void target_destroy(struct target *target)
{
    glDeleteFramebuffers(1, &target->framebuffer);
    glDeleteTextures(1, &target->texture);
    glDeleteRenderbuffers(1, &target->depth);
    *target = (struct target){0};
}
