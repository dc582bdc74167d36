/*
 * No seams: where one view ends and the next begins, the image does not know it. directions.c shows
 * that errors at view borders are those of the interior; here the guard bands are shown to be what
 * does it: texels beyond them may hold anything.
 */
#include <stdlib.h>

#include "direction_error.h"
#include "group.h"
#include "rig_random.h"

/* Fills the outermost rings of texels of every view with a colour that is no direction. */
static void spoil_rings(const struct fixture *fixture, int rings)
{
    const GLfloat wrong[4] = {-300.0f, 700.0f, 500.0f, 1.0f};
    int views = cupola_gl_frame_begin(fixture->gl, NULL, NULL);
    float *atlas = fixture_atlas(fixture);
    int width = cupola_plan_report(fixture->plan)->atlas_width_px;
    glBindTexture(GL_TEXTURE_2D, cupola_gl_atlas(fixture->gl));
    for (int v = 0; v < views; v++) {
        const struct cupola_rect *rect = &cupola_plan_view(fixture->plan, v)->rect;
        for (int y = 0; y < rect->height; y++)
            for (int x = 0; x < rect->width; x++) {
                float *texel = atlas + 4 * ((rect->y + y) * width + rect->x + x);
                bool inside =
                    x >= rings && y >= rings && x < rect->width - rings && y < rect->height - rings;
                if (!inside)
                    memcpy(texel, wrong, sizeof wrong);
            }
    }
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width,
                    cupola_plan_report(fixture->plan)->atlas_height_px, GL_RGBA, GL_FLOAT, atlas);
    free(atlas);
}

static struct direction_error error_with_spoilt_rings(struct fixture *fixture, int rings)
{
    fixture_paint(fixture, PAINT_DIRECTIONS);
    spoil_rings(fixture, rings);
    float *image = fixture_warp(fixture, 0);
    struct direction_error error = direction_error_of(fixture, 0, image, fixture->dome);
    free(image);
    return error;
}

/*
 * A tap of the bilinear filter reaches half a texel beyond a ray's place, and no further than into
 * the first ring of the guard band; a band of `guard` texels has guard - 1 rings to spare.
 */
static void check_guard(const struct cupola_rig *rig, enum cupola_layout layout, int views,
                        int guard)
{
    struct fixture fixture;
    struct cupola_gl_params params = {.format = CUPOLA_FORMAT_RGBA32F};
    struct cupola_plan_params wish = {.layout = layout, .views = views, .guard_px = guard};
    fixture_make(rig, &wish, &params, &fixture);
    struct direction_error error = error_with_spoilt_rings(&fixture, guard - 1);
    check_at_least(error.border_pixels, 200);
    check_at_most(error.deg, 0.01);
    check_at_most(error.border_px, 1.2 * error.interior_px);
    /* The same metric sees rings that the filter does reach. A view's rectangle is fitted to whole
     * cells, so its outermost pixels' middles may lie some texels inside of it. */
    error = error_with_spoilt_rings(&fixture, guard + 5);
    check_at_least(error.border_px, 0.1);
    fixture_release(&fixture);
}

static void the_filter_stays_inside_of_the_guard_band(void **state)
{
    (void)state;
    static const enum cupola_layout layouts[] = {CUPOLA_LAYOUT_ASYMMETRIC, CUPOLA_LAYOUT_ROTATED};
    uint64_t seed = 3001;
    for (int l = 0; l < 2; l++)
        for (int views = 2; views <= 6; views += 2) {
            struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 140.0, 200);
            random_in_ball(&seed, 0.1, rig.eye_m);
            rig.outputs[0].width_px = 217;
            rig.outputs[0].aim.roll_rad = random_between(&seed, -3.0, 3.0);
            check_guard(&rig, layouts[l], views, random_int(&seed, 1, 4));
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_filter_stays_inside_of_the_guard_band),
    };
    return run_gpu_group("seams", tests);
}
