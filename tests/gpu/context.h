/* The GL context that a test program runs in. */
#ifndef CONTEXT_H
#define CONTEXT_H

/*
 * Makes a context without a display current and prints its renderer. Ends the program with 77,
 * which Meson counts as skipped, where no context at all can be had, and with 1 where there is one
 * that is too old. With CUPOLA_GPU_REQUIRED=1 in the environment it is 1 in either case.
 */
void context_open(void);
void context_close(void);

#endif
