/* cupola-quality: how near the ways of antialiasing come to the truth, and what they cost. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <epoxy/gl.h>

#include "headless.h"
#include "json.h"
#include "probe.h"
#include "quality_check.h"
#include "quality_options.h"

/* A machine without any GL context: Meson counts it as skipped. */
enum { EXIT_SKIPPED = 77 };

static const double degree_rad = 3.14159265358979323846 / 180;

struct quality {
    struct quality_options options;
    FILE *file;
    int trials;
    char message[MESSAGE_SIZE];
};

static void put_verdict(FILE *file, const struct method *method, const struct verdict *verdict,
                        const struct trial_wishes *wishes)
{
    bool turned = wishes->steps > 0, measured = wishes->cost.frames > 0;
    const double none = (double)NAN;

    fputs("\n   {", file);
    json_put_text(file, "name", method->name);
    json_put_number(file, "psnr_db", verdict->likeness.psnr_db);
    json_put_number(file, "ssim", verdict->likeness.ssim);
    json_put_number(file, "worst_db", verdict->likeness.worst_db);
    json_put_number(file, "shimmer", turned ? verdict->shimmer : none);
    json_put_number(file, "warp_ms", measured ? verdict->warp_ms : none);
    json_put_number(file, "warp_blits", measured ? verdict->warp_blits : none);
    json_put_number(file, "frame_ms", measured ? verdict->frame_ms : none);
    fprintf(file, measured ? "\"frame_ratio\": %.6g}" : "\"frame_ratio\": null}",
            verdict->frame_ratio);
}

static void put_place(FILE *file, const char *scene, const struct setting *setting)
{
    const double *eye_m = setting->viewer_m;

    json_put_text(file, "scene", scene);
    json_put_text(file, "lens", cupola_lens_model_name(setting->lens));
    json_put_number(file, "fov_deg", setting->fov_rad / degree_rad);
    fprintf(file, "\"eye\": [%g, %g, %g], ", eye_m[0], eye_m[1], eye_m[2]);
    json_put_number(file, "size_px", setting->size_px);
}

static void put_trial(struct quality *quality, const char *scene, const struct setting *setting,
                      const struct trial_wishes *wishes, const struct trial *trial)
{
    FILE *file = quality->file;

    fputs(quality->trials++ ? ",\n  {" : "\n  {", file);
    put_place(file, scene, setting);
    json_put_number(file, "pixels", trial->pixels);
    json_put_number(file, "reference_density", wishes->reference_density);
    json_put_number(file, "change", wishes->steps > 0 ? trial->change : (double)NAN);
    json_put_number(file, "blit_ms", wishes->cost.frames > 0 ? trial->blit_ms : (double)NAN);
    json_put_number(file, "check_db", wishes->check ? trial->check.psnr_db : (double)NAN);
    json_put_number(file, "check_moved_db", wishes->check ? trial->check.moved_db : (double)NAN);
    fputs("\"methods\": [", file);
    for (int i = 0; i < quality->options.method_count; i++) {
        fputs(i ? "," : "", file);
        put_verdict(file, &quality->options.methods[i], &trial->verdicts[i], wishes);
    }
    fputs("]}", file);
    fflush(file);
}

/* Of the lens in the image's middle: dphi/dr there, for a circle of that width. */
static struct probe_scale scale_of(const struct cupola_lens *lens, int size_px)
{
    double half_rad = lens->fov_rad / 2;
    double slope = lens->model == CUPOLA_LENS_HEMISPHERIC ? sin(half_rad) : half_rad;

    return (struct probe_scale){half_rad, slope / (0.5 * size_px)};
}

/* scene-lens-fov-centre|off */
static void name_trial(const char *scene, const struct setting *setting, char name[128])
{
    const double *eye_m = setting->viewer_m;
    bool off = eye_m[0] != 0 || eye_m[1] != 0 || eye_m[2] != 0;

    snprintf(name, 128, "%.40s-%.20s-%.0f%s", scene, cupola_lens_model_name(setting->lens),
             setting->fov_rad / degree_rad, off ? "-off" : "");
}

