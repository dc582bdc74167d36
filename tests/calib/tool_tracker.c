/* What the legend tells of a tracker: reports, and what came and was none. */
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include "tool/panel.h"
#include "tool/tracker.h"
#include "tool_fixture.h"

static const char report[] = "/viewer\0,fff\0\0\0\0\0\0\0\0\0\0\0\0\x3e\x80\0"; /* 0, 0, 0.25 */
static const char elsewhere[] = "/head\0\0\0,fff\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0";
static const char refused[] = "/viewer\0,fff\0\0\0\0\x7f\x80\0\0\0\0\0\0\0\0\0"; /* infinity */
/* 0, 0, 20: beyond every screen of these tests, and no report that is refused. */
static const char far_away[] = "/viewer\0,fff\0\0\0\0\0\0\0\0\0\0\0\0\x41\xa0\0";
enum { BYTES = 28 };

struct line {
    struct tool tool;
    struct tracker *tracker;
    int sender;
};

static void open_line(struct line *line)
{
    uint64_t seed = 3;
    char message[MESSAGE_SIZE] = "";
    struct sockaddr_in to = {.sin_family = AF_INET, .sin_addr.s_addr = htonl(INADDR_LOOPBACK)};

    open_by_chance(&line->tool, &seed, "rig.cfg");
    line->tracker = tracker_open(&line->tool, "127.0.0.1:0", 20, message);
    if (!line->tracker)
        fail_msg("%s", message);
    to.sin_port = htons((uint16_t)atoi(strchr(line->tool.tracker.address, ':') + 1));
    line->sender = socket(AF_INET, SOCK_DGRAM, 0);
    assert_int_equal(connect(line->sender, (struct sockaddr *)&to, sizeof to), 0);
}

static void close_line(struct line *line)
{
    close(line->sender);
    tracker_close(line->tracker);
    tool_close(&line->tool);
}

static void post(const struct line *line, const char *bytes, size_t size, int times)
{
    for (int i = 0; i < times; i++)
        assert_int_equal(send(line->sender, bytes, size, 0), size);
}

/* Whether the legend tells of the tracker, with this in one of its columns. */
static bool tells(const struct tool *tool, const char *words)
{
    struct panel panel;
    bool found = false;

    panel_write(tool, PANEL_LEGEND, 80, &panel);
    for (int i = 0; i < panel.columns; i++) {
        char lines[PANEL_TEXT + 2];
        snprintf(lines, sizeof lines, "%s\n", panel.text[i]); /* the last one has no end */
        found |= strstr(lines, words) != NULL;
    }
    return found && strstr(panel.text[0], "tracker\n");
}

static void every_kind_is_told(void **state)
{
    struct line line;

    (void)state;
    open_line(&line);
    tracker_hear(&line.tool, line.tracker);
    assert_true(tells(&line.tool, line.tool.tracker.address));
    assert_true(tells(&line.tool, ": 0 reports\n"));
    assert_false(tells(&line.tool, "not /viewer"));
    assert_false(line.tool.viewer_lives);

    post(&line, elsewhere, BYTES, 12);
    post(&line, "what", 4, 2);
    post(&line, refused, BYTES, 3);
    line.tool.time_s += 1;
    tracker_hear(&line.tool, line.tracker);
    assert_true(tells(&line.tool, ": 0 reports\n"));
    assert_true(tells(&line.tool, "\n12 not /viewer x y z, 2 no OSC, 3 refused\n"));
    assert_false(tells(&line.tool, "late"));
    assert_false(line.tool.viewer_lives);

    post(&line, report, BYTES, 1);
    line.tool.time_s += 1;
    tracker_hear(&line.tool, line.tracker);
    assert_true(tells(&line.tool, ": 1 report\n"));
    assert_true(line.tool.viewer_lives);
    check_near(line.tool.live_eye_m[2], 0.25, 1e-9);
    close_line(&line);
}

static double eye_distance_m(const struct tool *tool)
{
    struct cupola_rig rig;

    tool_shown_rig(tool, &rig);
    return sqrt(rig.eye_m[0] * rig.eye_m[0] + rig.eye_m[1] * rig.eye_m[1] +
                rig.eye_m[2] * rig.eye_m[2]);
}

/* Whatever has changed the screen since the tracker was opened. */
static void the_eye_may_go_as_far_as_the_screen_of_now_allows(void **state)
{
    struct line line;
    double before_m;

    (void)state;
    open_line(&line);
    before_m = line.tool.rig.screen.radius_m;
    post(&line, far_away, BYTES, 1);
    tracker_hear(&line.tool, line.tracker);
    check_near(eye_distance_m(&line.tool), 0.9 * before_m, 0.001 * before_m);
    assert_true(tool_set(&line.tool, PARAMETER_SCREEN_RADIUS, 2 * before_m));
    tracker_hear(&line.tool, line.tracker);
    check_near(eye_distance_m(&line.tool), 1.8 * before_m, 0.002 * before_m);
    line.tool.shows_before = true;
    check_near(eye_distance_m(&line.tool), 0.9 * before_m, 0.001 * before_m);
    tool_undo(&line.tool);
    check_near(eye_distance_m(&line.tool), 0.9 * before_m, 0.001 * before_m);
    tool_redo(&line.tool);
    tracker_hear(&line.tool, line.tracker);
    check_near(eye_distance_m(&line.tool), 1.8 * before_m, 0.002 * before_m);
    close_line(&line);
}

/* Else what nobody asked for would draw frames. */
static void it_is_told_a_few_times_a_second(void **state)
{
    struct line line;
    int told = 0;

    (void)state;
    open_line(&line);
    tracker_hear(&line.tool, line.tracker);
    for (int i = 0; i < 100; i++) {
        struct viewer_osc_counts before = line.tool.tracker.counts;
        post(&line, elsewhere, BYTES, 1);
        line.tool.time_s += 0.01;
        tracker_hear(&line.tool, line.tracker);
        told += memcmp(&before, &line.tool.tracker.counts, sizeof before) != 0;
    }
    check_near(told, 4, 1);
    line.tool.time_s += 1;
    tracker_hear(&line.tool, line.tracker);
    assert_int_equal(line.tool.tracker.counts.others, 100);
    close_line(&line);
}

static void without_a_tracker_there_is_no_line(void **state)
{
    uint64_t seed = 3;
    struct tool tool;
    char message[MESSAGE_SIZE];

    (void)state;
    open_by_chance(&tool, &seed, "rig.cfg");
    assert_false(tells(&tool, ""));
    assert_null(tracker_open(&tool, "192.0.2.1:9000", 20, message));
    assert_non_null(strstr(message, "192.0.2.1"));
    assert_false(tells(&tool, ""));
    tracker_close(NULL);
    tool_close(&tool);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_kind_is_told),
        cmocka_unit_test(the_eye_may_go_as_far_as_the_screen_of_now_allows),
        cmocka_unit_test(it_is_told_a_few_times_a_second),
        cmocka_unit_test(without_a_tracker_there_is_no_line),
    };

    return cmocka_run_group_tests_name("calib-tool_tracker", tests, enter_folder, NULL);
}
