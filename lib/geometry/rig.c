/* Rigs: checks, defaults and resizing. */
#include "cupola/rig.h"

#include <math.h>
#include <stdbool.h>

#include "error.h"
#include "lens.h"
#include "vector.h"

enum { SIZE_DEFAULT_PX = 1024, SIZE_MAX_PX = 32768 };

/* Below these, squares and products of them are no numbers of their own. */
static const double radius_min_m = 1e-6, circle_min_px = 1e-6;
static const double radius_max_m = 1000;
static const double circle_max_px = 1e6;
static const double units_max = 1e9;

static int check_size(const char *name, int size_px, struct cupola_error *error)
{
    if (size_px >= 1 && size_px <= SIZE_MAX_PX)
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is %d px; allowed: 1 to %d", name, size_px,
                     (int)SIZE_MAX_PX);
}

static int check_angle(const char *name, double angle_rad, double limit_rad,
                       struct cupola_error *error)
{
    if (fabs(angle_rad) <= limit_rad + angle_slack)
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_ARGUMENT,
                     "%s is %g rad (%g degrees); allowed: -%g to %g rad (-%g to %g degrees)", name,
                     RAD_AND_DEG(angle_rad), limit_rad, limit_rad, limit_rad * 180 / pi,
                     limit_rad * 180 / pi);
}

static int check_inside(const char *name, const double position_m[3], double radius_m,
                        struct cupola_error *error)
{
    if (length3(position_m) < radius_m)
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_ARGUMENT,
                     "%s is (%g, %g, %g) m; allowed: inside of the screen sphere, less than %g m "
                     "from its centre",
                     name, position_m[0], position_m[1], position_m[2], radius_m);
}

static void fit_circle(struct cupola_output *output)
{
    if (output->circle.radius_px != 0)
        return;
    double smaller = fmin(output->width_px, output->height_px);
    output->circle = (struct cupola_circle){
        .center_x_px = 0.5 * output->width_px,
        .center_y_px = 0.5 * output->height_px,
        .radius_px = 0.5 * smaller,
    };
}

static void fill_in_size(struct cupola_output *output)
{
    if (output->width_px == 0)
        output->width_px = SIZE_DEFAULT_PX;
    if (output->height_px == 0)
        output->height_px = SIZE_DEFAULT_PX;
    fit_circle(output);
}

static int check_circle(const struct cupola_output *output, struct cupola_error *error)
{
    struct cupola_circle circle = output->circle;
    if (!(circle.radius_px >= circle_min_px && circle.radius_px <= circle_max_px))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "image circle's radius is %g px; allowed: %g to %g", circle.radius_px,
                         circle_min_px, circle_max_px);
    /* The nearest place of the frame buffer to the circle's centre. */
    double x = fmin(fmax(circle.center_x_px, 0), output->width_px);
    double y = fmin(fmax(circle.center_y_px, 0), output->height_px);
    if (!(hypot(circle.center_x_px - x, circle.center_y_px - y) < circle.radius_px))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "image circle with centre (%g, %g) px and radius %g px lies outside of "
                         "the frame buffer; allowed: one that meets 0 to %d by 0 to %d px",
                         circle.center_x_px, circle.center_y_px, circle.radius_px, output->width_px,
                         output->height_px);
    return CUPOLA_OK;
}

static int complete_output(struct cupola_output *output, double screen_radius_m,
                           struct cupola_error *error)
{
    struct lens lens;
    int status;
    fill_in_size(output);
    if ((status = check_size("width", output->width_px, error)) != CUPOLA_OK ||
        (status = check_size("height", output->height_px, error)) != CUPOLA_OK ||
        (status = check_circle(output, error)) != CUPOLA_OK ||
        (status = lens_prepare(&output->lens, &lens, error)) != CUPOLA_OK ||
        (status = check_inside("projector's position", output->position_m, screen_radius_m,
                               error)) != CUPOLA_OK ||
        (status = check_angle("projector's yaw", output->aim.yaw_rad, 2 * pi, error)) !=
            CUPOLA_OK ||
        (status = check_angle("projector's pitch", output->aim.pitch_rad, 2 * pi, error)) !=
            CUPOLA_OK ||
        (status = check_angle("projector's roll", output->aim.roll_rad, 2 * pi, error)) !=
            CUPOLA_OK)
        return status;
    if (output->flip < 0 || output->flip > (CUPOLA_FLIP_X | CUPOLA_FLIP_Y))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "flip is %d; allowed: 0 (none), 1 (x), 2 (y), 3 (x and y)", output->flip);
    output->lens.fov_rad = 2 * lens.half_fov;
    return CUPOLA_OK;
}

