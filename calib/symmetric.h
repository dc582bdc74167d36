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

/*
 * The lower triangle of L with L L' = matrix, into `matrix`, by Cholesky. False unless positive
 * definite, what is left of each element of the diagonal being more than `least` of it.
 */
bool symmetric_factor(int n, double *matrix, double least);

/* Solves L L' x = right, x into `right`. */
void symmetric_substitute(int n, const double *l, double *right);

/* Solves matrix x = right, x into `right`, by both. False unless positive definite. */
bool symmetric_solve(int n, const double *matrix, double *right);

#endif
