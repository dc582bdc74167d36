/* The simulated theatre beside the image. */
#include "tool/preview.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <epoxy/gl.h>

#include <cupola/theatre.h>

#include "tool/stickers.h"

static const double EYE_FOV_RAD = 1.6; /* wide, but not so wide that the corners are drawn out */

struct preview_room {
    struct cupola_rig rig; /* of the theatre */
    cupola_dome *dome;     /* NULL: nothing was drawn so far */
    cupola_theatre *theatre;
    unsigned int black[CUPOLA_OUTPUTS_MAX]; /* what projectors throw that the tool does not know */
    struct stickers *stickers;
};

struct preview_room *preview_create(char *message)
{
    struct preview_room *preview = calloc(1, sizeof *preview);

    if (!preview) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return NULL;
    }
    preview->stickers = stickers_create(message);
    if (preview->stickers)
        return preview;
    free(preview);
    return NULL;
}

static void clear(struct preview_room *preview)
{
    cupola_theatre_destroy(&preview->theatre);
    cupola_dome_destroy(&preview->dome);
    glDeleteTextures(CUPOLA_OUTPUTS_MAX, preview->black);
    memset(preview->black, 0, sizeof preview->black);
}

void preview_destroy(struct preview_room *preview)
{
    if (!preview)
        return;
    clear(preview);
    stickers_destroy(preview->stickers);
    free(preview);
}

static bool make_black(struct preview_room *preview, int output, char *message)
{
    const struct cupola_output *size = &preview->rig.outputs[output];
    unsigned char *texels = calloc((size_t)size->width_px * (size_t)size->height_px, 1);

    if (!texels) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return false;
    }
    glGenTextures(1, &preview->black[output]);
    glBindTexture(GL_TEXTURE_2D, preview->black[output]);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, size->width_px, size->height_px, 0, GL_RED,
                 GL_UNSIGNED_BYTE, texels);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glBindTexture(GL_TEXTURE_2D, 0);
    free(texels);
    return true;
}

static bool build(struct preview_room *preview, const struct cupola_rig *rig, int known,
                  char *message)
{
    struct cupola_error error = {0};

    if (preview->theatre && memcmp(rig, &preview->rig, sizeof *rig) == 0)
        return true;
    clear(preview);
    preview->rig = *rig;
    if (cupola_dome_create(rig, &preview->dome, &error) < 0 ||
        cupola_theatre_create(preview->dome, &preview->theatre, &error) < 0) {
        snprintf(message, MESSAGE_SIZE, "preview: %s", error.message);
        return false;
    }
    for (int i = known; i < rig->output_count; i++)
        if (!make_black(preview, i, message))
            return false;
    return true;
}

/* The theatre as it stands there, its projectors with images as large as those that are made. */
static bool find_rig(const struct tool *tool, struct cupola_rig *rig, char *message)
{
    struct cupola_error error = {0};

    *rig = tool->theatre;
    for (int i = 0; i < rig->output_count && i < tool->rig.output_count; i++) {
        const struct cupola_output *made = &tool->rig.outputs[i];
        struct cupola_output *output = &rig->outputs[i];
        if (output->width_px == made->width_px && output->height_px == made->height_px)
            continue;
        if (cupola_output_resize(output, made->width_px, made->height_px, &error) < 0) {
            snprintf(message, MESSAGE_SIZE, "preview: %s", error.message);
            return false;
        }
    }
    return true;
}

bool preview_draw(struct preview_room *preview, const struct tool *tool,
                  const unsigned int made[CUPOLA_OUTPUTS_MAX], unsigned int framebuffer,
                  const int rectangle[4], char *message)
{
    struct cupola_error error = {0};
    struct cupola_spectator spectator;
    struct cupola_rig rig;
    struct cupola_target target = {
        .framebuffer = framebuffer, .x = rectangle[0], .y = rectangle[1]};
    unsigned int images[CUPOLA_OUTPUTS_MAX];

    if (!find_rig(tool, &rig, message) || !build(preview, &rig, tool->rig.output_count, message))
        return false;
    for (int i = 0; i < CUPOLA_OUTPUTS_MAX; i++)
        images[i] = i < tool->rig.output_count ? made[i] : preview->black[i];
    if (tool->preview == PREVIEW_OUTSIDE) {
        cupola_spectator_outside(preview->dome, &spectator);
    } else {
        cupola_spectator_at_eye(preview->dome, &spectator);
        spectator.fov_rad = EYE_FOV_RAD;
        tool_live_eye(tool, rig.screen.radius_m, spectator.position_m);
    }
    spectator.encoding = CUPOLA_ENCODING_SRGB;
    for (int i = 0; i < 3; i++)
        spectator.ambient_rgb[i] = 0.006f; /* what is not lit is seen, too */
    if (cupola_theatre_draw(preview->theatre, images, &spectator, rectangle[2], rectangle[3],
                            &target, &error) < 0) {
        snprintf(message, MESSAGE_SIZE, "preview: %s", error.message);
        return false;
    }
    if (tool->group == GROUP_MARKS && tool->preview == PREVIEW_EYE)
        stickers_draw(preview->stickers, tool, &spectator, framebuffer, rectangle);
    return true;
}
