/* The command line of cupola-calib solve. */
#ifndef SOLVE_OPTIONS_H
#define SOLVE_OPTIONS_H

#include <stdbool.h>

struct solve_options {
    const char *marks;
    const char *rig, *preset; /* one of them */
    const char *output;       /* these three: NULL, not written */
    const char *json;
    const char *plot;
    int free; /* of enum solve_free */
    int projector;
    bool flips, verbose, help;
};

/* Returns an exit status; one line in `message` unless it is STATUS_OK. */
int solve_options_parse(int argc, char **argv, struct solve_options *options, char *message);

void solve_options_print_help(void);

#endif
