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

/* Of letters in this direction: nine pixels high, but neither tiny nor huge on the dome. */
double pattern_label_unit_rad(const cupola_dome *dome, int output, const double direction[3]);

/* All labels of the tool's pattern on the dome of the rig that is shown. */
void pattern_labels_list(const struct tool *tool, const cupola_dome *dome,
                         struct pattern_labels *labels);

#endif
