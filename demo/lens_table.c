/* Lens tables: a measured lens as lines of text. */
#include "lens_table.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "option_values.h"
#include "short_path.h"

/* The table as far as it was read. */
struct reading {
    const char *path;
    int line;         /* 1 is the first */
    char before[256]; /* the table's line before, without blanks */
    struct cupola_lens *lens;
    int count;
    char *message;
};

static bool refuse(const struct reading *reading, const char *text, const char *allowed)
{
    snprintf(reading->message, MESSAGE_SIZE, "%s:%d: '%s' is not allowed; allowed: %s",
             short_path(reading->path).text, reading->line, text, allowed);
    return false;
}

/* Takes blanks and the line's end away, in place. */
static void drop_blanks(char *line)
{
    char *to = line;

    for (const char *from = line; *from; from++)
        if (!strchr(" \t\r\n", *from))
            *to++ = *from;
    *to = 0;
}

static bool check_order(const struct reading *reading, const char *text,
                        const struct cupola_lens_sample *sample)
{
    const struct cupola_lens_sample *before;
    char both[sizeof reading->before + 300];

    if (reading->count == 0) {
        if ((sample->angle_rad > 0) == (sample->radius > 0))
            return true;
        return refuse(reading, text, "in the first line 0,0, or both numbers above 0");
    }
    before = &reading->lens->table[reading->count - 1];
    if (sample->angle_rad > before->angle_rad && sample->radius > before->radius)
        return true;
    snprintf(both, sizeof both, "%s' after '%s", text, reading->before);
    return refuse(reading, both, "angles and radii that grow from line to line");
}

static bool take_line(struct reading *reading, const char *text)
{
    char part[64];
    const char *comma = strchr(text, ',');
    double angle_deg;
    struct cupola_lens_sample sample;

    if (reading->count == CUPOLA_LENS_TABLE_MAX)
        return refuse(reading, text, "2 to 64 lines angle_deg,radius");
    if (!comma || (size_t)(comma - text) >= sizeof part)
        return refuse(reading, text, "angle_deg,radius, two numbers");
    memcpy(part, text, (size_t)(comma - text));
    part[comma - text] = 0;
    if (!parse_number(part, &angle_deg) || !parse_number(comma + 1, &sample.radius))
        return refuse(reading, text, "angle_deg,radius, two numbers");
    if (!(angle_deg >= 0 && angle_deg <= 180 && sample.radius >= 0))
        return refuse(reading, text, "an angle of 0 to 180 and a radius of at least 0");
    sample.angle_rad = angle_rad(part);
    if (!check_order(reading, text, &sample))
        return false;
    reading->lens->table[reading->count++] = sample;
    snprintf(reading->before, sizeof reading->before, "%s", text);
    return true;
}

static bool take_lines(struct reading *reading, FILE *file)
{
    char line[sizeof reading->before];

    while (fgets(line, sizeof line, file)) {
        size_t length = strlen(line);
        reading->line++;
        if ((length == 0 || line[length - 1] != '\n') && !feof(file)) {
            snprintf(line + 20, sizeof line - 20, "...");
            drop_blanks(line);
            return refuse(reading, line, "angle_deg,radius in at most 250 bytes, none of them 0");
        }
        drop_blanks(line);
        if (!*line || *line == '#' || (reading->count == 0 && !strcmp(line, "angle_deg,radius")))
            continue;
        if (!take_line(reading, line))
            return false;
    }
    return true;
}

/* False with the reason in errno or, where that is 0, in the message. */
static bool take_file(struct reading *reading, FILE *file)
{
    struct stat status;

    if (fstat(fileno(file), &status) == 0 && S_ISDIR(status.st_mode)) {
        errno = EISDIR;
        return false;
    }
    errno = 0;
    if (!take_lines(reading, file)) {
        errno = 0;
        return false;
    }
    if (ferror(file))
        return false;
    if (reading->count >= 2)
        return true;
    errno = 0;
    if (reading->line == 0)
        snprintf(reading->message, MESSAGE_SIZE,
                 "%s: is empty; allowed: 2 to 64 lines angle_deg,radius",
                 short_path(reading->path).text);
    else
        snprintf(reading->message, MESSAGE_SIZE,
                 "%s:%d: the table ends here with %d line%s; allowed: 2 to 64 lines "
                 "angle_deg,radius",
                 short_path(reading->path).text, reading->line, reading->count,
                 reading->count == 1 ? "" : "s");
    return false;
}

bool lens_table_read(const char *path, struct cupola_lens *lens, char *message)
{
    struct reading reading = {.path = path, .lens = lens, .message = message};
    FILE *file = fopen(path, "r");
    bool taken = file && take_file(&reading, file);

    if (!taken && (!file || errno))
        snprintf(message, MESSAGE_SIZE, "%s: %s; allowed: a file of lines angle_deg,radius",
                 short_path(path).text, strerror(errno));
    if (file)
        fclose(file);
    if (taken)
        lens->table_count = reading.count;
    return taken;
}
