/* Text over the picture, by stb_easy_font: every letter is a handful of quads. */
#include "overlay.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cupola/text.h>
#include <epoxy/gl.h>
#include <stb_easy_font.h>

#include "overlay_shaders.h"
#include "program.h"

enum { QUADS_MAX = 8192, VERTEX_BYTES = 16, TEXT_MAX = 2000, MARGIN = 4 };

struct overlay {
    GLuint program;
    GLuint vertex_array;
    GLuint vertices;
    GLuint indices;
    GLint window;
    GLint origin;
    /* As stb_easy_font writes them: x, y, z as floats, four bytes of colour. */
    unsigned char quads[QUADS_MAX * 4 * VERTEX_BYTES];
};

/* Two triangles for every quad. */
static void fill_indices(void)
{
    static const uint16_t corners[6] = {0, 1, 2, 0, 2, 3};
    uint16_t *indices = malloc(QUADS_MAX * 6 * sizeof *indices);

    if (!indices)
        return;
    for (int i = 0; i < QUADS_MAX * 6; i++)
        indices[i] = (uint16_t)(4 * (i / 6) + corners[i % 6]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(QUADS_MAX * 6 * sizeof *indices), indices,
                 GL_STATIC_DRAW);
    free(indices);
}

struct overlay *overlay_create(char *message, size_t message_size)
{
    struct overlay *overlay = calloc(1, sizeof *overlay);

    if (!overlay) {
        snprintf(message, message_size, "overlay: out of memory");
        return NULL;
    }
    overlay->program =
        program_create("overlay", shader_overlay_vert, shader_overlay_frag, message, message_size);
    if (!overlay->program) {
        free(overlay);
        return NULL;
    }
    overlay->window = glGetUniformLocation(overlay->program, "window_px");
    overlay->origin = glGetUniformLocation(overlay->program, "origin_scale");
    glGenVertexArrays(1, &overlay->vertex_array);
    glGenBuffers(1, &overlay->vertices);
    glGenBuffers(1, &overlay->indices);
    glBindVertexArray(overlay->vertex_array);
    glBindBuffer(GL_ARRAY_BUFFER, overlay->vertices);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, VERTEX_BYTES, NULL);
    glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, VERTEX_BYTES, (const void *)12);
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, overlay->indices);
    fill_indices();
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    return overlay;
}

void overlay_destroy(struct overlay *overlay)
{
    if (!overlay)
        return;
    glDeleteBuffers(1, &overlay->vertices);
    glDeleteBuffers(1, &overlay->indices);
    glDeleteVertexArrays(1, &overlay->vertex_array);
    glDeleteProgram(overlay->program);
    free(overlay);
}

void overlay_size(const char *text, double scale, double *width, double *height)
{
    char copy[TEXT_MAX];

    cupola_text_letters(text, copy, sizeof copy);
    *width = scale * (stb_easy_font_width(copy) + 2 * MARGIN);
    *height = scale * (stb_easy_font_height(copy) + 2 * MARGIN);
}

/* The first quad: the ground behind the text. */
static void write_ground(struct overlay *overlay, double width, double height, int opacity)
{
    const double corners[4][2] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    const unsigned char color[4] = {0, 0, 0, (unsigned char)(opacity > 0 ? opacity : 160)};

    for (int i = 0; i < 4; i++) {
        float place[3] = {(float)corners[i][0], (float)corners[i][1], 0};
        memcpy(overlay->quads + i * VERTEX_BYTES, place, sizeof place);
        memcpy(overlay->quads + i * VERTEX_BYTES + sizeof place, color, sizeof color);
    }
}

void overlay_text(struct overlay *overlay, const struct overlay_place *place, const char *text)
{
    char copy[TEXT_MAX];
    unsigned char ink[4] = {255, 255, 255, 255};
    double ground_width, ground_height;
    int quads;

    if (place->ink)
        memcpy(ink, place->ink, sizeof ink);
    cupola_text_letters(text, copy, sizeof copy);
    overlay_size(copy, 1, &ground_width, &ground_height);
    write_ground(overlay, ground_width, ground_height, place->ground);
    quads = 1 + stb_easy_font_print(MARGIN, MARGIN, copy, ink, overlay->quads + 4 * VERTEX_BYTES,
                                    (int)sizeof overlay->quads - 4 * VERTEX_BYTES);

    glBindFramebuffer(GL_FRAMEBUFFER, place->framebuffer);
    glViewport(0, 0, place->width, place->height);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glUseProgram(overlay->program);
    glUniform2f(overlay->window, (float)place->width, (float)place->height);
    glUniform3f(overlay->origin, (float)place->x, (float)place->y, (float)place->scale);
    glBindVertexArray(overlay->vertex_array);
    glBindBuffer(GL_ARRAY_BUFFER, overlay->vertices);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)quads * 4 * VERTEX_BYTES, overlay->quads,
                 GL_STREAM_DRAW);
    glDrawElements(GL_TRIANGLES, 6 * quads, GL_UNSIGNED_SHORT, NULL);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindVertexArray(0);
    glUseProgram(0);
    glDisable(GL_BLEND);
}
