/* What a reference that is under way has on disk. */
#include "reference_state.h"

#include <assert.h>
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "options.h"
#include "short_path.h"

/* As it stands in the file, before the sum; in the bytes' order of the machine. */
struct header {
    char mark[24];
    uint32_t order;
    uint32_t version;
    char command[REFERENCE_COMMAND_MAX];
    uint64_t settings;
    int64_t picture, frames, width, height;
    uint64_t check; /* of all the rest, and the sum */
};

static const char mark[24] = "cupola-demo reference\n";

enum { ORDER = 0x01020304, VERSION = 2 };

uint64_t reference_number(uint64_t number, const void *bytes, size_t count)
{
    const unsigned char *at = bytes;

    for (size_t i = 0; i < count; i++)
        number = (number ^ at[i]) * 1099511628211u;
    return number;
}

static size_t sum_bytes(const struct reference_state *state)
{
    return 4 * sizeof *state->sum * (size_t)state->width * (size_t)state->height;
}

/* By words of 8 bytes. */
static uint64_t check_words(uint64_t number, const void *bytes, size_t count)
{
    uint64_t word;

    for (size_t at = 0; at < count; at += sizeof word) {
        memcpy(&word, (const char *)bytes + at, sizeof word);
        number = (number ^ word) * 1099511628211u;
        number ^= number >> 29;
    }
    return number;
}

static uint64_t check_of(const struct header *header, const struct reference_state *state)
{
    static_assert(offsetof(struct header, check) % sizeof(uint64_t) == 0, "whole words");
    uint64_t number = check_words(REFERENCE_NUMBER, header, offsetof(struct header, check));

    return check_words(number, state->sum, sum_bytes(state));
}

static struct header header_of(const struct reference_state *state)
{
    struct header header;

    memset(&header, 0, sizeof header); /* gaps, too */
    memcpy(header.mark, mark, sizeof mark);
    header.order = ORDER;
    header.version = VERSION;
    memcpy(header.command, state->command, sizeof header.command);
    header.settings = state->settings;
    header.picture = state->picture;
    header.frames = state->frames;
    header.width = state->width;
    header.height = state->height;
    header.check = check_of(&header, state);
    return header;
}

/* Both of it behind each other: the name of a file whose `tail` says what it is. */
static bool path_of(const char *path, const char *tail, char whole[PATH_MAX])
{
    return snprintf(whole, PATH_MAX, "%s%s", path, tail) < PATH_MAX;
}

static bool write_all(FILE *file, const struct reference_state *state)
{
    const struct header header = header_of(state);

    return fwrite(&header, sizeof header, 1, file) == 1 &&
           fwrite(state->sum, 1, sum_bytes(state), file) == sum_bytes(state) && fflush(file) == 0 &&
           fsync(fileno(file)) == 0;
}

/* Always under one name, so that many ends leave one file at most. */
bool reference_state_write(const char *path, const struct reference_state *state, char *message)
{
    char temporary[PATH_MAX];
    FILE *file = path_of(path, ".tmp", temporary) ? fopen(temporary, "wb") : NULL;
    bool written = file && write_all(file, state);
    int problem = errno;

    if (file && fclose(file) != 0 && written) {
        written = false;
        problem = errno;
    }
    if (written && rename(temporary, path) == 0)
        return true;
    problem = written ? errno : problem;
    if (file)
        unlink(temporary);
    snprintf(message, MESSAGE_SIZE, "--reference: %s cannot be written: %s", short_path(path).text,
             strerror(problem));
    return false;
}

static bool refuse(const char *path, const char *problem, char *message)
{
    snprintf(message, MESSAGE_SIZE, "--reference: %s %s; remove it to begin anew",
             short_path(path).text, problem);
    return false;
}

/* Why a file cannot be gone on with; NULL: it can. */
static const char *stranger(const struct header *header, const struct reference_state *state)
{
    if (memcmp(header->mark, mark, sizeof mark) != 0 || header->order != ORDER ||
        header->version != VERSION)
        return "is no state of this program on this machine";
    if (strncmp(header->command, state->command, sizeof header->command) != 0)
        return "was begun by another command line; allowed: the same again";
    if (header->settings != state->settings || header->width != state->width ||
        header->height != state->height)
        return "was begun with other contents of the files that are read, another OpenGL or "
               "another cupola-demo; allowed: the same";
    return header->picture < 0 || header->frames < 0 ? "is damaged" : NULL;
}

bool reference_state_read(const char *path, struct reference_state *state, char *message)
{
    struct header header;
    const char *problem = NULL;
    FILE *file = fopen(path, "rb");

    if (!file && errno == ENOENT)
        return true;
    if (!file) {
        snprintf(message, MESSAGE_SIZE, "--reference: %s cannot be read: %s", short_path(path).text,
                 strerror(errno));
        return false;
    }
    if (fread(&header, sizeof header, 1, file) != 1)
        problem = "is no state of this program on this machine";
    else
        problem = stranger(&header, state);
    if (!problem && (fread(state->sum, 1, sum_bytes(state), file) != sum_bytes(state) ||
                     fgetc(file) != EOF || check_of(&header, state) != header.check))
        problem = "is damaged";
    fclose(file);
    if (problem)
        return refuse(path, problem, message);
    state->picture = header.picture;
    state->frames = header.frames;
    return true;
}
