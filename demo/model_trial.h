/*
 * A trial of a model in a process of its own. assimp ends the process on some broken files and
 * never returns on others; here that becomes an ordinary error.
 */
#ifndef MODEL_TRIAL_H
#define MODEL_TRIAL_H

#include <stdbool.h>
#include <stddef.h>

/*
 * False with one line in `message` where reading the model would not come to an end. True says no
 * more than that model_load will return, be it with an error. To be called before there is a GL
 * context, because it forks.
 */
bool model_trial(const char *path, bool want_normals, char *message, size_t message_size);

#endif
