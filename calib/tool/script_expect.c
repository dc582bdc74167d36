/* Expectations: every name that a script may ask for, and what stands there. */
#include "tool/script_expect.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tool/history.h"
#include "tool/marks_walk.h"

static const char *answer_name(int answer)
{
    return answer == 0 ? "no" : answer == 1 ? "yes" : NULL;
}

/* What stands behind a name that is a word, and all the words that it may be. */
struct word {
    const char *name;
    int there;
    const char *(*name_of)(int index);
};

static bool word_of(const struct tool *tool, const char *name, struct word *word)
{
    const struct word words[] = {
        {"pattern", (int)tool->pattern, tool_pattern_name},
        {"group", (int)tool->group, tool_group_word},
        {"about", (int)tool->about, tool_about_name},
        {"preview", (int)tool->preview, tool_preview_name},
        {"unsaved", tool->unsaved, answer_name},
        {"before", tool->shows_before, answer_name},
        {"help", tool->shows_help, answer_name},
        {"legend", tool->shows_legend, answer_name},
        {"labels", tool->shows_labels, answer_name},
        {"text_on_dome", tool->text_on_dome, answer_name},
        {"wants_picture", tool->wants_picture, answer_name},
        {"ends", tool->ends, answer_name},
    };

    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        *word = words[i];
        if (strcmp(word->name, name) == 0)
            return true;
    }
    return false;
}

static bool expect_word(const struct tool *tool, const struct word *word, const char *text,
                        char *message)
{
    const struct value_context context = {word->name, message};
    int expected;

    /* As the legend has it. */
    if (word->name_of == tool_group_word && strcmp(tool_group_name(tool->group), text) == 0)
        return true;
    if (!value_name(&context, text, word->name_of, &expected))
        return false;
    if (expected == word->there)
        return true;
    snprintf(message, MESSAGE_SIZE, "expected %s %s; there is %s", word->name, text,
             word->name_of(word->there));
    return false;
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
    if (!parameter_word(parameter, 0))
        return expect_number(words[0], there, expected, tolerance, message);
    if (there == expected)
        return true;
    snprintf(message, MESSAGE_SIZE, "expected %s %s; there is %s", words[0], words[1],
             parameter_word(parameter, (int)there));
    return false;
}

static bool expect_other(const struct tool *tool, char *const *words, char *message)
{
    double count, expected;
    struct word word;

    if (word_of(tool, words[0], &word))
        return expect_word(tool, &word, words[1], message);
    if (!count_of(tool, words[0], &count)) {
        snprintf(
            message, MESSAGE_SIZE,
            "expect: '%.200s' is not allowed; allowed: a value (cupola-calib --help), warning, "
            "notice, pattern, group, about, preview, marks, marks_steered, undo, redo, "
            "unsaved, before, help, legend, labels, text_on_dome, wants_picture, ends",
            words[0]);
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
