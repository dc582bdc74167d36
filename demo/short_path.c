/* Paths in messages. */
#include "short_path.h"

#include <string.h>

/* Whether a byte continues a character of UTF-8. */
static int continues(char byte)
{
    return ((unsigned char)byte & 0xc0) == 0x80;
}

struct short_path short_path(const char *path)
{
    static const char gap[] = "...";
    struct short_path result;
    size_t length = strlen(path), half = (SHORT_PATH_MAX - strlen(gap)) / 2;
    size_t head = half, tail = half;

    if (length <= SHORT_PATH_MAX) {
        memcpy(result.text, path, length + 1);
        return result;
    }
    for (int i = 0; i < 3 && continues(path[head]); i++)
        head--;
    for (int i = 0; i < 3 && continues(path[length - tail]); i++)
        tail--;
    memcpy(result.text, path, head);
    memcpy(result.text + head, gap, strlen(gap));
    memcpy(result.text + head + strlen(gap), path + length - tail, tail + 1);
    return result;
}
