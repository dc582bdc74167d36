/* A scene into the views of a plan: one by one, or all of them in one pass. */
#include "submission.h"

#include <epoxy/gl.h>

#include "scene_views.h"

/* The scene, and what lies over it, where the stencil's mask lets it. */
static void draw_scene(const struct submission *submission, const struct scene_camera *camera,
                       int first, int count)
{
    if (submission->stencil) {
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_EQUAL, 0, 128);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    }
    submission->scene->draw(submission->scene, camera);
    if (submission->grid)
        grid_draw(submission->grid, submission->dome, submission->plan, first, count);
    glDisable(GL_STENCIL_TEST);
}

static bool draw_one_by_one(const struct submission *submission, struct scene_camera camera,
                            int views, struct cupola_error *error)
{
    struct cupola_gl_view view;

    camera.view = &view.camera;
    for (int i = 0; i < views; i++) {
        if (cupola_gl_view_begin(submission->gl, i, &view, error) < 0)
            return false;
        draw_scene(submission, &camera, i, 1);
        if (cupola_gl_view_end(submission->gl, error) < 0)
            return false;
    }
    return true;
}

static bool draw_at_once(const struct submission *submission, struct scene_camera camera,
                         struct cupola_error *error)
{
    struct cupola_gl_pass pass;

    if (cupola_gl_pass_begin(submission->gl, camera.host, &pass, error) < 0)
        return false;
    camera.pass = &pass;
    glBindBufferBase(GL_UNIFORM_BUFFER, SCENE_PASS_BINDING, pass.buffer);
    draw_scene(submission, &camera, 0, pass.view_count);
    return cupola_gl_pass_end(submission->gl, error) >= 0;
}

bool submission_draw(const struct submission *submission, const struct cupola_frame *frame,
                     struct scene_camera camera, struct cupola_error *error)
{
    int views = cupola_gl_frame_begin(submission->gl, frame, error);

    if (views < 0)
        return false;
    return submission->one_pass ? draw_at_once(submission, camera, error)
                                : draw_one_by_one(submission, camera, views, error);
}
