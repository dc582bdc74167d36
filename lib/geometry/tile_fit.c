/*
 * Polynomials go through the points at Chebyshev's nodes by least squares. They are tried there, at
 * the corners, the middles of the sides and in the middle.
 */
#include "tile_fit.h"

#include "vector.h"
#include "views.h"

enum { SIDE_NODES = 4, NODES = SIDE_NODES * SIDE_NODES };

/* cos((2 i + 1) pi / 8): where Chebyshev's polynomial of degree 4 is 0. */
static const double nodes[SIDE_NODES] = {0.92387953251128674, 0.38268343236508977,
                                         -0.38268343236508977, -0.92387953251128674};

static void powers(double x, double y, double terms[TILE_TERMS])
{
    const double all[TILE_TERMS] = {1,     x,         y,         x * x,     x * y,
                                    y * y, x * x * x, x * x * y, x * y * y, y * y * y};
    memcpy(terms, all, sizeof all);
}

void tile_terms_at(double terms[TILE_TERMS][3], double x, double y, double point_m[3])
{
    double power[TILE_TERMS], sum[3] = {0, 0, 0};
    powers(x, y, power);
    for (int k = 0; k < TILE_TERMS; k++)
        for (int i = 0; i < 3; i++)
            sum[i] += power[k] * terms[k][i];
    memcpy(point_m, sum, sizeof sum);
}

void tile_point_exact(const struct projector *projector, double x_px, double y_px,
                      double point_m[3])
{
    double place[2];
    struct varying lens, point;
    circle_place(projector, x_px, y_px, place);
    lens_ray(projector, place, &lens);
    screen_point(projector, &lens, &point);
    memcpy(point_m, point.at, sizeof point.at);
}

/*
 * Chebyshev's polynomials T_i(x) T_j(y), i + j up to 3, are orthogonal on the nodes, so least
 * squares are sums of products.
 */
static void fit_nodes(double points[NODES][3], double side_px, double terms[TILE_TERMS][3])
{
    static const double chebyshev[4][4] = {
        {1, 0, 0, 0}, {0, 1, 0, 0}, {-1, 0, 2, 0}, {0, -3, 0, 4}};
    static const int term_of[4][4] = {{0, 2, 5, 9}, {1, 4, 8, -1}, {3, 7, -1, -1}, {6, -1, -1, -1}};
    double at[4][SIDE_NODES], scale[TILE_TERMS];
    for (int n = 0; n < SIDE_NODES; n++) {
        double x = nodes[n], values[4] = {1, x, 2 * x * x - 1, x * (4 * x * x - 3)};
        for (int i = 0; i < 4; i++)
            at[i][n] = values[i] * (i ? 2.0 : 1.0) / SIDE_NODES;
    }
    memset(terms, 0, TILE_TERMS * sizeof terms[0]);
    for (int i = 0; i < 4; i++)
        for (int j = 0; i + j < 4; j++) {
            double sum[3] = {0, 0, 0};
            for (int n = 0; n < NODES; n++)
                for (int c = 0; c < 3; c++)
                    sum[c] += at[i][n % SIDE_NODES] * at[j][n / SIDE_NODES] * points[n][c];
            for (int a = i & 1; a <= i; a += 2)
                for (int b = j & 1; b <= j; b += 2)
                    for (int c = 0; c < 3; c++)
                        terms[term_of[a][b]][c] += chebyshev[i][a] * chebyshev[j][b] * sum[c];
        }
    powers(2 / side_px, 2 / side_px, scale);
    for (int k = 0; k < TILE_TERMS; k++)
        scale3(terms[k], scale[k]);
}

/* Into a view's texels; false if the ray points away from the view. */
static bool texel_of(const cupola_plan *plan, const double eye_m[3], const struct cupola_view *view,
                     const double point_m[3], double texel[2])
{
    double ray[3], base[2];
    for (int i = 0; i < 3; i++)
        ray[i] = point_m[i] - eye_m[i];
    transform3(plan->dome.tilt, ray, ray);
    if (!view_hit(view, ray, base))
        return false;
    view_texel(view, base, texel);
    return true;
}

