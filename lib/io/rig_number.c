/* Numbers of rig files, exact both ways. */
#include "rig_number.h"

#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const long double rad_per_deg = 3.14159265358979323846264338327950288L / 180;

double rig_number_real(const char *text)
{
    return strtod(text, NULL);
}

double rig_number_angle_rad(const char *text_deg)
{
    return (double)(strtold(text_deg, NULL) * rad_per_deg);
}

/* So that people see a number that need not be whole. */
static void add_point(char text[RIG_NUMBER_SIZE])
{
    if (!strpbrk(text, ".e"))
        strcat(text, ".0");
}

void rig_number_print_real(double value, char text[RIG_NUMBER_SIZE])
{
    for (int digits = DBL_DIG; digits <= DBL_DECIMAL_DIG; digits++) {
        snprintf(text, RIG_NUMBER_SIZE - 2, "%.*g", digits, value);
        if (rig_number_real(text) == value)
            break;
    }
    add_point(text);
}

void rig_number_print_angle(double angle_rad, char text_deg[RIG_NUMBER_SIZE])
{
    for (int digits = DBL_DIG; digits <= LDBL_DECIMAL_DIG; digits++) {
        snprintf(text_deg, RIG_NUMBER_SIZE - 2, "%.*Lg", digits,
                 (long double)angle_rad / rad_per_deg);
        if (rig_number_angle_rad(text_deg) == angle_rad)
            break;
    }
    add_point(text_deg);
}
