/* Theatres of many kinds: see cases.h. */
#include "cases.h"

#include <stdio.h>
#include <string.h>

#include "rig_random.h"

static const double fovs_deg[] = {90, 140, 160, 180, 220};
static const int view_counts[] = {1, 2, 3, 4, 5, 6, 8};
static const int sizes_px[][2] = {{317, 241}, {256, 256}, {320, 200}};
static const char *const eye_names[] = {"centre", "0.3 R off", "0.8 R back", "0.8 R off"};

enum { VALUES_MAX = 8, ATTEMPTS = 24, TRUNCATED = 2, MATRIX_PROPERTIES = CASE_EYE + 1 };

static const int value_counts[CASE_PROPERTIES] = {
    [CASE_LENS] = 6,  [CASE_FOV] = 5,       [CASE_LAYOUT] = 3,  [CASE_VIEWS] = 7, [CASE_SIZE] = 3,
    [CASE_EYE] = 4,   [CASE_PROJECTOR] = 3, [CASE_AIM] = 2,     [CASE_TILT] = 3,  [CASE_FLIP] = 4,
    [CASE_STAGE] = 5, [CASE_ROTATION] = 2,  [CASE_OUTPUTS] = 2, [CASE_CAP] = 2,
};

/* ---- from values to a theatre ---- */

static void build_output(const int *values, uint64_t *seed, double radius_m,
                         struct cupola_output *output)
{
    const int *size = sizes_px[values[CASE_SIZE]];
    double offset = (double[]){0.0, 0.3, 0.8}[values[CASE_PROJECTOR]];
    output->width_px = size[0];
    output->height_px = size[1];
    if (values[CASE_SIZE] == TRUNCATED)
        output->circle = (struct cupola_circle){160.25, 99.5, 160.0};
    output->lens = random_lens(seed, (enum cupola_lens_model)values[CASE_LENS],
                               radians(fovs_deg[values[CASE_FOV]]));
    output->flip = values[CASE_FLIP];
    random_in_ball(seed, offset * radius_m, output->position_m);
    if (values[CASE_AIM])
        output->aim =
            (struct cupola_aim){random_between(seed, -0.7, 0.7), random_between(seed, -0.5, 0.5),
                                random_between(seed, -3.0, 3.0)};
}

/* Away from where the first lens looks. */
static void eye_behind(struct cupola_rig *rig, double distance_m)
{
    cupola_dome *dome = NULL;
    struct cupola_ray ray;
    if (cupola_dome_create(rig, &dome, NULL) < 0)
        return;
    const struct cupola_circle *circle = &cupola_dome_rig(dome)->outputs[0].circle;
    cupola_dome_ray(dome, 0, NULL, circle->center_x_px, circle->center_y_px, &ray);
    for (int i = 0; i < 3; i++)
        rig->eye_m[i] = -distance_m * ray.lens_direction[i];
    cupola_dome_destroy(&dome);
}

static void build_case(uint64_t *seed, struct theatre_case *theatre)
{
    const int *values = theatre->values;
    struct cupola_rig *rig = &theatre->rig;
    memset(rig, 0, sizeof *rig);
    rig->screen.radius_m = random_between(seed, 0.5, 12.0);
    rig->units_per_metre = random_between(seed, 0.5, 100.0);
    rig->tilt_rad = (double[]){0.0, pi / 2.0, random_between(seed, -3.0, 3.0)}[values[CASE_TILT]];
    rig->output_count = 1 + values[CASE_OUTPUTS];
    for (int i = 0; i < rig->output_count; i++)
        build_output(values, seed, rig->screen.radius_m, &rig->outputs[i]);
    if (values[CASE_CAP])
        rig->screen.cap_rad = radians(75.0);
    if (values[CASE_EYE] == 1)
        random_in_ball(seed, 0.3 * rig->screen.radius_m, rig->eye_m);
    if (values[CASE_EYE] == 2)
        eye_behind(rig, 0.8 * rig->screen.radius_m);
    if (values[CASE_EYE] == 3)
        random_in_ball(seed, 0.8 * rig->screen.radius_m, rig->eye_m);

    theatre->stage = (enum cupola_table)values[CASE_STAGE];
    memset(&theatre->params, 0, sizeof theatre->params);
    theatre->params.layout = (enum cupola_layout)values[CASE_LAYOUT];
    theatre->params.views = view_counts[values[CASE_VIEWS]];
    theatre->params.rotation_in_projection = values[CASE_ROTATION];
}

