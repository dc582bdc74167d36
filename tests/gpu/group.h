/* The main function of a test program in this folder. */
#ifndef GROUP_H
#define GROUP_H

#include "check.h"
#include "context.h"
#include "fixture.h"

/* Runs cmocka tests where a context is current. */
#define run_gpu_group(name, tests)                                                                 \
    (context_open(), group_close(cmocka_run_group_tests_name(name, tests, NULL, NULL)))

static inline int group_close(int failures)
{
    fixture_forget_programs();
    context_close();
    return failures;
}

#endif
