/* Ways of antialiasing by name. */
#include "method.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool take_samples(const char *word, int *samples)
{
    char *end = NULL;
    long value = strtol(word, &end, 10);

    if (end == word || *end || value < 1 || value > CUPOLA_RAYS_MAX)
        return false;
    *samples = (int)value;
    return true;
}

/* The part of a name whose index that is, behind a colon each. */
static bool take_part(int index, const char *word, struct cupola_filter *filter)
{
    int found;

    switch (index) {
    case 0:
        found = cupola_antialiasing_find(word);
        filter->method = (enum cupola_antialiasing)found;
        return found >= 0;
    case 1:
        return take_samples(word, &filter->samples);
    case 2:
        found = cupola_pattern_find(word);
        filter->pattern = (enum cupola_pattern)found;
        return found >= 0;
    case 3:
        filter->turned = true;
        return strcmp(word, "turned") == 0;
    }
    return false;
}

bool method_find(const char *text, struct method *method)
{
    char parts[METHOD_NAME];
    int index = 0;

    *method = (struct method){{0}};
    if (strlen(text) >= sizeof parts)
        return false;
    snprintf(method->name, sizeof method->name, "%s", text);
    snprintf(parts, sizeof parts, "%s", text);
    for (char *word = parts; word; index++) {
        char *colon = strchr(word, ':');
        if (colon)
            *colon++ = '\0';
        if (!take_part(index, word, &method->filter))
            return false;
        word = colon;
    }
    return true;
}
