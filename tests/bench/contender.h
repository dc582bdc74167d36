/*
 * One way to come to a picture, whoever draws it: views of the scene first, then what makes the
 * output's picture of them. Every contender lands in the setting's target.
 */
#ifndef CONTENDER_H
#define CONTENDER_H

#include "setting.h"

/* What a contender's pictures show, and so what they are compared with. */
enum shows { SHOWS_NOTHING, SHOWS_DOME, SHOWS_PLAIN_VIEW };

struct contender_facts {
    enum shows shows;
    int views;
    double texels; /* of all views, guard bands included */
    double
        planned; /* those that pixels sample and guard bands round them, by the plan; 0: unknown */
    double shaded; /* those that no mask covers, as the GL counts them; 0: not known */
    double bytes;  /* of colour and depth that the views take */
    double tables; /* bytes of all else that is there for the warp and the mask */
    char note[256];
};

struct contender_kind {
    /* NULL with one line in `message` where it cannot serve the setting. */
    void *(*prepare)(const struct setting *setting, int variant, char *message);
    bool (*before)(void *self); /* what comes before a frame and is not timed; NULL: nothing */
    bool (*views)(void *self);  /* NULL: it has none */
    bool (*warp)(void *self);   /* NULL: its view is the picture */
    void (*facts)(const void *self, struct contender_facts *facts);
    void (*release)(void *self);
};

struct contender {
    char name[32];
    const struct contender_kind *kind;
    int variant; /* what it means is the kind's */
};

/* One plain view, straight into the target. */
extern const struct contender_kind contender_plain_view;
/* The same, with nothing drawn. */
extern const struct contender_kind contender_plain_clear;
/*
 * A texture of the output's size, drawn over all of it bilinearly; the same with its rows turned by
 * 45 degrees against the output's, as a dome's views have theirs; and so turned, but a texture of a
 * quarter of the side over and over, which stays in the processor's cache.
 */
enum blit_variant { BLIT_STRAIGHT, BLIT_TURNED, BLIT_TURNED_SMALL };
extern const struct contender_kind contender_blit;

/* Cupola with one of these, or as many rotated views as the variant says. */
enum cupola_variant { CUPOLA_CHOICE = 0, CUPOLA_SAVES_VERTICES = -1, CUPOLA_UNMASKED = -2 };
extern const struct contender_kind contender_cupola;
/* The same, all views drawn in one pass. */
extern const struct contender_kind contender_one_pass;
/* Cupola's own choice with the table stage that the variant is. */
extern const struct contender_kind contender_stage;
/* Cupola's warp with a filter; the variant is contender_filters' own. */
extern const struct contender_kind contender_filter;

/*
 * Writes those of all filters, with so many samples where their number can be chosen; returns how
 * many. contender_filter_found: whether a name is that of one.
 */
enum { FILTER_CONTENDERS = 6 };
int contender_filters(int samples, struct contender contenders[FILTER_CONTENDERS]);
bool contender_filter_found(const char *name);
/* Cupola's own choice with the setting's filter whose index the variant is. */
extern const struct contender_kind contender_listed;
/*
 * A table stage planned for a viewer who moves: at rest, having moved, and with another eye before
 * every warp, where what follows from it is timed, too.
 */
extern const struct contender_kind contender_resting;
extern const struct contender_kind contender_moved;
extern const struct contender_kind contender_moving;
/* What comes before the host draws, its views cleared and masked: at rest, and likewise. */
extern const struct contender_kind contender_resting_clear;
extern const struct contender_kind contender_moving_clear;
/* The views of Cupola's own choice, and a warp that computes nothing. */
extern const struct contender_kind contender_control;

/*
 * Parts of such a frame: its views begun and ended, but nothing drawn; its views, never warped;
 * and the warp of views that were drawn once.
 */
extern const struct contender_kind contender_cupola_clear;
extern const struct contender_kind contender_cupola_views;
extern const struct contender_kind contender_cupola_warp;

/* 4 or 6 full faces of a cube; by trigonometry in the shader, or by a mesh. */
enum cube_variant { CUBE_4_TRIGONOMETRY, CUBE_6_TRIGONOMETRY, CUBE_6_MESH };
extern const struct contender_kind contender_cube;

/* Three frusta set by hand, and a mesh for each. */
extern const struct contender_kind contender_frusta;

#endif
