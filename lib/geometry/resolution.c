/* How well the views of a plan fit its outputs: every lit pixel asked, and sorted. */
#include "cupola/resolution.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "advice.h"
#include "density.h"
#include "error.h"
#include "filter.h"
#include "mask.h"
#include "plan.h"
#include "vector.h"
#include "views.h"

enum { COLUMNS = 4, ASKED_MOST = 2048 * 2048 };

/* What is asked of each pixel. */
enum column { SOLID_ANGLE, AREA, LEAST, MOST };

struct asking {
    const cupola_plan *plan;
    struct cupola_resolution *resolution;
    int first, last; /* outputs */
    int step;        /* every such column and row of an image */
    size_t count, room;
    float *columns[COLUMNS]; /* a number for each pixel asked */
    float *sorting[2];       /* room to sort one */
    unsigned char *views;    /* that each falls to */
    double smallest_sr, largest_sr;
    struct advice_asked asked;
};

/* ---- asking ---- */

/*
 * Along the line with the fewest texels, as the planner counts them: no finite number of them would
 * do for the rim of a lens of nearly 360 degrees.
 */
static double fewest_texels(const struct asking *asking, int output, int view,
                            const double middle_px[2], double least)
{
    const cupola_dome *dome = &asking->plan->dome;
    const struct projector *projector = &dome->projectors[output];
    struct varying ray, point, seen;
    double place[2], base[2], jacobian[4], values[2];
    if (projector->lens.half_fov < PLAN_COLLAPSES_RAD)
        return least;
    place_inside_rim(projector, middle_px[0], middle_px[1], place);
    lens_ray(projector, place, &ray);
    plan_widen_collapsed(projector, place, &ray);
    screen_point(projector, &ray, &point);
    eye_ray(dome, dome->rig.eye_m, &point, &seen);
    if (!view_hit(&asking->plan->views[view], seen.at, base))
        return least;
    filter_jacobian(&asking->plan->views[view], &seen, jacobian);
    density_stretch(jacobian, values);
    return values[1];
}

static void note_place(const struct varying *seen, int output, const double middle_px[2],
                       struct cupola_resolution_place *place)
{
    double length = length3(seen->at);
    *place = (struct cupola_resolution_place){.output = output,
                                              .pixel_px = {middle_px[0], middle_px[1]}};
    for (int i = 0; i < 3; i++)
        place->direction[i] = seen->at[i] / length;
}

static void ask_pixel(struct asking *asking, int output, int x, int y)
{
    const cupola_plan *plan = asking->plan;
    struct cupola_resolution *resolution = asking->resolution;
    const double middle_px[2] = {x + 0.5, y + 0.5};
    struct varying seen;
    double base[2], jacobian[4], values[2];
    double coverage =
        density_ray(&plan->dome, output, plan->dome.rig.eye_m, middle_px[0], middle_px[1], &seen);
    if (!(coverage > 0))
        return;
    int view = view_select(plan->views, plan->view_count, seen.at);
    if (!view_hit(&plan->views[view], seen.at, base))
        return;
    filter_jacobian(&plan->views[view], &seen, jacobian);
    density_stretch(jacobian, values);
    double solid_angle_sr = density_solid_angle(&seen);
    double pixels = coverage * asking->step * asking->step;
    size_t i = asking->count++;
    asking->columns[SOLID_ANGLE][i] = (float)solid_angle_sr;
    asking->columns[AREA][i] = (float)(values[0] * values[1]);
    asking->columns[LEAST][i] = (float)values[1];
    asking->columns[MOST][i] = (float)values[0];
    asking->views[i] = (unsigned char)view;
    asking->asked.really[view] = fmin(asking->asked.really[view], values[1]);
    asking->asked.fewest[view] =
        fmin(asking->asked.fewest[view], fewest_texels(asking, output, view, middle_px, values[1]));
    resolution->view[view].pixels += pixels;
    resolution->pixels += pixels;
    if (solid_angle_sr > asking->largest_sr) {
        asking->largest_sr = solid_angle_sr;
        note_place(&seen, output, middle_px, &resolution->coarsest);
    }
    if (solid_angle_sr < asking->smallest_sr) {
        asking->smallest_sr = solid_angle_sr;
        note_place(&seen, output, middle_px, &resolution->finest);
    }
}

