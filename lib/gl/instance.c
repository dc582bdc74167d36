/* A cupola_gl: made, given back. */
#include "instance.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "error.h"
#include "filter_gl.h"
#include "gl_objects.h"
#include "log.h"
#include "names.h"
#include "one_pass.h"

static const char *const table_names[] = {
    [CUPOLA_TABLE_POINTS] = "points",
    [CUPOLA_TABLE_NONE] = "none",
    [CUPOLA_TABLE_ANGLES] = "angles",
    [CUPOLA_TABLE_SINES] = "sines",
    [CUPOLA_TABLE_COORDINATES] = "coordinates",
    [CUPOLA_TABLE_TILES] = "tiles",
    [CUPOLA_TABLE_AUTO] = "auto",
};

enum { TABLE_COUNT = sizeof table_names / sizeof table_names[0] };

const char *cupola_table_name(int table)
{
    return name_of_number(table_names, TABLE_COUNT, table);
}

int cupola_table_find(const char *name)
{
    return number_of_name(table_names, TABLE_COUNT, name);
}

int cupola_gl_table(const cupola_gl *gl, int output)
{
    if (!gl || !shows_source(gl, CUPOLA_SOURCE_VIEWS) || output < 0 ||
        output >= gl->plan.dome.rig.output_count)
        return CUPOLA_ERROR_ARGUMENT;
    return (int)gl->passes[output].stage;
}

int color_check(const char *name, const float color[4], struct cupola_error *error)
{
    for (int i = 0; i < 4; i++)
        if (!isfinite(color[i]))
            return error_set(error, CUPOLA_ERROR_ARGUMENT,
                             "%s[%d] is %g; allowed: any finite number", name, i, (double)color[i]);
    return CUPOLA_OK;
}

static int check_params(const struct cupola_gl_params *params, int guard_px,
                        struct cupola_error *error)
{
    int status = views_check_params(params, error);
    if (status != CUPOLA_OK)
        return status;
    if (!cupola_table_name((int)params->table))
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "table stage is %d; allowed: 0 to %d",
                         (int)params->table, TABLE_COUNT - 1);
    if (params->storage < CUPOLA_STORAGE_ATLAS || params->storage > CUPOLA_STORAGE_LAYERS)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "storage is %d; allowed: %d to %d",
                         (int)params->storage, CUPOLA_STORAGE_ATLAS, CUPOLA_STORAGE_LAYERS);
    if (params->storage != CUPOLA_STORAGE_ATLAS && params->table == CUPOLA_TABLE_COORDINATES)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "table stage is coordinates, which are those of the atlas; allowed for "
                         "the host's textures: points, none, angles, sines, tiles, auto");
    if ((status = jitter_check_params(params, guard_px, error)) != CUPOLA_OK ||
        (status = mask_check_params(params, error)) != CUPOLA_OK)
        return status;
    if (params->encoding < CUPOLA_ENCODING_LINEAR || params->encoding > CUPOLA_ENCODING_SRGB)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "encoding is %d; allowed: %d to %d",
                         (int)params->encoding, CUPOLA_ENCODING_LINEAR, CUPOLA_ENCODING_SRGB);
    if (params->sources >> SOURCE_KINDS)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "sources is 0x%x; allowed: 0 to 0x%x",
                         params->sources, (1u << SOURCE_KINDS) - 1u);
    bool views = !params->sources || params->sources & 1u << CUPOLA_SOURCE_VIEWS;
    if (params->one_pass && (params->storage != CUPOLA_STORAGE_ATLAS || !views))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "one_pass is true, which is for views in the atlas; allowed without them: "
                         "false");
    status = color_check("border", params->border, error);
    return status == CUPOLA_OK ? log_check(&params->log, error) : status;
}

int call_ended(cupola_gl *gl, const char *call, int status, struct cupola_error *error)
{
    return gl ? guest_ended(&gl->guest, call, status, error) : status;
}

static void destroy_objects(cupola_gl *gl)
{
    for (int i = 0; i < CUPOLA_OUTPUTS_MAX; i++)
        warp_pass_destroy(&gl->passes[i]);
    views_destroy(gl);
    one_pass_destroy(gl);
    mask_pass_destroy(&gl->mask);
    glDeleteSamplers(1, &gl->sampler);
    glDeleteSamplers(1, &gl->image_sampler);
    glDeleteSamplers(1, &gl->gain_sampler);
    glDeleteVertexArrays(1, &gl->vertex_array);
}

static int create_vertex_array(cupola_gl *gl, struct cupola_error *error)
{
    gl->vertex_array = vertex_array_create(&gl->guest, "full screen", error);
    return gl->vertex_array ? CUPOLA_OK : (int)error->status;
}

static int create_sampler(cupola_gl *gl, struct cupola_error *error)
{
    if (!(gl->params.sources >> CUPOLA_SOURCE_DOMEMASTER) && !gl->params.overlays)
        return CUPOLA_OK;
    gl->sampler = sampler_create(&gl->guest, "pictures", error);
    return gl->sampler ? CUPOLA_OK : (int)error->status;
}

