/* Small symmetric matrices. */
#include "symmetric.h"

#include <math.h>
#include <string.h>

/* Turns rows and columns p and q so that a[p][q] becomes 0. */
static void annihilate(int n, double *a, double *vectors, int p, int q)
{
    double off = a[n * p + q];
    double theta = (a[n * q + q] - a[n * p + p]) / (2 * off);
    double t = (theta < 0 ? -1 : 1) / (fabs(theta) + sqrt(theta * theta + 1));
    double c = 1 / sqrt(t * t + 1), s = t * c;

    for (int i = 0; i < n; i++) {
        double ip = a[n * i + p], iq = a[n * i + q];
        a[n * i + p] = c * ip - s * iq;
        a[n * i + q] = s * ip + c * iq;
    }
    for (int i = 0; i < n; i++) {
        double pi = a[n * p + i], qi = a[n * q + i], pv = vectors[n * p + i];
        a[n * p + i] = c * pi - s * qi;
        a[n * q + i] = s * pi + c * qi;
        vectors[n * p + i] = c * pv - s * vectors[n * q + i];
        vectors[n * q + i] = s * pv + c * vectors[n * q + i];
    }
}

static void swap_pairs(int n, double *values, double *vectors, int a, int b)
{
    double value = values[a];

    values[a] = values[b];
    values[b] = value;
    for (int i = 0; i < n; i++) {
        double component = vectors[n * a + i];
        vectors[n * a + i] = vectors[n * b + i];
        vectors[n * b + i] = component;
    }
}

void symmetric_eigen(int n, const double *matrix, double *values, double *vectors)
{
    enum { SWEEPS = 50 };
    double a[SYMMETRIC_MAX * SYMMETRIC_MAX];

    memcpy(a, matrix, (size_t)(n * n) * sizeof *a);
    for (int i = 0; i < n * n; i++)
        vectors[i] = i % (n + 1) == 0;
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
        bool turned = false;
        for (int p = 0; p < n; p++) {
            for (int q = p + 1; q < n; q++) {
                if (!(fabs(a[n * p + q]) >
                      1e-17 * sqrt(fabs(a[n * p + p] * a[n * q + q])) + 1e-300))
                    continue;
                annihilate(n, a, vectors, p, q);
                turned = true;
            }
        }
        if (!turned)
            break;
    }
    for (int i = 0; i < n; i++)
        values[i] = a[n * i + i];
    for (int i = 0; i < n; i++) {
        for (int j = i + 1; j < n; j++) {
            if (values[j] < values[i])
                swap_pairs(n, values, vectors, i, j);
        }
    }
}

bool symmetric_factor(int n, double *matrix, double least)
{
    for (int i = 0; i < n; i++) {
        for (int j = 0; j <= i; j++) {
            double sum = matrix[n * i + j];
            for (int k = 0; k < j; k++)
                sum -= matrix[n * i + k] * matrix[n * j + k];
            if (i == j && !(sum > least * matrix[n * i + i]))
                return false;
            matrix[n * i + j] = i == j ? sqrt(sum) : sum / matrix[n * j + j];
        }
    }
    return true;
}

void symmetric_substitute(int n, const double *l, double *right)
{
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < i; k++)
            right[i] -= l[n * i + k] * right[k];
        right[i] /= l[n * i + i];
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++)
            right[i] -= l[n * k + i] * right[k];
        right[i] /= l[n * i + i];
    }
}

bool symmetric_solve(int n, const double *matrix, double *right)
{
    double l[SYMMETRIC_MAX * SYMMETRIC_MAX];

    memcpy(l, matrix, (size_t)(n * n) * sizeof *l);
    if (!symmetric_factor(n, l, 0))
        return false;
    symmetric_substitute(n, l, right);
    return true;
}
