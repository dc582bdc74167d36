/* What is told of a rig and its plan without drawing anything: --map and --report. Needs no GL. */
#ifndef SURVEY_H
#define SURVEY_H

#include "show.h"

/* Whether anything of it is asked for, and whether there is nothing else to be done. */
bool survey_is_wished(const struct options *options);
bool survey_is_all(const struct options *options);

/* Returns an exit status, with one line in `message` (MESSAGE_SIZE bytes) unless STATUS_OK. */
int survey_run(const struct options *options, const struct show_setup *setup, char *message);

#endif
