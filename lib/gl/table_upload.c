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

static void entry_of_ray(const cupola_gl *gl, const struct cupola_ray *ray, enum cupola_table stage,
                         double entry[4])
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
        view = view_select(gl->plan.views, gl->plan.view_count, way);
        if (view_hit(&gl->plan.views[view], way, base))
            view_texel(&gl->plan.views[view], base, texel);
        entry[0] = texel[0] / gl->plan.report.atlas_width_px;
        entry[1] = texel[1] / gl->plan.report.atlas_height_px;
        entry[2] = ray->coverage;
        entry[3] = 0;
        return;
    default:
        for (int i = 0; i < 3; i++)
            entry[i] = ray->point_m[i];
        entry[3] = ray->coverage;
    }
}

static void upload_row(const cupola_gl *gl, int output, enum cupola_table stage, int y, int width,
                       float *row)
{
    for (int x = 0; x < width; x++) {
        struct cupola_ray ray;
        double entry[4];
        cupola_dome_ray(&gl->plan.dome, output, NULL, x + 0.5, y + 0.5, &ray);
        entry_of_ray(gl, &ray, stage, entry);
        for (int i = 0; i < 4; i++)
            row[4 * x + i] = (float)entry[i];
    }
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, y, width, 1, GL_RGBA, GL_FLOAT, row);
}

GLuint table_upload(const cupola_gl *gl, int output, enum cupola_table stage,
                    struct cupola_error *error)
{
    const struct cupola_output *size = &gl->plan.dome.rig.outputs[output];
    float *row = malloc(4 * (size_t)size->width_px * sizeof *row);
    if (!row) {
        error_set(error, CUPOLA_ERROR_MEMORY, "no memory for a row of a table (%d px)",
                  size->width_px);
        return 0;
    }
    GLuint table = texture_create(GL_RGBA32F, size->width_px, size->height_px, GL_NEAREST, error);
    for (int y = 0; table && y < size->height_px; y++)
        upload_row(gl, output, stage, y, size->width_px, row);
    free(row);
    return table;
}
