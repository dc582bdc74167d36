/*
 * What happens inside, told to a host that wants to know. Without a callback the library is silent.
 */
#ifndef CUPOLA_LOG_H
#define CUPOLA_LOG_H

#include "version.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How much an entry matters. */
enum cupola_log_level {
    CUPOLA_LOG_ERROR = 0, /* a call has failed; its error says the same */
    CUPOLA_LOG_WARNING,   /* it works, but slower or otherwise than one would expect */
    CUPOLA_LOG_INFO,      /* something was made or given back */
    CUPOLA_LOG_DEBUG,     /* details, once in a while; never in every frame */
};

/*
 * What an entry is about. The numbers are part of the interface: they are never given to something
 * else, and new ones come at the end of their hundred.
 */
enum cupola_log_id {
    CUPOLA_LOG_CALL_FAILED = 100, /* error: any call, with its message */
    CUPOLA_LOG_CONTEXT_LOST,      /* error: seen for the first time */

    CUPOLA_LOG_ERRORS_DROPPED = 200, /* warning: GL errors of the host's were pending */
    CUPOLA_LOG_TABLE_ON_CPU,         /* warning: this GL cannot draw into floats */
    CUPOLA_LOG_NOT_DRAWN, /* warning: a warp of views none of which was ever drawn; once */

    CUPOLA_LOG_CREATED = 300, /* info: a cupola_gl, with its formats, sizes and the GL's names */
    CUPOLA_LOG_DESTROYED,     /* info */
    CUPOLA_LOG_TABLE_CHOSEN, /* info: which stage CUPOLA_TABLE_AUTO became, and what was measured */

    CUPOLA_LOG_PROGRAM = 400, /* debug: a program was compiled */
    CUPOLA_LOG_TEXTURE,       /* debug: a texture or renderbuffer was made */
    CUPOLA_LOG_FEATURES,      /* debug: what of the GL beyond its floor is used */
};

/* Who is told. All zero: nobody. */
struct cupola_log {
    /*
     * Called on the thread of the call that it is about, while GL state may be Cupola's own: it
     * must make no GL call and none of Cupola's.
     *
     * level    of enum cupola_log_level
     * id       of enum cupola_log_id
     * text     one line in English without a final newline; valid during the call
     * user     as below
     */
    void (*write)(int level, int id, const char *text, void *user);
    void *user; /* handed to `write`; may be NULL */
    int most;   /* the highest level that is told, of enum cupola_log_level; 0: errors alone */
};

/*
 * The name of a level.
 *
 * level    of enum cupola_log_level
 * returns  "error", "warning", "info" or "debug"; NULL for a number that is no level
 * thread   any
 * since    0.1
 */
CUPOLA_API const char *cupola_log_level_name(int level);

#ifdef __cplusplus
}
#endif

#endif
