/* What the GL keeps, by asking it for every object that there is. */
#ifndef FOOTPRINT_H
#define FOOTPRINT_H

/* Bytes. */
struct footprint {
    double color;   /* of textures and renderbuffers */
    double depth;   /* likewise, with stencil */
    double buffers; /* vertices, indices, uniforms */
};

/* All that is there now. Of textures those that are flat, and of them the first level. */
struct footprint footprint_now(void);

/* Of one flat texture. */
double footprint_texture(unsigned int texture);

#endif
