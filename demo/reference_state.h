/*
 * What a reference that is under way has on disk: which picture, how many frames, and their sum. A
 * file FILE.part beside the --output FILE, which is replaced as a whole: whoever ends the program
 * at whatever moment leaves the last one that was complete.
 */
#ifndef REFERENCE_STATE_H
#define REFERENCE_STATE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { REFERENCE_COMMAND_MAX = 1024 };

struct reference_state {
    char command[REFERENCE_COMMAND_MAX]; /* the command line, for messages; cut if it is longer */
    uint64_t settings;                   /* all that the pictures depend on, as one number */
    int64_t picture;                     /* that is under way, from 0 */
    int64_t frames;                      /* of it that are in the sum */
    int64_t width, height;
    double *sum; /* RGBA in linear light, 4 width height of them; all zero before the first frame;
                  * of floats so many frames would not keep their last digits */
};

/*
 * Reads a state of the same settings, picture size included, into one that has all of that; where
 * there is no file, it stays as it is. False with one line in `message`, MESSAGE_SIZE bytes, where
 * the file is of other settings, or none of these.
 */
bool reference_state_read(const char *path, struct reference_state *state, char *message);

/* False with one line in `message`; what was there is there still. */
bool reference_state_write(const char *path, const struct reference_state *state, char *message);

/* Takes bytes into a number that begins as REFERENCE_NUMBER (FNV-1a, 64 bits). */
#define REFERENCE_NUMBER 14695981039346656037u
uint64_t reference_number(uint64_t number, const void *bytes, size_t count);

#endif
