/* Overlays: the picture's plane, and how much of a pixel lies in it. */
#include "overlay.h"

#include "error.h"
#include "vector.h"

static const double width_max = 5 * 3.14159265358979323846 / 6;

static int check_angle(const char *name, double angle, bool zero, struct cupola_error *error)
{
    if ((angle > 0 && angle <= width_max + angle_slack) || (zero && angle == 0))
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_ARGUMENT,
                     "%s is %g rad (%g degrees); allowed: %sabove 0 and up to %g rad (150 degrees)",
                     name, RAD_AND_DEG(angle), zero ? "0, or " : "", width_max);
}

static int check_direction(const double v[3], struct cupola_error *error)
{
    bool finite = isfinite(v[0]) && isfinite(v[1]) && isfinite(v[2]);
    if (finite && (v[0] != 0 || v[1] != 0 || v[2] != 0))
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_ARGUMENT,
                     "direction is (%g, %g, %g); allowed: finite numbers, not all of them 0", v[0],
                     v[1], v[2]);
}

static int check_color(const float *color, struct cupola_error *error)
{
    for (int i = 0; color && i < 4; i++) {
        double value = (double)color[i];
        if (!(value >= 0 && isfinite(value) && (i < 3 || value <= 1)))
            return error_set(error, CUPOLA_ERROR_ARGUMENT, "color[%d] is %g; allowed: %s", i, value,
                             i < 3 ? "0 or more" : "0 to 1");
    }
    return CUPOLA_OK;
}

int overlay_check(const struct cupola_overlay *overlay, struct cupola_error *error)
{
    if (overlay->kind < CUPOLA_OVERLAY_PICTURE || overlay->kind > CUPOLA_OVERLAY_DISC)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "kind is %d; allowed: 0 to %d",
                         (int)overlay->kind, OVERLAY_KINDS - 1);
    int status = check_direction(overlay->direction, error);
    if (status == CUPOLA_OK)
        status = check_angle("width", overlay->width_rad, false, error);
    if (status == CUPOLA_OK)
        status = check_angle("height", overlay->height_rad, true, error);
    if (status == CUPOLA_OK)
        status = check_color(overlay->color, error);
    if (status != CUPOLA_OK)
        return status;
    if (!(fabs(overlay->roll_rad) <= 2 * pi + angle_slack))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "roll is %g rad (%g degrees); allowed: -%g to %g rad",
                         RAD_AND_DEG(overlay->roll_rad), 2 * pi, 2 * pi);
    return CUPOLA_OK;
}

int overlay_check_height(const struct cupola_overlay *overlay, int width, int height,
                         struct cupola_error *error)
{
    double angle = 2 * atan(tan(0.5 * overlay->width_rad) * height / width);
    if (overlay->kind != CUPOLA_OVERLAY_PICTURE || overlay->height_rad > 0 ||
        angle <= width_max + angle_slack)
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_ARGUMENT,
                     "height is 0, which at the width of %g rad makes a picture of %d x %d texels "
                     "%g rad (%g degrees) high; allowed: up to %g rad (150 degrees)",
                     overlay->width_rad, width, height, RAD_AND_DEG(angle), width_max);
}

/* Unit length, also of vectors whose squares are no numbers of their own. */
static void unit_of(const double v[3], double unit[3])
{
    double largest = fmax(fmax(fabs(v[0]), fabs(v[1])), fabs(v[2]));
    for (int i = 0; i < 3; i++)
        unit[i] = v[i] / largest;
    scale3(unit, 1 / length3(unit));
}

/* Right is level. Straight up or down it is as if one had looked there from straight ahead. */
static void set_axes(const double forward[3], double roll_rad, double axes[9])
{
    double level = hypot(forward[0], forward[2]);
    double right[3] = {1, 0, 0}, up[3];
    if (level > 1e-6) {
        right[0] = -forward[2] / level;
        right[2] = forward[0] / level;
    }
    cross3(right, forward, up);
    scale3(up, 1 / length3(up));
    double c = cos(roll_rad), s = sin(roll_rad);
    for (int i = 0; i < 3; i++) {
        axes[i] = c * right[i] + s * up[i];
        axes[3 + i] = c * up[i] - s * right[i];
        axes[6 + i] = forward[i];
    }
}

