/*
 * A camera by V4L2, through libv4l2, which turns what the camera has into RGB. Its frames are
 * taken for sRGB.
 */
#ifndef DEVICE_H
#define DEVICE_H

#include "capture/photo.h"

struct device;

/*
 * Opens a camera and lets it run. width, height: asked of it, 0: its own; it may choose others.
 * NULL with one line in `message`, MESSAGE_SIZE bytes.
 */
struct device *device_open(const char *path, int width, int height, char *message);

/*
 * Waits until the light of its frames no longer changes, and holds exposure, gain and white balance
 * where they are then; what the projector shows meanwhile should be all light. `held` is whether
 * the camera lets its exposure be held. False with one line in `message`.
 */
bool device_settle(struct device *device, bool *held, char *message);

/* Passes over `skipped` frames, then averages `shots`. False with one line in `message`. */
bool device_take(struct device *device, int skipped, int shots, struct photo *photo, char *message);

/* NULL is allowed. */
void device_close(struct device *device);

#endif
