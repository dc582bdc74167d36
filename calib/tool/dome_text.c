/* Text on the dome: its textures, where it is in the image, and how it is drawn. */
#include "tool/dome_text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <epoxy/gl.h>

#include <cupola/projection.h>
#include <cupola/text.h>

#include "calib_shaders.h"
#include "option_values.h"
#include "program.h"
#include "rotation.h"

enum { KEPT = 160, TEXELS = 4 /* per unit */, SAMPLES = 5 /* of a rectangle, each way */ };

/* A text's texture. */
struct kept {
    char *text;
    GLuint texture;
    double width, height; /* units */
    unsigned long used;   /* when it was drawn last */
};

struct dome_text {
    GLuint program;
    GLuint vertex_array;
    struct kept kept[KEPT];
    unsigned long now;
};

/* Where a label's plane is: rows right, up, forward in the dome frame, and its rectangle at 1. */
struct plane {
    double axes[9];
    double corner[2];
    double size[2];
};

struct dome_text *dome_text_create(char *message)
{
    struct dome_text *text = calloc(1, sizeof *text);

    if (!text) {
        snprintf(message, MESSAGE_SIZE, "out of memory");
        return NULL;
    }
    text->program = program_create("text on the dome", shader_stage_vert, shader_dome_text_frag,
                                   message, MESSAGE_SIZE);
    if (!text->program) {
        free(text);
        return NULL;
    }
    glGenVertexArrays(1, &text->vertex_array);
    return text;
}

static void forget(struct kept *kept)
{
    glDeleteTextures(1, &kept->texture);
    free(kept->text);
    *kept = (struct kept){0};
}

void dome_text_destroy(struct dome_text *text)
{
    if (!text)
        return;
    for (int i = 0; i < KEPT; i++)
        forget(&text->kept[i]);
    glDeleteVertexArrays(1, &text->vertex_array);
    glDeleteProgram(text->program);
    free(text);
}

void dome_text_size(const char *text, double *width, double *height)
{
    int across = 0, up = 0;

    if (cupola_text_size(text, 1, &across, &up, NULL) < 0)
        across = up = 0;
    *width = across;
    *height = up;
}

