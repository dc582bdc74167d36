/*
 * What a candidate costs, on the samples: the shaded texels of each view, what is allocated, a
 * price for each view and one for the objects that are drawn into more than one.
 */
#include <stdlib.h>

#include "plan.h"
#include "vector.h"

/* Of the objects that a host culls; see struct cupola_cost. */
static const double object_radius_rad = 2 * (pi / 180);

bool plan_state_create(int samples, struct plan_state *state)
{
    *state = (struct plan_state){.cost = HUGE_VAL};
    state->members = malloc((size_t)samples * sizeof *state->members);
    return state->members != NULL;
}

void plan_state_release(struct plan_state *state)
{
    free(state->members);
    *state = (struct plan_state){.cost = HUGE_VAL};
}

void plan_state_copy(const struct plan_state *from, int samples, struct plan_state *to)
{
    struct plan_member *members = to->members;
    memcpy(members, from->members, (size_t)samples * sizeof *members);
    *to = *from;
    to->members = members;
}

bool plan_scratch_create(int samples, struct plan_scratch *scratch)
{
    scratch->footprints = malloc((size_t)samples * sizeof *scratch->footprints);
    scratch->base = malloc(((size_t)samples + PLAN_MEETINGS_MAX) * sizeof *scratch->base);
    if (scratch->footprints && scratch->base)
        return true;
    plan_scratch_release(scratch);
    return false;
}

void plan_scratch_release(struct plan_scratch *scratch)
{
    free(scratch->footprints);
    free(scratch->base);
    *scratch = (struct plan_scratch){.footprints = NULL};
}

/* Some orientation that looks along an axis; its roll is chosen later. */
void plan_look_along(const double axis[3], double rotation[9])
{
    double side[3] = {0, 0, 0}, right[3], up[3];
    int least = fabs(axis[1]) <= fabs(axis[0]) ? 1 : 0;
    if (fabs(axis[2]) < fabs(axis[least]))
        least = 2;
    side[least] = 1;
    cross3(axis, side, right);
    scale3(right, 1 / length3(right));
    cross3(right, axis, up);
    for (int i = 0; i < 3; i++) {
        rotation[i] = right[i];
        rotation[3 + i] = up[i];
        rotation[6 + i] = -axis[i];
    }
}

/*
 * With c the product of axis and ray, a step along u on the base plane changes the ray by c times
 * `right`, and by something along the ray itself, where x_of and y_of have no part.
 */
void plan_footprint(const double rotation[9], const struct plan_sample *sample,
                    struct plan_metric *footprint, double base[2])
{
    double c = -dot3(rotation + 6, sample->at), per_c = 1 / c;
    double xu = c * dot3(sample->x_of, rotation), xv = c * dot3(sample->x_of, rotation + 3);
    double yu = c * dot3(sample->y_of, rotation), yv = c * dot3(sample->y_of, rotation + 3);
    base[0] = dot3(rotation, sample->at) * per_c;
    base[1] = dot3(rotation + 3, sample->at) * per_c;
    footprint->uu = xu * xu + yu * yu;
    footprint->uv = xu * xv + yu * yv;
    footprint->vv = xv * xv + yv * yv;
}

static void fit_core(const struct plan_scratch *scratch, int count, const double turn[2],
                     struct plan_view_fit *fit)
{
    fit->core[0] = fit->core[2] = HUGE_VAL;
    fit->core[1] = fit->core[3] = -HUGE_VAL;
    for (int i = 0; i < count; i++) {
        const double *base = scratch->base[i];
        double u = turn[0] * base[0] + turn[1] * base[1];
        double v = turn[0] * base[1] - turn[1] * base[0];
        fit->core[0] = smaller(fit->core[0], u);
        fit->core[1] = larger(fit->core[1], u);
        fit->core[2] = smaller(fit->core[2], v);
        fit->core[3] = larger(fit->core[3], v);
    }
}

void plan_price_view(const struct plan_prices *prices, double short_px, struct plan_view_fit *fit)
{
    const double *core = fit->core;
    double width = (core[1] - core[0]) * fit->density[0];
    double height = (core[3] - core[2]) * fit->density[1];
    double guard = 2 * prices->guard_px, texels = fit->density[0] * fit->density[1];
    double more = guard + short_px * prices->density;
    fit->rect = (width + more) * (height + more);
    /* A shape without dents, widened by a square, gains its rectangle's sides. */
    double sampled = fit->area * texels + guard * (width + height + guard);
    fit->shaded = prices->unmasked ? fit->rect : smaller(sampled, fit->rect);
    fit->cost = fit->shaded + prices->allocated * fit->rect;
}

