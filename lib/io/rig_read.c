/* libconfig's tree, checked against the keys, becomes a rig. */
#include "rig_read.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "error.h"
#include "geometry/vector.h"
#include "rig_keys.h"
#include "rig_number.h"

enum { PATH_SIZE = 256, VALUE_SIZE = 64, NAME_SIZE = 32 };

/* What cupola_rig_complete grants, 1e-12 rad, so that all that it lets pass can be read. */
static const double angle_slack_deg = 6e-11;

struct reader {
    const char *name;
    const struct cupola_rig *rig; /* as far as it is read; the screen comes before the outputs */
    struct cupola_error *error;
};

static int read_section(const struct reader *reader, const config_setting_t *group,
                        const struct rig_section *section, void *base);

/* "outputs[0].lens.fov_deg" */
static void print_path(const config_setting_t *setting, char path[PATH_SIZE])
{
    const config_setting_t *parent = config_setting_parent(setting);
    path[0] = 0;
    if (!parent)
        return;
    print_path(parent, path);
    size_t length = strlen(path);
    const char *name = config_setting_name(setting);
    if (name)
        snprintf(path + length, PATH_SIZE - length, "%s%.60s", length ? "." : "", name);
    else
        snprintf(path + length, PATH_SIZE - length, "[%d]", config_setting_index(setting));
}

/* What rig_text_open moved out: a number, or a string with its quotes; NULL for all else. */
static const char *text_of(const config_setting_t *setting)
{
    return config_setting_type(setting) == CONFIG_TYPE_INT ? config_setting_get_hook(setting)
                                                           : NULL;
}

static bool is_number(const config_setting_t *setting)
{
    const char *text = text_of(setting);
    return text && *text != '"';
}

/* A name without its quotes; false for what is no string or too long to be a name. */
static bool name_of(const config_setting_t *setting, char name[NAME_SIZE])
{
    const char *text = text_of(setting);
    size_t length = text ? strlen(text) : 0;
    if (length < 2 || *text != '"' || length - 2 >= NAME_SIZE)
        return false;
    memcpy(name, text + 1, length - 2);
    name[length - 2] = 0;
    return true;
}

static void print_value(const config_setting_t *setting, char value[VALUE_SIZE])
{
    int count = config_setting_length(setting);
    switch (config_setting_type(setting)) {
    case CONFIG_TYPE_INT:
        snprintf(value, VALUE_SIZE, "%.40s", text_of(setting));
        for (char *c = value; *c; c++)
            *c = *c >= ' ' && *c <= '~' ? *c : '?';
        return;
    case CONFIG_TYPE_BOOL:
        snprintf(value, VALUE_SIZE, config_setting_get_bool(setting) ? "true" : "false");
        return;
    case CONFIG_TYPE_GROUP:
        snprintf(value, VALUE_SIZE, "{ ... }");
        return;
    case CONFIG_TYPE_LIST:
        snprintf(value, VALUE_SIZE, "a list of %d", count);
        return;
    default:
        snprintf(value, VALUE_SIZE, "an array of %d", count);
    }
}

/* "FILE:LINE: KEY" before a message. */
static int add_place(const struct reader *reader, const config_setting_t *setting, int status)
{
    char path[PATH_SIZE];
    print_path(setting, path);
    error_context(reader->error, "%s:%d: %s", reader->name,
                  (int)config_setting_source_line(setting), path);
    return status;
}

static int refuse(const struct reader *reader, const config_setting_t *setting, const char *allowed)
{
    char value[VALUE_SIZE];
    print_value(setting, value);
    return add_place(
        reader, setting,
        error_set(reader->error, CUPOLA_ERROR_ARGUMENT, "value %s; allowed: %s", value, allowed));
}

