/* How many rays a pixel sends out, and where to. */
#include "filter.h"

#include "angle.h"
#include "error.h"
#include "names.h"
#include "plan.h"
#include "vector.h"
#include "views.h"

static const char *const method_names[] = {
    [CUPOLA_ANTIALIASING_TEXTURE] = "texture",     [CUPOLA_ANTIALIASING_NONE] = "none",
    [CUPOLA_ANTIALIASING_CONE] = "cone",           [CUPOLA_ANTIALIASING_ADAPTIVE] = "adaptive",
    [CUPOLA_ANTIALIASING_FOOTPRINT] = "footprint",
};

static const char *const pattern_names[] = {
    [CUPOLA_PATTERN_REGULAR] = "regular",
    [CUPOLA_PATTERN_ROTATED_GRID] = "rotated-grid",
    [CUPOLA_PATTERN_BLUE_NOISE] = "blue-noise",
};

enum {
    METHOD_COUNT = sizeof method_names / sizeof method_names[0],
    PATTERN_COUNT = sizeof pattern_names / sizeof pattern_names[0],
};

const char *cupola_antialiasing_name(int method)
{
    return name_of_number(method_names, METHOD_COUNT, method);
}

int cupola_antialiasing_find(const char *name)
{
    return number_of_name(method_names, METHOD_COUNT, name);
}

const char *cupola_pattern_name(int pattern)
{
    return name_of_number(pattern_names, PATTERN_COUNT, pattern);
}

int cupola_pattern_find(const char *name)
{
    return number_of_name(pattern_names, PATTERN_COUNT, name);
}

static int check_samples(const struct cupola_filter *filter, struct cupola_error *error)
{
    int samples = filter->samples;
    if (samples == 0)
        return CUPOLA_OK;
    if (filter->method == CUPOLA_ANTIALIASING_TEXTURE && samples != 4 && samples != 9)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "samples of texture are %d; allowed: 4 or 9",
                         samples);
    if (filter->method == CUPOLA_ANTIALIASING_NONE && samples != 1)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "samples of none are %d; allowed: 1",
                         samples);
    if (samples < 0 || samples > CUPOLA_RAYS_MAX)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "samples of %s are %d; allowed: 1 to %d",
                         method_names[filter->method], samples, CUPOLA_RAYS_MAX);
    return CUPOLA_OK;
}

int filter_check(const struct cupola_filter *filter, struct cupola_filter *complete,
                 struct cupola_error *error)
{
    static const struct cupola_filter usual = {0};
    filter = filter ? filter : &usual;
    if (!cupola_antialiasing_name((int)filter->method))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "method of antialiasing is %d; allowed: 0 to %d", (int)filter->method,
                         METHOD_COUNT - 1);
    if (!cupola_pattern_name((int)filter->pattern))
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "pattern of rays is %d; allowed: 0 to %d",
                         (int)filter->pattern, PATTERN_COUNT - 1);
    int status = check_samples(filter, error);
    if (status != CUPOLA_OK)
        return status;
    *complete = *filter;
    if (complete->samples == 0)
        complete->samples = filter->method == CUPOLA_ANTIALIASING_NONE ? 1 : 4;
    return CUPOLA_OK;
}

void filter_cone(const struct varying *ray, double cone[3])
{
    double square = dot3(ray->at, ray->at), wx[3], wy[3];
    double along_x = dot3(ray->at, ray->dx) / square, along_y = dot3(ray->at, ray->dy) / square;
    for (int i = 0; i < 3; i++) {
        wx[i] = ray->dx[i] - along_x * ray->at[i];
        wy[i] = ray->dy[i] - along_y * ray->at[i];
    }
    double xx = dot3(wx, wx), xy = dot3(wx, wy), yy = dot3(wy, wy);
    double root = sqrt(fmax(xx * yy - xy * xy, 0)), length = sqrt(xx);
    double radius = sqrt(root / pi);
    if (!(root > 0)) {
        cone[0] = cone[1] = cone[2] = 0;
        return;
    }
    cone[0] = radius / length;
    cone[1] = -radius * xy / (length * root);
    cone[2] = radius * length / root;
}

