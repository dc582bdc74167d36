/* Numbers in files have a point, whatever the host's locale: the C locale for this thread only. */
#ifndef C_LOCALE_H
#define C_LOCALE_H

#include <locale.h>

struct c_locale {
    locale_t own;
    locale_t before;
};

/* Returns 0, or -1 when there is no memory for it. */
static inline int c_locale_enter(struct c_locale *locale)
{
    locale->own = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (locale->own == (locale_t)0)
        return -1;
    locale->before = uselocale(locale->own);
    return 0;
}

static inline void c_locale_leave(struct c_locale *locale)
{
    uselocale(locale->before);
    freelocale(locale->own);
}

#endif
