/* The numbers and names that belong to a pattern. */
#ifndef PATTERN_LABELS_H
#define PATTERN_LABELS_H

#include "tool/dome_text.h"
#include "tool/tool.h"

enum { PATTERN_LABELS_MAX = 200, PATTERN_LABEL_TEXT = 80 };

/* Texts of labels point into it: not to be copied. */
struct pattern_labels {
    int count;
    struct dome_label list[PATTERN_LABELS_MAX];
    char texts[PATTERN_LABELS_MAX][PATTERN_LABEL_TEXT];
};

/* All labels of the tool's pattern; letters are `unit_rad` large. */
void pattern_labels_list(const struct tool *tool, const struct cupola_rig *rig, double unit_rad,
                         struct pattern_labels *labels);

#endif
