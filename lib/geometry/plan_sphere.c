/*
 * What the eyes of a sphere ask of the views: how large their rectangles are, how far their rays
 * lie off their axes, and the eye that asks for most texels. Many eyes are looked at, on the sphere
 * and inside; from the worst of them the search goes on in steps that become smaller.
 *
 * Texels are asked for at places in the image that are traced once: of a measured lens at its
 * samples, too, where its slope has kinks.
 */
#include <math.h>
#include <stdlib.h>

#include "plan_exact.h"
#include "vector.h"

/* On the sphere, and half as many at half of the radius. */
enum { EYES = 160, EYES_INSIDE = 40 };

/* Rings of an image, places on each, rings between two samples of a measured lens. */
enum { RINGS = 28, PLACES = 90, FINE_PLACES = 160, BETWEEN = 6 };

static void fill_ring(const cupola_dome *dome, int output, double r, int places,
                      struct plan_probes *probes)
{
    const struct projector *projector = &dome->projectors[output];
    for (int i = 0; i < places; i++) {
        double azimuth = 2 * pi * i / places;
        double x = projector->center_px[0] + r * projector->radius_px * cos(azimuth);
        double y = projector->center_px[1] + r * projector->radius_px * sin(azimuth), place[2];
        struct varying lens, point, *to = &probes->list[probes->count];
        struct plan_sample unused;
        if (plan_trace(dome, dome->rig.eye_m, output, x, y, &unused) < -PLAN_HALF_DIAGONAL_PX)
            continue;
        circle_place(projector, x, y, place);
        lens_ray(projector, place, &lens);
        plan_widen_collapsed(projector, place, &lens);
        screen_point(projector, &lens, &point);
        transform3(dome->tilt, point.at, to->at);
        transform3(dome->tilt, point.dx, to->dx);
        transform3(dome->tilt, point.dy, to->dy);
        probes->count++;
    }
}

/* Rings of an output: even ones, or between the samples of a measured lens. */
static int ring_count(const struct projector *projector)
{
    if (projector->lens.model == CUPOLA_LENS_TABLE)
        return (projector->lens.table.count - 1) * BETWEEN;
    return RINGS;
}

static double ring_radius(const struct projector *projector, int ring)
{
    const struct lens_table *table = &projector->lens.table;
    double most = 1, r = (double)ring / RINGS;
    if (projector->lens.model == CUPOLA_LENS_HEMISPHERIC) /* at the rim slopes may be infinite */
        most -= 0.5 / projector->radius_px;
    if (projector->lens.model == CUPOLA_LENS_TABLE) {
        int i = (ring - 1) / BETWEEN;
        double part = (double)(ring - i * BETWEEN) / BETWEEN;
        r = table->radius[i] + part * (table->radius[i + 1] - table->radius[i]);
    }
    return smaller(r, most);
}

bool plan_probes_create(const cupola_dome *dome, bool fine, struct plan_probes *probes)
{
    int places = fine ? FINE_PLACES : PLACES;
    size_t rings = 0;
    for (int g = 0; g < dome->rig.output_count; g++)
        rings += (size_t)ring_count(&dome->projectors[g]);
    probes->count = 0;
    probes->list = malloc(rings * (size_t)places * sizeof *probes->list);
    if (!probes->list)
        return false;
    for (int g = 0; g < dome->rig.output_count; g++) {
        const struct projector *projector = &dome->projectors[g];
        int step = fine || projector->lens.model != CUPOLA_LENS_TABLE ? 1 : BETWEEN / 2;
        for (int ring = step; ring <= ring_count(projector); ring += step)
            fill_ring(dome, g, ring_radius(projector, ring), places, probes);
    }
    return true;
}

void plan_probes_release(struct plan_probes *probes)
{
    free(probes->list);
    *probes = (struct plan_probes){0, NULL};
}

static int view_of(const struct plan_exact *exact, const double ray[3])
{
    int best = 0;
    double most = dot3(exact->views[0].selector, ray);
    for (int v = 1; v < exact->count; v++) {
        double product = dot3(exact->views[v].selector, ray);
        if (product > most) {
            most = product;
            best = v;
        }
    }
    return best;
}

