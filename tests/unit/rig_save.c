/* Saving: a file appears whole or not at all, and the one before stays. */
#define _XOPEN_SOURCE 700 /* folder.h */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "check.h"
#include "cupola/rig_file.h"
#include "folder.h"

static int save(const char *path, double radius_m, struct cupola_error *error)
{
    struct cupola_rig rig = {.screen.radius_m = radius_m};
    return cupola_rig_write(path, &rig, error);
}

static double saved_radius(const char *path)
{
    struct cupola_rig rig;
    struct cupola_error error;
    if (cupola_rig_read(path, NULL, &rig, &error) != CUPOLA_OK)
        fail_msg("%s", error.message);
    return rig.screen.radius_m;
}

static mode_t mode_of(const char *path)
{
    struct stat status;
    assert_int_equal(stat(path, &status), 0);
    return status.st_mode & 0777;
}

static void check_refused(const char *path, const char *what)
{
    struct cupola_error error = {0};
    int before = entries_in_folder();
    assert_int_equal(save(path, 2, &error), CUPOLA_ERROR_FILE);
    if (!strstr(error.message, path) || !strstr(error.message, what))
        fail_msg("'%s' does not name %s and '%s'", error.message, path, what);
    assert_int_equal(entries_in_folder(), before);
}

static void the_file_before_stays_as_bak(void **state)
{
    (void)state;
    const char *path = in_folder("rig.cfg"), *backup = in_folder("rig.cfg.bak");
    assert_int_equal(save(path, 1, NULL), CUPOLA_OK);
    assert_int_equal(entries_in_folder(), 1);
    char *first = content_of(path);
    assert_int_equal(save(path, 2, NULL), CUPOLA_OK);
    assert_int_equal(entries_in_folder(), 2);
    char *kept = content_of(backup);
    assert_string_equal(kept, first);
    assert_int_equal(save(path, 3, NULL), CUPOLA_OK);
    assert_int_equal(entries_in_folder(), 2);
    check_near(saved_radius(path), 3, 0);
    check_near(saved_radius(backup), 2, 0);
    free(first);
    free(kept);
}

static void permissions_are_kept_and_the_umask_is_respected(void **state)
{
    (void)state;
    const char *path = in_folder("mode.cfg");
    mode_t before = umask(027);
    assert_int_equal(save(path, 1, NULL), CUPOLA_OK);
    assert_int_equal(mode_of(path), 0640);
    assert_int_equal(chmod(path, 0604), 0);
    assert_int_equal(save(path, 2, NULL), CUPOLA_OK);
    assert_int_equal(mode_of(path), 0604);
    umask(before);
}

static void a_link_stays_a_link(void **state)
{
    (void)state;
    const char *link = in_folder("link.cfg"), *target = in_folder("target.cfg");
    struct stat status;
    assert_int_equal(symlink("target.cfg", link), 0);
    check_refused(link, "symbolic link that leads nowhere");
    assert_int_equal(save(target, 1, NULL), CUPOLA_OK);
    assert_int_equal(save(link, 2, NULL), CUPOLA_OK);
    assert_int_equal(lstat(link, &status), 0);
    assert_true(S_ISLNK(status.st_mode));
    check_near(saved_radius(target), 2, 0);
    check_near(saved_radius(in_folder("target.cfg.bak")), 1, 0);
}

