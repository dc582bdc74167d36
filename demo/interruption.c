/* An interruption that waits until what is under way is done. */
#include "interruption.h"

#include <signal.h>
#include <stddef.h>

static volatile sig_atomic_t asked;

/* For both of them, so that it does not matter which one comes next. */
static void handle(void (*handler)(int))
{
    struct sigaction action = {.sa_handler = handler, .sa_flags = SA_RESTART};

    sigemptyset(&action.sa_mask);
    sigaddset(&action.sa_mask, SIGINT);
    sigaddset(&action.sa_mask, SIGTERM);
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
}

static void ask(int number)
{
    (void)number;
    asked = 1;
    handle(SIG_DFL);
}

void interruption_expect(void)
{
    handle(ask);
}

bool interruption_asked(void)
{
    return asked != 0;
}
