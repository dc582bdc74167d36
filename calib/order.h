/* Numbers in order. */
#ifndef ORDER_H
#define ORDER_H

/* Sorts them into rising order. */
void order_sort(double *numbers, int count);
void order_sort_floats(float *numbers, int count);

/* Sorts them, and returns the rank-th smallest of them, 1 to count. */
double order_ranked(double *numbers, int count, int rank);

#endif
