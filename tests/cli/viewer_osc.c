/* The socket by which a tracker's reports come. */
#define _GNU_SOURCE /* usleep */

#include "viewer_osc.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <unistd.h>

#include "check.h"
#include "osc_bytes.h"
#include "viewer_feed.h"
#include "viewer_sieve.h"

struct line {
    struct viewer_osc *osc;
    struct cupola_viewer viewer;
    int sender;
};

static struct line opened(void)
{
    struct line line;
    char message[MESSAGE_SIZE];
    struct sockaddr_in to = {.sin_family = AF_INET, .sin_addr.s_addr = htonl(INADDR_LOOPBACK)};
    struct cupola_viewer_params params = {.radius_m = 1};

    line.osc = viewer_osc_create("0", message);
    if (!line.osc)
        fail_msg("%s", message);
    assert_int_equal(strncmp(viewer_osc_address(line.osc), "127.0.0.1:", 10), 0);
    to.sin_port = htons((uint16_t)atoi(viewer_osc_address(line.osc) + 10));
    line.sender = socket(AF_INET, SOCK_DGRAM, 0);
    assert_int_equal(connect(line.sender, (struct sockaddr *)&to, sizeof to), 0);
    assert_int_equal(cupola_viewer_start(&line.viewer, &params, NULL), CUPOLA_OK);
    return line;
}

static void closed(struct line *line)
{
    close(line->sender);
    viewer_osc_destroy(line->osc);
}

static void send_packet(const struct line *line)
{
    assert_int_equal(send(line->sender, packet.at, packet.size, 0), packet.size);
}

static void send_report(const struct line *line, float x)
{
    begin();
    add_report(x);
    send_packet(line);
}

static void check_counts(const struct line *line, const struct viewer_osc_counts *expected)
{
    const struct viewer_osc_counts *counts = viewer_osc_counts(line->osc);

    assert_int_equal(counts->packets, expected->packets);
    assert_int_equal(counts->taken, expected->taken);
    assert_int_equal(counts->refused, expected->refused);
    assert_int_equal(counts->late, expected->late);
    assert_int_equal(counts->malformed, expected->malformed);
    assert_int_equal(counts->others, expected->others);
}

/*
 * By the kernel, and not 50 ms later by the poll. The kernel begins to keep time for sockets a
 * little after it was told to: the first reports may be as young as the poll.
 */
static void what_comes_is_dated_by_its_arrival(void **state)
{
    (void)state;
    struct line line = opened();
    bool was_dated = false;

    viewer_osc_poll(line.osc, &line.viewer); /* nothing there: nothing waits */
    check_counts(&line, &(struct viewer_osc_counts){0});
    for (int i = 1; i <= 50 && !was_dated; i++) {
        double before_s = viewer_osc_now_s();
        send_report(&line, 0.5f);
        double after_s = viewer_osc_now_s();
        usleep(50000);
        viewer_osc_poll(line.osc, &line.viewer);
        check_counts(&line, &(struct viewer_osc_counts){.packets = i, .taken = i});
        check_near(line.viewer.position_m[0], 0.5, 0);
        check_at_least(line.viewer.time_s, before_s - 1e-3);
        was_dated = line.viewer.time_s <= after_s + 0.03;
    }
    assert_true(was_dated);
    closed(&line);
}

static void send_dated(const struct line *line, uint64_t tag, float x)
{
    begin_bundle(tag);
    add_number(REPORT_SIZE, 4);
    add_report(x);
    send_packet(line);
}

static void late_bundles_are_dropped_and_future_ones_count_at_once(void **state)
{
    (void)state;
    const uint64_t second = (uint64_t)1 << 32, now = 4000000000u * second;
    struct line line = opened();

    send_dated(&line, now, 0.1f);
    send_dated(&line, now - second / 100, 0.2f); /* overtaken */
    send_dated(&line, now, 0.1f);
    send_dated(&line, now + 3600 * second, 0.3f); /* an hour ahead */
    send_dated(&line, now, 0.4f);                 /* the clock was set anew */
    send_dated(&line, 1, 0.5f);                   /* "immediately" */
    viewer_osc_poll(line.osc, &line.viewer);
    check_counts(&line, &(struct viewer_osc_counts){.packets = 6, .taken = 5, .late = 1});
    closed(&line);
}

