/*
 * Pictures that are each the mean of many frames, whose samples lie beside the middles of pixels
 * and of the views' texels. What is done is on disk (reference_state.h): the same command goes on
 * where it was ended, and comes to the same pictures.
 */
#ifndef REFERENCE_H
#define REFERENCE_H

#include "show.h"
#include "target.h"
#include "world.h"

/* In place of STATUS_OK where the end was asked for and there is more to be done. */
enum { STATUS_INTERRUPTED = 3 };

struct reference;

/*
 * `output`: a file, or a pattern; world: what is shown. The target is of floats,
 * in linear light; with `encoded` the files are sRGB. NULL with one line in `message`,
 * MESSAGE_SIZE bytes. Runs where a GL context is current.
 */
struct reference *reference_create(const struct options *options, const char *output, long pictures,
                                   const struct world *world, const struct target *target,
                                   bool encoded, char *message);

/* NULL is allowed. */
void reference_destroy(struct reference *reference);

/* The first picture that is not complete, from 0. */
long reference_first(const struct reference *reference);

/*
 * Draws what is missing of a picture, writes it to a file, and what is on disk of it goes.
 * STATUS_OK, STATUS_INTERRUPTED or STATUS_FAILED, the latter two with one line in `message`.
 */
int reference_draw(struct reference *reference, struct show *show, const struct show_frame *frame,
                   long picture, const char *path, char *message);

#endif
