/* See view_textures.h. */
#include "view_textures.h"

#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "geometry/plan.h"
#include "light_fixture.h"

enum { MARGIN = 9 };

static void color_of_ray(const double direction[3], float rgba[4], void *user)
{
    const double *phase = user;
    for (int c = 0; c < 4; c++)
        rgba[c] = 0.5f + 0.4f * (float)sin(2.0 * direction[c % 3] + *phase + c);
}

static int count_of(const struct view_textures *textures)
{
    return textures->plan->view_count;
}

static int total_width(const struct view_textures *textures)
{
    return textures->plan->report.atlas_width_px;
}

/* Sizes and places; layers of an array are all of one size. */
static void lay_out(const struct view_wish *wish, struct view_textures *textures)
{
    int x = 0, highest = 0, widest = 0, count = count_of(textures);
    int margin = wish->whole ? 0 : MARGIN;
    for (int i = 0; i < count; i++) {
        struct cupola_rect *rect = &textures->plan->views[i].rect;
        rect->width = (int)(wish->larger * rect->width) + i;
        rect->height = (int)(wish->larger * rect->height) + 2 * i;
        textures->width[i] = rect->width + margin * (i + 1);
        textures->height[i] = rect->height + margin * (i + 2);
        widest = widest > textures->width[i] ? widest : textures->width[i];
        highest = highest > textures->height[i] ? highest : textures->height[i];
    }
    for (int i = 0; i < count; i++) {
        struct cupola_rect *rect = &textures->plan->views[i].rect;
        if (wish->storage == CUPOLA_STORAGE_LAYERS) {
            textures->width[i] = widest;
            textures->height[i] = highest;
        }
        if (wish->whole) {
            rect->width = textures->width[i];
            rect->height = textures->height[i];
        }
        textures->left[i] = x;
        rect->x = x + (wish->whole ? 0 : 2 + i);
        rect->y = wish->whole ? 0 : 7 - i % 3;
        x += textures->width[i];
    }
    textures->plan->report.atlas_width_px = x;
    textures->plan->report.atlas_height_px = highest;
}

static bool in_a_view(const struct view_textures *textures, int x, int y)
{
    for (int i = 0; i < count_of(textures); i++) {
        const struct cupola_rect *rect = &textures->plan->views[i].rect;
        if (x >= rect->x && y >= rect->y && x < rect->x + rect->width && y < rect->y + rect->height)
            return true;
    }
    return false;
}

/* As the format holds them; sRGB decoded, as the GL does it. */
static void paint(const struct view_wish *wish, struct view_textures *textures)
{
    int width = total_width(textures), height = textures->plan->report.atlas_height_px;
    double phase = wish->phase;
    textures->texels = malloc(4 * sizeof(float) * (size_t)width * (size_t)height);
    assert_non_null(textures->texels);
    cupola_reference_views(textures->plan, color_of_ray, &phase, textures->texels);
    for (int k = 0; k < width * height; k++)
        for (int c = 0; c < 4; c++) {
            float *number = textures->texels + 4 * k + c;
            double value = in_a_view(textures, k % width, k / width) ? (double)*number : 1.0;
            if (wish->format == GL_RGBA16F)
                value = round(1024.0 * value) / 1024.0;
            else if (c == 3)
                value = round(255.0 * value) / 255.0;
            else
                value = light_decoded(round(255.0 * light_encoded(value)) / 255.0);
            *number = (float)value;
        }
}

static void *cut(const struct view_wish *wish, const struct view_textures *textures, int i)
{
    int width = textures->width[i], height = textures->height[i];
    float *floats = malloc(4 * sizeof *floats * (size_t)width * (size_t)height);
    unsigned char *bytes = malloc(4 * (size_t)width * (size_t)height);
    assert_true(floats && bytes);
    for (int y = 0; y < height; y++)
        memcpy(floats + 4 * y * width,
               textures->texels + 4 * (y * total_width(textures) + textures->left[i]),
               4 * sizeof *floats * (size_t)width);
    for (int k = 0; k < 4 * width * height; k++) {
        double value = (double)floats[k];
        bytes[k] = (unsigned char)lround(255.0 * (k % 4 == 3 ? value : light_encoded(value)));
    }
    bool wants_floats = wish->format == GL_RGBA16F;
    free(wants_floats ? (void *)bytes : (void *)floats);
    return wants_floats ? (void *)floats : (void *)bytes;
}

/* Layers in another order than the views. */
static int layer_of(int i, int count)
{
    return (3 * i + 2) % (count % 3 ? count : count + 1);
}

static void upload(const struct view_wish *wish, struct view_textures *textures)
{
    GLenum type = wish->format == GL_RGBA16F ? GL_FLOAT : GL_UNSIGNED_BYTE;
    bool layers = wish->storage == CUPOLA_STORAGE_LAYERS;
    int count = count_of(textures);
    glGenTextures(layers ? 1 : count, textures->names);
    if (layers) {
        glBindTexture(GL_TEXTURE_2D_ARRAY, textures->names[0]);
        glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, (GLint)wish->format, textures->width[0],
                     textures->height[0], count + 1, 0, GL_RGBA, type, NULL);
    }
    for (int i = 0; i < count; i++) {
        void *pixels = cut(wish, textures, i);
        if (layers) {
            glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, layer_of(i, count), textures->width[i],
                            textures->height[i], 1, GL_RGBA, type, pixels);
        } else {
            glBindTexture(GL_TEXTURE_2D, textures->names[i]);
            glTexImage2D(GL_TEXTURE_2D, 0, (GLint)wish->format, textures->width[i],
                         textures->height[i], 0, GL_RGBA, type, pixels);
        }
        free(pixels);
    }
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
}

void view_textures_make(const cupola_plan *plan, const struct view_wish *wish,
                        struct view_textures *textures)
{
    *textures = (struct view_textures){.plan = malloc(sizeof *plan)};
    assert_non_null(textures->plan);
    *textures->plan = *plan;
    lay_out(wish, textures);
    paint(wish, textures);
    upload(wish, textures);
    for (int i = 0; i < count_of(textures); i++) {
        bool layers = wish->storage == CUPOLA_STORAGE_LAYERS;
        struct cupola_view_image *image = &textures->images[i];
        image->texture = textures->names[layers ? 0 : i];
        image->layer = layers ? layer_of(i, count_of(textures)) : 0;
        if (wish->whole)
            continue;
        image->rect = textures->plan->views[i].rect;
        image->rect.x -= textures->left[i];
    }
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

void view_textures_release(struct view_textures *textures)
{
    glDeleteTextures(CUPOLA_VIEWS_MAX, textures->names);
    free(textures->texels);
    cupola_plan_destroy(&textures->plan);
}
