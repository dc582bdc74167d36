/* What the host has bound of buffers of vertices: saved and restored. */
#include "host_buffer.h"

void host_buffer_save(struct host_buffer *host)
{
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &host->buffer);
}

void host_buffer_restore(const struct host_buffer *host)
{
    glBindBuffer(GL_ARRAY_BUFFER, (GLuint)host->buffer);
}
