/* What can be said before anything is solved. */
#include "refusal.h"

#include <math.h>
#include <stdio.h>

#include "option_values.h"
#include "solve/arrangement.h"
#include "solve/consensus.h"

static bool refuse(char *message, const char *why)
{
    snprintf(message, MESSAGE_SIZE, "%s", why);
    return false;
}

bool refusal_enough(const struct marks *marks, const bool *rejected, int count, double near_px,
                    int values, char *message)
{
    int least = consensus_least(values);

    if (count < least) {
        snprintf(message, MESSAGE_SIZE,
                 "%d mark%s%s cannot determine %d values: each gives two numbers, and some have to "
                 "be left over to see errors; allowed: %d at least",
                 count, count == 1 ? "" : "s", rejected ? " that agree" : "", values, least);
        return false;
    }
    int places = arrangement_places(marks, rejected, near_px, least);
    if (places >= least)
        return true;
    snprintf(message, MESSAGE_SIZE,
             "%d marks%s at %d different place%s, more than a degree and %.2g px apart, cannot "
             "determine %d values, however often each was measured; allowed: %d places at least",
             count, rejected ? " that agree" : "", places, places == 1 ? "" : "s", near_px, values,
             least);
    return false;
}

/* Combinations that leave the picture as it is, wherever the marks are. */
bool refusal_combination(const struct solve_request *request, int free, char *message)
{
    const struct cupola_output *output = &request->start->outputs[request->output];
    const double *position = output->position_m;
    double off_m = hypot(hypot(position[0], position[1]), position[2]);
    bool directions = request->marks->kind == MARKS_DIRECTIONS;

    if (free & SOLVE_LENS && free & SOLVE_CIRCLE_RADIUS)
        return refuse(message, "lens and circle-radius cannot both be free: a wider lens in a "
                               "larger image circle shows the same; allowed: one of them");
    if (free & SOLVE_RADIUS && free & SOLVE_POSITION && directions)
        return refuse(message,
                      "position and radius cannot both be free: marks given as directions fix the "
                      "position only relative to the radius; allowed: one of them, or marks as "
                      "points (x_m, y_m, z_m)");
    if (free & SOLVE_RADIUS && directions && !(off_m > 1e-3 * request->start->screen.radius_m))
        return refuse(message,
                      "radius cannot be free: marks given as directions do not tell it to a "
                      "projector at the centre; allowed: a projector aside of it, or marks as "
                      "points (x_m, y_m, z_m)");
    return true;
}

static bool check_marks(const struct marks *marks, char *message)
{
    for (int i = 0; i < marks->count; i++) {
        if (marks->list[i].steered)
            continue;
        snprintf(message, MESSAGE_SIZE, "mark '%s' has no pixel; allowed: marks with x_px and y_px",
                 marks->list[i].name);
        return false;
    }
    return true;
}

bool refusal_check(const struct solve_request *request, int free, int count, double near_px,
                   char *message)
{
    struct arrangement arrangement;

    if (!refusal_combination(request, free, message) || !check_marks(request->marks, message) ||
        !refusal_enough(request->marks, NULL, request->marks->count, near_px, count, message))
        return false;
    if (count <= 3)
        return true;
    arrangement_measure(request->marks, NULL, &arrangement);
    return arrangement_suffices(&arrangement, message);
}
