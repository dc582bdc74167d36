/* Expectations: every name that a script may ask for, and what stands there. */
#include "tool/script_expect.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tool/history.h"
#include "tool/marks_walk.h"

/* What stands behind a name that is a word. */
static const char *word_of(const struct tool *tool, const char *name)
{
    static const char *const answers[] = {"no", "yes"};
    const struct {
        const char *name, *word;
    } words[] = {
        {"pattern", tool_pattern_name((int)tool->pattern)},
        {"group", tool_group_name(tool->group)},
        {"about", tool_about_name((int)tool->about)},
        {"preview", tool_preview_name((int)tool->preview)},
        {"unsaved", answers[tool->unsaved]},
        {"before", answers[tool->shows_before]},
        {"help", answers[tool->shows_help]},
        {"legend", answers[tool->shows_legend]},
        {"labels", answers[tool->shows_labels]},
        {"text_on_dome", answers[tool->text_on_dome]},
        {"wants_picture", answers[tool->wants_picture]},
        {"ends", answers[tool->ends]},
    };

    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strcmp(words[i].name, name) == 0)
            return words[i].word;
    return NULL;
}

/* What stands behind a name that is a count. */
static bool count_of(const struct tool *tool, const char *name, double *count)
{
    if (strcmp(name, "marks_steered") == 0)
        *count = marks_walk_steered(tool);
    else if (strcmp(name, "marks") == 0)
        *count = tool->marks.count;
    else if (strcmp(name, "undo") == 0)
        *count = history_undo_count(tool->history);
    else if (strcmp(name, "redo") == 0)
        *count = history_redo_count(tool->history);
    else
        return false;
    return true;
}

static bool expect_text(const char *name, const char *there, int count, char *const *words,
                        char *message)
{
    if (count == 2 && strcmp(words[1], "none") == 0) {
        if (*there == '\0')
            return true;
        snprintf(message, MESSAGE_SIZE, "expected no %s; there is '%.1000s'", name, there);
        return false;
    }
    if (count != 3 || strcmp(words[1], "containing") != 0) {
        snprintf(message, MESSAGE_SIZE, "expect %s: allowed: none, or containing \"text\"", name);
        return false;
    }
    if (strstr(there, words[2]))
        return true;
    snprintf(message, MESSAGE_SIZE, "expected a %s containing '%.300s'; there is %s%.800s%s", name,
             words[2], *there ? "'" : "none", there, *there ? "'" : "");
    return false;
}

static bool expect_number(const char *name, double there, double expected, double tolerance,
                          char *message)
{
    if (fabs(there - expected) <= tolerance)
        return true;
    snprintf(message, MESSAGE_SIZE, "expected %s %.10g within %.3g; there is %.10g", name, expected,
             tolerance, there);
    return false;
}

static bool expect_parameter(const struct tool *tool, enum parameter parameter, int count,
                             char *const *words, char *message)
{
    double there = parameter_get(tool, parameter), expected;
    double tolerance = parameter_tolerance(parameter);

    if (!parameter_parse(parameter, words[1], &expected, message))
        return false;
    if (count == 4 && (!parse_number(words[3], &tolerance) || tolerance < 0)) {
        snprintf(message, MESSAGE_SIZE, "within '%.200s'; allowed: a number from 0", words[3]);
        return false;
    }
    if (parameter != PARAMETER_LENS)
        return expect_number(words[0], there, expected, tolerance, message);
    if (there == expected)
        return true;
    snprintf(message, MESSAGE_SIZE, "expected lens %s; there is %s", words[1],
             cupola_lens_model_name((int)there));
    return false;
}

static bool expect_other(const struct tool *tool, char *const *words, char *message)
{
    const char *there = word_of(tool, words[0]);
    double count, expected;

    if (there) {
        if (strcmp(there, words[1]) == 0)
            return true;
        snprintf(message, MESSAGE_SIZE, "expected %s %.200s; there is %s", words[0], words[1],
                 there);
        return false;
    }
    if (!count_of(tool, words[0], &count)) {
        snprintf(message, MESSAGE_SIZE, "'%.200s' is nothing that can be expected", words[0]);
        return false;
    }
    if (!parse_number(words[1], &expected)) {
        snprintf(message, MESSAGE_SIZE, "expect %s: '%.200s' is not allowed; allowed: a number",
                 words[0], words[1]);
        return false;
    }
    return expect_number(words[0], count, expected, 0, message);
}

bool script_expect(const struct tool *tool, int count, char *const *words, char *message)
{
    int parameter = count > 0 ? parameter_find(words[0]) : -1;

    if (count > 0 && strcmp(words[0], "warning") == 0) {
        char warnings[2 * MESSAGE_SIZE];
        tool_warnings(tool, "; ", warnings);
        return expect_text("warning", warnings, count, words, message);
    }
    if (count > 0 && strcmp(words[0], "notice") == 0)
        return expect_text("notice", tool->notice, count, words, message);
    if (count != 2 && !(parameter >= 0 && count == 4 && strcmp(words[2], "within") == 0)) {
        snprintf(message, MESSAGE_SIZE, "allowed: expect NAME VALUE [within T]");
        return false;
    }
    if (parameter >= 0)
        return expect_parameter(tool, (enum parameter)parameter, count, words, message);
    return expect_other(tool, words, message);
}
