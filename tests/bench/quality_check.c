/* Whether all that was asked for can be measured. */
#include "quality_check.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cupola/plan.h>

#include "probe.h"

struct setting quality_setting(const struct quality_options *options, int lens, int eye)
{
    struct setting setting = {
        .size_px = options->size_px,
        .lens = options->lenses[lens].model,
        .fov_rad = options->lenses[lens].fov_rad,
        .density = options->density,
        .gl = {.table = (enum cupola_table)options->table, .samples = options->samples}};

    memcpy(setting.viewer_m, options->eyes_m[eye], sizeof setting.viewer_m);
    return setting;
}

static bool check_folder(const char *folder, char *message)
{
    struct stat found;

    if (!folder ||
        (stat(folder, &found) == 0 && S_ISDIR(found.st_mode) && access(folder, W_OK | X_OK) == 0))
        return true;
    snprintf(message, MESSAGE_SIZE,
             "--pictures has '%.900s'; allowed: a folder that is there and can be written", folder);
    return false;
}

static bool check_plan(const cupola_dome *dome, double density, struct cupola_error *error)
{
    const struct cupola_plan_params wishes = {.density = density};
    cupola_plan *plan = NULL;
    bool made = cupola_plan_create(dome, &wishes, &plan, error) >= 0;

    cupola_plan_destroy(&plan);
    return made;
}

static bool check_setting(const struct quality_options *options, int lens, int eye, char *message)
{
    struct setting setting = quality_setting(options, lens, eye);
    struct cupola_error error = {0};
    char why[MESSAGE_SIZE];
    double eye_m[3];
    bool made = setting_make_dome(&setting, eye_m, why);

    if (made && !check_plan(setting.dome, options->density, &error)) {
        snprintf(why, sizeof why, "%s", error.message);
        made = false;
    } else if (made && !check_plan(setting.dome, options->trial.reference_density, &error)) {
        snprintf(why, sizeof why, "the reference: %.900s", error.message);
        made = false;
    }
    cupola_dome_destroy(&setting.dome);
    if (!made)
        snprintf(message, MESSAGE_SIZE, "%s:%g with the eye at %g/%g/%g: %.800s",
                 cupola_lens_model_name(setting.lens),
                 setting.fov_rad * 180 / 3.14159265358979323846, setting.viewer_m[0],
                 setting.viewer_m[1], setting.viewer_m[2], why);
    return made;
}

bool quality_check(const struct quality_options *options, char *message)
{
    if (!check_folder(options->trial.cut_out.folder, message))
        return false;
    for (int scene = 0; scene < options->scene_count; scene++)
        if (!probe_check(options->scenes[scene], message))
            return false;
    for (int lens = 0; lens < options->lens_count; lens++)
        for (int eye = 0; eye < options->eye_count; eye++)
            if (!check_setting(options, lens, eye, message))
                return false;
    return true;
}
