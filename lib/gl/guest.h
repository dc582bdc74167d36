/*
 * Cupola as a guest in the host's context: what every call does round its work in the GL, whatever
 * the work is. It asks whether the context still is, opens a debug group, keeps the host's state,
 * names what it makes and tells the host's log.
 */
#ifndef GUEST_H
#define GUEST_H

#include <epoxy/gl.h>
#include <stdbool.h>

#include "cupola/error.h"
#include "cupola/log.h"
#include "host_state.h"

struct guest {
    const struct host_features *features; /* of the same context */
    struct cupola_log log;
    bool leaves_state; /* frames neither ask for the host's state nor put it back */
    bool lost;         /* the context was seen lost: the GL is not touched again */
};

/* A piece of work in the GL, from guest_begin to guest_end. */
struct guest_work {
    struct host_state state;
    bool grouped;
};

/* An error unless a context of OpenGL 3.3, OpenGL ES 3.0 or newer is current. */
int context_check(struct cupola_error *error);

/* The same; also, and from then on, CUPOLA_ERROR_LOST where the guest's context has been lost. */
int guest_check(struct guest *guest, struct cupola_error *error);

/* CUPOLA_ERROR_LOST if that was seen before. Asks no GL. */
int guest_check_seen(const struct guest *guest, struct cupola_error *error);

/*
 * The reason why a call failed: what its GL calls gave in a context that was lost meanwhile means
 * nothing. The error is never NULL.
 */
int guest_reason(struct guest *guest, int status, struct cupola_error *error);

/* The end of every public call: the same, and a failure is told to the log. */
int guest_ended(struct guest *guest, const char *call, int status, struct cupola_error *error);

/*
 * Begins a piece of work: a debug group of that name ("Cupola " before it), and the host's state
 * kept and set for full-screen passes. Work in frames leaves the state where the host wishes that;
 * work that makes something never does.
 */
__attribute__((format(printf, 3, 4))) void guest_begin(const struct guest *guest,
                                                       struct guest_work *work, const char *format,
                                                       ...);
__attribute__((format(printf, 3, 4))) void guest_begin_making(const struct guest *guest,
                                                              struct guest_work *work,
                                                              const char *format, ...);
void guest_end(const struct guest *guest, const struct guest_work *work);

/* A debug group by itself; whether it was opened, which guest_group_close has to be told. */
__attribute__((format(printf, 2, 3))) bool guest_group_open(const struct guest *guest,
                                                            const char *format, ...);
void guest_group_close(const struct guest *guest, bool opened);

__attribute__((format(printf, 4, 5))) void guest_tell(const struct guest *guest, int level, int id,
                                                      const char *format, ...);

/*
 * What the GL has made gets its name, for debuggers and, textures, renderbuffers and programs, for
 * the log. The kind is as for glObjectLabel, GL_TEXTURE and so on; the object has been bound.
 */
__attribute__((format(printf, 4, 5))) void guest_name(const struct guest *guest, GLenum kind,
                                                      GLuint object, const char *format, ...);

/* Forgets errors that were there before, so that the next glGetError tells of our own calls. */
void gl_errors_drop(void);
/* The same, where they are the host's: the log is told. */
void guest_errors_drop(const struct guest *guest);

/*
 * Says what the GL refused, `what` in words, after a call that may have failed. GL_NO_ERROR stands
 * for a call that gave nothing and no reason.
 */
__attribute__((format(printf, 3, 4))) int gl_refused(GLenum failure, struct cupola_error *error,
                                                     const char *what, ...);

#endif
