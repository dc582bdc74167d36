/*
 * Numbers of samples that colour and depth do not have alike: both get the smallest that either
 * may have. The GL's lists are replaced, and so is the making of renderbuffers: a GL with such
 * lists would make what it is asked for.
 */
#include <stdio.h>

#include "group.h"
#include "rig_random.h"

enum { COUNTS_MAX = 4, MADE_MAX = 8 };

static struct lists {
    GLint color[COUNTS_MAX], depth[COUNTS_MAX]; /* in falling order; 0 ends */
} lists;

static GLsizei made[MADE_MAX];
static int made_count;

static void (*real_storage)(GLenum target, GLsizei samples, GLenum format, GLsizei width,
                            GLsizei height);
static void (*real_format)(GLenum target, GLenum format, GLenum name, GLsizei room, GLint *values);

static void answer_format(GLenum target, GLenum format, GLenum name, GLsizei room, GLint *values)
{
    (void)target;
    const GLint *list = format == GL_RGBA8 ? lists.color : lists.depth;
    int count = 0;
    while (count < COUNTS_MAX && list[count])
        count++;
    if (name == GL_NUM_SAMPLE_COUNTS)
        *values = count;
    for (int i = 0; name == GL_SAMPLES && i < count && i < room; i++)
        values[i] = list[i];
}

static void note_storage(GLenum target, GLsizei samples, GLenum format, GLsizei width,
                         GLsizei height)
{
    made[made_count++ % MADE_MAX] = samples;
    glRenderbufferStorage(target, format, width, height);
}

static int create(const cupola_plan *plan, int samples, struct cupola_error *error)
{
    const struct cupola_gl_params params = {
        .samples = samples, .depth = CUPOLA_DEPTH_24, .table = CUPOLA_TABLE_NONE};
    cupola_gl *gl = NULL;
    real_format = epoxy_glGetInternalformativ;
    real_storage = epoxy_glRenderbufferStorageMultisample;
    epoxy_glGetInternalformativ = answer_format;
    epoxy_glRenderbufferStorageMultisample = note_storage;
    made_count = 0;
    int status = cupola_gl_create(plan, &params, &gl, error);
    epoxy_glGetInternalformativ = real_format;
    epoxy_glRenderbufferStorageMultisample = real_storage;
    cupola_gl_destroy(&gl);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    return status;
}

static bool lists_are_asked_for(void)
{
    return context_has(42, "GL_ARB_internalformat_query", 30, NULL);
}

static void color_and_depth_get_the_same_number(void **state)
{
    static const struct {
        struct lists lists;
        int wished, expected;
    } cases[] = {
        {{{4}, {4, 2}}, 2, 4},       {{{4, 2}, {4}}, 2, 4}, {{{8, 4, 2}, {8, 6, 2}}, 3, 8},
        {{{8, 4, 2}, {8, 2}}, 2, 2}, {{{4}, {4}}, 1, 0},
    };
    struct cupola_error error = {CUPOLA_OK, ""};
    struct fixture fixture;
    const struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 90.0, 32);
    (void)state;
    if (!lists_are_asked_for())
        skip();
    fixture_make(&rig, NULL, NULL, &fixture);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        lists = cases[i].lists;
        if (create(fixture.plan, cases[i].wished, &error) != CUPOLA_OK)
            fail_msg("case %zu: %s", i, error.message);
        assert_int_equal(made_count, cases[i].expected ? 2 : 0);
        for (int k = 0; k < made_count; k++)
            assert_int_equal(made[k], cases[i].expected);
    }
    fixture_release(&fixture);
}

static void what_they_do_not_have_in_common_is_refused(void **state)
{
    static const struct {
        struct lists lists;
        int wished;
        const char *allowed;
    } cases[] = {
        {{{8, 4}, {6, 4, 2}}, 5, "0 to 4, of which it has 1, 4"},
        {{{8}, {4, 2}}, 2, "0 to 1, of which it has 1"},
        {{{0}, {4}}, 2, "0 to 1, of which it has 1"},
        {{{8, 4}, {8, 4}}, -1, "0 to 8, of which it has 1, 4, 8"},
        {{{8, 4}, {8, 4}}, 1000, "0 to 8, of which it has 1, 4, 8"},
    };
    struct cupola_error error = {CUPOLA_OK, ""};
    struct fixture fixture;
    const struct cupola_rig rig = plain_rig(CUPOLA_LENS_ANGULAR, 90.0, 32);
    (void)state;
    if (!lists_are_asked_for())
        skip();
    fixture_make(&rig, NULL, NULL, &fixture);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        lists = cases[i].lists;
        assert_int_equal(create(fixture.plan, cases[i].wished, &error), CUPOLA_ERROR_ARGUMENT);
        assert_int_equal(made_count, 0);
        if (!strstr(error.message, cases[i].allowed))
            fail_msg("case %zu: %s", i, error.message);
    }
    fixture_release(&fixture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(color_and_depth_get_the_same_number),
        cmocka_unit_test(what_they_do_not_have_in_common_is_refused),
    };
    return run_gpu_group("sample_counts", tests);
}
