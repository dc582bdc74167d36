/* The texels that are needed, for an eye. */
#include "mask.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "error.h"
#include "vector.h"

/* A view as it is used here: rows give a place in texels, homogeneous. */
struct place {
    float rows[3][3]; /* host's camera frame; x, y, depth */
    float selector[3];
};

struct marking {
    const cupola_plan *plan;
    struct mask *mask;
    struct place places[CUPOLA_VIEWS_MAX];
    float eye[3];
    float widened; /* texels */
};

static void prepare_place(const struct cupola_view *view, struct place *place)
{
    const double from[2] = {view->left, view->bottom};
    const double density[2] = {view->rect.width / (view->right - view->left),
                               view->rect.height / (view->top - view->bottom)};
    for (int k = 0; k < 3; k++) {
        double depth = -view->rotation[6 + k];
        for (int axis = 0; axis < 2; axis++)
            place->rows[axis][k] =
                (float)(density[axis] * (view->rotation[3 * axis + k] - from[axis] * depth));
        place->rows[2][k] = (float)depth;
        place->selector[k] = (float)view->selector[k];
    }
}

/*
 * Where others take over: the product of ray and selector is linear in the ray, and so, along a
 * view's plane, in the texel. Widened like the lit part.
 */
static void prepare_lines(const cupola_plan *plan, int index, double widened,
                          struct mask_texels *texels)
{
    const struct cupola_view *view = &plan->views[index];
    double width = (view->right - view->left) / view->rect.width;
    double height = (view->top - view->bottom) / view->rect.height;
    texels->line_count = 0;
    for (int other = 0; other < plan->view_count; other++) {
        double ahead[3], n[3], *line = texels->lines[texels->line_count];
        if (other == index)
            continue;
        for (int i = 0; i < 3; i++)
            ahead[i] = view->selector[i] - plan->views[other].selector[i];
        transform3(view->rotation, ahead, n);
        line[0] = n[0] * width;
        line[1] = n[1] * height;
        line[2] = n[0] * view->left + n[1] * view->bottom - n[2] +
                  widened * (fabs(line[0]) + fabs(line[1]));
        texels->line_count++;
    }
}

/*
 * Whether rays of a square may fall to a view: another one is not ahead at all corners by more than
 * half of what its lead differs between them.
 */
static bool may_fall(const float products[4], const float others[4])
{
    float least = HUGE_VALF, most = -HUGE_VALF;
    for (int i = 0; i < 4; i++) {
        float lead = others[i] - products[i];
        least = lead < least ? lead : least;
        most = lead > most ? lead : most;
    }
    return !(least > 0.5f * (most - least));
}

static void mark_row(uint64_t *row, int from, int to)
{
    int first = from / 64, last = to / 64;
    uint64_t begin = ~(uint64_t)0 << (from % 64), end = ~(uint64_t)0 >> (63 - to % 64);
    if (first == last) {
        row[first] |= begin & end;
        return;
    }
    row[first] |= begin;
    for (int i = first + 1; i < last; i++)
        row[i] = ~(uint64_t)0;
    row[last] |= end;
}

/* All whose middles are in a box: left, right, bottom, top. */
static void mark_box(struct mask_texels *texels, const float box[4])
{
    float most[2] = {(float)texels->width - 0.5f, (float)texels->height - 0.5f};
    if (!(box[0] < most[0] && box[1] > 0.5f && box[2] < most[1] && box[3] > 0.5f))
        return;
    int left = box[0] > 0.5f ? (int)ceilf(box[0] - 0.5f) : 0;
    int bottom = box[2] > 0.5f ? (int)ceilf(box[2] - 0.5f) : 0;
    int right = box[1] < most[0] ? (int)(box[1] - 0.5f) : texels->width - 1;
    int top = box[3] < most[1] ? (int)(box[3] - 0.5f) : texels->height - 1;
    if (left > right)
        return;
    for (int y = bottom; y <= top; y++)
        mark_row(texels->bits + (size_t)y * (size_t)texels->words, left, right);
}

/* The box of a square in a view; all of the view where a corner is out of its reach. */
static void mark_in_view(const struct marking *marking, const struct mask_square *square,
                         float rays[3][4], int view)
{
    const struct place *place = &marking->places[view];
    struct mask_texels *texels = &marking->mask->texels[view];
    float at[3][4], box[4] = {HUGE_VALF, -HUGE_VALF, HUGE_VALF, -HUGE_VALF};
    for (int axis = 0; axis < 3; axis++)
        for (int i = 0; i < 4; i++)
            at[axis][i] = place->rows[axis][0] * rays[0][i] + place->rows[axis][1] * rays[1][i] +
                          place->rows[axis][2] * rays[2][i];
    for (int i = 0; i < 4; i++) {
        float across = fabsf(rays[0][i]) + fabsf(rays[1][i]) + fabsf(rays[2][i]);
        if (!(at[2][i] > 0.02f * across)) {
            const float all[4] = {0, (float)texels->width, 0, (float)texels->height};
            mark_box(texels, all);
            return;
        }
        for (int axis = 0; axis < 2; axis++) {
            float texel = at[axis][i] / at[2][i];
            box[2 * axis] = texel < box[2 * axis] ? texel : box[2 * axis];
            box[2 * axis + 1] = texel > box[2 * axis + 1] ? texel : box[2 * axis + 1];
        }
    }
    for (int axis = 0; axis < 2; axis++) {
        float more = marking->widened + square->margin * (box[2 * axis + 1] - box[2 * axis]);
        box[2 * axis] -= more;
        box[2 * axis + 1] += more;
    }
    mark_box(texels, box);
}

