/* From a rig to the text of a rig file. */
#ifndef RIG_WRITE_H
#define RIG_WRITE_H

#include <stdio.h>

#include "cupola/rig.h"

/* Expects the C locale, and a rig that is complete. The stream says whether it went well. */
void rig_write(FILE *stream, const struct cupola_rig *rig);

#endif
