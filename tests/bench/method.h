/* Ways of antialiasing by name. */
#ifndef METHOD_H
#define METHOD_H

#include <stdbool.h>

#include <cupola/antialiasing.h>

enum { METHODS_MAX = 24, METHOD_NAME = 64 };

struct method {
    char name[METHOD_NAME];
    struct cupola_filter filter;
};

/*
 * METHOD[:SAMPLES[:PATTERN[:turned]]] by the library's names: "cone:8:blue-noise:turned". False
 * where it is none.
 */
bool method_find(const char *text, struct method *method);

#endif
