/* Small symmetric matrices: eigenvalues, systems of equations. */
#ifndef SYMMETRIC_H
#define SYMMETRIC_H

#include <stdbool.h>

enum { SYMMETRIC_MAX = 16 };

/*
 * Eigenvalues in rising order; row k of `vectors` is the unit vector of the k-th. By Jacobi's
 * rotations (Golub and Van Loan, Matrix Computations, section 8.5).
 */
void symmetric_eigen(int n, const double *matrix, double *values, double *vectors);

/* Solves matrix x = right, x into `right`, by Cholesky. False unless positive definite. */
bool symmetric_solve(int n, const double *matrix, double *right);

#endif
