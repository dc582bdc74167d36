/* Cupola as a guest in the host's context. */
#include "guest.h"

#include <stdarg.h>
#include <stdio.h>

#include "error.h"
#include "log.h"

enum { ERRORS_PENDING_MAX = 32, NAME_MAX = 200 };

int context_check(struct cupola_error *error)
{
    static const char allowed[] = "OpenGL 3.3 or OpenGL ES 3.0, or newer";
    int version = epoxy_gl_version(); /* 0 without a context, where any GL call would abort */
    if (version == 0)
        return error_set(error, CUPOLA_ERROR_CONTEXT,
                         "no GL context is current on this thread; allowed: %s", allowed);
    bool es = !epoxy_is_desktop_gl();
    if (version < (es ? 30 : 33))
        return error_set(error, CUPOLA_ERROR_CONTEXT,
                         "the GL context is OpenGL%s %d.%d; allowed: %s", es ? " ES" : "",
                         version / 10, version % 10, allowed);
    return CUPOLA_OK;
}

int guest_check_seen(const struct guest *guest, struct cupola_error *error)
{
    if (!guest->lost)
        return CUPOLA_OK;
    return error_set(error, CUPOLA_ERROR_LOST,
                     "the GL context has been lost; destroy what was made in it and make it anew "
                     "in another context");
}

static GLenum reset_status(enum host_reset asked)
{
    switch (asked) {
    case HOST_RESET_CORE:
        return glGetGraphicsResetStatus();
    case HOST_RESET_KHR:
        return glGetGraphicsResetStatusKHR();
    case HOST_RESET_ARB:
        return glGetGraphicsResetStatusARB();
    case HOST_RESET_EXT:
        return glGetGraphicsResetStatusEXT();
    case HOST_RESET_NEVER:
        break;
    }
    return GL_NO_ERROR;
}

int guest_check(struct guest *guest, struct cupola_error *error)
{
    bool robust = guest->features->reset != HOST_RESET_NEVER;
    int status = guest_check_seen(guest, error);
    if (status != CUPOLA_OK)
        return status;
    status = context_check(error);
    /* A lost context, too, has no version any more. Its reset can be asked for: creation did. */
    if (status != CUPOLA_OK && !(robust && epoxy_gl_version() == 0))
        return status;
    GLenum reset = reset_status(guest->features->reset);
    if (reset == GL_NO_ERROR)
        return status;
    guest->lost = true;
    guest_tell(guest, CUPOLA_LOG_ERROR, CUPOLA_LOG_CONTEXT_LOST,
               "the GL context has been lost (reset status 0x%x%s)", reset,
               reset == GL_GUILTY_CONTEXT_RESET     ? ", guilty"
               : reset == GL_INNOCENT_CONTEXT_RESET ? ", innocent"
                                                    : "");
    return guest_check_seen(guest, error);
}

int guest_reason(struct guest *guest, int status, struct cupola_error *error)
{
    struct cupola_error lost;
    if (status >= 0 || guest->features->reset == HOST_RESET_NEVER ||
        guest_check(guest, &lost) != CUPOLA_ERROR_LOST)
        return status;
    *error = lost;
    return CUPOLA_ERROR_LOST;
}

int guest_ended(struct guest *guest, const char *call, int status, struct cupola_error *error)
{
    status = guest_reason(guest, status, error);
    if (status < 0)
        guest_tell(guest, CUPOLA_LOG_ERROR, CUPOLA_LOG_CALL_FAILED, "%s: %s", call, error->message);
    return status;
}

void guest_tell(const struct guest *guest, int level, int id, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    log_tell_list(&guest->log, level, id, format, arguments);
    va_end(arguments);
}

/* Whether the stack of groups, which is the host's too, has room for one more. */
static bool group_fits(const struct guest *guest)
{
    const struct host_features *features = guest->features;
    GLint depth = 0;
    if (features->debug == HOST_DEBUG_NONE)
        return false;
    if (guest->leaves_state && !features->debug_context)
        return false; /* whoever wants no questions wants none about groups that nobody sees */
    glGetIntegerv(GL_DEBUG_GROUP_STACK_DEPTH, &depth);
    return depth > 0 && depth < features->debug_groups;
}