/* Whole pixels of an output from and to which it may be lit. */
static void lit_box(const struct asking *asking, int output, int box[4])
{
    struct plan_part part = plan_lit_part(&asking->plan->dome.projectors[output]);
    const struct cupola_output *size = &asking->plan->dome.rig.outputs[output];
    for (int i = 0; i < 4; i++) {
        int most = i < 2 ? size->width_px : size->height_px;
        box[i] = (int)fmin(fmax(part.sides[i] + (i % 2 ? 1 : -1), 0), most);
    }
}

static double box_pixels(const struct asking *asking)
{
    double sum = 0;
    for (int output = asking->first; output <= asking->last; output++) {
        int box[4];
        lit_box(asking, output, box);
        sum += ((box[1] - box[0]) / asking->step + 1.0) * ((box[3] - box[2]) / asking->step + 1.0);
    }
    return sum;
}

static void ask_output(struct asking *asking, int output)
{
    int box[4], step = asking->step;
    lit_box(asking, output, box);
    for (int y = box[2] + step / 2; y < box[3]; y += step)
        for (int x = box[0] + step / 2; x < box[1]; x += step)
            ask_pixel(asking, output, x, y);
}

static bool make_room(struct asking *asking)
{
    bool made = true;
    asking->step = 1;
    while (box_pixels(asking) > ASKED_MOST + 4.0 * 2048)
        asking->step++;
    asking->room = (size_t)box_pixels(asking);
    for (int i = 0; i < COLUMNS; i++)
        made &= (asking->columns[i] = malloc(asking->room * sizeof(float))) != NULL;
    for (int i = 0; i < 2; i++)
        made &= (asking->sorting[i] = malloc(asking->room * sizeof(float))) != NULL;
    return (asking->views = malloc(asking->room)) != NULL && made;
}

static void give_back_room(struct asking *asking)
{
    for (int i = 0; i < COLUMNS; i++)
        free(asking->columns[i]);
    for (int i = 0; i < 2; i++)
        free(asking->sorting[i]);
    free(asking->views);
}

/* ---- sorting ---- */

/* By bytes, the lowest first: bits of floats from 0 on are in the order of the numbers. */
static void sort(float *values, float *other, size_t count)
{
    for (int shift = 0; shift < 32; shift += 8) {
        size_t first[257] = {0};
        uint32_t bits;
        for (size_t i = 0; i < count; i++) {
            memcpy(&bits, &values[i], sizeof bits);
            first[(bits >> shift & 0xff) + 1]++;
        }
        for (int i = 0; i < 256; i++)
            first[i + 1] += first[i];
        for (size_t i = 0; i < count; i++) {
            memcpy(&bits, &values[i], sizeof bits);
            other[first[bits >> shift & 0xff]++] = values[i];
        }
        float *sorted = other;
        other = values;
        values = sorted;
    }
}

/* Of the pixels of one view. */
static struct cupola_spread spread_of(const struct asking *asking, enum column column, int view)
{
    float *values = asking->sorting[0];
    size_t count = 0;
    for (size_t i = 0; i < asking->count; i++)
        if (asking->views[i] == view)
            values[count++] = asking->columns[column][i];
    if (count == 0)
        return (struct cupola_spread){0, 0, 0};
    sort(values, asking->sorting[1], count);
    return (struct cupola_spread){(double)values[0], (double)values[count / 2],
                                  (double)values[count - 1]};
}

static double pixels_per_degree(double solid_angle_sr)
{
    return pi / 180 / sqrt(larger(solid_angle_sr, 1e-300));
}

