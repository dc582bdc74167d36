/* Vectors of three doubles and 3x3 matrices (row-major), as small as the geometry needs them. */
#ifndef VECTOR_H
#define VECTOR_H

#include <math.h>
#include <string.h>

static inline double dot3(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void cross3(const double a[3], const double b[3], double product[3])
{
    double c[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    memcpy(product, c, sizeof c);
}

static inline double length3(const double a[3])
{
    return sqrt(dot3(a, a));
}

static inline void scale3(double a[3], double factor)
{
    for (int i = 0; i < 3; i++)
        a[i] *= factor;
}

/* matrix times vector; result may be the vector itself */
static inline void transform3(const double m[9], const double v[3], double result[3])
{
    double r[3] = {dot3(m, v), dot3(m + 3, v), dot3(m + 6, v)};
    memcpy(result, r, sizeof r);
}

/* transposed matrix times vector: the inverse of a rotation */
static inline void transform3_back(const double m[9], const double v[3], double result[3])
{
    double r[3];
    for (int i = 0; i < 3; i++)
        r[i] = m[i] * v[0] + m[3 + i] * v[1] + m[6 + i] * v[2];
    memcpy(result, r, sizeof r);
}

static inline void multiply3(const double a[9], const double b[9], double product[9])
{
    double p[9];
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++)
            p[3 * row + column] = a[3 * row] * b[column] + a[3 * row + 1] * b[3 + column] +
                                  a[3 * row + 2] * b[6 + column];
    memcpy(product, p, sizeof p);
}

/* Of column-major 4x4 matrices, unlike those above; the product is neither of them. */
static inline void multiply4(const double a[16], const double b[16], double product[16])
{
    for (int column = 0; column < 4; column++)
        for (int row = 0; row < 4; row++) {
            double sum = 0;
            for (int i = 0; i < 4; i++)
                sum += a[4 * i + row] * b[4 * column + i];
            product[4 * column + row] = sum;
        }
}

static inline void transpose3(const double m[9], double transposed[9])
{
    double t[9] = {m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]};
    memcpy(transposed, t, sizeof t);
}

/* By cofactors; of a matrix that has an inverse. */
static inline void invert3(const double m[9], double inverse[9])
{
    double columns[9], determinant;
    cross3(m + 3, m + 6, columns);
    cross3(m + 6, m, columns + 3);
    cross3(m, m + 3, columns + 6);
    determinant = dot3(m, columns);
    for (int i = 0; i < 9; i++)
        inverse[i] = columns[3 * (i % 3) + i / 3] / determinant;
}

static inline void rotation_x(double angle_rad, double m[9])
{
    double c = cos(angle_rad), s = sin(angle_rad);
    double r[9] = {1, 0, 0, 0, c, -s, 0, s, c};
    memcpy(m, r, sizeof r);
}

static inline void rotation_y(double angle_rad, double m[9])
{
    double c = cos(angle_rad), s = sin(angle_rad);
    double r[9] = {c, 0, s, 0, 1, 0, -s, 0, c};
    memcpy(m, r, sizeof r);
}

static inline void rotation_z(double angle_rad, double m[9])
{
    double c = cos(angle_rad), s = sin(angle_rad);
    double r[9] = {c, -s, 0, s, c, 0, 0, 0, 1};
    memcpy(m, r, sizeof r);
}

#endif
