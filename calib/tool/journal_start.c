/* Printing and reading the start of a journal. */
#include "tool/journal_start.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char version_line[] = "cupola-calib journal 1";

static void add(struct journal_text *text, double number)
{
    journal_text_add(text, "%.17g", number);
}

static void add_all(struct journal_text *text, const double *numbers, int count)
{
    for (int i = 0; i < count; i++)
        add(text, numbers[i]);
}

static void print_rig(const struct tool *tool, struct journal_text *text)
{
    const struct cupola_rig *rig = &tool->rig;

    journal_text_add(text, "rig %d", tool->output);
    add(text, rig->screen.radius_m);
    add(text, rig->screen.cap_rad);
    add_all(text, rig->eye_m, 3);
    add(text, rig->tilt_rad);
    add(text, rig->units_per_metre);
    journal_text_add(text, "%d", rig->output_count);
}

static void print_output(const struct cupola_output *output, struct journal_text *text)
{
    journal_text_add(text, "projector %d %d %d %d %d", output->width_px, output->height_px,
                     output->flip, (int)output->lens.model, output->lens.table_count);
    add(text, output->circle.center_x_px);
    add(text, output->circle.center_y_px);
    add(text, output->circle.radius_px);
    add(text, output->lens.fov_rad);
    add_all(text, output->lens.k, 4);
    add_all(text, output->position_m, 3);
    add(text, output->aim.yaw_rad);
    add(text, output->aim.pitch_rad);
    add(text, output->aim.roll_rad);
}

static void print_mark(const struct mark *mark, struct journal_text *text)
{
    journal_text_add(text, "place %d", (int)mark->steered);
    add_all(text, mark->place, 3);
    add_all(text, mark->pixel_px, 2);
    journal_text_add_name(text, mark->name);
}

bool journal_start_line(const struct tool *tool, int index, struct journal_text *text)
{
    struct values values;

    *text = (struct journal_text){0};
    if (index == 0)
        journal_text_add(text, "%s", version_line);
    else if (index == 1)
        print_rig(tool, text);
    if (index < 2)
        return true;
    index -= 2;
    for (int i = 0; i < tool->rig.output_count; i++) {
        const struct cupola_lens *lens = &tool->rig.outputs[i].lens;
        if (index-- == 0) {
            print_output(&tool->rig.outputs[i], text);
            return true;
        }
        if (index < lens->table_count) {
            journal_text_add(text, "sample %.17g %.17g", lens->table[index].angle_rad,
                             lens->table[index].radius);
            return true;
        }
        index -= lens->table_count;
    }
    if (index-- == 0) {
        journal_text_add(text, "marks %d %d", (int)tool->marks.kind, tool->marks.count);
        if (tool->marks_path)
            journal_text_add_name(text, tool->marks_path);
        return true;
    }
    if (index < tool->marks.count) {
        print_mark(&tool->marks.list[index], text);
        return true;
    }
    values_take(tool, &values);
    if (index == tool->marks.count) {
        journal_text_add(text, "begin");
        add_all(text, values.raw, PARAMETER_COUNT);
        return true;
    }
    return false;
}

static bool near(double a, double b)
{
    return fabs(a - b) <= 1e-9 * (1 + fabs(a));
}

/* Word by word; numbers by what they are. */
static bool same_line(char *a, char *b)
{
    char *mine, *other;

    for (;;) {
        double values[2];
        mine = journal_word(&a);
        other = journal_word(&b);
        if (!mine || !other)
            return mine == other;
        if (strcmp(mine, other) != 0 &&
            (!parse_number(mine, &values[0]) || !parse_number(other, &values[1]) ||
             !near(values[0], values[1])))
            return false;
    }
}

bool journal_start_same_rig(const struct tool *a, const struct tool *b)
{
    /* Lines are the rig's until the first of the marks. */
    static const char end[] = "marks ";
    struct journal_text mine, other;

    for (int i = 0;; i++) {
        if (!journal_start_line(a, i, &mine) || !journal_start_line(b, i, &other))
            return false;
        if (strncmp(mine.text, end, strlen(end)) == 0)
            return strncmp(other.text, end, strlen(end)) == 0;
        if (!same_line(mine.text, other.text))
            return false;
    }
}

bool journal_start_same_marks(const struct marks *a, const struct marks *b)
{
    struct journal_text mine, other;

    if (a->kind != b->kind || a->count != b->count)
        return false;
    for (int i = 0; i < a->count; i++) {
        mine = other = (struct journal_text){0};
        print_mark(&a->list[i], &mine);
        print_mark(&b->list[i], &other);
        if (!same_line(mine.text, other.text))
            return false;
    }
    return true;
}

