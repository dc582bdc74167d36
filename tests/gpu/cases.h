/*
 * Theatres of many kinds: every pair of values of any two properties stands in at least one of
 * them (pairwise coverage), or all combinations of the first ones (the long form).
 */
#ifndef CASES_H
#define CASES_H

#include <stdbool.h>
#include <stdint.h>

#include "cupola/cupola.h"

enum case_property {
    CASE_LENS,
    CASE_FOV,
    CASE_LAYOUT,
    CASE_VIEWS,
    CASE_SIZE,
    CASE_EYE,
    CASE_PROJECTOR,
    CASE_AIM,
    CASE_TILT,
    CASE_FLIP,
    CASE_STAGE,
    CASE_ROTATION,
    CASE_OUTPUTS,
    CASE_CAP,
    CASE_PROPERTIES,
};

/* One theatre. */
struct theatre_case {
    int values[CASE_PROPERTIES]; /* an index each */
    struct cupola_rig rig;
    struct cupola_plan_params params;
    enum cupola_table stage;
    char text[256]; /* what a message calls it */
};

/* Called with a plan that it takes over; whether it wants more. */
typedef bool (*case_visitor)(const struct theatre_case *theatre, cupola_plan *plan, void *user);

/* What became of the pairs. */
struct case_count {
    int cases;
    int pairs;
    int refused_pairs; /* in no theatre, because none with them is legal */
};

/*
 * Visits seeded theatres until every pair of values is covered. A pair is given up when the planner
 * refused 24 theatres with it; each is printed.
 */
struct case_count cases_pairwise(uint64_t seed, case_visitor visit, void *user);

/* All combinations of lens, fov, layout, views, size and eye that are legal, the rest random. */
struct case_count cases_matrix(uint64_t seed, case_visitor visit, void *user);

#endif
