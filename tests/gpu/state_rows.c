/*
 * Frames that leave the host's state: what they leave is what the table in docs/host-contract.md
 * says, row by row, and all else is as the host has left it.
 */
#include "gl/instance.h"
#include "left_house.h"

static double all_stencil_bits; /* as a mask of them is told */

static void expect(struct snapshot *expected, GLenum name, int index, double value)
{
    for (int i = 0; i < expected->count; i++)
        if (expected->entries[i].name == name && expected->entries[i].index == index)
            expected->entries[i].value = value;
}

/* The table's right column, but for what is drawn, bound or blended. */
static void expect_each(struct snapshot *expected)
{
    static const GLenum stays[] = {GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT, GL_LINE_SMOOTH,
                                   GL_TEXTURE_CUBE_MAP_SEAMLESS};
    static const GLenum zero[] = {
        GL_PACK_ROW_LENGTH,
        GL_PACK_SKIP_ROWS,
        GL_PACK_SKIP_PIXELS,
        GL_PACK_SWAP_BYTES,
        GL_UNPACK_ROW_LENGTH,
        GL_UNPACK_SKIP_ROWS,
        GL_UNPACK_SKIP_PIXELS,
        GL_UNPACK_SWAP_BYTES,
        GL_PIXEL_PACK_BUFFER_BINDING,
        GL_CLAMP_READ_COLOR,
        GL_BLEND,
        GL_PIXEL_UNPACK_BUFFER_BINDING,
    };
    for (int i = 0; i < CAPABILITIES; i++) {
        GLenum name = capabilities[i].name;
        bool kept = false;
        for (int k = 0; k < 4; k++)
            kept = kept || name == stays[k];
        if (!kept)
            expect(expected, name, 0, name == GL_MULTISAMPLE || name == GL_PROGRAM_POINT_SIZE);
    }
    for (size_t i = 0; i < sizeof zero / sizeof zero[0]; i++)
        expect(expected, zero[i], 0, 0);
    expect(expected, GL_PACK_ALIGNMENT, 0, 1);
    expect(expected, GL_UNPACK_ALIGNMENT, 0, 1);
    expect(expected, GL_BLEND_EQUATION_RGB, 0, GL_FUNC_ADD);
    expect(expected, GL_BLEND_EQUATION_ALPHA, 0, GL_FUNC_ADD);
    expect(expected, GL_DEPTH_WRITEMASK, 0, 1);
    expect(expected, GL_POLYGON_MODE, 0, GL_FILL);
    expect(expected, GL_CLIP_ORIGIN, 0, GL_LOWER_LEFT);
    expect(expected, GL_CLIP_DEPTH_MODE, 0, GL_NEGATIVE_ONE_TO_ONE);
    for (int i = 0; i < 4 * SNAPSHOT_BUFFERS; i++)
        expect(expected, GL_COLOR_WRITEMASK, i, i < 4);
    expect(expected, GL_ACTIVE_TEXTURE, 0, GL_TEXTURE0);
    for (int unit = 0; unit < house.gl->features.texture_units; unit++)
        expect(expected, GL_SAMPLER_BINDING, unit, 0);
}

static void expect_area(struct snapshot *expected, GLuint draw, GLuint read,
                        const struct cupola_rect *rect)
{
    const int corners[4] = {rect->x, rect->y, rect->width, rect->height};
    expect(expected, GL_DRAW_FRAMEBUFFER_BINDING, 0, draw);
    expect(expected, GL_READ_FRAMEBUFFER_BINDING, 0, read);
    expect(expected, GL_SCISSOR_TEST, 0, 1);
    for (int i = 0; i < 4; i++) {
        expect(expected, GL_VIEWPORT, i, corners[i]);
        expect(expected, GL_SCISSOR_BOX, i, corners[i]);
    }
}

static void expect_texture(struct snapshot *expected, int unit, GLenum binding, GLuint texture,
                           GLuint sampler)
{
    expect(expected, binding, unit, texture);
    expect(expected, GL_SAMPLER_BINDING, unit, sampler);
}

static void expect_gain(struct snapshot *expected)
{
    if (house.gl->passes[0].gain)
        expect_texture(expected, gain_unit(house.gl), GL_TEXTURE_BINDING_2D, house.gain,
                       house.gl->gain_sampler);
}

