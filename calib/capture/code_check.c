/* Whether photographs can be those of a series. */
#include "capture/code_check.h"

#include <math.h>
#include <stdio.h>

#include "option_values.h"
#include "short_path.h"

/* Stripes and their inverse add up to all light and none, but for noise and flicker. */
static const double most_mismatch = 0.25;
/* Code and phase disagree at some borders, and everywhere where a bit is of another picture. */
static const double most_disagreement = 0.5;
/* A sine that is of another picture counts as noise of a third of the contrast. */
static const double most_noise = 0.15, much_noise = 0.05;
static const double many_lost = 0.25;
/* From so many borders on that agree so well with each other they tell where the sines begin. */
static const double least_borders = 16, least_agreement = 0.5;

void code_check_begin_pair(struct code_check *check)
{
    check->contrast = check->mismatch = 0;
}

void code_check_begin_axis(struct code_check *check)
{
    check->contrast_square = check->variance = check->tested = check->off = 0;
    check->border[0] = check->border[1] = check->borders = 0;
}

void code_check_add_border(struct code_check *check, unsigned int border, double cosine,
                           double sine)
{
    double length = hypot(cosine, sine) * (border % 2 ? -1 : 1); /* stripes are half periods */

    if (!(fabs(length) > 0))
        return;
    check->border[0] += cosine / length;
    check->border[1] += sine / length;
    check->borders++;
}

bool code_check_pair(const struct code_check *check, const char *code, const char *inverse,
                     char *message)
{
    if (check->mismatch <= most_mismatch * check->contrast)
        return true;
    snprintf(message, MESSAGE_SIZE,
             "%s and %s do not show stripes and their inverse: together they are off by %.0f %% of "
             "all light; allowed: up to %.0f %%; look at the order of the photographs and at these "
             "two",
             short_path(code).text, short_path(inverse).text,
             100 * check->mismatch / check->contrast, 100 * most_mismatch);
    return false;
}

/*
 * Sines in an order that is turned round or begins elsewhere are sines, too, and may even agree
 * with the stripes, each of them mirrored in itself. At the stripes' borders their phase tells: a
 * wrong one is off by a step at least.
 */
static bool check_borders(const struct code_check *check, int axis, int steps, char *message)
{
    const double degrees = 180 / 3.14159265358979323846, least_allowed = 20;
    double allowed = fmax(180.0 / steps, least_allowed);
    double off = degrees * fabs(atan2(check->border[1], check->border[0]));

    if (check->borders < least_borders ||
        hypot(check->border[0], check->border[1]) < least_agreement * check->borders ||
        off <= allowed)
        return true;
    snprintf(message, MESSAGE_SIZE,
             "the sines of %c do not lie as their stripes do: their phase is off by %.0f degrees; "
             "allowed: up to %.0f; look at the order of these photographs, two sines may be "
             "exchanged",
             axis ? 'y' : 'x', off, allowed);
    return false;
}

bool code_check_axis(struct code_check *check, int axis, int steps, char *message)
{
    double noise = sqrt(fmax(check->variance, 0) / fmax(check->contrast_square, 1e-30));

    check->noise[axis] = noise;
    if (!(noise <= most_noise)) {
        snprintf(message, MESSAGE_SIZE,
                 "the sines of %c do not follow each other: what is left over is %.0f %% of the "
                 "contrast; allowed: up to %.0f %%; look at the order of these photographs and at "
                 "each of them, and where it is noise expose longer or take more --shots",
                 axis ? 'y' : 'x', 100 * noise, 100 * most_noise);
        return false;
    }
    if (check->off <= most_disagreement * check->tested)
        return check_borders(check, axis, steps, message);
    snprintf(message, MESSAGE_SIZE,
             "stripes and sines of %c disagree at %.0f %% of what is lit; allowed: up to %.0f %%; "
             "look at the order of these photographs, a picture and its inverse may be exchanged",
             axis ? 'y' : 'x', 100 * check->off / check->tested, 100 * most_disagreement);
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
