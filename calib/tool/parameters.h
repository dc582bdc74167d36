/*
 * Every value of the tool that can be changed, as one table: its name with the unit, as scripts,
 * the legend and the journal have it, how it is changed by a key and how many digits are shown.
 */
#ifndef PARAMETERS_H
#define PARAMETERS_H

#include <stdbool.h>
#include <stddef.h>

#include <cupola/rig.h>

struct tool;

enum parameter {
    PARAMETER_CIRCLE_X,
    PARAMETER_CIRCLE_Y,
    PARAMETER_CIRCLE_RADIUS,
    PARAMETER_FLIP, /* 0 to 3, of enum cupola_flip; a word in scripts */
    PARAMETER_LENS, /* of enum cupola_lens_model; a word in scripts */
    PARAMETER_FOV,
    PARAMETER_K1,
    PARAMETER_K3,
    PARAMETER_K5,
    PARAMETER_K7,
    PARAMETER_PROJECTOR_X,
    PARAMETER_PROJECTOR_Y,
    PARAMETER_PROJECTOR_Z,
    PARAMETER_YAW,
    PARAMETER_PITCH,
    PARAMETER_ROLL,
    PARAMETER_SCREEN_RADIUS,
    PARAMETER_CAP,
    PARAMETER_TILT,
    PARAMETER_VIEWER_X,
    PARAMETER_VIEWER_Y,
    PARAMETER_VIEWER_Z,
    PARAMETER_DOT_YAW,
    PARAMETER_DOT_PITCH,
    PARAMETER_DOT_SIZE,
    PARAMETER_CROSS_X,
    PARAMETER_CROSS_Y,
    PARAMETER_MARK, /* 1 is the first; 0 without marks */
    PARAMETER_COUNT,
    PARAMETER_RIG_COUNT = PARAMETER_DOT_YAW /* those before it are of the rig */
};

/* All values at once, in the API's units (radians), bit for bit: what undo brings back. */
struct values {
    double raw[PARAMETER_COUNT];
};

/* "yaw_deg"; NULL beyond the last, so that a loop over 0, 1, ... ends. */
const char *parameter_name(int parameter);

/* The way back; negative where there is no such parameter. */
int parameter_find(const char *name);

/* In the unit of its name: degrees, metres, pixels. */
double parameter_get(const struct tool *tool, enum parameter parameter);

/* How far an arrow key moves it, in the same unit, before Shift (a tenth) and Ctrl (ten times). */
double parameter_step(const struct tool *tool, enum parameter parameter);

/*
 * Sets it, in the same unit, without a step of history. False, with one line in tool->warning that
 * names value and what is allowed, where it is impossible; nothing else has then changed.
 */
bool parameter_set(struct tool *tool, enum parameter parameter, double value);

/* "12.3 degrees", "angular", "-0.010 m": as the legend shows it. */
void parameter_text(const struct tool *tool, enum parameter parameter, char *text, size_t size);

/* "yaw": the name without its unit, with spaces for the eye. */
void parameter_label(enum parameter parameter, char *text, size_t size);

/* The words of a value that has some, as rig files have them: "angular", "xy"; NULL beyond. */
const char *parameter_word(enum parameter parameter, int value);

/*
 * What scripts write behind a name: a number, or a word of a lens or a flip. False where it is
 * neither, with one line in `message`, MESSAGE_SIZE bytes, that names all there are.
 */
bool parameter_parse(enum parameter parameter, const char *text, double *value, char *message);

/* Half of the last digit that is shown, in the unit of the name. */
double parameter_tolerance(enum parameter parameter);

/* All values, out of the tool and back. Those that go back were once taken out, or are checked. */
void values_take(const struct tool *tool, struct values *values);
void values_put(struct tool *tool, const struct values *values);

/*
 * Whether the rig would be possible with these values and the tool's cross-hair and mark would
 * exist; for values that come from a file. One line in `message` where not.
 */
bool values_check(const struct tool *tool, const struct values *values, char *message);

#endif
