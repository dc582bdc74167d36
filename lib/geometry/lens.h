/* A lens made ready for evaluation: validated, scaled so that r = 1 at half of the fov. */
#ifndef LENS_PRIVATE_H
#define LENS_PRIVATE_H

#include "angle.h"
#include "cupola/lens.h"

enum { LENS_KNOTS_MAX = CUPOLA_LENS_TABLE_MAX + 1 };

/* A monotone cubic r(angle) through measured samples. */
struct lens_table {
    int count;
    double angle[LENS_KNOTS_MAX];
    double radius[LENS_KNOTS_MAX];
    double slope[LENS_KNOTS_MAX]; /* dr / dangle */
};

struct lens {
    enum cupola_lens_model model;
    double half_fov;         /* h, rad */
    double scale;            /* hemispheric sin h, equisolid sin(h/2), stereographic tan(h/2) */
    double k[4];             /* polynomial, scaled */
    struct lens_table table; /* table, scaled */
};

/* Validates and scales; see cupola_lens_validate. */
int lens_prepare(const struct cupola_lens *lens, struct lens *prepared, struct cupola_error *error);

/*
 * The forward form, 0 <= angle <= h, the inverse, 0 <= r <= 1, and the inverse's derivative where
 * the inverse is known: for measured lenses it is the dear part.
 */
double lens_radius(const struct lens *lens, double angle);
double lens_angle(const struct lens *lens, double r);
double lens_angle_slope(const struct lens *lens, double r, double angle);

int lens_table_prepare(const struct cupola_lens *lens, double half_fov, struct lens_table *table,
                       struct cupola_error *error);
double lens_table_radius(const struct lens_table *table, double angle);
double lens_table_slope(const struct lens_table *table, double angle);
double lens_table_angle(const struct lens_table *table, double r);

#endif
