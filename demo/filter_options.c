/* The options about antialiasing and noise. */
#include "filter_options.h"

#include <stddef.h>

#include "option_list.h"
#include "output_file.h"

enum { SEED_MAX = 1000000 };

bool filter_options_take(const struct value_context *context, int code, const char *text,
                         struct options *options)
{
    int number;

    options->filter_given = true;
    switch (code) {
    case OPTION_AA:
        if (!value_name(context, text, cupola_antialiasing_name, &number))
            return false;
        options->filter.method = (enum cupola_antialiasing)number;
        return options->aa_given = true;
    case OPTION_SAMPLES:
        return value_integer(context, text, 1, CUPOLA_RAYS_MAX, &options->filter.samples);
    case OPTION_PATTERN:
        if (!value_name(context, text, cupola_pattern_name, &number))
            return false;
        options->filter.pattern = (enum cupola_pattern)number;
        return options->pattern_given = true;
    case OPTION_TURNED:
        if (!value_integer(context, text, 0, SEED_MAX, &number))
            return false;
        options->filter.seed = (uint32_t)number;
        options->filter.turned = true;
        return options->pattern_given = true;
    default:
        options->dither_bits = 8;
        return true;
    }
}

const char *filter_options_contradiction(const struct options *options)
{
    const struct cupola_filter *filter = &options->filter;
    bool cone = filter->method == CUPOLA_ANTIALIASING_CONE ||
                filter->method == CUPOLA_ANTIALIASING_ADAPTIVE;

    if (options->filter_given && (options->mode == SHOW_PERSPECTIVE ||
                                  options->mode == SHOW_VIEWS || options->mode == SHOW_MAP))
        return "--aa, --samples, --pattern, --turned and --dither belong to the warp, and "
               "--perspective, --views-only and --map have none; allowed: without them";
    if (options->pattern_given && !cone)
        return "--pattern and --turned belong to --aa cone and --aa adaptive only";
    if (options->reference && !options->show && !options->aa_given && filter->samples != 0)
        return "--reference takes --aa none where no other is given, which is of one texel; "
               "allowed: --samples together with --aa";
    if (filter->method == CUPOLA_ANTIALIASING_TEXTURE && filter->samples != 0 &&
        filter->samples != 4 && filter->samples != 9)
        return "--samples of --aa texture are texels; allowed: 4 or 9";
    if (filter->method == CUPOLA_ANTIALIASING_NONE && filter->samples > 1)
        return "--aa none is of one texel; allowed with it: --samples 1";
    if (options->dither_bits && options->output && output_file_is_pfm(options->output))
        return "--dither is for targets of 8 bits, and a .pfm file has floats; allowed: without it";
    return NULL;
}
