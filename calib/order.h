/* Numbers in order, for qsort. */
#ifndef ORDER_H
#define ORDER_H

int order_doubles(const void *a, const void *b);
int order_floats(const void *a, const void *b);

#endif
