/* The values of command-line options that are names of files. */
#ifndef OPTION_PATHS_H
#define OPTION_PATHS_H

#include "option_values.h"

/* FILE.png or FILE.pfm. */
bool value_output_path(const struct value_context *context, const char *text, const char **path);

/* FILE.png. */
bool value_png_path(const struct value_context *context, const char *text, const char **path);

/* Any name but an empty one. */
bool value_path(const struct value_context *context, const char *text, const char **path);

#endif