void plan_probes_look(const struct plan_probes *probes, const struct fitting *fitting,
                      const double eye_m[3], int only, double excess[CUPOLA_VIEWS_MAX])
{
    double eye[3];
    transform3(fitting->dome->tilt, eye_m, eye);
    for (int i = 0; i < probes->count; i++) {
        struct varying ray = probes->list[i];
        for (int k = 0; k < 3; k++)
            ray.at[k] -= eye[k];
        int v = view_of(fitting->exact, ray.at);
        if (only >= 0 && v != only)
            continue;
        struct plan_sample sample;
        struct plan_metric footprint;
        double base[2];
        plan_sample_of(&ray, &sample);
        plan_footprint(fitting->exact->views[v].rotation, &sample, &footprint, base);
        excess[v] = larger(excess[v], plan_excess(&fitting->metric[v], &footprint));
    }
}

/* What is asked of a view: the largest of each is looked for. */
enum wish { WISH_WIDTH, WISH_HEIGHT, WISH_SLANT, WISH_EXCESS, WISHES };

/* The eyes that are looked at, and what asks most, of each view. */
struct sphere {
    const struct fitting *fitting;
    cupola_plan *plan; /* for its outline */
    struct plan_probes probes;
    double radius_m;
    double most[CUPOLA_VIEWS_MAX][WISHES];
    double eye[CUPOLA_VIEWS_MAX][WISHES][3]; /* as a part of the radius, from the middle */
};

static void wishes_of(const struct sphere *sphere, const double at[3], int v, double wishes[WISHES])
{
    double eye_m[3], core[4], least_cosine = 1;
    for (int i = 0; i < 3; i++)
        eye_m[i] = sphere->fitting->dome->rig.eye_m[i] + sphere->radius_m * at[i];
    wishes[WISH_WIDTH] = wishes[WISH_HEIGHT] = 0;
    if (plan_outline_core(sphere->plan, eye_m, v, core, &least_cosine)) {
        wishes[WISH_WIDTH] = core[1] - core[0];
        wishes[WISH_HEIGHT] = core[3] - core[2];
    }
    wishes[WISH_SLANT] = -least_cosine;
}

static double excess_of(const struct sphere *sphere, const double at[3], int v)
{
    double eye_m[3], excess[CUPOLA_VIEWS_MAX] = {0};
    for (int i = 0; i < 3; i++)
        eye_m[i] = sphere->fitting->dome->rig.eye_m[i] + sphere->radius_m * at[i];
    plan_probes_look(&sphere->probes, sphere->fitting, eye_m, v, excess);
    return excess[v];
}

static void learn(struct sphere *sphere, const double at[3], int v, int wish, double value)
{
    if (!(value > sphere->most[v][wish]))
        return;
    sphere->most[v][wish] = value;
    memcpy(sphere->eye[v][wish], at, sizeof sphere->eye[v][wish]);
}

static void look_from(struct sphere *sphere, const double at[3])
{
    double eye_m[3], excess[CUPOLA_VIEWS_MAX] = {0};
    for (int i = 0; i < 3; i++)
        eye_m[i] = sphere->fitting->dome->rig.eye_m[i] + sphere->radius_m * at[i];
    plan_probes_look(&sphere->probes, sphere->fitting, eye_m, -1, excess);
    for (int v = 0; v < sphere->plan->view_count; v++) {
        double wishes[WISHES];
        wishes_of(sphere, at, v, wishes);
        wishes[WISH_EXCESS] = excess[v];
        for (int wish = 0; wish < WISHES; wish++)
            learn(sphere, at, v, wish, wishes[wish]);
    }
}

/* Evenly over a sphere, along a spiral. */
static void look_all_over(struct sphere *sphere, int eyes, double part)
{
    static const double golden_rad = 2.399963229728653;
    for (int i = 0; i < eyes; i++) {
        double z = 1 - (2 * i + 1.0) / eyes, across = sqrt(1 - z * z);
        double at[3] = {part * across * cos(golden_rad * i), part * across * sin(golden_rad * i),
                        part * z};
        look_from(sphere, at);
    }
}

/* Beside an eye, as far from the middle. */
static void step_aside(const double from[3], int way, double step, double to[3])
{
    double length = length3(from), aside[3] = {0, 0, 0}, other[3];
    int least = fabs(from[0]) < fabs(from[1]) ? 0 : 1;
    if (fabs(from[2]) < fabs(from[least]))
        least = 2;
    aside[least] = 1;
    cross3(from, aside, other);
    if (way & 1) {
        cross3(from, other, aside);
        memcpy(other, aside, sizeof other);
    }
    double size = length3(other);
    for (int i = 0; i < 3; i++)
        to[i] = from[i] + (way & 2 ? -step : step) * length * other[i] / larger(size, 1e-12);
    scale3(to, length / larger(length3(to), 1e-12));
}

