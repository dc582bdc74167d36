/* The keys of rig files. */
#include "rig_keys.h"

#include <float.h>
#include <string.h>

#include "cupola/rig.h"

#define SECTION(keys)                                                                              \
    {                                                                                              \
        keys, sizeof keys / sizeof keys[0]                                                         \
    }
#define ANY_NUMBER           .low = -DBL_MAX, .high = DBL_MAX
#define ABOVE_0_UP_TO(bound) .low = 0, .low_is_open = true, .high = (bound)
#define FROM_1E_6_TO(bound)  .low = 1e-6, .high = (bound)

static const struct rig_key screen_keys[] = {
    {"radius_m", "1e-6 to 1000", RIG_REAL, offsetof(struct cupola_screen, radius_m),
     FROM_1E_6_TO(1000), .comment = "of the sphere"},
    {"cap_deg", "above 0 and up to 180", RIG_ANGLE, offsetof(struct cupola_screen, cap_rad),
     ABOVE_0_UP_TO(180), .comment = "half-angle of the screen round the dome's axis"},
};
static const struct rig_section section_screen = SECTION(screen_keys);

static const struct rig_key circle_keys[] = {
    {"center_px", "[x, y], each from -1e7 to 1e7", RIG_REALS,
     offsetof(struct cupola_circle, center_x_px), -1e7, 1e7, .least = 2, .most = 2,
     .comment = "from the lower left corner"},
    {"radius_px", "1e-6 to 1e6", RIG_REAL, offsetof(struct cupola_circle, radius_px),
     FROM_1E_6_TO(1e6)},
};
static const struct rig_section section_circle = SECTION(circle_keys);

static const struct rig_key aim_keys[] = {
    {"yaw_deg", "-360 to 360", RIG_ANGLE, offsetof(struct cupola_aim, yaw_rad), -360, 360,
     .comment = "to the left"},
    {"pitch_deg", "-360 to 360", RIG_ANGLE, offsetof(struct cupola_aim, pitch_rad), -360, 360,
     .comment = "up"},
    {"roll_deg", "-360 to 360", RIG_ANGLE, offsetof(struct cupola_aim, roll_rad), -360, 360,
     .comment = "counter-clockwise"},
};
static const struct rig_section section_aim = SECTION(aim_keys);

static const struct rig_key sample_keys[] = {
    {"angle_deg", "0 to 180, increasing", RIG_ANGLE, offsetof(struct cupola_lens_sample, angle_rad),
     0, 180, .required = true},
    {"radius", "a number from 0, increasing", RIG_REAL, offsetof(struct cupola_lens_sample, radius),
     0, DBL_MAX, .required = true},
};
const struct rig_section rig_section_lens_sample = SECTION(sample_keys);

static const struct rig_key lens_keys[] = {
    {"model", "angular, hemispheric, equisolid, stereographic, polynomial, table", RIG_MODEL,
     offsetof(struct cupola_lens, model)},
    {"fov_deg", "above 0 and up to 360", RIG_ANGLE, offsetof(struct cupola_lens, fov_rad),
     ABOVE_0_UP_TO(360), .comment = "full opening"},
    {"k", "1 to 4 numbers [k1, k3, k5, k7]", RIG_REALS, offsetof(struct cupola_lens, k), ANY_NUMBER,
     .least = 1, .most = 4, .comment = "r ~ k1 a + k3 a^3 + ..., a in radians"},
    {"table", "a list of 2 to 64 groups ({ angle_deg = ...; radius = ...; }, ...)", RIG_GROUPS,
     offsetof(struct cupola_lens, table), .least = 2, .most = CUPOLA_LENS_TABLE_MAX,
     .section = &rig_section_lens_sample, .stride = sizeof(struct cupola_lens_sample),
     .count_offset = offsetof(struct cupola_lens, table_count)},
};
const struct rig_section rig_section_lens = SECTION(lens_keys);

/* The size comes first: the image circle's defaults follow it. */
static const struct rig_key output_keys[] = {
    {"size_px", "[width, height], whole numbers from 1 to 32768", RIG_SIZE, 0, 1, 32768, .least = 2,
     .most = 2},
    {"circle", "a group { center_px = [x, y]; radius_px = ...; }", RIG_GROUP,
     offsetof(struct cupola_output, circle), .section = &section_circle,
     .comment = "where the lens lands in the frame buffer"},
    {"flip", "\"none\", \"x\", \"y\", \"xy\"", RIG_FLIP, offsetof(struct cupola_output, flip)},
    {"lens", "a group { model = ...; fov_deg = ...; }", RIG_GROUP,
     offsetof(struct cupola_output, lens), .section = &rig_section_lens},
    {"position_m", "[x, y, z], inside of the screen sphere", RIG_REALS,
     offsetof(struct cupola_output, position_m), ANY_NUMBER, .least = 3, .most = 3,
     .comment = "+X right, +Y up, -Z along the dome's axis"},
    {"aim", "a group { yaw_deg = ...; pitch_deg = ...; roll_deg = ...; }", RIG_GROUP,
     offsetof(struct cupola_output, aim), .section = &section_aim},
};
const struct rig_section rig_section_output = SECTION(output_keys);

/* The preset comes before all that it gives defaults to. */
static const struct rig_key rig_keys[] = {
    {"format", "1", RIG_FORMAT, 0, 1, 1},
    {"preset", "visionstation, domemaster, truncated-16x10", RIG_PRESET, 0},
    {"screen", "a group { radius_m = ...; cap_deg = ...; }", RIG_GROUP,
     offsetof(struct cupola_rig, screen), .section = &section_screen},
    {"eye_m", "[x, y, z], inside of the screen sphere", RIG_REALS,
     offsetof(struct cupola_rig, eye_m), ANY_NUMBER, .least = 3, .most = 3,
     .comment = "+X right, +Y up, -Z along the dome's axis"},
    {"tilt_deg", "-180 to 180", RIG_ANGLE, offsetof(struct cupola_rig, tilt_rad), -180, 180,
     .comment = "of the dome's axis above the camera's forward direction"},
    {"units_per_metre", "above 0 and up to 1e9", RIG_REAL,
     offsetof(struct cupola_rig, units_per_metre), ABOVE_0_UP_TO(1e9), .comment = "scene units"},
    {"outputs", "a list of 1 to 8 groups ({ size_px = ...; ... }, ...)", RIG_GROUPS,
     offsetof(struct cupola_rig, outputs), .least = 1, .most = CUPOLA_OUTPUTS_MAX,
     .section = &rig_section_output, .stride = sizeof(struct cupola_output),
     .count_offset = offsetof(struct cupola_rig, output_count)},
};
const struct rig_section rig_section_rig = SECTION(rig_keys);

static const char *const flip_names[] = {"none", "x", "y", "xy"};

const char *rig_flip_name(int flip)
{
    return flip >= 0 && flip < 4 ? flip_names[flip] : NULL;
}

int rig_flip_find(const char *name)
{
    for (int flip = 0; flip < 4; flip++)
        if (strcmp(name, flip_names[flip]) == 0)
            return flip;
    return -1;
}
