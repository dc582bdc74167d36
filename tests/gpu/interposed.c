/* Functions in the place of the GL's. */
#include "interposed.h"

#include <string.h>

struct interposed interposed;

static void count_call(void)
{
    interposed.called++;
    if (interposed.lose_in > 0 && --interposed.lose_in == 0)
        interposed.lost = true;
}

/* Whether a call that may fail is the one that does. */
static bool fails(GLenum error)
{
    if (interposed.to_go == 0 || --interposed.to_go > 0)
        return false;
    interposed.error = error;
    return true;
}

/*
 * The first call of a function lets libepoxy find it and write the pointer anew: so the hook is put
 * back after each.
 */
#define HOOK(name)                                                                                 \
    do {                                                                                           \
        if (epoxy_##name != hook_##name) {                                                         \
            real_##name = epoxy_##name;                                                            \
            epoxy_##name = hook_##name;                                                            \
        }                                                                                          \
    } while (0)
#define CALL(name, arguments)                                                                      \
    do {                                                                                           \
        real_##name arguments;                                                                     \
        HOOK(name);                                                                                \
    } while (0)

/* Gives names, or zeros. */
#define NAMES(name)                                                                                \
    static void (*real_##name)(GLsizei n, GLuint * names);                                         \
    static void hook_##name(GLsizei n, GLuint *names)                                              \
    {                                                                                              \
        count_call();                                                                              \
        interposed.made++;                                                                         \
        if (fails(GL_OUT_OF_MEMORY))                                                               \
            memset(names, 0, (size_t)n * sizeof *names);                                           \
        else if (!interposed.lost)                                                                 \
            CALL(name, (n, names));                                                                \
    }
/* Makes storage, compiles and the like; the failure leaves an error or shows by itself. */
#define MAKES(name, failure, parameters, arguments)                                                \
    static void(*real_##name) parameters;                                                          \
    static void hook_##name parameters                                                             \
    {                                                                                              \
        count_call();                                                                              \
        interposed.made++;                                                                         \
        if (!fails(failure) && !interposed.lost)                                                   \
            CALL(name, arguments);                                                                 \
    }
/* Asks for numbers. */
#define ASKS(name, count, type, parameters, arguments)                                             \
    static void(*real_##name) parameters;                                                          \
    static void hook_##name parameters                                                             \
    {                                                                                              \
        count_call();                                                                              \
        interposed.asked++;                                                                        \
        if (!interposed.lost)                                                                      \
            CALL(name, arguments);                                                                 \
        for (int i = 0; interposed.lost && i < (count); i++)                                       \
            values[i] = (type)GARBAGE;                                                             \
    }
/* Answers by itself. */
#define ANSWERS(name, type, in_lost, parameters, arguments)                                        \
    static type(*real_##name) parameters;                                                          \
    static type hook_##name parameters                                                             \
    {                                                                                              \
        count_call();                                                                              \
        interposed.asked++;                                                                        \
        if (interposed.lost)                                                                       \
            return in_lost;                                                                        \
        type answer = real_##name arguments;                                                       \
        HOOK(name);                                                                                \
        return answer;                                                                             \
    }
/* Does something. */
#define DOES(name, parameters, arguments)                                                          \
    static void(*real_##name) parameters;                                                          \
    static void hook_##name parameters                                                             \
    {                                                                                              \
        count_call();                                                                              \
        if (!interposed.lost)                                                                      \
            CALL(name, arguments);                                                                 \
    }

NAMES(glGenTextures)
NAMES(glGenFramebuffers)
NAMES(glGenRenderbuffers)
NAMES(glGenVertexArrays)
NAMES(glGenSamplers)
NAMES(glGenBuffers)
NAMES(glGenQueries)
MAKES(glTexImage2D, GL_OUT_OF_MEMORY,
      (GLenum a, GLint b, GLint c, GLsizei d, GLsizei e, GLint f, GLenum g, GLenum h,
       const void *i),
      (a, b, c, d, e, f, g, h, i))
MAKES(glTexStorage2D, GL_OUT_OF_MEMORY, (GLenum a, GLsizei b, GLenum c, GLsizei d, GLsizei e),
      (a, b, c, d, e))
MAKES(glRenderbufferStorage, GL_OUT_OF_MEMORY, (GLenum a, GLenum b, GLsizei c, GLsizei d),
      (a, b, c, d))
MAKES(glRenderbufferStorageMultisample, GL_OUT_OF_MEMORY,
      (GLenum a, GLsizei b, GLenum c, GLsizei d, GLsizei e), (a, b, c, d, e))
MAKES(glBufferData, GL_OUT_OF_MEMORY, (GLenum a, GLsizeiptr b, const void *c, GLenum d),
      (a, b, c, d))
MAKES(glCompileShader, GL_NO_ERROR, (GLuint a), (a))
MAKES(glLinkProgram, GL_NO_ERROR, (GLuint a), (a))
ASKS(glGetIntegerv, 1, GLint, (GLenum name, GLint *values), (name, values))
ASKS(glGetBooleanv, 1, GLboolean, (GLenum name, GLboolean *values), (name, values))
ASKS(glGetFloatv, 4, GLfloat, (GLenum name, GLfloat *values), (name, values))
ASKS(glGetIntegeri_v, 4, GLint, (GLenum name, GLuint i, GLint *values), (name, i, values))
ASKS(glGetFramebufferAttachmentParameteriv, 1, GLint,
     (GLenum target, GLenum at, GLenum name, GLint *values), (target, at, name, values))
ASKS(glGetTexParameteriv, 1, GLint, (GLenum target, GLenum name, GLint *values),
     (target, name, values))
ASKS(glGetTexLevelParameteriv, 1, GLint, (GLenum target, GLint level, GLenum name, GLint *values),
     (target, level, name, values))
ASKS(glGetInternalformativ, n, GLint,
     (GLenum target, GLenum format, GLenum name, GLsizei n, GLint *values),
     (target, format, name, n, values))
ASKS(glGetProgramiv, 1, GLint, (GLuint program, GLenum name, GLint *values),
     (program, name, values))
ASKS(glGetShaderiv, 1, GLint, (GLuint shader, GLenum name, GLint *values), (shader, name, values))
ANSWERS(glIsEnabled, GLboolean, 77, (GLenum a), (a))
ANSWERS(glGetUniformLocation, GLint, GARBAGE, (GLuint a, const GLchar *b), (a, b))
ANSWERS(glGetGraphicsResetStatus, GLenum, GL_GUILTY_CONTEXT_RESET, (void), ())
ANSWERS(glGetGraphicsResetStatusKHR, GLenum, GL_GUILTY_CONTEXT_RESET, (void), ())
ANSWERS(glGetGraphicsResetStatusARB, GLenum, GL_GUILTY_CONTEXT_RESET, (void), ())
ANSWERS(glGetGraphicsResetStatusEXT, GLenum, GL_GUILTY_CONTEXT_RESET, (void), ())
DOES(glDrawArrays, (GLenum a, GLint b, GLsizei c), (a, b, c))
DOES(glClearBufferfv, (GLenum a, GLint b, const GLfloat *c), (a, b, c))
DOES(glBindFramebuffer, (GLenum a, GLuint b), (a, b))
DOES(glUseProgram, (GLuint a), (a))
DOES(glPushDebugGroup, (GLenum a, GLuint b, GLsizei c, const GLchar *d), (a, b, c, d))
DOES(glPopDebugGroup, (void), ())
DOES(glDeleteTextures, (GLsizei a, const GLuint *b), (a, b))

/* Those that are unlike the others. */
static GLenum (*real_glGetError)(void);
static GLenum hook_glGetError(void)
{
    GLenum error = interposed.error;
    count_call();
    interposed.asked++;
    interposed.error = GL_NO_ERROR;
    if (interposed.lost)
        return GL_CONTEXT_LOST;
    if (error != GL_NO_ERROR)
        return error;
    error = real_glGetError();
    HOOK(glGetError);
    return error;
}

static GLenum (*real_glCheckFramebufferStatus)(GLenum target);
static GLenum hook_glCheckFramebufferStatus(GLenum target)
{
    count_call();
    if (fails(GL_NO_ERROR))
        return GL_FRAMEBUFFER_UNSUPPORTED;
    if (interposed.lost)
        return GL_FRAMEBUFFER_COMPLETE;
    GLenum status = real_glCheckFramebufferStatus(target);
    HOOK(glCheckFramebufferStatus);
    return status;
}

static GLuint (*real_glCreateShader)(GLenum kind);
static GLuint hook_glCreateShader(GLenum kind)
{
    count_call();
    interposed.made++;
    if (fails(GL_OUT_OF_MEMORY) || interposed.lost)
        return 0;
    GLuint shader = real_glCreateShader(kind);
    HOOK(glCreateShader);
    return shader;
}

static GLuint (*real_glCreateProgram)(void);
static GLuint hook_glCreateProgram(void)
{
    count_call();
    interposed.made++;
    if (fails(GL_OUT_OF_MEMORY) || interposed.lost)
        return 0;
    GLuint program = real_glCreateProgram();
    HOOK(glCreateProgram);
    return program;
}

#define EACH(X)                                                                                    \
    X(glGenTextures)                                                                               \
    X(glGenFramebuffers)                                                                           \
    X(glGenRenderbuffers)                                                                          \
    X(glGenVertexArrays)                                                                           \
    X(glGenSamplers)                                                                               \
    X(glGenBuffers)                                                                                \
    X(glGenQueries)                                                                                \
    X(glTexImage2D)                                                                                \
    X(glTexStorage2D)                                                                              \
    X(glRenderbufferStorage)                                                                       \
    X(glRenderbufferStorageMultisample)                                                            \
    X(glBufferData)                                                                                \
    X(glCompileShader)                                                                             \
    X(glLinkProgram)                                                                               \
    X(glCreateShader)                                                                              \
    X(glCreateProgram)                                                                             \
    X(glCheckFramebufferStatus)                                                                    \
    X(glGetError)                                                                                  \
    X(glGetIntegerv)                                                                               \
    X(glGetBooleanv)                                                                               \
    X(glGetFloatv)                                                                                 \
    X(glGetIntegeri_v)                                                                             \
    X(glGetFramebufferAttachmentParameteriv)                                                       \
    X(glGetTexParameteriv)                                                                         \
    X(glGetTexLevelParameteriv)                                                                    \
    X(glGetInternalformativ)                                                                       \
    X(glGetProgramiv)                                                                              \
    X(glGetShaderiv)                                                                               \
    X(glIsEnabled)                                                                                 \
    X(glGetUniformLocation)                                                                        \
    X(glGetGraphicsResetStatus)                                                                    \
    X(glGetGraphicsResetStatusKHR)                                                                 \
    X(glGetGraphicsResetStatusARB)                                                                 \
    X(glGetGraphicsResetStatusEXT)                                                                 \
    X(glDrawArrays)                                                                                \
    X(glClearBufferfv)                                                                             \
    X(glBindFramebuffer)                                                                           \
    X(glUseProgram)                                                                                \
    X(glPushDebugGroup)                                                                            \
    X(glPopDebugGroup)                                                                             \
    X(glDeleteTextures)

#define INSTALL(name) HOOK(name);
#define REMOVE(name)  epoxy_##name = real_##name;

void interposed_begin(void)
{
    interposed = (struct interposed){0};
    EACH(INSTALL)
}

void interposed_end(void)
{
    EACH(REMOVE)
}
