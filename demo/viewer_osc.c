/* The socket for reports of a tracker. */
#define _GNU_SOURCE /* SO_TIMESTAMPNS */

#include "viewer_osc.h"

#include <errno.h>
#include <netdb.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include "viewer_packet.h"
#include "viewer_sieve.h"

enum {
    HOST_SIZE = 256,
    QUEUE_BYTES = 208 * 1024, /* that the kernel keeps, all that Linux grants without more ado: some
                               * 500 small packets */
    POLL_PACKETS = 1024,      /* at most, and so many bytes, in one poll */
    POLL_BYTES = 1024 * 1024,
    FLOOD_PACKETS = 100, /* of no use, in one poll: somebody floods the port */
};

struct viewer_osc {
    int socket;
    char address[HOST_SIZE + 16];
    struct viewer_osc_counts counts;
    uint64_t newest_tag; /* 0: none yet */
    int useless;         /* packets of the poll under way */
    bool has_sieve;
    double sieve_end_s;
    unsigned char packet[65536];
};

static double seconds(const struct timespec *time)
{
    return (double)time->tv_sec + 1e-9 * (double)time->tv_nsec;
}

static double now_s(clockid_t clock)
{
    struct timespec now;

    clock_gettime(clock, &now);
    return seconds(&now);
}

double viewer_osc_now_s(void)
{
    return now_s(CLOCK_MONOTONIC);
}

/* "[HOST:]PORT" or "[[HOST]:]PORT" in its parts. */
static bool split(const char *text, char host[HOST_SIZE], char port[6])
{
    const char *colon = strrchr(text, ':'), *digits = colon ? colon + 1 : text;
    size_t length = colon ? (size_t)(colon - text) : 0, count = strlen(digits);

    if (count < 1 || count > 5 || strspn(digits, "0123456789") != count || atoi(digits) > 65535)
        return false;
    memcpy(port, digits, count + 1);
    snprintf(host, HOST_SIZE, "127.0.0.1");
    if (!colon)
        return true;
    if (length >= 2 && text[0] == '[' && text[length - 1] == ']') {
        text++;
        length -= 2;
    } else if (memchr(text, ':', length)) {
        return false; /* IPv6 without brackets: whose is the last colon? */
    }
    if (length < 1 || length >= HOST_SIZE)
        return false;
    memcpy(host, text, length);
    host[length] = 0;
    return true;
}

bool viewer_osc_check(const struct value_context *context, const char *text)
{
    char host[HOST_SIZE], port[6];

    if (split(text, host, port))
        return true;
    snprintf(
        context->message, MESSAGE_SIZE,
        "%s: '%.200s' is not allowed; allowed: PORT or HOST:PORT, the port from 0 (any that is "
        "free) to 65535: 9000, 0.0.0.0:9000, [::1]:9000",
        context->option, text);
    return false;
}

static void name_address(struct viewer_osc *osc)
{
    struct sockaddr_storage own;
    socklen_t size = sizeof own;
    char host[HOST_SIZE] = "?", port[6] = "?";

    if (getsockname(osc->socket, (struct sockaddr *)&own, &size) == 0)
        getnameinfo((struct sockaddr *)&own, size, host, sizeof host, port, sizeof port,
                    NI_NUMERICHOST | NI_NUMERICSERV);
    snprintf(osc->address, sizeof osc->address, strchr(host, ':') ? "[%s]:%s" : "%s:%s", host,
             port);
}

/* A name that has addresses of both kinds is the older one's: it is what senders mean. */
static const struct addrinfo *choose(const struct addrinfo *found)
{
    for (const struct addrinfo *at = found; at; at = at->ai_next)
        if (at->ai_family == AF_INET)
            return at;
    return found;
}

static bool listen_on(struct viewer_osc *osc, const struct addrinfo *found)
{
    int queue = QUEUE_BYTES, yes = 1;

    osc->socket = socket(found->ai_family, found->ai_socktype | SOCK_CLOEXEC | SOCK_NONBLOCK,
                         found->ai_protocol);
    if (osc->socket < 0)
        return false;
    setsockopt(osc->socket, SOL_SOCKET, SO_RCVBUF, &queue, sizeof queue);
    setsockopt(osc->socket, SOL_SOCKET, SO_TIMESTAMPNS, &yes, sizeof yes);
    setsockopt(osc->socket, SOL_SOCKET, SO_RXQ_OVFL, &yes, sizeof yes);
    return bind(osc->socket, found->ai_addr, found->ai_addrlen) == 0;
}

struct viewer_osc *viewer_osc_create(const char *address, char *message)
{
    struct addrinfo wish = {.ai_family = AF_UNSPEC, .ai_socktype = SOCK_DGRAM}, *found = NULL;
    char host[HOST_SIZE], port[6];
    struct viewer_osc *osc;
    int status;

