/* The projector from the marks that were steered to, as one step of history. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "solve/solve.h"
#include "tool/marks_walk.h"

/* Those with a pixel; the list is to be freed. */
static struct marks steered_marks(const struct tool *tool)
{
    struct marks steered = {.kind = tool->marks.kind};

    steered.list = malloc((size_t)(tool->marks.count + 1) * sizeof *steered.list);
    for (int i = 0; steered.list && i < tool->marks.count; i++)
        if (tool->marks.list[i].steered)
            steered.list[steered.count++] = tool->marks.list[i];
    return steered;
}

static void say_rejected(const struct marks *marks, const struct solve_result *result, char *notice)
{
    size_t used = strlen(notice);
    const char *before = "; wrong and left out: ";

    for (int i = 0; i < marks->count && used + MARK_NAME_MAX + 40 < MESSAGE_SIZE; i++) {
        if (!result->marks[i].rejected)
            continue;
        used += (size_t)snprintf(notice + used, MESSAGE_SIZE - used, "%s%s", before,
                                 marks->list[i].name);
        before = ", ";
    }
}

/* What the solver noted, as far as there is room: a lens of another model, few marks, and so on. */
static void say_notes(const struct solve_result *result, char *notice)
{
    for (int i = 0; i < result->warning_count; i++) {
        size_t used = strlen(notice);
        if (used + strlen(result->warnings[i]) + 8 < MESSAGE_SIZE)
            snprintf(notice + used, MESSAGE_SIZE - used, "; note: %s", result->warnings[i]);
    }
}

/* Takes the solved rig over. It differs from the present one in values that the tool has. */
static void take_over(struct tool *tool, const struct marks *marks,
                      const struct solve_result *result)
{
    struct values before;
    char message[MESSAGE_SIZE];

    if (cupola_rig_complete(&result->rig, NULL, NULL) < 0) {
        snprintf(tool->warning, MESSAGE_SIZE, "the marks lead to an impossible rig");
        return;
    }
    values_take(tool, &before);
    tool->rig = result->rig;
    snprintf(message, sizeof message, "solved from %d marks: residual %.2f px, worst %.2f px",
             marks->count - result->rejected, result->rms_px, result->worst_px);
    say_rejected(marks, result, message);
    say_notes(result, message);
    tool_commit(tool, &before, -1, NULL, -1);
    memcpy(tool->notice, message, sizeof message);
}

void marks_walk_solve(struct tool *tool)
{
    struct marks marks;
    struct solve_request request = {.start = &tool->rig, .output = tool->output, .marks = &marks};
    struct solve_result result;

    if (marks_walk_steered(tool) == 0) {
        snprintf(tool->warning, MESSAGE_SIZE,
                 tool->marks.count > 0 ? "no mark has a pixel yet: Enter takes the cross-hair's"
                                       : "there are no marks; give --marks FILE.csv");
        return;
    }
    marks = steered_marks(tool);
    if (!marks.list) {
        snprintf(tool->warning, MESSAGE_SIZE, "out of memory for the marks");
    } else if (solve(&request, &result, tool->warning)) {
        take_over(tool, &marks, &result);
        solve_result_free(&result);
    }
    marks_free(&marks);
}
