/* An interruption that waits until what is under way is done. */
#include "interruption.h"

#include <signal.h>
#include <stddef.h>

static volatile sig_atomic_t asked;

static void ask(int number)
{
    (void)number;
    asked = 1;
}

void interruption_expect(void)
{
    struct sigaction action = {.sa_handler = ask, .sa_flags = SA_RESTART | SA_RESETHAND};

    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
}

bool interruption_asked(void)
{
    return asked != 0;
}
