/* The commands of `cupola-calib capture`. Each returns an exit status, with one line in `message`,
 * MESSAGE_SIZE bytes, where that is not STATUS_OK. */
#ifndef CAPTURE_COMMAND_H
#define CAPTURE_COMMAND_H

#include "capture/camera.h"
#include "capture/options.h"
#include "capture/series.h"

int capture_patterns(const struct capture_options *options, char *message);
int capture_show(const struct capture_options *options, char *message);
int capture_decode(const struct capture_options *options, char *message);
int capture_simulate(const struct capture_options *options, char *message);

/* The rest is what they share. */

/* --rig and --projector. */
int capture_rig(const struct capture_options *options, struct cupola_rig *rig, char *message);

/* The patterns, which must be of the size of the rig's projector; NULL: of any. */
int capture_series(const char *folder, const struct cupola_rig *rig, int projector,
                   struct series *series, char *message);

/* One of its pictures as light, to be freed. */
bool capture_picture(const struct series *series, int number, struct photo *photo, char *message);

/* --camera and its like, for photographs of this size. */
int capture_camera(const struct capture_options *options, const struct cupola_rig *rig, int width,
                   int height, struct camera *camera, char *message);

#endif
