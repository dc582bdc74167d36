/* Marks as CSV files. */
#include "marks.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "csv_line.h"
#include "option_values.h"
#include "plain_text.h"
#include "short_path.h"
#include "whole_file.h"

enum { FILE_BYTES_MAX = 64 << 20 };

enum column { NAME, X_PX, Y_PX, DIR_X, DIR_Y, DIR_Z, X_M, Y_M, Z_M, COLUMNS };
static const char *const column_names[COLUMNS] = {"name",  "x_px", "y_px", "dir_x", "dir_y",
                                                  "dir_z", "x_m",  "y_m",  "z_m"};
static const double pixel_limit_px = 1e7, point_limit_m = 1000;

/* A file that is being read. */
struct reading {
    struct csv_line line;
    bool needs_pixels;
    int field_of[COLUMNS]; /* -1: not there */
    struct marks *marks;
    int room;
    int *lines; /* of the marks */
    char *message;
};

static bool has(const struct reading *reading, enum column column)
{
    return reading->field_of[column] >= 0;
}

/* "file:line: ", then whatever the format says. */
#define refuse(reading, ...) csv_line_refuse(&(reading)->line, (reading)->message, __VA_ARGS__)

static bool take_column(struct reading *reading, int field)
{
    const char *text = reading->line.fields[field];

    for (int i = 0; i < COLUMNS; i++) {
        if (strcmp(text, column_names[i]) != 0)
            continue;
        if (has(reading, (enum column)i))
            return refuse(reading, "column %s is there twice; allowed: once", column_names[i]);
        reading->field_of[i] = field;
        return true;
    }
    return refuse(reading,
                  "'%.80s' is no column; allowed: name, x_px, y_px, and dir_x, dir_y, dir_z or "
                  "x_m, y_m, z_m",
                  text);
}

static bool read_header(struct reading *reading)
{
    bool directions = false, points = false;

    for (int i = 0; i < COLUMNS; i++)
        reading->field_of[i] = -1;
    for (int i = 0; i < reading->line.count; i++) {
        if (!take_column(reading, i))
            return false;
    }
    for (int i = 0; i < 3; i++) {
        directions |= has(reading, (enum column)(DIR_X + i));
        points |= has(reading, (enum column)(X_M + i));
    }
    if (directions && points)
        return refuse(reading, "has columns of directions (dir_x ...) and of points (x_m ...); "
                               "allowed: one kind in a file");
    reading->marks->kind = points ? MARKS_POINTS : MARKS_DIRECTIONS;
    for (int i = 0; i < COLUMNS; i++) {
        bool pixel = i == X_PX || i == Y_PX;
        bool other = points ? i >= DIR_X && i <= DIR_Z : i >= X_M;
        if (has(reading, (enum column)i) || other || (pixel && !reading->needs_pixels))
            continue;
        return refuse(reading,
                      "column %s is missing; allowed: name, x_px, y_px, and dir_x, "
                      "dir_y, dir_z or x_m, y_m, z_m",
                      column_names[i]);
    }
    if (has(reading, X_PX) != has(reading, Y_PX))
        return refuse(reading, "one of x_px and y_px is missing; allowed: both or neither");
    return true;
}

static bool take_number(struct reading *reading, enum column column, double limit, double *number)
{
    const char *text = reading->line.fields[reading->field_of[column]];

    if (parse_number(text, number) && fabs(*number) <= limit)
        return true;
    if (limit == HUGE_VAL)
        return refuse(reading, "%s: '%.80s' is not allowed; allowed: a number",
                      column_names[column], text);
    return refuse(reading, "%s: '%.80s' is not allowed; allowed: a number, %g to %g",
                  column_names[column], text, -limit, limit);
}

static bool take_name(struct reading *reading, struct mark *mark)
{
    const char *text = reading->line.fields[reading->field_of[NAME]];
    size_t length = strlen(text);

    if (length == 0 || length > MARK_NAME_MAX || !plain_text_is(text))
        return refuse(reading,
                      "name: '%.80s' is not allowed; allowed: 1 to %d bytes of UTF-8 without "
                      "control characters",
                      text, MARK_NAME_MAX);
    memcpy(mark->name, text, length + 1);
    return true;
}

static bool take_pixel(struct reading *reading, struct mark *mark)
{
    bool empty[2];

    if (!has(reading, X_PX))
        return true;
    for (int i = 0; i < 2; i++)
        empty[i] = !reading->line.fields[reading->field_of[X_PX + i]][0];
    if (empty[0] && empty[1] && !reading->needs_pixels)
        return true;
    for (int i = 0; i < 2; i++) {
        if (!take_number(reading, (enum column)(X_PX + i), pixel_limit_px, &mark->pixel_px[i]))
            return false;
    }
    mark->steered = true;
    return true;
}

/* What has unit length to rounding stays to the last bit. */
static bool normalise(double v[3])
{
    double largest = fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
    double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);

    if (!(largest > 0))
        return false;
    if (fabs(length - 1) <= 1e-14)
        return true;
    for (int i = 0; i < 3; i++)
        v[i] /= largest;
    length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int i = 0; i < 3; i++)
        v[i] /= length;
    return true;
}

static bool take_place(struct reading *reading, struct mark *mark)
{
    bool points = reading->marks->kind == MARKS_POINTS;

    for (int i = 0; i < 3; i++) {
        if (!take_number(reading, (enum column)((points ? X_M : DIR_X) + i),
                         points ? point_limit_m : HUGE_VAL, &mark->place[i]))
            return false;
    }
    if (!points && !normalise(mark->place))
        return refuse(reading, "dir_x, dir_y, dir_z: '0, 0, 0' is not allowed; allowed: a "
                               "direction, of any length above 0");
    return true;
}

