/* All that a reference's pictures depend on. */
#ifndef REFERENCE_SETTINGS_H
#define REFERENCE_SETTINGS_H

#include "reference_state.h"
#include "world.h"

/*
 * Sets command and settings of a state: the command line, the contents of what files it names, of a
 * model all that was read of it and of what it names (of a film's pictures their sizes and times),
 * the OpenGL and the program's version.
 * False with one line in `message`, MESSAGE_SIZE bytes.
 */
bool reference_settings(const struct options *options, const struct world *world,
                        struct reference_state *state, char *message);

#endif
