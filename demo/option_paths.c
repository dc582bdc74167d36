/* The values of command-line options that are names of files. */
#include "option_paths.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "option_values.h"
#include "output_file.h"
#include "short_path.h"

static bool is_png(const char *path)
{
    size_t length = strlen(path);
    return length > 4 && strcasecmp(path + length - 4, ".png") == 0;
}

/* An option without its file would take the next option for one. */
static bool is_option(const struct value_context *context, const char *text)
{
    if (strncmp(text, "--", 2) != 0)
        return false;
    snprintf(context->message, MESSAGE_SIZE,
             "%s: '%s' looks like an option; allowed: the name of a file, ./%s for this one",
             context->option, short_path(text).text, short_path(text).text);
    return true;
}

bool value_output_path(const struct value_context *context, const char *text, const char **path)
{
    if (is_option(context, text))
        return false;
    if (is_png(text) || output_file_is_pfm(text)) {
        *path = text;
        return true;
    }
    snprintf(context->message, MESSAGE_SIZE,
             "%s: '%s' is not allowed; allowed: FILE.png or FILE.pfm", context->option,
             short_path(text).text);
    return false;
}

bool value_png_path(const struct value_context *context, const char *text, const char **path)
{
    if (is_option(context, text))
        return false;
    if (is_png(text)) {
        *path = text;
        return true;
    }
    snprintf(context->message, MESSAGE_SIZE, "%s: '%s' is not allowed; allowed: FILE.png",
             context->option, short_path(text).text);
    return false;
}

bool value_path(const struct value_context *context, const char *text, const char **path)
{
    if (is_option(context, text))
        return false;
    if (*text) {
        *path = text;
        return true;
    }
    snprintf(context->message, MESSAGE_SIZE, "%s: '' is not allowed; allowed: the name of a file",
             context->option);
    return false;
}
