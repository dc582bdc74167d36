/* What is told of a rig and its plan without drawing anything. */
#include "survey.h"

#include <stdio.h>

#include <cupola/rig_file.h>

#include "density_picture.h"
#include "film_output.h"
#include "report.h"

bool survey_is_wished(const struct options *options)
{
    return options->mode == SHOW_MAP || options->report;
}

bool survey_is_all(const struct options *options)
{
    return options->mode == SHOW_MAP || (options->report && !options->output && !options->headless);
}

static bool write_report(const struct options *options, const struct show_setup *setup,
                         const cupola_dome *dome, char *message)
{
    cupola_plan *plan = NULL;
    struct cupola_error error = {0};
    bool written;

    if (cupola_plan_create(dome, &setup->plan, &plan, &error) < 0) {
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
        return false;
    }
    written = report_write(options->report, plan, message);
    cupola_plan_destroy(&plan);
    return written;
}

/* The report last: what follows it on stdout is its reader's. */
static bool write_files(const struct options *options, const struct show_setup *setup,
                        const cupola_dome *dome, char *message)
{
    struct cupola_error error = {0};

    if (survey_is_all(options) && options->save_rig &&
        cupola_rig_write(options->save_rig, &setup->rig, &error) < 0) {
        snprintf(message, MESSAGE_SIZE, "--save-rig: %s", error.message);
        return false;
    }
    if (options->mode == SHOW_MAP &&
        !density_picture_write(options->output, dome, setup->output, message))
        return false;
    return !options->report || write_report(options, setup, dome, message);
}

int survey_run(const struct options *options, const struct show_setup *setup, char *message)
{
    cupola_dome *dome = NULL;
    struct cupola_error error = {0};
    int status = STATUS_OK;

    if (options->output && !film_output_check_options(options, message))
        return STATUS_USAGE;
    if (cupola_dome_create(&setup->rig, &dome, &error) < 0) {
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
        return STATUS_FAILED;
    }
    if (options->mode == SHOW_MAP)
        options_notice(options, &setup->rig);
    if (!write_files(options, setup, dome, message))
        status = STATUS_FAILED;
    cupola_dome_destroy(&dome);
    return status;
}
