/* The tool as a user meets it on a command line, without a display. */
#include "command_fixture.h"

static void help_names_every_key_and_value(void **state)
{
    struct key_line line;

    (void)state;
    assert_int_equal(run("\"$C\" --help"), 0);
    for (int i = 0; key_line(i, &line); i++)
        assert_non_null(strstr(output, line.help));
    for (int i = 0; parameter_name(i); i++)
        assert_non_null(strstr(output, parameter_name(i)));
    assert_non_null(strstr(output, "\n  flip is none, x, y, xy\n  lens is angular, "));
    check_run("\"$C\" -h", 0, "Usage: ");
    check_run("\"$C\" --version", 0, "cupola-calib ");
}

static void wrong_options_are_refused_in_one_line(void **state)
{
    static const struct {
        const char *options, *says;
    } wrong[] = {
        {"--foo", "unknown option '--foo'"},
        {"-x", "unknown option '-x'"},
        {"--rig", "needs a value"},
        {"--help=3", "takes no value"},
        {"--pattern spiral", "grid, meridians"},
        {"--preview in", "none, eye, outside"},
        {"--windowed 0x5", "1 to 32768"},
        {"--windowed=big", "WxH"},
        {"--frames 0", "1 to 1000000"},
        {"a.cfg b.cfg", "one rig file"},
        {"--rig a.cfg --preset visionstation", "one of them"},
        {"--headless", "--script, --picture or --frames"},
        {"--marks-output a.csv", "needs --marks"},
        {"--projector 3 --script -", "0 to 0"},
        {"--script - --picture a.png", "'picture FILE.png'"},
        {"--script - --osc 9000", "'eye X Y Z'"},
        {"--picture a.png --osc 9000", "without --headless and --picture"},
        {"--viewer-lookahead 5", "needs --osc"},
        {"--osc 0 --viewer-lookahead 501", "0 to 500"},
        {"--osc nowhere", "HOST:PORT"},
        {"--picture a.jpg", "FILE.png or FILE.pfm"},
        {"--output ''", "''"},
        {"''", "''"},
    };
    char line[300];

    (void)state;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        snprintf(line, sizeof line, "\"$C\" %s </dev/null", wrong[i].options);
        check_run(line, 2, wrong[i].says);
        assert_ptr_equal(strchr(output, '\n') + 1, output + strlen(output));
    }
}

static void a_theatre_without_the_projector_is_refused(void **state)
{
    (void)state;
    check_run("echo 'outputs = ({ size_px = [64, 48]; });' >one.cfg;"
              "echo 'outputs = ({ size_px = [64, 48]; }, { size_px = [80, 48]; });' >two.cfg;"
              "\"$C\" two.cfg --projector 1 --theatre one.cfg --script - </dev/null",
              2,
              "--projector: 1 is not in --theatre one.cfg, which has 1 projector; allowed: 0 to 0");
    check_run("\"$C\" one.cfg --theatre two.cfg --script - </dev/null", 0, "");
    check_run("\"$C\" two.cfg --projector 1 --theatre two.cfg --script - </dev/null", 0, "");
}

static void missing_files_are_failures(void **state)
{
    (void)state;
    check_run("\"$C\" none.cfg --script - </dev/null", 1, "none.cfg");
    check_run("\"$C\" --marks none.csv --script - </dev/null", 1, "none.csv");
    check_run("\"$C\" --theatre none.cfg --script - </dev/null", 1, "none.cfg");
    check_run("\"$C\" --script none.script", 1,
              "none.script cannot be read: No such file or directory");
    check_run("\"$C\" --script . ", 1, "cannot be read: Is a directory");
    check_run("\"$C\" --output no/rig.cfg --script - </dev/null", 1, "no/rig.cfg");
    check_run("\"$C\"", 1, "neither DISPLAY nor WAYLAND_DISPLAY");
}

