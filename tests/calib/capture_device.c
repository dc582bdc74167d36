/*
 * Photographs by V4L2, against a camera that this program plays itself: the calls of libv4l2 are
 * defined here, and the linker takes these.
 */
#include <errno.h>
#include <fcntl.h>
#include <linux/videodev2.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include <libv4l2.h>

#include "capture/device.h"
#include "check.h"
#include "option_values.h"

enum { WIDTH = 8, HEIGHT = 6, STRIDE = 32, SIZE = STRIDE * HEIGHT };

/* The camera. */
static struct {
    bool absent, is_sound, no_rgb, no_buffers, no_hold; /* what is wrong with it */
    int fails_after;                                    /* frames; 0: never */
    int broken;                                         /* so many frames are broken first */
    int settles_at;   /* frame from which light no longer changes */
    int base, change; /* number of a frame: base plus frame modulo change */
    int frame, opened, mapped, queued, streams, held;
    unsigned char *bytes[4];
} fake;

int v4l2_open(const char *file, int flags, ...)
{
    (void)file;
    (void)flags;
    if (fake.absent) {
        errno = ENOENT;
        return -1;
    }
    fake.opened++;
    return open("/dev/null", O_RDONLY); /* poll finds it ready */
}

int v4l2_close(int file)
{
    fake.opened--;
    return close(file);
}

void *v4l2_mmap(void *start, size_t length, int prot, int flags, int fd, int64_t offset)
{
    (void)start;
    (void)prot;
    (void)flags;
    (void)fd;
    assert_int_equal(length, SIZE);
    fake.mapped++;
    return fake.bytes[offset / 4096] = malloc(length);
}

int v4l2_munmap(void *start, size_t length)
{
    (void)length;
    fake.mapped--;
    free(start);
    return 0;
}

static int fail_with(int number)
{
    errno = number;
    return -1;
}

/* Grey, brighter upwards by one per row; what lies beyond the width is noise. */
static int give_frame(struct v4l2_buffer *buffer)
{
    int frame = fake.frame++;
    int unsettled = frame < fake.settles_at ? 5 * (fake.settles_at - frame) : 0;
    int number = fake.base - unsettled + (fake.change ? frame % fake.change : 0);

    if (fake.fails_after && frame >= fake.fails_after)
        return fail_with(ENODEV);
    if (fake.queued < 1)
        return fail_with(EAGAIN);
    fake.queued--;
    buffer->index = (unsigned int)(frame % 4);
    buffer->bytesused = frame < fake.broken ? SIZE / 2 : SIZE;
    buffer->flags = 0;
    memset(fake.bytes[buffer->index], 255, SIZE);
    for (int j = 0; j < HEIGHT; j++)
        memset(fake.bytes[buffer->index] + STRIDE * j, number + (HEIGHT - 1 - j), 3 * WIDTH);
    return 0;
}

static int set_format(struct v4l2_format *format)
{
    format->fmt.pix.width = WIDTH;
    format->fmt.pix.height = HEIGHT;
    format->fmt.pix.bytesperline = STRIDE;
    format->fmt.pix.pixelformat = fake.no_rgb ? V4L2_PIX_FMT_YUYV : V4L2_PIX_FMT_RGB24;
    return 0;
}

int v4l2_ioctl(int fd, unsigned long int request, ...)
{
    va_list list;
    void *data;

    (void)fd;
    va_start(list, request);
    data = va_arg(list, void *);
    va_end(list);
    switch (request) {
    case VIDIOC_QUERYCAP: {
        struct v4l2_capability *able = data;
        strcpy((char *)able->card, "a fake");
        able->capabilities =
            V4L2_CAP_STREAMING | (fake.is_sound ? V4L2_CAP_AUDIO : V4L2_CAP_VIDEO_CAPTURE);
        return 0;
    }
    case VIDIOC_G_FMT:
    case VIDIOC_S_FMT:
        return set_format(data);
    case VIDIOC_REQBUFS:
        return fake.no_buffers ? fail_with(ENOMEM) : 0;
    case VIDIOC_QUERYBUF: {
        struct v4l2_buffer *buffer = data;
        buffer->length = SIZE;
        buffer->m.offset = 4096 * buffer->index;
        return 0;
    }
    case VIDIOC_QBUF:
        fake.queued++;
        return 0;
    case VIDIOC_DQBUF:
        return give_frame(data);
    case VIDIOC_STREAMON:
    case VIDIOC_STREAMOFF:
        fake.streams = request == VIDIOC_STREAMON;
        return 0;
    case VIDIOC_S_CTRL:
        if (fake.no_hold)
            return fail_with(EINVAL);
        fake.held++;
        return 0;
    default:
        return fail_with(ENOTTY);
    }
}

