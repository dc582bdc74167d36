/* Whether photographs can be those of a series. */
#include "capture/code_check.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "option_values.h"
#include "short_path.h"

/* Stripes and their inverse add up to all light and none, but for noise and flicker. */
static const double most_mismatch = 0.25;
/* Code and phase disagree at some borders, and everywhere where a bit is of another picture. */
static const double most_disagreement = 0.5;
/* A sine that is of another picture counts as noise of a third of the contrast. */
static const double most_noise = 0.15, much_noise = 0.05;
static const double many_lost = 0.25;
/* Fewer pixels than this give no marks worth a word, and chance may say anything of them. */
static const double least_pixels = 200;
/* Of what is lit; below, blur may be why something is wrong. */
static const double mostly_clear = 0.5;
static const double least_agreement = 0.5;
/* Noise is as often darker as brighter: from this part of the light on it explains the rest. */
static const double much_darker = 0.1, mostly_darker = 0.5;

void code_check_begin_pair(struct code_check *check)
{
    check->contrast = check->mismatch = 0;
}

void code_check_begin_axis(struct code_check *check)
{
    check->contrast_square = check->variance = check->judged = check->tested = check->off = 0;
    check->phase = (struct code_phase){0};
}

void code_check_add_light(struct code_check *check, double contrast, bool lit)
{
    check->lit += lit;
    check->brighter += lit ? contrast : 0;
    check->darker += contrast <= -check->least_contrast ? -contrast : 0;
}

/* Where it is darker by far white and black are exchanged. */
static bool has_noise(const struct code_check *check, double part)
{
    return check->darker > part * check->brighter && check->darker < 2 * check->brighter;
}

bool code_check_is_noise(const struct code_check *check)
{
    return has_noise(check, mostly_darker);
}

bool code_check_pair(const struct code_check *check, const char *code, const char *inverse,
                     char *message)
{
    if (check->mismatch <= most_mismatch * check->contrast || check->lit < least_pixels)
        return true;
    if (has_noise(check, much_darker)) {
        snprintf(message, MESSAGE_SIZE,
                 "noise of the photographs passes for light: where all light and none differ by "
                 "--contrast or more, %.0f %% is darker under all light; allowed: up to %.0f %%; "
                 "give a higher --contrast, expose longer or take more --shots",
                 100 * check->darker / (check->darker + check->brighter),
                 100 * much_darker / (1 + much_darker));
        return false;
    }
    snprintf(message, MESSAGE_SIZE,
             "%s and %s do not show stripes and their inverse: together they are off by %.0f %% of "
             "all light; allowed: up to %.0f %%; look at the order of the photographs and at these "
             "two, and where it is noise expose longer or take more --shots",
             short_path(code).text, short_path(inverse).text,
             100 * check->mismatch / check->contrast, 100 * most_mismatch);
    return false;
}

static bool is_mostly_clear(const struct code_check *check)
{
    return check->tested >= mostly_clear * check->lit;
}

/* What is to be looked at first and what else, where blur explains it as well. */
static void add_advice(const struct code_check *check, bool order_first, const char *order,
                       char *message)
{
    size_t length = strlen(message);
    char blur[200];

    snprintf(blur, sizeof blur,
             "of what is lit %.0f %% shows clear stripes and sines, usual is from %.0f %% on; look "
             "at the focus, expose less where it is saturated, or take a longer --period",
             100 * check->tested / check->lit, 100 * mostly_clear);
    if (is_mostly_clear(check))
        snprintf(message + length, MESSAGE_SIZE - length,
                 "; look at the order of these photographs, %s may be exchanged", order);
    else if (order_first)
        snprintf(message + length, MESSAGE_SIZE - length,
                 "; look at the order of these photographs, %s may be exchanged; or it is blur: %s",
                 order, blur);
    else
        snprintf(message + length, MESSAGE_SIZE - length,
                 "; it may be blur: %s; or %s are "
                 "exchanged",
                 blur, order);
}

/*
 * Sines in an order that is turned round or begins elsewhere are sines, too, and may even agree
 * with the stripes, each of them mirrored in itself. At the stripes' borders their phase tells: a
 * wrong one is off by a step at least. Where little is clear it is of places where light falls off
 * or is cut off: a few borders may all be off by that.
 */
static bool check_borders(const struct code_check *check, int axis, int steps, char *message)
{
    const double degrees = 180 / 3.14159265358979323846, least_allowed = 20;
    const int many_borders = 4;
    double allowed = fmax(180.0 / steps, least_allowed);
    double off = degrees * fabs(check->phase.off_rad);

    if (check->phase.borders == 0 || check->phase.agreement < least_agreement || off <= allowed)
        return true;
    snprintf(message, MESSAGE_SIZE,
             "the sines of %c do not lie as their stripes do: their phase is off by %.0f degrees; "
             "allowed: up to %.0f",
             axis ? 'y' : 'x', off, allowed);
    add_advice(check, check->phase.borders >= many_borders, "two sines", message);
    return false;
}

bool code_check_axis(struct code_check *check, int axis, int steps, char *message)
{
    double noise = sqrt(fmax(check->variance, 0) / fmax(check->contrast_square, 1e-30));

    check->noise[axis] = noise;
    if (!(noise <= most_noise) && check->judged >= least_pixels) {
        snprintf(message, MESSAGE_SIZE,
                 "the sines of %c do not follow each other: what is left over is %.0f %% of the "
                 "contrast; allowed: up to %.0f %%; look at the order of these photographs and at "
                 "each of them, and where it is noise expose longer or take more --shots",
                 axis ? 'y' : 'x', 100 * noise, 100 * most_noise);
        return false;
    }
    if (check->tested < least_pixels)
        return true;
    if (check->off <= most_disagreement * check->tested)
        return check_borders(check, axis, steps, message);
    snprintf(message, MESSAGE_SIZE,
             "stripes and sines of %c disagree at %.0f %% of what shows both; allowed: up to "
             "%.0f %%",
             axis ? 'y' : 'x', 100 * check->off / check->tested, 100 * most_disagreement);
    add_advice(check, true, "a picture and its inverse", message);
    return false;
}

void code_check_warning(const struct code_check *check, double lit, double lost, char *text,
                        size_t text_size)
{
    double noise = fmax(check->noise[0], check->noise[1]);

    *text = 0;
    if (noise > much_noise)
        snprintf(text, text_size,
                 "the noise is %.0f %% of the contrast, usual is up to %.0f %%; look at each "
                 "photograph, expose longer, darken the room, or take more --shots",
                 100 * noise, 100 * much_noise);
    else if (lost > many_lost * lit)
        snprintf(text, text_size,
                 "%.0f %% of what is lit has no sure place, usual is up to %.0f %%; look at each "
                 "photograph and at its focus, or take a longer --period",
                 100 * lost / lit, 100 * many_lost);
}
