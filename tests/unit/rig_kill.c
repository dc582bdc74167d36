/* A writer that is killed at any moment loses nothing: the name always has one whole rig. */
#define _XOPEN_SOURCE 700 /* folder.h */
#include <signal.h>
#include <stdio.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "check.h"
#include "cupola/rig_file.h"
#include "folder.h"

enum { KILLS = 200, LONGEST_NS = 12000000 };

/* Two rigs of very different length: a torn file of one could never be the other. */
static struct cupola_rig rig_of(int which)
{
    struct cupola_rig rig = {.screen.radius_m = which == 0 ? 1 : 2};
    if (which == 0)
        return rig;
    rig.output_count = 8;
    for (int i = 0; i < rig.output_count; i++) {
        struct cupola_lens *lens = &rig.outputs[i].lens;
        lens->model = CUPOLA_LENS_TABLE;
        lens->table_count = CUPOLA_LENS_TABLE_MAX;
        for (int k = 0; k < lens->table_count; k++)
            lens->table[k] = (struct cupola_lens_sample){0.02 * (k + 1), 1.0 / 3 * (k + 1)};
    }
    return rig;
}

/* What each rig is as a file. */
static char *whole[2];

static int make_whole_files(void **state)
{
    if (make_folder(state) != 0)
        return -1;
    for (int i = 0; i < 2; i++) {
        struct cupola_rig rig = rig_of(i);
        if (cupola_rig_write(in_folder("whole.cfg"), &rig, NULL) != CUPOLA_OK)
            return -1;
        whole[i] = content_of(in_folder("whole.cfg"));
    }
    return 0;
}

static int remove_whole_files(void **state)
{
    free(whole[0]);
    free(whole[1]);
    return remove_folder(state);
}

static void check_whole(const char *path)
{
    struct cupola_rig rig;
    struct cupola_error error = {CUPOLA_OK, ""};
    char *content = content_of(path);
    if (strcmp(content, whole[0]) != 0 && strcmp(content, whole[1]) != 0)
        fail_msg("%s holds %zu bytes that are neither rig", path, strlen(content));
    free(content);
    if (cupola_rig_read(path, NULL, &rig, &error) != CUPOLA_OK)
        fail_msg("%s", error.message);
    assert_int_equal(rig.output_count, rig.screen.radius_m == 1 ? 1 : 8);
}

static void save_for_ever(const char *path)
{
    struct cupola_rig rigs[2] = {rig_of(0), rig_of(1)};
    for (int i = 0; cupola_rig_write(path, &rigs[i % 2], NULL) == CUPOLA_OK; i++)
        ;
    _exit(1);
}

static void kill_a_writer(const char *path, long after_ns)
{
    pid_t writer = fork();
    assert_true(writer >= 0);
    if (writer == 0)
        save_for_ever(path);
    struct timespec wait = {0, after_ns};
    nanosleep(&wait, NULL);
    assert_int_equal(kill(writer, SIGKILL), 0);
    int status;
    assert_int_equal(waitpid(writer, &status, 0), writer);
    assert_true(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
}

static void two_hundred_kills_lose_nothing(void **state)
{
    (void)state;
    uint64_t seed = 20260801;
    char path[512], backup[512];
    snprintf(path, sizeof path, "%s", in_folder("rig.cfg"));
    snprintf(backup, sizeof backup, "%s", in_folder("rig.cfg.bak"));
    struct cupola_rig first = rig_of(0);
    assert_int_equal(cupola_rig_write(path, &first, NULL), CUPOLA_OK);
    for (int i = 0; i < KILLS; i++) {
        kill_a_writer(path, (long)random_between(&seed, 0, LONGEST_NS));
        check_whole(path);
        if (access(backup, F_OK) == 0)
            check_whole(backup);
    }
    /* Neither does what they left behind stand in the way of the next save. */
    assert_int_equal(cupola_rig_write(path, &first, NULL), CUPOLA_OK);
    check_whole(path);
    check_whole(backup);
}

/* A killed writer's own temporary files may stay, but no other: at most two at a time. */
static void what_stays_behind_is_hidden_and_little(void **state)
{
    (void)state;
    int left_over = 0;
    struct dirent *entry;
    DIR *directory = opendir(folder);
    assert_non_null(directory);
    while ((entry = readdir(directory)) != NULL)
        if (strncmp(entry->d_name, "rig.cfg", 7) != 0 && entry->d_name[0] != '.' &&
            strncmp(entry->d_name, "whole.cfg", 9) != 0)
            fail_msg("%s lies beside the rig", entry->d_name);
        else
            left_over += strncmp(entry->d_name, ".cupola-", 8) == 0;
    closedir(directory);
    check_at_most(left_over, 2 * KILLS);
}

int main(void)
{
    const struct CMUnitTest rig_kill[] = {
        cmocka_unit_test(two_hundred_kills_lose_nothing),
        cmocka_unit_test(what_stays_behind_is_hidden_and_little),
    };
    return cmocka_run_group_tests(rig_kill, make_whole_files, remove_whole_files);
}
