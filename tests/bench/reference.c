/* Pictures that contenders are compared with: many rays per pixel into a fine cube map. */
#include "reference.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <epoxy/gl.h>

#include "bench_shaders.h"
#include "cube_faces.h"
#include "program.h"

enum { OVERSAMPLING = 3, FACE_MOST_PX = 6144, BAND_PX = 128, TABLES = 3 };

/* What a band of rows is made with. */
struct maker {
    const struct setting *setting;
    struct cube_faces faces;
    GLuint program;
    GLuint vertex_array;
    GLuint tables[TABLES]; /* direction and whether it counts, its changes along x and y */
    float *numbers[TABLES];
    struct target band;
};

static void maker_destroy(struct maker *maker)
{
    cube_faces_destroy(&maker->faces);
    glDeleteProgram(maker->program);
    glDeleteVertexArrays(1, &maker->vertex_array);
    glDeleteTextures(TABLES, maker->tables);
    target_destroy(&maker->band);
    for (int i = 0; i < TABLES; i++)
        free(maker->numbers[i]);
}

static bool maker_create(struct maker *maker, const struct setting *setting, int face_px,
                         char *message)
{
    static const char *const names[TABLES] = {"directions", "along_x", "along_y"};
    size_t floats = 4 * (size_t)setting->size_px * BAND_PX;

    *maker = (struct maker){.setting = setting};
    for (int i = 0; i < TABLES; i++)
        if (!(maker->numbers[i] = calloc(floats, sizeof(float)))) {
            snprintf(message, MESSAGE_SIZE, "out of memory");
            return false;
        }
    maker->program = program_create("reference", shader_whole_vert, shader_many_rays_frag, message,
                                    MESSAGE_SIZE);
    if (!maker->program || !cube_faces_create(&maker->faces, face_px, message) ||
        !target_create(&maker->band, setting->size_px, BAND_PX, TARGET_FLOATS, message,
                       MESSAGE_SIZE))
        return false;
    glGenVertexArrays(1, &maker->vertex_array);
    glGenTextures(TABLES, maker->tables);
    glUseProgram(maker->program);
    for (int i = 0; i < TABLES; i++) {
        glBindTexture(GL_TEXTURE_2D, maker->tables[i]);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glUniform1i(glGetUniformLocation(maker->program, names[i]), 1 + i);
    }
    glUseProgram(0);
    return true;
}

/* The ray of a pixel; false where the pixel is not wholly lit. */
static bool ray_of(const struct setting *setting, enum shows shows, double x, double y,
                   struct cupola_ray *ray)
{
    double scale = 2 * tan(setting_plain_fov_rad(setting) / 2) / setting->size_px;
    double half = 0.5 * setting->size_px;

    if (shows == SHOWS_DOME)
        return cupola_dome_ray(setting->dome, 0, NULL, x, y, ray) == 1 && ray->coverage >= 1;
    *ray = (struct cupola_ray){.direction = {(x - half) * scale, (y - half) * scale, -1},
                               .direction_dx = {scale, 0, 0},
                               .direction_dy = {0, scale, 0}};
    return true;
}

static void fill_band(struct maker *maker, enum shows shows, int row)
{
    int size_px = maker->setting->size_px;
    struct cupola_ray ray;

    for (int j = 0; j < BAND_PX; j++)
        for (int i = 0; i < size_px; i++) {
            size_t at = 4 * ((size_t)j * (size_t)size_px + (size_t)i);
            bool counts = ray_of(maker->setting, shows, i + 0.5, row + j + 0.5, &ray);
            for (int k = 0; k < 3; k++) {
                maker->numbers[0][at + (size_t)k] = (float)ray.direction[k];
                maker->numbers[1][at + (size_t)k] = (float)ray.direction_dx[k];
                maker->numbers[2][at + (size_t)k] = (float)ray.direction_dy[k];
            }
            maker->numbers[0][at + 3] = counts && row + j < size_px;
        }
    for (int i = 0; i < TABLES; i++) {
        glActiveTexture(GL_TEXTURE1 + (GLenum)i);
        glBindTexture(GL_TEXTURE_2D, maker->tables[i]);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, size_px, BAND_PX, 0, GL_RGBA, GL_FLOAT,
                     maker->numbers[i]);
    }
    glActiveTexture(GL_TEXTURE0);
}

