/* Loads by name, and one that costs what is wished. */
#include "load.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TRIAL_FRAMES = 15, TRIAL_MOST_PX = 1024 };

struct trial {
    int size_px;
    enum clock clock;
};

/* What a pixel of the plain view costs; below 0 with one line in `message`. */
static double cost_ns(const struct load *load, const struct trial *trial, char *message)
{
    struct setting setting = {
        .size_px = trial->size_px, .fov_rad = 140 * 3.14159265358979323846 / 180, .load = *load};
    const struct contender plain = {"perspective", &contender_plain_view, 0};
    const struct comparison_wishes wishes = {
        .frames = TRIAL_FRAMES, .warm_up = 2, .clock = trial->clock};
    struct result result;
    struct scene *scene = setting_scene(load, message);
    double cost = -1;

    if (!scene)
        return -1;
    if (setting_create(&setting, scene, message)) {
        if (compare_contenders(&setting, &plain, 1, &wishes, NULL, &result, message))
            cost = 1e6 * result.time_ms.median / ((double)trial->size_px * trial->size_px);
        setting_destroy(&setting);
    }
    scene->destroy(scene);
    return cost;
}

/*
 * From the dearest on: the first takes as many lamps as are wished. All of them cost the same
 * wherever a pixel looks, so that texels of a dome's views cost what the plain view's pixels do.
 */
enum { KINDS = 4, MANY = 17 };
static const struct scene_wishes kinds[KINDS] = {
    {.shading = SCENE_HEAVY, .lamps = 1, .smooth = true, .anisotropy = 1, .one_level = true},
    {.shading = SCENE_HEAVY, .lamps = -1, .smooth = true, .anisotropy = 1, .one_level = true},
    {.shading = SCENE_LAMBERT, .anisotropy = 1, .one_level = true},
    {.shading = SCENE_FLAT, .anisotropy = 1, .one_level = true},
};

/* The number of lamps that makes the first kind cost what is wished; `one_ns` is that of one. */
static bool find_lamps(double wished_ns, double one_ns, const struct trial *trial,
                       struct load *load, char *message)
{
    double many_ns, lamps;

    load->wishes = kinds[0];
    load->wishes.lamps = MANY;
    many_ns = cost_ns(load, trial, message);
    if (many_ns < 0)
        return false;
    lamps = 1 + (wished_ns - one_ns) / fmax((many_ns - one_ns) / (MANY - 1), 1e-3);
    load->wishes.lamps = (int)lround(fmin(fmax(lamps, 1), SCENE_LAMPS_MAX));
    return true;
}

/* The kind that comes nearest to a cost. */
static bool find_cost(double wished_ns, const struct trial *trial, struct load *load, char *message)
{
    double found_ns[KINDS];
    int nearest = 0;

    for (int kind = 0; kind < KINDS; kind++) {
        load->wishes = kinds[kind];
        found_ns[kind] = cost_ns(load, trial, message);
        if (found_ns[kind] <= 0)
            return false;
        if (kind == 0 && found_ns[kind] <= wished_ns)
            return find_lamps(wished_ns, found_ns[kind], trial, load, message);
        if (fabs(log(found_ns[kind] / wished_ns)) < fabs(log(found_ns[nearest] / wished_ns)))
            nearest = kind;
    }
    load->wishes = kinds[nearest];
    return true;
}

/* The whole number after the colon, within bounds. */
static bool number_after(const char *colon, int least, int most, int *number, char *message)
{
    char *end = NULL;
    long value = strtol(colon + 1, &end, 10);

    if (end == colon + 1 || *end || value < least || value > most) {
        snprintf(message, MESSAGE_SIZE, "a load has '%s'; allowed: whole numbers, %d to %d",
                 colon + 1, least, most);
        return false;
    }
    *number = (int)value;
    return true;
}

/* A load by its name; or what a pixel shall cost, ns, where that is wished, else 0. */
static bool read_load(const char *name, struct load *load, int *wished_ns, char *message)
{
    const char *colon = strchr(name, ':');
    size_t length = colon ? (size_t)(colon - name) : strlen(name);
    char kind[16] = "";

    memset(load, 0, sizeof *load);
    *wished_ns = 0;
    snprintf(load->name, sizeof load->name, "%s", name);
    snprintf(kind, sizeof kind, "%.*s", (int)length, name);
    if (strcmp(kind, "light") == 0 && !colon) {
        load->wishes.anisotropy = 1;
        return true;
    }
    if (strcmp(kind, "directions") == 0 && !colon) {
        load->kind = SCENE_DIRECTIONS;
        return true;
    }
    if (strcmp(kind, "lambert") == 0 && !colon) {
        load->wishes.shading = SCENE_LAMBERT;
        return true;
    }
    if (strcmp(kind, "heavy") == 0) {
        load->wishes.shading = SCENE_HEAVY;
        load->wishes.lamps = SCENE_LAMPS;
        return !colon || number_after(colon, 1, SCENE_LAMPS_MAX, &load->wishes.lamps, message);
    }
    if (strcmp(kind, "forest") == 0) {
        load->kind = SCENE_FOREST;
        load->wishes.triangles = SCENE_TRIANGLES;
        return !colon || number_after(colon, SCENE_TRIANGLES_MIN, SCENE_TRIANGLES_MAX,
                                      &load->wishes.triangles, message);
    }
    if (strcmp(kind, "ns") == 0 && colon)
        return number_after(colon, 1, 1000000, wished_ns, message);
    snprintf(message, MESSAGE_SIZE,
             "there is no load '%s'; there are light, lambert, directions, heavy[:LAMPS], "
             "forest[:TRIANGLES] and ns:COST",
             name);
    return false;
}

bool load_check(const char *name, char *message)
{
    struct load load;
    int wished_ns;

    return read_load(name, &load, &wished_ns, message);
}

bool loads_check(const char *const *names, int count, char *message)
{
    char problem[MESSAGE_SIZE];

    for (int i = 0; i < count; i++)
        if (!load_check(names[i], problem)) {
            snprintf(message, MESSAGE_SIZE, "--load %.40s: %.200s", names[i], problem);
            return false;
        }
    return true;
}

bool load_find(const char *name, const struct comparison_wishes *wishes, int size_px,
               struct load *load, char *message)
{
    struct trial trial = {size_px < TRIAL_MOST_PX ? size_px : TRIAL_MOST_PX, wishes->clock};
    int wished_ns;

    return read_load(name, load, &wished_ns, message) &&
           (wished_ns == 0 || find_cost(wished_ns, &trial, load, message));
}
