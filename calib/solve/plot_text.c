/* Text in plots. */
#include "plot_text.h"

#include <stdlib.h>
#include <string.h>

#include <cupola/text.h>

/* The library's picture has its rows from the bottom up, cairo's masks from the top down. */
static void fill_mask(cairo_surface_t *mask, const unsigned char *rgba, int width, int height)
{
    unsigned char *bytes = cairo_image_surface_get_data(mask);
    int stride = cairo_image_surface_get_stride(mask);

    cairo_surface_flush(mask);
    for (int i = 0; i < width * height && bytes; i++)
        bytes[(height - 1 - i / width) * stride + i % width] = rgba[4 * i + 3];
    cairo_surface_mark_dirty(mask);
}

void plot_text(cairo_t *cairo, const char *text, double x, double y, const double color[3])
{
    enum { SCALE = 2, BELOW = 2 /* units below the baseline */ };
    int width, height;

    if (cupola_text_size(text, SCALE, &width, &height, NULL) < 0)
        return;
    unsigned char *rgba = malloc(4 * (size_t)width * (size_t)height);
    cairo_surface_t *mask = cairo_image_surface_create(CAIRO_FORMAT_A8, width, height);
    if (rgba && cupola_text_draw(text, SCALE, rgba, width, height, NULL) >= 0) {
        fill_mask(mask, rgba, width, height);
        cairo_set_source_rgb(cairo, color[0], color[1], color[2]);
        cairo_mask_surface(cairo, mask, (int)x, (int)y - height + BELOW * SCALE);
    }
    free(rgba);
    cairo_surface_destroy(mask);
}
