/* The floats are drawn as bytes, which every GL can read. */
#include "table_bits.h"

#include <stdint.h>
#include <stdlib.h>

#include "check.h"
#include "context.h"
#include "paint_shaders.h"

static GLuint bytes_framebuffer(int width_px, int height_px, GLuint *color)
{
    GLuint framebuffer = 0;
    glGenRenderbuffers(1, color);
    glBindRenderbuffer(GL_RENDERBUFFER, *color);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width_px, height_px);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, *color);
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    return framebuffer;
}

static void draw_bytes(GLuint texture, int width_px, int height_px)
{
    GLuint vertex_array = 0;
    GLuint program = context_program(shader_paint_vert, shader_bits_frag);
    glGenVertexArrays(1, &vertex_array);
    glBindVertexArray(vertex_array);
    glUseProgram(program);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture);
    glUniform1i(glGetUniformLocation(program, "table"), 0);
    glViewport(0, 0, width_px, height_px);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glUseProgram(0);
    glBindTexture(GL_TEXTURE_2D, 0);
    glDeleteProgram(program);
    glDeleteVertexArrays(1, &vertex_array);
}

float *table_bits(GLuint texture, int width_px, int height_px)
{
    size_t count = 4 * (size_t)width_px * (size_t)height_px;
    uint8_t *bytes = malloc(4 * count);
    float *values = malloc(count * sizeof *values);
    GLuint color = 0, framebuffer = bytes_framebuffer(4 * width_px, height_px, &color);
    assert_true(bytes && values);
    draw_bytes(texture, 4 * width_px, height_px);
    glReadPixels(0, 0, 4 * width_px, height_px, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    for (size_t i = 0; i < count; i++) {
        const uint8_t *b = bytes + 4 * i;
        union {
            uint32_t bits;
            float value;
        } word = {b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24};
        values[i] = word.value;
    }
    free(bytes);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(1, &color);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    return values;
}
