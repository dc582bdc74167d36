/* Sizes of GL objects. Names are small numbers in every GL that this was tried with. */
#include "footprint.h"

#include <epoxy/gl.h>

enum { NAMES_TRIED = 4096, PARTS = 5 };

/* Of so many bits, as they are kept: 24 take 32. */
static double bytes_of(int bits)
{
    int kept = 8;

    while (kept < bits)
        kept *= 2;
    return bits > 0 ? kept / 8 : 0;
}

/* Adds a picture, whose size and bits of red, green, blue and alpha are given, or of depth. */
static void add(struct footprint *sum, double texels, const GLint bits[PARTS], GLint stencil)
{
    sum->depth += texels * bytes_of(bits[PARTS - 1] + stencil);
    sum->color += texels * bytes_of(bits[0] + bits[1] + bits[2] + bits[3]);
}

static void add_texture(struct footprint *sum, GLuint name)
{
    static const GLenum parts[PARTS] = {GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE,
                                        GL_TEXTURE_BLUE_SIZE, GL_TEXTURE_ALPHA_SIZE,
                                        GL_TEXTURE_DEPTH_SIZE};
    GLint width = 0, height = 0, bits[PARTS] = {0}, stencil = 0;

    glBindTexture(GL_TEXTURE_2D, name);
    if (glGetError() != GL_NO_ERROR)
        return; /* it is of another kind */
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &height);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_STENCIL_SIZE, &stencil);
    for (int i = 0; i < PARTS; i++)
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, parts[i], &bits[i]);
    add(sum, (double)width * height, bits, stencil);
    glBindTexture(GL_TEXTURE_2D, 0);
}

static void add_renderbuffer(struct footprint *sum, GLuint name)
{
    static const GLenum parts[PARTS] = {GL_RENDERBUFFER_RED_SIZE, GL_RENDERBUFFER_GREEN_SIZE,
                                        GL_RENDERBUFFER_BLUE_SIZE, GL_RENDERBUFFER_ALPHA_SIZE,
                                        GL_RENDERBUFFER_DEPTH_SIZE};
    GLint width = 0, height = 0, samples = 0, bits[PARTS] = {0}, stencil = 0;

    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &width);
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_HEIGHT, &height);
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &samples);
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_STENCIL_SIZE, &stencil);
    for (int i = 0; i < PARTS; i++)
        glGetRenderbufferParameteriv(GL_RENDERBUFFER, parts[i], &bits[i]);
    add(sum, (double)width * height * (samples > 1 ? samples : 1), bits, stencil);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
}

static void add_buffer(struct footprint *sum, GLuint name)
{
    GLint bytes = 0;

    glBindBuffer(GL_COPY_READ_BUFFER, name);
    glGetBufferParameteriv(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE, &bytes);
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
    sum->buffers += bytes;
}

struct footprint footprint_now(void)
{
    struct footprint sum = {0};

    for (GLuint name = 1; name <= NAMES_TRIED; name++) {
        if (glIsTexture(name))
            add_texture(&sum, name);
        if (glIsRenderbuffer(name))
            add_renderbuffer(&sum, name);
        if (glIsBuffer(name))
            add_buffer(&sum, name);
    }
    return sum;
}

double footprint_texture(unsigned int texture)
{
    struct footprint sum = {0};

    if (texture)
        add_texture(&sum, texture);
    return sum.color + sum.depth;
}