static bool make_room(struct reading *reading)
{
    struct marks *marks = reading->marks;

    if (marks->count < reading->room)
        return true;
    if (marks->count >= MARKS_MAX)
        return refuse(reading, "is one mark too many; allowed: up to %d", MARKS_MAX);
    int room = reading->room ? 2 * reading->room : 64;
    room = room < MARKS_MAX ? room : MARKS_MAX;
    struct mark *list = realloc(marks->list, (size_t)room * sizeof *list);
    if (list)
        marks->list = list;
    int *lines = list ? realloc(reading->lines, (size_t)room * sizeof *lines) : NULL;
    if (lines)
        reading->lines = lines;
    if (!list || !lines)
        return refuse(reading, "out of memory for %d marks", room);
    reading->room = room;
    return true;
}

static bool read_row(struct reading *reading, int columns)
{
    struct mark mark = {0};

    if (reading->line.count != columns)
        return refuse(reading, "has %d fields; allowed: %d, as the header", reading->line.count,
                      columns);
    if (!make_room(reading) || !take_name(reading, &mark) || !take_pixel(reading, &mark) ||
        !take_place(reading, &mark))
        return false;
    reading->lines[reading->marks->count] = reading->line.number;
    reading->marks->list[reading->marks->count++] = mark;
    return true;
}

struct named_line {
    const char *name;
    int line;
};

static int compare_names(const void *a, const void *b)
{
    const struct named_line *first = a, *second = b;
    int order = strcmp(first->name, second->name);

    return order ? order : (first->line > second->line) - (first->line < second->line);
}

static bool names_differ(struct reading *reading)
{
    const struct marks *marks = reading->marks;
    struct named_line *sorted = malloc((size_t)marks->count * sizeof *sorted);
    bool differ = true;

    if (!sorted)
        return refuse(reading, "out of memory for %d names", marks->count);
    for (int i = 0; i < marks->count; i++)
        sorted[i] = (struct named_line){marks->list[i].name, reading->lines[i]};
    qsort(sorted, (size_t)marks->count, sizeof *sorted, compare_names);
    for (int i = 1; i < marks->count && differ; i++) {
        differ = strcmp(sorted[i - 1].name, sorted[i].name) != 0;
        if (differ)
            continue;
        reading->line.number = sorted[i].line;
        refuse(reading, "name: '%s' is that of line %d, too; allowed: a name of its own",
               sorted[i].name, sorted[i - 1].line);
    }
    free(sorted);
    return differ;
}

static bool read_all(struct reading *reading)
{
    int columns = 0;
    enum csv_next next;

    while ((next = csv_line_next(&reading->line, reading->message)) == CSV_LINE) {
        if (!(columns ? read_row(reading, columns) : read_header(reading)))
            return false;
        if (!columns)
            columns = reading->line.count;
    }
    if (next == CSV_REFUSED)
        return false;
    if (!columns)
        return refuse(reading, "there is no header; allowed: name, x_px, y_px, and dir_x, dir_y, "
                               "dir_z or x_m, y_m, z_m");
    if (reading->marks->count == 0)
        return refuse(reading, "there are no marks below the header; allowed: 1 to %d", MARKS_MAX);
    return names_differ(reading);
}

bool marks_read(const char *path, bool needs_pixels, struct marks *marks, char *message)
{
    struct reading reading = {.needs_pixels = needs_pixels, .marks = marks, .message = message};
    size_t size;
    char *text = whole_file_read(path, FILE_BYTES_MAX, &size, message);
    bool read;

    *marks = (struct marks){0};
    if (!text)
        return false;
    csv_line_begin(&reading.line, path, text, size);
    read = read_all(&reading);
    free(reading.lines);
    free(text);
    if (!read)
        marks_free(marks);
    return read;
}

static void write_name(FILE *file, const char *name)
{
    bool plain = !strpbrk(name, ",\"") && name[0] != '#' && name[0] != ' ' &&
                 name[strlen(name) - 1] != ' ' && (unsigned char)name[0] != 0xef;

    if (!plain)
        fputc('"', file);
    for (const char *at = name; *at; at++)
        fprintf(file, *at == '"' ? "\"\"" : "%c", *at);
    if (!plain)
        fputc('"', file);
}

bool marks_settle(struct whole_file *file, const char *path, const struct marks *marks,
                  char *message)
{
    bool points = marks->kind == MARKS_POINTS;

    if (!whole_file_begin(file, path, message))
        return false;
    fprintf(file->stream, "name,x_px,y_px,%s\n", points ? "x_m,y_m,z_m" : "dir_x,dir_y,dir_z");
    for (int i = 0; i < marks->count; i++) {
        const struct mark *mark = &marks->list[i];
        write_name(file->stream, mark->name);
        if (mark->steered)
            fprintf(file->stream, ",%.17g,%.17g", mark->pixel_px[0], mark->pixel_px[1]);
        else
            fputs(",,", file->stream);
        fprintf(file->stream, ",%.17g,%.17g,%.17g\n", mark->place[0], mark->place[1],
                mark->place[2]);
    }
    return whole_file_settle(file, message);
}

bool marks_write(const char *path, const struct marks *marks, char *message)
{
    struct whole_file file;

    return marks_settle(&file, path, marks, message) && whole_file_end(&file, message);
}

void marks_free(struct marks *marks)
{
    free(marks->list);
    *marks = (struct marks){0};
}
