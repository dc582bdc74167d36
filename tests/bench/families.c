/* Families of comparisons, and who takes part in each. */
#include "families.h"

#include <string.h>

#include "json.h"

/* Whole frames: everything that makes a dome's picture, in plain views. */
static const struct contender frame_contenders[] = {
    {"perspective", &contender_plain_view, 0},
    {"blit", &contender_blit, BLIT_STRAIGHT},
    {"cupola", &contender_cupola, 0},
    {"cupola-one-pass", &contender_one_pass, CUPOLA_CHOICE},
    {"cupola-unmasked", &contender_cupola, CUPOLA_UNMASKED},
    {"cupola-vertices", &contender_cupola, CUPOLA_SAVES_VERTICES},
    {"cupola-3-views", &contender_cupola, 3},
    {"cupola-5-views", &contender_cupola, 5},
    {"cupola-7-views", &contender_cupola, 7},
    {"control", &contender_control, 0},
    {"four-faces", &contender_cube, CUBE_4_TRIGONOMETRY},
    {"six-faces", &contender_cube, CUBE_6_TRIGONOMETRY},
    {"six-faces-mesh", &contender_cube, CUBE_6_MESH},
    {"three-frusta", &contender_frusta, 0},
};

/* Where a frame's time goes: clears alone, views without a warp, a warp without views. */
static const struct contender part_contenders[] = {
    {"perspective", &contender_plain_view, 0},
    {"perspective-clear", &contender_plain_clear, 0},
    {"blit", &contender_blit, BLIT_STRAIGHT},
    {"cupola", &contender_cupola, 0},
    {"cupola-clear", &contender_cupola_clear, 0},
    {"cupola-views", &contender_cupola_views, 0},
    {"cupola-warp", &contender_cupola_warp, 0},
    {"cupola-unmasked", &contender_cupola, CUPOLA_UNMASKED},
    {"cupola-unmasked-clear", &contender_cupola_clear, CUPOLA_UNMASKED},
    {"cupola-unmasked-views", &contender_cupola_views, CUPOLA_UNMASKED},
};

enum {
    PART_CONTENDERS = sizeof part_contenders / sizeof *part_contenders,
    FRAME_CONTENDERS = sizeof frame_contenders / sizeof *frame_contenders,
};

static bool take_scene(struct bench *bench, const struct load *load)
{
    if (bench->scene && memcmp(&bench->load, load, sizeof *load) == 0)
        return true;
    if (bench->scene)
        bench->scene->destroy(bench->scene);
    bench->load = *load;
    bench->scene = setting_scene(load, bench->message);
    return bench->scene;
}

/* The first, and those of the others that are wished for; how many. */
static int choose(struct bench *bench, const struct contender *all, int count,
                  struct contender chosen[CONTENDERS_MAX])
{
    const struct options *options = &bench->options;
    int kept = 1;

    chosen[0] = all[0];
    for (int i = 1; i < count; i++) {
        bool wished = options->contender_count == 0;
        for (int k = 0; k < options->contender_count; k++)
            wished |= strcmp(options->contenders[k], all[i].name) == 0;
        if (wished)
            chosen[kept++] = all[i];
    }
    bench->others += kept - 1;
    return kept;
}

/* Draws, measures and writes one comparison. */
static bool compare(struct bench *bench, struct setting *setting,
                    const struct json_heading *heading, const struct contender *all, int count)
{
    struct contender contenders[CONTENDERS_MAX];
    struct comparison_wishes wishes = bench->options.wishes;
    struct reference reference = {0}, *wished = bench->options.no_quality ? NULL : &reference;
    struct result results[CONTENDERS_MAX];
    bool done;

    count = choose(bench, all, count, contenders);
    wishes.warp_alone = strcmp(heading->family, family_names[FAMILY_WARP]) == 0 ||
                        strcmp(heading->family, family_names[FAMILY_FILTERS]) == 0 ||
                        strcmp(heading->family, family_names[FAMILY_EYE]) == 0;
    if (!take_scene(bench, &setting->load) ||
        !setting_create(setting, bench->scene, bench->message))
        return false;
    fprintf(stderr, "%s: %d px, %s %.0f degrees%s, %s\n", heading->family, setting->size_px,
            cupola_lens_model_name(setting->lens), setting->fov_rad * 180 / 3.14159265358979323846,
            setting->off_axis ? ", off axis" : "", setting->load.name);
    done = (!wished || reference_create(&reference, setting, bench->message)) &&
           compare_contenders(setting, contenders, count, &wishes, wished, results, bench->message);
    if (done)
        json_comparison(bench->file, bench->comparisons++ == 0, heading, setting, wished,
                        contenders, count, results);
    reference_destroy(&reference);
    setting_destroy(setting);
    return done;
}

