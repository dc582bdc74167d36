/*
 * The noise of photographs, from what sines of four steps and more leave over: its variance as a
 * straight line over the light, the constant part from reading out and the slope from counting.
 */
#ifndef CODE_NOISE_H
#define CODE_NOISE_H

struct code_noise {
    double count, light, light_square, variance, light_variance; /* sums */
    double constant, slope;
};

void code_noise_add(struct code_noise *noise, double light, double variance);

/* The line of least squares, nowhere below 0; the mean where light tells no difference. */
void code_noise_fit(struct code_noise *noise);

/* Standard deviation. */
double code_noise_at(const struct code_noise *noise, double light);

#endif
