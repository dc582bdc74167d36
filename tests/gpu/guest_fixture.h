/*
 * All that the library does in a host's context, small: views, every kind of picture, points, the
 * theatre, into a target that can be read.
 */
#ifndef GUEST_FIXTURE_H
#define GUEST_FIXTURE_H

#include "fixture.h"

enum { GUEST_SIZE = 32, GUEST_PICTURES = 3 };

struct guest_house {
    cupola_dome *dome;
    cupola_plan *plan;
    cupola_gl *gl;
    cupola_theatre *theatre; /* NULL until it is made */
    struct cupola_source pictures[GUEST_PICTURES];
    GLuint gain;
    enum cupola_storage storage; /* of gl */
    bool one_pass;               /* gl draws its views in one pass, too */
    GLuint view_textures[2];     /* of the host's: a 2-D texture, an array */
    struct cupola_target target;
    GLuint target_texture;
    bool moving; /* every frame has another eye than the one before */
};

/* Of the rig's eye, m, in a house for a viewer who moves. */
#define GUEST_HEAD_RADIUS_M 0.1

/* Dome, plan, pictures and target; no gl. */
void guest_house_build(struct guest_house *house);
void guest_house_build_for(struct guest_house *house, int projectors); /* alike, in one place */
/* The same for a viewer who moves. */
void guest_house_build_moving(struct guest_house *house);
void guest_house_release(struct guest_house *house);

/* All sources and overlays, unless the parameters name some. */
enum cupola_table guest_moving_table(enum cupola_table wished); /* points where it needs floats */
int guest_gl_create(struct guest_house *house, const struct cupola_gl_params *params,
                    struct cupola_error *error);

/*
 * One frame: the views, drawn by clears (one by one, and where the GL can in one pass) or imported,
 * then each source warped over the one before, then overlays. With a status below 0 it ends, and
 * that is what it returns. Where the viewer moves, it does at the beginning: away, and always to
 * the same place.
 */
int guest_move(struct guest_house *house, struct cupola_error *error);
int guest_frame(struct guest_house *house, struct cupola_error *error);
int guest_views(struct guest_house *house, struct cupola_error *error);
int guest_pass(struct guest_house *house, struct cupola_error *error); /* after frame_begin */
int guest_import(struct guest_house *house, struct cupola_error *error);
int guest_warp(struct guest_house *house, int picture, struct cupola_error *error); /* -1: views */
int guest_overlays(struct guest_house *house, struct cupola_error *error);
int guest_theatre(struct guest_house *house, struct cupola_error *error);
int guest_theatre_encoded(struct guest_house *house, enum cupola_encoding encoding,
                          struct cupola_error *error);

/* RGBA floats, GUEST_SIZE by GUEST_SIZE; freed by the caller. */
float *guest_picture(const struct guest_house *house);

#endif
