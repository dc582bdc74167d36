/*
 * The version of Cupola. This header is the only place where it is written; the build reads it
 * from here.
 */
#ifndef CUPOLA_VERSION_H
#define CUPOLA_VERSION_H

/* Grows with changes that break hosts. */
#define CUPOLA_VERSION_MAJOR 0
/* Grows with what is added. */
#define CUPOLA_VERSION_MINOR 1
/* Grows with what is mended. */
#define CUPOLA_VERSION_PATCH 0

#ifndef CUPOLA_API
#define CUPOLA_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

/*
 * The version of the library that runs, which may differ from the one compiled against.
 *
 * returns  "major.minor.patch", a static string
 * thread   any
 * since    0.1
 */
CUPOLA_API const char *cupola_version(void);

#ifdef __cplusplus
}
#endif

#endif
