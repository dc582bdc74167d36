/*
 * Numbers of rig files, exact both ways. All of this expects the C locale.
 *
 * Angles are radians in memory and degrees in files, and a double of degrees cannot name every
 * double of radians: over most of their range the former lie farther apart. So degrees are read
 * and written as long double with as many digits as that takes. With a mantissa of 64 bits or more
 * both conversions together err by less than 2^-61, relatively, and the nearest other double of
 * radians is 2^-53 away: every angle comes back to the last bit. Where long double is no wider
 * than double, about one angle in ten comes back with its last bit changed.
 */
#ifndef RIG_NUMBER_H
#define RIG_NUMBER_H

enum { RIG_NUMBER_SIZE = 64 };

/* text: the number alone, checked by rig_text_open */
double rig_number_real(const char *text);
double rig_number_angle_rad(const char *text_deg);

/* The shortest text from 15 digits on that reads back as the same number; always with a point or
 * an exponent. */
void rig_number_print_real(double value, char text[RIG_NUMBER_SIZE]);
void rig_number_print_angle(double angle_rad, char text_deg[RIG_NUMBER_SIZE]);

#endif
