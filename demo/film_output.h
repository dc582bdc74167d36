/* A sequence of pictures, or of places of the eye, without a window: a file for each frame. */
#ifndef FILM_OUTPUT_H
#define FILM_OUTPUT_H

#include "film.h"

/* Whether --output names one file for each frame. */
bool film_output_is_numbered(const struct options *options);

/* False with one line in `message` where --output is no name for what is drawn. */
bool film_output_check_options(const struct options *options, char *message);

/* How many files there will be: --frames, or as many as there are pictures; NULL: one turn. */
long film_output_frames(const struct options *options, const struct film *film);

/* The path of frame `index`, from 0: it has the number of its picture, and goes on counting where
 * the film starts again. Without a film it is numbered from 0. */
bool film_output_path(const struct options *options, const struct film *film, long index,
                      char path[PATH_MAX]);

/*
 * Before anything is drawn: whether all numbered files can probably be written, and no file that
 * the options write is a picture of the film itself. `picture` is the file of a single image, NULL
 * where there is none; so may `film` be. False with one line in `message`, MESSAGE_SIZE bytes.
 */
bool film_output_check_files(const struct options *options, const struct film *film,
                             const char *picture, char *message);

#endif