static void a_session_as_a_script(void **state)
{
    (void)state;
    check_run("printf 'name,dir_x,dir_y,dir_z\\na,0,0,-1\\nb,0.6,0,-0.8\\n' >marks.csv;"
              "printf 'key M\\nkey Right 3\\nkey Enter 2\\nexpect marks_steered 2\\n"
              "set viewer_y_m 0.2\\nkey S\\nexpect notice containing marks-steered.csv\\n"
              "picture window.png\\ndome dome.png\\nframes 2\\n' |"
              "\"$C\" --preset visionstation --output s.cfg --marks marks.csv --windowed 320x240 "
              "--script - && grep -q 'eye_m = .0.0, 0.2, 0.0' s.cfg && grep -c , marks-steered.csv "
              "&& test -s window.png && test -s dome.png",
              0, "3");
    check_run("printf 'key A\\n\\nexpect yaw_deg 4\\n' | \"$C\" --script -", 1,
              "standard input:3: expected yaw_deg 4");
    check_run("\"$C\" s.cfg --picture p.png --windowed 64x48 && test -s p.png", 0, "");
    check_run("\"$C\" s.cfg --headless --frames 2 --windowed 64x48", 0, "");
}

static void what_no_terminal_should_get_is_a_question_mark(void **state)
{
    (void)state;
    check_run("printf 'set z\\377\\344\\033[2J\\302\\233\\177\\303\\274 1\\n' | \"$C\" --script -",
              1, "set: 'z???[2J???\303\274' is not allowed");
    check_run("\"$C\" --script \"$(printf 'x\\033\\200')\"", 1, "x?? cannot be read");
    check_run("echo 'key X' | \"$C\" --script - --journal --output "
              "\"$(printf 'x\\033')\"",
              0, "kept in x?.journal");
}

static void a_script_keeps_a_journal_only_if_asked(void **state)
{
    (void)state;
    check_run("echo 'key X' | \"$C\" --output j.cfg --script - && test ! -e j.cfg.journal", 0, "");
    check_run("echo 'key X' | \"$C\" --output j.cfg --script - --journal; test -e j.cfg.journal", 0,
              "unsaved changes are kept in j.cfg.journal");
    check_run("printf 'expect flip 1\\nexpect notice containing restored\\nkey S\\n' |"
              "\"$C\" --output j.cfg --script - --journal && test ! -e j.cfg.journal",
              0, "");
}

static void two_programs_cannot_share_a_rig(void **state)
{
    (void)state;
    check_run("mkfifo lines; \"$C\" --output t.cfg --script - --journal <lines & exec 9<>lines;"
              "for i in $(seq 2000); do test -s t.cfg.journal && break; sleep 0.01; done;"
              "\"$C\" --output t.cfg --script - --journal </dev/null; status=$?;"
              "exec 9>&-; wait; exit $status",
              1, "in use");
}

static void killed_it_goes_on_where_it_was(void **state)
{
    (void)state;
    check_run(
        "mkfifo keys; \"$C\" --output k.cfg --script - --journal <keys & process=$!;"
        "exec 9<>keys; printf 'set yaw_deg 7\\nset pitch_deg 3\\n' >&9;"
        "for i in $(seq 2000); do grep -q '^[0-9]* change 14' k.cfg.journal 2>/dev/null && "
        "break; sleep 0.01; done;"
        "kill -9 $process; wait $process; exec 9>&-;"
        "printf 'expect yaw_deg 7\\nexpect pitch_deg 3\\nkey ctrl+Z\\nexpect pitch_deg 0\\n' |"
        "\"$C\" --output k.cfg --script - --journal",
        0, "");
    check_run("printf 'expect yaw_deg 0\\n' | \"$C\" --output k.cfg --script - --journal --fresh "
              "&& test -s k.cfg.journal.old",
              0, "");
}

