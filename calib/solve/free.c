/* Names of what is solved for. */
#include <stdio.h>
#include <string.h>

#include "option_values.h"
#include "solve/solve.h"

const char *solve_free_name(int index)
{
    static const char *const names[] = {"circle",   "circle-radius", "lens",
                                        "position", "aim",           "radius"};
    const int count = sizeof names / sizeof *names;

    return index >= 0 && index < count ? names[index] : NULL;
}

const char *solve_flip_name(int flip)
{
    static const char *const names[] = {"none", "x", "y", "xy"};

    return flip >= 0 && flip < 4 ? names[flip] : NULL;
}

bool solve_free_parse(const char *option, const char *text, int *free, char *message)
{
    int parsed = 0;
    const char *at = text;

    for (;;) {
        char word[32];
        int index;
        size_t length = strcspn(at, ",");
        size_t taken = length < sizeof word ? length : sizeof word - 1;
        memcpy(word, at, taken);
        word[taken] = 0;
        if (!value_name(&(struct value_context){option, message}, word, solve_free_name, &index))
            return false;
        if (parsed & 1 << index) {
            snprintf(message, MESSAGE_SIZE, "%s: '%s' is there twice; allowed: each name once",
                     option, word);
            return false;
        }
        parsed |= 1 << index;
        if (!at[length])
            break;
        at += length + 1;
    }
    *free = parsed;
    return true;
}