static void expect_views(struct snapshot *expected)
{
    const cupola_gl *gl = house.gl;
    expect(expected, GL_TEXTURE_BINDING_2D, UNIT_TABLE, gl->passes[0].table);
    if (gl->params.storage == CUPOLA_STORAGE_ATLAS)
        expect(expected, GL_TEXTURE_BINDING_2D, UNIT_IMAGE, gl->atlas);
    if (gl->params.storage == CUPOLA_STORAGE_LAYERS)
        expect_texture(expected, UNIT_IMAGE, GL_TEXTURE_BINDING_2D_ARRAY, house.view_textures[1],
                       gl->image_sampler);
    if (gl->params.storage != CUPOLA_STORAGE_TEXTURES)
        return;
    for (int i = 0; i < gl->plan.view_count; i++)
        expect_texture(expected, view_image_unit(i), GL_TEXTURE_BINDING_2D, house.view_textures[0],
                       gl->image_sampler);
    expect(expected, GL_ACTIVE_TEXTURE, 0, GL_TEXTURE0 + view_image_unit(gl->plan.view_count - 1));
}

static void expect_drawn(struct snapshot *expected, GLuint program)
{
    const struct cupola_rect all = {0, 0, GUEST_SIZE, GUEST_SIZE};
    expect_area(expected, house.target.framebuffer, house.target.framebuffer, &all);
    expect(expected, GL_CURRENT_PROGRAM, 0, program);
    expect(expected, GL_VERTEX_ARRAY_BINDING, 0, house.gl->vertex_array);
    expect(expected, GL_ELEMENT_ARRAY_BUFFER_BINDING, 0, 0); /* the vertex array's */
    expect_gain(expected);
}

/* The last kind that there is; the viewport is of whole tiles. */
static void expect_tiles(struct snapshot *expected)
{
    const struct warp_pass *pass = &house.gl->passes[0];
    int last = TILE_KINDS - 1;
    while (last > 0 && !pass->tiles.tiles.count[last])
        last--;
    expect(expected, GL_CURRENT_PROGRAM, 0,
           pass->programs[pass->gain != 0][SOURCE_KINDS + last].program);
    expect(expected, GL_VERTEX_ARRAY_BINDING, 0, pass->tiles.arrays[last]);
    expect(expected, GL_VIEWPORT, 2, pass->tiles.tiles.width_px);
    expect(expected, GL_VIEWPORT, 3, pass->tiles.tiles.height_px);
    if (!context_is_es())
        expect(expected, GL_POINT_FADE_THRESHOLD_SIZE, 0, 1);
}

/* The last buffer of tiles that was filled anew. */
static void expect_moved(struct snapshot *expected)
{
    const struct tile_pass *tiles = &house.gl->passes[0].tiles;
    for (int kind = TILE_PURE; kind <= TILE_CHOOSING; kind++)
        if (tiles->buffers[kind])
            expect(expected, GL_ARRAY_BUFFER_BINDING, 0, tiles->buffers[kind]);
}

static void expect_warp(struct snapshot *expected, int picture)
{
    const struct warp_pass *pass = &house.gl->passes[0];
    int kind = picture < 0 ? CUPOLA_SOURCE_VIEWS : (int)house.pictures[picture].kind;
    bool cube = kind == CUPOLA_SOURCE_CUBE;
    expect_drawn(expected, pass->programs[pass->gain != 0][kind].program);
    if (picture < 0 && house.gl->params.table == CUPOLA_TABLE_TILES)
        expect_tiles(expected);
    if (picture < 0)
        expect_views(expected);
    else
        expect_texture(expected, UNIT_IMAGE,
                       cube ? GL_TEXTURE_BINDING_CUBE_MAP : GL_TEXTURE_BINDING_2D,
                       house.pictures[picture].texture, house.gl->sampler);
    if (cube)
        expect(expected, GL_TEXTURE_CUBE_MAP_SEAMLESS, 0, 1);
}

/* Viewport and scissor rectangle are the last overlay's, somewhere in the target: not asked. */
static void expect_overlays(struct snapshot *expected, const struct snapshot *now)
{
    const struct warp_pass *pass = &house.gl->passes[0];
    const GLenum one[] = {GL_BLEND_SRC_RGB, GL_BLEND_SRC_ALPHA};
    const GLenum rest[] = {GL_BLEND_DST_RGB, GL_BLEND_DST_ALPHA};
    expect_drawn(expected, pass->overlays[pass->gain != 0].program);
    expect_texture(expected, UNIT_IMAGE, GL_TEXTURE_BINDING_2D, house.pictures[0].texture,
                   house.gl->sampler);
    expect(expected, GL_BLEND, 0, 1);
    for (int i = 0; i < 2; i++) {
        expect(expected, one[i], 0, GL_ONE);
        expect(expected, rest[i], 0, GL_ONE_MINUS_SRC_ALPHA);
    }
    for (int i = 0; i < now->count; i++)
        if ((now->entries[i].name == GL_VIEWPORT || now->entries[i].name == GL_SCISSOR_BOX) &&
            now->entries[i].of_target)
            expected->entries[i].value = now->entries[i].value;
}

