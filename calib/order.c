/* Numbers in order. */
#include "order.h"

#include <stdlib.h>

static int compare_doubles(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

static int compare_floats(const void *a, const void *b)
{
    float x = *(const float *)a, y = *(const float *)b;

    return (x > y) - (x < y);
}

void order_sort(double *numbers, int count)
{
    qsort(numbers, (size_t)count, sizeof *numbers, compare_doubles);
}

void order_sort_floats(float *numbers, int count)
{
    qsort(numbers, (size_t)count, sizeof *numbers, compare_floats);
}

double order_ranked(double *numbers, int count, int rank)
{
    order_sort(numbers, count);
    return numbers[rank - 1];
}
