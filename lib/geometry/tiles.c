/*
 * Which tiles there are. Each square is looked at on a grid of 3 x 3 places; what lies between them
 * is bounded by second differences.
 */
#include "tiles.h"

#include <stdlib.h>

#include "error.h"
#include "tile_fit.h"
#include "vector.h"
#include "views.h"

/* Half the diagonal of a pixel and some more: farther from an edge none is cut. */
static const double pixel_reach = 0.75;

void tile_point(const struct tile *tile, double x_px, double y_px, double point_m[3])
{
    double terms[TILE_TERMS][3], half = 0.5 * (double)tile->side_px;
    for (int k = 0; k < TILE_TERMS; k++)
        for (int i = 0; i < 3; i++)
            terms[k][i] = (double)tile->terms[k][i];
    tile_terms_at(terms, x_px - (double)tile->x_px - half, y_px - (double)tile->y_px - half,
                  point_m);
}

/* What a function does all over a square, from its values on the grid. */
struct range {
    double least, most;
    double slope; /* per pixel, at most */
};

static struct range range_of(const double f[TILE_GRID_PLACES], double side_px)
{
    struct range range = {f[0], f[0], 0};
    double step = 0, bend[2] = {0, 0};
    for (int i = 0; i < TILE_GRID_PLACES; i++) {
        range.least = fmin(range.least, f[i]);
        range.most = fmax(range.most, f[i]);
    }
    for (int i = 0; i < TILE_GRID; i++) {
        const double *row = f + TILE_GRID * i, *column = f + i;
        bend[0] = fmax(bend[0], fabs(row[0] - 2 * row[1] + row[2]));
        bend[1] = fmax(bend[1], fabs(column[0] - 2 * column[TILE_GRID] + column[2 * TILE_GRID]));
        for (int k = 0; k < TILE_GRID - 1; k++) {
            step = fmax(step, fabs(row[k + 1] - row[k]));
            step = fmax(step, fabs(column[TILE_GRID * (k + 1)] - column[TILE_GRID * k]));
        }
    }
    /* An eighth of each would do for a parabola. */
    double between = 0.25 * (bend[0] + bend[1]);
    range.least -= between;
    range.most += between;
    range.slope = 2 * (step + bend[0] + bend[1]) / side_px;
    return range;
}

/* Pure where no pixel of a square is cut by the image circle's rim, nor beyond it. */
static enum tile_kind kind_by_rim(const struct projector *projector, const struct tile_piece *piece)
{
    double nearest[2], farthest[2];
    double at[2] = {piece->x_px - projector->center_px[0], piece->y_px - projector->center_px[1]};
    for (int i = 0; i < 2; i++) {
        double end = at[i] + piece->side_px;
        nearest[i] = fmax(fmax(at[i], -end), 0);
        farthest[i] = fmax(fabs(at[i]), fabs(end));
    }
    if (hypot(nearest[0], nearest[1]) > projector->radius_px + pixel_reach)
        return TILE_DARK;
    return hypot(farthest[0], farthest[1]) < projector->radius_px - pixel_reach ? TILE_PURE
                                                                                : TILE_EXACT;
}

/* The same for the edge of the screen's cap. */
static enum tile_kind kind_by_cap(const struct projector *projector, double side_px,
                                  double grid[TILE_GRID_PLACES][3])
{
    double excess[TILE_GRID_PLACES];
    if (!projector->capped)
        return TILE_PURE;
    for (int i = 0; i < TILE_GRID_PLACES; i++)
        excess[i] = -grid[i][2] / projector->screen_radius_m - projector->cap_cosine;
    struct range range = range_of(excess, side_px);
    double reach = pixel_reach * 1.5 * range.slope;
    if (range.most < -reach)
        return TILE_DARK;
    return range.least > reach ? TILE_PURE : TILE_EXACT;
}

/* Pure: has a polynomial. */
static enum tile_kind fit_piece(const cupola_plan *plan, int output, struct tile_piece *piece)
{
    const struct projector *projector = &plan->dome.projectors[output];
    double grid[TILE_GRID_PLACES][3], half = 0.5 * piece->side_px;
    enum tile_kind rim = kind_by_rim(projector, piece);
    if (rim == TILE_DARK || (rim == TILE_EXACT && !projector->capped))
        return rim;
    for (int i = 0; i < TILE_GRID_PLACES; i++)
        tile_point_exact(projector, piece->x_px + half * (1 + tile_grid_x(i)),
                         piece->y_px + half * (1 + tile_grid_y(i)), grid[i]);
    enum tile_kind cap = kind_by_cap(projector, piece->side_px, grid);
    if (cap == TILE_DARK || rim == TILE_EXACT || cap == TILE_EXACT)
        return cap == TILE_DARK ? cap : TILE_EXACT;
    return tile_fit(plan, output, grid, piece) ? TILE_PURE : TILE_EXACT;
}

