/* The values of command-line options as numbers and names. */
#include "option_values.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool parse_number(const char *text, double *number)
{
    char *end;
    double parsed;

    /* Narrower than strtod: no blanks, no hexadecimal, no names of numbers. */
    if (!*text || text[strspn(text, "0123456789+-.eE")])
        return false;
    parsed = strtod(text, &end);
    if (*end || !isfinite(parsed))
        return false;
    *number = parsed;
    return true;
}

static void describe_range(struct number_range range, char *text, size_t text_size)
{
    if (range.low == -HUGE_VAL)
        snprintf(text, text_size, "any number");
    else if (range.high == HUGE_VAL)
        snprintf(text, text_size, "%s %g", range.above_low ? "above" : "at least", range.low);
    else if (range.above_low)
        snprintf(text, text_size, "above %g and up to %g", range.low, range.high);
    else
        snprintf(text, text_size, "%g to %g", range.low, range.high);
}

static bool in_range(struct number_range range, double number)
{
    return number <= range.high && (range.above_low ? number > range.low : number >= range.low);
}

bool value_number(const struct value_context *context, const char *text, struct number_range range,
                  double *number)
{
    double parsed;
    char allowed[80];

    if (parse_number(text, &parsed) && in_range(range, parsed)) {
        *number = parsed;
        return true;
    }
    describe_range(range, allowed, sizeof allowed);
    snprintf(context->message, MESSAGE_SIZE, "%s: '%.200s' is not allowed; allowed: a number, %s",
             context->option, text, allowed);
    return false;
}

bool value_integer(const struct value_context *context, const char *text, int low, int high,
                   int *number)
{
    char *end;
    long parsed;

    errno = 0;
    parsed = strtol(text, &end, 10);
    if (text[0] && !text[strspn(text, "0123456789+-")] && !*end && !errno && parsed >= low &&
        parsed <= high) {
        *number = (int)parsed;
        return true;
    }
    snprintf(context->message, MESSAGE_SIZE,
             "%s: '%.200s' is not allowed; allowed: a whole number, %d to %d", context->option,
             text, low, high);
    return false;
}

bool value_numbers(const struct value_context *context, const char *text, const char *shape,
                   struct number_range range, int count, double *numbers)
{
    double parsed[8];
    char part[64];
    char allowed[80];
    const char *at = text;

    for (int i = 0; i < count; i++) {
        size_t length = strcspn(at, ",");
        bool last = i == count - 1;
        if (length >= sizeof part || (at[length] == ',') == last)
            goto fail;
        memcpy(part, at, length);
        part[length] = 0;
        if (!parse_number(part, &parsed[i]) || !in_range(range, parsed[i]))
            goto fail;
        at += length + 1;
    }
    memcpy(numbers, parsed, (size_t)count * sizeof *numbers);
    return true;

fail:
    describe_range(range, allowed, sizeof allowed);
    snprintf(context->message, MESSAGE_SIZE,
             "%s: '%.200s' is not allowed; allowed: %s, each a number, %s", context->option, text,
             shape, allowed);
    return false;
}

bool value_size(const struct value_context *context, const char *text, int *width, int *height)
{
    char part[32];
    const char *cross = strchr(text, 'x');
    double numbers[2];

    if (!cross || (size_t)(cross - text) >= sizeof part)
        goto fail;
    memcpy(part, text, (size_t)(cross - text));
    part[cross - text] = 0;
    if (strspn(part, "0123456789") != strlen(part) ||
        strspn(cross + 1, "0123456789") != strlen(cross + 1))
        goto fail;
    if (!parse_number(part, &numbers[0]) || !parse_number(cross + 1, &numbers[1]))
        goto fail;
    if (!(numbers[0] >= 1 && numbers[0] <= 32768 && numbers[1] >= 1 && numbers[1] <= 32768))
        goto fail;
    *width = (int)numbers[0];
    *height = (int)numbers[1];
    return true;

fail:
    snprintf(context->message, MESSAGE_SIZE,
             "%s: '%.200s' is not allowed; allowed: WxH, whole numbers, 1 to 32768 each",
             context->option, text);
    return false;
}

void value_name_list(const char *(*name_of)(int index), char *list, size_t list_size)
{
    size_t used = 0;
    const char *name;

    list[0] = 0;
    for (int i = 0; (name = name_of(i)) && used < list_size; i++)
        used += (size_t)snprintf(list + used, list_size - used, "%s%s", i ? ", " : "", name);
}

bool value_name(const struct value_context *context, const char *text,
                const char *(*name_of)(int index), int *index)
{
    char list[400];
    const char *name;

    for (int i = 0; (name = name_of(i)); i++) {
        if (strcmp(name, text) == 0) {
            *index = i;
            return true;
        }
    }
    value_name_list(name_of, list, sizeof list);
    snprintf(context->message, MESSAGE_SIZE, "%s: '%.200s' is not allowed; allowed: %s",
             context->option, text, list);
    return false;
}

/* One line of a lens table; `order` is the line before it, NULL for the first. */
static bool table_line(const char *line, const struct cupola_lens_sample *order,
                       struct cupola_lens_sample *sample, const char **problem)
{
    char part[64];
    const char *comma = strchr(line, ',');
    double angle_deg;

    *problem = "allowed: angle_deg,radius, two numbers";
    if (!comma || (size_t)(comma - line) >= sizeof part)
        return false;
    memcpy(part, line, (size_t)(comma - line));
    part[comma - line] = 0;
    if (!parse_number(part, &angle_deg) || !parse_number(comma + 1, &sample->radius))
        return false;
    *problem = "allowed: an angle of 0 to 180 and a radius of at least 0";
    if (!(angle_deg >= 0 && angle_deg <= 180 && sample->radius >= 0))
        return false;
    sample->angle_rad = angle_deg * (3.14159265358979323846 / 180);
    *problem = "allowed: angles and radii that grow from line to line";
    return !order || (sample->angle_rad > order->angle_rad && sample->radius > order->radius);
}

/* Takes blanks and the line's end away, in place. */
static char *without_blanks(char *line)
{
    char *to = line;

    for (const char *from = line; *from; from++)
        if (!strchr(" \t\r\n", *from))
            *to++ = *from;
    *to = 0;
    return line;
}

bool lens_table_read(const char *path, struct cupola_lens *lens, char *message)
{
    char line[256];
    int number = 0, count = 0;
    const char *problem = NULL;
    FILE *file = fopen(path, "r");

    if (!file) {
        snprintf(message, MESSAGE_SIZE, "%.400s: %s", path, strerror(errno));
        return false;
    }
    while (!problem && fgets(line, sizeof line, file)) {
        number++;
        if (!strchr(line, '\n') && !feof(file)) {
            problem = "the line is too long or holds a zero byte; allowed: angle_deg,radius";
            break;
        }
        without_blanks(line);
        if (!*line || *line == '#' || (count == 0 && strcmp(line, "angle_deg,radius") == 0))
            continue;
        if (count == CUPOLA_LENS_TABLE_MAX)
            problem = "one line too many; allowed: 2 to 64 lines";
        else if (table_line(line, count ? &lens->table[count - 1] : NULL, &lens->table[count],
                            &problem))
            count++, problem = NULL;
    }
    if (!problem && ferror(file))
        problem = "the file cannot be read; allowed: text with lines angle_deg,radius";
    else if (!problem && count < 2)
        problem = "the table ends here; allowed: 2 to 64 lines angle_deg,radius";
    fclose(file);
    if (problem) {
        snprintf(message, MESSAGE_SIZE, "%.400s:%d: %s", path, number, problem);
        return false;
    }
    lens->table_count = count;
    return true;
}
