/* What a context has for debuggers, and whether it tells that it has been lost. */
#include "host_origin.h"

static bool has_debug_extension(void)
{
    return epoxy_has_gl_extension("GL_KHR_debug");
}

static enum host_debug debug_of(const struct host_features *features)
{
    if (epoxy_gl_version() >= (features->es ? 32 : 43))
        return HOST_DEBUG_CORE;
    if (!has_debug_extension())
        return HOST_DEBUG_NONE;
    return features->es ? HOST_DEBUG_KHR : HOST_DEBUG_CORE;
}

/* Those of GL_ARB_robustness and GL_EXT_robustness have the same numbers by other names. */
static enum host_reset reset_of(const struct host_features *features)
{
    enum host_reset reset = HOST_RESET_NEVER;
    GLint strategy = GL_NO_RESET_NOTIFICATION;
    if (epoxy_gl_version() >= (features->es ? 32 : 45))
        reset = HOST_RESET_CORE;
    else if (epoxy_has_gl_extension("GL_KHR_robustness"))
        reset = features->es ? HOST_RESET_KHR : HOST_RESET_CORE;
    else if (!features->es && epoxy_has_gl_extension("GL_ARB_robustness"))
        reset = HOST_RESET_ARB;
    else if (features->es && epoxy_has_gl_extension("GL_EXT_robustness"))
        reset = HOST_RESET_EXT;
    if (reset == HOST_RESET_NEVER)
        return reset;
    glGetIntegerv(GL_RESET_NOTIFICATION_STRATEGY, &strategy);
    return strategy == GL_LOSE_CONTEXT_ON_RESET ? reset : HOST_RESET_NEVER;
}

void host_debug_find(struct host_features *features)
{
    GLint flags = 0, groups = 0;
    features->reset = reset_of(features);
    features->debug = debug_of(features);
    if (features->debug == HOST_DEBUG_NONE)
        return;
    glGetIntegerv(GL_MAX_DEBUG_GROUP_STACK_DEPTH, &groups);
    features->debug_groups = groups;
    if (features->debug == HOST_DEBUG_KHR) {
        features->debug_context = glIsEnabled(GL_DEBUG_OUTPUT); /* no flags to be asked for */
        return;
    }
    glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    features->debug_context = (flags & GL_CONTEXT_FLAG_DEBUG_BIT) != 0;
}
