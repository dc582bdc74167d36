/* Parts of pictures as files, enlarged so that every pixel is seen. */
#ifndef CUT_OUT_H
#define CUT_OUT_H

#include "trial.h"

/*
 * Writes FOLDER/NAME-METHOD.png of a square picture, RGB, rows from the bottom up; colons become
 * dashes. Nothing without a folder. False with one line in `message`.
 */
bool cut_out_write(const struct cut_out *cut_out, const char *name, const char *method,
                   const unsigned char *rgb, int size_px, char *message);

#endif
