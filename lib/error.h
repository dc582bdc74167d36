/* Making of error messages, for all of the library. */
#ifndef ERROR_PRIVATE_H
#define ERROR_PRIVATE_H

#include "cupola/error.h"

/*
 * Fills in an error (NULL: nobody wants it) and returns its status, so that a check reads
 * `return error_set(error, CUPOLA_ERROR_ARGUMENT, "radius is %g; allowed: above 0", radius);`.
 */
__attribute__((format(printf, 3, 4))) int error_set(struct cupola_error *error,
                                                    enum cupola_status status, const char *format,
                                                    ...);

/* Puts "context: " before the message, for callers who know where the value stands. */
__attribute__((format(printf, 2, 3))) void error_context(struct cupola_error *error,
                                                         const char *format, ...);

#endif
