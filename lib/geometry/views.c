/* Which view a ray falls to and where it meets it. */
#include "views.h"

#include "vector.h"

int view_select(const struct cupola_view *views, int count, const double ray[3])
{
    int selected = 0;
    double most = dot3(views[0].selector, ray);
    for (int i = 1; i < count; i++) {
        double product = dot3(views[i].selector, ray);
        if (product > most) {
            most = product;
            selected = i;
        }
    }
    return selected;
}

bool view_hit(const struct cupola_view *view, const double ray[3], double base[2])
{
    double q[3];
    transform3(view->rotation, ray, q);
    if (!(q[2] < 0))
        return false;
    base[0] = q[0] / -q[2];
    base[1] = q[1] / -q[2];
    return true;
}

void view_base(const struct cupola_view *view, double base[4])
{
    base[0] = view->left;
    base[1] = view->bottom;
    base[2] = view->right - view->left;
    base[3] = view->top - view->bottom;
}

void view_share(const struct cupola_view *view, const struct cupola_plan_report *report,
                double share[4])
{
    share[0] = (double)view->rect.x / report->atlas_width_px;
    share[1] = (double)view->rect.y / report->atlas_height_px;
    share[2] = (double)view->rect.width / report->atlas_width_px;
    share[3] = (double)view->rect.height / report->atlas_height_px;
}

void view_texel(const struct cupola_view *view, const double base[2], double texel[2])
{
    double u = (base[0] - view->left) / (view->right - view->left);
    double v = (base[1] - view->bottom) / (view->top - view->bottom);
    texel[0] = view->rect.x + u * view->rect.width;
    texel[1] = view->rect.y + v * view->rect.height;
}
