/* A host that has all there is drawn for it in bad states: for frames that leave the state. */
#ifndef LEFT_HOUSE_H
#define LEFT_HOUSE_H

#include "check.h"
#include "guest_fixture.h"
#include "host_objects.h"

static struct guest_house house;

static int open_house(void **state)
{
    (void)state;
    context_open();
    state_reset();
    objects_create();
    state_reset();
    guest_house_build(&house);
    state_reset();
    return 0;
}

static int close_house(void **state)
{
    (void)state;
    guest_house_release(&house);
    objects_release();
    context_close();
    return 0;
}

static bool hostility_may_be(const struct hostility *hostility)
{
    return context_has(hostility->gl, hostility->gl_extension, hostility->es,
                       hostility->es_extension) &&
           hostility->set != set_feedback; /* which frames that do not ask cannot pause */
}

/* All of them at once; a clean state for -1. */
static void be_hostile(int which)
{
    for (int i = 0; i < HOSTILITIES; i++)
        if (which >= 0 && (which == i || which == HOSTILITIES) && hostility_may_be(&hostilities[i]))
            hostilities[i].set();
    while (glGetError() != GL_NO_ERROR) /* not all of them go together */
        ;
}

static void check_ok(int status, const char *call, const struct cupola_error *error)
{
    GLenum pending = glGetError();
    if (status < 0 || pending != GL_NO_ERROR)
        fail_msg("%s: status %d, %s, GL error 0x%x", call, status, error->message, pending);
}

#endif
