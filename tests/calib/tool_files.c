/* The files of a session: what is written over, and what is not. */
#include "command_fixture.h"

/* A rig with a link to it, marks, a theatre and a session that saves all. */
static void make_files(void)
{
    check_run("rm -rf *; echo save | \"$C\" --output r.cfg --script - && ln -s r.cfg same.cfg && "
              "mkdir f && printf 'name,dir_x,dir_y,dir_z\na,0,0,-1\nb,0.6,0,-0.8\n' >p.csv && "
              "ln -s p.csv p.png && cp r.cfg t.cfg.bak && cat r.cfg p.csv >before && "
              "printf 'key M\nkey Enter\nkey A\nkey Up\nkey S\n' >s.script",
              0, "");
}

static const char unchanged[] = "status=$?; cat r.cfg p.csv | cmp - before && exit $status";

static void no_file_is_written_over_another(void **state)
{
    static const struct {
        const char *options, *says;
    } wrong[] = {
        {"r.cfg --marks p.csv --marks-output r.cfg", "--rig and --marks-output are the same file"},
        {"r.cfg --marks p.csv --marks-output same.cfg", "--rig and --marks-output"},
        {"same.cfg --marks p.csv --marks-output f/../r.cfg", "--rig and --marks-output"},
        {"r.cfg --output o.cfg --marks p.csv --marks-output r.cfg", "--rig and --marks-output"},
        {"--output p.csv --marks p.csv", "--output and --marks are the same file, p.csv"},
        {"--output o.cfg --marks p.csv --marks-output o.cfg", "--output and --marks-output"},
        {"--output p-steered.csv --marks p.csv", "--output and default --marks-output"},
        {"--theatre rig.cfg", ": default --output and --theatre are the same file, rig.cfg"},
        {"t.cfg --theatre t.cfg.bak", ": default --output (what was there) and --theatre"},
        {"r.cfg --marks p.csv --marks-output r.cfg.bak", "--output (what was there) and --marks-o"},
        {"same.cfg --marks p.csv --marks-output r.cfg.bak", "--output (what was there) and"},
        {"--output y.cfg --marks p.csv --marks-output y.cfg.journal", "--output (its journal) and"},
        {"--output t.cfg.bak --theatre t.cfg.bak", "--output and --theatre"},
        {"--output t.cfg --theatre t.cfg.bak", "--output (what was there) and --theatre"},
        {"--output s.script", "--output and --script"},
        {"--marks p.csv --marks-output s.script", "--marks-output and --script"},
    };
    char line[500];

    (void)state;
    make_files();
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        snprintf(line, sizeof line, "\"$C\" %s --script s.script; %s", wrong[i].options, unchanged);
        check_run(line, 2, wrong[i].says);
        assert_non_null(strstr(output, "; allowed: files of their own\n"));
    }
    snprintf(line, sizeof line, "\"$C\" --marks p.csv --picture p.png; %s", unchanged);
    check_run(line, 2, "--marks and --picture are the same file");
}

/* A journal tells what is unsaved: with one, files are looked at as where all can be saved. */
static void what_cannot_save_names_no_file_to_be_written(void **state)
{
    static const char *const files[] = {
        "--theatre rig.cfg", "r.cfg --theatre t.cfg.bak", "t.cfg --theatre t.cfg.bak",
        "r.cfg --marks r-steered.csv --theatre r.cfg.bak --output none/rig.cfg"};
    char line[500];

    (void)state;
    make_files();
    check_run("cp r.cfg rig.cfg; cp r.cfg t.cfg; cp r.cfg r.cfg.bak; cp p.csv r-steered.csv", 0,
              "");
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        snprintf(line, sizeof line,
                 "for shown in '--picture n.png' '--headless --frames 1'; do "
                 "\"$C\" %s --windowed 32x24 $shown || exit; done",
                 files[i]);
        check_run(line, 0, "");
    }
    for (int i = 0; i < 3; i += 2) {
        snprintf(line, sizeof line, "\"$C\" %s --picture n.png --journal", files[i]);
        check_run(line, 2, ": default --output");
    }
}

