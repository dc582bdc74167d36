/* A camera by V4L2. */
#include "capture/device.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/videodev2.h>
#include <math.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include <libv4l2.h>

#include "capture/light.h"
#include "option_values.h"
#include "short_path.h"

enum {
    BUFFERS = 4,
    FRAME_WAIT_MS = 5000,
    SETTLED_FRAMES = 8, /* one after the other that are alike */
    SETTLE_FRAMES_MAX = 150,
    BROKEN_FRAMES_MAX = 30,
};

/* Frames are alike where the mean of their numbers differs by less than this part. */
static const double settled_part = 0.005;

struct device {
    char name[SHORT_PATH_MAX + 1];
    int file;
    int width, height, stride;
    bool streams;
    int buffer_count;
    struct {
        unsigned char *bytes;
        size_t size;
    } buffers[BUFFERS];
    double light[256]; /* of a frame's numbers */
};

static int request(int file, unsigned long code, void *data)
{
    int status;

    do
        status = v4l2_ioctl(file, code, data);
    while (status < 0 && errno == EINTR);
    return status;
}

static bool fail(const struct device *device, char *message, const char *what)
{
    snprintf(message, MESSAGE_SIZE, "--device: %s %s: %s", device->name, what, strerror(errno));
    return false;
}

static bool check_kind(const struct device *device, char *message)
{
    struct v4l2_capability able = {0};
    unsigned int flags;

    if (request(device->file, VIDIOC_QUERYCAP, &able) < 0)
        return fail(device, message, "is no camera");
    flags = able.capabilities & V4L2_CAP_DEVICE_CAPS ? able.device_caps : able.capabilities;
    if (flags & V4L2_CAP_VIDEO_CAPTURE && flags & V4L2_CAP_STREAMING)
        return true;
    snprintf(message, MESSAGE_SIZE,
             "--device: %s (%.32s) cannot stream pictures; allowed: a camera that can",
             device->name, (const char *)able.card);
    return false;
}

static bool set_format(struct device *device, int width, int height, char *message)
{
    struct v4l2_format format = {.type = V4L2_BUF_TYPE_VIDEO_CAPTURE};

    if (request(device->file, VIDIOC_G_FMT, &format) < 0)
        return fail(device, message, "does not say what its pictures are");
    if (width > 0) {
        format.fmt.pix.width = (unsigned int)width;
        format.fmt.pix.height = (unsigned int)height;
    }
    format.fmt.pix.pixelformat = V4L2_PIX_FMT_RGB24;
    format.fmt.pix.field = V4L2_FIELD_ANY;
    format.fmt.pix.bytesperline = 0;
    if (request(device->file, VIDIOC_S_FMT, &format) < 0)
        return fail(device, message, "refuses the size or RGB");
    if (format.fmt.pix.pixelformat != V4L2_PIX_FMT_RGB24 || format.fmt.pix.width < 1 ||
        format.fmt.pix.height < 1 || format.fmt.pix.width > PHOTO_SIDE_MAX ||
        format.fmt.pix.height > PHOTO_SIDE_MAX) {
        snprintf(message, MESSAGE_SIZE,
                 "--device: %s gives %u x %u px, not as RGB; allowed: RGB of up to %d px each way",
                 device->name, format.fmt.pix.width, format.fmt.pix.height, PHOTO_SIDE_MAX);
        return false;
    }
    device->width = (int)format.fmt.pix.width;
    device->height = (int)format.fmt.pix.height;
    device->stride = (int)format.fmt.pix.bytesperline;
    if (device->stride < 3 * device->width)
        device->stride = 3 * device->width;
    return true;
}

static bool map_buffers(struct device *device, char *message)
{
    struct v4l2_requestbuffers wish = {
        .count = BUFFERS, .type = V4L2_BUF_TYPE_VIDEO_CAPTURE, .memory = V4L2_MEMORY_MMAP};

    if (request(device->file, VIDIOC_REQBUFS, &wish) < 0 || wish.count < 1)
        return fail(device, message, "gives no buffers for its frames");
    for (unsigned int i = 0; i < wish.count && i < BUFFERS; i++) {
        struct v4l2_buffer buffer = {
            .index = i, .type = V4L2_BUF_TYPE_VIDEO_CAPTURE, .memory = V4L2_MEMORY_MMAP};
        void *bytes;
        if (request(device->file, VIDIOC_QUERYBUF, &buffer) < 0)
            return fail(device, message, "gives no buffers for its frames");
        bytes = v4l2_mmap(NULL, buffer.length, PROT_READ | PROT_WRITE, MAP_SHARED, device->file,
                          buffer.m.offset);
        if (bytes == MAP_FAILED)
            return fail(device, message, "gives no buffers for its frames");
        device->buffers[i].bytes = bytes;
        device->buffers[i].size = buffer.length;
        device->buffer_count++;
        if (request(device->file, VIDIOC_QBUF, &buffer) < 0)
            return fail(device, message, "gives no buffers for its frames");
    }
    return true;
}

static bool start(struct device *device, int width, int height, char *message)
{
    int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;

    if (!check_kind(device, message) || !set_format(device, width, height, message) ||
        !map_buffers(device, message))
        return false;
    if (request(device->file, VIDIOC_STREAMON, &type) < 0)
        return fail(device, message, "does not start");
    device->streams = true;
    return true;
}

struct device *device_open(const char *path, int width, int height, char *message)
{
    struct device *device = calloc(1, sizeof *device);