static int refuse_unknown(const struct reader *reader, const config_setting_t *setting,
                          const struct rig_section *section)
{
    char names[256] = "";
    for (int i = 0; i < section->key_count; i++) {
        size_t length = strlen(names);
        snprintf(names + length, sizeof names - length, "%s%s", i ? ", " : "",
                 section->keys[i].name);
    }
    return add_place(
        reader, setting,
        error_set(reader->error, CUPOLA_ERROR_ARGUMENT, "unknown key; allowed: %s", names));
}

static int refuse_missing(const struct reader *reader, const config_setting_t *group,
                          const char *name, const char *allowed)
{
    return add_place(reader, group,
                     error_set(reader->error, CUPOLA_ERROR_ARGUMENT, "%s is missing; allowed: %s",
                               name, allowed));
}

/* A number within the key's range, in the unit of the file. */
static int read_number(const struct reader *reader, const config_setting_t *setting,
                       const struct rig_key *key, double *value)
{
    if (!is_number(setting))
        return refuse(reader, setting, key->allowed);
    *value = rig_number_real(text_of(setting));
    double slack = key->kind == RIG_ANGLE ? angle_slack_deg : 0;
    bool low_enough = *value <= key->high + slack;
    bool high_enough = key->low_is_open ? *value > key->low : *value >= key->low - slack;
    return low_enough && high_enough ? CUPOLA_OK : refuse(reader, setting, key->allowed);
}

static bool is_sequence(const config_setting_t *setting, const struct rig_key *key)
{
    int type = config_setting_type(setting), count = config_setting_length(setting);
    return (type == CONFIG_TYPE_ARRAY || type == CONFIG_TYPE_LIST) && count >= key->least &&
           count <= key->most;
}

static int read_numbers(const struct reader *reader, const config_setting_t *setting,
                        const struct rig_key *key, double *values)
{
    if (!is_sequence(setting, key))
        return refuse(reader, setting, key->allowed);
    int status = CUPOLA_OK;
    for (int i = 0; i < config_setting_length(setting) && status == CUPOLA_OK; i++)
        status =
            read_number(reader, config_setting_get_elem(setting, (unsigned)i), key, &values[i]);
    return status;
}

static int read_size(const struct reader *reader, const config_setting_t *setting,
                     const struct rig_key *key, struct cupola_output *output)
{
    double size_px[2];
    int status = read_numbers(reader, setting, key, size_px);
    if (status != CUPOLA_OK)
        return status;
    for (unsigned i = 0; i < 2; i++)
        if (size_px[i] != floor(size_px[i]))
            return refuse(reader, config_setting_get_elem(setting, i), key->allowed);
    status = cupola_output_resize(output, (int)size_px[0], (int)size_px[1], reader->error);
    return status == CUPOLA_OK ? status : add_place(reader, setting, status);
}

/* A name out of a closed list; `find` answers a negative number where there is no such name. */
static int read_name(const struct reader *reader, const config_setting_t *setting,
                     const struct rig_key *key, int (*find)(const char *name), int *found)
{
    char name[NAME_SIZE];
    *found = name_of(setting, name) ? find(name) : -1;
    return *found >= 0 ? CUPOLA_OK : refuse(reader, setting, key->allowed);
}

static int read_preset(const struct reader *reader, const config_setting_t *setting,
                       const struct rig_key *key, struct cupola_rig *rig)
{
    char name[NAME_SIZE];
    if (name_of(setting, name) && cupola_rig_preset(name, rig, NULL) == CUPOLA_OK)
        return CUPOLA_OK;
    return refuse(reader, setting, key->allowed);
}

