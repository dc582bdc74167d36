/* The command `capture decode`: from photographs to marks. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cupola/rig_file.h>

#include "angles.h"
#include "capture/code_map.h"
#include "capture/command.h"
#include "capture/patches.h"
#include "capture/photo_list.h"
#include "capture/pose.h"
#include "option_values.h"
#include "order.h"
#include "output_file.h"
#include "plain_text.h"
#include "status.h"
#include "whole_file.h"

struct decoding {
    const struct capture_options *options;
    struct cupola_rig rig;
    struct series series;
    struct photo_list photos;
    struct marks references;
    struct code_map map;
    struct patches patches;
    struct camera camera;
    struct pose_result pose; /* all zero where the pose is known */
    struct marks marks;
    int beyond; /* patches that are not on the screen */
};

static int read_photos(struct decoding *decoding, char *message)
{
    const struct capture_options *options = decoding->options;
    struct code_settings settings = {
        .series = &decoding->series,
        .paths = decoding->photos.paths,
        .encoding = options->linear ? PHOTO_LINEAR : PHOTO_SRGB,
        .least_contrast = options->contrast,
    };

    if (!photo_list_check(&decoding->photos, &decoding->series, message) ||
        !code_map_read(&settings, &decoding->map, message))
        return STATUS_FAILED;
    return STATUS_OK;
}

/* "12.3 % too little contrast, ..." of what has no place. */
static void describe_states(const struct code_map *map, char *text, size_t text_size)
{
    double all = (double)map->width * map->height;
    size_t length = 0;

    *text = 0;
    for (int i = CODE_DECODED; i < CODE_STATES && length < text_size; i++) {
        if (i == CODE_NO_NUMBER && map->counts[i] == 0)
            continue;
        length += (size_t)snprintf(text + length, text_size - length, "%s%.1f %% %s", i ? ", " : "",
                                   100 * map->counts[i] / all, code_state_text((enum code_state)i));
    }
}

static void warn(const struct code_map *map)
{
    int lost = map->counts[CODE_UNSURE] + map->counts[CODE_NOISY];
    char text[300];

    code_check_warning(&map->check, map->counts[CODE_DECODED] + lost, lost, text, sizeof text);
    if (*text)
        fprintf(stderr, "cupola-calib capture decode: %s\n", text);
}

/* By whether numbers, light or what it shows is missing. */
static const char *advice_without_marks(const struct code_map *map)
{
    const double least_part = 0.05;
    double least = least_part * map->width * map->height;
    int lost = map->counts[CODE_UNSURE] + map->counts[CODE_NOISY];
    int lit = map->counts[CODE_DECODED] + lost;

    if (map->counts[CODE_NO_NUMBER] > least && map->counts[CODE_NO_NUMBER] > lost)
        return "NaN and infinity are no numbers: look at what wrote the files";
    if (code_check_is_noise(&map->check))
        return "what seems to be lit is mostly noise: give a higher --contrast, expose longer or "
               "take more --shots";
    return lit > least
               ? "look at the order of the photographs and at their focus, and take a longer "
                 "--period"
               : "for contrast expose longer, darken the room or give --contrast; where saturated, "
                 "expose less";
}

static int find_patches(struct decoding *decoding, char *message)
{
    char states[300];

    describe_states(&decoding->map, states, sizeof states);
    if (!patches_find(&decoding->map, decoding->options->marks, &decoding->patches, message))
        return STATUS_FAILED;
    if (decoding->patches.count == 0) {
        snprintf(message, MESSAGE_SIZE, "the photographs give no marks: of their pixels %s; %s",
                 states, advice_without_marks(&decoding->map));
        return STATUS_FAILED;
    }
    printf("pixels: %s (%dx%d)\n", states, decoding->map.width, decoding->map.height);
    printf("light: contrast %.3g, noise %.2g, of what a photograph holds\n", decoding->map.contrast,
           decoding->map.noise);
    warn(&decoding->map);
    return STATUS_OK;
}

