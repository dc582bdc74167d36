/* Scripts: every line does what a user would, and what fails is named with its place. */
#include "tool/script.h"

#include "status.h"
#include "tool_fixture.h"

/* Draws nothing and remembers what it was asked for. */
struct drawn {
    char text[1000];
};

static bool picture(void *user, struct tool *tool, bool dome, const char *path, char *message)
{
    struct drawn *drawn = user;
    size_t length = strlen(drawn->text);

    (void)tool;
    snprintf(drawn->text + length, sizeof drawn->text - length, "%s %s;", dome ? "dome" : "picture",
             path);
    if (strcmp(path, "bad.png") != 0)
        return true;
    snprintf(message, MESSAGE_SIZE, "the disk burns");
    return false;
}

static bool frames(void *user, struct tool *tool, int count, char *message)
{
    struct drawn *drawn = user;
    size_t length = strlen(drawn->text);

    (void)tool, (void)message;
    snprintf(drawn->text + length, sizeof drawn->text - length, "%d frames;", count);
    return true;
}

/* Plays a text with a VisionStation and three marks. */
static int play(const char *text, struct drawn *drawn, char *message)
{
    const struct script_stage stage = {drawn, picture, frames};
    uint64_t seed = 4;
    struct marks marks = random_marks(&seed, 3);
    struct cupola_rig rig;
    struct tool tool;
    FILE *stream = fmemopen((void *)(uintptr_t)text, strlen(text), "r");
    int status;

    assert_non_null(stream);
    for (int i = 0; i < 3; i++)
        marks.list[i].steered = false;
    *drawn = (struct drawn){""};
    message[0] = '\0';
    assert_int_equal(cupola_rig_preset("visionstation", &rig, NULL), CUPOLA_OK);
    assert_true(tool_open(&tool, &rig, 0, &marks, "rig.cfg", "m-steered.csv", message));
    status = script_play(&tool, stream, "a.script", &stage, message);
    fclose(stream);
    tool_close(&tool);
    return status;
}

static void check_plays(const char *text)
{
    struct drawn drawn;
    char message[MESSAGE_SIZE];

    if (play(text, &drawn, message) != STATUS_OK)
        fail_msg("%s", message);
}

static void check_fails(const char *text, const char *says)
{
    struct drawn drawn;
    char message[MESSAGE_SIZE];

    assert_int_equal(play(text, &drawn, message), STATUS_FAILED);
    if (!strstr(message, says))
        fail_msg("'%s' is not in '%s'", says, message);
    assert_null(strchr(message, '\n'));
}

static void lines_do_what_a_user_would(void **state)
{
    (void)state;
    check_plays("# a comment\n\n   \nkey A # aim\nkey Right 10\nexpect yaw_deg 1\n"
                "key shift+Right\nexpect yaw_deg 1.01\nkey ctrl+Up\nexpect pitch_deg 1\n"
                "expect undo 3\nkey ctrl+Z 3\nexpect unsaved no\nexpect redo 3\r\n"
                "key ctrl+shift+z 2\nexpect yaw_deg 1.01\nexpect group \"projector aim\"");
    check_plays("key 8\nexpect pattern dot\nkey U\nexpect about viewer\nkey P\nexpect preview eye\n"
                "key H\nexpect help yes\nkey I\nexpect legend no\nkey N\nexpect labels no\n"
                "key F12\nexpect wants_picture yes\nkey B\nexpect before yes\n"
                "expect warning none\nexpect notice containing before\n");
    check_plays("key M\nexpect mark 1\nkey Enter\nexpect marks_steered 1\nexpect mark 2\n"
                "expect marks 3\nset cross_x_px 100\nset cross_y_px 50.5\nkey Enter\n"
                "expect marks_steered 2\nkey PageDown\nexpect cross_x_px 100\nkey Backspace\n"
                "expect marks_steered 1\n");
    check_plays("key C\nmouse 10 10\npress\nmouse 20 15\nmouse 30 25\nrelease\nmouse 500 500\n"
                "expect circle_x_px 532\nexpect circle_y_px 399\nexpect undo 1\n");
    check_plays("set lens hemispheric\nexpect lens hemispheric\nrefuse fov_deg 181\n"
                "expect warning containing 180\nset fov_deg 120\nexpect warning none\n"
                "expect fov_deg 125 within 5\nset flip 3\nexpect flip 3\n");
    check_plays("set lens polynomial\nexpect k1 1\nexpect undo 1\nset k3 -0.01\nset lens angular\n"
                "refuse k1 2\nexpect warning containing \"the lens is angular\"\nexpect undo 3\n"
                "set lens polynomial\nexpect k3 -0.01\n");
    check_plays(
        "set flip xy\nexpect flip 3\nset flip x\nexpect flip x\nset flip 0\nexpect flip none\n"
        "key Y\nexpect flip y\nkey A\nexpect group aim\nexpect group \"projector aim\"\n"
        "key C\nexpect group circle\nkey T\nexpect group position\n");
    check_plays("key Escape\nexpect ends yes\n");
    check_plays("key X\nkey Escape\nexpect ends no\nkey Escape\nexpect ends yes\n");
    check_plays("set yaw_deg 5\nsave\nexpect unsaved no\nexpect notice containing rig.cfg\n"
                "save \"with blank.cfg\"\n");
    assert_int_equal(access("with blank.cfg", F_OK), 0);
    check_plays("");
    check_plays("\xef\xbb\xbfset yaw_deg 1\nexpect yaw_deg 1\n");
    check_plays("\xef\xbb\xbf");
    check_plays("\xef\xbb\xbf# a comment\n");
}