/* All but what belongs to the framebuffer that is bound. */
static void check_row(struct snapshot *expected, const struct snapshot *now, const char *call)
{
    for (int i = 0; i < now->count; i++)
        if (now->entries[i].name == GL_DRAW_BUFFER0 || now->entries[i].name == GL_READ_BUFFER ||
            now->entries[i].name == GL_STENCIL_REF || now->entries[i].name == GL_STENCIL_BACK_REF)
            expected->entries[i].value = now->entries[i].value;
    assert_int_equal(snapshot_differences(expected, now, true, call), 0);
}

/* After masks that have been laid in depth, or in stencil. */
static void expect_mask(struct snapshot *expected)
{
    static const GLenum stencil[] = {GL_STENCIL_FUNC, GL_STENCIL_BACK_FUNC};
    static const GLenum ops[] = {
        GL_STENCIL_FAIL,      GL_STENCIL_PASS_DEPTH_FAIL,      GL_STENCIL_PASS_DEPTH_PASS,
        GL_STENCIL_BACK_FAIL, GL_STENCIL_BACK_PASS_DEPTH_FAIL, GL_STENCIL_BACK_PASS_DEPTH_PASS};
    const struct mask_pass *mask = &house.gl->mask;
    expect(expected, GL_CURRENT_PROGRAM, 0, mask->program);
    expect(expected, GL_VERTEX_ARRAY_BINDING, 0, mask->array);
    expect(expected, GL_ELEMENT_ARRAY_BUFFER_BINDING, 0, 0); /* the vertex array's */
    if (mask->kind == CUPOLA_MASK_DEPTH) {
        expect(expected, GL_DEPTH_FUNC, 0, GL_ALWAYS);
        expect(expected, GL_DEPTH_RANGE, 0, 0);
        expect(expected, GL_DEPTH_RANGE, 1, 1);
        return;
    }
    for (int i = 0; i < 2; i++)
        expect(expected, stencil[i], 0, GL_ALWAYS);
    for (int i = 0; i < 6; i++)
        expect(expected, ops[i], 0, GL_REPLACE);
    expect(expected, GL_STENCIL_VALUE_MASK, 0, 255);
    expect(expected, GL_STENCIL_BACK_VALUE_MASK, 0, 255);
    expect(expected, GL_STENCIL_BACK_WRITEMASK, 0, all_stencil_bits);
}

static void check_views(int which)
{
    const cupola_gl *gl = house.gl;
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_gl_view view;
    struct snapshot expected, now;
    assert_true(cupola_gl_frame_begin(house.gl, NULL, &error) > 0);
    be_hostile(which);
    snapshot_take(&expected);
    check_ok(cupola_gl_view_begin(house.gl, 0, &view, &error), "view_begin", &error);
    snapshot_take(&now);
    expect_each(&expected);
    expect_area(&expected, view.framebuffer, view.framebuffer, &view.rect);
    expect_mask(&expected);
    if (views_have_stencil(gl))
        expect(&expected, GL_STENCIL_WRITEMASK, 0, all_stencil_bits);
    check_row(&expected, &now, "view_begin");
    state_reset();
    be_hostile(which);
    snapshot_take(&expected);
    check_ok(cupola_gl_view_end(house.gl, &error), "view_end", &error);
    snapshot_take(&now);
    if (gl->resolved) {
        expect_area(&expected, gl->resolved, gl->framebuffer, &view.rect);
        expect(&expected, GL_FRAMEBUFFER_SRGB, 0, 0);
    }
    check_row(&expected, &now, "view_end");
    state_reset();
}

/* After passes all indices are the views'; the block was written through a buffer's binding. */
static void check_pass(int which)
{
    const cupola_gl *gl = house.gl;
    struct cupola_error error = {CUPOLA_OK, ""};
    struct cupola_gl_pass pass;
    struct snapshot expected, now;
    assert_true(cupola_gl_frame_begin(house.gl, NULL, &error) > 0);
    be_hostile(which);
    snapshot_take(&expected);
    check_ok(cupola_gl_pass_begin(house.gl, NULL, &pass, &error), "pass_begin", &error);
    snapshot_take(&now);
    expect_each(&expected);
    expect_mask(&expected);
    expect(&expected, GL_ARRAY_BUFFER_BINDING, 0, pass.buffer);
    expect_area(&expected, pass.framebuffer, pass.framebuffer, &pass.views[0].rect);
    for (int i = 1; i < pass.view_count; i++) {
        const struct cupola_rect *rect = &pass.views[i].rect;
        const int corners[4] = {rect->x, rect->y, rect->width, rect->height};
        for (int k = 0; k < 4; k++) {
            expect(&expected, GL_VIEWPORT, 4 * i + k, corners[k]);
            expect(&expected, GL_SCISSOR_BOX, 4 * i + k, corners[k]);
        }
        expect(&expected, GL_SCISSOR_TEST, i, 1);
    }
    if (views_have_stencil(gl))
        expect(&expected, GL_STENCIL_WRITEMASK, 0, all_stencil_bits);
    check_row(&expected, &now, "pass_begin");
    expected = now;
    check_ok(cupola_gl_pass_end(house.gl, &error), "pass_end", &error);
    snapshot_take(&now);
    if (gl->resolved) {
        expect_area(&expected, gl->resolved, gl->framebuffer,
                    &pass.views[pass.view_count - 1].rect);
        expect(&expected, GL_FRAMEBUFFER_SRGB, 0, 0);
    }
    check_row(&expected, &now, "pass_end");
    state_reset();
}

