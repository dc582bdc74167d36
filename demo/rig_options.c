/* The rig that the command line asks for: options over rig file over preset. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <cupola/rig.h>
#include <cupola/rig_file.h>

#include "lens_table.h"
#include "options.h"

static const double DEGREES = 180 / 3.14159265358979323846;
static const double PERSPECTIVE_FOV_MAX_DEG = 170;

static int usage(char *message, const char *text)
{
    snprintf(message, MESSAGE_SIZE, "%s", text);
    return STATUS_USAGE;
}

static int failed(char *message, const char *option, const struct cupola_error *error)
{
    snprintf(message, MESSAGE_SIZE, "%s%s%s", option, *option ? ": " : "", error->message);
    return STATUS_FAILED;
}

int options_output(const struct options *options)
{
    return options->show_output >= 0 ? options->show_output : 0;
}

/*
 * Without a rig file and a preset: a full circle of 1024 x 1024, angular, 180 degrees, like the
 * preset domemaster, but with the dome's axis along the line of sight.
 */
static int start(const struct options *options, struct cupola_rig *rig, char *message)
{
    struct cupola_error error = {0};
    int status;

    *rig = (struct cupola_rig){0};
    status = options->preset ? cupola_rig_preset(options->preset, rig, &error)
                             : cupola_rig_complete(rig, rig, &error);
    if (status == CUPOLA_OK && options->rig)
        status = cupola_rig_read(options->rig, rig, rig, &error);
    if (status != CUPOLA_OK)
        return failed(message, "", &error);
    if (options_output(options) >= rig->output_count) {
        snprintf(message, MESSAGE_SIZE,
                 "--show-output: %d is not allowed; allowed: 0 to %d, the rig has %d output%s",
                 options->show_output, rig->output_count - 1, rig->output_count,
                 rig->output_count == 1 ? "" : "s");
        return STATUS_USAGE;
    }
    return STATUS_OK;
}

/* `table` is what --lens-table holds. */
static void set_lens(const struct options *options, const struct cupola_lens *table,
                     struct cupola_lens *lens)
{
    int model = options->lens;

    if (model < 0 && options->lens_table)
        model = CUPOLA_LENS_TABLE;
    if (model < 0 && options->lens_k.given)
        model = CUPOLA_LENS_POLYNOMIAL;
    if (model >= 0 && model != (int)lens->model)
        *lens =
            (struct cupola_lens){.model = (enum cupola_lens_model)model, .fov_rad = lens->fov_rad};
    if (options->lens_k.given)
        memcpy(lens->k, options->lens_k.value, sizeof lens->k);
    if (options->lens_table) {
        lens->table_count = table->table_count;
        memcpy(lens->table, table->table, sizeof lens->table);
        lens->fov_rad = 0; /* as far as the table reaches */
    }
    if (options->fov_rad.given)
        lens->fov_rad = options->fov_rad.value[0];
}

static int check_lens(const struct options *options, const struct cupola_lens *lens, char *message)
{
    bool all_zero = !lens->k[0] && !lens->k[1] && !lens->k[2] && !lens->k[3];

    if (lens->model == CUPOLA_LENS_TABLE && lens->table_count == 0)
        return usage(message, "--lens table needs --lens-table FILE.csv");
    if (lens->model == CUPOLA_LENS_POLYNOMIAL && all_zero)
        return usage(message, options->lens_k.given
                                  ? "--lens-k: all numbers are 0; allowed: at least one other"
                                  : "--lens polynomial needs --lens-k K1,K3,K5,K7, 1 to 4 of them");
    return STATUS_OK;
}

static int set_output(const struct options *options, struct cupola_output *output,
                      struct cupola_error *error)
{
    int status = CUPOLA_OK;

    if (options->width_px > 0 && options->circle_px.given) {
        output->width_px = options->width_px;
        output->height_px = options->height_px;
    } else if (options->width_px > 0) {
        status = cupola_output_resize(output, options->width_px, options->height_px, error);
    }
    if (options->circle_px.given) {
        output->circle.center_x_px = options->circle_px.value[0];
        output->circle.center_y_px = options->circle_px.value[1];
        output->circle.radius_px = options->circle_px.value[2];
    }
    if (options->flip >= 0)
        output->flip = options->flip;
    if (options->projector_m.given)
        memcpy(output->position_m, options->projector_m.value, sizeof output->position_m);
    if (options->aim_rad.given)
        output->aim = (struct cupola_aim){options->aim_rad.value[0], options->aim_rad.value[1],
                                          options->aim_rad.value[2]};
    return status;
}

