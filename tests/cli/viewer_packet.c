/* Packets of a tracker, read from bytes of any kind. */
#include "viewer_packet.h"

#include <stdlib.h>

#include <lo/lo.h>

#include "check.h"
#include "osc_bytes.h"

/* What the packet holds; fails if it isn't read as it should be. */
static struct viewer_packet read_packet(bool is_osc)
{
    struct viewer_packet found;

    assert_int_equal(viewer_packet_read(packet.at, packet.size, &found), is_osc);
    if (!is_osc)
        assert_int_equal(found.reports + found.others, 0);
    return found;
}

static void check_position(const struct viewer_packet *found, double x, double y, double z)
{
    assert_int_equal(found->reports, 1);
    check_near(found->position_m[0], x, 1e-7);
    check_near(found->position_m[1], y, 1e-7);
    check_near(found->position_m[2], z, 1e-7);
}

static void numbers_of_every_type_are_positions(void **state)
{
    (void)state;
    struct viewer_packet found;
    lo_message message = lo_message_new();
    size_t size;

    begin();
    add_report(0.25f);
    found = read_packet(true);
    check_position(&found, 0.25, 2, 3);
    assert_int_equal(found.time_tag, 1);
    begin();
    add_text("/viewer");
    add_text(",dih");
    add_double(-0.1);
    add_number((uint32_t)-7, 4);
    add_number((uint64_t)-9, 8);
    found = read_packet(true);
    check_position(&found, -0.1, -7, -9);
    /* and as the library writes them, which others use to send */
    lo_message_add_float(message, 0.5f);
    lo_message_add_double(message, 1.5);
    lo_message_add_int32(message, -2);
    begin();
    lo_message_serialise(message, "/viewer", packet.at, &size);
    packet.size = size;
    lo_message_free(message);
    found = read_packet(true);
    check_position(&found, 0.5, 1.5, -2);
}

static void other_messages_are_counted_only(void **state)
{
    (void)state;
    static const char *const others[][2] = {
        {"/viewer", ",ff"},   {"/viewer", ",ffff"}, {"/viewer", ",fsf"}, {"/viewer", ","},
        {"/viewers", ",fff"}, {"/view", ",fff"},    {"/*", ",fff"},      {"/viewer", ",TFN"},
    };

    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        struct viewer_packet found;
        begin();
        add_text(others[i][0]);
        add_text(others[i][1]);
        for (const char *type = others[i][1]; *type; type++)
            if (*type == 'f' || *type == 's')
                add_number(0, 4);
        found = read_packet(true);
        assert_int_equal(found.reports, 0);
        assert_int_equal(found.others, 1);
    }
}

static void what_is_no_osc_is_refused_as_a_whole(void **state)
{
    (void)state;
    begin();
    read_packet(false); /* nothing at all */
    add_report(1);
    for (size_t size = packet.size - 1; size > 0; size--) {
        packet.size = size;
        read_packet(false);
    }
    begin();
    add("viewer\0\0,fff", 12);
    read_packet(false);
    begin();
    add("/viewer/without/an/end..", 24);
    read_packet(false);
    begin();
    add_text("/viewer");
    add("fff\0", 4); /* no comma */
    add_number(0, 8);
    add_number(0, 4);
    read_packet(false);
    begin_bundle(1); /* a good report, then one that is longer than the packet */
    add_number(REPORT_SIZE, 4);
    add_report(1);
    add_number(0xfffffffcu, 4);
    add_report(2);
    read_packet(false);
}

static void nested(int depth)
{
    begin_bundle(1);
    for (int i = depth - 1; i > 0; i--) {
        add_number((uint64_t)(20 * i + REPORT_SIZE), 4);
        add_text("#bundle");
        add_number(77, 8);
    }
    add_number(REPORT_SIZE, 4);
    add_report(4);
}

static void bundles_are_read_as_deep_and_as_long_as_is_sensible(void **state)
{
    (void)state;
    struct viewer_packet found;

    nested(VIEWER_PACKET_DEPTH);
    found = read_packet(true);
    check_position(&found, 4, 2, 3);
    assert_int_equal(found.time_tag, 77);
    nested(VIEWER_PACKET_DEPTH + 1);
    read_packet(false);
    nested(3000);
    read_packet(false);
    for (int extra = 0; extra < 2; extra++) {
        begin_bundle(5);
        for (int i = 0; i < VIEWER_PACKET_REPORTS + extra; i++) {
            add_number(REPORT_SIZE, 4);
            add_report((float)i);
        }
        found = read_packet(!extra);
        if (!extra)
            check_near(found.position_m[0], VIEWER_PACKET_REPORTS - 1, 0);
    }
    begin_bundle(5); /* as many messages as a packet can hold */
    while (packet.size < 65500) {
        add_number(4, 4);
        add_text("/a");
    }
    found = read_packet(true);
    check_at_least(found.others, 8000);
}

/* A wrong one is told by a sanitizer, or by a count that cannot be. */
static void any_bytes_are_read_without_harm(void **state)
{
    (void)state;
    uint64_t seed = 5;
    int good = 0;

    for (int run = 0; run < 60000; run++) {
        struct viewer_packet found;
        unsigned char *copy; /* of the very size, so that reading beyond is seen */
        if (run % 3 == 0) {
            begin();
            packet.size = (size_t)random_between(&seed, 0, 80);
            for (size_t i = 0; i < packet.size; i++)
                packet.at[i] = (unsigned char)random_between(&seed, 0, 256);
        } else {
            nested(1 + run % 4);
            for (int i = 0; i < 1 + run % 2; i++)
                packet.at[(size_t)random_between(&seed, 0, (double)packet.size)] =
                    (unsigned char)random_between(&seed, 0, run % 7 ? 4 : 256);
            packet.size -= run % 5 == 0 ? (size_t)random_between(&seed, 0, 8) : 0;
        }
        copy = malloc(packet.size + !packet.size);
        assert_non_null(copy);
        memcpy(copy, packet.at, packet.size);
        if (viewer_packet_read(copy, packet.size, &found))
            good++;
        else
            assert_int_equal(found.reports + found.others, 0);
        assert_true(found.reports >= 0 && found.reports <= VIEWER_PACKET_REPORTS);
        free(copy);
    }
    check_at_least(good, 1000);
    check_at_most(good, 50000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_of_every_type_are_positions),
        cmocka_unit_test(other_messages_are_counted_only),
        cmocka_unit_test(what_is_no_osc_is_refused_as_a_whole),
        cmocka_unit_test(bundles_are_read_as_deep_and_as_long_as_is_sensible),
        cmocka_unit_test(any_bytes_are_read_without_harm),
    };
    return cmocka_run_group_tests_name("viewer_packet", tests, NULL, NULL);
}
