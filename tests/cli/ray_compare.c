/* A picture against what the ray tracer expects, pixel by pixel and as a whole. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "ray_rig.h"
#include "srgb.h"

/*
 * Of 255. A colour is rounded three times: in the view, by the filter's weights, in the picture;
 * each time by at most a half and a little.
 */
static const double TOLERANCE = 2;

/*
 * A depth buffer tells two surfaces that cross at a small angle apart only as far as its bits go,
 * and corners are rounded to 1/256 of a texel: so few pixels. None in a hundred pictures so far.
 */
static const double WRONG_SHARE_MAX = 0.0001;

enum { TELLING_MIN = 16 }; /* tiles with edges, for a measurement */

/*
 * An error of 0.1 degrees in the opening moves the rim of a picture 256 pixels wide by 0.07. A
 * texel takes the colour at its centre, so an edge lies up to half a texel off, here to one side
 * and there to the other: how much of that remains on the average is what the standard error says.
 * That of a block comes from few tiles and is itself uncertain.
 */
static const double MOVE_MAX_PX = 0.01, ERRORS_MAX = 4;
static const double BLOCK_MOVE_MAX_PX = 0.1, BLOCK_ERRORS_MAX = 6;

/*
 * Moved by (u, v) pixels the picture loses right * u + up * v in each colour. u and v are those of
 * a shift, a growth and a turn about the circle's centre, the latter two in pixels at its rim.
 */
static void measure(struct comparison *comparison, const struct theatre *theatre, int i, int j,
                    const struct expectation *expectation, const unsigned char *pixel)
{
    double x = (i + 0.5 - theatre->circle_x_px) / theatre->circle_radius_px;
    double y = (j + 0.5 - theatre->circle_y_px) / theatre->circle_radius_px;
    struct sums *tile =
        &comparison->tiles[TILES * j / theatre->height_px][TILES * i / theatre->width_px];

    for (int c = 0; c < 3; c++) {
        double right = expectation->right[c], up = expectation->up[c];
        double row[MOVES] = {right, up, right * x + up * y, up * x - right * y};
        double lost = expectation->mean[c] - light_decoded(pixel[c] / 255.0);

        for (int a = 0; a < MOVES; a++) {
            for (int b = 0; b < MOVES; b++)
                tile->matrix[a][b] += row[a] * row[b];
            tile->side[a] += row[a] * lost;
        }
    }
}

/* Gaussian elimination of the first n unknowns; false where the edges do not tell them. */
static bool solve(const struct sums *sums, int n, double solution[MOVES])
{
    struct sums rest = *sums;

    for (int a = 0; a < n; a++) {
        if (!(rest.matrix[a][a] > 1))
            return false;
        for (int b = a + 1; b < n; b++) {
            double factor = rest.matrix[b][a] / rest.matrix[a][a];

            for (int c = a; c < n; c++)
                rest.matrix[b][c] -= factor * rest.matrix[a][c];
            rest.side[b] -= factor * rest.side[a];
        }
    }
    for (int a = n - 1; a >= 0; a--) {
        solution[a] = rest.side[a];
        for (int b = a + 1; b < n; b++)
            solution[a] -= rest.matrix[a][b] * solution[b];
        solution[a] /= rest.matrix[a][a];
    }
    return true;
}

/*
 * The first n moves from a square of tiles. What is left unexplained goes together within a tile
 * and not from one to another, so the tiles' scatter gives the standard errors.
 */
static bool fit(const struct comparison *comparison, int row, int column, int width, int n,
                struct displacement *displacement)
{
    int telling = 0;
    struct sums whole = {0}, unit;
    double inverse[MOVES][MOVES], *move = displacement->move_px;

    memset(displacement, 0, sizeof *displacement);
    for (int t = 0; t < width * width; t++) {
        const struct sums *tile = &comparison->tiles[row + t / width][column + t % width];

        telling += tile->matrix[0][0] + tile->matrix[1][1] > 0.5;
        for (int a = 0; a < n; a++) {
            whole.side[a] += tile->side[a];
            for (int b = 0; b < n; b++)
                whole.matrix[a][b] += tile->matrix[a][b];
        }
    }
    if (telling < TELLING_MIN || !solve(&whole, n, move))
        return false;
    for (int a = 0; a < n; a++) {
        unit = whole;
        memset(unit.side, 0, sizeof unit.side);
        unit.side[a] = 1;
        solve(&unit, n, inverse[a]);
    }
    for (int t = 0; t < width * width; t++) {
        const struct sums *tile = &comparison->tiles[row + t / width][column + t % width];

        for (int a = 0; a < n; a++) {
            double influence = 0;

            for (int b = 0; b < n; b++) {
                double left = tile->side[b];

                for (int c = 0; c < n; c++)
                    left -= tile->matrix[b][c] * move[c];
                influence += inverse[a][b] * left;
            }
            displacement->error_px[a] += influence * influence;
        }
    }
    for (int a = 0; a < n; a++)
        displacement->error_px[a] = sqrt(displacement->error_px[a]);
    return true;
}

