/* Structured light: patterns that the projector shows, photographs of them, and marks from both. */
#ifndef CAPTURE_H
#define CAPTURE_H

/* The command: cupola-calib capture ... Returns its exit status. */
int capture_main(int argc, char **argv);

#endif
