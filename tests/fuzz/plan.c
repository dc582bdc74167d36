/* Any dome: the plan is refused in one line, or every view of it is one that can be drawn. */
#include "cupola/plan.h"
#include "rig_values.h"
#include "target.h"

static void require_view(const cupola_plan *plan, int index, int guard_px)
{
    const struct cupola_plan_report *report = cupola_plan_report(plan);
    const struct cupola_view *view = cupola_plan_view(plan, index);
    struct cupola_camera camera;
    for (int i = 0; i < 3; i++)
        require(is_unit(view->rotation + 3 * i));
    require(is_finite3(view->selector));
    require(view->left < view->right && view->bottom < view->top);
    require(isfinite(view->left) && isfinite(view->right) && isfinite(view->bottom) &&
            isfinite(view->top));
    require(view->rect.x >= 0 && view->rect.width > 2 * guard_px &&
            view->rect.x + view->rect.width <= report->atlas_width_px);
    require(view->rect.y >= 0 && view->rect.height > 2 * guard_px &&
            view->rect.y + view->rect.height <= report->atlas_height_px);
    require(cupola_plan_camera(plan, index, NULL, &camera, NULL) == CUPOLA_OK);
    for (int i = 0; i < 16; i++)
        require(isfinite(camera.view[i]) && isfinite(camera.projection[i]));
}

/* Lit pixels find their texels in the view that they fall to. */
static void require_texels(const cupola_plan *plan)
{
    const struct cupola_rig *rig = cupola_dome_rig(cupola_plan_dome(plan));
    for (int output = 0; output < rig->output_count; output++)
        for (int y = 0; y < rig->outputs[output].height_px; y++)
            for (int x = 0; x < rig->outputs[output].width_px; x++) {
                struct cupola_ray ray;
                double texel[2];
                if (!cupola_dome_ray(cupola_plan_dome(plan), output, NULL, x + 0.5, y + 0.5, &ray))
                    continue;
                int index = cupola_plan_select(plan, ray.direction);
                require(index >= 0 && index < cupola_plan_view_count(plan));
                if (cupola_plan_texel(plan, index, ray.direction, texel))
                    require(isfinite(texel[0]) && isfinite(texel[1]));
            }
}

static void require_plan(const cupola_dome *dome, struct values *values)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_plan_params params = {
        .layout = (enum cupola_layout)(take_byte(values) % 4),
        .views = take_byte(values) % (CUPOLA_VIEWS_MAX + 2),
        .density = fabs(take_double(values, 1)),
        .guard_px = take_byte(values) % 4,
        .max_texture_px = 512,
    };
    cupola_plan *plan = NULL;
    int status = cupola_plan_create(dome, &params, &plan, &error);
    if (status != CUPOLA_OK) {
        require_message(&error, status);
        require(status != CUPOLA_ERROR_MEMORY && plan == NULL);
        return;
    }
    const struct cupola_plan_report *report = cupola_plan_report(plan);
    require(report->views == cupola_plan_view_count(plan) && report->views >= 1);
    require(isfinite(report->pixels) && report->pixels > 0);
    require(isfinite(report->texels_sampled_per_pixel));
    require(isfinite(report->least_texels_per_pixel) && report->seen_fov_rad >= 0);
    for (int i = 0; i < report->views; i++)
        require_view(plan, i, params.guard_px ? params.guard_px : 2);
    require_texels(plan);
    cupola_plan_destroy(&plan);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    /* The cost of a plan goes with its pixels. */
    enum { SIDE_MAX_PX = 12 };
    struct values values = {data, size};
    struct cupola_rig rig = take_rig(&values, SIDE_MAX_PX);
    cupola_dome *dome = NULL;
    if (cupola_dome_create(&rig, &dome, NULL) != CUPOLA_OK)
        return 0;
    require_plan(dome, &values);
    cupola_dome_destroy(&dome);
    return 0;
}
