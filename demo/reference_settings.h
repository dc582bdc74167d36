/* All that a reference's pictures depend on. */
#ifndef REFERENCE_SETTINGS_H
#define REFERENCE_SETTINGS_H

#include "film.h"
#include "reference_state.h"

/*
 * Sets command and settings of a state: the command line, the contents of what files it names (of a
 * film's pictures their sizes and times), the OpenGL and the program's version. A film may be NULL.
 * False with one line in `message`, MESSAGE_SIZE bytes.
 */
bool reference_settings(const struct options *options, const struct film *film,
                        struct reference_state *state, char *message);

#endif
