/* What a GL's compiler says about a shader is told with the right file and line. */
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "context.h"
#include "gl/program.h"

static int setup(void **state)
{
    (void)state;
    context_open();
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    context_close();
    return 0;
}

static void check_place(const char *first, const char *last, const char *place)
{
    const struct shader_file files[] = {{"first.glsl", first}, {"last.frag", last}};
    struct cupola_error error = {CUPOLA_OK, ""};
    assert_int_equal(program_create("#define ONE 1\n#define TWO 2\n", files, 2, &error), 0);
    assert_int_equal(error.status, CUPOLA_ERROR_GL);
    printf("  %s\n", error.message);
    if (!strstr(error.message, place) || !strstr(error.message, "refused last.frag"))
        fail_msg("'%s' does not say '%s'", error.message, place);
    if (strchr(error.message, '\n'))
        fail_msg("'%s' has more than one line", error.message);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

static void error_in_the_first_file_is_placed_there(void **state)
{
    (void)state;
    check_place("float one()\n{\n    return missing;\n}\n",
                "out vec4 color;\nvoid main() { color = vec4(one()); }\n", "first.glsl:3");
    check_place("float one() { return = 1.0; }\n",
                "out vec4 color;\nvoid main() { color = vec4(one()); }\n", "first.glsl:1");
}

static void error_in_the_last_file_is_placed_there(void **state)
{
    (void)state;
    check_place("float one() { return 1.0; }\n\n\n",
                "// nothing\n\nout vec4 color;\nvoid main() { color = vec4(missing); }\n",
                "last.frag:4");
    check_place("float one() { return 1.0; }\n",
                "out vec4 color;\nvoid main() { color = vec4(one()) }\n", "last.frag:2");
    check_place("", "out vec4 color;\n#error here\nvoid main() {}\n", "last.frag:2");
}

static void a_long_log_is_cut_off(void **state)
{
    char text[4000] = "out vec4 color;\nvoid main() {\n";
    (void)state;
    for (int i = 0; i < 100; i++)
        strcat(text, "color = vec4(missing);\n");
    strcat(text, "}\n");
    check_place("", text, "last.frag:3");
}

static void whole_shaders_are_made(void **state)
{
    const struct shader_file file = {"good.frag", "out vec4 color;\n"
                                                  "void main() { color = vec4(ONE); }\n"};
    struct cupola_error error = {CUPOLA_OK, ""};
    (void)state;
    GLuint program = program_create("#define ONE 1\n", &file, 1, &error);
    assert_int_not_equal(program, 0);
    assert_int_equal(error.status, CUPOLA_OK);
    glDeleteProgram(program);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(error_in_the_first_file_is_placed_there),
        cmocka_unit_test(error_in_the_last_file_is_placed_there),
        cmocka_unit_test(a_long_log_is_cut_off),
        cmocka_unit_test(whole_shaders_are_made),
    };
    return cmocka_run_group_tests_name("shader_errors", tests, setup, teardown);
}
