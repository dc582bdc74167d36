/* From a rig to the text of a rig file, key by key. */
#include "rig_write.h"

#include <stdbool.h>
#include <string.h>

#include "rig_keys.h"
#include "rig_number.h"

enum { INDENT = 4, LINE_SIZE = 256 };

static void write_section(FILE *stream, const struct rig_section *section, const void *base,
                          int depth);

static void print_reals(const struct rig_key *key, const void *value, char *text)
{
    char number[RIG_NUMBER_SIZE];
    double real;
    strcpy(text, "[");
    for (int i = 0; i < key->most; i++) {
        memcpy(&real, (const char *)value + (size_t)i * sizeof real, sizeof real);
        rig_number_print_real(real, number);
        strcat(strcat(text, i ? ", " : ""), number);
    }
    strcat(text, "]");
}

static void print_value(const struct rig_key *key, const void *value, char text[LINE_SIZE])
{
    const struct cupola_output *output = value;
    int number;
    switch (key->kind) {
    case RIG_FORMAT:
        strcpy(text, "1");
        return;
    case RIG_REAL:
        rig_number_print_real(*(const double *)value, text);
        return;
    case RIG_REALS:
        print_reals(key, value, text);
        return;
    case RIG_ANGLE:
        rig_number_print_angle(*(const double *)value, text);
        return;
    case RIG_SIZE:
        snprintf(text, LINE_SIZE, "[%d, %d]", output->width_px, output->height_px);
        return;
    case RIG_FLIP:
        memcpy(&number, value, sizeof number);
        snprintf(text, LINE_SIZE, "\"%s\"", rig_flip_name(number));
        return;
    case RIG_MODEL:
        snprintf(text, LINE_SIZE, "\"%s\"",
                 cupola_lens_model_name((int)*(const enum cupola_lens_model *)value));
        return;
    case RIG_PRESET:
    case RIG_GROUP:
    case RIG_GROUPS:
        break;
    }
    text[0] = 0;
}

/* Samples of a lens stand on a line each: there may be many. */
static void write_sample(FILE *stream, const void *sample, int depth, const char *separator)
{
    char value[LINE_SIZE];
    const struct rig_section *section = &rig_section_lens_sample;
    fprintf(stream, "%*s{ ", depth * INDENT, "");
    for (int i = 0; i < section->key_count; i++) {
        print_value(&section->keys[i], (const char *)sample + section->keys[i].offset, value);
        fprintf(stream, "%s = %s; ", section->keys[i].name, value);
    }
    fprintf(stream, "}%s\n", separator);
}

static void write_groups(FILE *stream, const struct rig_key *key, const char *base, int depth)
{
    int count;
    memcpy(&count, base + key->count_offset, sizeof count);
    fprintf(stream, "%*s%s: (\n", depth * INDENT, "", key->name);
    for (int i = 0; i < count; i++) {
        const void *value = base + key->offset + (size_t)i * key->stride;
        const char *separator = i + 1 < count ? "," : "";
        if (key->section == &rig_section_lens_sample) {
            write_sample(stream, value, depth + 1, separator);
            continue;
        }
        fprintf(stream, "%*s{\n", (depth + 1) * INDENT, "");
        write_section(stream, key->section, value, depth + 2);
        fprintf(stream, "%*s}%s\n", (depth + 1) * INDENT, "", separator);
    }
    fprintf(stream, "%*s);\n", depth * INDENT, "");
}

static void write_key(FILE *stream, const struct rig_key *key, const char *base, int depth)
{
    char value[LINE_SIZE];
    const char *hash = key->comment ? "  # " : "", *comment = key->comment ? key->comment : "";
    if (key->kind == RIG_GROUPS) {
        write_groups(stream, key, base, depth);
    } else if (key->kind == RIG_GROUP) {
        fprintf(stream, "%*s%s: {%s%s\n", depth * INDENT, "", key->name, hash, comment);
        write_section(stream, key->section, base + key->offset, depth + 1);
        fprintf(stream, "%*s};\n", depth * INDENT, "");
    } else {
        print_value(key, base + key->offset, value);
        fprintf(stream, "%*s%s = %s;%s%s\n", depth * INDENT, "", key->name, value, hash, comment);
    }
}

/* What a lens's model does not use may be anything in memory and is not written. */
static bool is_used(const struct rig_section *section, const struct rig_key *key, const void *base)
{
    const struct cupola_lens *lens = base;
    if (key->kind == RIG_PRESET)
        return false;
    if (section != &rig_section_lens)
        return true;
    if (key->kind == RIG_REALS)
        return lens->model == CUPOLA_LENS_POLYNOMIAL;
    if (key->kind == RIG_GROUPS)
        return lens->model == CUPOLA_LENS_TABLE;
    return true;
}

static void write_section(FILE *stream, const struct rig_section *section, const void *base,
                          int depth)
{
    for (int i = 0; i < section->key_count; i++)
        if (is_used(section, &section->keys[i], base))
            write_key(stream, &section->keys[i], base, depth);
}

void rig_write(FILE *stream, const struct cupola_rig *rig)
{
    fprintf(stream, "# Cupola rig file. Metres, degrees and pixels, as the names of the keys say;\n"
                    "# image coordinates have their origin at the bottom left.\n\n");
    write_section(stream, &rig_section_rig, rig, 0);
}
