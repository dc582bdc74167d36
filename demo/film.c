/* Existing pictures, one or many. */
#include "film.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <epoxy/gl.h>

#include "file_pattern.h"
#include "film_picture.h"
#include "short_path.h"

enum { FACES = 6, PICTURES_MAX = 1000000, GAP_MAX = 1000 };

/*
 * In the order of GL. The files have +Z ahead, +X to the right and +Y up, each face upright as it
 * is seen from inside; a host's camera looks along -Z, so ahead and behind change places.
 */
static const char *const face_files[FACES] = {"posx", "negx", "posy", "negy", "negz", "posz"};

struct film {
    const char *pattern;
    double rate_hz;
    long first, count; /* numbers of the files; count is 1 where there is no number */
    long shown;        /* index; -1: none yet */
    int side_px[2];    /* of the first picture */
    struct cupola_source source;
};

static bool is_there(const struct film *film, long number)
{
    char path[PATH_MAX];

    return file_pattern_path(film->pattern, number, face_files[0], path) && access(path, F_OK) == 0;
}

/* After the last picture none may follow: a film that ends too early would look complete. */
static bool has_no_gap(const struct film *film, char *message)
{
    long missing = film->first + film->count;

    for (long number = missing + 1; number <= missing + GAP_MAX; number++) {
        if (!is_there(film, number))
            continue;
        snprintf(message, MESSAGE_SIZE,
                 "--show: '%s' has no file of number %ld, but one of number %ld; allowed: numbers "
                 "without a gap",
                 short_path(film->pattern).text, missing, number);
        return false;
    }
    return true;
}

static bool find_numbers(struct film *film, char *message)
{
    char path[PATH_MAX];
    bool cube = film->source.kind == CUPOLA_SOURCE_CUBE;

    if (!file_pattern_path(film->pattern, 0, "", path) ||
        cube != (strstr(film->pattern, "%s") != NULL)) {
        snprintf(message, MESSAGE_SIZE, "--show: '%s' is not allowed; allowed: %s",
                 short_path(film->pattern).text,
                 cube ? "a name with %s, for posx, negx, posy, negy, posz and negz, and with %04d "
                        "or the like for a sequence"
                      : "a name without %, or with %04d or the like for a sequence");
        return false;
    }
    film->count = 1;
    if (!file_pattern_has_number(film->pattern))
        return true;
    film->first = is_there(film, 0) ? 0 : 1;
    film->count = 0;
    while (film->count < PICTURES_MAX && is_there(film, film->first + film->count))
        film->count++;
    if (film->count > 0)
        return has_no_gap(film, message);
    snprintf(message, MESSAGE_SIZE, "--show: '%s' has no file of number 0 and none of number 1",
             short_path(film->pattern).text);
    return false;
}

static bool check_size(struct film *film, const char *path, const struct film_picture *picture,
                       char *message)
{
    bool wide = film->source.kind == CUPOLA_SOURCE_EQUIRECTANGULAR;
    GLint most = 0;

    glGetIntegerv(wide || film->source.kind == CUPOLA_SOURCE_DOMEMASTER
                      ? GL_MAX_TEXTURE_SIZE
                      : GL_MAX_CUBE_MAP_TEXTURE_SIZE,
                  &most);
    const char *allowed = NULL;
    if (picture->width != picture->height * (wide ? 2 : 1))
        allowed = wide ? "twice as wide as high" : "as wide as high";
    else if (film->side_px[0] && film->side_px[0] != picture->width)
        allowed = "all pictures of one size";
    if (allowed)
        snprintf(message, MESSAGE_SIZE, "--show: %s is %d x %d px; allowed for %s: %s",
                 short_path(path).text, picture->width, picture->height,
                 cupola_source_name((int)film->source.kind), allowed);
    else if (picture->width > most)
        snprintf(message, MESSAGE_SIZE,
                 "--show: %s is %d x %d px; allowed by this GL: up to %d each way",
                 short_path(path).text, picture->width, picture->height, most);
    else
        return true;
    return false;
}

/* One file into the texture that is bound. */
static bool load_file(struct film *film, const char *path, GLenum target, char *message)
{
    struct film_picture picture;
    bool loaded = film_picture_read(path, &picture, message);

    if (loaded && (loaded = check_size(film, path, &picture, message))) {
        bool upright = target == GL_TEXTURE_2D || target == GL_TEXTURE_CUBE_MAP_POSITIVE_Y ||
                       target == GL_TEXTURE_CUBE_MAP_NEGATIVE_Y;
        if (!upright)
            film_picture_turn(&picture); /* GL's faces stand on their heads, seen from inside */
        glTexImage2D(target, 0, picture.floats ? GL_RGBA32F : GL_SRGB8_ALPHA8, picture.width,
                     picture.height, 0, GL_RGBA, picture.floats ? GL_FLOAT : GL_UNSIGNED_BYTE,
                     picture.floats ? (const void *)picture.floats : picture.bytes);
        film->side_px[0] = picture.width;
        film->side_px[1] = picture.height;
    }
    film_picture_free(&picture);
    return loaded;
}

static bool load(struct film *film, long index, char *message)
{
    bool cube = film->source.kind == CUPOLA_SOURCE_CUBE;
    GLenum target = cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
    char path[PATH_MAX];

    if (!film->source.texture)
        glGenTextures(1, &film->source.texture);
    glBindTexture(target, film->source.texture);
    for (int face = 0; face < film_faces(film); face++) {
        GLenum place = cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + (GLenum)face : target;
        if (!film_path(film, index, face, path)) {
            snprintf(message, MESSAGE_SIZE, "--show: '%s' makes too long a name",
                     short_path(film->pattern).text);
            return false;
        }
        if (!load_file(film, path, place, message))
            return false;
    }
    glGenerateMipmap(target);
    glBindTexture(target, 0);
    return true;
}

struct film *film_create(const struct options *options, char *message)
{
    struct film *film = calloc(1, sizeof *film);

    if (!film) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return NULL;
    }
    film->pattern = options->show;
    film->rate_hz = options->frame_rate.given ? options->frame_rate.value[0] : 30;
    film->shown = -1;
    film->source = (struct cupola_source){
        .kind = options->show_as,
        .place = options->picture_place,
        .mipmaps = !options->reference, /* whose rays find all of a pixel */
        .fov_rad = options->picture_fov_rad.value[0],
        .orientation = {options->picture_aim_rad.value[0], options->picture_aim_rad.value[1],
                        options->picture_aim_rad.value[2]},
    };
    if (find_numbers(film, message) && film_seek(film, 0, message))
        return film;
    film_destroy(film);
    return NULL;
}

void film_destroy(struct film *film)
{
    if (!film)
        return;
    glDeleteTextures(1, &film->source.texture);
    free(film);
}

bool film_seek(struct film *film, long index, char *message)
{
    index %= film->count;
    if (index == film->shown)
        return true;
    if (!load(film, index, message))
        return false;
    film->shown = index;
    return true;
}

long film_index(const struct film *film, double time_ms)
{
    return (long)fmod(floor(time_ms * 1e-3 * film->rate_hz), (double)film->count);
}

long film_first(const struct film *film)
{
    return film->first;
}

long film_count(const struct film *film)
{
    return film->count;
}

int film_faces(const struct film *film)
{
    return film->source.kind == CUPOLA_SOURCE_CUBE ? FACES : 1;
}

bool film_path(const struct film *film, long index, int face, char path[PATH_MAX])
{
    return file_pattern_path(film->pattern, film->first + index, face_files[face], path);
}

const struct cupola_source *film_source(const struct film *film)
{
    return &film->source;
}