__attribute__((format(printf, 2, 0))) static bool group_open(const struct guest *guest,
                                                             const char *format, va_list arguments)
{
    char name[NAME_MAX] = "Cupola ";
    if (!group_fits(guest))
        return false;
    vsnprintf(name + 7, sizeof name - 7, format, arguments);
    if (guest->features->debug == HOST_DEBUG_CORE)
        glPushDebugGroup(GL_DEBUG_SOURCE_THIRD_PARTY, 0, -1, name);
    else
        glPushDebugGroupKHR(GL_DEBUG_SOURCE_THIRD_PARTY, 0, -1, name);
    return true;
}

bool guest_group_open(const struct guest *guest, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    bool opened = group_open(guest, format, arguments);
    va_end(arguments);
    return opened;
}

void guest_group_close(const struct guest *guest, bool opened)
{
    if (!opened)
        return;
    if (guest->features->debug == HOST_DEBUG_CORE)
        glPopDebugGroup();
    else
        glPopDebugGroupKHR();
}

void guest_begin(const struct guest *guest, struct guest_work *work, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    work->grouped = group_open(guest, format, arguments);
    va_end(arguments);
    if (guest->leaves_state)
        host_state_set(&work->state, guest->features);
    else
        host_state_save(&work->state, guest->features);
}

void guest_begin_making(const struct guest *guest, struct guest_work *work, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    work->grouped = group_open(guest, format, arguments);
    va_end(arguments);
    host_state_save(&work->state, guest->features);
}

void guest_end(const struct guest *guest, const struct guest_work *work)
{
    host_state_restore(&work->state);
    guest_group_close(guest, work->grouped);
}

void guest_name(const struct guest *guest, GLenum kind, GLuint object, const char *format, ...)
{
    char name[NAME_MAX] = "Cupola ";
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(name + 7, sizeof name - 7, format, arguments);
    va_end(arguments);
    if (guest->features->debug == HOST_DEBUG_CORE)
        glObjectLabel(kind, object, -1, name);
    else if (guest->features->debug == HOST_DEBUG_KHR)
        glObjectLabelKHR(kind, object, -1, name);
    if (kind == GL_PROGRAM)
        guest_tell(guest, CUPOLA_LOG_DEBUG, CUPOLA_LOG_PROGRAM, "program %u: %s", object, name + 7);
    else if (kind == GL_TEXTURE || kind == GL_RENDERBUFFER)
        guest_tell(guest, CUPOLA_LOG_DEBUG, CUPOLA_LOG_TEXTURE, "%s %u: %s",
                   kind == GL_TEXTURE ? "texture" : "renderbuffer", object, name + 7);
}

/* How many there were, and the first of them. */
static int drop(GLenum *first)
{
    int count = 0;
    /* A GL keeps a handful at most, but one that has lost its context answers with one for ever. */
    while (count < ERRORS_PENDING_MAX) {
        GLenum pending = glGetError();
        if (pending == GL_NO_ERROR)
            break;
        if (count++ == 0)
            *first = pending;
    }
    return count;
}

void gl_errors_drop(void)
{
    GLenum first = GL_NO_ERROR;
    drop(&first);
}

void guest_errors_drop(const struct guest *guest)
{
    GLenum first = GL_NO_ERROR;
    int count = drop(&first);
    if (count > 0)
        guest_tell(guest, CUPOLA_LOG_WARNING, CUPOLA_LOG_ERRORS_DROPPED,
                   "%d GL errors of the host's were pending and are dropped (the first is 0x%x)",
                   count, first);
}

int gl_refused(GLenum failure, struct cupola_error *error, const char *what, ...)
{
    char words[NAME_MAX];
    va_list arguments;
    va_start(arguments, what);
    vsnprintf(words, sizeof words, what, arguments);
    va_end(arguments);
    if (failure == GL_CONTEXT_LOST)
        return error_set(error, CUPOLA_ERROR_LOST, "the GL context was lost before it made %s",
                         words);
    if (failure == GL_OUT_OF_MEMORY)
        return error_set(error, CUPOLA_ERROR_MEMORY, "the GL has no memory for %s", words);
    return error_set(error, CUPOLA_ERROR_GL, "the GL refused %s (error 0x%x)", words, failure);
}
