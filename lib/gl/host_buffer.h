/* What the host has bound of buffers of vertices, where Cupola fills its own. */
#ifndef HOST_BUFFER_H
#define HOST_BUFFER_H

#include <epoxy/gl.h>

struct host_buffer {
    GLint buffer;
};

void host_buffer_save(struct host_buffer *host);
void host_buffer_restore(const struct host_buffer *host);

#endif