static double light_of(double number)
{
    return pow((number / 255 + 0.055) / 1.055, 2.4);
}

static int new_camera(void **state)
{
    (void)state;
    memset(&fake, 0, sizeof fake);
    fake.base = 100;
    return 0;
}

static int check_closed(void **state)
{
    (void)state;
    return fake.opened == 0 && fake.mapped == 0 && fake.streams == 0 ? 0 : -1;
}

static void test_frames_are_averaged_from_the_bottom_up(void **state)
{
    char message[MESSAGE_SIZE];
    struct device *device = device_open("/dev/video7", 0, 0, message);
    struct photo photo;

    (void)state;
    assert_non_null(device);
    fake.change = 2; /* 100, 101, 100 ... */
    fake.broken = 3;
    assert_true(device_take(device, 1, 4, &photo, message));
    assert_int_equal(fake.frame, 3 + 1 + 4);
    assert_int_equal(photo.width, WIDTH);
    assert_int_equal(photo.height, HEIGHT);
    for (int j = 0; j < HEIGHT; j++) {
        for (int i = 0; i < WIDTH; i++)
            check_near(photo.light[j * WIDTH + i], 0.5 * (light_of(100 + j) + light_of(101 + j)),
                       1e-6);
    }
    photo_free(&photo);
    device_close(device);
}

static void test_light_settles_before_it_is_held(void **state)
{
    char message[MESSAGE_SIZE];
    struct device *device = device_open("/dev/video7", 640, 480, message);
    bool held = false;

    (void)state;
    assert_non_null(device);
    fake.settles_at = 12;
    assert_true(device_settle(device, &held, message));
    assert_true(held);
    check_at_least(fake.frame, 12 + 8);
    check_at_most(fake.frame, 12 + 10);
    fake.no_hold = true;
    assert_true(device_settle(device, &held, message));
    assert_false(held);
    fake.change = 3; /* for ever */
    fake.base = 10;
    assert_false(device_settle(device, &held, message));
    assert_non_null(strstr(message, "does not settle"));
    device_close(device);
}

static void test_a_camera_that_is_none_is_refused(void **state)
{
    static const char *const reasons[] = {"cannot be opened: No such file",
                                          "cannot stream pictures", "not as RGB", "no buffers"};
    char message[MESSAGE_SIZE];

    for (int i = 0; i < 4; i++) {
        new_camera(state);
        fake.absent = i == 0;
        fake.is_sound = i == 1;
        fake.no_rgb = i == 2;
        fake.no_buffers = i == 3;
        assert_null(device_open("/dev/video7", 0, 0, message));
        assert_non_null(strstr(message, "/dev/video7"));
        assert_non_null(strstr(message, reasons[i]));
        assert_int_equal(check_closed(state), 0);
    }
}

static void test_a_camera_that_goes_away_is_said(void **state)
{
    char message[MESSAGE_SIZE];
    struct device *device = device_open("/dev/video7", 0, 0, message);
    struct photo photo;

    (void)state;
    fake.fails_after = 5;
    assert_true(device_take(device, 1, 2, &photo, message));
    photo_free(&photo);
    assert_false(device_take(device, 1, 2, &photo, message));
    assert_non_null(strstr(message, "gives no more frames: No such device"));
    assert_null(photo.light);
    device_close(device);

    new_camera(state);
    device = device_open("/dev/video7", 0, 0, message);
    fake.broken = 1000;
    assert_false(device_take(device, 0, 1, &photo, message));
    assert_non_null(strstr(message, "broken frames"));
    device_close(device);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_frames_are_averaged_from_the_bottom_up, new_camera,
                                        check_closed),
        cmocka_unit_test_setup_teardown(test_light_settles_before_it_is_held, new_camera,
                                        check_closed),
        cmocka_unit_test_setup_teardown(test_a_camera_that_is_none_is_refused, new_camera,
                                        check_closed),
        cmocka_unit_test_setup_teardown(test_a_camera_that_goes_away_is_said, new_camera,
                                        check_closed),
    };
    return cmocka_run_group_tests_name("calib capture_device", tests, NULL, NULL);
}
