/* Points of Gauss, and integrals of polynomials through values at points.
 *
 * Part of cardan. Caller owns all memory.
 * Source: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed.,
 * section II.7.
 */
#ifndef CARDAN_GAUSS_H
#define CARDAN_GAUSS_H

#include "cardan.h"
#include <math.h>
#include <stddef.h>

enum { MOST_POINTS = 10 };

/* A step of length h with s points (s), weights (s), and how far they keep from a place in it. */
typedef struct gauss {
    ptrdiff_t s;
    real h, spacing, points[MOST_POINTS], weights[MOST_POINTS];
} gauss;

/* Legendre polynomials p (count) at x in -1 ... 1. */
static inline void legendre(real x, ptrdiff_t count, real *p)
{
    p[0] = 1;
    p[1] = x;
    for (ptrdiff_t k = 1; k + 1 < count; k++)
        p[k + 1] = ((real)(2 * k + 1) * x * p[k] - (real)k * p[k - 1]) / (real)(k + 1);
}

/* Points and weights of Gauss in 0 ... 1, by Newton's method. */
static inline void lay(gauss *at, ptrdiff_t s)
{
    const real pi = 3.14159265358979323846;
    real p[MOST_POINTS + 1];

    at->s = s;
    for (ptrdiff_t i = 0; i < s; i++) {
        real x = -cos(pi * ((real)i + 0.75) / ((real)s + 0.5)), slope = 1;
        for (int k = 0; k < 8; k++) {
            legendre(x, s + 1, p);
            slope = (real)s * (x * p[s] - p[s - 1]) / (x * x - 1);
            x -= p[s] / slope;
        }
        at->points[i] = 0.5 * (1 + x);
        at->weights[i] = 1 / ((1 - x * x) * slope * slope);
    }
}

/* Weights w (count) of values at `points`, for the integral from a to b of their polynomial. */
static inline void integral(const real *points, ptrdiff_t count, real a, real b, real *w)
{
    gauss rule;

    lay(&rule, MOST_POINTS);
    for (ptrdiff_t j = 0; j < count; j++) {
        w[j] = 0;
        for (ptrdiff_t i = 0; i < rule.s; i++) {
            real x = a + (b - a) * rule.points[i], value = 1;
            for (ptrdiff_t k = 0; k < count; k++)
                value *= k == j ? 1 : (x - points[k]) / (points[j] - points[k]);
            w[j] += (b - a) * rule.weights[i] * value;
        }
    }
}

#endif
