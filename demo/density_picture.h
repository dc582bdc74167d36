/* The density map of an output as a picture: false colours and a scale, the paper's figure 8. */
#ifndef DENSITY_PICTURE_H
#define DENSITY_PICTURE_H

#include <stdbool.h>

#include <cupola/dome.h>

/*
 * Writes it by the path's end: PNG with colours and scale, or PFM with the solid angles, sr. False
 * with one line in `message`, MESSAGE_SIZE bytes.
 */
bool density_picture_write(const char *path, const cupola_dome *dome, int output, char *message);

#endif
