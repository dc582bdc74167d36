/* The table of values, and reading and setting one. */
#include "tool/parameters.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "solve/solve.h"
#include "tool/marks_walk.h"
#include "tool/tool.h"

/* In which unit a value is shown, and with it how it is kept. */
enum unit { UNIT_NONE, UNIT_PX, UNIT_DEG, UNIT_M, UNIT_PER_RAD };

struct parameter_info {
    const char *name;
    enum unit unit;
    int digits;      /* behind the point */
    double step;     /* 0: relative, see parameter_step */
    bool above_zero; /* 0 would mean the default to the library */
};

static const struct parameter_info infos[PARAMETER_COUNT] = {
    [PARAMETER_CIRCLE_X] = {"circle_x_px", UNIT_PX, 2, 1},
    [PARAMETER_CIRCLE_Y] = {"circle_y_px", UNIT_PX, 2, 1},
    [PARAMETER_CIRCLE_RADIUS] = {"circle_radius_px", UNIT_PX, 2, 1, true},
    [PARAMETER_FLIP] = {"flip", UNIT_NONE, 0, 1},
    [PARAMETER_LENS] = {"lens", UNIT_NONE, 0, 1},
    [PARAMETER_FOV] = {"fov_deg", UNIT_DEG, 3, 0.5, true},
    [PARAMETER_K1] = {"k1", UNIT_PER_RAD, 6, 0},
    [PARAMETER_K3] = {"k3", UNIT_PER_RAD, 6, 0},
    [PARAMETER_K5] = {"k5", UNIT_PER_RAD, 6, 0},
    [PARAMETER_K7] = {"k7", UNIT_PER_RAD, 6, 0},
    [PARAMETER_PROJECTOR_X] = {"projector_x_m", UNIT_M, 4, 0},
    [PARAMETER_PROJECTOR_Y] = {"projector_y_m", UNIT_M, 4, 0},
    [PARAMETER_PROJECTOR_Z] = {"projector_z_m", UNIT_M, 4, 0},
    [PARAMETER_YAW] = {"yaw_deg", UNIT_DEG, 3, 0.1},
    [PARAMETER_PITCH] = {"pitch_deg", UNIT_DEG, 3, 0.1},
    [PARAMETER_ROLL] = {"roll_deg", UNIT_DEG, 3, 0.1},
    [PARAMETER_SCREEN_RADIUS] = {"screen_radius_m", UNIT_M, 4, 0, true},
    [PARAMETER_CAP] = {"cap_deg", UNIT_DEG, 3, 0.5, true},
    [PARAMETER_TILT] = {"tilt_deg", UNIT_DEG, 3, 0.5},
    [PARAMETER_VIEWER_X] = {"viewer_x_m", UNIT_M, 4, 0},
    [PARAMETER_VIEWER_Y] = {"viewer_y_m", UNIT_M, 4, 0},
    [PARAMETER_VIEWER_Z] = {"viewer_z_m", UNIT_M, 4, 0},
    [PARAMETER_DOT_YAW] = {"dot_yaw_deg", UNIT_DEG, 3, 1},
    [PARAMETER_DOT_PITCH] = {"dot_pitch_deg", UNIT_DEG, 3, 1},
    [PARAMETER_DOT_SIZE] = {"dot_size_deg", UNIT_DEG, 3, 0.1, true},
    [PARAMETER_CROSS_X] = {"cross_x_px", UNIT_PX, 2, 1},
    [PARAMETER_CROSS_Y] = {"cross_y_px", UNIT_PX, 2, 1},
    [PARAMETER_MARK] = {"mark", UNIT_NONE, 0, 1},
};

/* In long double, so that 120 degrees stay 120. */
static double to_deg(double raw)
{
    return (double)((long double)raw * (180 / 3.14159265358979323846264338327950288L));
}

static double to_rad(double angle_deg)
{
    char text[40];

    /* As if it had been typed: what is saved reads 12.3, not 12.300000000000001. */
    snprintf(text, sizeof text, "%.15g", angle_deg);
    return angle_rad(text);
}

