/* Lines of a script: read, bounded, and parted into words. */
#include "tool/script_line.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "option_values.h"

/* Reads a line without its end. SCRIPT_END at the end of the stream. */
static enum script_next read_line(struct script_line *line, FILE *stream, char *message)
{
    int length = 0, byte;

    while ((byte = getc(stream)) != EOF && byte != '\n') {
        if (byte == '\0' || length == SCRIPT_LINE_MAX - 1) {
            snprintf(message, MESSAGE_SIZE, "%s; allowed: lines of text, up to %d bytes",
                     byte ? "the line is too long" : "there is a byte 0", SCRIPT_LINE_MAX - 1);
            return SCRIPT_REFUSED;
        }
        line->text[length++] = (char)byte;
    }
    if (byte == EOF && ferror(stream)) {
        snprintf(message, MESSAGE_SIZE, "the script cannot be read: %s", strerror(errno));
        return SCRIPT_REFUSED;
    }
    line->text[length] = '\0';
    return byte == EOF && length == 0 ? SCRIPT_END : SCRIPT_LINE;
}

static void skip_byte_order_mark(char *text)
{
    if (strncmp(text, "\xef\xbb\xbf", 3) == 0)
        memmove(text, text + 3, strlen(text + 3) + 1);
}

/* Where a word ends; NULL without a closing quote. */
static char *word_end(char *word)
{
    return *word == '"' ? strchr(word + 1, '"') : word + strcspn(word, " \t\r");
}

static bool part(struct script_line *line, char *message)
{
    char *at = line->text;

    for (line->count = 0;; line->count++) {
        char *end;
        at += strspn(at, " \t\r");
        if (*at == '\0' || *at == '#')
            return true;
        if (line->count == SCRIPT_WORDS_MAX) {
            snprintf(message, MESSAGE_SIZE, "more than %d words", SCRIPT_WORDS_MAX);
            return false;
        }
        end = word_end(at);
        if (!end) {
            snprintf(message, MESSAGE_SIZE, "a quote is not closed");
            return false;
        }
        line->words[line->count] = *at == '"' ? at + 1 : at;
        at = *end ? end + 1 : end;
        *end = '\0';
    }
}

enum script_next script_line_next(struct script_line *line, FILE *stream, char *message)
{
    do {
        enum script_next next;
        line->number++;
        next = read_line(line, stream, message);
        if (next != SCRIPT_LINE)
            return next;
        if (line->number == 1)
            skip_byte_order_mark(line->text);
        if (!part(line, message))
            return SCRIPT_REFUSED;
    } while (line->count == 0);
    return SCRIPT_LINE;
}
