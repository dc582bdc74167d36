/*
 * How a call says that it failed.
 *
 * Every call that can fail returns 0 or a positive number on success and a negative
 * `enum cupola_status` on failure, and a call that failed has changed nothing. NULL in place of a
 * handle or of a pointer that is needed is such a failure: calls that return a number return
 * CUPOLA_ERROR_ARGUMENT, calls that return a pointer return NULL, calls that count return 0, and
 * calls that return nothing do nothing. Where more can be
 * said, the call takes a `struct cupola_error` last; NULL means that the caller does not want it.
 * The message is one sentence in English without a final newline; it names the thing, its value
 * and what is allowed.
 */
#ifndef CUPOLA_ERROR_H
#define CUPOLA_ERROR_H

#include "version.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a call that can fail returns. */
enum cupola_status {
    CUPOLA_OK = 0,              /* nothing failed; calls that count return more */
    CUPOLA_ERROR_ARGUMENT = -1, /* a value outside of what is allowed */
    CUPOLA_ERROR_MEMORY = -2,   /* out of memory, in the process or on the GPU */
    CUPOLA_ERROR_FILE = -3,     /* a file cannot be opened, read or written */
    CUPOLA_ERROR_SYNTAX = -4,   /* a file is not of the form that it should have */
    CUPOLA_ERROR_LAYOUT = -5,   /* the wished layout cannot reach every ray */
    CUPOLA_ERROR_CONTEXT = -6,  /* no current GL context, or one that is too old */
    CUPOLA_ERROR_GL = -7,       /* the GL refused something that it should have done */
    CUPOLA_ERROR_ORDER = -8,    /* a call at a moment when it makes no sense */
    CUPOLA_ERROR_LOST = -9,     /* the GL context has been lost: make anew what lived in it */
};

/* What failed, in words. */
struct cupola_error {
    enum cupola_status status; /* CUPOLA_OK while nothing failed */
    char message[1024];        /* empty while nothing failed; cut off where it is longer */
};

/*
 * What a status means, in general terms.
 *
 * status   any number; positive ones count as CUPOLA_OK
 * returns  a static string, never NULL
 * thread   any
 * since    0.1
 */
CUPOLA_API const char *cupola_status_text(int status);

#ifdef __cplusplus
}
#endif

#endif