    if (!device) {
        snprintf(message, MESSAGE_SIZE, "out of memory for a camera");
        return NULL;
    }
    memcpy(device->name, short_path(path).text, sizeof device->name);
    for (int i = 0; i < 256; i++)
        device->light[i] = light_decode(i / 255.0);
    /* libv4l2 would print lines of its own beside the message. */
    if (!v4l2_log_file)
        v4l2_log_file = fopen("/dev/null", "w");
    device->file = v4l2_open(path, O_RDWR | O_NONBLOCK);
    if (device->file < 0)
        fail(device, message, "cannot be opened");
    else if (start(device, width, height, message))
        return device;
    device_close(device);
    return NULL;
}

void device_close(struct device *device)
{
    int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;

    if (!device)
        return;
    if (device->streams)
        request(device->file, VIDIOC_STREAMOFF, &type);
    for (int i = 0; i < device->buffer_count; i++)
        v4l2_munmap(device->buffers[i].bytes, device->buffers[i].size);
    if (device->file >= 0)
        v4l2_close(device->file);
    free(device);
}

/* The next whole frame, in a buffer that is to be given back. */
static bool next_frame(struct device *device, struct v4l2_buffer *buffer, char *message)
{
    for (int broken = 0; broken < BROKEN_FRAMES_MAX;) {
        struct pollfd wait = {.fd = device->file, .events = POLLIN};
        int ready = poll(&wait, 1, FRAME_WAIT_MS);
        if (ready == 0) {
            snprintf(message, MESSAGE_SIZE, "--device: %s gave no frame within %d s", device->name,
                     FRAME_WAIT_MS / 1000);
            return false;
        }
        if (ready < 0 && errno != EINTR)
            return fail(device, message, "fails");
        *buffer =
            (struct v4l2_buffer){.type = V4L2_BUF_TYPE_VIDEO_CAPTURE, .memory = V4L2_MEMORY_MMAP};
        if (request(device->file, VIDIOC_DQBUF, buffer) < 0) {
            if (errno != EAGAIN && errno != EIO)
                return fail(device, message, "gives no more frames");
            broken++;
            continue;
        }
        if ((int)buffer->index < device->buffer_count && !(buffer->flags & V4L2_BUF_FLAG_ERROR) &&
            buffer->bytesused >= (unsigned int)device->stride * (unsigned int)device->height &&
            buffer->bytesused <= device->buffers[buffer->index].size)
            return true;
        broken++;
        if (request(device->file, VIDIOC_QBUF, buffer) < 0)
            return fail(device, message, "gives no more frames");
    }
    snprintf(message, MESSAGE_SIZE, "--device: %s gave %d broken frames one after the other",
             device->name, BROKEN_FRAMES_MAX);
    return false;
}

static bool give_back(struct device *device, struct v4l2_buffer *buffer, char *message)
{
    return request(device->file, VIDIOC_QBUF, buffer) >= 0 ||
           fail(device, message, "gives no more frames");
}

/* The mean of its numbers, 0 to 255. */
static double mean_of(const struct device *device, const struct v4l2_buffer *buffer)
{
    const unsigned char *bytes = device->buffers[buffer->index].bytes;
    double sum = 0;

    for (int j = 0; j < device->height; j++) {
        for (int i = 0; i < 3 * device->width; i++)
            sum += bytes[(size_t)j * (size_t)device->stride + (size_t)i];
    }
    return sum / (3.0 * device->width * device->height);
}

static bool set_control(const struct device *device, unsigned int id, int value)
{
    struct v4l2_control control = {.id = id, .value = value};

    return request(device->file, VIDIOC_S_CTRL, &control) >= 0;
}

bool device_settle(struct device *device, bool *held, char *message)
{
    double last = -1;
    int alike = 0;

    for (int frame = 0; alike < SETTLED_FRAMES; frame++) {
        struct v4l2_buffer buffer;
        double mean;
        if (frame == SETTLE_FRAMES_MAX) {
            snprintf(message, MESSAGE_SIZE,
                     "--device: the light in the frames of %s does not settle within %d frames; "
                     "allowed: changes of less than %g %%",
                     device->name, SETTLE_FRAMES_MAX, 100 * settled_part);
            return false;
        }
        if (!next_frame(device, &buffer, message))
            return false;
        mean = mean_of(device, &buffer);
        alike = fabs(mean - last) <= settled_part * fmax(mean, 1) ? alike + 1 : 0;
        last = mean;
        if (!give_back(device, &buffer, message))
            return false;
    }
    *held = set_control(device, V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_MANUAL);
    set_control(device, V4L2_CID_AUTOGAIN, 0);
    set_control(device, V4L2_CID_AUTO_WHITE_BALANCE, 0);
    return true;
}

/* Top row first in the frame. */
static void add_frame(const struct device *device, const struct v4l2_buffer *buffer, int shots,
                      struct photo *photo)
{
    for (int j = 0; j < photo->height; j++) {
        const unsigned char *at = device->buffers[buffer->index].bytes +
                                  (size_t)(photo->height - 1 - j) * (size_t)device->stride;
        float *row = photo->light + (size_t)j * (size_t)photo->width;
        for (int i = 0; i < photo->width; i++, at += 3)
            row[i] += (float)((device->light[at[0]] + device->light[at[1]] + device->light[at[2]]) /
                              (3 * shots));
    }
}

bool device_take(struct device *device, int skipped, int shots, struct photo *photo, char *message)
{
    if (!photo_create(photo, device->width, device->height, message))
        return false;
    for (int frame = 0; frame < skipped + shots; frame++) {
        struct v4l2_buffer buffer;
        if (!next_frame(device, &buffer, message)) {
            photo_free(photo);
            return false;
        }
        if (frame >= skipped)
            add_frame(device, &buffer, shots, photo);
        if (!give_back(device, &buffer, message)) {
            photo_free(photo);
            return false;
        }
    }
    return true;
}
