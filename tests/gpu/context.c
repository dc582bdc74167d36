/* A surfaceless GL context, the way cupola-demo makes its own. */
#include "context.h"

#include <epoxy/gl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "headless.h"

enum { EXIT_SKIPPED = 77 };

static struct headless *headless;

void context_open(void)
{
    /* A version in the message means that there was a context. */
    static const char too_old[] = "the OpenGL found is";
    char message[256];
    headless = headless_create(message, sizeof message);
    if (!headless) {
        const char *required = getenv("CUPOLA_GPU_REQUIRED");
        int skipped = strncmp(message, too_old, sizeof too_old - 1) != 0 &&
                      !(required && strcmp(required, "1") == 0);
        fprintf(stderr, "%s: %s\n", skipped ? "skipped" : "failed", message);
        exit(skipped ? EXIT_SKIPPED : EXIT_FAILURE);
    }
    printf("renderer: %s, OpenGL %s\n", (const char *)glGetString(GL_RENDERER),
           (const char *)glGetString(GL_VERSION));
    fflush(stdout);
}

void context_close(void)
{
    headless_destroy(headless);
    headless = NULL;
}