/*
 * Roll, densities and rectangle of a view with this metric. Whole rectangles may be smaller for a
 * roll that is not the metric's own, and where it is round it says nothing about roll: then the
 * roll of least cost is kept.
 */
static void fit_rect(const struct plan_prices *prices, const struct plan_scratch *scratch,
                     int count, double short_px, const struct plan_metric *x,
                     struct plan_view_fit *fit)
{
    double own = plan_roll_of(x), roll = own, least = HUGE_VAL;
    int rolls = plan_rolls_freely(prices, x) ? PLAN_ROLLS : 1;
    for (int i = 0; i < rolls; i++) {
        struct plan_view_fit rolled = *fit;
        double angle = own + 0.5 * pi * i / PLAN_ROLLS, turn[2] = {cos(angle), sin(angle)};
        struct plan_metric d = plan_enclose_rolled(x, angle);
        rolled.density[0] = prices->density * sqrt(d.uu);
        rolled.density[1] = prices->density * sqrt(d.vv);
        fit_core(scratch, count, turn, &rolled);
        plan_price_view(prices, short_px, &rolled);
        if (rolled.cost < 0.999 * least) {
            least = rolled.cost;
            roll = angle;
            *fit = rolled;
        }
    }
    plan_roll_by(roll, fit->rotation);
}

/* Where a view meets others, on its base plane. Returns the number of places. */
static int meet_base(const struct plan_meetings *meetings, const double rotation[9], int v,
                     double (*base)[2])
{
    int count = 0;
    for (int i = 0; i < meetings->count; i++) {
        const struct plan_meeting *meeting = &meetings->list[i];
        double c = -dot3(rotation + 6, meeting->at);
        if (!(meeting->views >> v & 1) || c < 0.1)
            continue;
        base[count][0] = dot3(rotation, meeting->at) / c;
        base[count++][1] = dot3(rotation + 3, meeting->at) / c;
    }
    return count;
}

static void orient(const struct plan_state *state, int v, double rotation[9])
{
    if (state->orientation)
        memcpy(rotation, state->orientation, 9 * sizeof *rotation);
    else
        plan_look_along(state->views[v].axis, rotation);
}

/* Fits one view to the samples that fall to it: roll, densities, rectangle. */
static void fit_view(const struct plan_samples *samples, const struct plan_prices *prices, int v,
                     struct plan_scratch *scratch, struct plan_state *state)
{
    struct plan_view_fit *fit = &state->fits[v];
    double least = 1;
    int count = 0, bases = 0;
    *fit = (struct plan_view_fit){.samples = 0};
    orient(state, v, fit->rotation);
    for (int i = 0; i < samples->count; i++) {
        const struct plan_member *member = &state->members[i];
        const struct plan_sample *sample = &samples->list[i];
        if (member->view != v && (member->next != v || (member->part == 1 && member->shared == 0)))
            continue;
        double c = -dot3(fit->rotation + 6, sample->at);
        double part = member->view == v ? member->part : 1 - member->part;
        fit->area += part * sample->solid_angle / larger(c * c * c, 1e-3);
        fit->drawn +=
            sample->solid_angle * (member->view == v ? 1 + member->others : member->shared);
        if (member->view != v && member->part == 1)
            continue; /* objects reach over, the sample does not */
        /* A sample that the border cuts counts for both: its extremes may lie on either side. */
        least = smaller(least, c);
        plan_footprint(fit->rotation, sample, &scratch->footprints[count], scratch->base[bases]);
        count++;
        bases += member->view == v || samples->edge_count == 0;
        fit->samples += member->view == v;
    }
    fit->out_of_reach = larger(prices->reach_cosine - 1e-9 - least, 0);
    if (fit->samples == 0 || fit->out_of_reach > 0)
        return;
    bases += meet_base(&scratch->meetings, fit->rotation, v, scratch->base + bases);
    if (state->orientation) {
        static const double level[2] = {1, 0};
        struct plan_metric x = plan_enclose_upright(scratch->footprints, count);
        fit->density[0] = prices->density * sqrt(x.uu);
        fit->density[1] = prices->density * sqrt(x.vv);
        fit_core(scratch, bases, level, fit);
        plan_price_view(prices, samples->short_px, fit);
    } else {
        struct plan_metric x = plan_enclose(scratch->footprints, count);
        fit_rect(prices, scratch, bases, samples->short_px, &x, fit);
    }
}