static void check_import(int which)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    struct snapshot before, expected, now;
    be_hostile(which);
    snapshot_take(&before);
    expected = before;
    check_ok(guest_import(&house, &error), "views_import", &error);
    snapshot_take(&now);
    expect_each(&expected);
    check_row(&expected, &now, "views_import");
    if (which >= 0) /* the control: there is much to be seen */
        check_at_least(snapshot_differences(&before, &now, true, NULL), 20);
    state_reset();
}

static void check_draws(int which)
{
    struct cupola_error error = {CUPOLA_OK, ""};
    struct snapshot expected, now;
    for (int i = -1; i <= GUEST_PICTURES; i++) {
        bool overlays = i == GUEST_PICTURES;
        check_ok(guest_move(&house, &error), "set_eye", &error);
        be_hostile(which);
        snapshot_take(&expected);
        check_ok(overlays ? guest_overlays(&house, &error) : guest_warp(&house, i, &error),
                 "warp or overlay", &error);
        snapshot_take(&now);
        expect_each(&expected);
        if (overlays)
            expect_overlays(&expected, &now);
        else
            expect_warp(&expected, i);
        if (house.moving && i < 0)
            expect_moved(&expected);
        check_row(&expected, &now, overlays ? "overlay" : "warp");
        state_reset();
    }
}

static double all_stencil_bits_told(void)
{
    GLfloat mask = 0;
    glGetFloatv(GL_STENCIL_WRITEMASK, &mask);
    return (double)mask;
}

static void what_is_left_is_what_the_contract_says(void **state)
{
    const struct cupola_gl_params wishes[] = {
        {.leaves_state = true},
        {.leaves_state = true,
         .format = CUPOLA_FORMAT_SRGB8,
         .depth = CUPOLA_DEPTH_24_STENCIL_8,
         .samples = 2,
         .encoding = CUPOLA_ENCODING_SRGB},
        {.leaves_state = true,
         .depth = CUPOLA_DEPTH_32F_STENCIL_8,
         .mask = CUPOLA_MASK_STENCIL,
         .table = CUPOLA_TABLE_TILES},
        {.leaves_state = true, .storage = CUPOLA_STORAGE_TEXTURES},
        {.leaves_state = true, .storage = CUPOLA_STORAGE_LAYERS},
    };
    (void)state;
    state_reset();
    all_stencil_bits = all_stencil_bits_told();
    for (int i = 0; i < 5; i++)
        for (int which = -1; which <= HOSTILITIES; which += HOSTILITIES + 1)
            for (int gained = 0; gained < 2; gained++) {
                struct cupola_error error = {CUPOLA_OK, ""};
                check_ok(guest_gl_create(&house, &wishes[i], &error), "create", &error);
                check_ok(cupola_gl_set_gain(house.gl, 0, gained ? house.gain : 0, &error), "gain",
                         &error);
                if (wishes[i].storage == CUPOLA_STORAGE_ATLAS)
                    check_views(which);
                if (house.one_pass)
                    check_pass(which);
                if (wishes[i].storage != CUPOLA_STORAGE_ATLAS)
                    check_import(which);
                check_draws(which);
                cupola_gl_destroy(&house.gl);
            }
}

static void what_a_warp_for_a_moved_eye_leaves_is_that_too(void **state)
{
    static const enum cupola_table stages[] = {CUPOLA_TABLE_POINTS, CUPOLA_TABLE_SINES,
                                               CUPOLA_TABLE_TILES};
    (void)state;
    guest_house_release(&house);
    guest_house_build_moving(&house);
    state_reset();
    for (int i = 0; i < 3; i++)
        for (int which = -1; which <= HOSTILITIES; which += HOSTILITIES + 1) {
            const struct cupola_gl_params params = {.leaves_state = true,
                                                    .table = guest_moving_table(stages[i])};
            struct cupola_error error = {CUPOLA_OK, ""};
            check_ok(guest_gl_create(&house, &params, &error), "create", &error);
            check_draws(which);
            cupola_gl_destroy(&house.gl);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_left_is_what_the_contract_says),
        cmocka_unit_test(what_a_warp_for_a_moved_eye_leaves_is_that_too),
    };
    return cmocka_run_group_tests_name("state_rows", tests, open_house, close_house);
}
