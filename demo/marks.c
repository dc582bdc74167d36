/* Labels and cursors on the dome. */
#include "marks.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cupola/text.h>
#include <epoxy/gl.h>

/* Texels per unit of a letter: enough for a label that fills the dome. */
enum { TEXT_SCALE = 8 };

static const double RADIANS = 3.14159265358979323846 / 180;
static const double LABEL_HEIGHT_DEG = 4, CURSOR_WIDTH_DEG = 3;

static bool value_place(const struct value_context *context, const char *text, const char *shape,
                        int most, struct mark *mark)
{
    double numbers[3] = {0};

    if (!value_numbers(context, text, shape, (struct number_range){-360, 360, .degrees = true}, 2,
                       most, numbers))
        return false;
    mark->yaw_rad = numbers[0];
    mark->pitch_rad = numbers[1];
    mark->height_rad = numbers[2];
    return true;
}

/* Of UTF-8: bytes from 0x80 to 0xBF go on with a character. */
static int count_characters(const char *text, size_t length)
{
    int count = 0;

    for (size_t i = 0; i < length; i++)
        count += ((unsigned char)text[i] >> 6) != 2;
    return count;
}

bool value_label(const struct value_context *context, const char *text, struct mark *mark)
{
    const char *at = strrchr(text, '@');
    size_t length = at ? (size_t)(at - text) : 0;
    int characters = count_characters(text, length);

    if (characters < 1 || characters > MARK_TEXT_MAX || length > MARK_BYTES_MAX) {
        snprintf(context->message, MESSAGE_SIZE,
                 "%s: '%.200s' is not allowed; allowed: TEXT@YAW,PITCH[,HEIGHT] with a TEXT of 1 "
                 "to %d characters",
                 context->option, text, MARK_TEXT_MAX);
        return false;
    }
    if (!value_place(context, at + 1, "YAW,PITCH[,HEIGHT] after the @", 3, mark))
        return false;
    memcpy(mark->text, text, length);
    mark->text[length] = 0;
    if (mark->height_rad == 0 && !strchr(strchr(at, ',') + 1, ','))
        mark->height_rad = LABEL_HEIGHT_DEG * RADIANS;
    if (mark->height_rad > 0 && mark->height_rad <= 90 * RADIANS)
        return true;
    snprintf(context->message, MESSAGE_SIZE,
             "%s: the height in '%.200s' is not allowed; allowed: above 0 and up to 90",
             context->option, text);
    return false;
}

bool value_cursor(const struct value_context *context, const char *text, struct mark *mark)
{
    mark->text[0] = 0;
    return value_place(context, text, "YAW,PITCH", 2, mark);
}

static void look_along(double yaw_rad, double pitch_rad, double direction[3])
{
    direction[0] = -sin(yaw_rad) * cos(pitch_rad);
    direction[1] = sin(pitch_rad);
    direction[2] = -cos(yaw_rad) * cos(pitch_rad);
}

struct cupola_overlay mark_cursor(const double direction[3])
{
    static const float amber[4] = {1, 0.8f, 0.1f, 1};
    struct cupola_overlay cursor = {
        .kind = CUPOLA_OVERLAY_CURSOR, .width_rad = CURSOR_WIDTH_DEG * RADIANS, .color = amber};

    memcpy(cursor.direction, direction, sizeof cursor.direction);
    return cursor;
}

static GLuint text_texture(const char *text, int *width, int *height, char *message)
{
    struct cupola_error error = {0};
    unsigned char *rgba = NULL;
    GLuint texture = 0;

    if (cupola_text_size(text, TEXT_SCALE, width, height, &error) < 0) {
        snprintf(message, MESSAGE_SIZE, "--label: %s", error.message);
        return 0;
    }
    rgba = malloc(4 * (size_t)*width * (size_t)*height);
    if (!rgba || cupola_text_draw(text, TEXT_SCALE, rgba, *width, *height, &error) < 0) {
        snprintf(message, MESSAGE_SIZE, "--label: %s", rgba ? error.message : "out of memory");
        free(rgba);
        return 0;
    }
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, *width, *height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    glGenerateMipmap(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, 0);
    free(rgba);
    return texture;
}

static bool make_label(const struct mark *mark, struct cupola_overlay *label, char *message)
{
    int width, height;

    *label = (struct cupola_overlay){
        .kind = CUPOLA_OVERLAY_PICTURE, .height_rad = mark->height_rad, .mipmaps = true};
    look_along(mark->yaw_rad, mark->pitch_rad, label->direction);
    label->texture = text_texture(mark->text, &width, &height, message);
    if (!label->texture)
        return false;
    label->width_rad = 2 * atan(tan(mark->height_rad / 2) * width / height);
    if (label->width_rad <= 150 * RADIANS)
        return true;
    snprintf(message, MESSAGE_SIZE,
             "--label: '%s' is %g degrees wide; allowed: up to 150, with a shorter text or less "
             "height",
             mark->text, label->width_rad / RADIANS);
    return false;
}

bool marks_create(struct marks *marks, const struct mark *wished, int count, char *message)
{
    for (int i = 0; i < count; i++) {
        struct cupola_overlay *overlay = &marks->overlays[marks->count++];
        double direction[3];

        look_along(wished[i].yaw_rad, wished[i].pitch_rad, direction);
        if (!wished[i].text[0])
            *overlay = mark_cursor(direction);
        else if (!make_label(&wished[i], overlay, message))
            return false;
    }
    return true;
}

void marks_destroy(struct marks *marks)
{
    for (int i = 0; i < marks->count; i++)
        glDeleteTextures(1, &marks->overlays[i].texture);
    marks->count = 0;
}