/* Samples in the order of the file, so that the line of the first wrong one is known. */
static int check_table(const struct reader *reader, const config_setting_t *table,
                       const struct cupola_lens *lens)
{
    for (int i = 0; i < lens->table_count; i++) {
        struct cupola_lens_sample zero = {0, 0}, here = lens->table[i];
        struct cupola_lens_sample before = i > 0 ? lens->table[i - 1] : zero;
        bool is_origin = i == 0 && here.angle_rad == 0 && here.radius == 0;
        if (is_origin || (here.angle_rad > before.angle_rad && here.radius > before.radius))
            continue;
        const config_setting_t *sample = config_setting_get_elem(table, (unsigned)i);
        bool angle = !(here.angle_rad > before.angle_rad);
        return refuse(reader, config_setting_get_member(sample, angle ? "angle_deg" : "radius"),
                      i > 0 ? "more than in the sample before"
                            : "above 0, or both angle_deg and radius 0");
    }
    return CUPOLA_OK;
}

static int check_lens(const struct reader *reader, const config_setting_t *group,
                      const struct cupola_lens *lens)
{
    const config_setting_t *k = config_setting_get_member(group, "k");
    const config_setting_t *table = config_setting_get_member(group, "table");
    if (!k && lens->model == CUPOLA_LENS_POLYNOMIAL)
        return refuse_missing(reader, group, "k", "[k1, k3, k5, k7]");
    if (!table && lens->model == CUPOLA_LENS_TABLE)
        return refuse_missing(reader, group, "table", "a list of samples");
    if (k && lens->model != CUPOLA_LENS_POLYNOMIAL)
        return refuse(reader, k, "only with model = \"polynomial\"");
    if (table && lens->model != CUPOLA_LENS_TABLE)
        return refuse(reader, table, "only with model = \"table\"");
    int status = table ? check_table(reader, table, lens) : CUPOLA_OK;
    if (status != CUPOLA_OK)
        return status;
    status = cupola_lens_validate(lens, reader->error);
    return status == CUPOLA_OK ? status : add_place(reader, group, status);
}

static int check_inside(const struct reader *reader, const config_setting_t *group,
                        const char *name, const double position_m[3])
{
    const config_setting_t *setting = config_setting_get_member(group, name);
    if (!setting || length3(position_m) < reader->rig->screen.radius_m)
        return CUPOLA_OK;
    return add_place(reader, setting,
                     error_set(reader->error, CUPOLA_ERROR_ARGUMENT,
                               "value [%g, %g, %g]; allowed: inside of the screen sphere, less "
                               "than %g from its centre",
                               position_m[0], position_m[1], position_m[2],
                               reader->rig->screen.radius_m));
}

/* What concerns several keys of an output; the line is that of the output. */
static int check_output(const struct reader *reader, const config_setting_t *group,
                        const struct cupola_output *output)
{
    int status = check_inside(reader, group, "position_m", output->position_m);
    if (status != CUPOLA_OK)
        return status;
    struct cupola_rig alone = {.screen = reader->rig->screen, .outputs[0] = *output};
    status = cupola_rig_complete(&alone, NULL, reader->error);
    return status == CUPOLA_OK ? status : add_place(reader, group, status);
}

static int read_group(const struct reader *reader, const config_setting_t *setting,
                      const struct rig_key *key, void *value)
{
    if (config_setting_type(setting) != CONFIG_TYPE_GROUP)
        return refuse(reader, setting, key->allowed);
    bool is_lens = key->section == &rig_section_lens;
    /* A lens is one thing: its missing keys have their defaults, whatever the preset had. */
    if (is_lens)
        *(struct cupola_lens *)value = (struct cupola_lens){0};
    int status = read_section(reader, setting, key->section, value);
    return status == CUPOLA_OK && is_lens ? check_lens(reader, setting, value) : status;
}

static struct cupola_rig default_rig(void)
{
    struct cupola_rig rig = {0};
    cupola_rig_complete(&rig, &rig, NULL);
    return rig;
}

