/* Files of marks: what is read, what is refused and in which words, what is written. */
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "check.h"
#include "marks.h"
#include "option_values.h"

static char directory[] = "/tmp/cupola-marks-XXXXXX";

static int enter(void **state)
{
    (void)state;
    return mkdtemp(directory) && chdir(directory) == 0 ? 0 : -1;
}

static int leave(void **state)
{
    (void)state;
    unlink("marks.csv");
    unlink("link.csv");
    return chdir("/") == 0 && rmdir(directory) == 0 ? 0 : -1;
}

static void write_bytes(const char *bytes, size_t size)
{
    FILE *file = fopen("marks.csv", "wb");

    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

static void expect_read(const char *text, bool needs_pixels, struct marks *marks)
{
    char message[MESSAGE_SIZE] = "";

    write_bytes(text, strlen(text));
    if (!marks_read("marks.csv", needs_pixels, marks, message))
        fail_msg("refused: %s", message);
}

static void expect_refused(const char *text, const char *said)
{
    char message[MESSAGE_SIZE] = "";
    struct marks marks;

    write_bytes(text, strlen(text));
    assert_false(marks_read("marks.csv", true, &marks, message));
    assert_null(marks.list);
    assert_null(strchr(message, '\n'));
    if (!strstr(message, said))
        fail_msg("'%s' does not say '%s'", message, said);
}

static void columns_may_stand_in_any_order(void **state)
{
    struct marks marks;

    (void)state;
    expect_read("\xef\xbb\xbf# by hand\r\n\r\n z_m, name ,x_px,\"y_px\",x_m,y_m\r\n"
                "  # more\r\n -3 , \"left, \"\"low\"\"\" , 10.5,\t-4,1e0,2\r\n4,#5 ,1,1,1,1",
                true, &marks);
    assert_int_equal(marks.kind, MARKS_POINTS);
    assert_int_equal(marks.count, 2);
    assert_string_equal(marks.list[0].name, "left, \"low\"");
    assert_string_equal(marks.list[1].name, "#5");
    const double expected[] = {1, 2, -3};
    for (int i = 0; i < 3; i++)
        check_near(marks.list[0].place[i], expected[i], 0);
    check_near(marks.list[0].pixel_px[0], 10.5, 0);
    check_near(marks.list[0].pixel_px[1], -4, 0);
    assert_true(marks.list[0].steered);
    marks_free(&marks);
}

static void directions_get_unit_length(void **state)
{
    struct marks marks;

    (void)state;
    expect_read("name,x_px,y_px,dir_x,dir_y,dir_z\na,1,2,0,3e-300,-4e-300\nb,1,2,3e300,0,4e300\n",
                true, &marks);
    check_near(marks.list[0].place[1], 0.6, 1e-15);
    check_near(marks.list[0].place[2], -0.8, 1e-15);
    check_near(marks.list[1].place[0], 0.6, 1e-15);
    marks_free(&marks);
}

static void pixels_may_be_missing_only_where_they_are_not_needed(void **state)
{
    struct marks marks;

    (void)state;
    expect_read("name,x_m,y_m,z_m\na,1,2,3\n", false, &marks);
    assert_false(marks.list[0].steered);
    marks_free(&marks);
    expect_read("name,x_px,y_px,x_m,y_m,z_m\na,,,1,2,3\nb,7,8,1,2,3\n", false, &marks);
    assert_false(marks.list[0].steered);
    assert_true(marks.list[1].steered);
    marks_free(&marks);
    expect_refused("name,x_m,y_m,z_m\na,1,2,3\n", "marks.csv:1: column x_px is missing");
    expect_refused("name,x_px,y_px,x_m,y_m,z_m\na,,,1,2,3\n", "marks.csv:2: x_px: ''");
}

static void what_is_wrong_is_named_with_its_line(void **state)
{
#define HEAD "name,x_px,y_px,dir_x,dir_y,dir_z\n"
    static const char *const cases[][2] = {
        {"", "there is no header"},
        {"# only this\n", "there is no header"},
        {HEAD, "no marks"},
        {"name,x_px,y_px,dir_x,dir_y\na,1,1,1,1\n", "marks.csv:1: column dir_z is missing"},
        {"name,x_px,y_px\na,1,1\n", "column dir_x is missing"},
        {"name,x_px,y_px,dir_x,dir_y,dir_z,x_m\n", "one kind"},
        {"name,name,x_px,y_px,x_m,y_m,z_m\n", "column name is there twice"},
        {"name,x,y_px,x_m,y_m,z_m\n", "'x' is no column"},
        {HEAD "a,1,1,1,1,1\n\n# \na,1,1,1,1,2\n", "marks.csv:5: name: 'a' is that of line 2"},
        {HEAD "a,1,1,1,1\n", "marks.csv:2: has 5 fields; allowed: 6"},
        {HEAD "a,1,1,1,1,1,\n", "has 7 fields"},
        {HEAD "a,nan,1,1,1,1\n", "marks.csv:2: x_px: 'nan'"},
        {HEAD "a,1,inf,1,1,1\n", "y_px: 'inf'"},
        {HEAD "a,1,1e400,1,1,1\n", "y_px: '1e400'"},
        {HEAD "a,1,2e7,1,1,1\n", "-1e+07 to 1e+07"},
        {HEAD "a,1,1,1,0x1,1\n", "dir_y: '0x1'"},
        {HEAD "a,1,1,0,0,-0\n", "any length above 0"},
        {HEAD ",1,1,0,0,1\n", "name: ''"},
        {HEAD "\"a,1,1,0,0,1\n", "quote is not closed"},
        {HEAD "\"a\"b,1,1,0,0,1\n", "'b,1,1,0,0,1' after a closing quote"},
        {HEAD "a\x01,1,1,0,0,1\n", "control characters"},
        {HEAD "\xc3,1,1,0,0,1\n", "UTF-8"},
        {HEAD "\xc0\x80,1,1,0,0,1\n", "UTF-8"},
        {HEAD "0123456789012345678901234567890123456789012345678901234567890123,1,1,0,0,1\n",
         "1 to 63 bytes"},
        {"name,x_px,y_px,x_m,y_m,z_m\na,1,1,1001,1,1\n", "-1000 to 1000"},
    };

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        expect_refused(cases[i][0], cases[i][1]);
}

/* As many as are allowed, and one more. */
static void their_number_has_an_exact_limit(void **state)
{
    enum { LINE_SIZE = 32 };
    size_t used = 0;
    char *text = malloc((MARKS_MAX + 2) * LINE_SIZE), said[80];
    struct marks marks;

    (void)state;
    assert_non_null(text);
    used += (size_t)sprintf(text, "name,x_px,y_px,dir_x,dir_y,dir_z\n");
    for (int i = 0; i < MARKS_MAX; i++)
        used += (size_t)sprintf(text + used, "m%d,1,2,0,0,-1\n", i);
    expect_read(text, true, &marks);
    assert_int_equal(marks.count, MARKS_MAX);
    marks_free(&marks);
    sprintf(text + used, "more,1,2,0,0,-1\n");
    snprintf(said, sizeof said, "marks.csv:%d: is one mark too many; allowed: up to %d",
             MARKS_MAX + 2, MARKS_MAX);
    expect_refused(text, said);
    free(text);
}

static void files_that_are_none_are_refused(void **state)
{
    char message[MESSAGE_SIZE] = "";
    struct marks marks;

    (void)state;
    assert_false(marks_read("absent.csv", true, &marks, message));
    assert_non_null(strstr(message, "absent.csv: cannot be read"));
    assert_false(marks_read(".", true, &marks, message));
    write_bytes("name\0,", 6);
    assert_false(marks_read("marks.csv", true, &marks, message));
    assert_non_null(strstr(message, "byte of value 0"));
}

static void what_is_written_reads_back_to_the_last_bit(void **state)
{
    uint64_t seed = 7;
    char message[MESSAGE_SIZE] = "";
    struct marks marks = {0}, again, third;
    FILE *file = fopen("marks.csv", "w");

    (void)state;
    fputs("name,x_px,y_px,dir_x,dir_y,dir_z\n", file);
    for (int i = 0; i < 500; i++)
        fprintf(file, "\" n\"\"%d\xc3\xa9,\",%.17g,%.17g,%.17g,%.17g,%.17g\n", i,
                random_between(&seed, -9e6, 9e6), random_between(&seed, -1e-6, 1e-6),
                random_between(&seed, -3, 3), random_between(&seed, -1e-9, 1e-9),
                random_between(&seed, -1, 1));
    fclose(file);
    assert_true(marks_read("marks.csv", true, &marks, message));
    marks.list[3].steered = false;
    marks.list[3].pixel_px[0] = marks.list[3].pixel_px[1] = 0;
    assert_int_equal(symlink("marks.csv", "link.csv"), 0);
    assert_true(marks_write("link.csv", &marks, message));
    struct stat link;
    assert_int_equal(lstat("link.csv", &link), 0);
    assert_true(S_ISLNK(link.st_mode));
    assert_true(marks_read("marks.csv", false, &again, message));
    assert_int_equal(again.count, marks.count);
    assert_memory_equal(again.list, marks.list, (size_t)marks.count * sizeof *marks.list);
    marks.kind = MARKS_POINTS;
    assert_true(marks_write("marks.csv", &marks, message));
    assert_true(marks_read("marks.csv", false, &third, message));
    assert_int_equal(third.kind, MARKS_POINTS);
    assert_memory_equal(third.list, marks.list, (size_t)marks.count * sizeof *marks.list);
    marks_free(&marks);
    marks_free(&again);
    marks_free(&third);
}

static void a_file_that_cannot_be_written_stays_as_it_was(void **state)
{
    char message[MESSAGE_SIZE] = "";
    struct mark mark = {.name = "a", .place = {1, 0, 0}};
    struct marks marks = {.list = &mark, .count = 1};

    (void)state;
    assert_false(marks_write("absent/marks.csv", &marks, message));
    assert_non_null(strstr(message, "absent/marks.csv: cannot be written"));
    assert_false(marks_write("/dev/null", &marks, message));
    assert_non_null(strstr(message, "no plain file"));
}

/* Half of the bytes that go in are those that mean something. */
static char rubbish(uint64_t *seed)
{
    static const char telling[] = ",,,\"\"\n\r# \t-0.e+namexyz_px";

    return random_between(seed, 0, 1) < 0.5
               ? telling[(size_t)random_between(seed, 0, sizeof telling - 1)]
               : (char)(int)random_between(seed, -128, 128);
}

static void rubbish_is_refused_in_one_line_or_read(void **state)
{
    static const char sound[] = "name,x_px,y_px,dir_x,dir_y,dir_z\n\"a, \"\"b\",1,2,0,0,-1\n"
                                "# note\r\nc,3.5e2,-4,1,1,1\nd,5,6,0.1,0.2,0.3\n";
    uint64_t seed = 11;
    int read = 0;

    (void)state;
    for (int i = 0; i < 1500; i++) {
        char text[sizeof sound], message[MESSAGE_SIZE] = "";
        size_t size = sizeof sound - 1;
        struct marks marks;
        memcpy(text, sound, size);
        for (int n = (int)random_between(&seed, 1, 3.5); n > 0; n--)
            text[(size_t)random_between(&seed, 0, (double)size)] = rubbish(&seed);
        if (random_between(&seed, 0, 1) < 0.2)
            size = (size_t)random_between(&seed, 0, (double)size);
        write_bytes(text, size);
        if (marks_read("marks.csv", i % 2, &marks, message)) {
            read++;
            assert_true(marks.count > 0);
        } else {
            assert_null(marks.list);
            assert_true(*message && !strchr(message, '\n'));
        }
        marks_free(&marks);
    }
    assert_in_range(read, 20, 1400);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(columns_may_stand_in_any_order),
        cmocka_unit_test(directions_get_unit_length),
        cmocka_unit_test(pixels_may_be_missing_only_where_they_are_not_needed),
        cmocka_unit_test(what_is_wrong_is_named_with_its_line),
        cmocka_unit_test(their_number_has_an_exact_limit),
        cmocka_unit_test(files_that_are_none_are_refused),
        cmocka_unit_test(what_is_written_reads_back_to_the_last_bit),
        cmocka_unit_test(a_file_that_cannot_be_written_stays_as_it_was),
        cmocka_unit_test(rubbish_is_refused_in_one_line_or_read),
    };

    return cmocka_run_group_tests_name("marks", tests, enter, leave);
}
