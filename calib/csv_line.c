/* Lines of CSV in memory. */
#include "csv_line.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "option_values.h"
#include "short_path.h"

void csv_line_begin(struct csv_line *line, const char *path, char *text, size_t size)
{
    *line = (struct csv_line){.path = path, .number = 1, .next_number = 1};
    line->at = text;
    line->end = text + size;
    if (size >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0)
        line->at += 3;
}

bool csv_line_refuse(const struct csv_line *line, char *message, const char *format, ...)
{
    va_list arguments;
    int used =
        snprintf(message, MESSAGE_SIZE, "%s:%d: ", short_path(line->path).text, line->number);

    va_start(arguments, format);
    vsnprintf(message + used, (size_t)(MESSAGE_SIZE - used), format, arguments);
    va_end(arguments);
    return false;
}

/* Cuts the next line out and goes behind it. */
static char *cut_line(struct csv_line *line, size_t *length)
{
    char *start = line->at, *stop = start;

    while (stop < line->end && *stop != '\n' && *stop != '\r')
        stop++;
    line->at = stop;
    if (line->at < line->end)
        line->at += stop[0] == '\r' && stop + 1 < line->end && stop[1] == '\n' ? 2 : 1;
    *stop = 0;
    *length = (size_t)(stop - start);
    line->number = line->next_number++;
    return start;
}

static char *skip_blanks(char *at)
{
    return at + strspn(at, " \t");
}

/* Undoubles the quotes in place. Behind the closing one; NULL where there is none. */
static char *unquote(char *at)
{
    char *to = at;

    for (at++; *at; at++) {
        if (*at == '"' && at[1] != '"') {
            *to = 0;
            return at + 1;
        }
        at += *at == '"';
        *to++ = *at;
    }
    return NULL;
}

static void cut_blanks_off(char *start, char *stop)
{
    while (stop > start && (stop[-1] == ' ' || stop[-1] == '\t'))
        stop--;
    *stop = 0;
}

/* One field from `at`; *next is behind it: a comma or the end. */
static bool take_field(struct csv_line *line, char *at, char **next, char *message)
{
    char *start = skip_blanks(at);

    if (line->count == CSV_FIELDS_MAX)
        return csv_line_refuse(line, message, "has more than %d fields", CSV_FIELDS_MAX);
    line->fields[line->count++] = start;
    if (*start != '"') {
        *next = start + strcspn(start, ",");
        return true;
    }
    char *behind = unquote(start);
    if (!behind)
        return csv_line_refuse(line, message, "a quote is not closed; allowed: in pairs");
    *next = skip_blanks(behind);
    if (**next && **next != ',')
        return csv_line_refuse(line, message,
                               "'%.40s' after a closing quote; allowed: a comma or the end", *next);
    return true;
}

static bool split(struct csv_line *line, char *text, char *message)
{
    char *at = text, *next = text;
    bool quoted, more;

    line->count = 0;
    do {
        quoted = *skip_blanks(at) == '"';
        if (!take_field(line, at, &next, message))
            return false;
        more = *next == ',';
        if (!quoted)
            cut_blanks_off(line->fields[line->count - 1], next);
        at = next + 1;
    } while (more);
    return true;
}

enum csv_next csv_line_next(struct csv_line *line, char *message)
{
    while (line->at < line->end) {
        size_t length;
        char *text = cut_line(line, &length);
        if (strlen(text) != length) {
            csv_line_refuse(line, message, "holds a byte of value 0; allowed: text");
            return CSV_REFUSED;
        }
        char *first = skip_blanks(text);
        if (!*first || *first == '#')
            continue;
        return split(line, text, message) ? CSV_LINE : CSV_REFUSED;
    }
    return CSV_END;
}
