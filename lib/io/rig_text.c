/* The text of a rig file, looked through before libconfig gets it. */
#include "rig_text.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "error.h"

enum { DEPTH_MAX = 16 };

struct scan {
    const char *name;
    char *at; /* in the copy for libconfig */
    char *value_end;
    int line;
    int depth;
    struct cupola_error *error;
};

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

static bool is_of_name(char c)
{
    return is_letter(c) || is_digit(c) || c == '_' || c == '-' || c == '*';
}

static bool begins_number(const char *at)
{
    return is_digit(*at) || *at == '.' || *at == '+' || *at == '-';
}

static bool is_of_number(char c)
{
    return is_letter(c) || is_digit(c) || c == '.' || c == '+' || c == '-' || c == '_';
}

static void skip_line(struct scan *scan)
{
    while (*scan->at && *scan->at != '\n')
        scan->at++;
}

static int skip_comment(struct scan *scan)
{
    int first_line = scan->line;
    for (scan->at += 2; *scan->at; scan->at++) {
        if (scan->at[0] == '*' && scan->at[1] == '/') {
            scan->at += 2;
            return CUPOLA_OK;
        }
        scan->line += *scan->at == '\n';
    }
    return error_set(scan->error, CUPOLA_ERROR_SYNTAX,
                     "%s:%d: comment has no end; allowed: /* ... */", scan->name, first_line);
}

/* Moves a text out of the copy for libconfig and leaves a 1 there; lines stay where they are. */
static char *move_out(struct scan *scan, size_t length)
{
    char *value = scan->value_end;
    memcpy(value, scan->at, length);
    value[length] = 0;
    scan->value_end += length + 1;
    for (size_t i = 0; i < length; i++)
        if (scan->at[i] != '\n')
            scan->at[i] = ' ';
    *scan->at = '1';
    scan->at += length;
    return value;
}

static int take_string(struct scan *scan)
{
    int first_line = scan->line;
    size_t length = 1;
    while (scan->at[length] && scan->at[length] != '"') {
        if (scan->at[length] == '\\' && scan->at[length + 1])
            length++;
        scan->line += scan->at[length] == '\n';
        length++;
    }
    if (!scan->at[length])
        return error_set(scan->error, CUPOLA_ERROR_SYNTAX,
                         "%s:%d: string has no end; allowed: \"...\"", scan->name, first_line);
    move_out(scan, length + 1);
    return CUPOLA_OK;
}

static int take_number(struct scan *scan)
{
    size_t length = 0;
    while (is_of_number(scan->at[length]))
        length++;
    char *end, *number = move_out(scan, length);
    double value = strtod(number, &end);
    bool decimal = end == number + length && !strpbrk(number, "xXnNfF");
    if (!decimal)
        return error_set(scan->error, CUPOLA_ERROR_SYNTAX,
                         "%s:%d: '%.40s' is no number; allowed: decimal numbers like 3, -0.5 or "
                         "1e-3",
                         scan->name, scan->line, number);
    if (!isfinite(value))
        return error_set(scan->error, CUPOLA_ERROR_ARGUMENT,
                         "%s:%d: number %.40s is too large; allowed: up to 1.7e308", scan->name,
                         scan->line, number);
    return CUPOLA_OK;
}

static int take_bracket(struct scan *scan)
{
    scan->depth += strchr("{[(", *scan->at) ? 1 : -1;
    scan->at++;
    if (scan->depth <= DEPTH_MAX)
        return CUPOLA_OK;
    return error_set(scan->error, CUPOLA_ERROR_SYNTAX,
                     "%s:%d: groups and lists are nested too deeply; allowed: %d levels",
                     scan->name, scan->line, (int)DEPTH_MAX);
}

static int take_one(struct scan *scan)
{
    char c = *scan->at;
    if (c == '#' || (c == '/' && scan->at[1] == '/')) {
        skip_line(scan);
    } else if (c == '/' && scan->at[1] == '*') {
        return skip_comment(scan);
    } else if (c == '"') {
        return take_string(scan);
    } else if (c == '@') {
        return error_set(scan->error, CUPOLA_ERROR_SYNTAX,
                         "%s:%d: @ begins an @include; allowed: a rig in one file, without "
                         "@include",
                         scan->name, scan->line);
    } else if (is_letter(c) || c == '*') {
        while (is_of_name(*scan->at))
            scan->at++;
    } else if (begins_number(scan->at)) {
        return take_number(scan);
    } else if (strchr("{}[]()", c)) {
        return take_bracket(scan);
    } else {
        scan->line += c == '\n';
        scan->at++;
    }
    return CUPOLA_OK;
}

int rig_text_open(const char *text, const char *name, struct rig_text *opened,
                  struct cupola_error *error)
{
    static const char byte_order_mark[] = "\xef\xbb\xbf";
    if (strncmp(text, byte_order_mark, 3) == 0)
        text += 3;
    size_t length = strlen(text);
    struct rig_text made = {
        /* libconfig does not see a comment that ends with the file: add a line's end. */
        .structure = malloc(length + 2),
        /* Every value with its final 0, and there is at most one per byte. */
        .values = malloc(2 * length + 1),
    };
    int status = CUPOLA_OK;
    if (!made.structure || !made.values) {
        status = error_set(error, CUPOLA_ERROR_MEMORY, "%s: out of memory", name);
        goto fail;
    }
    memcpy(made.structure, text, length);
    memcpy(made.structure + length, "\n", 2);
    struct scan scan = {name, made.structure, made.values, 1, 0, error};
    while (*scan.at && status == CUPOLA_OK)
        status = take_one(&scan);
    if (status != CUPOLA_OK)
        goto fail;
    made.next_value = made.values;
    made.end = scan.value_end;
    *opened = made;
    return CUPOLA_OK;

fail:
    rig_text_close(&made);
    return status;
}

void rig_text_close(struct rig_text *text)
{
    free(text->structure);
    free(text->values);
    *text = (struct rig_text){0};
}

const char *rig_text_next_value(struct rig_text *text)
{
    const char *value = text->next_value;
    if (value == text->end)
        return NULL;
    text->next_value += strlen(value) + 1;
    return value;
}

int rig_text_excerpt(const char *text, int line, char excerpt[RIG_EXCERPT_SIZE])
{
    int here = 1;
    const char *start = text;
    for (; here < line && *text; text++)
        if (*text == '\n' && text[1]) {
            start = text + 1;
            here++;
        }
    while (*start == ' ' || *start == '\t')
        start++;
    size_t length = 0;
    for (; *start && *start != '\n' && *start != '\r' && length < RIG_EXCERPT_SIZE - 1; start++)
        excerpt[length++] = *start >= ' ' && *start <= '~' ? *start : '?';
    excerpt[length] = 0;
    if (here < line || length == 0)
        strcpy(excerpt, "the end");
    return here;
}
