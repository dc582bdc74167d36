/* Text that a terminal shows and does not obey. */
#include "plain_text.h"

#include <stddef.h>

/* Length of the character that begins here, from 1; 0 where there is none (RFC 3629). */
static size_t sequence_length(const unsigned char *at)
{
    static const unsigned least[] = {0, 0, 0xa0, 0x800, 0x10000}; /* below 0xa0 are controls */
    size_t length = at[0] < 0x80   ? 1
                    : at[0] < 0xc2 ? 0
                    : at[0] < 0xe0 ? 2
                    : at[0] < 0xf0 ? 3
                    : at[0] < 0xf5 ? 4
                                   : 0;
    unsigned code = at[0] & (0xffu >> (length + 1));

    if (length == 1)
        return 1;
    for (size_t i = 1; i < length; i++) {
        if ((at[i] & 0xc0) != 0x80)
            return 0;
        code = code << 6 | (at[i] & 0x3fu);
    }
    bool possible =
        length > 0 && code >= least[length] && code <= 0x10ffff && (code < 0xd800 || code > 0xdfff);
    return possible && code != 0x2028 && code != 0x2029 ? length : 0;
}

/* The same, 0 for control characters of one byte, too. */
static size_t character_length(const unsigned char *at)
{
    return *at < 0x20 || *at == 0x7f ? 0 : sequence_length(at);
}

bool plain_text_is(const char *text)
{
    const unsigned char *at = (const unsigned char *)text;

    while (*at) {
        size_t length = character_length(at);
        if (length == 0)
            return false;
        at += length;
    }
    return true;
}

void plain_text_print(const char *text, FILE *stream)
{
    const unsigned char *at = (const unsigned char *)text;

    while (*at) {
        size_t length = character_length(at);
        if (length == 0)
            fputc('?', stream);
        else
            fwrite(at, 1, length, stream);
        at += length ? length : 1;
    }
}
