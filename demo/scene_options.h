/* Those of cupola-demo's options that say what a scene is. */
#ifndef SCENE_OPTIONS_H
#define SCENE_OPTIONS_H

#include "options.h"

/* --scene to --seed. False with one line in the context's message. */
bool scene_options_take(const struct value_context *context, int code, const char *text,
                        struct options *options);

#endif