static void report_pose(const struct decoding *decoding)
{
    const struct pose_result *pose = &decoding->pose;
    const struct camera *camera = &pose->camera;
    const double *at = camera->position_m, *from = pose->projector.position_m;
    const struct cupola_aim *way = &pose->projector.aim;
    struct cupola_aim aim;

    camera_aim_of(camera, decoding->rig.tilt_rad, &aim);
    printf("camera: position %.4f, %.4f, %.4f m (sd %.2g), aim %.3f, %.3f, %.3f degrees (sd %.2g)",
           at[0], at[1], at[2], pose->camera_position_sd_m, aim.yaw_rad * deg_per_rad,
           aim.pitch_rad * deg_per_rad, aim.roll_rad * deg_per_rad,
           pose->camera_aim_sd_rad * deg_per_rad);
    if (decoding->options->free & POSE_FOV)
        printf(", fov %.3f degrees",
               deg_per_rad * (camera->kind == CAMERA_FISHEYE ? camera->fisheye.lens.fov_rad
                                                             : camera->fov_rad));
    if (decoding->options->free & POSE_CENTER)
        printf(", axis at %.2f, %.2f px", camera->center_px[0], camera->center_px[1]);
    printf("\nprojector: position %.4f, %.4f, %.4f m (sd %.2g), aim %.3f, %.3f, %.3f degrees "
           "(sd %.2g)\n",
           from[0], from[1], from[2], pose->projector_position_sd_m, way->yaw_rad * deg_per_rad,
           way->pitch_rad * deg_per_rad, way->roll_rad * deg_per_rad,
           pose->projector_aim_sd_rad * deg_per_rad);
    printf("residuals: %.3g px rms, %.3g px worst, %d of %d marks left out; references: %.3g px of "
           "the photograph rms, %.3g px worst (%s)\n",
           pose->rms_px, pose->worst_px, pose->rejected_count, decoding->patches.count,
           pose->reference_rms_px, pose->reference_px[pose->worst_reference],
           decoding->references.list[pose->worst_reference].name);
}

/* Where they are refused: how far each lies off. */
static void report_references(const struct decoding *decoding)
{
    for (int i = 0; decoding->pose.reference_px && i < decoding->references.count; i++)
        printf("%s: %.3g px of the photograph off\n", decoding->references.list[i].name,
               decoding->pose.reference_px[i]);
}

static int solve_pose(struct decoding *decoding, char *message)
{
    struct pose_request request = {
        .rig = &decoding->rig,
        .output = decoding->options->projector,
        .camera = &decoding->camera,
        .free = decoding->options->free ? decoding->options->free : POSE_POSITION | POSE_AIM,
        .patches = &decoding->patches,
        .references = &decoding->references,
    };

    if (!decoding->options->references)
        return STATUS_OK;
    if (!pose_solve(&request, &decoding->pose, message)) {
        report_references(decoding);
        return STATUS_FAILED;
    }
    decoding->camera = decoding->pose.camera;
    report_pose(decoding);
    return STATUS_OK;
}

/* The point of the screen that a patch's place of the photograph shows. */
static bool find_point(const struct decoding *decoding, const struct patch *patch, double point[3])
{
    const struct cupola_screen *screen = &decoding->rig.screen;
    double ray[3];

    return camera_ray(&decoding->camera, patch->camera_px, ray) &&
           camera_meets_sphere(decoding->camera.position_m, ray, screen->radius_m, point) &&
           -point[2] >= screen->radius_m * cos(screen->cap_rad);
}

static int make_marks(struct decoding *decoding, char *message)
{
    const struct patches *patches = &decoding->patches;

    decoding->marks = (struct marks){.kind = MARKS_POINTS};
    decoding->marks.list = calloc((size_t)patches->count, sizeof *decoding->marks.list);
    if (!decoding->marks.list) {
        snprintf(message, MESSAGE_SIZE, "out of memory for %d marks", patches->count);
        return STATUS_FAILED;
    }
    for (int i = 0; i < patches->count; i++) {
        struct mark mark = {.steered = true};
        if (decoding->pose.rejected && decoding->pose.rejected[i])
            continue;
        if (!find_point(decoding, &patches->list[i], mark.place)) {
            decoding->beyond++;
            continue;
        }
        snprintf(mark.name, sizeof mark.name, "c%04d", decoding->marks.count + 1);
        memcpy(mark.pixel_px, patches->list[i].projector_px, sizeof mark.pixel_px);
        decoding->marks.list[decoding->marks.count++] = mark;
    }
    if (decoding->marks.count > 0)
        return STATUS_OK;
    snprintf(message, MESSAGE_SIZE,
             "none of %d marks lies on the screen; look at --camera, --camera-position, "
             "--camera-aim",
             patches->count);
    return STATUS_FAILED;
}

