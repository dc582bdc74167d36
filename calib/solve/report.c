/* A solution in words and numbers for people. */
#include "report.h"

#include <math.h>
#include <stdlib.h>

#include "angles.h"

/* One value: as solved, its sd, the change from the start. */
static void write_value(FILE *file, const char *name, const char *unit, double solved, double sd,
                        double start)
{
    fprintf(file, "  %-16s %13.6g %-8s sd %10.3g   change %+11.4g\n", name, solved, unit, sd,
            solved - start);
}

static void write_position(FILE *file, const struct cupola_output *solved,
                           const struct cupola_output *start, const struct solve_result *result)
{
    static const char *const names[] = {"position x", "position y", "position z"};

    for (int i = 0; i < 3 && result->free & SOLVE_POSITION; i++)
        write_value(file, names[i], "m", solved->position_m[i], result->position_sd_m[i],
                    start->position_m[i]);
}

/* Angles that differ by whole turns are the same: the start is taken next to the solved one. */
static void write_aim(FILE *file, const struct cupola_aim *solved, const struct cupola_aim *start,
                      const struct solve_result *result)
{
    static const char *const names[] = {"yaw", "pitch", "roll"};
    const double now[] = {solved->yaw_rad, solved->pitch_rad, solved->roll_rad};
    const double then[] = {start->yaw_rad, start->pitch_rad, start->roll_rad};

    for (int i = 0; i < 3 && result->free & SOLVE_AIM; i++) {
        double near = now[i] * deg_per_rad - remainder((now[i] - then[i]) * deg_per_rad, 360);
        write_value(file, names[i], "degrees", now[i] * deg_per_rad,
                    result->aim_sd_rad[i] * deg_per_rad, near);
    }
}

static void write_lens(FILE *file, const struct cupola_lens *solved,
                       const struct cupola_lens *start, const struct solve_result *result)
{
    static const char *const names[] = {"lens k1", "lens k3", "lens k5", "lens k7"};

    if (!(result->free & SOLVE_LENS))
        return;
    write_value(file, "lens fov", "degrees", solved->fov_rad * deg_per_rad,
                result->fov_sd_rad * deg_per_rad, start->fov_rad * deg_per_rad);
    for (int i = 0; i < 4 && solved->model == CUPOLA_LENS_POLYNOMIAL; i++) {
        if (solved->k[i] != 0 || result->k_sd[i] > 0)
            write_value(file, names[i], "", solved->k[i], result->k_sd[i], start->k[i]);
    }
}

static void write_circle(FILE *file, const struct cupola_circle *solved,
                         const struct cupola_circle *start, const struct solve_result *result)
{
    if (result->free & SOLVE_CIRCLE) {
        write_value(file, "circle x", "px", solved->center_x_px, result->circle_sd_px[0],
                    start->center_x_px);
        write_value(file, "circle y", "px", solved->center_y_px, result->circle_sd_px[1],
                    start->center_y_px);
    }
    if (result->free & SOLVE_CIRCLE_RADIUS)
        write_value(file, "circle radius", "px", solved->radius_px, result->circle_sd_px[2],
                    start->radius_px);
}

struct ranked {
    double length_px;
    int mark;
};

static int compare_lengths(const void *a, const void *b)
{
    const struct ranked *first = a, *second = b;
    int order = (first->length_px < second->length_px) - (first->length_px > second->length_px);

    return order ? order : (first->mark > second->mark) - (first->mark < second->mark);
}

/* Longest first; NULL without memory. */
static struct ranked *rank(const struct solve_request *request, const struct solve_result *result)
{
    int count = request->marks->count;
    struct ranked *ranked = malloc((size_t)count * sizeof *ranked);

    for (int i = 0; i < count && ranked; i++)
        ranked[i] = (struct ranked){
            hypot(result->marks[i].residual_px[0], result->marks[i].residual_px[1]), i};
    if (ranked)
        qsort(ranked, (size_t)count, sizeof *ranked, compare_lengths);
    return ranked;
}

static void write_residuals(FILE *file, const struct solve_request *request,
                            const struct solve_result *result, const struct ranked *ranked,
                            bool verbose)
{
    int count = request->marks->count, shown = verbose || count < 10 ? count : 10;

    fprintf(file, "residuals, px (x, y, length)%s\n",
            shown < count ? ", the ten longest; --verbose shows all" : "");
    for (int i = 0; i < shown; i++) {
        const struct solve_mark *mark = &result->marks[ranked[i].mark];
        fprintf(file, "  %-16s %+10.3f %+10.3f %10.3f%s\n",
                request->marks->list[ranked[i].mark].name, mark->residual_px[0],
                mark->residual_px[1], ranked[i].length_px, mark->rejected ? "  rejected" : "");
    }
}

static const char *worst_name(const struct solve_request *request,
                              const struct solve_result *result, const struct ranked *ranked)
{
    for (int i = 0; i < request->marks->count; i++) {
        if (!result->marks[ranked[i].mark].rejected)
            return request->marks->list[ranked[i].mark].name;
    }
    return "";
}

static void write_rejected(FILE *file, const struct solve_request *request,
                           const struct solve_result *result)
{
    enum { NAMES_MAX = 30 };
    int named = 0;

    if (result->rejected == 0)
        return;
    fputs("rejected as wrong: ", file);
    for (int i = 0; i < request->marks->count && named < NAMES_MAX; i++) {
        if (result->marks[i].rejected)
            fprintf(file, "%s%s", named++ ? ", " : "", request->marks->list[i].name);
    }
    if (named < result->rejected)
        fprintf(file, " and %d more (--json names all)", result->rejected - named);
    fputc('\n', file);
}

void report_write(FILE *file, const struct solve_request *request,
                  const struct solve_result *result, bool verbose)
{
    const struct cupola_output *solved = &result->rig.outputs[request->output];
    const struct cupola_output *start = &request->start->outputs[request->output];
    struct ranked *ranked = rank(request, result);
    int count = request->marks->count;

    fprintf(file, "%d mark%s (%s), %d used, %d rejected\n", count, count == 1 ? "" : "s",
            request->marks->kind == MARKS_POINTS ? "points" : "directions",
            count - result->rejected, result->rejected);
    write_position(file, solved, start, result);
    write_aim(file, &solved->aim, &start->aim, result);
    write_lens(file, &solved->lens, &start->lens, result);
    write_circle(file, &solved->circle, &start->circle, result);
    if (result->free & SOLVE_RADIUS)
        write_value(file, "radius", "m", result->rig.screen.radius_m, result->radius_sd_m,
                    request->start->screen.radius_m);
    fprintf(file, "residuals: %.3g px rms, %.3g px at worst (%s)\n", result->rms_px,
            result->worst_px, ranked ? worst_name(request, result, ranked) : "");
    fprintf(file,
            "the viewer's directions: sd %.2g degrees (median over what is lit), %.2g (worst)\n",
            result->direction_sd_rad * deg_per_rad, result->worst_direction_sd_rad * deg_per_rad);
    write_rejected(file, request, result);
    for (int i = 0; i < result->warning_count; i++)
        fprintf(file, "note: %s\n", result->warnings[i]);
    if (ranked)
        write_residuals(file, request, result, ranked, verbose);
    free(ranked);
}
