/* What --stats says of the plan and of how it is carried out. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "process.h"

static struct process process;

/* What follows a key; fails without one. */
static const char *stated(const char *key)
{
    char name[60];
    const char *at;

    snprintf(name, sizeof name, "\"%s\": ", key);
    at = strstr(process.out, name);
    if (!at)
        fail_msg("the statistics have no %s", key);
    return at + strlen(name);
}

static double number(const char *key)
{
    return strtod(stated(key), NULL);
}

static void check_text(const char *key, const char *text)
{
    if (strncmp(stated(key), text, strlen(text)) != 0)
        fail_msg("%s is %.60s; it should begin with %s", key, stated(key), text);
}

/* The statistics of one frame of the room, 48 pixels wide. */
static void run(const char *options)
{
    char command[300];

    snprintf(command, sizeof command, "--size 48x48 --frames 1 --stats - --output x.png %s",
             options);
    process_run(&process, command, NULL);
    if (process.status != 0)
        fail_msg("%s: %s", options, process.err);
}

static void they_say_how_the_plan_is_carried_out(void **state)
{
    (void)state;
    run("");
    check_text("mask", "\"depth\",");
    check_text("table", "\"tiles\",");
    run("--mask stencil --submission once --table sines");
    check_text("mask", "\"stencil\",");
    check_text("table", "\"sines\",");
    check_text("submission", strstr(process.err, "one by one") ? "\"loop\"," : "\"once\",");
    run("--mask none --submission loop --table auto");
    check_text("mask", "\"none\",");
    check_text("submission", "\"loop\",");
    check_text("table", "\""); /* which of them is a matter of the machine */
    assert_int_not_equal(strncmp(stated("table"), "\"auto", 5), 0);
    run("--perspective --fov 90");
    check_text("mask", "null,");
    check_text("submission", "null,");
    check_text("table", "null,");
}

static void they_say_why_the_plan_is_as_it_is(void **state)
{
    (void)state;
    run("--fov 140");
    assert_non_null(strstr(stated("reason"), "cost least"));
    run("--fov 140 --layout asymmetric --views 3");
    check_text("reason", "\"3 asymmetric views (1x3), as asked, cost ");
    assert_non_null(strstr(stated("reason"), "under a mask"));
    run("--fov 140 --mask none");
    assert_null(strstr(stated("reason"), "under a mask"));
}

/* The same views, forced: a mask leaves less to be shaded, and says so. */
static void a_mask_shades_less(void **state)
{
    double all;

    (void)state;
    run("--fov 140 --layout asymmetric --views 3 --mask none");
    all = number("texels_shaded_per_pixel");
    check_near(all, number("texels_in_views_per_pixel"), 0);
    check_at_most(number("texels_masked_per_pixel"), 0.9 * all);
    run("--fov 140 --layout asymmetric --views 3 --mask depth");
    check_near(number("texels_shaded_per_pixel"), number("texels_masked_per_pixel"), 0);
    check_at_most(number("texels_shaded_per_pixel"), 0.9 * all);
    check_at_most(number("texels_shaded_per_pixel"), number("texels_in_views_per_pixel"));
    check_at_most(number("texels_in_views_per_pixel"), number("texels_allocated_per_pixel"));
}

static void measured_prices_are_named(void **state)
{
    (void)state;
    run("--goal auto");
    if (!strstr(process.err, "usual prices"))
        check_at_least(number("price_view"), 0);
    assert_null(strstr(process.out, "e-09"));
    assert_null(strstr(process.err, "one by one"));
    run("--goal fill");
    assert_null(strstr(process.out, "price_"));
}

static void one_pass_is_not_dropped_without_a_word(void **state)
{
    (void)state;
    run("--goal auto --submission once");
    assert_non_null(strstr(process.err, "--submission once: --goal auto"));
    check_text("submission", "\"loop\",");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(they_say_how_the_plan_is_carried_out),
        cmocka_unit_test(they_say_why_the_plan_is_as_it_is),
        cmocka_unit_test(a_mask_shades_less),
        cmocka_unit_test(measured_prices_are_named),
        cmocka_unit_test(one_pass_is_not_dropped_without_a_word),
    };
    return cmocka_run_group_tests(tests, process_enter_directory, process_leave_directory);
}
