/* Exit statuses of cupola-calib and its one way of saying what failed. */
#ifndef STATUS_H
#define STATUS_H

enum {
    STATUS_OK = 0,
    STATUS_FAILED = 1, /* files, devices, marks that determine nothing, expectations not met */
    STATUS_USAGE = 2,  /* the command line */
};

/* Prints "cupola-calib COMMAND: message" as one line on stderr and returns the status. */
int complain(const char *command, int status, const char *message);

#endif
