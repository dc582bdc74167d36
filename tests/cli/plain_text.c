/* What goes to a terminal: characters as they are, anything else as question marks. */
#include "plain_text.h"

#include <string.h>

#include "check.h"

static const struct {
    const char *text, *shown;
} texts[] = {
    {"", ""},
    {"plain ~", "plain ~"},
    {"a\tb\nc\x7f", "a?b?c?"},
    {"\x1b[2J", "?[2J"},
    {"\xc3\xbc\xe2\x82\xac\xf0\x9f\x98\x80", "\xc3\xbc\xe2\x82\xac\xf0\x9f\x98\x80"},
    {"\xc2\x9b\xc2\xa0", "??\xc2\xa0"},          /* a control of two bytes */
    {"\xff\xe4x\x80", "??x?"},                   /* no beginning of a character */
    {"\xc3", "?"},                               /* cut off */
    {"\xe2\x82", "??"},                          /* likewise */
    {"\xc0\xaf\xe0\x80\xaf", "?????"},           /* longer than they must be */
    {"\xed\xa0\x80\xf4\x90\x80\x80", "???????"}, /* surrogates, beyond the last */
    {"\xe2\x80\xa8 \xe2\x80\xa9", "??? ???"},    /* line and paragraph separators */
};

static void what_is_no_text_becomes_question_marks(void **state)
{
    char shown[40];

    (void)state;
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        FILE *stream = fmemopen(shown, sizeof shown, "w");
        assert_non_null(stream);
        plain_text_print(texts[i].text, stream);
        fputc(0, stream);
        assert_int_equal(fclose(stream), 0);
        assert_string_equal(shown, texts[i].shown);
    }
}

static void plain_is_what_is_shown_as_it_is(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        assert_int_equal(plain_text_is(texts[i].text), strcmp(texts[i].text, texts[i].shown) == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_no_text_becomes_question_marks),
        cmocka_unit_test(plain_is_what_is_shown_as_it_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