/* Whether one point does for another, for an eye. */
static bool does_for(const cupola_plan *plan, const double eye_m[3], const double found_m[3],
                     const double expected_m[3])
{
    double ray[3], expected[2], found[2];
    for (int i = 0; i < 3; i++)
        ray[i] = expected_m[i] - eye_m[i];
    transform3(plan->dome.tilt, ray, ray);
    const struct cupola_view *view = &plan->views[view_select(plan->views, plan->view_count, ray)];
    const double apart_m[3] = {found_m[0] - expected_m[0], found_m[1] - expected_m[1],
                               found_m[2] - expected_m[2]};
    /* Half of what is allowed: between the places and eyes that are tried it may be more. */
    return length3(apart_m) < 0.5 * TILE_ERROR_RAD * length3(ray) &&
           texel_of(plan, eye_m, view, expected_m, expected) &&
           texel_of(plan, eye_m, view, found_m, found) &&
           hypot(found[0] - expected[0], found[1] - expected[1]) < 0.5 * TILE_ERROR_TEXELS;
}

/*
 * Whether the terms do for a place; x and y from -1 to 1 across the piece. Where the eye moves, for
 * the eye nearest to the place, too, and for some all over the sphere that it stays in.
 */
static bool does(const cupola_plan *plan, struct tile_piece *piece, double x, double y,
                 const double expected_m[3])
{
    double found_m[3], eye_m[3], to[3], half = 0.5 * piece->side_px;
    tile_terms_at(piece->terms, half * x, half * y, found_m);
    if (!does_for(plan, plan->dome.rig.eye_m, found_m, expected_m))
        return false;
    if (plan->head_radius_m == 0)
        return true;
    for (int i = 0; i < 3; i++)
        to[i] = expected_m[i] - plan->planned_eye_m[i];
    double part = plan->head_radius_m / length3(to);
    for (int i = 0; i < 3; i++)
        eye_m[i] = plan->planned_eye_m[i] + part * to[i];
    bool good = does_for(plan, eye_m, found_m, expected_m);
    for (int e = 0; e < PLAN_EYES && good; e++) {
        plan_eye_place(plan->planned_eye_m, plan->head_radius_m, e, eye_m);
        good = does_for(plan, eye_m, found_m, expected_m);
    }
    return good;
}

bool tile_fit(const cupola_plan *plan, int output, double grid[TILE_GRID_PLACES][3],
              struct tile_piece *piece)
{
    double points[NODES][3], half = 0.5 * piece->side_px;
    for (int n = 0; n < NODES; n++)
        tile_point_exact(&plan->dome.projectors[output],
                         piece->x_px + half * (1 + nodes[n % SIDE_NODES]),
                         piece->y_px + half * (1 + nodes[n / SIDE_NODES]), points[n]);
    fit_nodes(points, piece->side_px, piece->terms);
    for (int i = 0; i < TILE_GRID_PLACES; i++)
        if (!does(plan, piece, tile_grid_x(i), tile_grid_y(i), grid[i]))
            return false;
    for (int n = 0; n < NODES; n++)
        if (!does(plan, piece, nodes[n % SIDE_NODES], nodes[n / SIDE_NODES], points[n]))
            return false;
    return true;
}

/* Taylor's series of a cubic about another place. */
static void shift(const struct tile_piece *piece, double x, double y, struct tile_piece *part)
{
    memcpy(part->terms, piece->terms, sizeof part->terms);
    tile_terms_at(part->terms, x, y, part->terms[0]);
    for (int i = 0; i < 3; i++) {
        double t[TILE_TERMS];
        for (int k = 0; k < TILE_TERMS; k++)
            t[k] = piece->terms[k][i];
        part->terms[1][i] =
            t[1] + 2 * t[3] * x + t[4] * y + 3 * t[6] * x * x + 2 * t[7] * x * y + t[8] * y * y;
        part->terms[2][i] =
            t[2] + t[4] * x + 2 * t[5] * y + t[7] * x * x + 2 * t[8] * x * y + 3 * t[9] * y * y;
        part->terms[3][i] = t[3] + 3 * t[6] * x + t[7] * y;
        part->terms[4][i] = t[4] + 2 * t[7] * x + 2 * t[8] * y;
        part->terms[5][i] = t[5] + t[8] * x + 3 * t[9] * y;
    }
}

void tile_quarter(const struct tile_piece *piece, int quarter, struct tile_piece *part)
{
    int half = piece->side_px / 2, right = quarter & 1, up = quarter >> 1;
    part->x_px = piece->x_px + half * right;
    part->y_px = piece->y_px + half * up;
    part->side_px = half;
    shift(piece, 0.5 * half * (2 * right - 1), 0.5 * half * (2 * up - 1), part);
}
