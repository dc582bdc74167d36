/*
 * The views' places in one texture. There are so few of them that every sensible place can be
 * tried: the highest first, each as low and then as far left as it can lie, in strips of many
 * widths.
 */
#include <math.h>
#include <stdbool.h>

#include "error.h"
#include "plan.h"

static bool overlap(const struct cupola_rect *a, const struct cupola_rect *b)
{
    return a->x < b->x + b->width && b->x < a->x + a->width && a->y < b->y + b->height &&
           b->y < a->y + a->height;
}

static bool is_free(const struct cupola_rect *rect, const struct cupola_rect *placed, int count)
{
    for (int i = 0; i < count; i++)
        if (overlap(rect, &placed[i]))
            return false;
    return true;
}

/*
 * Puts one rectangle beside those that lie already. A lowest place has its left side and its bottom
 * at the strip's or at another rectangle's side; index `count` stands for the strip's.
 */
static bool place_rect(struct cupola_rect *rect, const struct cupola_rect *placed, int count,
                       int width_px)
{
    struct cupola_rect best = {.x = -1};
    for (int across = 0; across <= count; across++)
        for (int up = 0; up <= count; up++) {
            struct cupola_rect here = *rect;
            here.x = across < count ? placed[across].x + placed[across].width : 0;
            here.y = up < count ? placed[up].y + placed[up].height : 0;
            bool better = best.x < 0 || here.y < best.y || (here.y == best.y && here.x < best.x);
            if (better && here.x <= width_px - here.width && is_free(&here, placed, count))
                best = here;
        }
    *rect = best;
    return best.x >= 0;
}

/* Packs into a strip; `order` says which view comes when. Returns the height used. */
static double pack_strip(const struct cupola_view *views, const int *order, int count, int width_px,
                         struct cupola_rect placed[CUPOLA_VIEWS_MAX])
{
    double height = 0;
    for (int i = 0; i < count; i++) {
        placed[i] = views[order[i]].rect;
        if (!place_rect(&placed[i], placed, i, width_px))
            return HUGE_VAL;
        height = fmax(height, (double)placed[i].y + placed[i].height);
    }
    return height;
}

static void order_by_height(const struct cupola_view *views, int count, int *order)
{
    for (int i = 0; i < count; i++) {
        int place = i;
        while (place > 0 && views[order[place - 1]].rect.height < views[i].rect.height) {
            order[place] = order[place - 1];
            place--;
        }
        order[place] = i;
    }
}

int plan_atlas_pack(struct cupola_view *views, int count, int max_px, int *width_px, int *height_px,
                    struct cupola_error *error)
{
    enum { WIDTHS = 64 };
    int order[CUPOLA_VIEWS_MAX];
    double widest = 0, total = 0, best_area = HUGE_VAL;
    order_by_height(views, count, order);
    for (int v = 0; v < count; v++) {
        widest = fmax(widest, views[v].rect.width);
        total += views[v].rect.width;
    }
    for (int i = 0; i <= WIDTHS; i++) {
        struct cupola_rect placed[CUPOLA_VIEWS_MAX];
        double width = ceil(widest + (total - widest) * i / WIDTHS);
        if (width > max_px)
            break;
        double height = pack_strip(views, order, count, (int)width, placed);
        if (height > max_px || width * height >= best_area)
            continue;
        best_area = width * height;
        *width_px = (int)width;
        *height_px = (int)height;
        for (int k = 0; k < count; k++)
            views[order[k]].rect = placed[k];
    }
    if (best_area < HUGE_VAL)
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_ARGUMENT,
                     "%d views, the widest of them %.0f texels, do not fit into an atlas of %d x "
                     "%d texels; allowed: a lower density, a smaller view size or a smaller output",
                     count, widest, max_px, max_px);
}