static void set_theatre(const struct options *options, struct cupola_rig *rig)
{
    if (options->tilt_rad.given)
        rig->tilt_rad = options->tilt_rad.value[0];
    if (options->cap_rad.given)
        rig->screen.cap_rad = options->cap_rad.value[0];
    if (options->radius_m.given)
        rig->screen.radius_m = options->radius_m.value[0];
    if (options->viewer_m.given)
        memcpy(rig->eye_m, options->viewer_m.value, sizeof rig->eye_m);
}

/* The options over what preset and rig file gave. Returns a status of Cupola's. */
static int apply(const struct options *options, const struct cupola_lens *table,
                 struct cupola_rig *rig, struct cupola_error *error)
{
    struct cupola_output *output = &rig->outputs[options_output(options)];
    int status;

    set_lens(options, table, &output->lens);
    if ((status = set_output(options, output, error)) != CUPOLA_OK)
        return status;
    set_theatre(options, rig);
    return cupola_rig_complete(rig, rig, error);
}

/*
 * The option that made a rig impossible: the one without which something else or nothing is said.
 * "": it is not one alone.
 */
static const char *find_culprit(const struct options *options, const struct cupola_lens *table,
                                const struct cupola_rig *before, const struct cupola_error *error)
{
    struct options less = *options;
    struct {
        const char *name;
        bool *given;
    } const suspects[] = {
        {"--viewer", &less.viewer_m.given},  {"--projector", &less.projector_m.given},
        {"--radius", &less.radius_m.given},  {"--cap", &less.cap_rad.given},
        {"--tilt", &less.tilt_rad.given},    {"--projector-aim", &less.aim_rad.given},
        {"--circle", &less.circle_px.given}, {"--fov", &less.fov_rad.given},
        {"--lens-k", &less.lens_k.given},
    };

    for (size_t i = 0; i < sizeof suspects / sizeof *suspects; i++) {
        struct cupola_rig rig = *before;
        struct cupola_error other = {0};
        if (!*suspects[i].given)
            continue;
        *suspects[i].given = false;
        apply(&less, table, &rig, &other);
        *suspects[i].given = true;
        if (strcmp(other.message, error->message) != 0)
            return suspects[i].name;
    }
    if (options->lens_table)
        return "--lens-table";
    if (options->lens >= 0)
        return "--lens";
    return options->width_px > 0 ? "--size" : "";
}

static int check_perspective(const struct options *options, const struct cupola_lens *lens,
                             char *message)
{
    double fov_deg = lens->fov_rad * DEGREES;

    if (options->mode != SHOW_PERSPECTIVE || fov_deg <= PERSPECTIVE_FOV_MAX_DEG + 1e-9)
        return STATUS_OK;
    snprintf(message, MESSAGE_SIZE,
             "--perspective: a fov of %g degrees is not allowed; allowed: up to %g (--fov DEG)",
             fov_deg, PERSPECTIVE_FOV_MAX_DEG);
    return STATUS_USAGE;
}

int options_rig(const struct options *options, struct cupola_rig *rig, char *message)
{
    int status;
    struct cupola_error error = {0};
    struct cupola_lens table = {0}, lens;
    struct cupola_rig before, wished;

    if ((status = start(options, &before, message)) != STATUS_OK)
        return status;
    if (options->lens_table && !lens_table_read(options->lens_table, &table, message))
        return STATUS_FAILED;
    lens = before.outputs[options_output(options)].lens;
    set_lens(options, &table, &lens);
    if ((status = check_lens(options, &lens, message)) != STATUS_OK)
        return status;
    wished = before;
    if (apply(options, &table, &wished, &error) != CUPOLA_OK)
        return failed(message, find_culprit(options, &table, &before, &error), &error);
    status = check_perspective(options, &wished.outputs[options_output(options)].lens, message);
    if (status == STATUS_OK)
        *rig = wished;
    return status;
}

void options_notice(const struct options *options, const struct cupola_rig *rig)
{
    bool shows_one = options->mode == SHOW_DOME || options->mode == SHOW_PERSPECTIVE ||
                     options->mode == SHOW_MAP;

    if (shows_one && rig->output_count > 1 && options->show_output < 0)
        fprintf(stderr,
                "cupola-demo: output 0 of the rig's %d is shown (give --show-output to choose)\n",
                rig->output_count);
}
