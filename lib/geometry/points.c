/* Points and rays of one output. Derivatives are analytic and go along step by step. */
#include "points.h"

#include "vector.h"

void projector_prepare(const struct cupola_output *output, const struct cupola_screen *screen,
                       struct projector *projector)
{
    *projector = (struct projector){
        .width_px = output->width_px,
        .height_px = output->height_px,
        .center_px = {output->circle.center_x_px, output->circle.center_y_px},
        .radius_px = output->circle.radius_px,
        .sign = {output->flip & CUPOLA_FLIP_X ? -1 : 1, output->flip & CUPOLA_FLIP_Y ? -1 : 1},
        .screen_radius_m = screen->radius_m,
        .cap_cosine = cos(screen->cap_rad),
        .capped = screen->cap_rad < pi - angle_slack,
    };
    memcpy(projector->position_m, output->position_m, sizeof projector->position_m);
    double yaw[9], pitch[9], roll[9];
    rotation_y(output->aim.yaw_rad, yaw);
    rotation_x(output->aim.pitch_rad, pitch);
    rotation_z(output->aim.roll_rad, roll);
    multiply3(pitch, roll, projector->aim);
    multiply3(yaw, projector->aim, projector->aim);
    lens_prepare(&output->lens, &projector->lens, NULL);
}

double circle_place(const struct projector *projector, double x_px, double y_px, double place[2])
{
    double x = projector->sign[0] * (x_px - projector->center_px[0]) / projector->radius_px;
    double y = projector->sign[1] * (y_px - projector->center_px[1]) / projector->radius_px;
    /* Places absurdly far away lie beyond the rim all the same. */
    x = fmin(fmax(x, -1e150), 1e150);
    y = fmin(fmax(y, -1e150), 1e150);
    double r = hypot(x, y);
    double onto_rim = r > 1 ? 1 / r : 1;
    place[0] = onto_rim * x;
    place[1] = onto_rim * y;
    return r;
}

/*
 * With s = sin(angle) / r the ray is (x s, y s, -cos(angle)). Its derivatives by x and y need
 * ds/dr / r = (cos(angle) angle' - s) / r^2, whose limit at r = 0 stands in products with x and y
 * only and so drops out there.
 */
void lens_ray(const struct projector *projector, const double place[2], struct varying *ray)
{
    double x = place[0], y = place[1];
    double r = fmin(hypot(x, y), 1);
    double angle = lens_angle(&projector->lens, r);
    double slope = lens_angle_slope(&projector->lens, r, angle);
    double s = r > 1e-9 ? sin(angle) / r : slope;
    double bend = r > 1e-5 ? (cos(angle) * slope - s) / (r * r) : 0;
    struct varying lens_frame = {
        .at = {x * s, y * s, -cos(angle)},
        .dx = {s + x * x * bend, x * y * bend, x * s * slope},
        .dy = {x * y * bend, s + y * y * bend, y * s * slope},
    };
    /* Measured lenses may be so steep at the axis that the tangent is no arc even there. */
    if (!(r > 1e-9))
        scale3(lens_frame.at, 1 / length3(lens_frame.at));
    scale3(lens_frame.dx, projector->sign[0] / projector->radius_px);
    scale3(lens_frame.dy, projector->sign[1] / projector->radius_px);
    transform3(projector->aim, lens_frame.at, ray->at);
    transform3(projector->aim, lens_frame.dx, ray->dx);
    transform3(projector->aim, lens_frame.dy, ray->dy);
}

void screen_point(const struct projector *projector, const struct varying *ray,
                  struct varying *point)
{
    const double *position = projector->position_m;
    double along = dot3(position, ray->at);
    double root = sqrt(along * along - dot3(position, position) +
                       projector->screen_radius_m * projector->screen_radius_m);
    double t = root - along;
    double dt_dx = dot3(position, ray->dx) * (along / root - 1);
    double dt_dy = dot3(position, ray->dy) * (along / root - 1);
    for (int i = 0; i < 3; i++) {
        point->at[i] = position[i] + t * ray->at[i];
        point->dx[i] = dt_dx * ray->at[i] + t * ray->dx[i];
        point->dy[i] = dt_dy * ray->at[i] + t * ray->dy[i];
    }
}

