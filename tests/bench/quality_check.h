/* What is looked at before the first frame, since the last may be hours later. */
#ifndef QUALITY_CHECK_H
#define QUALITY_CHECK_H

#include "quality_options.h"
#include "setting.h"

/* How a lens and an eye of the lists are set up, but for the scene. */
struct setting quality_setting(const struct quality_options *options, int lens, int eye);

/*
 * Whether scenes have names that there are, the folder of pictures can be written, and every lens
 * can be planned for every eye; false with one line in `message`. Needs no GL.
 */
bool quality_check(const struct quality_options *options, char *message);

#endif
