/* A sequence of pictures without a window: one file for each frame. */
#include "film_output.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "eye_path.h"
#include "file_clash.h"
#include "file_pattern.h"
#include "output_file.h"
#include "short_path.h"

/* What a file is, whatever its name. */
struct identity {
    dev_t device;
    ino_t number;
};

struct identities {
    struct identity *sorted;
    size_t count;
};

bool film_output_is_numbered(const struct options *options)
{
    return options->output && file_pattern_has_number(options->output);
}

/* Pictures that differ from frame to frame: a sequence, or a viewer who moves. */
static bool has_many(const struct options *options)
{
    return options->eye_circle_m.given || (options->show && file_pattern_has_number(options->show));
}

bool film_output_check_options(const struct options *options, char *message)
{
    const char *problem = NULL;

    if (film_output_is_numbered(options)) {
        if (!has_many(options) && !options->osc)
            problem = "has a number, but --show names no sequence, and without --eye-circle and "
                      "--osc no eye moves; allowed: a name without %";
        else if (options->stats)
            problem = "has a number, and --stats wants one file only; allowed: one of them";
        else if (strstr(options->output, "%s"))
            problem = "has %s; allowed: a name with %05d or the like alone";
    } else if (options->output && strchr(options->output, '%')) {
        problem = "has a % that begins no number; allowed: a name without %, or with %05d or the "
                  "like for a sequence";
    } else if (has_many(options) && options->frames > 1 && !options->stats) {
        problem = "is one file for many frames; allowed: a name with %05d or the like, or no "
                  "--frames for the first picture alone";
    }
    if (problem)
        snprintf(message, MESSAGE_SIZE, "--output: '%s' %s",
                 short_path(options->output ? options->output : "dome.png").text, problem);
    return !problem;
}

long film_output_frames(const struct options *options, const struct film *film)
{
    if (options->frames > 0)
        return options->frames;
    return film ? film_count(film) : EYE_PATH_FRAMES;
}

bool film_output_path(const struct options *options, const struct film *film, long index,
                      char path[PATH_MAX])
{
    long first = film ? film_first(film) : 0;

    return file_pattern_path(options->output, first + index, "", path);
}

static int compare(const void *first, const void *second)
{
    const struct identity *a = first, *b = second;

    if (a->device != b->device)
        return a->device < b->device ? -1 : 1;
    return (a->number > b->number) - (a->number < b->number);
}

/* All pictures of the film that are there. */
static bool identify(const struct film *film, struct identities *identities)
{
    long count = film_count(film);
    int faces = film_faces(film);
    char path[PATH_MAX];
    struct stat file;

    identities->count = 0;
    identities->sorted = calloc((size_t)count * (size_t)faces, sizeof *identities->sorted);
    if (!identities->sorted)
        return false;
    for (long index = 0; index < count; index++)
        for (int face = 0; face < faces; face++)
            if (film_path(film, index, face, path) && stat(path, &file) == 0)
                identities->sorted[identities->count++] =
                    (struct identity){file.st_dev, file.st_ino};
    qsort(identities->sorted, identities->count, sizeof *identities->sorted, compare);
    return true;
}

static bool check_own(const char *option, const char *path, const struct identities *pictures,
                      char *message)
{
    struct stat file;

    if (!path || pictures->count == 0 || stat(path, &file) != 0)
        return true;
    const struct identity wanted = {file.st_dev, file.st_ino};
    if (!bsearch(&wanted, pictures->sorted, pictures->count, sizeof wanted, compare))
        return true;
    snprintf(message, MESSAGE_SIZE,
             "%s: %s is a picture that --show names; allowed: files of their own", option,
             short_path(path).text);
    return false;
}

/* Every file of a numbered --output. */
static bool check_numbered(const struct options *options, const struct film *film,
                           const struct identities *pictures, char *message)
{
    long frames = film_output_frames(options, film);
    char path[PATH_MAX];

    for (long index = 0; index < frames; index++) {
        if (!film_output_path(options, film, index, path)) {
            snprintf(message, MESSAGE_SIZE, "--output: '%s' makes too long a name",
                     short_path(options->output).text);
            return false;
        }
        if (!output_file_check("--output", path, message) ||
            !file_clash_check(options, path, message) ||
            !check_own("--output", path, pictures, message))
            return false;
    }
    return true;
}

bool film_output_check_files(const struct options *options, const struct film *film,
                             const char *picture, char *message)
{
    const char *save = options->save_rig;
    struct identities pictures = {NULL, 0};
    char backup[PATH_MAX];

    if (!film)
        return !film_output_is_numbered(options) ||
               check_numbered(options, film, &pictures, message);
    if (!identify(film, &pictures)) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return false;
    }
    bool has_backup = save && snprintf(backup, sizeof backup, "%s.bak", save) < PATH_MAX;
    bool good =
        check_own("--output", picture, &pictures, message) &&
        check_own("--stats", options->stats, &pictures, message) &&
        check_own("--save-rig", save, &pictures, message) &&
        check_own("--save-rig", has_backup ? backup : NULL, &pictures, message) &&
        (!film_output_is_numbered(options) || check_numbered(options, film, &pictures, message));
    free(pictures.sorted);
    return good;
}
