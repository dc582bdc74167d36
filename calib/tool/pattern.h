/* Test patterns: functions of the place on the dome, drawn per pixel of the projector's image. */
#ifndef PATTERN_H
#define PATTERN_H

#include "tool/tool.h"

/* What a pattern's middle, -Z, and its right and up are. */
struct pattern_frame {
    bool about_viewer;
    double to_pattern[9]; /* rows; dome frame to the pattern's */
    double origin_m[3];   /* dome frame; directions of the pattern begin there */
};

/* Markers of the rim are the dome's own, the dot is the viewer's, all others are as wished. */
void pattern_frame(const struct tool *tool, const struct cupola_rig *rig,
                   struct pattern_frame *frame);

/* Between the circles on which the stars of the wedges stand. */
double pattern_star_spacing_rad(const struct cupola_rig *rig);

/* Towards the dot, in the pattern's frame, unit length. */
void pattern_dot(const struct tool *tool, double direction[3]);

struct patterns;

/* NULL with one line in `message`. Where a GL context is current, like all below. */
struct patterns *patterns_create(char *message);

/* NULL is allowed. */
void patterns_destroy(struct patterns *patterns);

/*
 * Draws the tool's pattern into the framebuffer that is bound, all of the image: encoded numbers,
 * and the coverage as alpha. `points` is the output's point table.
 */
bool patterns_draw(struct patterns *patterns, const struct tool *tool, const struct cupola_rig *rig,
                   unsigned int points, char *message);

/* How far the cross-hair reaches from its middle. */
double pattern_cross_arm_px(const struct cupola_output *output);

/* Draws the cross-hair likewise over it, in linear light. */
void patterns_draw_cross(struct patterns *patterns, const struct tool *tool,
                         const struct cupola_rig *rig, unsigned int points);

#endif
