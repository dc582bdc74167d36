/* The references of a camera of unknown pose. */
#include "capture/pose_references.h"

#include <math.h>
#include <stdio.h>

#include "angles.h"
#include "option_values.h"

static void unit_place(const struct marks *marks, int index, double unit[3])
{
    const double *place = marks->list[index].place;
    double length = sqrt(place[0] * place[0] + place[1] * place[1] + place[2] * place[2]);

    for (int i = 0; i < 3; i++)
        unit[i] = place[i] / fmax(length, 1e-9);
}

/* Two of the references tell three angles if they are neither one place nor opposite ones. */
static bool references_span(const struct marks *references)
{
    double a[3], b[3];

    for (int i = 0; i < references->count; i++) {
        for (int k = 0; k < i; k++) {
            unit_place(references, i, a);
            unit_place(references, k, b);
            if (fabs(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) < cos(5 / deg_per_rad))
                return true;
        }
    }
    return false;
}

static bool are_inside(const struct pose_request *request, char *message)
{
    const struct camera *camera = request->camera;

    for (int i = 0; i < request->references->count; i++) {
        const struct mark *mark = &request->references->list[i];
        const double *at = mark->pixel_px;
        double ray[3];
        if (at[0] >= 0 && at[0] <= camera->width && at[1] >= 0 && at[1] <= camera->height &&
            camera_ray(camera, at, ray))
            continue;
        snprintf(message, MESSAGE_SIZE,
                 "--references: %.64s at (%g, %g) is not in the photograph; allowed: what the lens "
                 "sees of its %d x %d px, y counted from the bottom",
                 mark->name, at[0], at[1], camera->width, camera->height);
        return false;
    }
    return true;
}

bool pose_references_check(const struct pose_request *request, char *message)
{
    if (!references_span(request->references)) {
        snprintf(message, MESSAGE_SIZE,
                 "--references: turning camera and projector together round the centre of the "
                 "screen changes no photograph; allowed: 2 references or more, two of which are 5 "
                 "to 175 degrees apart as seen from the centre");
        return false;
    }
    return are_inside(request, message);
}

/* The angle, for points that the camera cannot place. */
static double angle_px(const struct camera *camera, const struct mark *mark, const double *point)
{
    double ray[3], way[3], length = 0, chord = 0;

    camera_ray(camera, mark->pixel_px, ray);
    for (int i = 0; i < 3; i++) {
        way[i] = point[i] - camera->position_m[i];
        length += way[i] * way[i];
    }
    length = fmax(sqrt(length), 1e-9);
    for (int i = 0; i < 3; i++)
        chord += pow(ray[i] - way[i] / length, 2);
    return sqrt(chord) / camera_pixel_rad(camera);
}

static double off_px_of(const struct pose_request *request, const struct camera *camera, int index)
{
    const struct mark *mark = &request->references->list[index];
    double radius_m = request->rig->screen.radius_m, place[2] = {HUGE_VAL, HUGE_VAL}, point[3], x,
           y;

    for (int i = 0; i < 3; i++)
        point[i] = mark->place[i] * (request->references->kind == MARKS_DIRECTIONS ? radius_m : 1);
    camera_place(camera, point, place);
    x = fabs(place[0] - mark->pixel_px[0]);
    y = fabs(place[1] - mark->pixel_px[1]);
    if (camera->kind == CAMERA_EQUIRECTANGULAR)
        x = fmin(x, camera->width - x);
    return isfinite(x + y) ? hypot(x, y) : angle_px(camera, mark, point);
}

double pose_references_measure(const struct pose_request *request, const struct camera *camera,
                               int left_out, double *off_px)
{
    int count = request->references->count;
    double sum = 0;

    for (int i = 0; i < count; i++) {
        double off = off_px_of(request, camera, i);
        if (off_px)
            off_px[i] = off;
        if (i != left_out)
            sum += off * off;
    }
    return sqrt(sum / (left_out < 0 ? count : count - 1));
}

double pose_references_allowed_px(const struct camera *camera)
{
    return fmax(5, 0.01 * camera->width);
}

void pose_references_refuse(const struct pose_request *request, const double *off_px, double rms_px,
                            int wrong, double rest_px, char *message)
{
    const struct marks *references = request->references;
    int worst = 0;
    char rest[128] = "";

    for (int i = 0; i < references->count; i++)
        worst = off_px[i] > off_px[worst] ? i : worst;
    if (wrong >= 0)
        snprintf(rest, sizeof rest, "; without %.64s the others fit to %.2g px",
                 references->list[wrong].name, rest_px);
    snprintf(message, MESSAGE_SIZE,
             "--references do not fit the photographs: rms %.3g px, worst %.64s at %.3g px; "
             "allowed: rms up to %.3g px%s; look at their places, names and signs; y counts from "
             "the bottom left",
             rms_px, references->list[worst].name, off_px[worst],
             pose_references_allowed_px(request->camera), rest);
}
