/*
 * Lines of CSV in memory: fields by commas, blanks round them cut off, in double quotes where they
 * hold a comma ("" is a quote). Empty lines and those that begin with # are passed over, a byte
 * order mark too; lines end by LF, CR LF or CR.
 */
#ifndef CSV_LINE_H
#define CSV_LINE_H

#include <stdbool.h>
#include <stddef.h>

enum { CSV_FIELDS_MAX = 64 };

struct csv_line {
    const char *path; /* for messages */
    int number;       /* of the line, from 1 */
    int count;
    char *fields[CSV_FIELDS_MAX]; /* in the text */
    char *at, *end;               /* what has not been read yet */
    int next_number;
};

enum csv_next { CSV_LINE, CSV_END, CSV_REFUSED };

/* `text` has a 0 at text[size], lives as long as the fields do and is written into. */
void csv_line_begin(struct csv_line *line, const char *path, char *text, size_t size);

/* CSV_REFUSED with one line in `message`, MESSAGE_SIZE bytes. */
enum csv_next csv_line_next(struct csv_line *line, char *message);

/* Writes "file:line: " and what the format says into `message`. Returns false. */
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
bool csv_line_refuse(const struct csv_line *line, char *message, const char *format, ...);

#endif
