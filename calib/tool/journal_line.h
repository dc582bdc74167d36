/* One line of a journal: its number, its text, and a checksum of both. */
#ifndef JOURNAL_LINE_H
#define JOURNAL_LINE_H

#include <stdbool.h>
#include <stddef.h>

/*
 * Bytes of a line's text with its 0: there is room for the longest path that a system takes, were
 * each byte of it written as three.
 */
enum { JOURNAL_TEXT_MAX = 3 * 4096 + 64 };

/* A text that grows by words. What does not fit makes it `full`, and no line. */
struct journal_text {
    char text[JOURNAL_TEXT_MAX];
    size_t length;
    bool full;
};

/* Adds a word, a blank before it unless it is the first. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void journal_text_add(struct journal_text *text, const char *format, ...);

/* Adds any bytes as a word: blanks, %, and what is not printable as %20. */
void journal_text_add_name(struct journal_text *text, const char *name);

/* What such a word said, in its place. False where it is none. */
bool journal_name_decode(char *word);

/* The line with its end; `line` has room for JOURNAL_TEXT_MAX + 64 bytes. Returns its length. */
size_t journal_line_print(char *line, long number, const struct journal_text *text);

/* Whether a line, without its end, is whole; number and text (a copy) if so. */
bool journal_line_check(const char *line, size_t length, long *number, struct journal_text *text);

/* The next word behind *at, which moves on; NULL at the end. The text is written into. */
char *journal_word(char **at);

/* `count` numbers, each a word. */
bool journal_numbers(char **at, int count, double *numbers);

/* One whole number from low to high. */
bool journal_integer(char **at, int low, int high, int *number);

#endif
