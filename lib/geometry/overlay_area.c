/*
 * The pixels that an overlay may change: a rectangle that is cheap to find and never too small.
 *
 * From directions to places in the image everything is continuous and one to one, up to the lens's
 * rim. So a place furthest to one side comes from the overlay's border or lies on the rim: samples
 * of both tell where, and the gaps between neighbouring samples how far off they may be. What the
 * lens does not reach is taken to the rim.
 */
#include "overlay.h"
#include "vector.h"

enum { SIDE_SAMPLES = 8, BORDER_SAMPLES = 4 * SIDE_SAMPLES, RIM_SAMPLES = 64 };

/* Coverage reaches half a pixel beyond an edge, more where the derivative changes fast. */
static const double margin_px = 3;

struct bounds {
    double low[2], high[2];
};

static void include(struct bounds *bounds, const double place[2], double reach_px)
{
    for (int i = 0; i < 2; i++) {
        bounds->low[i] = fmin(bounds->low[i], place[i] - reach_px);
        bounds->high[i] = fmax(bounds->high[i], place[i] + reach_px);
    }
}

/* A place on the border, counter-clockwise from the lower left corner, as a direction. */
static void border_direction(const struct overlay_frame *frame, int sample, double direction[3])
{
    double t = 2.0 * (sample % SIDE_SAMPLES) / SIDE_SAMPLES - 1;
    const double sides[4][2] = {{t, -1}, {1, t}, {-t, 1}, {-1, -t}};
    const double *side = sides[sample / SIDE_SAMPLES];
    const double q[3] = {side[0] * frame->half[0], side[1] * frame->half[1], 1};
    transform3_back(frame->axes, q, direction);
    scale3(direction, 1 / length3(direction));
}

/* Whether all of it lies outside of the lens, also between the samples. */
struct reach {
    double nearest_rad; /* the smallest angle beyond the rim */
    double step_rad;    /* the largest one between neighbours */
};

static struct reach include_border(const cupola_dome *dome, int output,
                                   const struct overlay_frame *frame, struct bounds *bounds)
{
    const struct projector *projector = &dome->projectors[output];
    double places[BORDER_SAMPLES][2], ways[BORDER_SAMPLES][3], gap_px = 0;
    struct reach reach = {HUGE_VAL, 0};
    for (int i = 0; i < BORDER_SAMPLES; i++) {
        double direction[3], point[3];
        border_direction(frame, i, direction);
        eye_point(dome, dome->rig.eye_m, direction, point);
        for (int k = 0; k < 3; k++)
            ways[i][k] = point[k] - projector->position_m[k];
        scale3(ways[i], 1 / length3(ways[i]));
        reach.nearest_rad = fmin(reach.nearest_rad, lens_place(projector, ways[i], places[i]));
    }
    for (int i = 0; i < BORDER_SAMPLES; i++) {
        const double *next = places[(i + 1) % BORDER_SAMPLES];
        gap_px = fmax(gap_px, hypot(next[0] - places[i][0], next[1] - places[i][1]));
        double along = dot3(ways[i], ways[(i + 1) % BORDER_SAMPLES]);
        reach.step_rad = fmax(reach.step_rad, acos(fmin(fmax(along, -1), 1)));
    }
    for (int i = 0; i < BORDER_SAMPLES; i++)
        include(bounds, places[i], gap_px + margin_px);
    return reach;
}

/* Whether any of the rim's samples lies on the overlay; those that do are included. */
static bool include_rim(const cupola_dome *dome, int output, const struct overlay_frame *frame,
                        struct bounds *bounds)
{
    const struct projector *projector = &dome->projectors[output];
    double gap_px = 2 * pi * projector->radius_px / RIM_SAMPLES;
    bool any = false;
    for (int i = 0; i < RIM_SAMPLES; i++) {
        double angle = 2 * pi * i / RIM_SAMPLES;
        double at[2] = {cos(angle), sin(angle)}, place[2];
        struct varying lens, point, ray, direction;
        lens_ray(projector, at, &lens);
        screen_point(projector, &lens, &point);
        eye_ray(dome, dome->rig.eye_m, &point, &ray);
        overlay_direction(frame, &ray, &direction);
        if (!(fmax(fabs(direction.at[0]), fabs(direction.at[1])) <= direction.at[2]))
            continue;
        for (int k = 0; k < 2; k++)
            place[k] = projector->center_px[k] + projector->sign[k] * projector->radius_px * at[k];
        include(bounds, place, gap_px + margin_px);
        any = true;
    }
    return any;
}

struct overlay_area overlay_area_find(const cupola_dome *dome, int output,
                                      const struct overlay_frame *frame)
{
    const struct projector *projector = &dome->projectors[output];
    const double size[2] = {projector->width_px, projector->height_px};
    struct bounds bounds = {{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
    struct reach reach = include_border(dome, output, frame, &bounds);
    bool on_rim = include_rim(dome, output, frame, &bounds);
    double inside = lens_angle(&projector->lens, fmax(1 - margin_px / projector->radius_px, 0));
    double margin_rad = projector->lens.half_fov - inside;
    if (!on_rim && reach.nearest_rad > reach.step_rad + margin_rad)
        return (struct overlay_area){0};
    int low[2], high[2];
    for (int i = 0; i < 2; i++) {
        low[i] = (int)floor(fmin(fmax(bounds.low[i], 0), size[i]));
        high[i] = (int)ceil(fmin(fmax(bounds.high[i], 0), size[i]));
    }
    if (high[0] <= low[0] || high[1] <= low[1])
        return (struct overlay_area){0};
    return (struct overlay_area){low[0], low[1], high[0] - low[0], high[1] - low[1]};
}