static void mark_square(const struct marking *marking, const struct mask_square *square)
{
    int count = marking->plan->view_count;
    float rays[3][4], products[CUPOLA_VIEWS_MAX][4], most = -HUGE_VALF;
    int leading = 0;
    for (int i = 0; i < 4; i++) {
        rays[0][i] = square->x[i] - marking->eye[0];
        rays[1][i] = square->y[i] - marking->eye[1];
        rays[2][i] = square->z[i] - marking->eye[2];
    }
    for (int v = 0; v < count; v++) {
        const float *selector = marking->places[v].selector;
        for (int i = 0; i < 4; i++)
            products[v][i] =
                selector[0] * rays[0][i] + selector[1] * rays[1][i] + selector[2] * rays[2][i];
        float sum = products[v][0] + products[v][1] + products[v][2] + products[v][3];
        leading = sum > most ? v : leading;
        most = sum > most ? sum : most;
    }
    for (int v = 0; v < count; v++)
        if (v == leading || may_fall(products[v], products[leading]))
            mark_in_view(marking, square, rays, v);
}

static void mark(const cupola_plan *plan, struct mask *mask)
{
    double eye[3], widened = plan->guard_px + MASK_SLACK_TEXELS;
    struct marking marking = {.plan = plan, .mask = mask, .widened = (float)widened};
    transform3(plan->dome.tilt, plan->dome.rig.eye_m, eye);
    for (int i = 0; i < 3; i++)
        marking.eye[i] = (float)eye[i];
    for (int v = 0; v < plan->view_count; v++) {
        struct mask_texels *texels = &mask->texels[v];
        prepare_place(&plan->views[v], &marking.places[v]);
        prepare_lines(plan, v, widened, texels);
        memset(texels->bits, mask->whole ? 255 : 0,
               (size_t)texels->words * (size_t)texels->height * sizeof *texels->bits);
    }
    for (int i = 0; i < mask->square_count; i++)
        mark_square(&marking, &mask->squares[i]);
}

void mask_refit(const cupola_plan *plan, struct mask *mask)
{
    mark(plan, mask);
    mask->vertex_count = 0;
    for (int v = 0; v < plan->view_count; v++)
        mask_shapes_add(mask, v);
}

static bool create_texels(const cupola_plan *plan, struct mask *mask)
{
    for (int v = 0; v < plan->view_count; v++) {
        struct mask_texels *texels = &mask->texels[v];
        texels->x = plan->views[v].rect.x;
        texels->y = plan->views[v].rect.y;
        texels->width = plan->views[v].rect.width;
        texels->height = plan->views[v].rect.height;
        texels->words = texels->width / 64 + 1;
        texels->bits =
            malloc((size_t)texels->words * (size_t)texels->height * sizeof *texels->bits);
        if (!texels->bits)
            return false;
    }
    return true;
}

/* Other eyes may need more shapes. */
static bool make_room(struct mask *mask)
{
    int most = 2 * mask->vertex_count + 600;
    void *more = realloc(mask->vertices, (size_t)most * sizeof *mask->vertices);
    if (!more)
        return false;
    mask->vertices = more;
    mask->vertex_most = most;
    return true;
}

int mask_create(const cupola_plan *plan, bool middles, struct mask *mask,
                struct cupola_error *error)
{
    *mask = (struct mask){.middles = middles, .growing = true};
    bool done = create_texels(plan, mask) && mask_squares_cut(plan, mask);
    if (done) {
        mask_refit(plan, mask);
        done = !mask->failed && make_room(mask);
    }
    mask->growing = false;
    if (done)
        return CUPOLA_OK;
    mask_destroy(mask);
    return error_set(error, CUPOLA_ERROR_MEMORY, "no memory for the mask of a plan's views");
}

void mask_settle(struct mask *mask)
{
    for (int v = 0; v < CUPOLA_VIEWS_MAX; v++) {
        free(mask->texels[v].bits);
        mask->texels[v].bits = NULL;
    }
    free(mask->squares);
    free(mask->vertices);
    mask->squares = NULL;
    mask->vertices = NULL;
}

void mask_destroy(struct mask *mask)
{
    mask_settle(mask);
    *mask = (struct mask){0};
}