/*
 * The distance of the square's points from its centre, measured along the normal, is the sum of two
 * uniform variables of widths a and b; their distribution function is the area.
 */
double edge_coverage(double distance_px, double normal_x, double normal_y)
{
    double length = hypot(normal_x, normal_y);
    if (!(length > 0))
        return distance_px > 0 ? 1 : 0;
    double a = fmax(fabs(normal_x), fabs(normal_y)) / length;
    double b = fmax(fmin(fabs(normal_x), fabs(normal_y)) / length, 0.01);
    if (distance_px >= 0.5 * (a + b))
        return 1; /* to the last bit: squares cancel below */
    double ends[4] = {0.5 * (a + b), 0.5 * (a - b), 0.5 * (b - a), -0.5 * (a + b)};
    double signs[4] = {1, -1, -1, 1};
    double area = 0;
    for (int i = 0; i < 4; i++) {
        double ramp = fmax(distance_px + ends[i], 0);
        area += signs[i] * ramp * ramp;
    }
    return fmin(fmax(area / (2 * a * b), 0), 1);
}

bool place_inside_rim(const struct projector *projector, double x_px, double y_px, double place[2])
{
    double most = fmax(1 - 0.5 / projector->radius_px, 0);
    double r = fmin(circle_place(projector, x_px, y_px, place), 1);
    if (!(r > most))
        return false;
    place[0] *= most / r;
    place[1] *= most / r;
    return true;
}

void point_inside_rim(const struct projector *projector, double x_px, double y_px,
                      const struct varying *point, struct varying *inside)
{
    struct varying ray;
    double place[2];
    *inside = *point;
    if (place_inside_rim(projector, x_px, y_px, place)) {
        lens_ray(projector, place, &ray);
        screen_point(projector, &ray, inside);
    }
}

/*
 * The screen's depth, -D.z / R, per pixel. At the rim of a hemispheric lens of 180 degrees it is
 * infinite, and a pixel there would be lit by half however far its point lies beyond the cap.
 */
static void depth_gradient(const struct projector *projector, double x_px, double y_px,
                           const struct varying *point, double gradient[2])
{
    struct varying inside;
    point_inside_rim(projector, x_px, y_px, point, &inside);
    gradient[0] = -inside.dx[2] / projector->screen_radius_m;
    gradient[1] = -inside.dy[2] / projector->screen_radius_m;
}

double pixel_coverage(const struct projector *projector, double x_px, double y_px,
                      const struct varying *point)
{
    double across = fmin(x_px + 0.5, projector->width_px) - fmax(x_px - 0.5, 0);
    double up = fmin(y_px + 0.5, projector->height_px) - fmax(y_px - 0.5, 0);
    double framed = fmax(across, 0) * fmax(up, 0);
    double x = x_px - projector->center_px[0], y = y_px - projector->center_px[1];
    double rim = edge_coverage(projector->radius_px - hypot(x, y), x, y);
    if (!projector->capped)
        return framed * rim;
    /* Inside of the cap is where -D.z / R lies above its cosine. Where both edges coincide, as for
     * a centred projector, the pixel is cut once: the smaller part counts, not the product. */
    double gradient[2];
    depth_gradient(projector, x_px, y_px, point, gradient);
    double excess = -point->at[2] / projector->screen_radius_m - projector->cap_cosine;
    double steepness = hypot(gradient[0], gradient[1]);
    double distance = excess / fmax(steepness, 1e-12);
    return framed * fmin(rim, edge_coverage(distance, gradient[0], gradient[1]));
}

double lens_place(const struct projector *projector, const double direction[3], double pixel_px[2])
{
    double v[3];
    transform3_back(projector->aim, direction, v);
    double across = hypot(v[0], v[1]);
    double angle = atan2(across, -v[2]);
    double r = lens_radius(&projector->lens, fmin(angle, projector->lens.half_fov));
    double factor = across > 0 ? r * projector->radius_px / across : 0;
    for (int i = 0; i < 2; i++)
        pixel_px[i] = projector->center_px[i] + projector->sign[i] * factor * v[i];
    return angle - projector->lens.half_fov;
}

bool lens_pixel(const struct projector *projector, const double direction[3], double pixel_px[2])
{
    const double slack = 1e-9; /* a pixel's own ray comes back, also on the rim */
    return lens_place(projector, direction, pixel_px) <= slack;
}
