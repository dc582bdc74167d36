/* The views' places in one texture, by stb_rect_pack's skyline. */
#include <math.h>
#include <string.h>

#include "error.h"
#include "plan.h"

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wshadow"
#endif
#define STBRP_STATIC
#define STB_RECT_PACK_IMPLEMENTATION
#include <stb_rect_pack.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

/* Packs into a strip of the given width. Returns the height used. */
static int pack_strip(const struct cupola_view *views, int count, int width_px, int height_px,
                      stbrp_rect rects[CUPOLA_VIEWS_MAX])
{
    enum { NODES = 512 };
    stbrp_context context;
    stbrp_node nodes[NODES];
    for (int v = 0; v < count; v++)
        rects[v] = (stbrp_rect){.id = v, .w = views[v].rect.width, .h = views[v].rect.height};
    stbrp_init_target(&context, width_px, height_px, nodes, NODES);
    stbrp_setup_allow_out_of_mem(&context, 1);
    if (!stbrp_pack_rects(&context, rects, count))
        return 0;
    int used = 0;
    for (int v = 0; v < count; v++)
        if (rects[v].y + rects[v].h > used)
            used = rects[v].y + rects[v].h;
    return used;
}

int plan_atlas_pack(struct cupola_view *views, int count, int max_px, int *width_px, int *height_px,
                    struct cupola_error *error)
{
    enum { WIDTHS = 64 };
    int widest = 0;
    double total = 0, best_area = HUGE_VAL;
    for (int v = 0; v < count; v++) {
        if (views[v].rect.width > widest)
            widest = views[v].rect.width;
        total += views[v].rect.width;
    }
    for (int i = 0; i <= WIDTHS; i++) {
        stbrp_rect rects[CUPOLA_VIEWS_MAX];
        double width = ceil(widest + (total - widest) * i / WIDTHS);
        if (width > max_px)
            break;
        int height = pack_strip(views, count, (int)width, max_px, rects);
        if (height == 0 || width * height >= best_area)
            continue;
        best_area = width * height;
        *width_px = (int)width;
        *height_px = height;
        for (int v = 0; v < count; v++) {
            views[rects[v].id].rect.x = rects[v].x;
            views[rects[v].id].rect.y = rects[v].y;
        }
    }
    if (best_area < HUGE_VAL)
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_ARGUMENT,
                     "%d views, the widest of them %d texels, do not fit into an atlas of %d x %d "
                     "texels; allowed: a lower density, a smaller view size or a smaller output",
                     count, widest, max_px, max_px);
}
