/* A host with functions that are called as private ones of the library are. */
#include <cupola/cupola.h>
#include <stddef.h>

int error_set(void);
int program_create(void);
int texture_create(void);
int draw_fullscreen(void);

int error_set(void)
{
    return 1;
}

int program_create(void)
{
    return 2;
}

int texture_create(void)
{
    return 4;
}

int draw_fullscreen(void)
{
    return 8;
}

/* The library calls its own: a refusal has a message. */
int main(void)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    cupola_gl *gl = NULL;
    int status = cupola_gl_create(NULL, NULL, &gl, &error);
    int sum = error_set() + program_create() + texture_create() + draw_fullscreen();
    return status == CUPOLA_ERROR_ARGUMENT && error.message[0] && sum == 15 ? 0 : 1;
}
