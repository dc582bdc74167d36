/* A solution as JSON. */
#include "solve_json.h"

#include "angles.h"

/* 0 is added so that none is -0. */
static void write_numbers(FILE *file, const double *numbers, int count, double factor)
{
    fputc('[', file);
    for (int i = 0; i < count; i++)
        fprintf(file, "%s%.17g", i ? ", " : "", numbers[i] * factor + 0);
    fputc(']', file);
}

static void write_array(FILE *file, const char *key, const double *numbers, int count,
                        double factor)
{
    fprintf(file, "  \"%s\": ", key);
    write_numbers(file, numbers, count, factor);
    fputs(",\n", file);
}

/* Names and warnings are UTF-8 without control characters. */
static void write_string(FILE *file, const char *text)
{
    fputc('"', file);
    for (const char *at = text; *at; at++) {
        if (*at == '"' || *at == '\\')
            fputc('\\', file);
        fputc(*at, file);
    }
    fputc('"', file);
}

static void write_lens(FILE *file, const char *key, const char *model, double fov_rad,
                       const double k[4])
{
    fprintf(file, "  \"%s\": {", key);
    if (model)
        fprintf(file, "\"model\": \"%s\", ", model);
    fprintf(file, "\"fov_deg\": %.17g", fov_rad * deg_per_rad);
    if (k) {
        fputs(", \"k\": ", file);
        write_numbers(file, k, 4, 1);
    }
    fputs("},\n", file);
}

static void write_values(FILE *file, const struct cupola_output *output,
                         const struct solve_result *result)
{
    const double aim[] = {output->aim.yaw_rad, output->aim.pitch_rad, output->aim.roll_rad};
    const double circle[] = {output->circle.center_x_px, output->circle.center_y_px,
                             output->circle.radius_px};
    bool polynomial = output->lens.model == CUPOLA_LENS_POLYNOMIAL;

    write_array(file, "projector_position_m", output->position_m, 3, 1);
    write_array(file, "projector_position_m_sd", result->position_sd_m, 3, 1);
    write_array(file, "projector_aim_deg", aim, 3, deg_per_rad);
    write_array(file, "projector_aim_deg_sd", result->aim_sd_rad, 3, deg_per_rad);
    write_lens(file, "lens", cupola_lens_model_name((int)output->lens.model), output->lens.fov_rad,
               polynomial ? output->lens.k : NULL);
    write_lens(file, "lens_sd", NULL, result->fov_sd_rad, polynomial ? result->k_sd : NULL);
    write_array(file, "circle_px", circle, 3, 1);
    write_array(file, "circle_px_sd", result->circle_sd_px, 3, 1);
    fprintf(file, "  \"radius_m\": %.17g,\n  \"radius_m_sd\": %.17g,\n",
            result->rig.screen.radius_m, result->radius_sd_m);
}

void solve_json_write(FILE *file, const struct solve_request *request,
                      const struct solve_result *result)
{
    const struct cupola_output *output = &result->rig.outputs[request->output];
    int written = 0;
    const char *name;

    fputs("{\n", file);
    write_values(file, output, result);
    fprintf(file, "  \"flip\": \"%s\",\n", solve_flip_name((int)output->flip));
    fprintf(file, "  \"residual_px\": {\"rms\": %.17g, \"worst\": %.17g},\n", result->rms_px,
            result->worst_px);
    fprintf(file, "  \"direction_sd_deg\": {\"median\": %.17g, \"worst\": %.17g},\n",
            result->direction_sd_rad * deg_per_rad, result->worst_direction_sd_rad * deg_per_rad);
    fprintf(file, "  \"marks_used\": %d,\n  \"rejected\": [",
            request->marks->count - result->rejected);
    for (int i = 0; i < request->marks->count; i++) {
        if (!result->marks[i].rejected)
            continue;
        fputs(written++ ? ", " : "", file);
        write_string(file, request->marks->list[i].name);
    }
    fputs("],\n  \"free\": [", file);
    written = 0;
    for (int i = 0; (name = solve_free_name(i)); i++) {
        if (result->free & 1 << i)
            fprintf(file, "%s\"%s\"", written++ ? ", " : "", name);
    }
    fputs("],\n  \"warnings\": [", file);
    for (int i = 0; i < result->warning_count; i++) {
        fputs(i ? ", " : "", file);
        write_string(file, result->warnings[i]);
    }
    fputs("]\n}\n", file);
}
