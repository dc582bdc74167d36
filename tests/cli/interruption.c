/* The first signal asks for the end, the next one ends at once, whichever of the two each is. */
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "check.h"
#include "interruption.h"

enum { UNASKED = 3, UNMOVED = 4 };

/* What becomes of a process that gets one signal and then another. */
static int status_after(int first, int second)
{
    int status = 0;
    pid_t child = fork();

    assert_true(child >= 0);
    if (child == 0) {
        interruption_expect();
        if (interruption_asked())
            _exit(UNMOVED);
        raise(first);
        if (!interruption_asked())
            _exit(UNASKED);
        raise(second);
        _exit(UNMOVED);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    return status;
}

static void the_second_signal_ends_at_once(void **state)
{
    static const int signals[] = {SIGINT, SIGTERM};

    (void)state;
    for (int i = 0; i < 4; i++) {
        int second = signals[i % 2], status = status_after(signals[i / 2], second);
        assert_true(WIFSIGNALED(status));
        assert_int_equal(WTERMSIG(status), second);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_second_signal_ends_at_once),
    };
    return cmocka_run_group_tests_name("interruption", tests, NULL, NULL);
}
