/* An interruption that waits until what is under way is done. */
#ifndef INTERRUPTION_H
#define INTERRUPTION_H

#include <stdbool.h>

/*
 * From now on the first SIGINT or SIGTERM only asks for the end; the next one, either of them, ends
 * at once.
 */
void interruption_expect(void);

/* Whether the end was asked for. */
bool interruption_asked(void);

#endif
