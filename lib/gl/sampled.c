/* Textures that are sampled: whether they can be, where the GL can be asked. */
#include "sampled.h"

#include "error.h"
#include "host_cube.h"
#include "host_origin.h"

static const char allowed[] = "a format of colours that are floats or normalised numbers";

/* The number of the last level that a texture of some side may have. */
static GLint last_level(GLint side)
{
    GLint level = 0;
    while (side >> (level + 1) > 0)
        level++;
    return level;
}

/* A cube map is asked by one of its faces. */
static GLenum level_target(GLenum target)
{
    return target == GL_TEXTURE_CUBE_MAP ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : target;
}

static GLint level_value(GLenum target, GLint level, GLenum name)
{
    GLint value = 0;
    glGetTexLevelParameteriv(level_target(target), level, name, &value);
    return value;
}

/* -1 for one beyond all that the GL has, for which to ask would be an error. */
static GLint base_level(GLenum target)
{
    GLint base = 0, largest = 0;
    glGetTexParameteriv(target, GL_TEXTURE_BASE_LEVEL, &base);
    if (base == 0)
        return 0;
    glGetIntegerv(target == GL_TEXTURE_CUBE_MAP ? GL_MAX_CUBE_MAP_TEXTURE_SIZE
                                                : GL_MAX_TEXTURE_SIZE,
                  &largest);
    return base <= last_level(largest) ? base : -1;
}

bool texture_size(const struct host_features *features, GLenum target, GLint size[3])
{
    size[0] = size[1] = size[2] = 0;
    if (!features->texture_sizes)
        return false;
    GLint base = base_level(target);
    if (base < 0)
        return true;
    size[0] = level_value(target, base, GL_TEXTURE_WIDTH);
    size[1] = level_value(target, base, GL_TEXTURE_HEIGHT);
    size[2] = level_value(target, base, GL_TEXTURE_DEPTH);
    return true;
}

/* What a level is made of, where that is no colour; else NULL. */
static const char *strange_format(GLenum target, GLint level)
{
    GLint type = level_value(target, level, GL_TEXTURE_RED_TYPE);
    if (type == GL_INT || type == GL_UNSIGNED_INT)
        return "integers";
    if (level_value(target, level, GL_TEXTURE_DEPTH_SIZE) > 0)
        return "depth";
    return level_value(target, level, GL_TEXTURE_STENCIL_SIZE) > 0 ? "stencil" : NULL;
}

/* Those of a texture whose levels were made all at once are there, as many as count. */
static bool has_storage(const struct host_features *features, GLenum target)
{
    const struct origin storage = {42, "GL_ARB_texture_storage", 30, NULL};
    GLint at_once = GL_FALSE;
    if (host_has(features, storage))
        glGetTexParameteriv(target, GL_TEXTURE_IMMUTABLE_FORMAT, &at_once);
    return at_once;
}

static bool has_levels(const struct host_features *features, GLenum target, GLint base, GLint side)
{
    GLint most = 0;
    glGetTexParameteriv(target, GL_TEXTURE_MAX_LEVEL, &most);
    GLint last = base + last_level(side);
    return level_value(target, last < most ? last : most, GL_TEXTURE_WIDTH) > 0 ||
           has_storage(features, target);
}

static int check_bound(const struct host_features *features, GLenum target, GLuint texture,
                       bool mipmaps, struct cupola_error *error)
{
    GLint base = base_level(target);
    GLint width = base < 0 ? 0 : level_value(target, base, GL_TEXTURE_WIDTH);
    GLint height = base < 0 ? 0 : level_value(target, base, GL_TEXTURE_HEIGHT);
    if (width < 1 || height < 1)
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "texture %u has no texels in its base level; allowed: at least 1 x 1",
                         texture);
    const char *strange = strange_format(target, base);
    if (strange)
        return error_set(error, CUPOLA_ERROR_ARGUMENT, "texture %u holds %s; allowed: %s", texture,
                         strange, allowed);
    if (mipmaps && !has_levels(features, target, base, width > height ? width : height))
        return error_set(error, CUPOLA_ERROR_ARGUMENT,
                         "mipmaps is true and texture %u of %d x %d texels lacks levels; allowed: "
                         "all levels (glGenerateMipmap), or false",
                         texture, width, height);
    return CUPOLA_OK;
}

int sampled_check(const struct host_features *features, GLenum target, GLuint texture, bool mipmaps,
                  struct cupola_error *error)
{
    struct host_cube host;
    if (!features->texture_sizes)
        return CUPOLA_OK;
    if (target != GL_TEXTURE_CUBE_MAP)
        return check_bound(features, target, texture, mipmaps, error);
    host_cube_save(&host);
    glBindTexture(target, texture);
    int status = check_bound(features, target, texture, mipmaps, error);
    host_cube_restore(&host);
    return status;
}

int sampled_check_in_frame(const struct guest *guest, GLenum target, GLuint texture, bool mipmaps,
                           struct cupola_error *error)
{
    return guest->leaves_state ? CUPOLA_OK
                               : sampled_check(guest->features, target, texture, mipmaps, error);
}
