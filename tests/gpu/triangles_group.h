/* The main function of a test program that draws triangles in all of its tests. */
#ifndef TRIANGLES_GROUP_H
#define TRIANGLES_GROUP_H

#include "group.h"
#include "triangles.h"

static struct triangles triangles;

static inline int triangles_open(void **state)
{
    (void)state;
    triangles = triangles_create();
    return 0;
}

static inline int triangles_close(void **state)
{
    (void)state;
    triangles_release(&triangles);
    return 0;
}

/* As run_gpu_group. */
#define run_triangles_group(name, tests)                                                           \
    (context_open(),                                                                               \
     group_close(cmocka_run_group_tests_name(name, tests, triangles_open, triangles_close)))

#endif