static double length_of(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

double dome_pixel_rad(const cupola_dome *dome, int output, const double direction[3])
{
    const struct cupola_circle *circle = &cupola_dome_rig(dome)->outputs[output].circle;
    double pixel[2] = {circle->center_x_px, circle->center_y_px};
    struct cupola_ray ray;

    cupola_dome_pixel(dome, output, NULL, direction, pixel);
    if (cupola_dome_ray(dome, output, NULL, pixel[0], pixel[1], &ray) < 0)
        return 0;
    return fmax(length_of(ray.direction_dx), length_of(ray.direction_dy));
}

void dome_label_anchor(struct dome_label *label, int across, int up)
{
    const double gap = 2;
    double width, height;

    dome_text_size(label->text, &width, &height);
    label->corner[0] = 0.5 * (across - 1) * width + across * gap;
    label->corner[1] = 0.5 * (up - 1) * height + up * gap;
}

/* The alpha of a picture, with all levels, since text is often smaller than its texture. */
static GLuint upload(const unsigned char *rgba, int width, int height)
{
    GLuint texture = 0;
    const GLint swizzle[4] = {GL_ALPHA, GL_ALPHA, GL_ALPHA, GL_ALPHA};

    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, swizzle);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glGenerateMipmap(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

static bool make(struct kept *kept, const char *text)
{
    int width, height;
    unsigned char *rgba;

    if (cupola_text_size(text, TEXELS, &width, &height, NULL) < 0)
        return false;
    rgba = malloc((size_t)width * (size_t)height * 4);
    kept->text = malloc(strlen(text) + 1);
    if (rgba && kept->text && cupola_text_draw(text, TEXELS, rgba, width, height, NULL) >= 0) {
        strcpy(kept->text, text);
        kept->texture = upload(rgba, width, height);
        kept->width = (double)width / TEXELS;
        kept->height = (double)height / TEXELS;
    } else {
        free(kept->text);
        kept->text = NULL;
    }
    free(rgba);
    return kept->text != NULL;
}

/* NULL where a text cannot be drawn. The texture that was not drawn for longest makes room. */
static const struct kept *find(struct dome_text *text, const char *wanted)
{
    struct kept *oldest = &text->kept[0];

    text->now++;
    for (int i = 0; i < KEPT; i++) {
        struct kept *kept = &text->kept[i];
        if (kept->text && strcmp(kept->text, wanted) == 0) {
            kept->used = text->now;
            return kept;
        }
        if (kept->used < oldest->used)
            oldest = kept;
    }
    forget(oldest);
    if (!make(oldest, wanted))
        return NULL;
    oldest->used = text->now;
    return oldest;
}

static void cross(const double a[3], const double b[3], double product[3])
{
    product[0] = a[1] * b[2] - a[2] * b[1];
    product[1] = a[2] * b[0] - a[0] * b[2];
    product[2] = a[0] * b[1] - a[1] * b[0];
}

static bool normalise(double v[3])
{
    double length = length_of(v);

    for (int i = 0; i < 3; i++)
        v[i] /= length;
    return isfinite(length) && length > 0;
}

/* From the host's camera frame to the dome frame: R_x(-tilt). */
static void to_dome(const struct cupola_rig *rig, const double v[3], double dome[3])
{
    double tilt[9];

    rotation_from_tilt(rig->tilt_rad, tilt);
    rotation_apply_back(tilt, v, dome);
}

/* Level as the viewer sees it; straight up or down as if the head had been raised or lowered. */
static bool find_plane(const struct cupola_rig *rig, const struct dome_label *label,
                       const double size[2], struct plane *plane)
{
    const double zenith[3] = {0, 1, 0};
    double forward[3], right[3], up[3];

    memcpy(forward, label->direction, sizeof forward);
    if (!normalise(forward))
        return false;
    cross(forward, zenith, right);
    if (!(right[0] * right[0] + right[2] * right[2] > 1e-12) || !normalise(right))
        memcpy(right, (double[3]){1, 0, 0}, sizeof right);
    cross(right, forward, up);
    to_dome(rig, right, plane->axes);
    to_dome(rig, up, plane->axes + 3);
    to_dome(rig, forward, plane->axes + 6);
    for (int i = 0; i < 2; i++) {
        plane->size[i] = size[i] * label->unit_rad;
        plane->corner[i] = label->corner[i] * label->unit_rad;
    }
    return true;
}

/* The point of the screen that is seen at a place on a plane. */
static void point_at(const struct cupola_rig *rig, const struct plane *plane, double x, double y,
                     double point[3])
{
    double ray[3], along = 0, eye2 = 0, t;

    for (int i = 0; i < 3; i++)
        ray[i] = plane->axes[6 + i] + x * plane->axes[i] + y * plane->axes[3 + i];
    normalise(ray);
    for (int i = 0; i < 3; i++) {
        along += ray[i] * rig->eye_m[i];
        eye2 += rig->eye_m[i] * rig->eye_m[i];
    }
    t = -along + sqrt(along * along - eye2 + rig->screen.radius_m * rig->screen.radius_m);
    for (int i = 0; i < 3; i++)
        point[i] = rig->eye_m[i] + t * ray[i];
}

/* The pixels that can show a plane's rectangle. False: none of the image. */
static bool find_box(const struct cupola_rig *rig, int output, const struct plane *plane,
                     int box[4])
{
    const struct cupola_output *size = &rig->outputs[output];
    double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
    double points_m[3 * SAMPLES * SAMPLES], pixels[2 * SAMPLES * SAMPLES];
    const int most[2] = {size->width_px, size->height_px};

    for (int k = 0; k < SAMPLES * SAMPLES; k++) {
        double across = (double)(k % SAMPLES) / (SAMPLES - 1);
        double up = (double)(k / SAMPLES) / (SAMPLES - 1);
        point_at(rig, plane, plane->corner[0] + across * plane->size[0],
                 plane->corner[1] + up * plane->size[1], points_m + 3 * k);
    }
    if (cupola_output_pixels(size, SAMPLES * SAMPLES, points_m, pixels, NULL) < 0)
        return false;
    for (int k = 0; k < 2 * SAMPLES * SAMPLES; k++) {
        low[k % 2] = fmin(low[k % 2], pixels[k]);
        high[k % 2] = fmax(high[k % 2], pixels[k]);
    }
    for (int i = 0; i < 2; i++) {
        /* Edges are curved between the samples. */
        double more = 2 + 0.06 * fmax(high[0] - low[0], high[1] - low[1]);
        double first = fmax(floor(low[i] - more), 0), end = fmin(ceil(high[i] + more), most[i]);
        if (!(first < end))
            return false;
        box[i] = (int)first;
        box[2 + i] = (int)(end - first);
    }
    return true;
}

bool dome_label_box(const struct cupola_rig *rig, int output, const struct dome_label *label,
                    int box[4])
{
    double size[2] = {label->size[0], label->size[1]};
    struct plane plane;

    if (label->text)
        dome_text_size(label->text, &size[0], &size[1]);
    return find_plane(rig, label, size, &plane) && find_box(rig, output, &plane, box);
}

static GLint place(GLuint program, const char *name)
{
    return glGetUniformLocation(program, name);
}

static void set_uniforms(GLuint program, const struct cupola_rig *rig, const struct plane *plane,
                         const struct dome_label *label)
{
    float axes[9];

    for (int i = 0; i < 9; i++)
        axes[i] = (float)plane->axes[i];
    glUniformMatrix3fv(place(program, "axes"), 1, GL_TRUE, axes);
    glUniform3f(place(program, "eye_m"), (float)rig->eye_m[0], (float)rig->eye_m[1],
                (float)rig->eye_m[2]);
    glUniform4f(place(program, "place"), (float)plane->corner[0], (float)plane->corner[1],
                (float)plane->size[0], (float)plane->size[1]);
    glUniform3fv(place(program, "ink"), 1, label->ink);
    glUniform1f(place(program, "ground"), label->ground);
    glUniform1i(place(program, "text"), 1);
}

static void draw_box(const struct dome_text *text, GLuint points, GLuint letters, const int box[4])
{
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, letters);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, points);
    glEnable(GL_SCISSOR_TEST);
    glScissor(box[0], box[1], box[2], box[3]);
    glBindVertexArray(text->vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glDisable(GL_SCISSOR_TEST);
}

void dome_text_draw(struct dome_text *text, const struct cupola_rig *rig, int output,
                    unsigned int points, const struct dome_label *label)
{
    const char *letters = label->text ? label->text : " ";
    const struct kept *kept = *letters ? find(text, letters) : NULL;
    struct plane plane;
    double size[2];
    int box[4];

    if (!kept)
        return;
    size[0] = label->text ? kept->width : label->size[0];
    size[1] = label->text ? kept->height : label->size[1];
    if (!find_plane(rig, label, size, &plane) || !find_box(rig, output, &plane, box))
        return;
    glUseProgram(text->program);
    set_uniforms(text->program, rig, &plane, label);
    draw_box(text, points, kept->texture, box);
    glUseProgram(0);
}
