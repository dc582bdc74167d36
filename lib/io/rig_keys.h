/*
 * The keys of rig files: one table that reading, writing and the test of docs/rig-format.md share.
 */
#ifndef RIG_KEYS_H
#define RIG_KEYS_H

#include <stdbool.h>
#include <stddef.h>

enum rig_kind {
    RIG_FORMAT, /* whole number, not kept */
    RIG_PRESET, /* name, not kept */
    RIG_REAL,
    RIG_REALS, /* up to `most` of them */
    RIG_ANGLE, /* degrees in the file, radians in memory */
    RIG_SIZE,  /* width and height of an output */
    RIG_FLIP,
    RIG_MODEL,
    RIG_GROUP,
    RIG_GROUPS, /* list of up to `most` groups */
};

struct rig_section;

struct rig_key {
    const char *name;
    const char *allowed; /* for messages and the documentation */
    enum rig_kind kind;
    size_t offset; /* of the value in its section's struct */
    /* Numbers: from low to high, without low itself if it is open. */
    double low;
    double high;
    bool low_is_open;
    bool required;
    int least; /* how many, for RIG_REALS and RIG_GROUPS */
    int most;
    /* RIG_GROUP and RIG_GROUPS */
    const struct rig_section *section;
    size_t stride;
    size_t count_offset;
    const char *comment; /* written behind it, or NULL */
};

struct rig_section {
    const struct rig_key *keys; /* in the order in which they are read and written */
    int key_count;
};

extern const struct rig_section rig_section_lens_sample;
extern const struct rig_section rig_section_lens;
extern const struct rig_section rig_section_output;
extern const struct rig_section rig_section_rig; /* the whole file */

/* The name of a flip, 0 to 3, and the way back, or -1. */
const char *rig_flip_name(int flip);
int rig_flip_find(const char *name);

#endif
