/* Classic BPF (bpf(4) of the BSDs, as Linux has it for sockets) over the first 8 bytes of OSC. */
#define _GNU_SOURCE /* SO_ATTACH_FILTER */

#include "viewer_sieve.h"

#include <linux/filter.h>
#include <sys/socket.h>

enum { UDP_HEAD = 8, KEEP = 65535 };

#define FOUR(a, b, c, d)                                                                           \
    ((unsigned int)(a) << 24 | (unsigned int)(b) << 16 | (unsigned int)(c) << 8 | (unsigned int)(d))

bool viewer_sieve_put(int udp_socket)
{
    /* A jump's numbers are how many lines to pass over, where it is equal and where not. A packet
     * that is too short to be looked at is dropped. */
    struct sock_filter lines[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, UDP_HEAD),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, FOUR('/', 'v', 'i', 'e'), 0, 2),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, UDP_HEAD + 4),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, FOUR('w', 'e', 'r', 0), 3, 4),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, FOUR('#', 'b', 'u', 'n'), 0, 3),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, UDP_HEAD + 4),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, FOUR('d', 'l', 'e', 0), 0, 1),
        BPF_STMT(BPF_RET | BPF_K, KEEP),
        BPF_STMT(BPF_RET | BPF_K, 0),
    };
    struct sock_fprog program = {sizeof lines / sizeof *lines, lines};

    return setsockopt(udp_socket, SOL_SOCKET, SO_ATTACH_FILTER, &program, sizeof program) == 0;
}

void viewer_sieve_remove(int udp_socket)
{
    int unused = 0;

    setsockopt(udp_socket, SOL_SOCKET, SO_DETACH_FILTER, &unused, sizeof unused);
}
