/* Writing JSON. */
#include "json.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <epoxy/gl.h>

static const char *const scene_names[] = {
    [SCENE_ROOM] = "room", [SCENE_FOREST] = "forest", [SCENE_DIRECTIONS] = "directions"};

void json_put_text(FILE *file, const char *name, const char *text)
{
    fprintf(file, "\"%s\": \"", name);
    for (; text && *text; text++)
        if (*text == '"' || *text == '\\')
            fprintf(file, "\\%c", *text);
        else if ((unsigned char)*text >= ' ')
            fputc(*text, file);
    fputs("\", ", file);
}

/* JSON has no other numbers. */
void json_put_number(FILE *file, const char *name, double value)
{
    if (isfinite(value))
        fprintf(file, "\"%s\": %.6g, ", name, value);
    else
        fprintf(file, "\"%s\": null, ", name);
}

void json_put_quartiles(FILE *file, const char *name, const struct quartiles *quartiles)
{
    fprintf(file, "\"%s\": [%.6g, %.6g, %.6g], ", name, quartiles->low, quartiles->median,
            quartiles->high);
}

/* The processor's name, from where Linux tells it. */
static void put_processor(FILE *out)
{
    char line[256], *name = NULL;
    FILE *file = fopen("/proc/cpuinfo", "r");

    while (file && !name && fgets(line, sizeof line, file))
        if (strncmp(line, "model name", 10) == 0)
            name = strchr(line, ':');
    if (file)
        fclose(file);
    json_put_text(out, "processor", name ? name + 2 : "unknown");
    json_put_number(out, "processors", (double)sysconf(_SC_NPROCESSORS_ONLN));
}

/* What else the machine does: mean of the last minute's runnable tasks. */
static double load_average(void)
{
    double load = (double)NAN;
    FILE *file = fopen("/proc/loadavg", "r");

    if (file) {
        if (fscanf(file, "%lf", &load) != 1)
            load = (double)NAN;
        fclose(file);
    }
    return load;
}

void json_put_machine(FILE *file, enum clock clock)
{
    struct utsname system;
    const char *threads = getenv("LP_NUM_THREADS");

    fputs("\"machine\": {", file);
    put_processor(file);
    if (uname(&system) == 0) {
        json_put_text(file, "system", system.sysname);
        json_put_text(file, "architecture", system.machine);
    }
    json_put_text(file, "gl_version", (const char *)glGetString(GL_VERSION));
    json_put_text(file, "llvmpipe_threads", threads ? threads : "one for each processor");
    json_put_text(file, "clock", clock_names[clock]);
    json_put_text(file, "renderer", (const char *)glGetString(GL_RENDERER));
    fprintf(file, "\"load_average\": %.2f}", load_average());
}

void json_begin(FILE *file, const struct comparison_wishes *wishes, enum clock clock)
{
    fputc('{', file);
    json_put_machine(file, clock);
    fprintf(file, ",\n\"frames\": %d, \"warm_up\": %d,\n\"comparisons\": [", wishes->frames,
            wishes->warm_up);
}

static void put_result(FILE *file, const struct setting *setting, const struct contender *contender,
                       const struct result *result)
{
    bool plain = result->facts.shows == SHOWS_PLAIN_VIEW;
    double pixels = plain ? (double)setting->size_px * setting->size_px : setting->lit_pixels;
    double output_bytes = 4.0 * setting->size_px * setting->size_px;

    fputs("\n  {", file);
    json_put_text(file, "name", contender->name);
    if (result->skipped[0]) {
        json_put_text(file, "skipped", result->skipped);
    } else {
        json_put_quartiles(file, "time_ms", &result->time_ms);
        json_put_quartiles(file, "wall_ms", &result->wall_ms);
        json_put_number(file, "ratio", result->ratio);
        json_put_quartiles(file, "round_ratio", &result->round_ratio);
        json_put_number(file, "ns_per_pixel", 1e6 * result->time_ms.median / pixels);
        json_put_number(file, "views", result->facts.views);
        json_put_number(file, "texels_per_pixel", result->facts.texels / pixels);
        json_put_number(file, "planned_texels_per_pixel",
                        result->facts.planned > 0 ? result->facts.planned / pixels : (double)NAN);
        json_put_number(file, "shaded_texels_per_pixel",
                        result->facts.shaded > 0 ? result->facts.shaded / pixels : (double)NAN);
        json_put_number(file, "bytes_per_output_byte", result->facts.bytes / output_bytes);
        json_put_number(file, "table_bytes_per_output_byte",
                        result->facts.planned > 0 ? result->facts.tables / output_bytes
                                                  : (double)NAN);
        json_put_number(file, "psnr_db", result->psnr_db > 0 ? result->psnr_db : (double)NAN);
        json_put_text(file, "note", result->facts.note);
        fprintf(file, "\"shows_dome\": %s, ", result->facts.shows == SHOWS_DOME ? "true" : "false");
    }
    fprintf(file, "\"took_part\": %s}", result->skipped[0] ? "false" : "true");
}

void json_comparison(FILE *file, bool first, const struct json_heading *heading,
                     const struct setting *setting, const struct reference *reference,
                     const struct contender *contenders, int count, const struct result *results)
{
    const struct scene_wishes *wishes = &setting->load.wishes;

    fprintf(file, "%s\n {", first ? "" : ",");
    json_put_text(file, "family", heading->family);
    json_put_text(file, "varied", heading->varied);
    json_put_number(file, "value", heading->value);
    json_put_number(file, "size_px", setting->size_px);
    json_put_text(file, "lens", cupola_lens_model_name(setting->lens));
    json_put_number(file, "fov_deg", setting->fov_rad * 180 / 3.14159265358979323846);
    json_put_number(file, "plain_fov_deg",
                    setting_plain_fov_rad(setting) * 180 / 3.14159265358979323846);
    fprintf(file, "\"off_axis\": %s, ", setting->off_axis ? "true" : "false");
    json_put_text(file, "table", cupola_table_name((int)setting->gl.table));
    json_put_text(file, "load", setting->load.name);
    json_put_text(file, "scene", scene_names[setting->load.kind]);
    json_put_number(file, "lamps",
                    wishes->shading == SCENE_HEAVY && wishes->lamps > 0 ? wishes->lamps : 0);
    json_put_number(file, "triangles", (double)setting->scene->whole.triangles);
    json_put_number(file, "object_radius_deg",
                    setting->object_radius_rad > 0
                        ? setting->object_radius_rad * 180 / 3.14159265358979323846
                        : (double)NAN);
    json_put_number(file, "lit_pixels", setting->lit_pixels);
    json_put_number(file, "load_average", load_average());
    json_put_number(file, "reference_oversampling",
                    reference ? reference->oversampling : (double)NAN);
    fputs("\"contenders\": [", file);
    for (int i = 0; i < count; i++) {
        fputs(i ? "," : "", file);
        put_result(file, setting, &contenders[i], &results[i]);
    }
    fputs("]}", file);
    fflush(file);
}

void json_end(FILE *file)
{
    fputs("]}\n", file);
}

bool json_close(FILE *file, const char *path, char *message)
{
    bool whole = fflush(file) == 0 && !ferror(file);

    if (path)
        whole = fclose(file) == 0 && whole;
    if (!whole && path)
        snprintf(message, MESSAGE_SIZE, "'%.900s' cannot be written whole", path);
    else if (!whole)
        snprintf(message, MESSAGE_SIZE, "the standard output cannot be written whole");
    return whole;
}
