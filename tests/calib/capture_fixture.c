/* What the tests of structured light share. */
#include "capture_fixture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cupola/rig_file.h>

#include "capture/command.h"
#include "capture/folder.h"
#include "check.h"
#include "option_values.h"
#include "status.h"

enum { WORDS_MAX = 64 };

static char directory[] = "/tmp/cupola-capture-XXXXXX";

int capture_enter_directory(void **state)
{
    (void)state;
    strcpy(directory, "/tmp/cupola-capture-XXXXXX");
    return mkdtemp(directory) && chdir(directory) == 0 ? 0 : -1;
}

int capture_leave_directory(void **state)
{
    char command[100];

    (void)state;
    snprintf(command, sizeof command, "rm -rf '%s'", directory);
    return chdir("/") == 0 && system(command) == 0 ? 0 : -1;
}

int capture_run(const char *line, char *message)
{
    static int (*const commands[])(const struct capture_options *, char *) = {
        capture_patterns, capture_show, capture_decode, capture_simulate};
    char copy[2000];
    static char name[] = "capture";
    char *words[WORDS_MAX] = {name};
    int count = 1, status;
    struct capture_options options;

    snprintf(copy, sizeof copy, "%s", line);
    for (char *word = strtok(copy, " "); word; word = strtok(NULL, " ")) {
        assert_true(count < WORDS_MAX - 1);
        words[count++] = word;
    }
    *message = 0;
    status = capture_options_parse(count, words, &options, message);
    return status == STATUS_OK ? commands[options.command](&options, message) : status;
}

void capture_refuse(const char *line, int status, const char *reason)
{
    char message[MESSAGE_SIZE];

    assert_int_equal(capture_run(line, message), status);
    if (!strstr(message, reason))
        fail_msg("%s: '%s' does not say '%s'", line, message, reason);
    assert_null(strchr(message, '\n'));
    assert_int_not_equal(access("m.csv", F_OK), 0);
}

void capture_write_rig(const char *path, const struct cupola_rig *rig)
{
    struct cupola_error error = {0};

    if (cupola_rig_write(path, rig, &error) < 0)
        fail_msg("%s", error.message);
}

void capture_write_photos(const char *folder, const struct series *series, int width, int height,
                          capture_light *light, void *data)
{
    char message[MESSAGE_SIZE], name[SERIES_NAME_MAX + 1], path[PATH_MAX];

    assert_true(folder_make("--folder", folder, message));
    assert_true(folder_write_series(folder, series, message));
    for (int number = 0; number < series_count(series); number++) {
        struct series_picture picture = series_picture(series, number);
        struct photo photo;
        assert_true(photo_create(&photo, width, height, message));
        for (int j = 0; j < height; j++) {
            for (int i = 0; i < width; i++)
                photo.light[j * width + i] = (float)light(&picture, i, j, data);
        }
        series_name(series, number, name);
        assert_true(folder_path(folder, name, ".pfm", path, message));
        assert_true(photo_write(path, &photo, PHOTO_PFM, message));
        photo_free(&photo);
    }
}
