/*
 * Existing pictures as what is shown: one, or a sequence of numbered files; each a PNG, a JPEG or
 * whatever else stb_image reads, or a PFM. A cube is six files.
 */
#ifndef FILM_H
#define FILM_H

#include <cupola/source.h>

#include "options.h"

struct film;

/* NULL with one line in `message`, MESSAGE_SIZE bytes. Runs where a GL context is current. */
struct film *film_create(const struct options *options, char *message);

/* NULL is allowed. */
void film_destroy(struct film *film);

/*
 * Makes picture `index` of the sequence, from 0, the one that is shown; after the last comes the
 * first again. False with one line in `message`; the picture before is still shown then.
 */
bool film_seek(struct film *film, long index, char *message);

/* The index of the picture to be seen at a time after the start. */
long film_index(const struct film *film, double time_ms);

/* Lives as long as the film. */
const struct cupola_source *film_source(const struct film *film);

#endif