const char *parameter_name(int parameter)
{
    return parameter >= 0 && parameter < PARAMETER_COUNT ? infos[parameter].name : NULL;
}

int parameter_find(const char *name)
{
    for (int i = 0; i < PARAMETER_COUNT; i++)
        if (strcmp(infos[i].name, name) == 0)
            return i;
    return -1;
}

/* Where a value that is a double is kept; NULL for those that are whole numbers. */
static double *place(struct tool *tool, enum parameter parameter)
{
    struct cupola_rig *rig = &tool->rig;
    struct cupola_output *output = &rig->outputs[tool->output];
    double *const places[PARAMETER_COUNT] = {
        [PARAMETER_CIRCLE_X] = &output->circle.center_x_px,
        [PARAMETER_CIRCLE_Y] = &output->circle.center_y_px,
        [PARAMETER_CIRCLE_RADIUS] = &output->circle.radius_px,
        [PARAMETER_FOV] = &output->lens.fov_rad,
        [PARAMETER_K1] = &output->lens.k[0],
        [PARAMETER_K3] = &output->lens.k[1],
        [PARAMETER_K5] = &output->lens.k[2],
        [PARAMETER_K7] = &output->lens.k[3],
        [PARAMETER_PROJECTOR_X] = &output->position_m[0],
        [PARAMETER_PROJECTOR_Y] = &output->position_m[1],
        [PARAMETER_PROJECTOR_Z] = &output->position_m[2],
        [PARAMETER_YAW] = &output->aim.yaw_rad,
        [PARAMETER_PITCH] = &output->aim.pitch_rad,
        [PARAMETER_ROLL] = &output->aim.roll_rad,
        [PARAMETER_SCREEN_RADIUS] = &rig->screen.radius_m,
        [PARAMETER_CAP] = &rig->screen.cap_rad,
        [PARAMETER_TILT] = &rig->tilt_rad,
        [PARAMETER_VIEWER_X] = &rig->eye_m[0],
        [PARAMETER_VIEWER_Y] = &rig->eye_m[1],
        [PARAMETER_VIEWER_Z] = &rig->eye_m[2],
        [PARAMETER_DOT_YAW] = &tool->dot_yaw_rad,
        [PARAMETER_DOT_PITCH] = &tool->dot_pitch_rad,
        [PARAMETER_DOT_SIZE] = &tool->dot_size_rad,
        [PARAMETER_CROSS_X] = &tool->cross_px[0],
        [PARAMETER_CROSS_Y] = &tool->cross_px[1],
    };

    return places[parameter];
}

static double raw_get(const struct tool *tool, enum parameter parameter)
{
    const struct cupola_output *output = &tool->rig.outputs[tool->output];

    switch (parameter) {
    case PARAMETER_FLIP:
        return output->flip;
    case PARAMETER_LENS:
        return output->lens.model;
    case PARAMETER_MARK:
        return tool->marks.count > 0 ? tool->mark + 1 : 0;
    default:
        return *place((struct tool *)tool, parameter); /* only read */
    }
}

static void raw_set(struct tool *tool, enum parameter parameter, double raw)
{
    struct cupola_output *output = &tool->rig.outputs[tool->output];

    if (parameter == PARAMETER_FLIP)
        output->flip = (int)raw;
    else if (parameter == PARAMETER_LENS)
        output->lens.model = (enum cupola_lens_model)(int)raw;
    else if (parameter == PARAMETER_MARK)
        tool->mark = raw >= 1 ? (int)raw - 1 : 0;
    else
        *place(tool, parameter) = raw;
}

double parameter_get(const struct tool *tool, enum parameter parameter)
{
    double raw = raw_get(tool, parameter);

    return infos[parameter].unit == UNIT_DEG ? to_deg(raw) : raw;
}

double parameter_step(const struct tool *tool, enum parameter parameter)
{
    const double *k = tool->rig.outputs[tool->output].lens.k;
    double largest = 0;

    if (infos[parameter].step > 0)
        return infos[parameter].step;
    /* A centimetre in a theatre of a metre or two, ten in one of ten. */
    if (infos[parameter].unit == UNIT_M)
        return 0.01 * pow(10, round(log10(tool->rig.screen.radius_m) - 0.2));
    for (int i = 0; i < 4; i++)
        largest = fmax(largest, fabs(k[i]));
    return largest > 0 ? 1e-3 * largest : 1e-3;
}

