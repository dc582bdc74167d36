/* Telling the host's log what happens. */
#include "log.h"

#include <stdio.h>

#include "error.h"
#include "names.h"

static const char *const level_names[] = {
    [CUPOLA_LOG_ERROR] = "error",
    [CUPOLA_LOG_WARNING] = "warning",
    [CUPOLA_LOG_INFO] = "info",
    [CUPOLA_LOG_DEBUG] = "debug",
};

enum {
    LEVEL_COUNT = sizeof level_names / sizeof level_names[0],
    TEXT_MAX = sizeof((struct cupola_error *)0)->message + 64, /* with the name of a call */
};

const char *cupola_log_level_name(int level)
{
    return name_of_number(level_names, LEVEL_COUNT, level);
}

int log_check(const struct cupola_log *log, struct cupola_error *error)
{
    if (cupola_log_level_name(log->most))
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_ARGUMENT, "log's highest level is %d; allowed: 0 to %d",
                     log->most, LEVEL_COUNT - 1);
}

void log_tell_list(const struct cupola_log *log, int level, int id, const char *format,
                   va_list arguments)
{
    char text[TEXT_MAX];
    /* An error is told even to a log whose highest level is none and is refused for that. */
    if (!log->write || (level > log->most && level != CUPOLA_LOG_ERROR))
        return;
    vsnprintf(text, sizeof text, format, arguments);
    for (char *c = text; *c; c++)
        if (*c == '\n')
            *c = ' ';
    log->write(level, id, text, log->user);
}

void log_tell(const struct cupola_log *log, int level, int id, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    log_tell_list(log, level, id, format, arguments);
    va_end(arguments);
}
