/* An ordinary camera that looks at the library's simulated theatre, without a display. */
#ifndef SIMULATE_GL_H
#define SIMULATE_GL_H

#include "capture/simulate.h"

struct gl_camera;

/* NULL with one line in `message`, MESSAGE_SIZE bytes, also where there is no GL. */
struct gl_camera *gl_camera_create(const struct simulation *simulation, char *message);
void gl_camera_destroy(struct gl_camera *camera);

/* Light of the screen, ambient and shown, into a photograph that is there. */
bool gl_camera_take(struct gl_camera *camera, const struct photo *shown, struct photo *photo,
                    char *message);

#endif
