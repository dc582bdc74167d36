/* The file of a journal: opened for one tool alone, written at once, kept aside. */
#ifndef JOURNAL_FILE_H
#define JOURNAL_FILE_H

#include <stdbool.h>
#include <stddef.h>

struct journal_file {
    int fd; /* -1: none */
    char *path;
    char *pending; /* what a full disk did not take yet */
    size_t pending_size;
    int given_up; /* errno: nothing more is taken; 0: it is */
    bool dirty;   /* not yet brought to the disk */
    bool named;   /* its name is on the disk */
};

enum journal_file_opened {
    JOURNAL_FILE_OPEN,
    JOURNAL_FILE_USED,   /* by another tool */
    JOURNAL_FILE_REFUSED /* not a plain file, no permission, ... */
};

/* Opens and locks; makes it if it is not there. One line in `message` unless it is open. */
enum journal_file_opened journal_file_open(struct journal_file *file, const char *path,
                                           char *message);

/* All that stands in it, to be freed; NULL with one line in `message`. */
char *journal_file_read(struct journal_file *file, size_t *size, char *message);

/* Gives it another name, PATH.ENDING or PATH.ENDING.2 and so on, none that exists; tells which. */
bool journal_file_keep_aside(struct journal_file *file, const char *ending, char *name,
                             size_t name_size, char *message);

/* Cuts it off, and goes on from there. */
bool journal_file_cut(struct journal_file *file, size_t size);

/*
 * Appends. False, with errno, where it could not be written: it is then kept and written before
 * whatever comes next.
 */
bool journal_file_append(struct journal_file *file, const char *bytes, size_t size);

/* Takes nothing more: what comes next fails with that errno. */
void journal_file_give_up(struct journal_file *file, int problem);

/* Tries once more to write what waits; whether nothing is missing in the file. */
bool journal_file_flush(struct journal_file *file);

/* Brings it to the disk. */
void journal_file_sync(struct journal_file *file);

/* Closes, removing the file first if so wished. */
void journal_file_close(struct journal_file *file, bool remove_file);

#endif
