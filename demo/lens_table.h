/* Lens tables: a measured lens as lines of text. */
#ifndef LENS_TABLE_H
#define LENS_TABLE_H

#include <stdbool.h>

#include <cupola/lens.h>

/*
 * Reads the table of a lens: lines "angle_deg,radius", with or without a line that says just this
 * in front. Empty lines and lines that begin with # are passed over. False with one line in
 * `message`, MESSAGE_SIZE bytes: the file, the line, what stands there and what is allowed.
 */
bool lens_table_read(const char *path, struct cupola_lens *lens, char *message);

#endif