static void what_makes_no_sense_is_counted_by_its_kind(void **state)
{
    (void)state;
    struct line line = opened();

    for (int i = 0; i < 10; i++)
        send_report(&line, 0.1f);
    send_report(&line, (float)NAN);
    send_report(&line, 1e30f);
    begin();
    send_packet(&line); /* empty */
    add("nonsense", 8);
    send_packet(&line);
    begin();
    add_text("/other");
    add_text(",");
    send_packet(&line);
    viewer_osc_poll(line.osc, &line.viewer);
    check_counts(&line, &(struct viewer_osc_counts){
                            .packets = 15, .taken = 10, .refused = 2, .malformed = 2, .others = 1});
    check_near(line.viewer.position_m[0], 0.1, 1e-6);
    closed(&line);
}

/* Of a flood the kernel keeps some, one poll ends, and the next reports count. */
static void a_flood_is_bounded(void **state)
{
    (void)state;
    struct line line = opened();

    for (int i = 0; i < 20000; i++)
        send_report(&line, 0.1f);
    viewer_osc_poll(line.osc, &line.viewer);
    check_at_least(viewer_osc_counts(line.osc)->packets, 20);
    check_at_most(viewer_osc_counts(line.osc)->packets, 1024);
    usleep(1000);
    send_report(&line, 0.9f);
    viewer_osc_poll(line.osc, &line.viewer);
    check_at_least(line.viewer.position_m[0], 0.1);
    assert_int_equal(viewer_osc_counts(line.osc)->malformed, 0);
    closed(&line);
}

static void send_nonsense(const struct line *line, int count)
{
    begin();
    add("nobody asked for this...", 24);
    for (int i = 0; i < count; i++)
        send_packet(line);
}

/* The first of it shows itself, and then the queue has room for reports. */
static void a_flood_of_nonsense_is_kept_out(void **state)
{
    (void)state;
    struct line line = opened();

    if (!viewer_sieve_put(line.sender)) {
        closed(&line);
        skip(); /* this kernel has no sieve */
    }
    viewer_sieve_remove(line.sender);
    for (int i = 0; i < 2; i++) { /* the control is the first of the two, when nobody knows yet */
        send_nonsense(&line, 20000);
        send_report(&line, 0.25f);
        viewer_osc_poll(line.osc, &line.viewer);
        assert_int_equal(viewer_osc_counts(line.osc)->taken, i);
    }
    check_at_most(viewer_osc_counts(line.osc)->malformed, 5000);
    check_at_least(viewer_osc_counts(line.osc)->lost, 35000);
    begin_bundle(1); /* bundles are let in, for they may hold reports */
    add_number(REPORT_SIZE, 4);
    add_report(0.26f);
    send_packet(&line);
    viewer_osc_poll(line.osc, &line.viewer);
    assert_int_equal(viewer_osc_counts(line.osc)->taken, 2);
    usleep(1100000);
    viewer_osc_poll(line.osc, &line.viewer); /* which takes the sieve out again */
    send_nonsense(&line, 1);
    int malformed = (int)viewer_osc_counts(line.osc)->malformed;
    viewer_osc_poll(line.osc, &line.viewer);
    assert_int_equal(viewer_osc_counts(line.osc)->malformed, malformed + 1);
    closed(&line);
}

/* What the kernel says of sockets that are bound to a port: the local addresses, in hexadecimal. */
static int bound_addresses(int port, bool *loopback_only)
{
    FILE *file = fopen("/proc/net/udp", "r");
    char line[300];
    int count = 0;

    *loopback_only = true;
    while (file && fgets(line, sizeof line, file)) {
        unsigned int address, its_port;
        if (sscanf(line, " %*d: %8X:%4X", &address, &its_port) != 2 || (int)its_port != port)
            continue;
        count++;
        *loopback_only &= address == htonl(INADDR_LOOPBACK);
    }
    if (file)
        fclose(file);
    return count;
}