static void describe_case(struct theatre_case *theatre)
{
    static const char *const projectors[] = {"centre", "0.3 R off", "0.8 R off"};
    const int *values = theatre->values, *size = sizes_px[values[CASE_SIZE]];
    snprintf(theatre->text, sizeof theatre->text,
             "%s %g deg, %s, %d views, %d x %d px, eye %s, projector %s, aim %d, tilt %d, flip %d, "
             "table %s, rotation %d, outputs %d, cap %d",
             cupola_lens_model_name(values[CASE_LENS]), fovs_deg[values[CASE_FOV]],
             cupola_layout_name(values[CASE_LAYOUT]), view_counts[values[CASE_VIEWS]], size[0],
             size[1], eye_names[values[CASE_EYE]], projectors[values[CASE_PROJECTOR]],
             values[CASE_AIM], values[CASE_TILT], values[CASE_FLIP],
             cupola_table_name(values[CASE_STAGE]), values[CASE_ROTATION], 1 + values[CASE_OUTPUTS],
             values[CASE_CAP]);
}

/* Whether there is such a lens at all. */
static bool lens_exists(const int *values)
{
    return values[CASE_LENS] != CUPOLA_LENS_HEMISPHERIC || fovs_deg[values[CASE_FOV]] <= 180;
}

/* The plan, or NULL where the layout cannot reach every ray; any other refusal is a failure. */
static cupola_plan *plan_case(uint64_t *seed, struct theatre_case *theatre)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    cupola_dome *dome = NULL;
    cupola_plan *plan = NULL;
    build_case(seed, theatre);
    describe_case(theatre);
    int status = cupola_dome_create(&theatre->rig, &dome, &error);
    if (status == CUPOLA_OK)
        status = cupola_plan_create(dome, &theatre->params, &plan, &error);
    cupola_dome_destroy(&dome);
    if (status < 0 && status != CUPOLA_ERROR_LAYOUT)
        fail_msg("%s: %s", theatre->text, error.message);
    return plan;
}

/* ---- pairwise ---- */

/* For every two properties and a value of each: 0 not covered yet, 1 covered, 2 refused. */
typedef char pair_table[CASE_PROPERTIES][VALUES_MAX][CASE_PROPERTIES][VALUES_MAX];

static void mark_pair(pair_table pairs, int p, int value_p, int q, int value_q, char mark)
{
    pairs[p][value_p][q][value_q] = mark;
    pairs[q][value_q][p][value_p] = mark;
}

static int mark_case(pair_table pairs, const int *values)
{
    int fresh = 0;
    for (int p = 0; p < CASE_PROPERTIES; p++)
        for (int q = p + 1; q < CASE_PROPERTIES; q++) {
            fresh += pairs[p][values[p]][q][values[q]] != 1;
            mark_pair(pairs, p, values[p], q, values[q], 1);
        }
    return fresh;
}

/* Pairs that a value of one property would cover with those that are fixed. */
static int gain(pair_table pairs, const int *values, const bool *fixed, int p, int value)
{
    int covered = 0;
    for (int q = 0; q < CASE_PROPERTIES; q++)
        covered += q != p && fixed[q] && pairs[p][value][q][values[q]] == 0;
    return covered;
}

/*
 * Fills in what is not fixed, in random order, each by the value that covers most; chance decides
 * between equals, and more and more often altogether, because what covers most may be refused.
 */
