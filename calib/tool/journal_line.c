/* Lines of a journal: as text with a checksum (FNV-1a, 64 bits), and word by word. */
#include "tool/journal_line.h"

#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "option_values.h"

void journal_text_add(struct journal_text *text, const char *format, ...)
{
    size_t room = sizeof text->text - text->length;
    va_list values;
    int length;

    if (text->length > 0 && room > 1) {
        text->text[text->length++] = ' ';
        room--;
    }
    va_start(values, format);
    length = vsnprintf(text->text + text->length, room, format, values);
    va_end(values);
    if (length < 0 || (size_t)length >= room)
        text->full = true;
    else
        text->length += (size_t)length;
}

void journal_text_add_name(struct journal_text *text, const char *name)
{
    static const char digits[] = "0123456789abcdef";

    journal_text_add(text, "%s", "");
    for (; *name; name++) {
        unsigned char byte = (unsigned char)*name;
        bool plain = byte > 0x20 && byte != '%' && byte != 0x7f;
        if (text->length + 4 > sizeof text->text) {
            text->full = true;
            return;
        }
        if (!plain) {
            text->text[text->length++] = '%';
            text->text[text->length++] = digits[byte >> 4];
            byte = (unsigned char)digits[byte & 15];
        }
        text->text[text->length++] = (char)byte;
        text->text[text->length] = '\0';
    }
}

static int digit(char character)
{
    if (character >= '0' && character <= '9')
        return character - '0';
    return character >= 'a' && character <= 'f' ? character - 'a' + 10 : -1;
}

bool journal_name_decode(char *word)
{
    char *to = word;

    for (; *word; word++) {
        if (*word != '%') {
            *to++ = *word;
            continue;
        }
        if (digit(word[1]) < 0 || digit(word[2]) < 0 || (digit(word[1]) | digit(word[2])) == 0)
            return false;
        *to++ = (char)(digit(word[1]) << 4 | digit(word[2]));
        word += 2;
    }
    *to = '\0';
    return true;
}

static unsigned long long checksum(const char *bytes, size_t count)
{
    uint64_t sum = 0xcbf29ce484222325u;

    for (size_t i = 0; i < count; i++)
        sum = (sum ^ (unsigned char)bytes[i]) * 0x100000001b3u;
    return sum;
}

size_t journal_line_print(char *line, long number, const struct journal_text *text)
{
    size_t room = JOURNAL_TEXT_MAX + 64;
    size_t length = (size_t)snprintf(line, room, "%ld %s", number, text->text);

    return length +
           (size_t)snprintf(line + length, room - length, " #%016llx\n", checksum(line, length));
}

bool journal_line_check(const char *line, size_t length, long *number, struct journal_text *text)
{
    enum {
        TAIL = 18,             /* " #" and the checksum */
        NUMBER_DIGITS_MAX = 9, /* whatever a long holds */
    };
    char tail[TAIL + 2];
    size_t digits = 0;

    if (length <= TAIL || length >= JOURNAL_TEXT_MAX + 40 || *line < '1' || *line > '9' ||
        memchr(line, '\0', length))
        return false;
    length -= TAIL;
    snprintf(tail, sizeof tail, " #%016llx", checksum(line, length));
    if (memcmp(tail, line + length, TAIL) != 0)
        return false;
    for (*number = 0; digits < length && line[digits] >= '0' && line[digits] <= '9'; digits++) {
        if (digits == NUMBER_DIGITS_MAX)
            return false;
        *number = 10 * *number + (line[digits] - '0');
    }
    if (digits + 1 >= length || line[digits] != ' ' || length - digits - 1 >= sizeof text->text)
        return false;
    text->length = length - digits - 1;
    text->full = false;
    memcpy(text->text, line + digits + 1, text->length);
    text->text[text->length] = '\0';
    return true;
}

char *journal_word(char **at)
{
    char *word = *at + strspn(*at, " ");

    if (*word == '\0')
        return NULL;
    *at = word + strcspn(word, " ");
    if (**at)
        *(*at)++ = '\0';
    return word;
}

bool journal_numbers(char **at, int count, double *numbers)
{
    for (int i = 0; i < count; i++) {
        const char *word = journal_word(at);
        if (!word || !parse_number(word, &numbers[i]))
            return false;
    }
    return true;
}

bool journal_integer(char **at, int low, int high, int *number)
{
    double value;

    if (!journal_numbers(at, 1, &value) || !(value >= low && value <= high) ||
        value != floor(value))
        return false;
    *number = (int)value;
    return true;
}