static void no_line_of_a_script_writes_over_another_file(void **state)
{
    static const struct {
        const char *line, *says;
    } wrong[] = {
        {"save p.csv", "s.script:1: --marks and save are the same file, p.csv"},
        {"save n.csv", "--marks-output and save are the same file"},
        {"save r.cfg.bak", "--output (what was there) and save"},
        {"save r.cfg.journal", "--output (its journal) and save"},
        {"save t.cfg.bak", "--theatre and save"},
        {"save s.script", "--script and save"},
        {"save t.cfg", "--theatre and save"},
        {"picture p.png", "--marks and picture"},
        {"dome p.png", "--marks and dome"},
    };
    char line[500];

    (void)state;
    make_files();
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        snprintf(line, sizeof line,
                 "echo '%s' >s.script; \"$C\" r.cfg --marks p.csv --marks-output n.csv --theatre "
                 "t.cfg.bak --script s.script; %s",
                 wrong[i].line, unchanged);
        check_run(line, 1, wrong[i].says);
    }
}

static void nor_after_a_journal_has_restored_it(void **state)
{
    (void)state;
    make_files();
    check_run("cp r.cfg t.cfg; for line in 'key X' 'save t.cfg'; do echo \"$line\" | "
              "\"$C\" r.cfg --theatre t.cfg --output o.cfg --script - --journal; done; "
              "cmp r.cfg t.cfg && false",
              1, "standard input:1: --theatre and save are the same file");
    assert_non_null(strstr(output, "restored from o.cfg.journal"));
}

static void what_is_changed_in_place_may_be(void **state)
{
    (void)state;
    make_files();
    check_run(
        "\"$C\" r.cfg --marks p.csv --marks-output p.csv --theatre r.cfg --script s.script && "
        "grep -q x_px p.csv && \"$C\" t.cfg.bak --output t.cfg --script s.script && "
        "printf 'save\nsave same.cfg\nsave t.cfg\nsave o.cfg\n' | "
        "\"$C\" r.cfg --output t.cfg --script - --journal",
        0, "");
}

static void a_rig_that_is_its_own_theatre_may_be_saved_to(void **state)
{
    (void)state;
    make_files();
    check_run("for theatre in r.cfg ./r.cfg same.cfg; do echo 'save r.cfg' | "
              "\"$C\" r.cfg --output o.cfg --theatre $theatre --script - || exit; done",
              0, "");
    check_run("echo 'save r.cfg' | \"$C\" --output o.cfg --theatre r.cfg --script -", 1,
              "--theatre and save are the same file");
}

/* By another name, through a link or from the root. */
static void a_save_to_the_sessions_rig_is_one_by_any_name(void **state)
{
    (void)state;
    make_files();
    check_run("for name in ./r.cfg same.cfg f/../r.cfg \"$PWD/r.cfg\"; do "
              "printf 'key X\nsave %s\nexpect unsaved no\n' \"$name\" | "
              "\"$C\" r.cfg --script - || exit; done; "
              "printf 'key X\nsave ./new.cfg\nexpect unsaved no\n' | "
              "\"$C\" --output new.cfg --script -",
              0, "");
    /* Of a hard link only one name gets what is written. */
    check_run("ln r.cfg hard.cfg; printf 'key X\nsave hard.cfg\nexpect unsaved yes\n' | "
              "\"$C\" r.cfg --script - && ! cmp -s r.cfg hard.cfg",
              0, "");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_file_is_written_over_another),
        cmocka_unit_test(what_cannot_save_names_no_file_to_be_written),
        cmocka_unit_test(no_line_of_a_script_writes_over_another_file),
        cmocka_unit_test(nor_after_a_journal_has_restored_it),
        cmocka_unit_test(what_is_changed_in_place_may_be),
        cmocka_unit_test(a_rig_that_is_its_own_theatre_may_be_saved_to),
        cmocka_unit_test(a_save_to_the_sessions_rig_is_one_by_any_name),
    };
    return cmocka_run_group_tests(tests, enter_folder, NULL);
}
