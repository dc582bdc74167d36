/* What is worked with in the image, so that panels over the window stay clear of it. */
#ifndef FOCUS_H
#define FOCUS_H

#include "tool/pattern_labels.h"
#include "tool/tool.h"

enum { FOCUS_MAX = 8 };

/* Boxes of pixels of the image, origin bottom left. */
struct focus {
    int count;
    struct focus_box {
        double low_px[2], high_px[2];
    } list[FOCUS_MAX];
};

/* The cross-hair with its name, the dot, labels that matter. `labels` is room for its work. */
void focus_find(const struct tool *tool, const cupola_dome *dome, struct pattern_labels *labels,
                struct focus *focus);

/* The cross-hair's name as a label that points to `name`; false where there is none. */
bool focus_cross_label(const struct tool *tool, const cupola_dome *dome,
                       char name[MARK_NAME_MAX + 1], struct dome_label *label);

#endif
