/*
 * lanes.h: the elementary functions of cardan.h for a `real` of several lanes, and sines and cosines
 * of many angles of a single state.
 *
 * Generated files include it before the first function of states: what stands above, prepares
 * parameters, are plain numbers. Vectors cross functions by pointer only; the mathematical library is
 * called lane by lane; what hardware does
 * with vectors gives every lane the bits that a single state has.
 */
#ifndef CARDAN_LANES_H
#define CARDAN_LANES_H

#include "cardan.h"

#if CARDAN_LANES > 1

/* f lane by lane */
CARDAN_APART void cardan_each(double (*f)(double), const real *x, real *y)
{
    for (int k = 0; k < CARDAN_LANES; ++k) (*y)[k] = f((*x)[k]);
}

CARDAN_APART void cardan_each_2(double (*f)(double, double), const real *a, const real *b, real *y)
{
    for (int k = 0; k < CARDAN_LANES; ++k) (*y)[k] = f((*a)[k], (*b)[k]);
}

CARDAN_APART void cardan_stumpff_lanes(int order, const real *x, real *y)
{
    for (int k = 0; k < CARDAN_LANES; ++k) (*y)[k] = cardan_stumpff(order, (*x)[k]);
}

CARDAN_APART void cardan_piecewise_lanes(int pieces, int order, const double *breaks,
                                         const double *coefficients, int derivative,
                                         const real *x, real *y)
{
    for (int k = 0; k < CARDAN_LANES; ++k)
        (*y)[k] = cardan_piecewise(pieces, order, breaks, coefficients, derivative, (*x)[k]);
}

/* the square root of the hardware; compilers offer none for vectors of their own */
#ifdef CARDAN_FLOAT
#define CARDAN_SQRT(prefix) prefix "sqrtps"
#define CARDAN_SQRT_OF_ARM "fsqrt %0.4s, %1.4s"
#else
#define CARDAN_SQRT(prefix) prefix "sqrtpd"
#define CARDAN_SQRT_OF_ARM "fsqrt %0.2d, %1.2d"
#endif
CARDAN_INLINE void cardan_sqrt_lanes(const real *x, real *y)
{
#if defined __AVX512F__ || (defined __AVX__ && CARDAN_BYTES <= 32)
    __asm__(CARDAN_SQRT("v") " %1, %0" : "=v"(*y) : "v"(*x));
#elif defined __SSE2__ && CARDAN_BYTES == 16
    __asm__(CARDAN_SQRT("") " %1, %0" : "=x"(*y) : "x"(*x));
#elif defined __aarch64__ && CARDAN_BYTES == 16
    __asm__(CARDAN_SQRT_OF_ARM : "=w"(*y) : "w"(*x));
#else
    cardan_each(cardan_sqrt, x, y);
#endif
}

/* the value of a function that takes pointers */
#define CARDAN_VALUE(call, x) \
    __extension__({ \
        const real x_ = CARDAN_REAL(x); \
        real y_; \
        call; \
        y_; \
    })
#define CARDAN_EACH(f, x) CARDAN_VALUE(cardan_each(f, &x_, &y_), x)
#define CARDAN_EACH_2(f, a, b) \
    __extension__({ \
        const real a_ = CARDAN_REAL(a), b_ = CARDAN_REAL(b); \
        real y_; \
        cardan_each_2(f, &a_, &b_, &y_); \
        y_; \
    })

#undef CARDAN_PADDED
#define CARDAN_PADDED(n) (n)
#define cardan_sincos(n, x, sine, cosine) cardan_sincos_vectors(n, x, sine, cosine)
#define cardan_sqrt(x) CARDAN_VALUE(cardan_sqrt_lanes(&x_, &y_), x)
#define cardan_tan(x) CARDAN_EACH(cardan_tan, x)
#define cardan_asin(x) CARDAN_EACH(cardan_asin, x)
#define cardan_acos(x) CARDAN_EACH(cardan_acos, x)
#define cardan_atan(x) CARDAN_EACH(cardan_atan, x)
#define cardan_atan2(y, x) CARDAN_EACH_2(cardan_atan2, y, x)
#define cardan_exp(x) CARDAN_EACH(cardan_exp, x)
#define cardan_log(x) CARDAN_EACH(cardan_log, x)
#define cardan_sinh(x) CARDAN_EACH(cardan_sinh, x)
#define cardan_cosh(x) CARDAN_EACH(cardan_cosh, x)
#define cardan_tanh(x) CARDAN_EACH(cardan_tanh, x)
#define cardan_asinh(x) CARDAN_EACH(cardan_asinh, x)
#define cardan_acosh(x) CARDAN_EACH(cardan_acosh, x)
#define cardan_atanh(x) CARDAN_EACH(cardan_atanh, x)
#define cardan_pow(x, y) CARDAN_EACH_2(cardan_pow, x, y)
#define cardan_floor(x) CARDAN_EACH(cardan_floor, x)
#define cardan_stumpff(k, x) CARDAN_VALUE(cardan_stumpff_lanes(k, &x_, &y_), x)
#define cardan_piecewise(pieces, order, breaks, coefficients, derivative, x) \
    CARDAN_VALUE( \
        cardan_piecewise_lanes(pieces, order, breaks, coefficients, derivative, &x_, &y_), x)

