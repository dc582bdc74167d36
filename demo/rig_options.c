/* The rig that the command line asks for: options over rig file over preset. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <cupola/rig.h>
#include <cupola/rig_file.h>

#include "options.h"

static const double RADIANS = 3.14159265358979323846 / 180;
static const double PERSPECTIVE_FOV_MAX_DEG = 170;

static int usage(char *message, const char *text)
{
    snprintf(message, MESSAGE_SIZE, "%s", text);
    return STATUS_USAGE;
}

/*
 * Without a rig file and a preset: a full circle of 1024 x 1024, angular, 180 degrees, like the
 * preset domemaster, but with the dome's axis along the line of sight and no limit to the screen.
 */
static int start(const struct options *options, struct cupola_rig *rig, struct cupola_error *error)
{
    int status;

    *rig = (struct cupola_rig){0};
    status = options->preset ? cupola_rig_preset(options->preset, rig, error)
                             : cupola_rig_complete(rig, rig, error);
    if (status == CUPOLA_OK && options->rig)
        status = cupola_rig_read(options->rig, rig, rig, error);
    return status;
}

static int set_lens(const struct options *options, struct cupola_lens *lens, char *message)
{
    int model = options->lens;

    if (model < 0 && options->lens_table)
        model = CUPOLA_LENS_TABLE;
    if (model >= 0 && model != (int)lens->model)
        *lens =
            (struct cupola_lens){.model = (enum cupola_lens_model)model, .fov_rad = lens->fov_rad};
    if (options->lens_k.given) {
        if (lens->model != CUPOLA_LENS_POLYNOMIAL)
            return usage(message, "--lens-k belongs to --lens polynomial only");
        memcpy(lens->k, options->lens_k.value, sizeof lens->k);
    }
    if (options->lens_table) {
        if (!lens_table_read(options->lens_table, lens, message))
            return STATUS_FAILED;
        lens->fov_rad = 0; /* as far as the table reaches */
    }
    if (options->fov_deg.given)
        lens->fov_rad = options->fov_deg.value[0] * RADIANS;
    if (lens->model == CUPOLA_LENS_TABLE && lens->table_count == 0)
        return usage(message, "--lens table needs --lens-table FILE.csv");
    if (lens->model == CUPOLA_LENS_POLYNOMIAL && !lens->k[0] && !lens->k[1] && !lens->k[2] &&
        !lens->k[3])
        return usage(message, "--lens polynomial needs --lens-k K1,K3,K5,K7, not all zero");
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
    if (options->aim_deg.given)
        output->aim = (struct cupola_aim){options->aim_deg.value[0] * RADIANS,
                                          options->aim_deg.value[1] * RADIANS,
                                          options->aim_deg.value[2] * RADIANS};
    return status;
}

static void set_theatre(const struct options *options, struct cupola_rig *rig)
{
    if (options->tilt_deg.given)
        rig->tilt_rad = options->tilt_deg.value[0] * RADIANS;
    if (options->cap_deg.given)
        rig->screen.cap_rad = options->cap_deg.value[0] * RADIANS;
    if (options->radius_m.given)
        rig->screen.radius_m = options->radius_m.value[0];
    if (options->viewer_m.given)
        memcpy(rig->eye_m, options->viewer_m.value, sizeof rig->eye_m);
}

int options_rig(const struct options *options, struct cupola_rig *rig, char *message)
{
    int status;
    double fov_deg;
    struct cupola_error error = {0};
    struct cupola_rig wished;

    if (start(options, &wished, &error) < 0)
        goto fail;
    if ((status = set_lens(options, &wished.outputs[0].lens, message)) != STATUS_OK)
        return status;
    if (set_output(options, &wished.outputs[0], &error) < 0)
        goto fail;
    set_theatre(options, &wished);
    if (cupola_rig_complete(&wished, &wished, &error) < 0)
        goto fail;
    fov_deg = wished.outputs[0].lens.fov_rad / RADIANS;
    if (options->mode == SHOW_PERSPECTIVE && fov_deg > PERSPECTIVE_FOV_MAX_DEG + 1e-9) {
        snprintf(message, MESSAGE_SIZE,
                 "--perspective: a fov of %g degrees is not allowed; allowed: up to %g (--fov DEG)",
                 fov_deg, PERSPECTIVE_FOV_MAX_DEG);
        return STATUS_USAGE;
    }
    *rig = wished;
    return STATUS_OK;

fail:
    snprintf(message, MESSAGE_SIZE, "%s", error.message);
    return STATUS_FAILED;
}
