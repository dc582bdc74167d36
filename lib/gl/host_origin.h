/* Where features of the GL come from: for those files that find out which there are. */
#ifndef HOST_ORIGIN_H
#define HOST_ORIGIN_H

#include "host_state.h"

enum { NEVER = 1000 }; /* not part of any version */

/* Where something is: versions that have it and extensions that bring it, of either API. */
struct origin {
    int gl;
    const char *gl_extension;
    int es;
    const char *es_extension;
};

#define EVERYWHERE                                                                                 \
    {                                                                                              \
        33, NULL, 30, NULL                                                                         \
    }
#define DESKTOP(es_extension)                                                                      \
    {                                                                                              \
        33, NULL, NEVER, es_extension                                                              \
    }

bool host_has(const struct host_features *features, struct origin origin);

/* Parts of host_features_find: capabilities; and what is about debugging and robustness. */
void host_capabilities_find(struct host_features *features);
void host_debug_find(struct host_features *features);

#endif
