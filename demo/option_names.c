/* The words that options allow. */
#include "option_names.h"

#include <stddef.h>

#include <cupola/source.h>

static const char *name_at(const char *const *names, int count, int index)
{
    return index >= 0 && index < count ? names[index] : NULL;
}

const char *option_flip_name(int index)
{
    static const char *const names[] = {"x", "y", "xy"};
    return name_at(names, 3, index);
}

const char *option_preview_name(int index)
{
    static const char *const names[] = {"eye", "outside"};
    return name_at(names, 2, index);
}

const char *option_map_name(int index)
{
    static const char *const names[] = {"density"};
    return name_at(names, 1, index);
}

/* In the order of enum cupola_format. */
const char *option_view_format_name(int index)
{
    static const char *const names[] = {"rgba8", "rgba16f", "rgba32f", "srgb8"};
    return name_at(names, 4, index);
}

/* In the order of enum cupola_mask. */
const char *option_mask_name(int index)
{
    static const char *const names[] = {"auto", "none", "depth", "stencil"};
    return name_at(names, 4, index);
}

const char *option_depth_name(int index)
{
    static const char *const names[] = {"forward", "reversed"};
    return name_at(names, 2, index);
}

/* In the order of enum submission_wish. */
const char *option_submission_name(int index)
{
    static const char *const names[] = {"auto", "loop", "once"};
    return name_at(names, 3, index);
}

/* Every kind of source but the views. */
const char *option_picture_kind_name(int index)
{
    return index >= 0 ? cupola_source_name(index + CUPOLA_SOURCE_DOMEMASTER) : NULL;
}

const char *option_picture_place_name(int index)
{
    static const char *const names[] = {"screen", "infinity"};
    return name_at(names, 2, index);
}
