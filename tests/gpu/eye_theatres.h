/* Theatres whose viewer moves, and where the viewer is. */
#ifndef EYE_THEATRES_H
#define EYE_THEATRES_H

#include "check.h"
#include "fixture.h"
#include "rig_random.h"

enum { EYE_THEATRES = 6 };

/* One theatre with wishes for its plan. */
struct eye_theatre {
    struct cupola_rig rig;
    struct cupola_plan_params params;
};

static inline void eye_theatre_layout(int number, struct cupola_plan_params *params)
{
    static const enum cupola_layout layouts[EYE_THEATRES] = {
        CUPOLA_LAYOUT_AUTO,    CUPOLA_LAYOUT_ASYMMETRIC, CUPOLA_LAYOUT_ROTATED,
        CUPOLA_LAYOUT_ROTATED, CUPOLA_LAYOUT_AUTO,       CUPOLA_LAYOUT_AUTO,
    };
    params->layout = layouts[number];
    params->views = number == 1 ? 3 : number == 2 ? 4 : 0;
    params->rotation_in_projection = number == 2;
}

/* On the axis; asymmetric; tilted; a planetarium with a cap; two outputs; hemispheric, cut off. */
static inline struct eye_theatre eye_theatre(int number)
{
    static const enum cupola_lens_model models[EYE_THEATRES] = {
        CUPOLA_LENS_ANGULAR,   CUPOLA_LENS_STEREOGRAPHIC, CUPOLA_LENS_ANGULAR,
        CUPOLA_LENS_EQUISOLID, CUPOLA_LENS_ANGULAR,       CUPOLA_LENS_HEMISPHERIC,
    };
    static const double fovs[EYE_THEATRES] = {140.0, 110.0, 160.0, 180.0, 120.0, 180.0};
    struct eye_theatre theatre = {.rig = plain_rig(models[number], fovs[number], 128)};
    struct cupola_rig *rig = &theatre.rig;
    double radius_m = rig->screen.radius_m = 2.0;
    if (number == 2 || number == 5)
        rig->tilt_rad = 0.4;
    if (number >= 2) {
        rig->eye_m[0] = 0.15 * radius_m;
        rig->eye_m[2] = 0.1 * radius_m;
        rig->outputs[0].position_m[1] = -0.2 * radius_m;
    }
    if (number == 3) {
        rig->tilt_rad = pi / 2.0;
        rig->screen.cap_rad = radians(80.0);
    }
    if (number == 4) {
        rig->output_count = 2;
        rig->outputs[1] = rig->outputs[0];
        rig->outputs[0].aim.yaw_rad = 0.4;
        rig->outputs[1].aim.yaw_rad = -0.4;
        rig->outputs[1].position_m[0] = 0.3 * radius_m;
    }
    if (number == 5)
        rig->outputs[0].height_px = 96;
    eye_theatre_layout(number, &theatre.params);
    theatre.params.head_radius_m = (number == 1 ? 0.08 : 0.12) * radius_m;
    return theatre;
}

/* In the sphere, or with `edge` on its surface. */
static inline void eye_place(const struct eye_theatre *theatre, uint64_t *seed, bool edge,
                             double eye_m[3])
{
    double apart[3], length = 1.0;
    random_in_ball(seed, 1.0, apart);
    if (edge)
        length = sqrt(apart[0] * apart[0] + apart[1] * apart[1] + apart[2] * apart[2]);
    for (int i = 0; i < 3; i++)
        eye_m[i] = theatre->rig.eye_m[i] + theatre->params.head_radius_m * apart[i] / length;
}

#endif
