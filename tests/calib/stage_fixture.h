/*
 * The tool's stage without a window, for tests of what it draws. Every failure here fails the test
 * under way; a machine without any GL context skips the program.
 */
#ifndef STAGE_FIXTURE_H
#define STAGE_FIXTURE_H

#include <stdint.h>

#include <cupola/cupola.h>

#include "tool/stage.h"
#include "tool/tool.h"

struct stage_fixture {
    struct tool tool;
    struct stage *stage;
};

/* For cmocka_run_group_tests. */
int stage_context_open(void **state);
int stage_context_close(void **state);

/* A tool that shows no text whatever. */
void stage_fixture_make(struct stage_fixture *fixture, const struct cupola_rig *rig);
void stage_fixture_release(struct stage_fixture *fixture);

/* The projector's image, four bytes a pixel, rows from the bottom up; to be freed. */
unsigned char *stage_fixture_image(struct stage_fixture *fixture);

/* A frame as a window of this size shows it; to be freed. */
unsigned char *stage_fixture_frame(struct stage_fixture *fixture, int width, int height);

/*
 * Any theatre with an image of `size` x 3/4 `size` px: lens, circle and flips, projector and viewer
 * within 0.4 of the radius, aim within 20 degrees, tilted.
 */
void stage_random_rig(uint64_t *seed, int size, struct cupola_rig *rig);

/* sRGB codes to light. */
double stage_light(unsigned char code);

#endif
