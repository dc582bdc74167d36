/* The bench's command line. */
#ifndef OPTIONS_H
#define OPTIONS_H

#include "comparison.h"

enum { LIST_MAX = 16, NAMES_MAX = 32 };

enum family {
    FAMILY_WARP,
    FAMILY_EYE,
    FAMILY_FRAME,
    FAMILY_PARTS,
    FAMILY_LAMPS,
    FAMILY_TRIANGLES,
    FAMILY_VIEWS,
    FAMILY_SIZE,
    FAMILY_FILTERS,
    FAMILIES
};

struct options {
    bool families[FAMILIES];
    int sizes_px[LIST_MAX + 1], size_count; /* ends with 0 */
    double fovs_deg[LIST_MAX];
    int fov_count;
    enum cupola_lens_model lenses[LIST_MAX];
    int lens_count;
    const char *loads[LIST_MAX];
    int load_count;
    bool load_given;                   /* it is not the default */
    const char *contenders[NAMES_MAX]; /* by name, besides the first; none: all */
    int contender_count;
    int table;   /* of enum cupola_table, for whole frames */
    int samples; /* rays of a pixel */
    struct comparison_wishes wishes;
    bool no_quality;
    const char *output; /* NULL: stdout */
};

extern const char *const family_names[FAMILIES];

/* True to go on; else `status` is what to exit with, and it has been said why. */
bool options_read(struct options *options, int argc, char **argv, int *status);

#endif
