/* Telling the host's log what happens; cupola/log.h has the levels and ids. */
#ifndef LOG_PRIVATE_H
#define LOG_PRIVATE_H

#include <stdarg.h>

#include "cupola/error.h"
#include "cupola/log.h"

/* CUPOLA_ERROR_ARGUMENT where `most` is no level. */
int log_check(const struct cupola_log *log, struct cupola_error *error);

/* One line, if anybody listens and the level is wished for; longer ones than an error are cut. */
__attribute__((format(printf, 4, 5))) void log_tell(const struct cupola_log *log, int level, int id,
                                                    const char *format, ...);
__attribute__((format(printf, 4, 0))) void log_tell_list(const struct cupola_log *log, int level,
                                                         int id, const char *format,
                                                         va_list arguments);

#endif
