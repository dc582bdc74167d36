/*
 * Views as textures of a host's: of any sizes and in any places, and the same for the warp in C.
 */
#ifndef VIEW_TEXTURES_H
#define VIEW_TEXTURES_H

#include <epoxy/gl.h>

#include "cupola/cupola.h"

/*
 * Textures side by side as one picture: view i is a rectangle of texture i, what lies round it is
 * not of the view and white.
 */
struct view_textures {
    cupola_plan *plan; /* with the rectangles in that picture, for the warp in C */
    int left[CUPOLA_VIEWS_MAX], width[CUPOLA_VIEWS_MAX], height[CUPOLA_VIEWS_MAX];
    float *texels; /* of that picture */
    GLuint names[CUPOLA_VIEWS_MAX];
    struct cupola_view_image images[CUPOLA_VIEWS_MAX];
};

struct view_wish {
    enum cupola_storage storage;
    bool whole;    /* each rectangle is all of its texture, and said by zeros */
    double larger; /* than planned */
    GLenum format; /* GL_RGBA16F or GL_SRGB8_ALPHA8 */
    double phase;  /* of the colours */
};

void view_textures_make(const cupola_plan *plan, const struct view_wish *wish,
                        struct view_textures *textures);
void view_textures_release(struct view_textures *textures);

#endif
