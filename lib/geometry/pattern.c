/* Places of rays in the unit disc, each for an equal part of it, and their weights. */
#include "pattern.h"

#include <math.h>
#include <stdlib.h>

#include "angle.h"

static void place_at(struct pattern_place *place, double radius, double angle_rad)
{
    place->x = radius * cos(angle_rad);
    place->y = radius * sin(angle_rad);
}

/*
 * Rings of places that all stand for an equal area: the ring of places `first` to `end` stands for
 * all between the radii sqrt(first / count) and sqrt(end / count), and lies at the root of the
 * mean square of them, so that the second moment of all is the disc's. A ring has as many places as
 * make them as far from each other along it as across.
 */
static void make_rings(int count, struct pattern *pattern)
{
    int rings = (int)floor(sqrt(count / pi) + 0.5), first = 0;
    for (int ring = 0; first < count; ring++) {
        int left = count - first, outwards = rings - ring;
        /* Of rings 1, 2, 3 ... wide of the middle, by their circumferences. */
        double share = (2 * ring + 1) / (double)(outwards * (2 * ring + outwards));
        int places = outwards <= 1 ? left : (int)fmax(floor(left * share + 0.5), 3);
        double radius = sqrt((2 * first + places) / (2.0 * count));
        for (int i = 0; i < places; i++)
            place_at(&pattern->places[first + i], radius, 2 * pi * (i + 0.5) / places);
        first += places;
    }
}

/* Of a square lattice whose squares have sides of 2, from its middle. */
struct lattice_place {
    int column, row;
    int square; /* of its distance from the middle */
    int order;  /* of places as far: those that a half turn or a quarter turn join stand together */
};

static int compare_places(const void *a, const void *b)
{
    const struct lattice_place *p = a, *q = b;
    return p->square != q->square ? p->square - q->square : p->order - q->order;
}

enum { LATTICE_REACH = 14 };

/* The first of the places that become each other by quarter turns, or by half turns. */
static int lattice_order(int column, int row, bool quarters)
{
    int turns = 0;
    while (!(column > 0 && (row >= 0 || !quarters)) && !(column == 0 && row >= 0 && !quarters)) {
        if (column == 0 && row == 0)
            break;
        int turned = quarters ? -row : -column;
        row = quarters ? column : -row;
        column = turned;
        turns++;
    }
    int halves_first = (turns % 2) * 2 + turns / 2;
    return 4 * ((row + LATTICE_REACH) * 2 * LATTICE_REACH + column) +
           (quarters ? halves_first : turns);
}

static int make_lattice(int column_start, int row_start, struct lattice_place *places)
{
    int found = 0;
    for (int column = column_start; column < LATTICE_REACH; column += 2)
        for (int row = row_start; row < LATTICE_REACH; row += 2)
            places[found++] = (struct lattice_place){
                column, row, column * column + row * row,
                lattice_order(column, row, (column_start - row_start) % 2 == 0)};
    qsort(places, (size_t)found, sizeof *places, compare_places);
    return found;
}

/*
 * The `count` places of a square lattice that are nearest to its middle, in pairs across it. Odd
 * numbers have a place there, fours the middle of a square, other even ones of an edge. Turned by
 * the angle whose tangent is 1 / rows, coordinates are column rows - row and row rows + column over
 * a common length: no two of them are equal while places are less than `rows` squares apart. The
 * length makes the second moment the disc's, unless a place would leave it.
 */
static void make_rotated_grid(int count, struct pattern *pattern)
{
    struct lattice_place places[LATTICE_REACH * LATTICE_REACH];
    int even = 1 - LATTICE_REACH, odd = 2 - LATTICE_REACH;
    make_lattice(count % 2 ? odd : even, count % 4 == 2 || count % 2 ? odd : even, places);
    int extent = 0, squares = 0;
    for (int i = 0; i < count; i++) {
        extent = places[i].column > extent ? places[i].column : extent;
        extent = places[i].row > extent ? places[i].row : extent;
        squares += places[i].square;
    }
    int rows = extent + 1;
    double length = sqrt(fmax(2.0 * squares / count, places[count - 1].square)) * hypot(rows, 1);
    for (int i = 0; i < count && squares > 0; i++) {
        pattern->places[i].x = (places[i].column * rows - places[i].row) / length;
        pattern->places[i].y = (places[i].row * rows + places[i].column) / length;
    }
}

static uint32_t scramble(uint32_t x)
{
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return x;
}

uint32_t pattern_hash(uint32_t x, uint32_t y, uint32_t seed)
{
    return scramble(x + scramble(y + scramble(seed)));
}

double pattern_turn_rad(uint32_t x, uint32_t y, uint32_t seed)
{
    return 2 * pi * ((pattern_hash(x, y, seed) >> 8) * 0x1p-24);
}

/* How far a place is from all others, those across the middle, and its own image in the rim. */
static double room_at(const struct pattern *pattern, int count, double x, double y)
{
    double room = 2 * fmin(hypot(x, y), 1 - hypot(x, y));
    for (int i = 0; i < count; i++)
        room = fmin(room, hypot(x - pattern->places[i].x, y - pattern->places[i].y));
    return room;
}

