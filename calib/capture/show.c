/* The command `capture show`: patterns on the projector, and photographs of them. */
#include <stdio.h>

#include "capture/command.h"
#include "capture/device.h"
#include "capture/folder.h"
#include "capture/shown.h"
#include "interruption.h"
#include "option_values.h"
#include "plain_text.h"
#include "status.h"

struct showing {
    const struct capture_options *options;
    struct series series;
    struct shown *shown;
    struct device *device;
};

static bool show_number(struct showing *showing, int number, char *message)
{
    struct photo picture;

    if (!capture_picture(&showing->series, number, &picture, message))
        return false;
    shown_picture(showing->shown, &picture);
    photo_free(&picture);
    return true;
}

/* By keys or by time. */
static bool show_all(struct showing *showing, char *message)
{
    double wait_s = showing->options->every_s > 0 ? showing->options->every_s : -1;
    int number = 0, count = series_count(&showing->series);

    while (number < count) {
        enum shown_wish wish;
        if (!show_number(showing, number, message))
            return false;
        wish = shown_wait(showing->shown, wait_s);
        if (wish == SHOWN_END)
            break;
        if (wish == SHOWN_BACK)
            number -= number > 0;
        else if (wish == SHOWN_NEXT || wait_s > 0)
            number++;
    }
    printf("%d of %d patterns shown\n", number, count);
    return true;
}

static bool photograph(struct showing *showing, int number, char *message)
{
    const struct capture_options *options = showing->options;
    char name[SERIES_NAME_MAX + 1], path[PATH_MAX];
    struct photo photo;
    bool done;

    series_name(&showing->series, number, name);
    if (!folder_path(options->folder, name, ".png", path, message) ||
        !show_number(showing, number, message))
        return false;
    if (shown_wait(showing->shown, options->every_s) == SHOWN_END) {
        snprintf(message, MESSAGE_SIZE, "ended after %d of %d photographs", number,
                 series_count(&showing->series));
        return false;
    }
    if (!device_take(showing->device, options->settle, options->shots, &photo, message))
        return false;
    /* 16 bits: an average has more than 8. */
    done = photo_write(path, &photo, options->shots > 1 ? PHOTO_PNG16 : PHOTO_PNG8, message);
    photo_free(&photo);
    return done;
}

static bool photograph_all(struct showing *showing, char *message)
{
    const struct capture_options *options = showing->options;
    bool held = false;
    int count = series_count(&showing->series);

    if (!folder_is_for("--folder", options->folder, ".png", &showing->series, message))
        return false;
    showing->device = device_open(options->device, options->width, options->height, message);
    if (!showing->device || !show_number(showing, 0, message) ||
        !device_settle(showing->device, &held, message) ||
        !folder_make("--folder", options->folder, message))
        return false;
    if (!held)
        fprintf(stderr, "cupola-calib capture show: the camera does not let its exposure be held; "
                        "if it follows the patterns, set it by hand\n");
    for (int i = 0; i < count; i++) {
        if (!photograph(showing, i, message))
            return false;
    }
    if (!folder_write_series(options->folder, &showing->series, message))
        return false;
    printf("%d photographs in ", count);
    plain_text_print(options->folder, stdout);
    putchar('\n');
    return true;
}

int capture_show(const struct capture_options *options, char *message)
{
    struct showing showing = {.options = options};
    int status = capture_series(options->patterns, NULL, 0, &showing.series, message);
    bool done;

    if (status != STATUS_OK)
        return status;
    interruption_expect();
    showing.shown = shown_create(showing.series.size_px[0], showing.series.size_px[1],
                                 options->monitor, options->window, message);
    done = showing.shown != NULL;
    if (done)
        done = options->device ? photograph_all(&showing, message) : show_all(&showing, message);
    device_close(showing.device);
    shown_destroy(showing.shown);
    return done ? STATUS_OK : STATUS_FAILED;
}