/* A list grows as an output is cut for the first time, not later. */
static bool grow(void **list, int *most, int wished, size_t size)
{
    void *more = realloc(*list, (size_t)wished * size);
    if (!more)
        return false;
    *list = more;
    *most = wished;
    return true;
}

static bool grow_tiles(struct tiles *tiles, enum tile_kind kind, int wished)
{
    void *list = tiles->tiles[kind];
    bool grown = grow(&list, &tiles->most[kind], wished, sizeof *tiles->tiles[kind]);
    tiles->tiles[kind] = list;
    return grown;
}

static bool has_polynomial(int kind)
{
    return kind == TILE_PURE || kind == TILE_PAIR || kind == TILE_CHOOSING;
}

static bool add_tile(struct tiles *tiles, enum tile_kind kind, const struct tile_piece *piece,
                     const int views[2])
{
    int index = tiles->count[kind];
    if (index == tiles->most[kind] && !grow_tiles(tiles, kind, 2 * index + 64))
        return false;
    struct tile *tile = &tiles->tiles[kind][index];
    *tile = (struct tile){.x_px = (float)piece->x_px,
                          .y_px = (float)piece->y_px,
                          .side_px = (float)piece->side_px,
                          .view = (float)views[0],
                          .other = (float)views[1]};
    if (has_polynomial((int)kind))
        for (int k = 0; k < TILE_TERMS; k++)
            for (int i = 0; i < 3; i++)
                tile->terms[k][i] = (float)piece->terms[k][i];
    tiles->count[kind]++;
    return true;
}

static bool add_piece(struct tiles *tiles, const struct tile_piece *piece)
{
    if (tiles->piece_count == tiles->piece_most) {
        void *list = tiles->pieces;
        bool grown = grow(&list, &tiles->piece_most, 2 * tiles->piece_most + 64, sizeof *piece);
        tiles->pieces = list;
        if (!grown)
            return false;
    }
    tiles->pieces[tiles->piece_count++] = *piece;
    return true;
}

/* What holds for every eye. */
static bool cut_square(const cupola_plan *plan, struct tiles *tiles, int x_px, int y_px,
                       int side_px)
{
    const struct cupola_output *size = &plan->dome.rig.outputs[tiles->output];
    struct tile_piece piece = {.x_px = x_px, .y_px = y_px, .side_px = side_px};
    if (x_px >= size->width_px || y_px >= size->height_px)
        return true; /* a quarter beyond the edge */
    enum tile_kind kind = fit_piece(plan, tiles->output, &piece);
    if (kind == TILE_PURE)
        return add_piece(tiles, &piece);
    if (kind == TILE_DARK || side_px <= TILE_LEAST_PX)
        return add_tile(tiles, kind, &piece, (const int[2]){0, 0});
    int half = side_px / 2;
    bool done = true;
    for (int quarter = 0; done && quarter < 4; quarter++)
        done = cut_square(plan, tiles, x_px + half * (quarter & 1), y_px + half * (quarter >> 1),
                          half);
    return done;
}

static bool cut_output(const cupola_plan *plan, struct tiles *tiles)
{
    const struct cupola_output *size = &plan->dome.rig.outputs[tiles->output];
    for (int y = 0; y < size->height_px; y += tiles->most_px)
        for (int x = 0; x < size->width_px; x += tiles->most_px)
            if (!cut_square(plan, tiles, x, y, tiles->most_px))
                return false;
    return true;
}

/* Pieces being cut into tiles by the views that their pixels fall to. */
struct choice {
    const cupola_plan *plan;
    const struct cupola_output *size;
    struct tiles *tiles;
    double selectors[CUPOLA_VIEWS_MAX][3]; /* of the views, in the dome frame */
    int pending;                           /* squares still to come, each one tile at least */
    bool growing, failed;
};

/*
 * The views that pixels of a piece may fall to: their number; `views` are the first two of them, of
 * which the first has the middle.
 */
