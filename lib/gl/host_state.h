/*
 * The host's GL state: everything that Cupola's calls change, saved and put back. The list here is
 * the one in docs/host-contract.md.
 */
#ifndef HOST_STATE_H
#define HOST_STATE_H

#include <epoxy/gl.h>
#include <stdbool.h>

enum {
    HOST_CAPABILITIES_MAX = 32,
    HOST_TEXTURE_UNITS = 2,
    HOST_PIXEL_STORES = 8,
};

/* Where drawing goes: what view_begin changes for the host until view_end. */
struct host_target {
    GLint draw_framebuffer;
    GLint read_framebuffer;
    GLfloat viewport[4];
    GLint scissor[4];
    GLboolean scissor_test;
};

/* How drawing is done: what never differs for the host from one of its own commands to the next. */
struct host_state {
    int version; /* of the context, 33 for 3.3 */
    struct host_target target;
    GLboolean capabilities[HOST_CAPABILITIES_MAX];
    GLboolean color_mask[4];
    GLboolean depth_mask;
    GLint polygon_mode[2];
    GLint program;
    GLint pipeline;
    GLint vertex_array;
    GLint renderbuffer;
    GLint active_texture;
    GLint textures[HOST_TEXTURE_UNITS];
    GLint samplers[HOST_TEXTURE_UNITS];
    GLint unpack_buffer;
    GLint pack_buffer;
    GLint pixel_stores[HOST_PIXEL_STORES];
    GLint clip_origin, clip_depth;
};

void host_target_save(struct host_target *target);
void host_target_restore(const struct host_target *target, int version);

/*
 * Saves all of it and sets what a full-screen pass, a clear or a transfer of pixels needs: no test,
 * no blending, all channels written, textures read without sampler objects, packed pixels.
 */
void host_state_save(struct host_state *state);
void host_state_restore(const struct host_state *state);

/* Sets viewport and scissor rectangle 0 and no other of the context. */
void host_set_area(int version, GLint x, GLint y, GLsizei width, GLsizei height);

#endif
