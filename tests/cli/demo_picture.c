/* Pictures that the demo writes, as numbers. */
#include "demo_picture.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <cupola/image_file.h>

#include "check.h"

void demo_run(struct process *process, const char *command)
{
    process_run(process, command, NULL);
    if (process->status != 0 || process->err[0]) {
        print_error("cupola-demo %s\nexit status %d: %s", command, process->status, process->err);
        fail();
    }
}

struct picture demo_run_pfm(struct process *process, const char *command)
{
    char whole[2000];
    struct picture picture = {0};
    struct cupola_error error = {0};

    snprintf(whole, sizeof whole, "--output x.pfm %s", command);
    unlink("x.pfm");
    demo_run(process, whole);
    if (cupola_pfm_read("x.pfm", &picture.rgba, &picture.width, &picture.height, &error) < 0) {
        print_error("%s\n", error.message);
        fail();
    }
    return picture;
}

const struct picture *demo_picture_of(struct process *process, const char *command)
{
    static struct picture kept;
    static const char *kept_command = "";

    if (strcmp(kept_command, command) != 0) {
        cupola_image_free(&kept.rgba);
        kept = demo_run_pfm(process, command);
        kept_command = command;
    }
    return &kept;
}

const float *picture_pixel(const struct picture *picture, int x, int y)
{
    return picture->rgba + 4 * ((size_t)y * (size_t)picture->width + (size_t)x);
}

double picture_difference(const struct picture *a, const struct picture *b)
{
    double largest = 0;

    assert_int_equal(a->width, b->width);
    assert_int_equal(a->height, b->height);
    for (size_t i = 0; i < 4 * (size_t)a->width * (size_t)a->height; i++)
        largest = fmax(largest, fabs((double)a->rgba[i] - (double)b->rgba[i]));
    return largest;
}

double picture_mean_difference(const struct picture *a, const struct picture *b, double *largest)
{
    double sum = 0, middle = 0.5 * a->width;
    int count = 0;

    assert_int_equal(a->width, b->width);
    assert_int_equal(a->height, b->height);
    *largest = 0;
    for (int j = 0; j < a->height; j++)
        for (int i = 0; i < a->width; i++) {
            if (hypot(i + 0.5 - middle, j + 0.5 - middle) > middle - 2)
                continue;
            for (int c = 0; c < 3; c++) {
                double off =
                    fabs((double)picture_pixel(a, i, j)[c] - (double)picture_pixel(b, i, j)[c]);
                *largest = fmax(*largest, off);
                sum += off;
                count++;
            }
        }
    return sum / count;
}

static bool differ(const float *a, const float *b)
{
    for (int c = 0; c < 3; c++)
        if (!(fabsf(a[c] - b[c]) <= 0.015f))
            return true;
    return false;
}

int picture_others(const struct picture *small, const struct picture *large, int left, int bottom)
{
    int count = 0;

    for (int y = 0; y < small->height; y++)
        for (int x = 0; x < small->width; x++) {
            int to_x = left + x, to_y = bottom + y;
            if (to_x < large->width && to_y < large->height)
                count += differ(picture_pixel(small, x, y), picture_pixel(large, to_x, to_y));
        }
    return count;
}
