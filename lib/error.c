/* Making of error messages, and what they mean in general. */
#include "error.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define TEXT_OF(x)                      #x
#define VERSION_OF(major, minor, patch) TEXT_OF(major) "." TEXT_OF(minor) "." TEXT_OF(patch)

const char *cupola_version(void)
{
    return VERSION_OF(CUPOLA_VERSION_MAJOR, CUPOLA_VERSION_MINOR, CUPOLA_VERSION_PATCH);
}

const char *cupola_status_text(int status)
{
    if (status >= 0)
        return "success";
    switch ((enum cupola_status)status) {
    case CUPOLA_OK:
        return "success";
    case CUPOLA_ERROR_ARGUMENT:
        return "a value outside of what is allowed";
    case CUPOLA_ERROR_MEMORY:
        return "out of memory";
    case CUPOLA_ERROR_FILE:
        return "a file cannot be opened, read or written";
    case CUPOLA_ERROR_SYNTAX:
        return "a file is not of the form that it should have";
    case CUPOLA_ERROR_LAYOUT:
        return "the layout cannot reach every ray";
    case CUPOLA_ERROR_CONTEXT:
        return "no current GL context, or one that is too old";
    case CUPOLA_ERROR_GL:
        return "the GL refused";
    case CUPOLA_ERROR_ORDER:
        return "a call at a moment when it makes no sense";
    case CUPOLA_ERROR_LOST:
        return "the GL context has been lost";
    }
    return "an unknown status";
}

int error_set(struct cupola_error *error, enum cupola_status status, const char *format, ...)
{
    if (!error)
        return status;
    error->status = status;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(error->message, sizeof error->message, format, arguments);
    va_end(arguments);
    return status;
}

void error_context(struct cupola_error *error, const char *format, ...)
{
    if (!error)
        return;
    char message[sizeof error->message];
    memcpy(message, error->message, sizeof message);
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(error->message, sizeof error->message, format, arguments);
    va_end(arguments);
    if (length >= 0 && (size_t)length < sizeof error->message)
        snprintf(error->message + length, sizeof error->message - (size_t)length, ": %s", message);
}
