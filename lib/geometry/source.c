/* From points of the screen to places in pictures. */
#include "source.h"

#include "error.h"
#include "names.h"
#include "vector.h"

static const char *const source_names[SOURCE_KINDS] = {
    [CUPOLA_SOURCE_VIEWS] = "views",
    [CUPOLA_SOURCE_DOMEMASTER] = "domemaster",
    [CUPOLA_SOURCE_EQUIRECTANGULAR] = "equirectangular",
    [CUPOLA_SOURCE_CUBE] = "cube",
};

const char *cupola_source_name(int kind)
{
    return name_of_number(source_names, SOURCE_KINDS, kind);
}

int cupola_source_find(const char *name)
{
    return number_of_name(source_names, SOURCE_KINDS, name);
}

int source_check(const struct cupola_source *source, struct cupola_error *error)
{
    const struct cupola_aim *aim = &source->orientation;
    const double angles[3] = {aim->yaw_rad, aim->pitch_rad, aim->roll_rad};
    static const char *const angle_names[3] = {"yaw", "pitch", "roll"};
    if (!cupola_source_name((int)source->kind))
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "kind of source is %d; allowed: 0 to %d",
                         (int)source->kind, SOURCE_KINDS - 1);
    if (source->kind == CUPOLA_SOURCE_VIEWS)
        return CUPOLA_OK;
    if (source->place < CUPOLA_PLACE_DEFAULT || source->place > CUPOLA_PLACE_INFINITY)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "place of the source is %d; allowed: 0 to "
                         "%d",
                         (int)source->place, CUPOLA_PLACE_INFINITY);
    if (!(source->fov_rad >= 0 && source->fov_rad <= 2 * pi + angle_slack))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "source's field of view is %g rad (%g degrees); allowed: above 0 and up "
                         "to %g rad (360 degrees)",
                         RAD_AND_DEG(source->fov_rad), 2 * pi);
    for (int i = 0; i < 3; i++)
        if (!(fabs(angles[i]) <= 2 * pi + angle_slack))
            return error_set(error, CUPOLA_ERROR_ARGUMENT,
                             "source's %s is %g rad (%g degrees); allowed: -%g to %g rad",
                             angle_names[i], RAD_AND_DEG(angles[i]), 2 * pi, 2 * pi);
    return CUPOLA_OK;
}

void source_frame_prepare(const cupola_dome *dome, const struct cupola_source *source,
                          struct source_frame *frame)
{
    const struct cupola_aim *aim = &source->orientation;
    bool domemaster = source->kind == CUPOLA_SOURCE_DOMEMASTER;
    bool on_screen = source->place == CUPOLA_PLACE_SCREEN ||
                     (source->place == CUPOLA_PLACE_DEFAULT && domemaster);
    double yaw[9], pitch[9], roll[9], turned[9];
    rotation_y(aim->yaw_rad, yaw);
    rotation_x(aim->pitch_rad, pitch);
    rotation_z(aim->roll_rad, roll);
    multiply3(yaw, pitch, turned);
    multiply3(turned, roll, turned);
    transpose3(turned, frame->rotation);
    if (!domemaster)
        multiply3(frame->rotation, dome->tilt, frame->rotation);
    for (int i = 0; i < 3; i++)
        frame->center_m[i] = on_screen ? 0 : dome->rig.eye_m[i];
    frame->half_fov = source->fov_rad == 0 ? 0.5 * pi : fmin(0.5 * source->fov_rad, pi);
}

void source_direction(const struct source_frame *frame, const struct varying *point,
                      struct varying *direction)
{
    double from_center[3];
    for (int i = 0; i < 3; i++)
        from_center[i] = point->at[i] - frame->center_m[i];
    transform3(frame->rotation, from_center, direction->at);
    transform3(frame->rotation, point->dx, direction->dx);
    transform3(frame->rotation, point->dy, direction->dy);
}

/* Change of the angle off the picture's axis for a change of the direction. */
static double angle_change(const double at[3], double across, const double change[3])
{
    double outwards =
        across > 0 ? (at[0] * change[0] + at[1] * change[1]) / across : hypot(change[0], change[1]);
    return (across * change[2] - at[2] * outwards) / dot3(at, at);
}

/*
 * Texels at a picture's rim are mixed with the black beyond it, and the pixel there is mixed with
 * the border: so that it happens once, places stay this far inside of the rim. From there no tap of
 * a bilinear filter meets a texel that a rim along the rows cuts, and hardly one that one across
 * does: white stays white within 0.005.
 */
static const double domemaster_inset_texels = 1.5;

double domemaster_place(const struct source_frame *frame, const struct varying *direction,
                        int side_px, double place[2])
{
    const double *at = direction->at;
    double across = hypot(at[0], at[1]);
    double angle = atan2(across, -at[2]);
    double r = fmin(angle / frame->half_fov, fmax(1 - 2 * domemaster_inset_texels / side_px, 0));
    double factor = across > 0 ? 0.5 * r / across : 0;
    for (int i = 0; i < 2; i++)
        place[i] = 0.5 + factor * at[i];
    if (frame->half_fov >= pi)
        return 1; /* nothing lies outside */
    double dx = angle_change(at, across, direction->dx);
    double dy = angle_change(at, across, direction->dy);
    return edge_coverage((frame->half_fov - angle) / fmax(hypot(dx, dy), 1e-12), dx, dy);
}

void equirectangular_place(const double direction[3], double place[2])
{
    double level = hypot(direction[0], direction[2]);
    place[0] = 0.5 + (level > 0 ? atan2(direction[0], -direction[2]) / (2 * pi) : 0);
    place[1] = 0.5 + atan2(direction[1], level) / pi;
}

int cube_place(const double direction[3], double place[2])
{
    double x = direction[0], y = direction[1], z = direction[2];
    double size[3] = {fabs(x), fabs(y), fabs(z)};
    int axis = size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
    bool back = direction[axis] < 0;
    double across = axis == 0 ? (back ? z : -z) : axis == 1 ? x : (back ? -x : x);
    double up = axis == 1 ? (back ? -z : z) : -y;
    place[0] = 0.5 + 0.5 * across / size[axis];
    place[1] = 0.5 + 0.5 * up / size[axis];
    return 2 * axis + back;
}
