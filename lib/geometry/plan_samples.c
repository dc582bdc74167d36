/*
 * Samples for the search: in rings where nearly all of the image circle is lit, else the corners of
 * the grid, each with its part of the pixels and of the solid angle of the cells round it. Eyes on
 * the sphere round the rig's add samples without weight: what they see constrains densities and
 * rectangles but costs nothing by itself.
 */
#include <math.h>
#include <stdlib.h>

#include "error.h"
#include "plan.h"
#include "vector.h"

/* Image area and solid angle of a cell. Folded cells at an edge may come out below 0. */
static void measure_cell(const struct plan_grid *grid, const struct plan_ray *const corners[4],
                         double *area_px, double *solid_angle)
{
    double unit[4][3], around[3] = {0}, middle[3] = {0}, twice = 0;
    for (int i = 0; i < 4; i++) {
        double length = length3(corners[i]->seen.at);
        for (int k = 0; k < 3; k++) {
            unit[i][k] = corners[i]->seen.at[k] / length;
            middle[k] += unit[i][k];
        }
    }
    for (int i = 0; i < 4; i++) {
        const double *a = corners[i]->place_px, *b = corners[(i + 1) % 4]->place_px;
        double part[3];
        twice += a[0] * b[1] - a[1] * b[0];
        cross3(unit[i], unit[(i + 1) % 4], part);
        for (int k = 0; k < 3; k++)
            around[k] += 0.5 * part[k];
    }
    *area_px = larger(0.5 * twice, 0);
    double size = length3(middle);
    *solid_angle = size > 0 ? larger(-grid->sense * dot3(around, middle) / size, 0) : 0;
}

/* Room for every corner of the grids, or for all rings. */
static bool make_room(const struct plan_rays *rays, int rings, struct plan_samples *samples)
{
    int most = PLAN_RINGS_MORE * rings;
    size_t more = (size_t)rays->count * (size_t)(3 * most * most + 6 * rings);
    for (int g = 0; g < rays->count; g++)
        more += (size_t)(rays->grids[g].columns + 1) * (size_t)(rays->grids[g].rows + 1);
    size_t capacity = (size_t)samples->count + more;
    struct plan_sample *grown = realloc(samples->list, capacity * sizeof *grown);
    if (!grown)
        return false;
    samples->list = grown;
    samples->capacity = (int)capacity;
    return true;
}

/* Divides what the lit cells of a grid stand for between their corners; -1 marks the others. */
static void weigh_corners(const struct plan_grid *grid, struct plan_sample *samples)
{
    int count = (grid->columns + 1) * (grid->rows + 1);
    for (int i = 0; i < count; i++)
        samples[i].weight = -1;
    for (int row = 0; row < grid->rows; row++)
        for (int column = 0; column < grid->columns; column++) {
            const struct plan_ray *corners[4];
            double area_px, solid_angle;
            if (!grid->lit[row * grid->columns + column])
                continue;
            plan_cell(grid, column, row, corners);
            measure_cell(grid, corners, &area_px, &solid_angle);
            for (int i = 0; i < 4; i++) {
                struct plan_sample *sample = &samples[corners[i] - grid->corners];
                if (!corners[i]->on_screen)
                    continue;
                if (sample->weight < 0)
                    sample->weight = sample->solid_angle = 0;
                sample->weight += 0.25 * area_px;
                sample->solid_angle += 0.25 * solid_angle;
            }
        }
}

/* Samples of the corners that count. */
static void add_grid(const struct plan_grid *grid, struct plan_samples *samples)
{
    int count = (grid->columns + 1) * (grid->rows + 1);
    struct plan_sample *room = samples->list + samples->count;
    weigh_corners(grid, room);
    for (int i = 0; i < count; i++) {
        if (room[i].weight < 0)
            continue;
        struct plan_sample *sample = &samples->list[samples->count++];
        double weight = room[i].weight, solid_angle = room[i].solid_angle;
        plan_sample_of(&grid->corners[i].seen, sample);
        sample->weight = weight;
        sample->solid_angle = solid_angle;
        sample->reach_rad = 0.5 * sqrt(solid_angle);
    }
}

