/*
 * Lenses: the function that ties an image radius r to an angle off the lens axis.
 *
 * r is the distance from the centre of the image circle as a fraction of its radius, 0 to 1. With
 * h half of the field of view, every lens is scaled so that r = 1 at h, and is monotone on [0, h].
 *
 *   angular        angle = h r                     equidistant, f-theta; the paper's 3.2.1.2
 *   hemispheric    angle = asin(r sin h)           orthographic; the paper's 3.2.1.1
 *   equisolid      angle = 2 asin(r sin(h/2))      equal areas for equal solid angles
 *   stereographic  angle = 2 atan(r tan(h/2))      keeps shapes
 *   polynomial     r ~ k1 a + k3 a^3 + k5 a^5 + k7 a^7, a in radians
 *   table          measured (angle, r) pairs, monotone cubic between them (Fritsch and Carlson,
 *                  SIAM J. Numer. Anal. 17, 1980)
 *
 * "The paper" here and elsewhere: Amundarain, Buchart, Valero, Aguinaga and Matey, Proyeccion
 * esferica usando la programacion en la GPU.
 */
#ifndef CUPOLA_LENS_H
#define CUPOLA_LENS_H

#include "error.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The curves above. */
enum cupola_lens_model {
    CUPOLA_LENS_ANGULAR = 0,   /* equidistant */
    CUPOLA_LENS_HEMISPHERIC,   /* orthographic */
    CUPOLA_LENS_EQUISOLID,     /* equal areas */
    CUPOLA_LENS_STEREOGRAPHIC, /* equal shapes */
    CUPOLA_LENS_POLYNOMIAL,    /* by `k` */
    CUPOLA_LENS_TABLE,         /* by `table` */
};

enum { CUPOLA_LENS_TABLE_MAX = 64 /* samples in a table */ };

/* One measurement of a lens. */
struct cupola_lens_sample {
    double angle_rad; /* off the lens axis, 0 to pi */
    double radius;    /* in any unit: the curve is scaled to 1 at half of the field of view */
};

/*
 * A lens as a plain value. All zero is an angular lens of 180 degrees.
 */
struct cupola_lens {
    enum cupola_lens_model model; /* 0: angular */
    /*
     * Full opening angle. 0: pi; for a table, twice its last angle. From 1e-6 up to 2 pi
     * (angular, equisolid, polynomial), up to pi (hemispheric), below 2 pi (stereographic), up to
     * twice the last angle (table).
     */
    double fov_rad;
    /* Polynomial only: k1, k3, k5, k7 in rad^-1, -3, -5, -7; any common factor cancels. */
    double k[4];
    /*
     * Table only: 2 to CUPOLA_LENS_TABLE_MAX samples, both columns strictly increasing. A first
     * sample at an angle above 0 gets (0, 0) before it.
     */
    int table_count;
    /* Table only: its first table_count samples. */
    struct cupola_lens_sample table[CUPOLA_LENS_TABLE_MAX];
};

/*
 * The name of a model as in rig files and on command lines.
 *
 * model    of enum cupola_lens_model
 * returns  a static string; NULL for a number that is no model, so that a loop over 0, 1, ... ends
 * thread   any
 * since    0.1
 */
CUPOLA_API const char *cupola_lens_model_name(int model);

/*
 * The way back from the name of a model.
 *
 * name     as cupola_lens_model_name gives it
 * returns  of enum cupola_lens_model, or CUPOLA_ERROR_ARGUMENT
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_lens_model_find(const char *name);

/*
 * Whether a lens is possible: its field of view within its model's limits, its curve strictly
 * increasing from 0 to half of the field of view.
 *
 * lens     0 means the default in every member
 * error    may be NULL
 * returns  CUPOLA_OK, or CUPOLA_ERROR_ARGUMENT with the value and what is allowed
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_lens_validate(const struct cupola_lens *lens, struct cupola_error *error);

/*
 * The forward form, r(angle), and the inverse, angle(r).
 *
 * lens       0 means the default in every member
 * angle_rad  0 to h; beyond, the rim's value is returned
 * radius     0 to 1; beyond, the rim's value is returned
 * returns    the image radius (0 to 1), the angle in radians (0 to h); NaN if the lens is not valid
 * thread     any
 * since      0.1
 */
CUPOLA_API double cupola_lens_radius(const struct cupola_lens *lens, double angle_rad);
CUPOLA_API double cupola_lens_angle(const struct cupola_lens *lens, double radius);

#ifdef __cplusplus
}
#endif

#endif
