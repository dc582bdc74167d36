/* Pictures that are each the mean of many frames. */
#include "reference.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "interruption.h"
#include "output_file.h"
#include "progress.h"
#include "reference_settings.h"
#include "reference_state.h"
#include "short_path.h"

/* Between two states on disk pass a second and so much more than one takes. */
static const double least_pause_ms = 1000, pause_per_ms = 20;

struct reference {
    struct reference_state state;
    char path[PATH_MAX]; /* of the state */
    long pictures;
    int frames; /* of each */
    struct target target;
    bool encoded;
    float *frame; /* one frame, and then the mean */
    double saved_ms, pause_ms;
    struct progress progress;
};

static size_t numbers(const struct reference *reference)
{
    return 4 * (size_t)reference->target.width * (size_t)reference->target.height;
}

/* Where it goes on, unless that is the beginning. */
static void tell(const struct reference *reference)
{
    const struct reference_state *state = &reference->state;

    if (state->picture == 0 && state->frames == 0)
        return;
    fprintf(stderr, "cupola-demo: --reference goes on after ");
    if (reference->pictures > 1)
        fprintf(stderr, "%ld of %ld pictures and ", (long)state->picture, reference->pictures);
    fprintf(stderr, "%ld of %d frames\n", (long)state->frames, reference->frames);
}

static bool load(struct reference *reference, char *message)
{
    struct reference_state *state = &reference->state;

    if (!reference_state_read(reference->path, state, message))
        return false;
    if (state->picture < reference->pictures && state->frames <= reference->frames)
        return true;
    snprintf(message, MESSAGE_SIZE, "--reference: %s is damaged; remove it to begin anew",
             short_path(reference->path).text);
    return false;
}

struct reference *reference_create(const struct options *options, const char *output, long pictures,
                                   const struct world *world, const struct target *target,
                                   bool encoded, char *message)
{
    struct reference *reference = calloc(1, sizeof *reference);

    if (!reference) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return NULL;
    }
    reference->pictures = pictures;
    reference->frames = options->reference;
    reference->target = *target;
    reference->encoded = encoded;
    reference->state.width = target->width;
    reference->state.height = target->height;
    reference->state.sum = calloc(numbers(reference), sizeof *reference->state.sum);
    reference->frame = malloc(numbers(reference) * sizeof *reference->frame);
    if (!reference->state.sum || !reference->frame)
        snprintf(message, MESSAGE_SIZE, "--reference: out of memory for %d x %d pixels",
                 target->width, target->height);
    else if (snprintf(reference->path, PATH_MAX, "%s.part", output) >= PATH_MAX - 4)
        snprintf(message, MESSAGE_SIZE, "--output makes too long a name");
    else if (reference_settings(options, world, &reference->state, message) &&
             output_file_check("--reference", reference->path, message) &&
             load(reference, message)) {
        tell(reference);
        interruption_expect();
        progress_begin(&reference->progress,
                       (long)reference->state.picture * reference->frames +
                           (long)reference->state.frames,
                       pictures * reference->frames);
        return reference;
    }
    reference_destroy(reference);
    return NULL;
}

void reference_destroy(struct reference *reference)
{
    if (!reference)
        return;
    progress_end(&reference->progress);
    free(reference->state.sum);
    free(reference->frame);
    free(reference);
}

long reference_first(const struct reference *reference)
{
    return (long)reference->state.picture;
}

static bool save(struct reference *reference, char *message)
{
    double start_ms = now_ms();
    bool saved = reference_state_write(reference->path, &reference->state, message);

    reference->saved_ms = now_ms();
    reference->pause_ms = fmax(least_pause_ms, pause_per_ms * (reference->saved_ms - start_ms));
    return saved;
}

/* The first frame's, too: what cannot be written is better known soon. */
static bool save_if_due(struct reference *reference, char *message)
{
    bool due = now_ms() >= reference->saved_ms + reference->pause_ms;

    return !due || save(reference, message);
}

static bool add_frame(struct reference *reference, struct show *show,
                      const struct show_frame *frame, char *message)
{
    struct show_frame mine = *frame;
    struct show_jitter jitter;
    struct cupola_error error = {0};
    const struct cupola_target target = {.framebuffer = reference->target.framebuffer};

    cupola_jitter_place((int)reference->state.frames, jitter.texels, jitter.pixels);
    mine.jitter = &jitter;
    if (!show_draw(show, &mine, message))
        return false;
    if (cupola_gl_capture(&target, reference->target.width, reference->target.height,
                          reference->frame, &error) < 0) {
        snprintf(message, MESSAGE_SIZE, "%s", error.message);
        return false;
    }
    for (size_t i = 0; i < numbers(reference); i++)
        reference->state.sum[i] += (double)reference->frame[i];
    reference->state.frames++;
    return true;
}

/* As IEC 61966-2-1 has it. */
static float srgb_encoded(float light)
{
    if (!(light > 0.0031308f))
        return 12.92f * light;
    return 1.055f * powf(light, 1 / 2.4f) - 0.055f;
}

static bool write_mean(struct reference *reference, const char *path, char *message)
{
    for (size_t i = 0; i < numbers(reference); i++) {
        float mean = (float)(reference->state.sum[i] / reference->frames);
        reference->frame[i] = reference->encoded && i % 4 != 3 ? srgb_encoded(mean) : mean;
    }
    return output_file_write(path, reference->frame, reference->target.width,
                             reference->target.height, message);
}

/* The next picture, of which there is nothing yet; after the last one nothing is to be kept. */
static bool go_on(struct reference *reference, char *message)
{
    reference->state.picture++;
    reference->state.frames = 0;
    memset(reference->state.sum, 0, numbers(reference) * sizeof *reference->state.sum);
    if (reference->state.picture < reference->pictures)
        return save(reference, message);
    unlink(reference->path);
    return true;
}

static int interrupt(struct reference *reference, char *message)
{
    if (!save(reference, message))
        return STATUS_FAILED;
    snprintf(message, MESSAGE_SIZE,
             "interrupted after %ld of %d frames%s, which %s holds; the same command goes on",
             (long)reference->state.frames, reference->frames,
             reference->pictures > 1 ? " of a picture" : "", short_path(reference->path).text);
    return STATUS_INTERRUPTED;
}

int reference_draw(struct reference *reference, struct show *show, const struct show_frame *frame,
                   long picture, const char *path, char *message)
{
    while (reference->state.frames < reference->frames) {
        if (interruption_asked())
            return interrupt(reference, message);
        if (!add_frame(reference, show, frame, message) || !save_if_due(reference, message))
            return STATUS_FAILED;
        progress_show(&reference->progress,
                      picture * reference->frames + (long)reference->state.frames);
    }
    return write_mean(reference, path, message) && go_on(reference, message) ? STATUS_OK
                                                                             : STATUS_FAILED;
}
