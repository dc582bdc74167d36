/* Runs the demo as a user does and keeps what it said. For the tests of its command line. */
#ifndef PROCESS_H
#define PROCESS_H

#include <stdbool.h>

struct process {
    int status; /* exit status; -1 if a signal ended it */
    char out[65536];
    char err[65536];
};

/*
 * Runs the program that the environment's CUPOLA_DEMO names in the current directory, without a
 * display. `command` holds its arguments with single blanks between them; `setting` is one more
 * "NAME=VALUE" for its environment, or NULL.
 */
void process_run(struct process *process, const char *command, const char *setting);

/*
 * The same, but once a file is there, and some milliseconds more have passed, the program gets a
 * signal, unless it has ended by then.
 */
void process_run_until(struct process *process, const char *command, const char *awaited,
                       int more_ms, int signal_number);

/* A new empty directory becomes the current one; it and all in it goes at the end. */
int process_enter_directory(void **state);
int process_leave_directory(void **state);

/* How many files the current directory holds. */
int process_count_files(void);

void process_write_file(const char *name, const char *text);
bool process_file_is(const char *name, const char *text);

#endif
