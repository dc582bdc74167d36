/* A locale with a decimal comma. Define _XOPEN_SOURCE 700 before any header. */
#ifndef COMMA_LOCALE_H
#define COMMA_LOCALE_H

#include <locale.h>
#include <stdio.h>
#include <stdlib.h>

#include "check.h"
#include "folder.h"

/* glibc keeps what it made of LOCPATH. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void)
{
    return "leak:argz_add_sep\n";
}

/* Made for the test where the system has none; 0 where that cannot be. */
static inline locale_t comma_locale(void)
{
    char command[1024];
    snprintf(command, sizeof command, "localedef -i de_DE -f UTF-8 %s >/dev/null 2>&1",
             in_folder("de_DE.UTF-8"));
    if (system(command) != 0)
        print_message("localedef: no locale made\n");
    setenv("LOCPATH", folder, 1);
    locale_t locale = newlocale(LC_ALL_MASK, "de_DE.UTF-8", (locale_t)0);
    unsetenv("LOCPATH");
    return locale ? locale : newlocale(LC_ALL_MASK, "de_DE.UTF-8", (locale_t)0);
}

#endif