/* From the worst eye of a view to the worst one near it. */
static void refine(struct sphere *sphere, int v, int wish)
{
    static const double first_step = 0.12, last_step = 0.012;
    for (double step = first_step; step > last_step;) {
        double from[3], before = sphere->most[v][wish];
        memcpy(from, sphere->eye[v][wish], sizeof from);
        for (int way = 0; way < 4; way++) {
            double at[3], wishes[WISHES];
            step_aside(from, way, step, at);
            if (wish == WISH_EXCESS)
                wishes[wish] = excess_of(sphere, at, v);
            else
                wishes_of(sphere, at, v, wishes);
            learn(sphere, at, v, wish, wishes[wish]);
        }
        if (!(sphere->most[v][wish] > before + 1e-4 * fabs(before)))
            step *= 0.5;
    }
}

static void look(struct sphere *sphere)
{
    for (int v = 0; v < CUPOLA_VIEWS_MAX; v++)
        for (int wish = 0; wish < WISHES; wish++)
            sphere->most[v][wish] = -HUGE_VAL;
    look_all_over(sphere, EYES, 1);
    look_all_over(sphere, EYES_INSIDE, 0.5);
    for (int v = 0; v < sphere->plan->view_count; v++)
        for (int wish = 0; wish < WISHES; wish++)
            if (wish != WISH_SLANT)
                refine(sphere, v, wish);
}

static void conclude(const struct sphere *sphere, struct plan_sphere *result)
{
    for (int v = 0; v < sphere->plan->view_count; v++) {
        const double *most = sphere->most[v], *at = sphere->eye[v][WISH_EXCESS];
        result->extent[v][0] = most[WISH_WIDTH];
        result->extent[v][1] = most[WISH_HEIGHT];
        result->least_cosine[v] = -most[WISH_SLANT];
        result->excess[v] = most[WISH_EXCESS];
        for (int i = 0; i < 3; i++)
            result->eye_m[v][i] = sphere->fitting->dome->rig.eye_m[i] + sphere->radius_m * at[i];
    }
}

int plan_sphere_look(const struct fitting *fitting, double radius_m, struct plan_sphere *result)
{
    int status = CUPOLA_ERROR_MEMORY;
    struct sphere sphere = {.fitting = fitting, .radius_m = radius_m};
    sphere.plan = calloc(1, sizeof *sphere.plan);
    if (!sphere.plan)
        return status;
    sphere.plan->dome = *fitting->dome;
    sphere.plan->view_count = fitting->exact->count;
    for (int v = 0; v < sphere.plan->view_count; v++) {
        const struct plan_exact_view *view = &fitting->exact->views[v];
        memcpy(sphere.plan->views[v].rotation, view->rotation, sizeof view->rotation);
        memcpy(sphere.plan->views[v].selector, view->selector, sizeof view->selector);
    }
    if (plan_outline_trace(fitting->dome, &sphere.plan->outline) == CUPOLA_OK &&
        plan_probes_create(fitting->dome, false, &sphere.probes)) {
        look(&sphere);
        conclude(&sphere, result);
        status = CUPOLA_OK;
    }
    plan_probes_release(&sphere.probes);
    plan_release(sphere.plan);
    free(sphere.plan);
    return status;
}

static bool is_measured(const cupola_dome *dome)
{
    for (int g = 0; g < dome->rig.output_count; g++)
        if (dome->projectors[g].lens.model == CUPOLA_LENS_TABLE)
            return true;
    return false;
}

int plan_kinks_look(struct fitting *fitting, const struct plan_sphere *sphere, bool moves)
{
    struct plan_probes probes;
    if (!is_measured(fitting->dome))
        return CUPOLA_OK;
    if (!plan_probes_create(fitting->dome, true, &probes))
        return CUPOLA_ERROR_MEMORY;
    plan_probes_look(&probes, fitting, fitting->dome->rig.eye_m, -1, fitting->excess);
    for (int v = 0; v < fitting->exact->count && moves; v++)
        plan_probes_look(&probes, fitting, sphere->eye_m[v], -1, fitting->excess);
    plan_probes_release(&probes);
    return CUPOLA_OK;
}
