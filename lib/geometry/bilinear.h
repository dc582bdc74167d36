/* The weighted mean of four texels: GL_LINEAR, OpenGL 3.3 core section 3.8.11. */
#ifndef BILINEAR_H
#define BILINEAR_H

/* RGBA of lower left, lower right, upper left, upper right; u and v from 0 to 1 between them. */
static inline void bilinear_mix(const float *const corners[4], double u, double v, double color[4])
{
    const double weights[4] = {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v};
    for (int c = 0; c < 4; c++) {
        color[c] = 0;
        for (int k = 0; k < 4; k++)
            color[c] += weights[k] * (double)corners[k][c];
    }
}

#endif
