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
    interposed.out_of_memory = error == GL_OUT_OF_MEMORY;
    return true;
}

/*
 * The first call of a function lets libepoxy find it and write the pointer anew: so the hook is
 * taken away before each and put back after it. Names go without their "gl", which would be macros
 * of libepoxy's.
 */
#define HOOK(name)                                                                                 \
    do {                                                                                           \
        real_##name = epoxy_gl##name;                                                              \
        epoxy_gl##name = hook_##name;                                                              \
    } while (0)
#define UNHOOK(name) epoxy_gl##name = real_##name
#define CALL(name, arguments)                                                                      \
    do {                                                                                           \
        UNHOOK(name);                                                                              \
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
        UNHOOK(name);                                                                              \
        type answer = real_##name arguments;                                                       \
        HOOK(name);                                                                                \
        return answer;                                                                             \
    }
/* Tells of resets. */
#define RESETS(name)                                                                               \
    static GLenum (*real_##name)(void);                                                            \
    static GLenum hook_##name(void)                                                                \
    {                                                                                              \
        count_call();                                                                              \
        interposed.asked++;                                                                        \
        interposed.resets_asked++;                                                                 \
        if (interposed.lost)                                                                       \
            return GL_GUILTY_CONTEXT_RESET;                                                        \
        UNHOOK(name);                                                                              \
        GLenum answer = real_##name();                                                             \
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

static int floats_of(GLenum name)
{
    return name == GL_VIEWPORT ? 4 : name == GL_POINT_FADE_THRESHOLD_SIZE ? 1 : 2; /* ranges */
}

NAMES(GenTextures)
NAMES(GenFramebuffers)
NAMES(GenRenderbuffers)
NAMES(GenVertexArrays)
NAMES(GenSamplers)
NAMES(GenBuffers)
NAMES(GenQueries)
MAKES(TexImage2D, GL_OUT_OF_MEMORY,
      (GLenum a, GLint b, GLint c, GLsizei d, GLsizei e, GLint f, GLenum g, GLenum h,
       const void *i),
      (a, b, c, d, e, f, g, h, i))
MAKES(TexStorage2D, GL_OUT_OF_MEMORY, (GLenum a, GLsizei b, GLenum c, GLsizei d, GLsizei e),
      (a, b, c, d, e))
MAKES(RenderbufferStorage, GL_OUT_OF_MEMORY, (GLenum a, GLenum b, GLsizei c, GLsizei d),
      (a, b, c, d))
MAKES(RenderbufferStorageMultisample, GL_OUT_OF_MEMORY,
      (GLenum a, GLsizei b, GLenum c, GLsizei d, GLsizei e), (a, b, c, d, e))
MAKES(BufferData, GL_OUT_OF_MEMORY, (GLenum a, GLsizeiptr b, const void *c, GLenum d), (a, b, c, d))
MAKES(CompileShader, GL_NO_ERROR, (GLuint a), (a))
MAKES(LinkProgram, GL_NO_ERROR, (GLuint a), (a))
ASKS(GetBooleanv, 1, GLboolean, (GLenum name, GLboolean *values), (name, values))
ASKS(GetFloatv, floats_of(name), GLfloat, (GLenum name, GLfloat *values), (name, values))
ASKS(GetFloati_v, 4, GLfloat, (GLenum name, GLuint index, GLfloat *values), (name, index, values))
ASKS(GetIntegeri_v, 4, GLint, (GLenum name, GLuint index, GLint *values), (name, index, values))
ASKS(GetFramebufferAttachmentParameteriv, 1, GLint,
     (GLenum target, GLenum at, GLenum name, GLint *values), (target, at, name, values))
ASKS(GetTexParameteriv, 1, GLint, (GLenum target, GLenum name, GLint *values),
     (target, name, values))
ASKS(GetTexLevelParameteriv, 1, GLint, (GLenum target, GLint level, GLenum name, GLint *values),
     (target, level, name, values))
ASKS(GetInternalformativ, n, GLint,
     (GLenum target, GLenum format, GLenum name, GLsizei n, GLint *values),
     (target, format, name, n, values))
ASKS(GetProgramiv, 1, GLint, (GLuint program, GLenum name, GLint *values), (program, name, values))
ASKS(GetShaderiv, 1, GLint, (GLuint shader, GLenum name, GLint *values), (shader, name, values))
ASKS(GetInteger64v, 1, GLint64, (GLenum name, GLint64 *values), (name, values))
ANSWERS(IsEnabled, GLboolean, 77, (GLenum a), (a))
ANSWERS(IsEnabledi, GLboolean, 77, (GLenum a, GLuint b), (a, b))
ANSWERS(IsFramebuffer, GLboolean, 77, (GLuint a), (a))
ANSWERS(IsProgram, GLboolean, 77, (GLuint a), (a))
ANSWERS(IsTexture, GLboolean, 77, (GLuint a), (a))
ANSWERS(GetUniformLocation, GLint, GARBAGE, (GLuint a, const GLchar *b), (a, b))
RESETS(GetGraphicsResetStatus)
RESETS(GetGraphicsResetStatusKHR)
RESETS(GetGraphicsResetStatusARB)
RESETS(GetGraphicsResetStatusEXT)
DOES(DrawArrays, (GLenum a, GLint b, GLsizei c), (a, b, c))
DOES(ClearBufferfv, (GLenum a, GLint b, const GLfloat *c), (a, b, c))
DOES(BufferSubData, (GLenum a, GLintptr b, GLsizeiptr c, const void *d), (a, b, c, d))
DOES(BindFramebuffer, (GLenum a, GLuint b), (a, b))
DOES(UseProgram, (GLuint a), (a))
DOES(PushDebugGroup, (GLenum a, GLuint b, GLsizei c, const GLchar *d), (a, b, c, d))
DOES(PopDebugGroup, (void), ())
DOES(DeleteTextures, (GLsizei a, const GLuint *b), (a, b))

/* Of constants that nobody has to wait for: not counted. */
static const GLubyte *(*real_GetString)(GLenum name);
static const GLubyte *hook_GetString(GLenum name)
{
    if (interposed.lost && interposed.versionless)
        return NULL;
    UNHOOK(GetString);
    const GLubyte *text = real_GetString(name);
    HOOK(GetString);
    return text;
}

/* Those that are unlike the others. */
static GLenum (*real_GetError)(void);
static GLenum hook_GetError(void)
{
    GLenum error = interposed.error;
    count_call();
    interposed.asked++;
    interposed.error = GL_NO_ERROR;
    if (interposed.lost)
        return GL_CONTEXT_LOST;
    if (error != GL_NO_ERROR)
        return error;
    UNHOOK(GetError);
    error = real_GetError();
    HOOK(GetError);
    return error;
}

static void (*real_GetIntegerv)(GLenum name, GLint *values);
static void hook_GetIntegerv(GLenum name, GLint *values)
{
    count_call();
    interposed.asked++;
    if (interposed.robust && name == GL_RESET_NOTIFICATION_STRATEGY)
        *values = GL_LOSE_CONTEXT_ON_RESET;
    else if (interposed.lost)
        *values = GARBAGE;
    else
        CALL(GetIntegerv, (name, values));
}

static GLenum (*real_CheckFramebufferStatus)(GLenum target);
static GLenum hook_CheckFramebufferStatus(GLenum target)
{
    count_call();
    interposed.asked++;
    if (fails(GL_NO_ERROR))
        return GL_FRAMEBUFFER_UNSUPPORTED;
    if (interposed.lost)
        return GL_FRAMEBUFFER_COMPLETE;
    UNHOOK(CheckFramebufferStatus);
    GLenum status = real_CheckFramebufferStatus(target);
    HOOK(CheckFramebufferStatus);
    return status;
}

static GLuint (*real_CreateShader)(GLenum kind);
static GLuint hook_CreateShader(GLenum kind)
{
    count_call();
    interposed.made++;
    if (fails(GL_OUT_OF_MEMORY) || interposed.lost)
        return 0;
    UNHOOK(CreateShader);
    GLuint shader = real_CreateShader(kind);
    HOOK(CreateShader);
    return shader;
}

static GLuint (*real_CreateProgram)(void);
static GLuint hook_CreateProgram(void)
{
    count_call();
    interposed.made++;
    if (fails(GL_OUT_OF_MEMORY) || interposed.lost)
        return 0;
    UNHOOK(CreateProgram);
    GLuint program = real_CreateProgram();
    HOOK(CreateProgram);
    return program;
}

#define EACH(X)                                                                                    \
    X(GenTextures)                                                                                 \
    X(GenFramebuffers)                                                                             \
    X(GenRenderbuffers)                                                                            \
    X(GenVertexArrays)                                                                             \
    X(GenSamplers)                                                                                 \
    X(GenBuffers)                                                                                  \
    X(GenQueries)                                                                                  \
    X(TexImage2D)                                                                                  \
    X(TexStorage2D)                                                                                \
    X(RenderbufferStorage)                                                                         \
    X(RenderbufferStorageMultisample)                                                              \
    X(BufferData)                                                                                  \
    X(CompileShader)                                                                               \
    X(LinkProgram)                                                                                 \
    X(CreateShader)                                                                                \
    X(CreateProgram)                                                                               \
    X(CheckFramebufferStatus)                                                                      \
    X(GetError)                                                                                    \
    X(GetString)                                                                                   \
    X(GetIntegerv)                                                                                 \
    X(GetBooleanv)                                                                                 \
    X(GetFloatv)                                                                                   \
    X(GetFloati_v)                                                                                 \
    X(GetIntegeri_v)                                                                               \
    X(GetFramebufferAttachmentParameteriv)                                                         \
    X(GetTexParameteriv)                                                                           \
    X(GetTexLevelParameteriv)                                                                      \
    X(GetInternalformativ)                                                                         \
    X(GetProgramiv)                                                                                \
    X(GetShaderiv)                                                                                 \
    X(GetInteger64v)                                                                               \
    X(IsFramebuffer)                                                                               \
    X(IsProgram)                                                                                   \
    X(IsTexture)                                                                                   \
    X(IsEnabled)                                                                                   \
    X(IsEnabledi)                                                                                  \
    X(GetUniformLocation)                                                                          \
    X(GetGraphicsResetStatus)                                                                      \
    X(GetGraphicsResetStatusKHR)                                                                   \
    X(GetGraphicsResetStatusARB)                                                                   \
    X(GetGraphicsResetStatusEXT)                                                                   \
    X(DrawArrays)                                                                                  \
    X(ClearBufferfv)                                                                               \
    X(BufferSubData)                                                                               \
    X(BindFramebuffer)                                                                             \
    X(UseProgram)                                                                                  \
    X(PushDebugGroup)                                                                              \
    X(PopDebugGroup)                                                                               \
    X(DeleteTextures)

#define INSTALL(name) HOOK(name);
#define REMOVE(name)  UNHOOK(name);

void interposed_begin(void)
{
    interposed = (struct interposed){0};
    EACH(INSTALL)
}

void interposed_end(void)
{
    EACH(REMOVE)
}
