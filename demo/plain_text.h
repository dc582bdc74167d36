/* Text that a terminal shows and does not obey. */
#ifndef PLAIN_TEXT_H
#define PLAIN_TEXT_H

#include <stdbool.h>
#include <stdio.h>

/* Whether it is UTF-8 without control characters. */
bool plain_text_is(const char *text);

/* Prints it with a question mark for each byte that is none of such text. */
void plain_text_print(const char *text, FILE *stream);

#endif
