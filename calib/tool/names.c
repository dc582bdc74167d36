/* Words for what the tool can show and change. */
#include <stddef.h>

#include "tool/tool.h"

const char *tool_group_name(enum group group)
{
    static const char *const names[GROUP_COUNT] = {
        [GROUP_CIRCLE] = "image circle",
        [GROUP_LENS] = "lens",
        [GROUP_POSITION] = "projector position",
        [GROUP_AIM] = "projector aim",
        [GROUP_SCREEN] = "screen",
        [GROUP_VIEWER] = "viewer",
        [GROUP_DOT] = "dot",
        [GROUP_MARKS] = "marks",
    };

    return names[group];
}

const char *tool_group_word(int group)
{
    static const char *const words[GROUP_COUNT] = {
        [GROUP_CIRCLE] = "circle", [GROUP_LENS] = "lens",     [GROUP_POSITION] = "position",
        [GROUP_AIM] = "aim",       [GROUP_SCREEN] = "screen", [GROUP_VIEWER] = "viewer",
        [GROUP_DOT] = "dot",       [GROUP_MARKS] = "marks",
    };

    return group >= 0 && group < GROUP_COUNT ? words[group] : NULL;
}

const char *tool_pattern_name(int pattern)
{
    static const char *const names[PATTERN_COUNT] = {
        [PATTERN_GRID] = "grid",       [PATTERN_MERIDIANS] = "meridians",
        [PATTERN_CIRCLES] = "circles", [PATTERN_CHECKER] = "checker",
        [PATTERN_WEDGES] = "wedges",   [PATTERN_RAMPS] = "ramps",
        [PATTERN_RIM] = "rim",         [PATTERN_DOT] = "dot",
    };

    return pattern >= 0 && pattern < PATTERN_COUNT ? names[pattern] : NULL;
}

const char *tool_about_name(int about)
{
    static const char *const names[ABOUT_COUNT] = {"dome", "viewer"};

    return about >= 0 && about < ABOUT_COUNT ? names[about] : NULL;
}

const char *tool_preview_name(int preview)
{
    static const char *const names[PREVIEW_COUNT] = {"none", "eye", "outside"};

    return preview >= 0 && preview < PREVIEW_COUNT ? names[preview] : NULL;
}
