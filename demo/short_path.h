/* Paths in messages: a long one loses its middle, so that what comes after it is still read. */
#ifndef SHORT_PATH_H
#define SHORT_PATH_H

enum { SHORT_PATH_MAX = 400 };

struct short_path {
    char text[SHORT_PATH_MAX + 1];
};

/* As an argument of printf: short_path(path).text */
struct short_path short_path(const char *path);

#endif