static struct setting first_setting(const struct options *options)
{
    return (struct setting){.size_px = options->sizes_px[0],
                            .lens = options->lenses[0],
                            .fov_rad = options->fovs_deg[0] * 3.14159265358979323846 / 180,
                            .gl = {.table = (enum cupola_table)options->table}};
}

typedef bool family_one(struct bench *bench, struct setting *setting);

/* Calls for every combination of sizes, fields of view and lenses. */
static bool each_setting(struct bench *bench, family_one *one)
{
    const struct options *options = &bench->options;

    for (int size = 0; size < options->size_count; size++)
        for (int lens = 0; lens < options->lens_count; lens++)
            for (int fov = 0; fov < options->fov_count; fov++) {
                struct setting setting = first_setting(options);
                setting.size_px = options->sizes_px[size];
                setting.lens = options->lenses[lens];
                setting.fov_rad = options->fovs_deg[fov] * 3.14159265358979323846 / 180;
                if (setting.lens == CUPOLA_LENS_HEMISPHERIC && options->fovs_deg[fov] > 180)
                    continue;
                if (!one(bench, &setting))
                    return false;
            }
    return true;
}

/* Every stage that the library has, and the passes of the others, in blits. */
static bool warp_one(struct bench *bench, struct setting *setting)
{
    struct contender contenders[CONTENDERS_MAX] = {{"blit", &contender_blit, BLIT_STRAIGHT}};
    int count = 1;

    contenders[count++] = (struct contender){"blit-turned", &contender_blit, BLIT_TURNED};
    contenders[count++] =
        (struct contender){"blit-turned-small", &contender_blit, BLIT_TURNED_SMALL};
    for (int i = 0; i < 20 && cupola_table_name(i); i++) {
        struct contender *stage = &contenders[count++];
        *stage = (struct contender){.kind = &contender_stage, .variant = i};
        snprintf(stage->name, sizeof stage->name, "%.31s", cupola_table_name(i));
    }
    contenders[count++] = (struct contender){"four-faces", &contender_cube, CUBE_4_TRIGONOMETRY};
    contenders[count++] = (struct contender){"six-faces-mesh", &contender_cube, CUBE_6_MESH};
    contenders[count++] = (struct contender){"three-frusta", &contender_frusta, 0};
    for (int off_axis = 0; off_axis < 2; off_axis++) {
        setting->off_axis = off_axis;
        if (!load_find(bench->options.loads[0], &bench->options.wishes, setting->size_px,
                       &setting->load, bench->message) ||
            !compare(bench, setting, &(struct json_heading){.family = family_names[FAMILY_WARP]},
                     contenders, count))
            return false;
    }
    return true;
}

/* Every way of antialiasing, in blits. */
static bool filters_one(struct bench *bench, struct setting *setting)
{
    struct contender contenders[1 + FILTER_CONTENDERS] = {{"blit", &contender_blit, 0}};
    int count = 1 + contender_filters(bench->options.samples, contenders + 1);

    return load_find(bench->options.loads[0], &bench->options.wishes, setting->size_px,
                     &setting->load, bench->message) &&
           compare(bench, setting, &(struct json_heading){.family = family_names[FAMILY_FILTERS]},
                   contenders, count);
}

/* Every stage with the viewer at rest, having moved, and moving before every warp. */
static bool eye_one(struct bench *bench, struct setting *setting)
{
    struct contender contenders[CONTENDERS_MAX] = {{"blit", &contender_blit, BLIT_STRAIGHT}};
    int count = 1;

    for (int i = 0; i < 9 && cupola_table_name(i); i++, count += 3) {
        struct contender *three = &contenders[count];
        three[0] = (struct contender){.kind = &contender_resting, .variant = i};
        three[1] = (struct contender){.kind = &contender_moved, .variant = i};
        three[2] = (struct contender){.kind = &contender_moving, .variant = i};
        snprintf(three[0].name, sizeof three[0].name, "%.20s", cupola_table_name(i));
        snprintf(three[1].name, sizeof three[1].name, "%.20s-moved", cupola_table_name(i));
        snprintf(three[2].name, sizeof three[2].name, "%.20s-moving", cupola_table_name(i));
    }
    contenders[count++] =
        (struct contender){"clear", &contender_resting_clear, CUPOLA_TABLE_POINTS};
    contenders[count++] =
        (struct contender){"clear-moving", &contender_moving_clear, CUPOLA_TABLE_POINTS};
    setting->off_axis = true;
    return load_find(bench->options.loads[0], &bench->options.wishes, setting->size_px,
                     &setting->load, bench->message) &&
           compare(bench, setting, &(struct json_heading){.family = family_names[FAMILY_EYE]},
                   contenders, count);
}

