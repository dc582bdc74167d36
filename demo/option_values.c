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

/* In long double, so that 120 degrees are written to a rig file as 120 again. */
double angle_rad(const char *text_deg)
{
    return (double)(strtold(text_deg, NULL) * (3.14159265358979323846264338327950288L / 180));
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
        *number = range.degrees ? angle_rad(text) : parsed;
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
                   struct number_range range, int least, int most, double *numbers)
{
    double parsed[8] = {0};
    char part[64];
    char allowed[80];
    const char *at = text;

    for (int i = 0; i < most; i++) {
        size_t length = strcspn(at, ",");
        bool last = at[length] == 0;
        if (length >= sizeof part || (last && i + 1 < least) || (!last && i + 1 == most))
            goto fail;
        memcpy(part, at, length);
        part[length] = 0;
        if (!parse_number(part, &parsed[i]) || !in_range(range, parsed[i]))
            goto fail;
        if (range.degrees)
            parsed[i] = angle_rad(part);
        if (last)
            break;
        at += length + 1;
    }
    memcpy(numbers, parsed, (size_t)most * sizeof *numbers);
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

const char *goal_name(int index)
{
    static const char *const names[] = {"fill", "vertices", "auto"};

    return index >= 0 && index < 3 ? names[index] : NULL;
}
