/* Whether residuals are noise or show something that is not as the rig says. */
#ifndef MISFIT_H
#define MISFIT_H

#include "solve/model.h"

struct misfit {
    char what[60];   /* "lens free, too,", "the lens model "angular"" */
    double rms_px;   /* of the residuals' lengths as they are; of 300 marks where there are more */
    double freed_px; /* with that */
};

/*
 * At a solution: what else, set free, or which other lens model would explain the residuals of the
 * marks that are not rejected far better than chance does, and make them clearly smaller. False:
 * nothing, or without memory.
 */
bool misfit_find(const struct solve_request *request, const struct model *solved,
                 const bool *rejected, struct misfit *misfit);

#endif