static void only_loopback_is_bound_unless_asked_otherwise(void **state)
{
    (void)state;
    char message[MESSAGE_SIZE];
    struct line line = opened();
    struct viewer_osc *wide;
    bool loopback_only;

    if (bound_addresses(atoi(viewer_osc_address(line.osc) + 10), &loopback_only) > 0)
        assert_true(loopback_only);
    closed(&line);
    wide = viewer_osc_create("0.0.0.0:0", message);
    assert_non_null(wide);
    assert_int_equal(strncmp(viewer_osc_address(wide), "0.0.0.0:", 8), 0);
    if (bound_addresses(atoi(viewer_osc_address(wide) + 8), &loopback_only) > 0)
        assert_false(loopback_only); /* so the test would tell */
    viewer_osc_destroy(wide);
}

static void what_cannot_be_listened_on_is_said(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        {"", "is not allowed"},
        {"65536", "is not allowed"},
        {"-1", "is not allowed"},
        {"9000x", "is not allowed"},
        {":9000", "is not allowed"},
        {"host:", "is not allowed"},
        {"::1:9000", "is not allowed"},
        {"[]:9000", "is not allowed"},
        {"no.such.host.invalid:9000", "is not known"},
        {"192.0.2.1:9000", "cannot be listened on"}, /* an address for documents, nobody's own */
    };
    struct line line = opened();
    char message[MESSAGE_SIZE];

    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        message[0] = 0;
        assert_null(viewer_osc_create(wrong[i][0], message));
        if (strncmp(message, "--osc: ", 7) != 0 || !strstr(message, wrong[i][1]))
            fail_msg("'%s': '%s' does not say '%s'", wrong[i][0], message, wrong[i][1]);
    }
    assert_null(viewer_osc_create(viewer_osc_address(line.osc) + 10, message));
    assert_non_null(strstr(message, "in use"));
    closed(&line);
}

static void a_feed_has_an_eye_once_something_came(void **state)
{
    (void)state;
    struct viewer_feed_wishes wishes = {
        .address = "127.0.0.1:0", .ahead_s = 0.02, .center_m = {1, 0, 0}, .radius_m = 0.1};
    char message[MESSAGE_SIZE];
    struct viewer_feed *feed = viewer_feed_create(&wishes, message);
    struct sockaddr_in to = {.sin_family = AF_INET, .sin_addr.s_addr = htonl(INADDR_LOOPBACK)};
    int sender = socket(AF_INET, SOCK_DGRAM, 0);
    double eye_m[3] = {9, 9, 9};

    assert_non_null(feed);
    assert_false(viewer_feed_eye(feed, eye_m));
    check_near(eye_m[0], 9, 0);
    to.sin_port = htons((uint16_t)atoi(viewer_feed_address(feed) + 10));
    begin();
    add_report(1.05f);
    memset(packet.at + packet.size - 8, 0, 8);
    sendto(sender, packet.at, packet.size, 0, (struct sockaddr *)&to, sizeof to);
    assert_true(viewer_feed_eye(feed, eye_m));
    check_near(eye_m[0], 1.05, 1e-6);
    assert_int_equal(viewer_feed_counts(feed)->taken, 1);
    /* What was reported counts on in another sphere; none that is impossible is taken. */
    viewer_feed_set_radius(feed, 0.02);
    assert_true(viewer_feed_eye(feed, eye_m));
    check_near(eye_m[0], 1.02, 1e-4);
    viewer_feed_set_radius(feed, -1);
    viewer_feed_set_radius(feed, 5);
    assert_true(viewer_feed_eye(feed, eye_m));
    check_near(eye_m[0], 1.05, 1e-6);
    close(sender);
    viewer_feed_destroy(feed);
    viewer_feed_destroy(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_comes_is_dated_by_its_arrival),
        cmocka_unit_test(late_bundles_are_dropped_and_future_ones_count_at_once),
        cmocka_unit_test(what_makes_no_sense_is_counted_by_its_kind),
        cmocka_unit_test(a_flood_is_bounded),
        cmocka_unit_test(a_flood_of_nonsense_is_kept_out),
        cmocka_unit_test(only_loopback_is_bound_unless_asked_otherwise),
        cmocka_unit_test(what_cannot_be_listened_on_is_said),
        cmocka_unit_test(a_feed_has_an_eye_once_something_came),
    };
    return cmocka_run_group_tests_name("viewer_osc", tests, NULL, NULL);
}
