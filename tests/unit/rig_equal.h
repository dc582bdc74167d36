/* Rigs that are the same to the last bit, and the way through a file. */
#ifndef RIG_EQUAL_H
#define RIG_EQUAL_H

#include "check.h"
#include "cupola/rig_file.h"
#include "folder.h"

static inline void check_bits(double actual, double expected)
{
    if (memcmp(&actual, &expected, sizeof actual) != 0)
        print_error("%.17g instead of %.17g\n", actual, expected);
    assert_memory_equal(&actual, &expected, sizeof actual);
}

static inline void check_lens_equal(const struct cupola_lens *a, const struct cupola_lens *b)
{
    assert_int_equal(a->model, b->model);
    check_bits(a->fov_rad, b->fov_rad);
    for (int i = 0; a->model == CUPOLA_LENS_POLYNOMIAL && i < 4; i++)
        check_bits(a->k[i], b->k[i]);
    if (a->model != CUPOLA_LENS_TABLE)
        return;
    assert_int_equal(a->table_count, b->table_count);
    for (int i = 0; i < a->table_count; i++) {
        check_bits(a->table[i].angle_rad, b->table[i].angle_rad);
        check_bits(a->table[i].radius, b->table[i].radius);
    }
}

static inline void check_output_equal(const struct cupola_output *a, const struct cupola_output *b)
{
    assert_int_equal(a->width_px, b->width_px);
    assert_int_equal(a->height_px, b->height_px);
    assert_int_equal(a->flip, b->flip);
    assert_memory_equal(&a->circle, &b->circle, sizeof a->circle);
    assert_memory_equal(a->position_m, b->position_m, sizeof a->position_m);
    assert_memory_equal(&a->aim, &b->aim, sizeof a->aim);
    check_lens_equal(&a->lens, &b->lens);
}

static inline void check_rig_equal(const struct cupola_rig *a, const struct cupola_rig *b)
{
    check_bits(a->screen.radius_m, b->screen.radius_m);
    check_bits(a->screen.cap_rad, b->screen.cap_rad);
    assert_memory_equal(a->eye_m, b->eye_m, sizeof a->eye_m);
    check_bits(a->tilt_rad, b->tilt_rad);
    check_bits(a->units_per_metre, b->units_per_metre);
    assert_int_equal(a->output_count, b->output_count);
    for (int i = 0; i < a->output_count; i++)
        check_output_equal(&a->outputs[i], &b->outputs[i]);
}

static inline void check_round_trip(const struct cupola_rig *rig)
{
    struct cupola_rig complete, read;
    struct cupola_error error = {0};
    assert_int_equal(cupola_rig_complete(rig, &complete, NULL), CUPOLA_OK);
    if (cupola_rig_write(in_folder("rig.cfg"), rig, &error) != CUPOLA_OK ||
        cupola_rig_read(in_folder("rig.cfg"), NULL, &read, &error) != CUPOLA_OK)
        fail_msg("%s", error.message);
    check_rig_equal(&read, &complete);
}

#endif