static void what_draws_is_asked_for_in_order(void **state)
{
    struct drawn drawn;
    char message[MESSAGE_SIZE];

    (void)state;
    assert_int_equal(
        play("frames 3\npicture a.png\neye 0.1 0 0\ndome \"b c.png\"\neye off\n", &drawn, message),
        STATUS_OK);
    assert_string_equal(drawn.text, "3 frames;picture a.png;dome b c.png;");
    check_fails("\npicture bad.png\n", "a.script:2: the disk burns");
}

static void what_fails_is_named_with_its_place(void **state)
{
    (void)state;
    check_fails("key A\n\nexpect yaw_deg 3\n", "a.script:3: expected yaw_deg 3");
    check_fails("set yaw_deg 2\nexpect yaw_deg 3 within 0.5", "there is 2");
    check_fails("expect lens polynomial", "expected lens polynomial; there is angular");
    check_fails("set yaw_deg 1\n\xef\xbb\xbfset yaw_deg 1\n", "a.script:2: line: '");
    check_fails("expect pattern dot", "there is grid");
    check_fails("expect undo 4", "there is 0");
    check_fails("expect warning containing x", "there is none");
    check_fails("expect notice is", "allowed: none, or containing");
    check_fails("set fov_deg 500", "set fov_deg 500 is refused: ");
    check_fails("refuse fov_deg 50", "it was taken");
    check_fails("set flip q", "flip: 'q' is not allowed; allowed: none, x, y, xy");
    check_fails("set flip 4", "flip: 4 is not allowed; allowed: none, x, y, xy");
    check_fails("expect flip xy", "expected flip xy; there is none");
    check_fails("set lens foo", "'foo' is not allowed; allowed: angular, hemispheric, equisolid");
    check_fails("expect group aims",
                "allowed: circle, lens, position, aim, screen, viewer, dot, marks");
    check_fails("expect group aim", "expected group aim; there is circle");
    check_fails("expect pattern dots", "allowed: grid, meridians");
    check_fails("expect unsaved maybe", "unsaved: 'maybe' is not allowed; allowed: no, yes");
    check_fails("expect saved yes", "notice, pattern, group, about");
    check_fails("set k1 5",
                "set k1 5 is refused: k1: the lens is angular; allowed: coefficients of a poly");
    check_fails("eye 0 5 0", "eye 0 5 0 is refused: ");
    check_fails("picture x.bmp", "picture: 'x.bmp' is not allowed; allowed: FILE.png or FILE.pfm");
    check_fails("dome x.bmp", "dome: 'x.bmp'");
}

static void what_is_no_line_is_refused(void **state)
{
    static const char *const lines[] = {
        "jump",
        "key",
        "key Foo",
        "key J",
        "key alt+A",
        "key A 0",
        "key A 1e9",
        "key A 1 2",
        "mouse 1",
        "mouse a b",
        "mouse nan 1",
        "set nothing 1",
        "set yaw_deg",
        "set yaw_deg x",
        "set yaw_deg nan",
        "set lens fisheye",
        "expect nothing 1",
        "expect yaw_deg x",
        "expect yaw_deg 1 about 2",
        "expect yaw_deg 1 within -1",
        "expect yaw_deg",
        "frames 0",
        "frames x",
        "eye 1",
        "eye 1 2 x",
        "eye 5 0 0",
        "picture x.bmp",
        "picture x",
        "dome x.jpg",
        "save a b",
        "save there/is/none.cfg",
        "expect \"warning",
        "a b c d e f g h i j k l m n o p q",
        "press hard",
    };

    (void)state;
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++)
        check_fails(lines[i], "a.script:1: ");
}

static void a_line_has_an_end(void **state)
{
    char *text = malloc(10001);

    (void)state;
    assert_non_null(text);
    memset(text, 'a', 10000);
    text[10000] = '\0';
    check_fails(text, "too long");
    free(text);
}

static void without_a_stage_nothing_is_drawn(void **state)
{
    char text[] = "frames 1\n", message[MESSAGE_SIZE];
    uint64_t seed = 4;
    struct tool tool;
    FILE *stream = fmemopen(text, sizeof text - 1, "r");

    (void)state;
    open_by_chance(&tool, &seed, "rig.cfg");
    assert_int_equal(script_play(&tool, stream, "-", NULL, message), STATUS_FAILED);
    fclose(stream);
    tool_close(&tool);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines_do_what_a_user_would),
        cmocka_unit_test(what_draws_is_asked_for_in_order),
        cmocka_unit_test(what_fails_is_named_with_its_place),
        cmocka_unit_test(what_is_no_line_is_refused),
        cmocka_unit_test(a_line_has_an_end),
        cmocka_unit_test(without_a_stage_nothing_is_drawn),
    };
    return cmocka_run_group_tests(tests, enter_folder, NULL);
}
