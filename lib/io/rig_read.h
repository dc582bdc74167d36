/* From libconfig's tree to a rig. */
#ifndef RIG_READ_H
#define RIG_READ_H

#include <libconfig.h>

#include "cupola/rig.h"

/*
 * Expects the C locale.
 *
 * root     its numbers and strings are whole numbers that carry their texts as hooks
 * name     of the file, for messages
 * base     what the keys change; NULL: the default rig
 * rig      out: complete; untouched on failure
 * returns  CUPOLA_OK; CUPOLA_ERROR_ARGUMENT for an unknown key or an impossible value
 */
int rig_read(const config_setting_t *root, const char *name, const struct cupola_rig *base,
             struct cupola_rig *rig, struct cupola_error *error);

#endif