static void fit_all(struct comparison *comparison)
{
    const int width = TILES / BLOCKS;

    comparison->has_edges = fit(comparison, 0, 0, TILES, MOVES, &comparison->whole);
    for (int b = 0; b < BLOCKS * BLOCKS; b++)
        fit(comparison, b / BLOCKS * width, b % BLOCKS * width, width, 2, &comparison->blocks[b]);
}

static bool out_of_range(const struct expectation *expectation, const unsigned char *pixel)
{
    for (int c = 0; c < 3; c++)
        if (!(pixel[c] >= 255 * expectation->low[c] - TOLERANCE &&
              pixel[c] <= 255 * expectation->high[c] + TOLERANCE))
            return true;
    return false;
}

static void print_pixel(const char *kind, int i, int j, const struct expectation *expectation,
                        const unsigned char *pixel)
{
    printf("%s pixel %d,%d is %d,%d,%d; expected", kind, i, j, pixel[0], pixel[1], pixel[2]);
    for (int c = 0; c < 3; c++)
        printf(" %.1f..%.1f", 255 * expectation->low[c], 255 * expectation->high[c]);
    printf("\n");
}

void ray_compare(struct comparison *comparison, const struct tracer *tracer,
                 const unsigned char *picture, bool print_wrong)
{
    const struct theatre *theatre = &tracer->theatre;

    memset(comparison, 0, sizeof *comparison);
    for (int n = 0; n < theatre->width_px * theatre->height_px; n++) {
        int i = n % theatre->width_px, j = n / theatre->width_px;
        const unsigned char *pixel =
            picture + 3 * ((theatre->height_px - 1 - j) * theatre->width_px + i);
        struct expectation expectation;
        bool wrong;

        tracer_expect(tracer, i, j, &expectation);
        wrong = out_of_range(&expectation, pixel);
        if (!expectation.inside) {
            comparison->rim++;
            comparison->rim_wrong += wrong;
        } else if (expectation.edge) {
            comparison->edge++;
            comparison->edge_wrong += wrong;
            measure(comparison, theatre, i, j, &expectation, pixel);
        } else {
            comparison->plain++;
            comparison->plain_wrong += wrong;
        }
        if (wrong && print_wrong)
            print_pixel(!expectation.inside ? "rim"
                        : expectation.edge  ? "edge"
                                            : "plain",
                        i, j, &expectation, pixel);
    }
    fit_all(comparison);
}

static bool few(long wrong, long all)
{
    return (double)wrong <= WRONG_SHARE_MAX * (double)all;
}

static bool in_place(const struct displacement *displacement, double move_max_px, double errors_max)
{
    for (int m = 0; m < MOVES; m++)
        if (!(fabs(displacement->move_px[m]) <=
              move_max_px + errors_max * displacement->error_px[m]))
            return false;
    return true;
}

bool ray_comparison_is_good(const struct comparison *comparison)
{
    bool good = few(comparison->plain_wrong, comparison->plain) &&
                few(comparison->edge_wrong, comparison->edge) && comparison->rim_wrong == 0 &&
                in_place(&comparison->whole, MOVE_MAX_PX, ERRORS_MAX);

    for (int b = 0; b < BLOCKS * BLOCKS; b++)
        good &= in_place(&comparison->blocks[b], BLOCK_MOVE_MAX_PX, BLOCK_ERRORS_MAX);
    return good;
}

void ray_comparison_print(const struct comparison *comparison)
{
    static const char *const NAMES[MOVES] = {"right", "up", "out", "turned"};

    printf("wrong: %ld of %ld plain, %ld of %ld edge, %ld of %ld rim pixels; moved by px:",
           comparison->plain_wrong, comparison->plain, comparison->edge_wrong, comparison->edge,
           comparison->rim_wrong, comparison->rim);
    for (int m = 0; m < MOVES; m++)
        printf(" %s %.4f+-%.4f", NAMES[m], comparison->whole.move_px[m],
               comparison->whole.error_px[m]);
    for (int b = 0; b < BLOCKS * BLOCKS; b++)
        if (!in_place(&comparison->blocks[b], BLOCK_MOVE_MAX_PX, BLOCK_ERRORS_MAX))
            printf(", block %d %.4f+-%.4f %.4f+-%.4f", b, comparison->blocks[b].move_px[0],
                   comparison->blocks[b].error_px[0], comparison->blocks[b].move_px[1],
                   comparison->blocks[b].error_px[1]);
    printf("\n");
}