static int create_objects(cupola_gl *gl, struct cupola_error *error)
{
    bool views = shows_source(gl, CUPOLA_SOURCE_VIEWS);
    int status = create_vertex_array(gl, error);
    if (status == CUPOLA_OK && views)
        status = gl->params.storage == CUPOLA_STORAGE_ATLAS ? views_create(gl, error)
                                                            : view_images_create(gl, error);
    if (status == CUPOLA_OK && gl->params.one_pass)
        status = one_pass_create(gl, error);
    if (status == CUPOLA_OK)
        status = mask_pass_create(gl, error);
    if (status == CUPOLA_OK)
        status = create_sampler(gl, error);
    for (int i = 0; status == CUPOLA_OK && i < gl->plan.dome.rig.output_count; i++)
        status = warp_pass_create(gl, i, error);
    if (status != CUPOLA_OK)
        return status;
    GLenum failure = glGetError();
    return failure == GL_NO_ERROR ? CUPOLA_OK
                                  : gl_refused(failure, error, "something that a cupola_gl needs");
}

/* With the context's features found. All or nothing, and the host's state as it was. */
static int make_objects(cupola_gl *gl, struct cupola_error *error)
{
    struct guest_work work;
    int status = guest_check(&gl->guest, error);
    if (status != CUPOLA_OK)
        return status;
    guest_errors_drop(&gl->guest);
    guest_begin_making(&gl->guest, &work, "create");
    status = create_objects(gl, error);
    if (status != CUPOLA_OK) {
        destroy_objects(gl);
        gl_errors_drop();
    }
    guest_end(&gl->guest, &work);
    return guest_reason(&gl->guest, status, error);
}

static void release(cupola_gl *gl)
{
    plan_release(&gl->plan);
    mask_pass_forget(&gl->mask);
    free(gl->filter_places);
    free(gl);
}

static int create(const cupola_plan *plan, const struct cupola_gl_params *params, cupola_gl **gl,
                  struct cupola_error *error)
{
    if (!plan || !gl)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "%s is NULL", plan ? "gl" : "plan");
    int status = context_check(error);
    if (status != CUPOLA_OK || (status = check_params(params, plan->guard_px, error)) != CUPOLA_OK)
        return status;
    cupola_gl *made = calloc(1, sizeof *made);
    if (!made)
        return error_set(error, CUPOLA_ERROR_MEMORY, "no memory for a cupola_gl (%zu bytes)",
                         sizeof *made);
    made->params = *params;
    status = filter_params_complete(&made->params, plan->guard_px, error);
    if (status == CUPOLA_OK)
        status = plan_copy(plan, &made->plan, error);
    if (status != CUPOLA_OK) {
        free(made);
        return status;
    }
    if (!made->params.sources)
        made->params.sources = 1u << CUPOLA_SOURCE_VIEWS;
    host_features_find(&made->features);
    made->features.texture_units = gain_unit(made);
    made->features.texture_arrays = made->params.storage == CUPOLA_STORAGE_LAYERS;
    made->guest = (struct guest){&made->features, params->log, params->leaves_state, false};
    made->filter_places = filter_places_text(&made->params.filter);
    status = made->filter_places
                 ? make_objects(made, error)
                 : error_set(error, CUPOLA_ERROR_MEMORY, "no memory for the places of %d rays",
                             made->params.filter.samples);
    if (status != CUPOLA_OK) {
        release(made);
        return status;
    }
    instance_tell_created(made);
    *gl = made;
    return CUPOLA_OK;
}

int cupola_gl_create(const cupola_plan *plan, const struct cupola_gl_params *params, cupola_gl **gl,
                     struct cupola_error *error)
{
    struct cupola_error unwanted;
    if (!error)
        error = &unwanted; /* what is made further down answers by the error's status */
    struct cupola_gl_params wished = params ? *params : (struct cupola_gl_params){.border = {0}};
    int status = create(plan, &wished, gl, error);
    if (status != CUPOLA_OK)
        log_tell(&wished.log, CUPOLA_LOG_ERROR, CUPOLA_LOG_CALL_FAILED, "%s: %s", __func__,
                 error->message);
    return status;
}

void cupola_gl_destroy(cupola_gl **gl)
{
    if (!gl || !*gl)
        return;
    cupola_gl *gone = *gl;
    struct cupola_error unwanted;
    /* In a lost context everything is gone, and another may be current by now. */
    if (guest_check(&gone->guest, &unwanted) == CUPOLA_OK) {
        if (gone->view_open)
            cupola_gl_view_end(gone, NULL);
        if (gone->pass_open)
            cupola_gl_pass_end(gone, NULL);
        destroy_objects(gone);
    }
    guest_tell(&gone->guest, CUPOLA_LOG_INFO, CUPOLA_LOG_DESTROYED, "a cupola_gl was destroyed%s",
               gone->guest.lost ? "; its GL objects went with the lost context" : "");
    for (int i = 0; i < gone->plan.dome.rig.output_count; i++)
        tile_pass_forget(&gone->passes[i].tiles);
    release(gone);
    *gl = NULL;
}