static void fill_values(pair_table pairs, uint64_t *seed, int *values, bool *fixed, int attempt)
{
    for (int left = CASE_PROPERTIES - 2; left > 0; left--) {
        int p = random_int(seed, 0, CASE_PROPERTIES - 1);
        while (fixed[p])
            p = (p + 1) % CASE_PROPERTIES;
        int best = -1;
        bool any = random_between(seed, 0.0, ATTEMPTS) < attempt;
        int first = random_int(seed, 0, value_counts[p] - 1);
        for (int k = 0; k < value_counts[p]; k++) {
            int value = (first + k) % value_counts[p];
            int covered = any ? 0 : gain(pairs, values, fixed, p, value);
            if (covered > best) {
                best = covered;
                values[p] = value;
            }
        }
        fixed[p] = true;
    }
}

/* A legal theatre with one pair; NULL if none was found. */
static cupola_plan *find_case(pair_table pairs, uint64_t *seed, const int pair[4],
                              struct theatre_case *theatre)
{
    for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
        bool fixed[CASE_PROPERTIES] = {false};
        theatre->values[pair[0]] = pair[1];
        theatre->values[pair[2]] = pair[3];
        fixed[pair[0]] = fixed[pair[2]] = true;
        fill_values(pairs, seed, theatre->values, fixed, attempt);
        if (!lens_exists(theatre->values))
            continue;
        cupola_plan *plan = plan_case(seed, theatre);
        if (plan)
            return plan;
    }
    return NULL;
}

/* Whether more are wanted. */
static bool cover_pair(pair_table pairs, uint64_t *seed, const int pair[4], case_visitor visit,
                       void *user, struct case_count *count)
{
    struct theatre_case theatre;
    if (pairs[pair[0]][pair[1]][pair[2]][pair[3]] != 0)
        return true;
    cupola_plan *plan = find_case(pairs, seed, pair, &theatre);
    if (!plan) {
        printf("refused: value %d of property %d with value %d of property %d\n", pair[1], pair[0],
               pair[3], pair[2]);
        mark_pair(pairs, pair[0], pair[1], pair[2], pair[3], 2);
        count->refused_pairs++;
        return true;
    }
    mark_case(pairs, theatre.values);
    count->cases++;
    return visit(&theatre, plan, user);
}

struct case_count cases_pairwise(uint64_t seed, case_visitor visit, void *user)
{
    static pair_table pairs;
    struct case_count count = {0};
    memset(pairs, 0, sizeof pairs);
    for (int p = 0; p < CASE_PROPERTIES; p++)
        for (int q = p + 1; q < CASE_PROPERTIES; q++)
            for (int k = 0; k < value_counts[p] * value_counts[q]; k++) {
                const int pair[4] = {p, k / value_counts[q], q, k % value_counts[q]};
                count.pairs++;
                if (!cover_pair(pairs, &seed, pair, visit, user, &count))
                    return count;
            }
    return count;
}

/* ---- the long form ---- */

struct case_count cases_matrix(uint64_t seed, case_visitor visit, void *user)
{
    struct case_count count = {0};
    int combinations = 1;
    for (int p = 0; p < MATRIX_PROPERTIES; p++)
        combinations *= value_counts[p];
    for (int number = 0; number < combinations; number++) {
        struct theatre_case theatre;
        int rest = number;
        for (int p = 0; p < CASE_PROPERTIES; p++) {
            theatre.values[p] = p < MATRIX_PROPERTIES ? rest % value_counts[p]
                                                      : random_int(&seed, 0, value_counts[p] - 1);
            rest = p < MATRIX_PROPERTIES ? rest / value_counts[p] : 0;
        }
        if (!lens_exists(theatre.values))
            continue;
        cupola_plan *plan = plan_case(&seed, &theatre);
        if (!plan)
            continue;
        count.cases++;
        if (!visit(&theatre, plan, user))
            break;
    }
    return count;
}