static void add_up(const struct plan_prices *prices, struct plan_state *state)
{
    double out_of_reach = 0, drawn = 0;
    bool empty = false;
    state->shaded = state->rect = 0;
    for (int v = 0; v < state->count; v++) {
        const struct plan_view_fit *fit = &state->fits[v];
        state->shaded += fit->shaded;
        state->rect += fit->rect;
        drawn += fit->drawn;
        out_of_reach += fit->out_of_reach;
        empty = empty || fit->samples == 0;
    }
    state->drawn_cost = prices->vertices * drawn / (4 * pi);
    state->cost = state->shaded + prices->allocated * state->rect + prices->view * state->count +
                  state->drawn_cost;
    if (out_of_reach > 0)
        state->cost = PLAN_IMPOSSIBLE * (1 + out_of_reach);
    if (empty)
        state->cost = HUGE_VAL;
}

/* Of what a sample stands for, the part whose objects reach over the border into view v. */
static double shared_part(const struct plan_state *state, const struct plan_sample *sample,
                          const struct plan_member *member, int v)
{
    const double *a = state->views[member->view].selector, *b = state->views[v].selector;
    double apart[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    double distance = dot3(apart, sample->at), width = 2 * sample->reach_rad;
    double over = object_radius_rad + sample->reach_rad - distance / larger(length3(apart), 1e-12);
    if (!(over > 0 && width > 0))
        return 0;
    return smaller(over, smaller(object_radius_rad, width)) / width;
}

/* The first and second choice of a sample, and how it is divided between them. */
static void select_views(const struct plan_state *state, const struct plan_sample *sample,
                         bool objects, struct plan_member *member)
{
    *member = (struct plan_member){.product = -HUGE_VAL, .next_product = -HUGE_VAL, .part = 1};
    for (int v = 0; v < state->count; v++) {
        double product = dot3(state->views[v].selector, sample->at);
        if (product > member->product) {
            member->next = member->view;
            member->next_product = member->product;
            member->view = v;
            member->product = product;
        } else if (product > member->next_product) {
            member->next = v;
            member->next_product = product;
        }
    }
    if (state->count == 1)
        return;
    const double *a = state->views[member->view].selector;
    const double *b = state->views[member->next].selector;
    double apart[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    double excess = member->product - member->next_product;
    double across = 2 * length3(apart) * sample->reach_rad;
    member->part = excess < 0.5 * across ? 0.5 + excess / across : 1;
    for (int v = 0; v < state->count && objects; v++)
        if (v != member->view)
            *(v == member->next ? &member->shared : &member->others) +=
                shared_part(state, sample, member, v);
}

double plan_drawn(const struct plan_samples *samples, const struct plan_state *state)
{
    double drawn = 0;
    for (int i = 0; i < samples->count; i++) {
        struct plan_member member;
        select_views(state, &samples->list[i], true, &member);
        drawn += samples->list[i].solid_angle * (1 + member.shared + member.others);
    }
    return drawn / (4 * pi);
}

void plan_evaluate(const struct plan_samples *samples, const struct plan_prices *prices,
                   struct plan_scratch *scratch, struct plan_state *state)
{
    for (int i = 0; i < samples->count; i++)
        select_views(state, &samples->list[i], prices->vertices > 0, &state->members[i]);
    plan_meet(samples, state, &scratch->meetings);
    for (int v = 0; v < state->count; v++)
        fit_view(samples, prices, v, scratch, state);
    add_up(prices, state);
}

void plan_reevaluate(const struct plan_samples *samples, const struct plan_prices *prices,
                     struct plan_scratch *scratch, int changed, struct plan_state *state)
{
    unsigned touched = 1u << changed;
    for (int i = 0; i < samples->count; i++) {
        struct plan_member *member = &state->members[i];
        if (member->view != changed && member->next != changed &&
            dot3(state->views[changed].selector, samples->list[i].at) <= member->next_product)
            continue;
        struct plan_member before = *member;
        select_views(state, &samples->list[i], prices->vertices > 0, member);
        if (member->view != before.view || member->part != before.part ||
            member->shared != before.shared || member->others != before.others)
            touched |=
                1u << before.view | 1u << before.next | 1u << member->view | 1u << member->next;
    }
    plan_meet(samples, state, &scratch->meetings);
    for (int v = 0; v < state->count; v++)
        if (touched & 1u << v)
            fit_view(samples, prices, v, scratch, state);
    add_up(prices, state);
}
