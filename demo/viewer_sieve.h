/*
 * A sieve in the kernel for the socket of viewer_osc.h: while it is in, packets that begin neither
 * as a report nor as a bundle never reach the queue, so that a flood of them leaves it room.
 */
#ifndef VIEWER_SIEVE_H
#define VIEWER_SIEVE_H

#include <stdbool.h>

/* Whether it is in now; never, on a kernel that has none. */
bool viewer_sieve_put(int udp_socket);

void viewer_sieve_remove(int udp_socket);

#endif
