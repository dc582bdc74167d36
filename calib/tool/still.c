/* Pictures of what the tool shows, without a window. */
#include "tool/still.h"

#include <stdio.h>
#include <stdlib.h>

#include <epoxy/gl.h>

#include "headless.h"
#include "output_file.h"
#include "target.h"
#include "tool/stage.h"

struct still {
    struct headless *headless;
    struct stage *stage;
    struct target target; /* a window's size; all zero: none was wanted so far */
};

struct still *still_create(char *message)
{
    struct still *still = calloc(1, sizeof *still);

    if (!still) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return NULL;
    }
    still->headless = headless_create(message, MESSAGE_SIZE);
    still->stage = still->headless ? stage_create(message) : NULL;
    if (still->stage)
        return still;
    still_destroy(still);
    return NULL;
}

void still_destroy(struct still *still)
{
    if (!still)
        return;
    if (still->target.framebuffer)
        target_destroy(&still->target);
    stage_destroy(still->stage);
    headless_destroy(still->headless);
    free(still);
}

static bool size_target(struct still *still, int width, int height, char *message)
{
    if (still->target.framebuffer && still->target.width == width && still->target.height == height)
        return true;
    if (still->target.framebuffer)
        target_destroy(&still->target);
    return target_create(&still->target, width, height, TARGET_BYTES, message, MESSAGE_SIZE);
}

/* The target of this size, or the stage's own for 0 x 0; NULL on failure. */
static const struct target *draw(struct still *still, const struct tool *tool, int width,
                                 int height, char *message)
{
    bool alone = width < 1 || height < 1;
    bool drawn = (alone || size_target(still, width, height, message)) &&
                 stage_draw(still->stage, tool, still->target.framebuffer, alone ? 0 : width,
                            alone ? 0 : height, message);

    if (!drawn)
        return NULL;
    return alone ? stage_image(still->stage) : &still->target;
}

bool still_draw(struct still *still, const struct tool *tool, int width, int height, char *message)
{
    return draw(still, tool, width, height, message) != NULL;
}

bool still_write(struct still *still, const struct tool *tool, int width, int height,
                 const char *path, char *message)
{
    const struct target *shown = draw(still, tool, width, height, message);

    return shown &&
           output_file_capture(path, shown->framebuffer, shown->width, shown->height, message);
}
