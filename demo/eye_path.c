/* The way of a viewer who moves: a circle round the dome's axis, with its middle at --viewer. */
#include "eye_path.h"

#include <math.h>

bool eye_path_place(const struct options *options, const struct cupola_rig *rig, double turns,
                    double eye_m[3])
{
    double angle = turns * (2 * 3.14159265358979323846);
    double radius_m = options->eye_circle_m.value[0];

    if (!options->eye_circle_m.given)
        return false;
    eye_m[0] = rig->eye_m[0] + radius_m * cos(angle);
    eye_m[1] = rig->eye_m[1] + radius_m * sin(angle);
    eye_m[2] = rig->eye_m[2];
    return true;
}

double eye_path_head_radius_m(const struct options *options)
{
    if (options->head_radius_m.given)
        return options->head_radius_m.value[0];
    return options->eye_circle_m.given ? options->eye_circle_m.value[0] : 0;
}
