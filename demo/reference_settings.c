/* All that a reference's pictures depend on. */
#include "reference_settings.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include <epoxy/gl.h>

#include <cupola/version.h>

#include "short_path.h"

static void take_text(struct reference_state *state, const char *text)
{
    state->settings = reference_number(state->settings, text ? text : "", text ? strlen(text) : 0);
    state->settings = reference_number(state->settings, "", 1);
}

/* Each word, with a blank between two. */
static void take_command(struct reference_state *state, const struct options *options)
{
    size_t length = 0;

    for (int i = 0; i < options->word_count; i++) {
        take_text(state, options->words[i]);
        int more = snprintf(state->command + length, sizeof state->command - length, "%s%s",
                            i ? " " : "", options->words[i]);
        length += more > 0 ? (size_t)more : 0;
        if (length >= sizeof state->command)
            length = sizeof state->command - 1;
    }
}

/* A file that is not there has nothing in it. */
static bool take_contents(struct reference_state *state, const char *path, char *message)
{
    char bytes[65536];
    size_t count;
    FILE *file = path ? fopen(path, "rb") : NULL;

    if (!path)
        return true;
    while (file && (count = fread(bytes, 1, sizeof bytes, file)) > 0)
        state->settings = reference_number(state->settings, bytes, count);
    bool read = file && !ferror(file);
    if (!read)
        snprintf(message, MESSAGE_SIZE, "--reference: %s cannot be read: %s", short_path(path).text,
                 strerror(errno));
    if (file)
        fclose(file);
    return read;
}

static void take_pictures(struct reference_state *state, const struct film *film)
{
    char path[PATH_MAX];
    struct stat file;

    for (long index = 0; index < film_count(film); index++)
        for (int face = 0; face < film_faces(film); face++) {
            if (!film_path(film, index, face, path) || stat(path, &file) != 0)
                continue;
            const int64_t facts[3] = {file.st_size, file.st_mtim.tv_sec, file.st_mtim.tv_nsec};
            state->settings = reference_number(state->settings, facts, sizeof facts);
        }
}

bool reference_settings(const struct options *options, const struct world *world,
                        struct reference_state *state, char *message)
{
    state->settings = REFERENCE_NUMBER;
    memset(state->command, 0, sizeof state->command);
    take_command(state, options);
    take_text(state, cupola_version());
    take_text(state, (const char *)glGetString(GL_RENDERER));
    take_text(state, (const char *)glGetString(GL_VERSION));
    if (world->film)
        take_pictures(state, world->film);
    if (world->scene)
        state->settings = reference_number(state->settings, &world->scene->contents,
                                           sizeof world->scene->contents);
    return take_contents(state, options->rig, message) &&
           take_contents(state, options->lens_table, message);
}