static bool take_rig(struct journal_start *start, char **at)
{
    struct cupola_rig *rig = &start->rig;
    double n[7];

    if (!journal_integer(at, 0, CUPOLA_OUTPUTS_MAX - 1, &start->output) ||
        !journal_numbers(at, 7, n) ||
        !journal_integer(at, start->output + 1, CUPOLA_OUTPUTS_MAX, &rig->output_count))
        return false;
    rig->screen = (struct cupola_screen){n[0], n[1]};
    memcpy(rig->eye_m, n + 2, sizeof rig->eye_m);
    rig->tilt_rad = n[5];
    rig->units_per_metre = n[6];
    return true;
}

static bool take_output(struct journal_start *start, char **at)
{
    struct cupola_output *output = &start->rig.outputs[start->outputs];
    int model;
    double n[14];

    if (start->outputs == start->rig.output_count ||
        !journal_integer(at, 1, 32768, &output->width_px) ||
        !journal_integer(at, 1, 32768, &output->height_px) ||
        !journal_integer(at, 0, 3, &output->flip) ||
        !journal_integer(at, 0, CUPOLA_LENS_TABLE, &model) ||
        !journal_integer(at, 0, CUPOLA_LENS_TABLE_MAX, &output->lens.table_count) ||
        !journal_numbers(at, 14, n))
        return false;
    output->lens.model = (enum cupola_lens_model)model;
    output->circle = (struct cupola_circle){n[0], n[1], n[2]};
    output->lens.fov_rad = n[3];
    memcpy(output->lens.k, n + 4, sizeof output->lens.k);
    memcpy(output->position_m, n + 8, sizeof output->position_m);
    output->aim = (struct cupola_aim){n[11], n[12], n[13]};
    start->outputs++;
    start->samples = 0;
    return true;
}

static bool samples_are_there(const struct journal_start *start)
{
    return start->outputs == 0 ||
           start->samples == start->rig.outputs[start->outputs - 1].lens.table_count;
}

static bool take_sample(struct journal_start *start, char **at)
{
    double n[2];

    if (start->outputs == 0 || samples_are_there(start) || !journal_numbers(at, 2, n))
        return false;
    start->rig.outputs[start->outputs - 1].lens.table[start->samples++] =
        (struct cupola_lens_sample){n[0], n[1]};
    return true;
}

static bool take_marks(struct journal_start *start, char **at)
{
    int kind;
    char *path;

    if (start->marks.list || !journal_integer(at, 0, MARKS_POINTS, &kind) ||
        !journal_integer(at, 0, MARKS_MAX, &start->marks.count))
        return false;
    start->marks.kind = (enum marks_kind)kind;
    start->marks.list = calloc((size_t)start->marks.count + 1, sizeof *start->marks.list);
    path = journal_word(at);
    if (path) {
        free(start->marks_path);
        start->marks_path = journal_name_decode(path) ? strdup(path) : NULL;
    }
    return start->marks.list && (start->marks_path || (!path && start->marks.count == 0));
}

static bool take_place(struct journal_start *start, char **at)
{
    struct mark *mark;
    double n[5];
    int steered;
    char *name;

    if (start->places == start->marks.count || !journal_integer(at, 0, 1, &steered) ||
        !journal_numbers(at, 5, n))
        return false;
    mark = &start->marks.list[start->places++];
    mark->steered = steered;
    memcpy(mark->place, n, sizeof mark->place);
    memcpy(mark->pixel_px, n + 3, sizeof mark->pixel_px);
    name = journal_word(at);
    if (!name)
        return true;
    if (!journal_name_decode(name) || strlen(name) > MARK_NAME_MAX)
        return false;
    strcpy(mark->name, name);
    return true;
}

static bool take_begin(struct journal_start *start, char **at)
{
    if (!start->marks.list || start->places < start->marks.count ||
        !journal_numbers(at, PARAMETER_COUNT, start->values.raw) ||
        cupola_rig_complete(&start->rig, NULL, NULL) < 0)
        return false;
    start->done = true;
    return true;
}

bool journal_start_take(struct journal_start *start, char *text)
{
    char *at = text, *word;
    bool taken = false;

    if (start->line++ == 0)
        return strcmp(text, version_line) == 0;
    word = journal_word(&at);
    if (!word)
        return false;
    if (start->line == 2)
        taken = strcmp(word, "rig") == 0 && take_rig(start, &at);
    else if (strcmp(word, "sample") == 0)
        taken = take_sample(start, &at);
    else if (strcmp(word, "projector") == 0)
        taken = samples_are_there(start) && take_output(start, &at);
    else if (start->outputs < start->rig.output_count || !samples_are_there(start))
        return false;
    else if (strcmp(word, "marks") == 0)
        taken = take_marks(start, &at);
    else if (strcmp(word, "place") == 0)
        taken = start->marks.list && take_place(start, &at);
    else if (strcmp(word, "begin") == 0)
        taken = take_begin(start, &at);
    return taken && !journal_word(&at);
}

void journal_start_free(struct journal_start *start)
{
    marks_free(&start->marks);
    free(start->marks_path);
    start->marks_path = NULL;
}