static bool try_one(struct quality *quality, const char *scene, int lens, int eye)
{
    const struct quality_options *options = &quality->options;
    struct setting setting = quality_setting(options, lens, eye);
    struct probe_scale scale = scale_of(&options->lenses[lens], options->size_px);
    struct trial_wishes wishes = options->trial;
    struct trial trial;
    char name[128];

    name_trial(scene, &setting, name);
    fprintf(stderr, "%s\n", name);
    struct scene *made = probe_create(scene, &scale, options->model, quality->message);
    if (!made)
        return false;
    if (probe_filters_itself(scene))
        wishes.reference_density = options->density;
    bool done = setting_create(&setting, made, quality->message);
    if (done) {
        done = trial_run(&setting, name, options->methods, options->method_count, &wishes, &trial,
                         quality->message);
        if (done)
            put_trial(quality, scene, &setting, &wishes, &trial);
        setting_destroy(&setting);
    }
    made->destroy(made);
    return done;
}

/* Whether the model's file is there: without it that scene is left out, with a word about it. */
static bool is_there(const struct quality_options *options, const char *scene)
{
    FILE *file;

    if (strcmp(scene, "model") != 0)
        return true;
    file = fopen(options->model, "rb");
    if (file) {
        fclose(file);
        return true;
    }
    fprintf(stderr,
            "cupola-quality: the scene model is left out: '%s' cannot be read (--model names "
            "another file; Debian's glmark2-data has some)\n",
            options->model);
    return false;
}

static bool try_all(struct quality *quality)
{
    const struct quality_options *options = &quality->options;

    for (int scene = 0; scene < options->scene_count; scene++)
        for (int lens = 0; lens < options->lens_count; lens++)
            for (int eye = 0; eye < options->eye_count; eye++) {
                if (lens == 0 && eye == 0 && !is_there(options, options->scenes[scene]))
                    lens = options->lens_count;
                else if (!try_one(quality, options->scenes[scene], lens, eye) ||
                         ferror(quality->file))
                    return false;
            }
    return true;
}

static bool run(struct quality *quality)
{
    const struct trial_wishes *wishes = &quality->options.trial;
    FILE *file = quality->file;
    struct stopwatch watch;

    stopwatch_create(&watch, wishes->cost.clock);
    fputc('{', file);
    json_put_machine(file, watch.clock);
    stopwatch_destroy(&watch);
    fputs(",\n", file);
    json_put_number(file, "rays", wishes->rays);
    json_put_number(file, "samples", quality->options.samples > 1 ? quality->options.samples : 1);
    json_put_number(file, "density", quality->options.density);
    json_put_number(file, "steps", wishes->steps);
    json_put_number(file, "shimmer_rays", wishes->shimmer_rays);
    json_put_number(file, "yaw_deg", wishes->yaw_rad / degree_rad);
    json_put_number(file, "frames", wishes->cost.frames);
    json_put_text(file, "table", cupola_table_name(quality->options.table));
    fputs("\n\"trials\": [", file);
    bool done = try_all(quality);
    fputs("]}\n", file);
    if (!done && !ferror(file))
        fprintf(stderr, "cupola-quality: %s\n", quality->message);
    return done;
}

int main(int argc, char **argv)
{
    struct quality quality = {.file = stdout};
    struct headless *headless;
    int status;

    if (!quality_options_read(&quality.options, argc, argv, &status))
        return status;
    if (!quality_check(&quality.options, quality.message)) {
        fprintf(stderr, "cupola-quality: %s\n", quality.message);
        return 2;
    }
    if (quality.options.dry_run)
        return EXIT_SUCCESS;
    headless = headless_create(quality.message, sizeof quality.message);
    if (!headless) {
        fprintf(stderr, "cupola-quality: %s\n", quality.message);
        return EXIT_SKIPPED;
    }
    if (quality.options.output && !(quality.file = fopen(quality.options.output, "w"))) {
        fprintf(stderr, "cupola-quality: '%s' cannot be written\n", quality.options.output);
        headless_destroy(headless);
        return EXIT_FAILURE;
    }
    status = run(&quality) ? EXIT_SUCCESS : EXIT_FAILURE;
    if (!json_close(quality.file, quality.options.output, quality.message)) {
        fprintf(stderr, "cupola-quality: %s\n", quality.message);
        status = EXIT_FAILURE;
    }
    headless_destroy(headless);
    return status;
}
