/* Rig files as a whole: bytes to and from the disk, libconfig for the structure. */
#include "cupola/rig_file.h"

#include <errno.h>
#include <libconfig.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "atomic_file.h"
#include "c_locale.h"
#include "error.h"
#include "input_file.h"
#include "rig_read.h"
#include "rig_text.h"
#include "rig_write.h"

/* The largest rig takes some 40 KiB without comments. libconfig looks through all keys of a group
 * for each new one, so a file of a megabyte might keep it busy for seconds. */
enum { FILE_SIZE_MAX = 256 * 1024 };

/* Gives each number and string of the tree its text. Trees are at most as deep as rig_text_open
 * allows. */
static int attach_values(config_setting_t *setting, struct rig_text *text)
{
    if (config_setting_is_number(setting)) {
        const char *value = rig_text_next_value(text);
        config_setting_set_hook(setting, (void *)(uintptr_t)value);
        return value ? 0 : -1;
    }
    if (!config_setting_is_aggregate(setting))
        return 0;
    for (int i = 0; i < config_setting_length(setting); i++)
        if (attach_values(config_setting_get_elem(setting, (unsigned)i), text) != 0)
            return -1;
    return 0;
}

static int explain(const config_t *config, const char *text, const char *name,
                   struct cupola_error *error)
{
    char excerpt[RIG_EXCERPT_SIZE];
    const char *problem = config_error_text(config);
    int line = rig_text_excerpt(text, config_error_line(config), excerpt);
    if (strcmp(problem, "duplicate setting name") == 0)
        return error_set(error, CUPOLA_ERROR_SYNTAX,
                         "%s:%d: key given twice at '%s'; allowed: each key once", name, line,
                         excerpt);
    if (strcmp(problem, "mismatched element type in array") == 0)
        return error_set(error, CUPOLA_ERROR_SYNTAX,
                         "%s:%d: array of different things at '%s'; allowed: [number, ...]", name,
                         line, excerpt);
    return error_set(error, CUPOLA_ERROR_SYNTAX,
                     "%s:%d: %s at '%s'; allowed: KEY = VALUE; with groups in { }, arrays in [ ], "
                     "lists in ( )",
                     name, line, problem, excerpt);
}

static int parse(const char *text, const char *name, const struct cupola_rig *base,
                 struct cupola_rig *rig, struct cupola_error *error)
{
    struct rig_text opened;
    config_t config;
    int status = rig_text_open(text, name, &opened, error);
    if (status != CUPOLA_OK)
        return status;
    config_init(&config);
    if (!config_read_string(&config, opened.structure))
        status = explain(&config, text, name, error);
    else if (attach_values(config_root_setting(&config), &opened) != 0 ||
             rig_text_next_value(&opened))
        status = error_set(error, CUPOLA_ERROR_SYNTAX,
                           "%s: a value stands where none may; allowed: KEY = VALUE;", name);
    else
        status = rig_read(config_root_setting(&config), name, base, rig, error);
    config_destroy(&config);
    rig_text_close(&opened);
    return status;
}

int cupola_rig_parse(const char *text, const char *name, const struct cupola_rig *base,
                     struct cupola_rig *rig, struct cupola_error *error)
{
    struct c_locale locale;
    if (!name)
        name = "rig";
    if (!text || !rig)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s: %s is NULL; allowed: a pointer", name,
                         text ? "rig" : "text");
    if (strlen(text) > FILE_SIZE_MAX)
        return error_set(error, CUPOLA_ERROR_SYNTAX, "%s: too long; allowed: up to %d bytes", name,
                         (int)FILE_SIZE_MAX);
    if (c_locale_enter(&locale) != 0)
        return error_set(error, CUPOLA_ERROR_MEMORY, "%s: out of memory", name);
    int status = parse(text, name, base, rig, error);
    c_locale_leave(&locale);
    return status;
}

static int line_of(const char *text, size_t place)
{
    int line = 1;
    for (size_t i = 0; i < place; i++)
        line += text[i] == '\n';
    return line;
}

int cupola_rig_read(const char *path, const struct cupola_rig *base, struct cupola_rig *rig,
                    struct cupola_error *error)
{
    FILE *file;
    uint64_t size;
    int status = input_file_open(path, &file, &size, error);
    if (status != CUPOLA_OK)
        return status;
    /* One byte more than allowed, so that a file that grew meanwhile is noticed, too. */
    char *text = malloc(FILE_SIZE_MAX + 2);
    size_t length = text ? fread(text, 1, FILE_SIZE_MAX + 1, file) : 0;
    int failed = ferror(file);
    fclose(file);
    if (!text)
        return error_set(error, CUPOLA_ERROR_MEMORY, "%s: out of memory", path);
    text[length] = 0;
    if (failed)
        status = error_set(error, CUPOLA_ERROR_FILE, "%s: cannot be read", path);
    else if (length <= FILE_SIZE_MAX && strlen(text) < length)
        status = error_set(error, CUPOLA_ERROR_SYNTAX, "%s:%d: byte 0; allowed: text", path,
                           line_of(text, strlen(text)));
    else
        status = cupola_rig_parse(text, path, base, rig, error);
    free(text);
    return status;
}

/* The text in memory first: nothing that fails there touches the disk. */
static int print(const char *path, const struct cupola_rig *rig, char **text, size_t *size,
                 struct cupola_error *error)
{
    struct c_locale locale;
    FILE *stream = open_memstream(text, size);
    if (!stream)
        return error_set(error, CUPOLA_ERROR_MEMORY, "%s: out of memory", path);
    int failed = c_locale_enter(&locale);
    if (!failed) {
        rig_write(stream, rig);
        c_locale_leave(&locale);
        failed = ferror(stream);
    }
    if (fclose(stream) == 0 && !failed)
        return CUPOLA_OK;
    free(*text);
    return error_set(error, CUPOLA_ERROR_MEMORY, "%s: out of memory", path);
}

int cupola_rig_write(const char *path, const struct cupola_rig *rig, struct cupola_error *error)
{
    struct cupola_rig complete;
    struct atomic_file file;
    char *text = NULL;
    size_t size = 0;
    if (!path || !*path)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "file name is empty; allowed: a path");
    int status = cupola_rig_complete(rig, &complete, error);
    if (status != CUPOLA_OK) {
        error_context(error, "%s", path);
        return status;
    }
    status = print(path, &complete, &text, &size, error);
    if (status != CUPOLA_OK)
        return status;
    status = atomic_file_begin(&file, path, error);
    if (status == CUPOLA_OK) {
        status = atomic_file_add(&file, text, size, error);
        if (status == CUPOLA_OK)
            status = atomic_file_commit(&file, true, error);
        else
            atomic_file_abort(&file);
    }
    free(text);
    return status;
}