/* Of the marks' places, as each patch tells it; the median. */
static double median_sd_px(const struct patches *patches)
{
    double *sizes = malloc((size_t)patches->count * sizeof *sizes);
    double median;

    if (!sizes)
        return HUGE_VAL;
    for (int i = 0; i < patches->count; i++)
        sizes[i] = hypot(patches->list[i].sd_px[0], patches->list[i].sd_px[1]);
    order_sort(sizes, patches->count);
    median = sizes[patches->count / 2];
    free(sizes);
    return median;
}

static bool write_solved(const struct decoding *decoding, char *message)
{
    const struct capture_options *options = decoding->options;
    struct cupola_rig rig = decoding->rig;
    struct cupola_error error = {0};

    if (!options->solved)
        return true;
    rig.outputs[options->projector] = decoding->pose.projector;
    if (cupola_rig_write(options->solved, &rig, &error) >= 0)
        return true;
    snprintf(message, MESSAGE_SIZE, "--solved: %s", error.message);
    return false;
}

/* Both files or none: the marks get their name after the rig has its own. */
static int write_results(const struct decoding *decoding, char *message)
{
    const struct capture_options *options = decoding->options;
    struct whole_file marks;

    if (!marks_settle(&marks, options->output, &decoding->marks, message))
        return STATUS_FAILED;
    if (!write_solved(decoding, message)) {
        whole_file_abort(&marks);
        return STATUS_FAILED;
    }
    if (!whole_file_end(&marks, message))
        return STATUS_FAILED;
    printf("marks: %d in ", decoding->marks.count);
    plain_text_print(options->output, stdout);
    printf(", places known to %.2g px (median); left out: %d beyond the screen, %d "
           "where too little is decoded, %d where places are not smooth\n",
           median_sd_px(&decoding->patches), decoding->beyond, decoding->patches.thin,
           decoding->patches.rough);
    return STATUS_OK;
}

static int check(struct decoding *decoding, char *message)
{
    const struct capture_options *options = decoding->options;
    const char *wants = options->free ? "--camera-free" : options->solved ? "--solved" : NULL;

    if (wants && !options->references) {
        snprintf(message, MESSAGE_SIZE,
                 "%s needs --references FILE: turning camera and projector together round the "
                 "centre of the screen changes no photograph, so only places of the photograph "
                 "with known points tell which way they look",
                 wants);
        return STATUS_USAGE;
    }
    if (!photo_list_find(options, &decoding->photos, message))
        return STATUS_FAILED;
    if (!photo_list_differs(&decoding->photos, options, message))
        return STATUS_USAGE;
    if (!output_file_check("--output", options->output, message) ||
        (options->solved && !output_file_check("--solved", options->solved, message)))
        return STATUS_FAILED;
    return STATUS_OK;
}

static int decode(struct decoding *decoding, char *message)
{
    const struct capture_options *options = decoding->options;
    const char *patterns = options->patterns ? options->patterns : options->folder;
    int status = check(decoding, message);

    if (status == STATUS_OK)
        status = capture_rig(options, &decoding->rig, message);
    if (status == STATUS_OK &&
        !camera_parse("--camera", options->camera, &decoding->camera, message))
        status = STATUS_USAGE;
    if (status == STATUS_OK && options->references &&
        !marks_read(options->references, true, &decoding->references, message))
        status = STATUS_FAILED;
    if (status == STATUS_OK)
        status = capture_series(patterns, &decoding->rig, options->projector, &decoding->series,
                                message);
    if (status == STATUS_OK)
        status = read_photos(decoding, message);
    if (status == STATUS_OK)
        status = capture_camera(options, &decoding->rig, decoding->map.width, decoding->map.height,
                                &decoding->camera, message);
    if (status == STATUS_OK)
        status = find_patches(decoding, message);
    if (status == STATUS_OK)
        status = solve_pose(decoding, message);
    if (status == STATUS_OK)
        status = make_marks(decoding, message);
    return status == STATUS_OK ? write_results(decoding, message) : status;
}

int capture_decode(const struct capture_options *options, char *message)
{
    struct decoding decoding = {.options = options};
    int status = decode(&decoding, message);

    photo_list_free(&decoding.photos);
    marks_free(&decoding.references);
    code_map_free(&decoding.map);
    patches_free(&decoding.patches);
    pose_result_free(&decoding.pose);
    marks_free(&decoding.marks);
    return status;
}
