/*
 * real_numbers.h: numbers are those of states again, behind complex_numbers.h; from one to the other.
 */
#ifndef CARDAN_REAL_NUMBERS_H
#define CARDAN_REAL_NUMBERS_H

#include "complex_numbers.h"

#undef real
#undef cardan_in
#undef CARDAN_REAL
#if CARDAN_LANES > 1
#define CARDAN_REAL(x) ((x) - (real){0.0})
/* an entry of one of the states side by side */
#define CARDAN_ENTRY(x, lane) ((x)[lane])
#else
#define CARDAN_REAL(x) (x)
#define CARDAN_ENTRY(x, lane) (x)
#endif
#ifdef CARDAN_LANE_PARAMETERS
#define CARDAN_WENTRY(x, lane) ((x)[lane])
#else
#define CARDAN_WENTRY(x, lane) (x)
#endif

/* so small that its square is nothing, and so large that products with it do not vanish */
#define CARDAN_COMPLEX_STEP 1e-40

/* A complex number lies in memory as its two parts: C99, 6.2.5. */
CARDAN_INLINE void cardan_join(double x, double along, cardan_complex *out)
{
    double *const parts = (double *)(void *)out;

    parts[0] = x;
    parts[1] = along * CARDAN_COMPLEX_STEP;
}

/* The derivative; what is no number has none either. */
CARDAN_INLINE double cardan_along(const cardan_complex *x)
{
    const double *const parts = (const double *)(const void *)x;

    return parts[1] / CARDAN_COMPLEX_STEP + 0.0 * parts[0];
}

#endif