static int views_of(const struct choice *choice, struct tile_piece *piece, int views[2])
{
    const double *eye = choice->plan->dome.rig.eye_m;
    double leads[CUPOLA_VIEWS_MAX][TILE_GRID_PLACES], half = 0.5 * piece->side_px;
    int count = choice->plan->view_count, own = 0, found = 1;
    for (int i = 0; i < TILE_GRID_PLACES; i++) {
        double ray[3];
        tile_terms_at(piece->terms, half * tile_grid_x(i), half * tile_grid_y(i), ray);
        for (int k = 0; k < 3; k++)
            ray[k] -= eye[k];
        for (int v = 0; v < count; v++)
            leads[v][i] = dot3(choice->selectors[v], ray);
    }
    for (int v = 1; v < count; v++)
        if (leads[v][TILE_GRID_PLACES / 2] > leads[own][TILE_GRID_PLACES / 2])
            own = v;
    for (int v = 0; v < count; v++) {
        double lead[TILE_GRID_PLACES];
        for (int i = 0; i < TILE_GRID_PLACES; i++)
            lead[i] = leads[own][i] - leads[v][i];
        struct range range = range_of(lead, piece->side_px);
        if (v == own || range.least > choice->tiles->reach_px * range.slope)
            continue;
        if (found == 1)
            views[1] = v;
        found++;
    }
    views[0] = own;
    if (found == 1)
        views[1] = own;
    return found;
}

/* Whether there is room for four in place of one, whatever they turn out to be. */
static bool has_room(const struct choice *choice)
{
    const struct tiles *tiles = choice->tiles;
    int more = choice->pending + 4;
    for (int kind = TILE_PURE; !choice->growing && kind <= TILE_CHOOSING; kind++)
        if (tiles->count[kind] + more > tiles->most[kind])
            return false;
    return true;
}

static void choose(struct choice *choice, struct tile_piece *piece)
{
    if (piece->x_px >= choice->size->width_px || piece->y_px >= choice->size->height_px)
        return;
    int views[2], count = views_of(choice, piece, views);
    if (count <= 2 || piece->side_px <= TILE_CHOOSING_PX || !has_room(choice)) {
        enum tile_kind kind = count == 1 ? TILE_PURE : count == 2 ? TILE_PAIR : TILE_CHOOSING;
        choice->failed |= !add_tile(choice->tiles, kind, piece, views);
        return;
    }
    for (int quarter = 0; quarter < 4; quarter++) {
        struct tile_piece part;
        tile_quarter(piece, quarter, &part);
        choice->pending += 3 - quarter;
        choose(choice, &part);
        choice->pending -= 3 - quarter;
    }
}

static bool choose_all(const cupola_plan *plan, struct tiles *tiles, bool growing)
{
    struct choice choice = {.plan = plan,
                            .size = &plan->dome.rig.outputs[tiles->output],
                            .tiles = tiles,
                            .pending = tiles->piece_count,
                            .growing = growing};
    for (int v = 0; v < plan->view_count; v++)
        transform3_back(plan->dome.tilt, plan->views[v].selector, choice.selectors[v]);
    for (int kind = TILE_PURE; kind <= TILE_CHOOSING; kind++)
        tiles->count[kind] = 0;
    for (int i = 0; i < tiles->piece_count; i++) {
        choice.pending--;
        choose(&choice, &tiles->pieces[i]);
    }
    return !choice.failed;
}

static int whole_squares(int length_px, int side_px)
{
    return (length_px + side_px - 1) / side_px * side_px;
}

int tiles_create(const cupola_plan *plan, int output, int most_px, double reach_px,
                 struct tiles *tiles, struct cupola_error *error)
{
    const struct cupola_output *size = &plan->dome.rig.outputs[output];
    *tiles = (struct tiles){.output = output,
                            .most_px = most_px,
                            .reach_px = reach_px,
                            .width_px = whole_squares(size->width_px, most_px),
                            .height_px = whole_squares(size->height_px, most_px)};
    bool done = cut_output(plan, tiles) && choose_all(plan, tiles, true);
    /* Room for the tiles of another eye. */
    for (enum tile_kind kind = TILE_PURE; done && kind <= TILE_CHOOSING; kind++)
        done = grow_tiles(tiles, kind, tiles->count[kind] * 5 / 4 + tiles->piece_count + 4);
    if (done)
        return CUPOLA_OK;
    tiles_destroy(tiles);
    return error_set(error, CUPOLA_ERROR_MEMORY, "no memory for the tiles of output %d", output);
}

void tiles_destroy(struct tiles *tiles)
{
    for (int kind = 0; kind < TILE_KINDS; kind++)
        free(tiles->tiles[kind]);
    free(tiles->pieces);
    *tiles = (struct tiles){0};
}

void tiles_refit(const cupola_plan *plan, struct tiles *tiles)
{
    choose_all(plan, tiles, false);
}