static int complete_theatre(struct cupola_rig *rig, struct cupola_error *error)
{
    int status;
    if (rig->screen.radius_m == 0)
        rig->screen.radius_m = 1;
    if (rig->screen.cap_rad == 0)
        rig->screen.cap_rad = pi;
    if (rig->units_per_metre == 0)
        rig->units_per_metre = 1;
    if (rig->output_count == 0)
        rig->output_count = 1;
    if (!(rig->screen.radius_m >= radius_min_m && rig->screen.radius_m <= radius_max_m))
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "screen's radius is %g m; allowed: %g to %g",
                         rig->screen.radius_m, radius_min_m, radius_max_m);
    if (!(rig->screen.cap_rad > 0 && rig->screen.cap_rad <= pi + angle_slack))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "screen's cap is %g rad (%g degrees); allowed: above 0 and up to %g rad "
                         "(180 degrees)",
                         RAD_AND_DEG(rig->screen.cap_rad), pi);
    if (!(rig->units_per_metre > 0 && rig->units_per_metre <= units_max))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "scene units per metre are %g; allowed: above 0 and up to %g",
                         rig->units_per_metre, units_max);
    if (rig->output_count < 1 || rig->output_count > CUPOLA_OUTPUTS_MAX)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "number of outputs is %d; allowed: 1 to %d",
                         rig->output_count, CUPOLA_OUTPUTS_MAX);
    status = check_inside("eye", rig->eye_m, rig->screen.radius_m, error);
    return status == CUPOLA_OK ? check_angle("tilt", rig->tilt_rad, pi, error) : status;
}

int cupola_rig_complete(const struct cupola_rig *rig, struct cupola_rig *complete,
                        struct cupola_error *error)
{
    if (!rig)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "rig is NULL; allowed: a rig");
    struct cupola_rig filled = *rig;
    int status = complete_theatre(&filled, error);
    for (int i = 0; status == CUPOLA_OK && i < filled.output_count; i++) {
        status = complete_output(&filled.outputs[i], filled.screen.radius_m, error);
        if (status != CUPOLA_OK && filled.output_count > 1)
            error_context(error, "output %d", i);
    }
    if (status == CUPOLA_OK && complete)
        *complete = filled;
    return status;
}

int cupola_output_resize(struct cupola_output *output, int width_px, int height_px,
                         struct cupola_error *error)
{
    int status;
    if (!output)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "output is NULL; allowed: an output");
    if ((status = check_size("width", width_px, error)) != CUPOLA_OK ||
        (status = check_size("height", height_px, error)) != CUPOLA_OK)
        return status;
    struct cupola_output known = *output;
    fill_in_size(&known);
    if ((status = check_size("width so far", known.width_px, error)) != CUPOLA_OK ||
        (status = check_size("height so far", known.height_px, error)) != CUPOLA_OK)
        return status;
    *output = known;
    double scale = fmin((double)width_px / output->width_px, (double)height_px / output->height_px);
    struct cupola_circle *circle = &output->circle;
    circle->center_x_px = 0.5 * width_px + scale * (circle->center_x_px - 0.5 * output->width_px);
    circle->center_y_px = 0.5 * height_px + scale * (circle->center_y_px - 0.5 * output->height_px);
    circle->radius_px *= scale;
    output->width_px = width_px;
    output->height_px = height_px;
    return CUPOLA_OK;
}