    if (!viewer_osc_check(&(struct value_context){"--osc", message}, address))
        return NULL;
    split(address, host, port);
    status = getaddrinfo(host, port, &wish, &found);
    if (status != 0) {
        snprintf(message, MESSAGE_SIZE,
                 "--osc: the host '%s' is not known: %s; allowed: a name or number of this machine",
                 host, gai_strerror(status));
        return NULL;
    }
    osc = calloc(1, sizeof *osc);
    if (!osc) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
    } else if (!listen_on(osc, choose(found))) {
        snprintf(message, MESSAGE_SIZE, "--osc: %s port %s cannot be listened on: %s", host, port,
                 strerror(errno));
        viewer_osc_destroy(osc);
        osc = NULL;
    } else {
        name_address(osc);
    }
    freeaddrinfo(found);
    return osc;
}

void viewer_osc_destroy(struct viewer_osc *osc)
{
    if (!osc)
        return;
    if (osc->socket >= 0)
        close(osc->socket);
    free(osc);
}

const char *viewer_osc_address(const struct viewer_osc *osc)
{
    return osc->address;
}

const struct viewer_osc_counts *viewer_osc_counts(const struct viewer_osc *osc)
{
    return &osc->counts;
}

/* Whether a newer packet of the same sender came before this one. */
static bool is_late(struct viewer_osc *osc, uint64_t tag)
{
    const uint64_t second = (uint64_t)1 << 32;
    bool late;

    if (tag <= 1) /* "immediately", by the specification */
        return false;
    late = tag < osc->newest_tag && osc->newest_tag - tag <= second;
    if (!late)
        osc->newest_tag = tag;
    return late;
}

static void take_packet(struct viewer_osc *osc, size_t size, double time_s,
                        struct cupola_viewer *viewer)
{
    struct viewer_packet packet;

    osc->counts.packets++;
    if (!viewer_packet_read(osc->packet, size, &packet)) {
        osc->counts.malformed++;
        osc->useless++;
        return;
    }
    osc->counts.others += packet.others;
    if (packet.reports == 0) {
        osc->useless++;
        return;
    }
    if (is_late(osc, packet.time_tag))
        osc->counts.late++;
    else if (cupola_viewer_report(viewer, time_s, packet.position_m) == 1)
        osc->counts.taken++;
    else
        osc->counts.refused++;
}

/* When the kernel got it, by our clock; `offset_s` is that clock less the kernel's. */
static double read_control(struct viewer_osc *osc, struct msghdr *header, double offset_s)
{
    double time_s = viewer_osc_now_s(); /* the future, where the kernel's clock was set, is now */

    for (struct cmsghdr *part = CMSG_FIRSTHDR(header); part; part = CMSG_NXTHDR(header, part)) {
        struct timespec stamp;
        uint32_t lost;
        if (part->cmsg_level != SOL_SOCKET)
            continue;
        if (part->cmsg_type == SCM_TIMESTAMPNS) {
            memcpy(&stamp, CMSG_DATA(part), sizeof stamp);
            if (seconds(&stamp) + offset_s < time_s)
                time_s = seconds(&stamp) + offset_s;
        } else if (part->cmsg_type == SO_RXQ_OVFL) {
            memcpy(&lost, CMSG_DATA(part), sizeof lost);
            osc->counts.lost = (long)lost;
        }
    }
    return time_s;
}

/* False where nothing is left, or a signal came: the next frame goes on. */
static bool receive(struct viewer_osc *osc, double offset_s, size_t *size, double *time_s)
{
    _Alignas(struct cmsghdr) char
        control[CMSG_SPACE(sizeof(struct timespec)) + CMSG_SPACE(sizeof(uint32_t))];
    struct iovec room = {osc->packet, sizeof osc->packet};
    struct msghdr header = {.msg_iov = &room,
                            .msg_iovlen = 1,
                            .msg_control = control,
                            .msg_controllen = sizeof control};
    ssize_t got = recvmsg(osc->socket, &header, MSG_DONTWAIT);

    if (got < 0)
        return false;
    *size = (size_t)got;
    *time_s = read_control(osc, &header, offset_s);
    return true;
}

/* After a second without it a flood shows itself again, or is over. */
static void set_sieve(struct viewer_osc *osc, double now_s)
{
    if (osc->useless > FLOOD_PACKETS) {
        osc->has_sieve = osc->has_sieve || viewer_sieve_put(osc->socket);
        osc->sieve_end_s = now_s + 1;
    } else if (osc->has_sieve && now_s > osc->sieve_end_s) {
        viewer_sieve_remove(osc->socket);
        osc->has_sieve = false;
    }
}

void viewer_osc_poll(struct viewer_osc *osc, struct cupola_viewer *viewer)
{
    double mine_s = viewer_osc_now_s(), offset_s = mine_s - now_s(CLOCK_REALTIME), time_s;
    size_t bytes = 0, size;

    osc->useless = 0;
    for (int i = 0; i < POLL_PACKETS && bytes < POLL_BYTES; i++) {
        if (!receive(osc, offset_s, &size, &time_s))
            break;
        bytes += size;
        take_packet(osc, size, time_s, viewer);
    }
    set_sieve(osc, mine_s);
}
