/* All views in one pass: what of cupola/one_pass.h is shared with the rest of the library. */
#ifndef ONE_PASS_PRIVATE_H
#define ONE_PASS_PRIVATE_H

#include "cupola/one_pass.h"

/* cupola_pass_way in a context that has been checked. */
int pass_way_find(struct cupola_error *error);

/* The buffer of the uniform block, for a gl that is made with one_pass. In creation the error is
 * never NULL. */
int one_pass_create(cupola_gl *gl, struct cupola_error *error);
void one_pass_destroy(cupola_gl *gl);

#endif
