/*
 * A ray tracer for worlds of triangles in a dome, made from the written formulas alone: nothing of
 * the library is used. It is the oracle of the whole chain from model and command line to picture.
 */
#ifndef RAY_TRACER_H
#define RAY_TRACER_H

#include <stdbool.h>
#include <stdint.h>

struct vector {
    double x, y, z;
};

/* Columns: where the axes go. */
struct rotation {
    struct vector x, y, z;
};

enum traced_lens { ANGULAR, HEMISPHERIC, EQUISOLID, STEREOGRAPHIC, POLYNOMIAL, LENS_KINDS };

/* The theatre and, in it, the host's camera. */
struct theatre {
    enum traced_lens lens;
    double fov_deg, k[4];
    int width_px, height_px;
    double circle_x_px, circle_y_px, circle_radius_px;
    bool flip_x, flip_y;
    double radius_m, cap_deg, tilt_deg;
    struct vector viewer_m, projector_m;
    double aim_deg[3]; /* yaw, pitch, roll */
    struct vector camera, look;
};

struct triangle {
    struct vector corner[3];
    int colour;
};

enum { TRIANGLES_MAX = 300, COLOURS_MAX = 24 };

struct traced_world {
    struct triangle triangles[TRIANGLES_MAX];
    int triangle_count;
    double colours[COLOURS_MAX][3];
    int colour_count;
};

/* A triangle as the viewer sees it: the directions a v1 + b v2 + c v3 with a, b, c >= 0. */
struct seen_triangle {
    struct vector side[3]; /* side[i] . direction: the factor of corner i */
    struct vector plane;   /* plane . direction: 1 / distance along the direction */
    const double *colour;
    struct vector middle; /* unit directions to it are at most `reach` from this one */
    double reach;
};

struct tracer {
    struct theatre theatre;
    struct rotation aim, host; /* lens to dome frame, dome frame to world */
    struct seen_triangle triangles[TRIANGLES_MAX];
    int triangle_count;
};

/* What a pixel may look like. */
struct expectation {
    double low[3], high[3]; /* its colour, coverage of the rim pixel included */
    bool inside;            /* it and what it is filtered from lie inside circle and screen */
    bool edge;              /* differently coloured triangles are near */
    /* Where inside and edge: light filtered over a pixel, linear, and how it grows per pixel right
     * and up. */
    double mean[3], right[3], up[3];
};

struct vector vector_add(struct vector a, struct vector b);
struct vector vector_scaled(struct vector a, double factor);
double vector_dot(struct vector a, struct vector b);
struct vector vector_cross(struct vector a, struct vector b);
struct vector vector_normal(struct vector a);
struct vector vector_rotated(const struct rotation *rotation, struct vector a);

/* Where the viewer's eye stands in the world. */
struct vector theatre_eye(const struct theatre *theatre);

/* Whether the lens's radius grows with the angle up to half of fov_deg. */
bool theatre_lens_is_monotone(const struct theatre *theatre);

/* world must outlive tracer. */
void tracer_prepare(struct tracer *tracer, const struct theatre *theatre,
                    const struct traced_world *world);

/*
 * The direction in the world in which the viewer sees image point (x, y) (px, origin bottom left);
 * beyond the rim, where no lens says it, as far beyond that of the rim as the way to it goes on
 * straight. False where the point lit is not on the screen.
 */
bool tracer_ray(const struct tracer *tracer, double x_px, double y_px, struct vector *ray);

/* Of pixel (i, j), counted from the bottom left. */
void tracer_expect(const struct tracer *tracer, int i, int j, struct expectation *expectation);

/* Fills a closed room round `eye` with things, none nearer to it than 0.05 units. */
void traced_world_make(struct traced_world *world, struct vector eye, uint64_t *random);

/* Writes NAME.obj and NAME.mtl; some pairs of triangles as one face, some faces turned over. */
void traced_world_write(const struct traced_world *world, const char *name, uint64_t *random);

#endif
