/* One line of a script, as words. */
#ifndef SCRIPT_LINE_H
#define SCRIPT_LINE_H

#include <stdbool.h>
#include <stdio.h>

enum { SCRIPT_LINE_MAX = 4096, SCRIPT_WORDS_MAX = 16 };

struct script_line {
    int number; /* from 1 */
    int count;
    char *words[SCRIPT_WORDS_MAX]; /* in the text */
    char text[SCRIPT_LINE_MAX];
};

enum script_next { SCRIPT_LINE, SCRIPT_END, SCRIPT_REFUSED };

/*
 * The next line that has words. They are parted by blanks; in double quotes a word may have blanks,
 * too; # begins a comment. SCRIPT_REFUSED with what is wrong in `message`, MESSAGE_SIZE bytes.
 */
enum script_next script_line_next(struct script_line *line, FILE *stream, char *message);

#endif
