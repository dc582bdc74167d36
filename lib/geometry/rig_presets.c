/* Rigs by name. */
#include <stdio.h>
#include <string.h>

#include "angle.h"
#include "cupola/rig.h"
#include "error.h"

/* The maker published the image's size, the opening and the lens (f-theta); that projector and
 * viewer stand at the centre is assumed, and so are radius and cap. */
static void make_visionstation(struct cupola_rig *rig)
{
    rig->screen = (struct cupola_screen){.radius_m = 0.75, .cap_rad = pi / 2};
    rig->outputs[0].width_px = 1024;
    rig->outputs[0].height_px = 768;
    rig->outputs[0].circle = (struct cupola_circle){512, 384, 512};
}

/* A format of pictures and not a theatre: it sets no limit to the screen. */
static void make_domemaster(struct cupola_rig *rig)
{
    rig->tilt_rad = pi / 2;
}

/* Likewise: a kind of projector. */
static void make_truncated_16x10(struct cupola_rig *rig)
{
    rig->outputs[0].width_px = 1920;
    rig->outputs[0].height_px = 1200;
    rig->outputs[0].circle = (struct cupola_circle){960, 600, 960};
}

static const struct {
    const char *name;
    void (*make)(struct cupola_rig *rig);
} presets[] = {
    {"visionstation", make_visionstation},
    {"domemaster", make_domemaster},
    {"truncated-16x10", make_truncated_16x10},
};

enum { PRESET_COUNT = sizeof presets / sizeof presets[0] };

const char *cupola_rig_preset_name(int index)
{
    return index >= 0 && index < PRESET_COUNT ? presets[index].name : NULL;
}

int cupola_rig_preset(const char *name, struct cupola_rig *rig, struct cupola_error *error)
{
    char allowed[256] = "";
    for (int i = 0; i < PRESET_COUNT; i++) {
        if (name && strcmp(name, presets[i].name) == 0) {
            struct cupola_rig made = {.output_count = 1};
            presets[i].make(&made);
            return cupola_rig_complete(&made, rig, error);
        }
        size_t length = strlen(allowed);
        snprintf(allowed + length, sizeof allowed - length, "%s%s", i ? ", " : "", presets[i].name);
    }
    return error_set(error, CUPOLA_ERROR_ARGUMENT, "preset is '%s'; allowed: %s",
                     name ? name : "(NULL)", allowed);
}
