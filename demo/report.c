/* The resolution of a plan as JSON: --report. */
#include "report.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cupola/resolution.h>

#include "options.h"
#include "output_file.h"
#include "short_path.h"

/* What was measured: all outputs together, then each. */
struct measured {
    const cupola_plan *plan;
    struct cupola_resolution all;
    struct cupola_resolution outputs[CUPOLA_OUTPUTS_MAX];
};

static bool measure(const cupola_plan *plan, struct measured *measured, char *message)
{
    int outputs = cupola_dome_rig(cupola_plan_dome(plan))->output_count;
    struct cupola_error error = {0};
    int status = cupola_resolution_measure(plan, -1, &measured->all, &error);

    measured->plan = plan;
    measured->outputs[0] = measured->all;
    for (int i = 0; i < outputs && outputs > 1 && status >= 0; i++)
        status = cupola_resolution_measure(plan, i, &measured->outputs[i], &error);
    if (status < 0)
        snprintf(message, MESSAGE_SIZE, "--report: %s", error.message);
    return status >= 0;
}

static void write_spread(FILE *file, const char *key, const struct cupola_spread *spread)
{
    fprintf(file, "\"%s\": {\"min\": %.6g, \"median\": %.6g, \"max\": %.6g}", key, spread->min,
            spread->median, spread->max);
}

/* Yaw and pitch as for --label. */
static void write_place(FILE *file, const char *key, const struct cupola_resolution_place *place,
                        double pixels_per_degree)
{
    static const double degrees = 180 / 3.14159265358979323846;
    const double *d = place->direction;
    double yaw_deg = d[0] == 0 && d[2] == 0 ? 0 : degrees * atan2(-d[0], -d[2]);

    /* 0 is added so that none is -0. */
    fprintf(file,
            "      \"%s\": {\"pixels_per_deg\": %.6g, \"x_px\": %.6g, \"y_px\": %.6g, "
            "\"yaw_deg\": %.6g, \"pitch_deg\": %.6g},\n",
            key, pixels_per_degree, place->pixel_px[0], place->pixel_px[1], yaw_deg + 0,
            degrees * atan2(d[1], hypot(d[0], d[2])) + 0);
}

static void write_seen_view(FILE *file, int index, const struct cupola_view_resolution *view)
{
    fprintf(file, "%s\n        {\"view\": %d, \"lit_px\": %.6g,\n         ", index ? "," : "",
            index, view->pixels);
    write_spread(file, "texels_per_px_by_area", &view->texels_per_pixel);
    fputs(",\n         ", file);
    write_spread(file, "texels_per_px_along_least", &view->least_texels_per_pixel);
    fputs(",\n         ", file);
    write_spread(file, "texels_per_px_along_most", &view->most_texels_per_pixel);
    fputs("}", file);
}

static void write_output(FILE *file, int index, const struct measured *measured)
{
    const struct cupola_resolution *resolution = &measured->outputs[index];
    const struct cupola_output *output =
        &cupola_dome_rig(cupola_plan_dome(measured->plan))->outputs[index];

    fprintf(file,
            "%s\n    {\n      \"output\": %d,\n      \"width_px\": %d,\n      \"height_px\": %d,\n"
            "      \"lit_px\": %.10g,\n      ",
            index ? "," : "", index, output->width_px, output->height_px, resolution->pixels);
    write_spread(file, "pixels_per_deg", &resolution->pixels_per_degree);
    fputs(",\n", file);
    write_place(file, "coarsest", &resolution->coarsest, resolution->pixels_per_degree.min);
    write_place(file, "finest", &resolution->finest, resolution->pixels_per_degree.max);
    fputs("      \"views\": [", file);
    for (int v = 0; v < resolution->views; v++)
        write_seen_view(file, v, &resolution->view[v]);
    fprintf(file, "\n      ],\n      \"advice\": \"%s\"\n    }", resolution->advice);
}

static void write_never_sampled(FILE *file, double texels, double never)
{
    fprintf(file,
            "\"texels\": %.10g, \"texels_never_sampled\": %.10g, \"share_never_sampled\": %.6g",
            texels, never, texels > 0 ? never / texels : 0);
}

static void write_view(FILE *file, int index, const struct measured *measured)
{
    const struct cupola_view *view = cupola_plan_view(measured->plan, index);
    const struct cupola_view_resolution *resolution = &measured->all.view[index];

    fprintf(file, "%s\n    {\"view\": %d, \"width_texels\": %d, \"height_texels\": %d,\n     ",
            index ? "," : "", index, view->rect.width, view->rect.height);
    write_never_sampled(file, resolution->texels, resolution->texels_never_sampled);
    fputs("}", file);
}

static void write_object(FILE *file, const struct measured *measured)
{
    const struct cupola_rig *rig = cupola_dome_rig(cupola_plan_dome(measured->plan));

    fprintf(file, "{\n  \"advice\": \"%s\",\n  \"eye_m\": [%.6g, %.6g, %.6g],\n  ",
            measured->all.advice, rig->eye_m[0] + 0, rig->eye_m[1] + 0, rig->eye_m[2] + 0);
    write_never_sampled(file, measured->all.texels, measured->all.texels_never_sampled);
    fputs(",\n  \"outputs\": [", file);
    for (int i = 0; i < rig->output_count; i++)
        write_output(file, i, measured);
    fputs("\n  ],\n  \"views\": [", file);
    for (int v = 0; v < measured->all.views; v++)
        write_view(file, v, measured);
    fputs("\n  ]\n}\n", file);
}

/* Closes and moves it to its name; errno says what is wrong. */
static bool keep(FILE *file, const char *temporary, const char *path)
{
    bool failed = ferror(file) != 0;
    failed |= fclose(file) != 0;
    if (!failed && rename(temporary, path) == 0)
        return true;
    int problem = errno;
    unlink(temporary);
    errno = problem;
    return false;
}

static bool write_whole(const char *name, const struct measured *measured)
{
    char *path = output_file_behind_links(name);
    size_t size = path ? strlen(path) + 32 : 0;
    char *temporary = path ? malloc(size) : NULL;
    FILE *file = NULL;
    bool written = false;

    if (temporary) {
        snprintf(temporary, size, "%s.%ld.tmp", path, (long)getpid());
        file = fopen(temporary, "wx");
    }
    if (file) {
        write_object(file, measured);
        written = keep(file, temporary, path);
    }
    free(temporary);
    free(path);
    return written;
}

bool report_write(const char *path, const cupola_plan *plan, char *message)
{
    struct measured *measured = malloc(sizeof *measured);
    bool written = false;

    if (!measured) {
        snprintf(message, MESSAGE_SIZE, "--report: out of memory");
        return false;
    }
    if (measure(plan, measured, message)) {
        if (strcmp(path, "-") == 0) {
            write_object(stdout, measured);
            written = fflush(stdout) == 0 && !ferror(stdout);
        } else {
            written = write_whole(path, measured);
        }
        if (!written)
            snprintf(message, MESSAGE_SIZE, "--report: %s cannot be written: %s",
                     short_path(path).text, strerror(errno));
    }
    free(measured);
    return written;
}
