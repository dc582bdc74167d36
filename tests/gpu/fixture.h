/*
 * A theatre ready to be drawn: dome, plan and GL side made from a rig, views painted by a test
 * shader, the warp captured. Every failure here fails the test under way.
 */
#ifndef FIXTURE_H
#define FIXTURE_H

#include <epoxy/gl.h>

#include "cupola/cupola.h"

struct fixture {
    cupola_dome *dome;
    cupola_plan *plan;
    cupola_gl *gl;
};

/* Worlds that are a function of the ray; each is a file shaders/NAME.frag. */
enum paint {
    PAINT_DIRECTIONS, /* unit direction, host's camera frame */
    PAINT_SCREEN,     /* the point of the screen sphere, in radii, host's camera frame */
    PAINT_NOISE,      /* four random numbers per texel, 0 to 1 */
    PAINT_ROOM,       /* a room with marks on its six faces */
    PAINT_CHECKER,    /* black and white cubes round the eye, without any filter */
};

/* params and gl_params may be NULL: all zero. */
void fixture_make(const struct cupola_rig *rig, const struct cupola_plan_params *params,
                  const struct cupola_gl_params *gl_params, struct fixture *fixture);
/* The same from a plan that exists; the fixture takes it over. */
void fixture_make_of_plan(cupola_plan *plan, const struct cupola_gl_params *gl_params,
                          struct fixture *fixture);
/* The stage of tables that a run is for, which CUPOLA_TEST_TABLE names; else what is wished. */
enum cupola_table fixture_stage(enum cupola_table wished);

/*
 * What a test wishes; in a run for another stage of tables, which CUPOLA_TEST_TABLE names, with
 * that one where it wishes none. `params` is room for it.
 */
const struct cupola_gl_params *fixture_with_stage(const struct cupola_gl_params *wished,
                                                  struct cupola_gl_params *params);
/* Another GL side for the same plan. */
void fixture_replace_gl(struct fixture *fixture, const struct cupola_gl_params *gl_params);
void fixture_release(struct fixture *fixture);

/* The fixture's plan with the rays of another rig: a plan that is wrong. For cupola_plan_destroy.
 */
cupola_plan *fixture_wrong_plan(const struct fixture *fixture, const struct cupola_rig *wrong);

/* Draws all views by nothing but what a host has: each view's matrices and viewport. */
void fixture_paint(const struct fixture *fixture, enum paint paint);

/*
 * RGBA floats of one output's image, or of the whole atlas; freed by the caller. A GL without float
 * targets rounds them to bytes.
 */
float *fixture_warp(const struct fixture *fixture, int output);
float *fixture_atlas(const struct fixture *fixture);
/* Of any texture. */
float *texture_read(GLuint texture, int width_px, int height_px);

/* The private table of the fixture's stage, of one output; 0 for the stage none. */
GLuint fixture_table(const struct fixture *fixture, int output);

/* A table as it is made where a GL cannot draw into floats; deleted by the caller. */
GLuint fixture_table_by_cpu(const struct fixture *fixture, int output, enum cupola_table stage);

/* The programs of all paints; to be called before the context goes. */
void fixture_forget_programs(void);

const struct cupola_output *fixture_output(const struct fixture *fixture, int output);

#endif
