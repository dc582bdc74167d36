/*
 * Rig files: a rig as a text file that people read and edit. The format is in docs/rig-format.md.
 * Part of the build option `io`.
 */
#ifndef CUPOLA_RIG_FILE_H
#define CUPOLA_RIG_FILE_H

#include "rig.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Reads a rig file. Every key has a default, so an empty file is a rig. Does not depend on the
 * locale.
 *
 * path     of the file
 * base     what the keys of the file change, a preset for instance; NULL: all zero, the default
 * rig      out: complete; may be base; untouched on failure
 * error    may be NULL; "file:line: key: value ...; allowed: ..."
 * returns  CUPOLA_OK; CUPOLA_ERROR_FILE; CUPOLA_ERROR_SYNTAX for what is no rig file;
 *          CUPOLA_ERROR_ARGUMENT for an unknown key or an impossible value; CUPOLA_ERROR_MEMORY
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_rig_read(const char *path, const struct cupola_rig *base,
                               struct cupola_rig *rig, struct cupola_error *error);

/*
 * The same from text in memory.
 *
 * text     with a final 0
 * name     stands for the file's name in messages; NULL: "rig"
 * base, rig, error, returns as for cupola_rig_read
 * thread   any
 * since    0.1
 */
CUPOLA_API int cupola_rig_parse(const char *text, const char *name, const struct cupola_rig *base,
                                struct cupola_rig *rig, struct cupola_error *error);

/*
 * Writes a rig file, whole or not at all: into a temporary file beside it, which is brought to the
 * disk and then takes the name. A file that had the name before stays as PATH.bak. What is written
 * reads back as the same rig to the last bit (angles where long double is wider than double). What
 * a lens's model does not use, k or table, is not written. A symbolic link stays one; devices,
 * pipes and directories are refused.
 *
 * path     of the file
 * rig      checked first; an impossible rig is not written
 * returns  CUPOLA_OK; CUPOLA_ERROR_ARGUMENT; CUPOLA_ERROR_FILE; CUPOLA_ERROR_MEMORY
 * thread   any; two writers of one file: the last one wins, neither file is damaged
 * since    0.1
 */
CUPOLA_API int cupola_rig_write(const char *path, const struct cupola_rig *rig,
                                struct cupola_error *error);

#ifdef __cplusplus
}
#endif

#endif