void overlay_frame_prepare(const struct cupola_overlay *overlay, double aspect,
                           struct overlay_frame *frame)
{
    double forward[3], most = tan(0.5 * width_max);
    unit_of(overlay->direction, forward);
    set_axes(forward, overlay->roll_rad, frame->axes);
    frame->half[0] = tan(0.5 * overlay->width_rad);
    if (overlay->height_rad > 0)
        frame->half[1] = tan(0.5 * overlay->height_rad);
    else if (overlay->kind != CUPOLA_OVERLAY_PICTURE)
        frame->half[1] = frame->half[0];
    else
        frame->half[1] = aspect > 0 ? fmin(frame->half[0] / aspect, most) : most;
}

void overlay_color(const struct cupola_overlay *overlay, float premultiplied[4])
{
    const float *color = overlay->color;
    for (int i = 0; i < 3; i++)
        premultiplied[i] = color ? color[i] * color[3] : 1;
    premultiplied[3] = color ? color[3] : 1;
}

void overlay_direction(const struct overlay_frame *frame, const struct varying *ray,
                       struct varying *direction)
{
    transform3(frame->axes, ray->at, direction->at);
    transform3(frame->axes, ray->dx, direction->dx);
    transform3(frame->axes, ray->dy, direction->dy);
    for (int i = 0; i < 2; i++) {
        direction->at[i] /= frame->half[i];
        direction->dx[i] /= frame->half[i];
        direction->dy[i] /= frame->half[i];
    }
}

void overlay_place(const struct varying *direction, double place[2])
{
    for (int i = 0; i < 2; i++)
        place[i] = 0.5 + 0.5 * direction->at[i] / direction->at[2];
}

/* The part of the pixel where the product of the direction with a normal is above 0. */
static double plane_coverage(const struct varying *direction, const double normal[3])
{
    double dx = dot3(normal, direction->dx), dy = dot3(normal, direction->dy);
    return edge_coverage(dot3(normal, direction->at) / fmax(hypot(dx, dy), 1e-12), dx, dy);
}

/* Between two opposite edges: exact also where both run through the pixel. */
static double slab_coverage(const struct varying *direction, int axis)
{
    double low[3] = {0, 0, 1}, high[3] = {0, 0, 1};
    low[axis] = 1;
    high[axis] = -1;
    return fmax(plane_coverage(direction, low) + plane_coverage(direction, high) - 1, 0);
}

/* Inside of the cone of a radius, by the plane that touches it where the direction is nearest. */
static double ellipse_coverage(const struct varying *direction, double radius)
{
    double r = hypot(direction->at[0], direction->at[1]);
    const double normal[3] = {r > 0 ? -direction->at[0] / r : -1, r > 0 ? -direction->at[1] / r : 0,
                              radius};
    return plane_coverage(direction, normal);
}

static double round_coverage(enum cupola_overlay_kind kind, const struct varying *direction)
{
    double disc = ellipse_coverage(direction, 1);
    if (kind == CUPOLA_OVERLAY_DISC)
        return disc;
    double hole = ellipse_coverage(direction, OVERLAY_RING_INNER);
    return fmin(fmax(disc - hole, 0) + ellipse_coverage(direction, OVERLAY_DOT_RADIUS), 1);
}

/* Round ones in parts of the pixel: a straight edge is a poor likeness of a small circle. */
double overlay_coverage(enum cupola_overlay_kind kind, const struct varying *direction)
{
    enum { PARTS = OVERLAY_PARTS };
    if (!(direction->at[2] > 0))
        return 0;
    if (kind == CUPOLA_OVERLAY_PICTURE)
        return slab_coverage(direction, 0) * slab_coverage(direction, 1);
    double sum = 0;
    for (int part = 0; part < PARTS * PARTS; part++) {
        struct varying small;
        double x = (part % PARTS + 0.5) / PARTS - 0.5,
               y = ((int)(part / PARTS) + 0.5) / PARTS - 0.5;
        for (int i = 0; i < 3; i++) {
            small.at[i] = direction->at[i] + x * direction->dx[i] + y * direction->dy[i];
            small.dx[i] = direction->dx[i] / PARTS;
            small.dy[i] = direction->dy[i] / PARTS;
        }
        sum += round_coverage(kind, &small);
    }
    return sum / (PARTS * PARTS);
}
