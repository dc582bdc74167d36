/*
 * What every fuzz target shares: the entry that libFuzzer and replay.c call, and a check that ends
 * the program where an invariant does not hold, so that both notice.
 */
#ifndef TARGET_H
#define TARGET_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cupola/error.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#define require(condition)                                                                         \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            fprintf(stderr, "%s:%d: does not hold: %s\n", __FILE__, __LINE__, #condition);         \
            abort();                                                                               \
        }                                                                                          \
    } while (0)

/* A refusal is of the status returned, and its message is one line. */
static inline void require_message(const struct cupola_error *error, int status)
{
    require(status < 0 && (int)error->status == status);
    require(error->message[0] != 0);
    require(memchr(error->message, 0, sizeof error->message) != NULL);
    require(strpbrk(error->message, "\n\r") == NULL);
}

#endif