static bool refuse(char *message, const char *name, double value, const char *allowed)
{
    snprintf(message, MESSAGE_SIZE, "%s: %g is not allowed; allowed: %s", name, value, allowed);
    return false;
}

/* The values that no rig has; raw. */
static bool check_own(const struct tool *tool, enum parameter parameter, double raw, double value,
                      char *message)
{
    const struct cupola_output *output = &tool->rig.outputs[tool->output];
    const char *name = infos[parameter].name;
    char allowed[80];

    switch (parameter) {
    case PARAMETER_DOT_YAW:
    case PARAMETER_DOT_PITCH:
        return fabs(to_deg(raw)) <= 360 || refuse(message, name, value, "-360 to 360");
    case PARAMETER_DOT_SIZE:
        return to_deg(raw) <= 90 || refuse(message, name, value, "above 0 and up to 90");
    case PARAMETER_CROSS_X:
    case PARAMETER_CROSS_Y: {
        int size_px = parameter == PARAMETER_CROSS_X ? output->width_px : output->height_px;
        snprintf(allowed, sizeof allowed, "0 to %d, within the image", size_px);
        return (raw >= 0 && raw <= size_px) || refuse(message, name, value, allowed);
    }
    case PARAMETER_MARK:
        if (tool->marks.count == 0)
            return raw == 0 || refuse(message, name, value, "none, since there are no marks");
        snprintf(allowed, sizeof allowed, "1 to %d", tool->marks.count);
        return (raw >= 1 && raw <= tool->marks.count && raw == floor(raw)) ||
               refuse(message, name, value, allowed);
    default:
        return true;
    }
}

/* What can be said of a value without the others. */
static bool check_alone(const struct tool *tool, enum parameter parameter, double raw, double value,
                        char *message)
{
    const char *name = infos[parameter].name;

    if (!isfinite(raw))
        return refuse(message, name, value, "a finite number");
    if (infos[parameter].above_zero && !(raw > 0))
        return refuse(message, name, value, "a number above 0");
    if (parameter == PARAMETER_FLIP && !(raw >= 0 && raw <= 3 && raw == floor(raw)))
        return refuse(message, name, value, "none, x, y, xy");
    if (parameter == PARAMETER_LENS && !(raw >= 0 && raw <= CUPOLA_LENS_TABLE && raw == floor(raw)))
        return refuse(message, name, value, "a lens that exists");
    return check_own(tool, parameter, raw, value, message);
}

/* Coefficients of a lens that has none would change nothing, and no rig file takes them. */
static bool check_used(const struct tool *tool, enum parameter parameter, char *message)
{
    enum cupola_lens_model model = tool->rig.outputs[tool->output].lens.model;

    if (parameter < PARAMETER_K1 || parameter > PARAMETER_K7 || model == CUPOLA_LENS_POLYNOMIAL)
        return true;
    snprintf(message, MESSAGE_SIZE,
             "%s: the lens is %s; allowed: coefficients of a polynomial one (L: next lens)",
             infos[parameter].name, cupola_lens_model_name((int)model));
    return false;
}

/* A polynomial without coefficients is none: it begins with the plainest. */
static void begin_polynomial(struct cupola_lens *lens)
{
    if (lens->model == CUPOLA_LENS_POLYNOMIAL && lens->k[0] == 0 && lens->k[1] == 0 &&
        lens->k[2] == 0 && lens->k[3] == 0)
        lens->k[0] = 1;
}

