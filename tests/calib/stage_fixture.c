/* The tool's stage without a window. */
#include "stage_fixture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <epoxy/gl.h>

#include "check.h"
#include "headless.h"

enum { EXIT_SKIPPED = 77 };

static const double RADIANS = 3.14159265358979323846 / 180;

static struct headless *headless;

int stage_context_open(void **state)
{
    static const char too_old[] = "the OpenGL";
    const char *required = getenv("CUPOLA_GPU_REQUIRED");
    char message[MESSAGE_SIZE];

    (void)state;
    headless = headless_create(message, sizeof message);
    if (headless)
        return 0;
    fprintf(stderr, "%s\n", message);
    exit(strncmp(message, too_old, sizeof too_old - 1) == 0 ||
                 (required && strcmp(required, "1") == 0)
             ? EXIT_FAILURE
             : EXIT_SKIPPED);
}

int stage_context_close(void **state)
{
    (void)state;
    headless_destroy(headless);
    headless = NULL;
    return 0;
}

void stage_fixture_make(struct stage_fixture *fixture, const struct cupola_rig *rig)
{
    struct marks none = {0};
    char message[MESSAGE_SIZE];
    struct tool *tool = &fixture->tool;

    memset(fixture, 0, sizeof *fixture);
    if (!tool_open(tool, rig, 0, &none, "rig.cfg", NULL, message))
        fail_msg("%s", message);
    tool->shows_legend = tool->shows_labels = tool->shows_help = tool->text_on_dome = false;
    tool->preview = PREVIEW_NONE;
    tool->warning[0] = tool->notice[0] = 0;
    fixture->stage = stage_create(message);
    if (!fixture->stage)
        fail_msg("%s", message);
}

void stage_fixture_release(struct stage_fixture *fixture)
{
    stage_destroy(fixture->stage);
    tool_close(&fixture->tool);
}

static unsigned char *read_bytes(unsigned int framebuffer, int width, int height)
{
    unsigned char *bytes = malloc((size_t)width * (size_t)height * 4);

    assert_non_null(bytes);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    return bytes;
}

unsigned char *stage_fixture_image(struct stage_fixture *fixture)
{
    char message[MESSAGE_SIZE];
    const struct target *image = stage_image(fixture->stage);

    if (!stage_draw(fixture->stage, &fixture->tool, 0, 0, 0, message))
        fail_msg("%s", message);
    return read_bytes(image->framebuffer, image->width, image->height);
}

unsigned char *stage_fixture_frame(struct stage_fixture *fixture, int width, int height)
{
    char message[MESSAGE_SIZE];
    struct target target;
    unsigned char *bytes;

    if (!target_create(&target, width, height, TARGET_BYTES, message, MESSAGE_SIZE) ||
        !stage_draw(fixture->stage, &fixture->tool, target.framebuffer, width, height, message))
        fail_msg("%s", message);
    bytes = read_bytes(target.framebuffer, width, height);
    target_destroy(&target);
    return bytes;
}

static void random_place(uint64_t *seed, double reach, double place[3])
{
    double length2;

    do {
        length2 = 0;
        for (int i = 0; i < 3; i++) {
            place[i] = random_between(seed, -reach, reach);
            length2 += place[i] * place[i];
        }
    } while (length2 > reach * reach);
}

void stage_random_rig(uint64_t *seed, int size, struct cupola_rig *rig)
{
    struct cupola_output *output = &rig->outputs[0];
    struct cupola_error error;

    memset(rig, 0, sizeof *rig);
    rig->screen.radius_m = random_between(seed, 0.5, 8);
    rig->screen.cap_rad = random_between(seed, 80, 130) * RADIANS;
    rig->tilt_rad = random_between(seed, 0, 90) * RADIANS;
    output->width_px = size;
    output->height_px = 3 * size / 4;
    output->circle = (struct cupola_circle){
        .center_x_px = size * random_between(seed, 0.45, 0.55),
        .center_y_px = size * random_between(seed, 0.33, 0.42),
        .radius_px = size * random_between(seed, 0.4, 0.55),
    };
    output->flip = (int)random_between(seed, 0, 3.999);
    output->lens.model = (enum cupola_lens_model)random_between(seed, 0, 3.999);
    output->lens.fov_rad = random_between(seed, 120, 175) * RADIANS;
    output->aim = (struct cupola_aim){random_between(seed, -20, 20) * RADIANS,
                                      random_between(seed, -20, 20) * RADIANS,
                                      random_between(seed, -20, 20) * RADIANS};
    random_place(seed, 0.4 * rig->screen.radius_m, output->position_m);
    random_place(seed, 0.4 * rig->screen.radius_m, rig->eye_m);
    if (cupola_rig_complete(rig, rig, &error) < 0)
        fail_msg("%s", error.message);
}

double stage_light(unsigned char code)
{
    double c = code / 255.0;

    return c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4);
}
