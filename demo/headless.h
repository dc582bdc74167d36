/*
 * A GL context without a display: EGL on a device where there is one, else on no surface at all.
 */
#ifndef HEADLESS_H
#define HEADLESS_H

#include <stddef.h>

struct headless;

/*
 * Makes a context of OpenGL 3.3 core (or newer) current on this thread. It has no default
 * framebuffer to draw to. NULL on failure, with one line in `message`.
 */
struct headless *headless_create(char *message, size_t message_size);

/* The same of OpenGL ES 3.0 (or newer). A process can have one kind only: the GL is found once. */
struct headless *headless_create_es(char *message, size_t message_size);

/* Destroys it; NULL is allowed. */
void headless_destroy(struct headless *headless);

#endif