static void spread_degrees(struct asking *asking)
{
    float *angles_sr = asking->columns[SOLID_ANGLE];
    double sum = 0, half = 0;
    size_t middle = 0;
    if (asking->count == 0)
        return;
    sort(angles_sr, asking->sorting[0], asking->count);
    for (size_t i = 0; i < asking->count; i++)
        sum += (double)angles_sr[i];
    while (middle + 1 < asking->count && (half += (double)angles_sr[middle]) < 0.5 * sum)
        middle++;
    asking->resolution->pixels_per_degree = (struct cupola_spread){
        pixels_per_degree(asking->largest_sr), pixels_per_degree((double)angles_sr[middle]),
        pixels_per_degree(asking->smallest_sr)};
}

/* ---- texels that nothing touches ---- */

static double needed_texels(const struct mask_texels *texels)
{
    size_t words = (size_t)texels->words * (size_t)texels->height;
    double needed = 0;
    for (size_t i = 0; i < words; i++)
        needed += __builtin_popcountll(texels->bits[i]);
    return needed;
}

static int count_texels(const cupola_plan *plan, struct cupola_resolution *resolution,
                        struct cupola_error *error)
{
    struct mask mask;
    int status = mask_create(plan, true, &mask, error);
    if (status != CUPOLA_OK)
        return status;
    for (int v = 0; v < plan->view_count; v++) {
        struct cupola_view_resolution *view = &resolution->view[v];
        const struct cupola_rect *rect = &plan->views[v].rect;
        view->texels = (double)rect->width * rect->height;
        view->texels_never_sampled = view->texels - needed_texels(&mask.texels[v]);
        resolution->texels += view->texels;
        resolution->texels_never_sampled += view->texels_never_sampled;
    }
    mask_destroy(&mask);
    return CUPOLA_OK;
}

static int measure(struct asking *asking, struct cupola_error *error)
{
    struct cupola_resolution *resolution = asking->resolution;
    for (int v = 0; v < asking->plan->view_count; v++)
        asking->asked.fewest[v] = asking->asked.really[v] = HUGE_VAL;
    asking->smallest_sr = HUGE_VAL;
    for (int output = asking->first; output <= asking->last; output++)
        ask_output(asking, output);
    for (int v = 0; v < asking->plan->view_count; v++) {
        resolution->view[v].texels_per_pixel = spread_of(asking, AREA, v);
        resolution->view[v].least_texels_per_pixel = spread_of(asking, LEAST, v);
        resolution->view[v].most_texels_per_pixel = spread_of(asking, MOST, v);
    }
    spread_degrees(asking);
    asking->asked.lit = asking->count > 0;
    asking->asked.all = asking->last - asking->first + 1 == asking->plan->dome.rig.output_count;
    return advice_give(asking->plan, &asking->asked, resolution->advice, error);
}

int cupola_resolution_measure(const cupola_plan *plan, int output,
                              struct cupola_resolution *resolution, struct cupola_error *error)
{
    if (!plan || !resolution)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is NULL; allowed: a %s",
                         plan ? "resolution" : "plan", plan ? "place for one" : "plan");
    int last = plan->dome.rig.output_count - 1;
    if (output < -1 || output > last)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "output is %d; allowed: 0 to %d, or -1 for all", output, last);
    struct cupola_resolution found = {.views = plan->view_count};
    struct asking asking = {.plan = plan,
                            .resolution = &found,
                            .first = output < 0 ? 0 : output,
                            .last = output < 0 ? last : output};
    int status = count_texels(plan, &found, error);
    if (status != CUPOLA_OK)
        return status;
    if (make_room(&asking))
        status = measure(&asking, error);
    else
        status = error_set(error, CUPOLA_ERROR_MEMORY, "no memory for the pixels of a resolution");
    if (status == CUPOLA_OK)
        *resolution = found;
    give_back_room(&asking);
    return status;
}
