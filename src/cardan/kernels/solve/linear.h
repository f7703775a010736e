/*
 * linear.h: dense LU factorization for the implicit methods, factored once and solved often.
 *
 * Matrices (n x n) are stored row by row and overwritten by their factors. `order` stores n
 * numbers: the row each one was exchanged with. Complex matrices are two arrays, real and imaginary
 * parts. Zeros below the diagonal are skipped, since many rows have few entries, such as those of
 * qdot = u.
 * Source: G. H. Golub, C. F. Van Loan, Matrix Computations, section 3.4.
 */
#ifndef CARDAN_LINEAR_H
#define CARDAN_LINEAR_H

#include "cardan.h"
#include <stddef.h>

/* Exchange two rows of length n. */
static inline void cardan_exchange(ptrdiff_t n, real *a, real *b)
{
    for (ptrdiff_t j = 0; j < n; j++) {
        const real swap = a[j];
        a[j] = b[j];
        b[j] = swap;
    }
}

/* A = P L U with partial pivoting. Returns 1 if A is singular or not finite. */
static inline int cardan_factor(ptrdiff_t n, real *a, real *order)
{
    for (ptrdiff_t k = 0; k < n; k++) {
        ptrdiff_t pivot = k;
        real scale;
        for (ptrdiff_t i = k + 1; i < n; i++)
            if (fabs(a[i * n + k]) > fabs(a[pivot * n + k]))
                pivot = i;
        order[k] = (real)pivot;
        if (pivot != k)
            cardan_exchange(n, a + k * n, a + pivot * n);
        scale = 1 / a[k * n + k];
        if (!(scale - scale == 0) || scale == 0)
            return 1;
        for (ptrdiff_t i = k + 1; i < n; i++) {
            real factor = a[i * n + k];
            if (factor == 0)
                continue;
            factor *= scale;
            a[i * n + k] = factor;
            for (ptrdiff_t j = k + 1; j < n; j++)
                a[i * n + j] -= factor * a[k * n + j];
        }
    }
    return 0;
}

/* b (n) becomes the solution of A x = b. */
static inline void cardan_substitute(ptrdiff_t n, const real *a, const real *order, real *b)
{
    for (ptrdiff_t k = 0; k < n; k++) {
        const ptrdiff_t pivot = (ptrdiff_t)order[k];
        const real swap = b[pivot];
        b[pivot] = b[k];
        b[k] = swap;
    }
    for (ptrdiff_t i = 1; i < n; i++)
        for (ptrdiff_t j = 0; j < i; j++)
            b[i] -= a[i * n + j] * b[j];
    for (ptrdiff_t i = n - 1; i >= 0; i--) {
        for (ptrdiff_t j = i + 1; j < n; j++)
            b[i] -= a[i * n + j] * b[j];
        b[i] /= a[i * n + i];
    }
}

/* b (n) becomes the solution of Aᵀ x = b, by the factors of A. */
static inline void cardan_substitute_transposed(ptrdiff_t n, const real *a, const real *order, real *b)
{
    for (ptrdiff_t i = 0; i < n; i++) {
        b[i] /= a[i * n + i];
        for (ptrdiff_t j = i + 1; j < n; j++)
            b[j] -= a[i * n + j] * b[i];
    }
    for (ptrdiff_t i = n - 1; i > 0; i--)
        for (ptrdiff_t j = 0; j < i; j++)
            b[j] -= a[i * n + j] * b[i];
    for (ptrdiff_t k = n - 1; k >= 0; k--)
        cardan_exchange(1, b + (ptrdiff_t)order[k], b + k);
}

/* The same as the first two for A = re + i im. */
static inline int cardan_factor_complex(ptrdiff_t n, real *re, real *im, real *order)
{
    for (ptrdiff_t k = 0; k < n; k++) {
        /* partial pivoting by |re| + |im|, which avoids a square root */
        ptrdiff_t pivot = k;
        real most = -1, size, x, y;
        for (ptrdiff_t i = k; i < n; i++) {
            const real magnitude = fabs(re[i * n + k]) + fabs(im[i * n + k]);
            if (magnitude > most) {
                most = magnitude;
                pivot = i;
            }
        }
        order[k] = (real)pivot;
        if (pivot != k) {
            cardan_exchange(n, re + k * n, re + pivot * n);
            cardan_exchange(n, im + k * n, im + pivot * n);
        }
        x = re[k * n + k], y = im[k * n + k];
        size = 1 / (x * x + y * y);
        if (!(size - size == 0) || size == 0)
            return 1;
        /* x + i y becomes the reciprocal of the pivot; factors replace the column below it */
        x *= size, y *= -size;
        for (ptrdiff_t i = k + 1; i < n; i++) {
            const real p = re[i * n + k], q = im[i * n + k];
            const real f = p * x - q * y, g = p * y + q * x;
            if (p == 0 && q == 0)
                continue;
            re[i * n + k] = f;
            im[i * n + k] = g;
            for (ptrdiff_t j = k + 1; j < n; j++) {
                re[i * n + j] -= f * re[k * n + j] - g * im[k * n + j];
                im[i * n + j] -= f * im[k * n + j] + g * re[k * n + j];
            }
        }
    }
    return 0;
}

/* b + i c (n) becomes the solution of A x = b + i c. */
static inline void cardan_substitute_complex(ptrdiff_t n, const real *re, const real *im,
                                             const real *order, real *b, real *c)
{
    for (ptrdiff_t k = 0; k < n; k++) {
        const ptrdiff_t pivot = (ptrdiff_t)order[k];
        cardan_exchange(1, b + pivot, b + k);
        cardan_exchange(1, c + pivot, c + k);
    }
    for (ptrdiff_t i = 1; i < n; i++)
        for (ptrdiff_t j = 0; j < i; j++) {
            b[i] -= re[i * n + j] * b[j] - im[i * n + j] * c[j];
            c[i] -= re[i * n + j] * c[j] + im[i * n + j] * b[j];
        }
    for (ptrdiff_t i = n - 1; i >= 0; i--) {
        const real x = re[i * n + i], y = im[i * n + i], size = 1 / (x * x + y * y);
        real p, q;
        for (ptrdiff_t j = i + 1; j < n; j++) {
            b[i] -= re[i * n + j] * b[j] - im[i * n + j] * c[j];
            c[i] -= re[i * n + j] * c[j] + im[i * n + j] * b[j];
        }
        p = b[i], q = c[i];
        b[i] = (p * x + q * y) * size;
        c[i] = (q * x - p * y) * size;
    }
}

#endif