void plan_sample_weigh(struct plan_sample *sample, double weight, double spread)
{
    double normal[3];
    cross3(sample->dx, sample->dy, normal);
    sample->weight = weight;
    sample->solid_angle = spread * length3(normal);
    sample->reach_rad = 0.5 * sqrt(sample->solid_angle);
}

static int gather_eye(const cupola_dome *dome, const double eye_m[3], int cells, bool first,
                      struct plan_samples *samples, struct cupola_error *error)
{
    struct plan_rays rays;
    int rings = (int)larger(0.5 * cells / sqrt(dome->rig.output_count) + 0.5, 3);
    int status = plan_rays_gather(dome, eye_m, cells, &rays, error), before = samples->count;
    if (status != CUPOLA_OK)
        return status;
    if (make_room(&rays, rings, samples)) {
        struct plan_samples before_it = *samples;
        if (!plan_rings_add(dome, eye_m, rings, samples))
            for (int g = 0; g < rays.count; g++)
                add_grid(&rays.grids[g], samples);
        for (int i = before; i < samples->count && !first; i++)
            plan_sample_weigh(&samples->list[i], 0, 0);
        if (!first) {
            memcpy(samples->edges, before_it.edges, sizeof samples->edges);
            samples->edge_count = before_it.edge_count;
        }
        if (first) {
            samples->pixels = rays.pixels;
            memcpy(samples->mean, rays.mean, sizeof samples->mean);
            samples->half_rad = 0.5 * rays.opening_rad;
        }
    } else {
        status = error_set(error, CUPOLA_ERROR_MEMORY, "no memory for the rays of a plan");
    }
    plan_rays_release(&rays);
    return status;
}

void plan_eye_place(const double middle_m[3], double radius_m, int index, double eye_m[3])
{
    double to[3] = {0, 0, 0};
    if (index > 6) {
        int corner = index - 7;
        for (int i = 0; i < 3; i++)
            to[i] = (corner >> i & 1 ? 1 : -1) / sqrt(3);
    } else if (index > 0) {
        to[(index - 1) / 2] = index % 2 ? 1 : -1;
    }
    for (int i = 0; i < 3; i++)
        eye_m[i] = middle_m[i] + radius_m * to[i];
}

/* Of the samples that stand for pixels. */
static double sample_spacing_px(const struct plan_samples *samples)
{
    int count = 0;
    for (int i = 0; i < samples->count; i++)
        count += samples->list[i].weight > 0;
    return sqrt(samples->pixels / larger(count, 1));
}

int plan_samples_gather(const cupola_dome *dome, double head_radius_m, int cells,
                        struct plan_samples *samples, struct cupola_error *error)
{
    enum { AXES = 7, CELLS_OF_OTHERS = 14 };
    static const double of_spacing = 0.4;
    *samples = (struct plan_samples){.count = 0};
    int status = gather_eye(dome, dome->rig.eye_m, cells, true, samples, error);
    for (int i = 1; i < AXES && head_radius_m > 0 && status == CUPOLA_OK; i++) {
        double eye_m[3];
        plan_eye_place(dome->rig.eye_m, head_radius_m, i, eye_m);
        status = gather_eye(dome, eye_m, CELLS_OF_OTHERS, false, samples, error);
    }
    if (status == CUPOLA_OK)
        samples->short_px =
            PLAN_WHOLE_PX + (samples->edge_count ? 0 : of_spacing * sample_spacing_px(samples));
    else
        plan_samples_release(samples);
    return status;
}

void plan_samples_release(struct plan_samples *samples)
{
    free(samples->list);
    *samples = (struct plan_samples){.count = 0};
}