static void draw_picture(struct maker *maker, enum shows shows, float *rgba)
{
    int size_px = maker->setting->size_px;

    for (int row = 0; row < size_px; row += BAND_PX) {
        int rows = size_px - row < BAND_PX ? size_px - row : BAND_PX;
        fill_band(maker, shows, row);
        glBindFramebuffer(GL_FRAMEBUFFER, maker->band.framebuffer);
        glViewport(0, 0, size_px, BAND_PX);
        glDisable(GL_DEPTH_TEST);
        glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
        glUseProgram(maker->program);
        glBindTexture(GL_TEXTURE_CUBE_MAP, maker->faces.texture);
        glBindVertexArray(maker->vertex_array);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
        glReadPixels(0, 0, size_px, rows, GL_RGBA, GL_FLOAT,
                     rgba + 4 * (size_t)row * (size_t)size_px);
    }
    glBindVertexArray(0);
    glBindTexture(GL_TEXTURE_CUBE_MAP, 0);
    for (int i = 0; i < TABLES; i++) {
        glActiveTexture(GL_TEXTURE1 + (GLenum)i);
        glBindTexture(GL_TEXTURE_2D, 0);
    }
    glActiveTexture(GL_TEXTURE0);
}

bool reference_create(struct reference *reference, const struct setting *setting, char *message)
{
    static const double axes[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    struct maker maker;
    GLint largest = 0;
    int wished_px = cube_faces_no_loss_px(setting, axes), face_px = OVERSAMPLING * wished_px;
    size_t floats = 4 * (size_t)setting->size_px * (size_t)setting->size_px;

    glGetIntegerv(GL_MAX_CUBE_MAP_TEXTURE_SIZE, &largest);
    face_px = largest < face_px ? largest : face_px;
    face_px = face_px < FACE_MOST_PX ? face_px : FACE_MOST_PX;
    *reference = (struct reference){.size_px = setting->size_px,
                                    .oversampling = (double)face_px / wished_px};
    if (!maker_create(&maker, setting, face_px, message))
        goto fail;
    cube_faces_draw(&maker.faces, setting, axes, 0x3f);
    for (int shows = SHOWS_DOME; shows <= SHOWS_PLAIN_VIEW; shows++) {
        reference->pictures[shows] = malloc(floats * sizeof(float));
        if (!reference->pictures[shows]) {
            snprintf(message, MESSAGE_SIZE, "out of memory");
            goto fail;
        }
        draw_picture(&maker, (enum shows)shows, reference->pictures[shows]);
    }
    maker_destroy(&maker);
    return true;

fail:
    maker_destroy(&maker);
    reference_destroy(reference);
    return false;
}

void reference_destroy(struct reference *reference)
{
    for (int i = 0; i <= SHOWS_PLAIN_VIEW; i++)
        free(reference->pictures[i]);
    *reference = (struct reference){0};
}

double reference_psnr_db(const struct reference *reference, const struct setting *setting,
                         enum shows shows)
{
    const float *wished = reference->pictures[shows];
    size_t pixels = (size_t)setting->size_px * (size_t)setting->size_px, count = 0;
    unsigned char *found;
    double sum = 0;

    if (!wished || !(found = malloc(4 * pixels)))
        return 0;
    glBindFramebuffer(GL_FRAMEBUFFER, setting->target.framebuffer);
    glReadPixels(0, 0, setting->size_px, setting->size_px, GL_RGBA, GL_UNSIGNED_BYTE, found);
    for (size_t i = 0; i < pixels; i++) {
        if (wished[4 * i + 3] < 0.5f)
            continue;
        for (size_t k = 0; k < 3; k++)
            sum += pow(found[4 * i + k] / 255.0 - (double)wished[4 * i + k], 2);
        count += 3;
    }
    free(found);
    /* 100 dB is more than 8 bits can show. */
    return count > 0 && sum > 1e-10 * (double)count ? 10 * log10((double)count / sum) : 100;
}
