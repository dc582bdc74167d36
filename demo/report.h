/* The resolution of a plan as JSON: --report. */
#ifndef REPORT_H
#define REPORT_H

#include <stdbool.h>

#include <cupola/plan.h>

/*
 * Writes it to a file, which appears whole or not at all, or to stdout for "-". False with one line
 * in `message`, MESSAGE_SIZE bytes.
 */
bool report_write(const char *path, const cupola_plan *plan, char *message);

#endif
