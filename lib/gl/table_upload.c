/*
 * Tables by the C functions, row by row: for OpenGL ES that cannot draw into floats. What an entry
 * holds is said in shaders/table.frag.
 */
#include <math.h>
#include <stdlib.h>

#include "error.h"
#include "geometry/vector.h"
#include "geometry/views.h"
#include "gl_objects.h"
#include "instance.h"
#include "table_gl.h"

static void entry_of_ray(const cupola_plan *plan, const struct cupola_ray *ray,
                         enum cupola_table stage, double entry[4])
{
    const double *way = ray->direction;
    double across = hypot(way[0], way[1]), texel[2] = {0, 0}, base[2];
    int view;
    switch (stage) {
    case CUPOLA_TABLE_ANGLES:
        entry[0] = atan2(across, -way[2]);
        entry[1] = across > 0 ? atan2(way[1], way[0]) : 0;
        entry[2] = ray->coverage;
        entry[3] = 0;
        return;
    case CUPOLA_TABLE_SINES:
        entry[0] = ray->coverage * across;
        entry[1] = ray->coverage * -way[2];
        entry[2] = across > 0 ? way[1] / across : 0;
        entry[3] = across > 0 ? way[0] / across : 1;
        return;
    case CUPOLA_TABLE_COORDINATES:
        view = view_select(plan->views, plan->view_count, way);
        if (view_hit(&plan->views[view], way, base))
            view_texel(&plan->views[view], base, texel);
        entry[0] = texel[0] / plan->report.atlas_width_px;
        entry[1] = texel[1] / plan->report.atlas_height_px;
        entry[2] = ray->coverage;
        entry[3] = 0;
        return;
    default:
        for (int i = 0; i < 3; i++)
            entry[i] = ray->point_m[i];
        entry[3] = ray->coverage;
    }
}

static void upload_row(const cupola_dome *dome, const cupola_plan *plan, int output,
                       enum cupola_table stage, int y, float *row)
{
    int width = dome->rig.outputs[output].width_px;
    for (int x = 0; x < width; x++) {
        struct cupola_ray ray;
        double entry[4];
        cupola_dome_ray(dome, output, NULL, x + 0.5, y + 0.5, &ray);
        entry_of_ray(plan, &ray, stage, entry);
        for (int i = 0; i < 4; i++)
            row[4 * x + i] = (float)entry[i];
    }
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, y, width, 1, GL_RGBA, GL_FLOAT, row);
}

int table_fill_by_cpu(const cupola_dome *dome, const cupola_plan *plan, int output,
                      enum cupola_table stage, struct cupola_error *error)
{
    const struct cupola_output *size = &dome->rig.outputs[output];
    float *row = malloc(4 * (size_t)size->width_px * sizeof *row);
    if (!row)
        return error_set(error, CUPOLA_ERROR_MEMORY, "no memory for a row of a table (%d px)",
                         size->width_px);
    for (int y = 0; y < size->height_px; y++)
        upload_row(dome, plan, output, stage, y, row);
    free(row);
    return CUPOLA_OK;
}

GLuint table_upload(const cupola_gl *gl, int output, enum cupola_table stage,
                    struct cupola_error *error)
{
    const struct cupola_output *size = &gl->plan.dome.rig.outputs[output];
    GLuint table = texture_create(GL_RGBA32F, size->width_px, size->height_px, GL_NEAREST, error);
    if (!table || table_fill_by_cpu(&gl->plan.dome, &gl->plan, output, stage, error) == CUPOLA_OK)
        return table;
    glDeleteTextures(1, &table);
    return 0;
}