static int read_groups(const struct reader *reader, const config_setting_t *setting,
                       const struct rig_key *key, char *base)
{
    bool are_outputs = key->section == &rig_section_output;
    int count_before, count = config_setting_length(setting), status = CUPOLA_OK;
    if (!is_sequence(setting, key))
        return refuse(reader, setting, key->allowed);
    memcpy(&count_before, base + key->count_offset, sizeof count_before);
    for (int i = 0; i < count && status == CUPOLA_OK; i++) {
        const config_setting_t *group = config_setting_get_elem(setting, (unsigned)i);
        void *value = base + key->offset + (size_t)i * key->stride;
        if (are_outputs && i >= count_before)
            *(struct cupola_output *)value = default_rig().outputs[0];
        if (config_setting_type(group) != CONFIG_TYPE_GROUP)
            return refuse(reader, group, key->allowed);
        status = read_section(reader, group, key->section, value);
        if (status == CUPOLA_OK && are_outputs)
            status = check_output(reader, group, value);
    }
    memcpy(base + key->count_offset, &count, sizeof count);
    return status;
}

static int read_key(const struct reader *reader, const config_setting_t *setting,
                    const struct rig_key *key, char *base)
{
    void *value = base + key->offset;
    double ignored;
    int found, status;
    switch (key->kind) {
    case RIG_FORMAT:
        return read_number(reader, setting, key, &ignored);
    case RIG_PRESET:
        return read_preset(reader, setting, key, (struct cupola_rig *)value);
    case RIG_REAL:
        return read_number(reader, setting, key, value);
    case RIG_REALS:
        return read_numbers(reader, setting, key, value);
    case RIG_ANGLE:
        status = read_number(reader, setting, key, &ignored);
        if (status == CUPOLA_OK)
            *(double *)value = rig_number_angle_rad(text_of(setting));
        return status;
    case RIG_SIZE:
        return read_size(reader, setting, key, value);
    case RIG_FLIP:
        return read_name(reader, setting, key, rig_flip_find, value);
    case RIG_MODEL:
        status = read_name(reader, setting, key, cupola_lens_model_find, &found);
        if (status == CUPOLA_OK)
            *(enum cupola_lens_model *)value = (enum cupola_lens_model)found;
        return status;
    case RIG_GROUP:
        return read_group(reader, setting, key, value);
    case RIG_GROUPS:
        return read_groups(reader, setting, key, base);
    }
    return CUPOLA_OK;
}

static int check_names(const struct reader *reader, const config_setting_t *group,
                       const struct rig_section *section)
{
    for (int i = 0; i < config_setting_length(group); i++) {
        const config_setting_t *setting = config_setting_get_elem(group, (unsigned)i);
        int known = 0;
        for (int k = 0; k < section->key_count; k++)
            known += strcmp(config_setting_name(setting), section->keys[k].name) == 0;
        if (!known)
            return refuse_unknown(reader, setting, section);
    }
    return CUPOLA_OK;
}

static int read_section(const struct reader *reader, const config_setting_t *group,
                        const struct rig_section *section, void *base)
{
    int status = check_names(reader, group, section);
    for (int i = 0; i < section->key_count && status == CUPOLA_OK; i++) {
        const struct rig_key *key = &section->keys[i];
        const config_setting_t *setting = config_setting_get_member(group, key->name);
        if (setting)
            status = read_key(reader, setting, key, base);
        else if (key->required)
            status = refuse_missing(reader, group, key->name, key->allowed);
    }
    return status;
}

int rig_read(const config_setting_t *root, const char *name, const struct cupola_rig *base,
             struct cupola_rig *rig, struct cupola_error *error)
{
    struct cupola_rig made = default_rig();
    if (base && cupola_rig_complete(base, &made, error) != CUPOLA_OK)
        return CUPOLA_ERROR_ARGUMENT;
    struct reader reader = {name, &made, error};
    int status = read_section(&reader, root, &rig_section_rig, &made);
    if (status == CUPOLA_OK)
        status = check_inside(&reader, root, "eye_m", made.eye_m);
    if (status != CUPOLA_OK)
        return status;
    status = cupola_rig_complete(&made, rig, error);
    if (status != CUPOLA_OK)
        error_context(error, "%s", name);
    return status;
}