/* comparisons and logic: masks of integers, and 1.0 where they are set */
#define CARDAN_BOOLEAN(mask) ((real)((cardan_mask)(mask) & (cardan_mask)CARDAN_REAL(1.0)))
#define CARDAN_TRUE(x) ((cardan_mask)(CARDAN_REAL(x) != 0.0))
#define CARDAN_CHOICE(mask, a, b) \
    __extension__({ \
        const cardan_mask m_ = (cardan_mask)(mask); \
        (real)((m_ & (cardan_mask)(a)) | (~m_ & (cardan_mask)(b))); \
    })
#define cardan_abs(x) ((real)((cardan_mask)CARDAN_REAL(x) & ~CARDAN_SIGN))
#define cardan_lt(a, b) CARDAN_BOOLEAN(CARDAN_REAL(a) < CARDAN_REAL(b))
#define cardan_le(a, b) CARDAN_BOOLEAN(CARDAN_REAL(a) <= CARDAN_REAL(b))
#define cardan_eq(a, b) CARDAN_BOOLEAN(CARDAN_REAL(a) == CARDAN_REAL(b))
#define cardan_and(a, b) CARDAN_BOOLEAN(CARDAN_TRUE(a) & CARDAN_TRUE(b))
#define cardan_or(a, b) CARDAN_BOOLEAN(CARDAN_TRUE(a) | CARDAN_TRUE(b))
#define cardan_not(a) CARDAN_BOOLEAN(~CARDAN_TRUE(a))
#define cardan_sign(x) (cardan_lt(0.0, x) - cardan_lt(x, 0.0))
#define cardan_min(a, b) \
    __extension__({ \
        const real a_ = CARDAN_REAL(a), b_ = CARDAN_REAL(b); \
        CARDAN_CHOICE(b_ < a_, b_, a_); \
    })
#define cardan_max(a, b) \
    __extension__({ \
        const real a_ = CARDAN_REAL(a), b_ = CARDAN_REAL(b); \
        CARDAN_CHOICE(a_ < b_, b_, a_); \
    })
#undef cardan_select
#define cardan_select(condition, then, otherwise) \
    CARDAN_CHOICE(CARDAN_TRUE(condition), CARDAN_REAL(then), CARDAN_REAL(otherwise))

/* linear systems: solve.h */
#undef CARDAN_SOLVE
#define CARDAN_SOLVE(kind, n, m, a, b, scratch) \
    cardan_solve_lanes(cardan_solve_##kind, n, m, a, b, scratch)

#elif CARDAN_PACK == 2 && defined __AVX__

/* many angles of a single state: in the widest vectors of the processor */
#ifdef __AVX512F__
#define CARDAN_WIDEST 8
#else
#define CARDAN_WIDEST 4
#endif
typedef double cardan_widest __attribute__((vector_size(sizeof(double) * CARDAN_WIDEST)));
typedef cardan_word cardan_widest_mask __attribute__((vector_size(sizeof(double) * CARDAN_WIDEST)));
#define CARDAN_SINCOS cardan_sincos_widest
#define CARDAN_NUMBER cardan_widest
#define CARDAN_BITS cardan_widest_mask
#define CARDAN_AS_BITS(x) ((cardan_widest_mask)(x))
#define CARDAN_AS_NUMBER(x) ((cardan_widest)(x))
#include "sincos.h"

/* angles from which that pays: a vector waits until those written one by one are in memory */
#define CARDAN_MANY 16
#define CARDAN_STEP(n) ((n) < CARDAN_MANY ? CARDAN_PACK : CARDAN_WIDEST)
#undef CARDAN_PADDED
#define CARDAN_PADDED(n) (((n) + CARDAN_STEP(n) - 1) / CARDAN_STEP(n) * CARDAN_STEP(n))
CARDAN_INLINE void cardan_sincos_many(int n, const double *x, double *sine, double *cosine)
{
    cardan_widest_mask far = {0};
    cardan_word any = 0;

    if (n < CARDAN_MANY) {
        cardan_sincos(n, x, sine, cosine);
        return;
    }
    for (int i = 0; i < n; i += CARDAN_WIDEST) {
        cardan_widest angle, s, c;
        memcpy(&angle, x + i, sizeof angle);
        cardan_sincos_widest(&angle, &s, &c);
        memcpy(sine + i, &s, sizeof s);
        memcpy(cosine + i, &c, sizeof c);
        const cardan_widest size = (cardan_widest)((cardan_widest_mask)angle & ~CARDAN_SIGN);
        far |= ~(cardan_widest_mask)(size <= CARDAN_SINCOS_RANGE);
    }
    /* what the reduction of sincos.h does not hold for: one by one */
    for (int k = 0; k < CARDAN_WIDEST; ++k) any |= far[k];
    for (int i = 0; any && i < n; ++i) cardan_sincos_any(x[i], sine + i, cosine + i);
}
#define cardan_sincos(n, x, sine, cosine) cardan_sincos_many(n, x, sine, cosine)

#endif
#endif
