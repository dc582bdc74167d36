/*
 * From a rig to pictures: dome, plan, GL objects and, where asked for, the simulated theatre. A
 * show never changes; whoever wants another rig, plan or mode makes a new one and, if that
 * succeeds, drops the old.
 */
#ifndef SHOW_H
#define SHOW_H

#include <cupola/cupola.h>

#include "host_camera.h"
#include "options.h"
#include "scene.h"

struct show_setup {
    struct cupola_rig rig; /* complete */
    struct cupola_plan_params plan;
    enum cupola_table table;
    int view_format; /* of enum cupola_format; -1: by `floats` */
    int samples;     /* per texel of a view; 0: one */
    struct cupola_filter filter;
    bool aa_given; /* its method is not left to what suits the picture */
    int dither_bits;
    bool reversed_depth;
    enum cupola_mask mask;
    bool one_pass; /* all views at once: scene and grid have been made for that */
    enum show_mode mode;
    enum cupola_source_kind source; /* what is shown: the views of a scene, or a picture */
    int output;                     /* index of the output that is shown where only one is */
    bool picture_of_numbers;        /* a picture of floats, whose numbers are taken as they are */
    bool floats;                    /* views and images of 32-bit floats instead of 8 bits */
    bool overlays;                  /* frames have some */
    bool reference;                 /* frames of a reference: jittered, and in linear light */
    bool measures_prices;           /* the plan's prices are, or have been, measured */
};

struct show;
struct grid;

/* NULL with one line in `message`, MESSAGE_SIZE bytes. Runs where a GL context is current. */
struct show *show_create(const struct show_setup *setup, char *message);

/* What the show was made from. */
const struct show_setup *show_setup_of(const struct show *show);

/* The name of the table stage by which the output that is shown is warped; NULL where none is. */
const char *show_table(const struct show *show);

/* NULL is allowed. */
void show_destroy(struct show *show);

/* How long a frame took, milliseconds, with the GL finished at the edges of each phase. */
struct frame_times {
    double views_ms; /* drawing the scene */
    double warp_ms;  /* from views to output; 0 where nothing is warped */
    double frame_ms; /* all of it, theatre included */
};

/* How far samples lie beside the middles of texels and pixels. */
struct show_jitter {
    double texels[2], pixels[2];
};

struct show_frame {
    const struct cupola_source *source; /* NULL: the scene */
    struct scene *scene;
    const struct host_camera *camera;
    const double *eye_m;              /* the viewer's, dome frame; NULL: the rig's */
    const struct show_jitter *jitter; /* of a reference; NULL: as it was */
    struct scene_range *range;
    struct grid *grid;                     /* drawn over every view; NULL: none */
    const struct cupola_overlay *overlays; /* over the dome's image */
    int overlay_count;
    unsigned int framebuffer;
    int width; /* of the framebuffer; for the dome and the perspective view, the output's */
    int height;
    struct frame_times *times; /* NULL: nobody wants them, and nothing waits */
};

/* Draws one frame. False with one line in `message`, MESSAGE_SIZE bytes. */
bool show_draw(struct show *show, const struct show_frame *frame, char *message);

/* Copies the views into a rectangle of a framebuffer, left to right and upwards as in the atlas. */
void show_draw_atlas(const struct show *show, unsigned int framebuffer,
                     const struct cupola_rect *rect);

/* The size of the picture that the mode makes when nothing else is wished. */
void show_size(const struct show *show, int *width, int *height);

/* With the eye where it is now. */
const cupola_dome *show_dome(const struct show *show);

/* NULL for a perspective view, which has no plan. */
const struct cupola_plan_report *show_report(const struct show *show);

/* The plan, as long as the show lives; NULL without views. */
const cupola_plan *show_plan(const struct show *show);

/*
 * Makes the GL objects of the plan once more, tables included, and returns how long that took until
 * the GL had finished; below 0 if it failed, 0 where there is no plan.
 */
double show_time_tables_ms(const struct show *show);

/* Of a clock that only goes forward. */
double now_ms(void);

#endif