/* A rig of its own, and a session that leaves an unsaved yaw of 7 behind. */
static const char left_unsaved[] =
    "rm -f o.cfg* o.csv*; printf 'set pitch_deg 1.1\\nsave\\n' | \"$C\" --output o.cfg --script -;"
    "printf 'name,dir_x,dir_y,dir_z\\na,0,0,-1\\nb,0.6,0,-0.8\\n' >o.csv;"
    "printf '%sset yaw_deg 7\\n' | \"$C\" o.cfg --marks o.csv --script - --journal 2>/dev/null; ";

static void what_was_changed_behind_a_journal_is_told(void **state)
{
    static const struct {
        const char *saved, *changes, *given, *says; /* NULL: nothing */
    } cases[] = {
        {"", "true", "o.cfg --marks o.csv", NULL},
        {"", "true", "o.cfg", NULL},
        {"", "sed -i 's/1\\.1/2.1/' o.cfg", "o.cfg --marks o.csv",
         "but o.cfg has been changed since"},
        {"", "sed -i s/0.6/0.5/ o.csv", "o.cfg --marks o.csv", "but o.csv has been changed since"},
        {"", "true", "--preset domemaster --output o.cfg",
         "but --preset domemaster is another rig"},
        {"", "true", "--output o.cfg", "but the default is another rig"},
        {"set pitch_deg 3.3\\nkey M\\nkey Enter\\nsave\\n", "true", "o.cfg --marks o.csv", NULL},
        {"set pitch_deg 3.3\\nkey M\\nkey Enter\\nsave\\n", "true", "o.cfg --marks o-steered.csv",
         NULL},
        {"set pitch_deg 3.3\\nsave\\n", "sed -i 's/3\\.3/2.1/' o.cfg", "o.cfg",
         "but o.cfg has been changed"},
    };
    char line[3000], session[1500];

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        snprintf(session, sizeof session, left_unsaved, cases[i].saved);
        snprintf(line, sizeof line,
                 "%s %s; printf 'expect yaw_deg 7\\n' | \"$C\" %s --script - --journal", session,
                 cases[i].changes, cases[i].given);
        check_run(line, 0, cases[i].says ? cases[i].says : "restored from");
        if (!cases[i].says && strstr(output, ", but "))
            fail_msg("%s: %s", line, output);
    }
}

static void links_lead_to_one_journal(void **state)
{
    (void)state;
    check_run("\"$C\" --output l.cfg --script - --journal </dev/null; echo save | \"$C\" --output "
              "l.cfg --script -; ln -s l.cfg link.cfg; mkfifo names;"
              "\"$C\" l.cfg --script - --journal <names & exec 9<>names;"
              "for i in $(seq 2000); do test -s l.cfg.journal && break; sleep 0.01; done;"
              "\"$C\" link.cfg --script - --journal </dev/null; status=$?;"
              "exec 9>&-; wait; test ! -e link.cfg.journal && exit $status",
              1, "in use");
}

static void on_a_full_disk_what_is_lost_is_said(void **state)
{
    (void)state;
    check_run("(ulimit -f 0; echo 'key X' | \"$C\" --output f.cfg --script - --journal)", 0,
              "unsaved changes are lost: f.cfg.journal cannot be written (File too large)");
    assert_null(strstr(output, "are kept"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(help_names_every_key_and_value),
        cmocka_unit_test(wrong_options_are_refused_in_one_line),
        cmocka_unit_test(missing_files_are_failures),
        cmocka_unit_test(a_theatre_without_the_projector_is_refused),
        cmocka_unit_test(a_session_as_a_script),
        cmocka_unit_test(what_no_terminal_should_get_is_a_question_mark),
        cmocka_unit_test(a_script_keeps_a_journal_only_if_asked),
        cmocka_unit_test(two_programs_cannot_share_a_rig),
        cmocka_unit_test(killed_it_goes_on_where_it_was),
        cmocka_unit_test(what_was_changed_behind_a_journal_is_told),
        cmocka_unit_test(links_lead_to_one_journal),
        cmocka_unit_test(on_a_full_disk_what_is_lost_is_said),
    };
    return cmocka_run_group_tests(tests, enter_folder, NULL);
}