void filter_jacobian(const struct cupola_view *view, const struct varying *ray, double jacobian[4])
{
    double q[3], dx[3], dy[3];
    transform3(view->rotation, ray->at, q);
    transform3(view->rotation, ray->dx, dx);
    transform3(view->rotation, ray->dy, dy);
    const double density[2] = {view->rect.width / (view->right - view->left),
                               view->rect.height / (view->top - view->bottom)};
    for (int i = 0; i < 2; i++) {
        double base = q[i] / -q[2];
        jacobian[2 * i] = density[i] * (dx[i] + base * dx[2]) / -q[2];
        jacobian[2 * i + 1] = density[i] * (dy[i] + base * dy[2]) / -q[2];
    }
}

double filter_long_axis(const double jacobian[4], double axis[2])
{
    double xx = jacobian[0] * jacobian[0] + jacobian[2] * jacobian[2];
    double xy = jacobian[0] * jacobian[1] + jacobian[2] * jacobian[3];
    double yy = jacobian[1] * jacobian[1] + jacobian[3] * jacobian[3];
    double half = 0.5 * (xx - yy), q = hypot(half, xy);
    axis[0] = half < 0 ? xy : half + q;
    axis[1] = half < 0 ? q - half : xy;
    double length = hypot(axis[0], axis[1]);
    axis[0] = length > 0 ? axis[0] / length : 1;
    axis[1] = length > 0 ? axis[1] / length : 0;
    return sqrt(0.5 * (xx + yy) + q);
}

/* From a number of texels to one of rays. */
static int count_for(double texels, int most)
{
    double count = ceil(texels);
    return count < most ? (count > 1 ? (int)count : 1) : most;
}

int filter_adaptive_count(const double jacobian[4], int samples)
{
    double covered = fabs(jacobian[0] * jacobian[3] - jacobian[1] * jacobian[2]);
    return count_for(covered - 1e-3, samples);
}

void filter_adaptive_places(const struct pattern *aligned, const double axis[2],
                            const double turn[2], struct filter_place *places)
{
    double cosine = (turn[0] * axis[0] - turn[1] * axis[1]) / sqrt(pi);
    double sine = (turn[1] * axis[0] + turn[0] * axis[1]) / sqrt(pi);
    for (int k = 0; k < aligned->count; k++) {
        const struct pattern_place *place = &aligned->places[k];
        places[k] = (struct filter_place){cosine * place->x - sine * place->y,
                                          sine * place->x + cosine * place->y, place->weight};
    }
}

int filter_footprint(const double jacobian[4], int samples, struct filter_place *places)
{
    double axis[2], s = filter_long_axis(jacobian, axis), pitch = 0;
    int most = samples < FOOTPRINT_RAYS_MAX ? samples : FOOTPRINT_RAYS_MAX;
    int count = count_for(s + FOOTPRINT_MORE, most);
    if (count > 1)
        pitch = sqrt(fmax(s * s - FOOTPRINT_BLUR, 0) / (count * count - 1)) / s;
    for (int k = 0; k < count; k++) {
        double along = (k - 0.5 * (count - 1)) * pitch;
        places[k] = (struct filter_place){along * axis[0], along * axis[1], 1.0 / count};
    }
    return count;
}

void filter_cone_places(const struct pattern *pattern, const double cone[3], const double turn[2],
                        struct filter_place *places)
{
    for (int k = 0; k < pattern->count; k++) {
        const struct pattern_place *place = &pattern->places[k];
        double x = turn[0] * place->x - turn[1] * place->y;
        double y = turn[1] * place->x + turn[0] * place->y;
        places[k] = (struct filter_place){cone[0] * x + cone[1] * y, cone[2] * y, place->weight};
    }
}

