/*
 * Existing pictures as what is shown: one, or a sequence of numbered files; each a PNG, a JPEG or
 * whatever else stb_image reads, or a PFM. A cube is six files.
 */
#ifndef FILM_H
#define FILM_H

#include <limits.h>
#include <stdbool.h>

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

/* The number in the name of the first picture, and how many there are; 0 and 1 without numbers. */
long film_first(const struct film *film);
long film_count(const struct film *film);

/* How many files a picture is, and the path of one. False where that would be too long. */
int film_faces(const struct film *film);
bool film_path(const struct film *film, long index, int face, char path[PATH_MAX]);

/* Lives as long as the film. */
const struct cupola_source *film_source(const struct film *film);

#endif
