/* The tool's command line. */
#ifndef TOOL_OPTIONS_H
#define TOOL_OPTIONS_H

#include <stdbool.h>

struct tool_options {
    const char *rig, *preset; /* NULL: not given */
    int projector;
    const char *output;
    const char *marks, *marks_output;
    const char *theatre;
    int monitor;
    bool windowed;
    int width, height; /* of the window or of pictures; 0: not given */
    int preview;       /* -1: not given */
    int pattern;       /* -1: not given */
    const char *script;
    bool headless;
    const char *picture;
    int frames; /* 0: no end */
    int swap_interval;
    const char *osc;
    double lookahead_ms; /* of osc */
    bool lookahead_given;
    bool fresh;
    bool journal; /* also for a script */
    bool help, version;
};

/* Returns an exit status, with one line in `message`, MESSAGE_SIZE bytes, unless STATUS_OK. */
int tool_options_parse(int argc, char **argv, struct tool_options *options, char *message);

/* --help, to stdout. */
void tool_options_help(void);

#endif