/* One comparison for each load. */
static bool each_load(struct bench *bench, const struct setting *setting, enum family family,
                      const struct contender *contenders, int count)
{
    for (int i = 0; i < bench->options.load_count; i++) {
        struct setting loaded = *setting;
        if (!load_find(bench->options.loads[i], &bench->options.wishes, loaded.size_px,
                       &loaded.load, bench->message) ||
            !compare(bench, &loaded, &(struct json_heading){.family = family_names[family]},
                     contenders, count))
            return false;
    }
    return true;
}

static bool frame_one(struct bench *bench, struct setting *setting)
{
    return each_load(bench, setting, FAMILY_FRAME, frame_contenders, FRAME_CONTENDERS);
}

static bool parts_one(struct bench *bench, struct setting *setting)
{
    return each_load(bench, setting, FAMILY_PARTS, part_contenders, PART_CONTENDERS);
}

/* Frames against one thing that varies: the load by its number, or the size. */
static bool sweep(struct bench *bench, enum family family, const char *load, const int *values)
{
    for (; *values; values++) {
        struct setting setting = first_setting(&bench->options);
        struct json_heading heading = {family_names[family], family_names[family], *values};
        char name[32];

        snprintf(name, sizeof name, "%.20s:%d", load, *values);
        if (family == FAMILY_SIZE) {
            setting.size_px = *values;
            snprintf(name, sizeof name, "%.31s", load);
        }
        if (!load_find(name, &bench->options.wishes, setting.size_px, &setting.load,
                       bench->message) ||
            !compare(bench, &setting, &heading, frame_contenders, FRAME_CONTENDERS))
            return false;
    }
    return true;
}

/* As many views as the library allows, side by side. */
static bool views(struct bench *bench)
{
    struct contender contenders[CUPOLA_VIEWS_MAX + 1] = {frame_contenders[0]};

    for (int i = 1; i <= CUPOLA_VIEWS_MAX; i++) {
        contenders[i] = (struct contender){.kind = &contender_cupola, .variant = i};
        snprintf(contenders[i].name, sizeof contenders[i].name, "cupola-%d-views", i);
    }
    for (int i = 0; i < bench->options.load_count; i++) {
        struct setting setting = first_setting(&bench->options);
        if (!load_find(bench->options.loads[i], &bench->options.wishes, setting.size_px,
                       &setting.load, bench->message) ||
            !compare(bench, &setting,
                     &(struct json_heading){family_names[FAMILY_VIEWS], "views", 0}, contenders,
                     CUPOLA_VIEWS_MAX + 1))
            return false;
    }
    return true;
}

bool family_run(struct bench *bench, enum family family)
{
    static const int lamps[] = {1, 2, 4, 8, 16, 32, 64, 0};
    static const int triangles[] = {1000, 10000, 100000, 1000000, 0};
    static const int usual_px[] = {512, 1024, 2048, 4096, 0};
    const struct options *options = &bench->options;

    switch (family) {
    case FAMILY_WARP:
        return each_setting(bench, warp_one);
    case FAMILY_FILTERS:
        return each_setting(bench, filters_one);
    case FAMILY_EYE:
        return each_setting(bench, eye_one);
    case FAMILY_FRAME:
        return each_setting(bench, frame_one);
    case FAMILY_PARTS:
        return each_setting(bench, parts_one);
    case FAMILY_LAMPS:
        return sweep(bench, family, "heavy", lamps);
    case FAMILY_TRIANGLES:
        return sweep(bench, family, "forest", triangles);
    case FAMILY_VIEWS:
        return views(bench);
    case FAMILY_SIZE:
        return sweep(bench, family, options->load_given ? options->loads[0] : "heavy",
                     options->size_count > 1 ? options->sizes_px : usual_px);
    case FAMILIES:
        break;
    }
    return true;
}

bool family_has(const char *name)
{
    static const char *const others[] = {"blit-turned", "blit-turned-small", "clear",
                                         "clear-moving"};
    static const char *const states[] = {"", "-moved", "-moving"};
    int views = 0, length = 0;

    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (strcmp(name, others[i]) == 0)
            return true;
    for (int i = 0; i < FRAME_CONTENDERS; i++)
        if (strcmp(name, frame_contenders[i].name) == 0)
            return true;
    for (int i = 0; i < PART_CONTENDERS; i++)
        if (strcmp(name, part_contenders[i].name) == 0)
            return true;
    for (int i = 0; cupola_table_name(i); i++) {
        size_t stage = strlen(cupola_table_name(i));
        for (size_t k = 0; k < sizeof states / sizeof *states; k++)
            if (strncmp(name, cupola_table_name(i), stage) == 0 &&
                strcmp(name + stage, states[k]) == 0)
                return true;
    }
    if (contender_filter_found(name))
        return true;
    return sscanf(name, "cupola-%1d-views%n", &views, &length) == 1 && length > 0 &&
           !name[length] && views >= 1 && views <= CUPOLA_VIEWS_MAX;
}