bool parameter_set(struct tool *tool, enum parameter parameter, double value)
{
    double raw = infos[parameter].unit == UNIT_DEG ? to_rad(value) : value;
    struct values before;
    struct cupola_error error = {0};

    if (!check_alone(tool, parameter, raw, value, tool->warning) ||
        !check_used(tool, parameter, tool->warning))
        return false;
    values_take(tool, &before);
    raw_set(tool, parameter, raw);
    if (parameter == PARAMETER_LENS)
        begin_polynomial(&tool->rig.outputs[tool->output].lens);
    if (parameter >= PARAMETER_RIG_COUNT || cupola_rig_complete(&tool->rig, NULL, &error) >= 0)
        return true;
    values_put(tool, &before);
    snprintf(tool->warning, MESSAGE_SIZE, "%s", error.message);
    return false;
}

const char *parameter_word(enum parameter parameter, int value)
{
    return parameter == PARAMETER_LENS   ? cupola_lens_model_name(value)
           : parameter == PARAMETER_FLIP ? solve_flip_name(value)
                                         : NULL;
}

void parameter_text(const struct tool *tool, enum parameter parameter, char *text, size_t size)
{
    static const char *const units[] = {"", " px", " degrees", " m", ""};
    const struct parameter_info *info = &infos[parameter];
    double value = parameter_get(tool, parameter);
    char mark[MARK_NAME_MAX + 1] = "";

    if (parameter == PARAMETER_MARK && tool->marks.count > 0)
        marks_walk_label(tool, tool->mark, mark);
    if (parameter_word(parameter, (int)value))
        snprintf(text, size, "%s", parameter_word(parameter, (int)value));
    else if (parameter == PARAMETER_MARK && tool->marks.count > 0)
        snprintf(text, size, "%d of %d: %s", tool->mark + 1, tool->marks.count, mark);
    else /* + 0 makes 0 of -0 */
        snprintf(text, size, "%.*f%s", info->digits,
                 (fabs(value) < parameter_tolerance(parameter) ? 0 : value) + 0.0,
                 units[info->unit]);
}

void parameter_label(enum parameter parameter, char *text, size_t size)
{
    static const char *const endings[] = {"_px", "_deg", "_m"};
    size_t length;

    snprintf(text, size, "%s", infos[parameter].name);
    length = strlen(text);
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++) {
        size_t end = strlen(endings[i]);
        if (length > end && strcmp(text + length - end, endings[i]) == 0)
            text[length -= end] = '\0';
    }
    for (char *at = text; *at; at++)
        if (*at == '_')
            *at = ' ';
}

bool parameter_parse(enum parameter parameter, const char *text, double *value, char *message)
{
    const struct value_context context = {infos[parameter].name, message};
    bool is_lens = parameter == PARAMETER_LENS;
    int word;

    if (!is_lens && parse_number(text, value))
        return true;
    if (is_lens || parameter == PARAMETER_FLIP) {
        if (!value_name(&context, text, is_lens ? cupola_lens_model_name : solve_flip_name, &word))
            return false;
        *value = word;
        return true;
    }
    snprintf(message, MESSAGE_SIZE, "%s: '%.200s' is not allowed; allowed: a number",
             infos[parameter].name, text);
    return false;
}

double parameter_tolerance(enum parameter parameter)
{
    return 0.5 * pow(10, -infos[parameter].digits);
}

void values_take(const struct tool *tool, struct values *values)
{
    for (int i = 0; i < PARAMETER_COUNT; i++)
        values->raw[i] = raw_get(tool, (enum parameter)i);
}

void values_put(struct tool *tool, const struct values *values)
{
    for (int i = 0; i < PARAMETER_COUNT; i++)
        raw_set(tool, (enum parameter)i, values->raw[i]);
}

bool values_check(const struct tool *tool, const struct values *values, char *message)
{
    struct tool trial = *tool;
    struct cupola_error error = {0};

    for (int i = 0; i < PARAMETER_COUNT; i++) {
        double shown = infos[i].unit == UNIT_DEG ? to_deg(values->raw[i]) : values->raw[i];
        if (!check_alone(tool, (enum parameter)i, values->raw[i], shown, message))
            return false;
    }
    values_put(&trial, values);
    if (cupola_rig_complete(&trial.rig, NULL, &error) >= 0)
        return true;
    snprintf(message, MESSAGE_SIZE, "%s", error.message);
    return false;
}