/* Mitchell's best candidate (1991), in pairs across the middle. */
static void make_blue_noise(int count, struct pattern *pattern)
{
    const int candidates = 64;
    uint32_t hash = (uint32_t)count;
    int first = count % 2;
    if (first)
        place_at(&pattern->places[0], 0, 0);
    for (; first < count; first += 2) {
        struct pattern_place best = {0};
        double most = -1;
        for (int i = 0; i < candidates; i++) {
            struct pattern_place candidate = {0};
            double square = ((hash = scramble(hash + 0x9e3779b9u)) >> 8) * 0x1p-24;
            double turn = ((hash = scramble(hash + 0x9e3779b9u)) >> 8) * 0x1p-24;
            place_at(&candidate, sqrt(square), 2 * pi * turn);
            double room = room_at(pattern, first, candidate.x, candidate.y);
            if (room > most) {
                most = room;
                best = candidate;
            }
        }
        pattern->places[first] = best;
        pattern->places[first + 1] = (struct pattern_place){-best.x, -best.y, 0};
    }
}

/* 1 - d^2 of the places as they are for equal parts of the disc, but never next to nothing. */
static void weigh(struct pattern *pattern)
{
    double sum = 0;
    for (int i = 0; i < pattern->count; i++) {
        struct pattern_place *place = &pattern->places[i];
        place->weight = fmax(1 - (place->x * place->x + place->y * place->y), 0.04);
        sum += place->weight;
    }
    for (int i = 0; i < pattern->count; i++)
        pattern->places[i].weight /= sum;
}

/* The symmetric matrix {xx, xy, yy} that makes the second moment `wished` each way. */
static void evening_matrix(const struct pattern *pattern, double wished, double matrix[3])
{
    double xx = 0, xy = 0, yy = 0;
    for (int i = 0; i < pattern->count; i++) {
        const struct pattern_place *place = &pattern->places[i];
        xx += place->weight * place->x * place->x;
        xy += place->weight * place->x * place->y;
        yy += place->weight * place->y * place->y;
    }
    /* The root of a symmetric matrix M is (M + r) / t, r = sqrt(det M), t = sqrt(trace M + 2 r);
     * its inverse is what is wanted. */
    double r = sqrt(xx * yy - xy * xy), t = sqrt(xx + yy + 2 * r);
    double scale = sqrt(wished) / (r * t);
    matrix[0] = scale * (yy + r);
    matrix[1] = -scale * xy;
    matrix[2] = scale * (xx + r);
}

/*
 * Moves places until their second moment is that of the whole disc, weighed so: a sixth each way,
 * unless one would leave it.
 */
static void even_out(struct pattern *pattern)
{
    double matrix[3], farthest = 1;
    evening_matrix(pattern, 1.0 / 6, matrix);
    for (int i = 0; i < pattern->count; i++) {
        struct pattern_place *place = &pattern->places[i];
        double x = matrix[0] * place->x + matrix[1] * place->y;
        place->y = matrix[1] * place->x + matrix[2] * place->y;
        place->x = x;
        farthest = fmax(farthest, hypot(x, place->y));
    }
    for (int i = 0; i < pattern->count; i++) {
        pattern->places[i].x /= farthest;
        pattern->places[i].y /= farthest;
    }
}

/* The middle, a pair that has the second moment along itself, and a triangle: of every pattern,
 * turned. */
static void make_few(enum cupola_pattern kind, int count, struct pattern *pattern)
{
    static const double turns_deg[] = {
        [CUPOLA_PATTERN_REGULAR] = 0,
        [CUPOLA_PATTERN_ROTATED_GRID] = 15,
        [CUPOLA_PATTERN_BLUE_NOISE] = 40,
    };
    double radius = count == 1 ? 0 : sqrt(count == 2 ? 1.0 / 6 : 1.0 / 3);
    for (int i = 0; i < count; i++)
        place_at(&pattern->places[i], radius, pi * (turns_deg[kind] / 180 + 2.0 * i / count));
    weigh(pattern);
}

void pattern_make(enum cupola_pattern kind, int count, struct pattern *pattern)
{
    *pattern = (struct pattern){.count = count};
    if (count <= 3) {
        make_few(kind, count, pattern);
        return;
    }
    if (kind == CUPOLA_PATTERN_ROTATED_GRID)
        make_rotated_grid(count, pattern);
    else if (kind == CUPOLA_PATTERN_BLUE_NOISE)
        make_blue_noise(count, pattern);
    else
        make_rings(count, pattern);
    weigh(pattern);
    even_out(pattern);
}

void pattern_align(struct pattern *pattern)
{
    const struct pattern_place last = pattern->places[pattern->count - 1];
    double length = hypot(last.x, last.y);
    if (!(length > 0))
        return;
    double cosine = last.x / length, sine = last.y / length;
    for (int i = 0; i < pattern->count; i++) {
        struct pattern_place *place = &pattern->places[i];
        double x = cosine * place->x + sine * place->y;
        place->y = cosine * place->y - sine * place->x;
        place->x = x;
    }
}