static void places_that_cannot_be_written_are_refused(void **state)
{
    (void)state;
    check_refused(in_folder("missing/rig.cfg"), "No such file or directory");
    check_refused(folder, "is a directory; allowed: a regular file or a new name");
    check_refused("/dev/full", "is a device or a pipe; allowed: a regular file or a new name");
    check_refused("/dev/null", "is a device or a pipe");
    assert_int_equal(mkfifo(in_folder("pipe"), 0600), 0);
    check_refused(in_folder("pipe"), "is a device or a pipe");
    put(in_folder("file"), "");
    check_refused(in_folder("file/rig.cfg"), "Not a directory");
    check_refused("/proc/cupola-rig.cfg", "/proc");
    assert_int_equal(save("", 1, NULL), CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(save(NULL, 1, NULL), CUPOLA_ERROR_ARGUMENT);
    char name[300];
    memset(name, 'x', sizeof name);
    name[299] = 0;
    check_refused(in_folder(name), "File name too long");
}

/* Permissions bind everybody but root, so this is done as somebody else where it can be. */
static void without_permission_nothing_changes(void **state)
{
    (void)state;
    const char *path = in_folder("readonly.cfg");
    assert_int_equal(save(path, 1, NULL), CUPOLA_OK);
    assert_int_equal(chmod(path, 0444), 0);
    assert_int_equal(chmod(folder, 0777), 0);
    uid_t own = geteuid();
    assert_int_equal(own == 0 ? seteuid(65534) : 0, 0);
    check_refused(path, "Permission denied");
    assert_int_equal(own == 0 ? seteuid(own) : 0, 0);
    assert_int_equal(chmod(path, 0666), 0);
    assert_int_equal(chmod(folder, 0555), 0);
    assert_int_equal(own == 0 ? seteuid(65534) : 0, 0);
    check_refused(path, "Permission denied");
    check_refused(in_folder("new.cfg"), "Permission denied");
    assert_int_equal(own == 0 ? seteuid(own) : 0, 0);
    assert_int_equal(chmod(folder, 0700), 0);
    check_near(saved_radius(path), 1, 0);
}

/* A limit of the file size stands for the full disk: writes come out short. */
static void a_full_disk_leaves_the_file_before(void **state)
{
    (void)state;
    struct rlimit before, tight;
    const char *path = in_folder("full.cfg");
    assert_int_equal(save(path, 1, NULL), CUPOLA_OK);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    tight = before;
    tight.rlim_cur = 100;
    void (*handler)(int) = signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &tight), 0);
    struct cupola_error error = {0};
    int entries = entries_in_folder();
    int status = save(path, 2, &error), fresh = save(in_folder("fresh.cfg"), 2, NULL);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
    signal(SIGXFSZ, handler);
    assert_int_equal(status, CUPOLA_ERROR_FILE);
    assert_int_equal(fresh, CUPOLA_ERROR_FILE);
    assert_non_null(strstr(error.message, "full.cfg: cannot be written: File too large"));
    assert_int_equal(entries_in_folder(), entries);
    check_near(saved_radius(path), 1, 0);
}

static void a_backup_that_cannot_be_written_stops_the_save(void **state)
{
    (void)state;
    const char *path = in_folder("blocked.cfg");
    assert_int_equal(save(path, 1, NULL), CUPOLA_OK);
    assert_int_equal(mkdir(in_folder("blocked.cfg.bak"), 0700), 0);
    check_refused(path, "blocked.cfg.bak: is a directory");
    check_near(saved_radius(path), 1, 0);
}

static void an_impossible_rig_is_not_written(void **state)
{
    (void)state;
    struct cupola_error error = {0};
    int entries = entries_in_folder();
    assert_int_equal(save(in_folder("impossible.cfg"), -1, &error), CUPOLA_ERROR_ARGUMENT);
    assert_non_null(strstr(error.message, "impossible.cfg: "));
    assert_int_equal(cupola_rig_write(in_folder("impossible.cfg"), NULL, NULL),
                     CUPOLA_ERROR_ARGUMENT);
    assert_int_equal(entries_in_folder(), entries);
}

static void save_for_ever(const char *path)
{
    for (double radius_m = 1; save(path, radius_m, NULL) == CUPOLA_OK; radius_m = 3 - radius_m)
        ;
    _exit(1);
}

/* Readers beside a writer, and a writer killed at any moment: the name always has a whole rig. */
static void whoever_reads_meanwhile_sees_a_whole_file(void **state)
{
    (void)state;
    const char *path = in_folder("busy.cfg");
    assert_int_equal(save(path, 1, NULL), CUPOLA_OK);
    for (int round = 0; round < 5; round++) {
        pid_t writer = fork();
        assert_true(writer >= 0);
        if (writer == 0)
            save_for_ever(path);
        for (int i = 0; i < 100; i++) {
            double radius_m = saved_radius(path);
            assert_true(radius_m == 1 || radius_m == 2);
        }
        int status;
        assert_int_equal(kill(writer, SIGKILL), 0);
        assert_int_equal(waitpid(writer, &status, 0), writer);
        assert_true(WIFSIGNALED(status));
        check_at_most(fabs(saved_radius(path) - 1.5), 0.5);
    }
}

int main(void)
{
    const struct CMUnitTest rig_save[] = {
        cmocka_unit_test(the_file_before_stays_as_bak),
        cmocka_unit_test(permissions_are_kept_and_the_umask_is_respected),
        cmocka_unit_test(a_link_stays_a_link),
        cmocka_unit_test(places_that_cannot_be_written_are_refused),
        cmocka_unit_test(without_permission_nothing_changes),
        cmocka_unit_test(a_full_disk_leaves_the_file_before),
        cmocka_unit_test(a_backup_that_cannot_be_written_stops_the_save),
        cmocka_unit_test(an_impossible_rig_is_not_written),
        cmocka_unit_test(whoever_reads_meanwhile_sees_a_whole_file),
    };
    return cmocka_run_group_tests(rig_save, make_folder, remove_folder);
}