void filter_pixel_prepare(const cupola_plan *plan, int output, int x, int y,
                          struct filter_pixel *pixel)
{
    const cupola_dome *dome = &plan->dome;
    const struct projector *projector = &dome->projectors[output];
    struct varying lens, point, inside, change;
    *pixel = (struct filter_pixel){.x = x, .y = y, .projector = projector};
    circle_place(projector, x + 0.5, y + 0.5, pixel->place);
    lens_ray(projector, pixel->place, &lens);
    screen_point(projector, &lens, &point);
    pixel->coverage = pixel_coverage(projector, x + 0.5, y + 0.5, &point);
    if (!(pixel->coverage > 0))
        return;
    point_inside_rim(projector, x + 0.5, y + 0.5, &point, &inside);
    eye_ray(dome, dome->rig.eye_m, &point, &pixel->ray);
    eye_ray(dome, dome->rig.eye_m, &inside, &change);
    memcpy(pixel->ray.dx, change.dx, sizeof change.dx);
    memcpy(pixel->ray.dy, change.dy, sizeof change.dy);
    int view = view_select(plan->views, plan->view_count, pixel->ray.at);
    filter_jacobian(&plan->views[view], &pixel->ray, pixel->jacobian);
}

static bool within_rim(const struct filter_pixel *pixel, double x_px, double y_px)
{
    const struct projector *projector = pixel->projector;
    double x = pixel->place[0] + projector->sign[0] * x_px / projector->radius_px;
    double y = pixel->place[1] + projector->sign[1] * y_px / projector->radius_px;
    return x * x + y * y <= 1;
}

void filter_reflect(const struct filter_pixel *pixel, struct filter_place *place)
{
    if (within_rim(pixel, place->x_px, place->y_px))
        return;
    double across = within_rim(pixel, -place->x_px, -place->y_px) ? -1 : 0;
    place->x_px *= across;
    place->y_px *= across;
}

int filter_pattern_count(const struct cupola_filter *complete, const struct filter_pixel *pixel)
{
    if (complete->method == CUPOLA_ANTIALIASING_CONE)
        return complete->samples;
    if (complete->method == CUPOLA_ANTIALIASING_ADAPTIVE)
        return filter_adaptive_count(pixel->jacobian, complete->samples);
    return 0;
}

void filter_pattern(const struct cupola_filter *complete, int count, struct pattern *pattern)
{
    pattern_make(complete->pattern, count, pattern);
    if (complete->method == CUPOLA_ANTIALIASING_ADAPTIVE)
        pattern_align(pattern);
}

static void pixel_turn(const struct cupola_filter *complete, const struct filter_pixel *pixel,
                       double turn[2])
{
    double turn_rad = 0;
    if (complete->turned)
        turn_rad = pattern_turn_rad((uint32_t)pixel->x, (uint32_t)pixel->y, complete->seed);
    turn[0] = cos(turn_rad);
    turn[1] = sin(turn_rad);
}

int filter_places(const struct cupola_filter *complete, const struct pattern *pattern,
                  const struct filter_pixel *pixel, struct filter_place *places)
{
    double cone[3], axis[2], turn[2];
    int count = 1;
    places[0] = (struct filter_place){0, 0, 1};
    switch (complete->method) {
    case CUPOLA_ANTIALIASING_TEXTURE:
    case CUPOLA_ANTIALIASING_NONE:
        return 1;
    case CUPOLA_ANTIALIASING_CONE:
        count = pattern->count;
        pixel_turn(complete, pixel, turn);
        filter_cone(&pixel->ray, cone);
        filter_cone_places(pattern, cone, turn, places);
        break;
    case CUPOLA_ANTIALIASING_ADAPTIVE:
        count = pattern->count;
        pixel_turn(complete, pixel, turn);
        filter_long_axis(pixel->jacobian, axis);
        filter_adaptive_places(pattern, axis, turn, places);
        break;
    case CUPOLA_ANTIALIASING_FOOTPRINT:
        count = filter_footprint(pixel->jacobian, complete->samples, places);
        break;
    }
    for (int k = 0; k < count; k++)
        filter_reflect(pixel, &places[k]);
    return count;
}

void filter_direction(const struct filter_pixel *pixel, const struct filter_place *place,
                      double direction[3])
{
    const struct varying *ray = &pixel->ray;
    for (int i = 0; i < 3; i++)
        direction[i] = ray->at[i] + place->x_px * ray->dx[i] + place->y_px * ray->dy[i];
}
