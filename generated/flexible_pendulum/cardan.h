/*
 * cardan.h: what every C file written by cardan stands on.
 *
 * The calling convention of a function (ABI 2)
 *
 *     int name(const cardan_in *in, real *out, real *work);
 *     void prepare_name(const wreal *p, wreal *w);
 *
 * `in` points to the input blocks; a block the function does not read may be NULL. `out` receives
 * the results one after the other, matrices row by row; `work` is scratch. The caller owns all
 * memory; the sizes stand in the head of each file and in manifest.json. `out` and `work` must
 * overlap neither each other nor an input. `w` holds the parameters p as the function needs them:
 * call prepare_name once for new parameters. The result is 0 or a status code.
 *
 * The same text serves several states side by side: compiled by gcc or clang with
 * -DCARDAN_LANES=8 (or 4, or 2) a `real` is a vector, entry k of every array belongs to all states
 * and element j of an entry to state j. Parameters are then shared by the states, or one set per
 * state with -DCARDAN_LANE_PARAMETERS. A status tells of any of the states.
 *
 * In single precision the text has float where it says double here, and CARDAN_FLOAT is defined; lanes
 * are then twice as many.
 *
 * Self-contained: C99 and its mathematical library; no memory is allocated, no state is kept.
 */
#ifndef CARDAN_H
#define CARDAN_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#define CARDAN_ABI 2

/* vectors of doubles: as wide as the lanes; pairs for single states, where wider ones are not gain */
#ifndef CARDAN_LANES
#define CARDAN_LANES 1
#endif
#if CARDAN_LANES > 1
#define CARDAN_PACK CARDAN_LANES
#elif defined __GNUC__ && !defined CARDAN_FLOAT
#define CARDAN_PACK 2
#else
#define CARDAN_PACK 1
#endif
/* integers of the size of a number, and the size of a `real` */
#ifdef CARDAN_FLOAT
typedef uint32_t cardan_word;
#define CARDAN_BYTES (4 * CARDAN_LANES)
#else
typedef uint64_t cardan_word;
#define CARDAN_BYTES (8 * CARDAN_LANES)
#endif
#if CARDAN_PACK > 1
typedef double cardan_pack __attribute__((vector_size(sizeof(double) * CARDAN_PACK)));
typedef cardan_word cardan_mask __attribute__((vector_size(sizeof(double) * CARDAN_PACK)));
#endif

/* numbers: `real` of a state, `wreal` of a prepared parameter; macros make them of numbers */
#if CARDAN_LANES > 1
typedef cardan_pack real;
#define CARDAN_REAL(x) ((x) - (real){0.0})
#else
typedef double real;
#define CARDAN_REAL(x) (x)
#endif
#ifdef CARDAN_LANE_PARAMETERS
typedef real wreal;
#define CARDAN_WREAL(x) CARDAN_REAL(x)
#else
typedef double wreal;
#define CARDAN_WREAL(x) (x)
#endif

/* what counts as rounding, in double and in single precision */
#ifdef CARDAN_FLOAT
#define CARDAN_ROUNDING(of_double, of_single) (of_single)
#else
#define CARDAN_ROUNDING(of_double, of_single) (of_double)
#endif

#ifdef CARDAN_FLOAT
/* -DCARDAN_FLOAT alone makes no floats: export the model with precision="single" */
typedef char cardan_numbers_are_float[sizeof(real) == CARDAN_BYTES ? 1 : -1];
#endif

/* status codes, may be or-ed together */
enum {
    CARDAN_OK = 0,
    CARDAN_SINGULAR = 1 /* a linear system has no solution; its unknowns are NaN */
};

/* qualifiers: of functions of the interface, of helpers, of the parts of a long function */
#ifndef CARDAN_API
#ifdef __cplusplus
#define CARDAN_API extern "C"
#else
#define CARDAN_API extern
#endif
#endif
#ifndef CARDAN_INLINE
#define CARDAN_INLINE static inline
#endif
#ifndef CARDAN_PART
#ifdef __GNUC__
#define CARDAN_PART static __attribute__((noinline))
#else
#define CARDAN_PART static
#endif
#endif
/* of helpers with loops: compilers fuse a product only with a sum of the same block, and a loop that
 * is inlined ends a block, in lanes elsewhere than in single states */
#ifdef __GNUC__
#define CARDAN_APART static __attribute__((noinline, unused))
#else
#define CARDAN_APART CARDAN_INLINE
#endif
#ifdef __cplusplus
#define CARDAN_RESTRICT __restrict__
#else
#define CARDAN_RESTRICT restrict
#endif

/* input blocks */
typedef struct cardan_in {
    const real *t;      /* time, 1 */
    const real *q;      /* generalized coordinates */
    const real *u;      /* generalized speeds */
    const real *z;      /* internal continuous states */
    const real *s;      /* discrete states, integer-valued */
    const real *r;      /* declared inputs */
    const wreal *p;     /* parameters; read by prepare_ functions only */
    const wreal *w;     /* prepared parameters of the called function */
    const real *udot;   /* derivatives of u */
    const real *zdot;   /* derivatives of z */
    const real *lam;    /* Lagrange multipliers */
    const real *tau;    /* generalized applied forces of the caller */
    const real *wrench; /* wrenches on bodies, torque before force */
    const real *du;     /* finite increment along u */
    const real *q0;     /* coordinates an increment starts from */
    const real *e;      /* events that happened: 1 or 0 each */
    const real *v;      /* weights or direction that a derivative is multiplied by */
} cardan_in;

typedef int (*cardan_function)(const cardan_in *in, real *out, real *work);

/* elementary functions of one number; lanes.h makes them functions of `real` */
CARDAN_INLINE double cardan_sqrt(double x) { return sqrt(x); }
CARDAN_INLINE double cardan_tan(double x) { return tan(x); }
CARDAN_INLINE double cardan_asin(double x) { return asin(x); }
CARDAN_INLINE double cardan_acos(double x) { return acos(x); }
CARDAN_INLINE double cardan_atan(double x) { return atan(x); }
CARDAN_INLINE double cardan_atan2(double y, double x) { return atan2(y, x); }
CARDAN_INLINE double cardan_exp(double x) { return exp(x); }
CARDAN_INLINE double cardan_log(double x) { return log(x); }
CARDAN_INLINE double cardan_sinh(double x) { return sinh(x); }
CARDAN_INLINE double cardan_cosh(double x) { return cosh(x); }
CARDAN_INLINE double cardan_tanh(double x) { return tanh(x); }
CARDAN_INLINE double cardan_asinh(double x) { return asinh(x); }
CARDAN_INLINE double cardan_acosh(double x) { return acosh(x); }
CARDAN_INLINE double cardan_atanh(double x) { return atanh(x); }
CARDAN_INLINE double cardan_pow(double x, double y) { return pow(x, y); }
CARDAN_INLINE double cardan_floor(double x) { return floor(x); }
CARDAN_INLINE double cardan_abs(double x) { return fabs(x); }

#if defined CARDAN_FLOAT && CARDAN_PACK == 1
/* sines and cosines of n angles, of the library for single precision */
#define CARDAN_PADDED(n) (n)
CARDAN_INLINE void cardan_sincos(int n, const double *x, double *sine, double *cosine)
{
    for (int i = 0; i < n; ++i) {
        sine[i] = sin(x[i]);
        cosine[i] = cos(x[i]);
    }
}
#else
/* one number as its bits, the first of which is the sign */
#define CARDAN_SIGN ((cardan_word)1 << (8 * sizeof(cardan_word) - 1))
CARDAN_INLINE cardan_word cardan_bits(double x)
{
    cardan_word bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

CARDAN_INLINE double cardan_of_bits(cardan_word bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* sine and cosine, where the reduction of sincos.h holds: of one number, of a vector */
#define CARDAN_SINCOS_RANGE CARDAN_ROUNDING(1e5, 100.0)
#define CARDAN_SINCOS cardan_sincos_one
#define CARDAN_NUMBER double
#define CARDAN_BITS cardan_word
#define CARDAN_AS_BITS(x) cardan_bits(x)
#define CARDAN_AS_NUMBER(x) cardan_of_bits(x)
#include "sincos.h"
#if CARDAN_PACK > 1
#define CARDAN_SINCOS cardan_sincos_pack
#define CARDAN_NUMBER cardan_pack
#define CARDAN_BITS cardan_mask
#define CARDAN_AS_BITS(x) ((cardan_mask)(x))
#define CARDAN_AS_NUMBER(x) ((cardan_pack)(x))
#include "sincos.h"
#endif

/* sine and cosine of any number; the mathematical library reduces huge ones exactly */
CARDAN_INLINE void cardan_sincos_any(double x, double *sine, double *cosine)
{
    if (fabs(x) <= CARDAN_SINCOS_RANGE) {
        cardan_sincos_one(&x, sine, cosine);
    } else {
        *sine = sin(x);
        *cosine = cos(x);
    }
}

#if CARDAN_PACK > 1
/* whether a mask is set anywhere */
CARDAN_INLINE int cardan_some(const cardan_mask *mask)
{
#if defined __AVX512F__ && CARDAN_BYTES == 64
    int some;
    __asm__("vptestmd %1, %1, %%k1\n\tkmovw %%k1, %0" : "=r"(some) : "v"(*mask) : "k1");
    return some != 0;
#else
    cardan_word each[CARDAN_PACK], any = 0;
    memcpy(each, mask, sizeof each);
    for (int k = 0; k < CARDAN_PACK; ++k) any |= each[k];
    return any != 0;
#endif
}

/* whether all numbers of n vectors lie in the range; conservative: their sum may be too large */
CARDAN_INLINE int cardan_in_range(int n, const cardan_pack *x)
{
    cardan_pack sum = {0.0};
    for (int i = 0; i < n; ++i) sum += (cardan_pack)((cardan_mask)x[i] & ~CARDAN_SIGN);
    const cardan_mask far = ~(cardan_mask)(sum <= CARDAN_SINCOS_RANGE);
    return !cardan_some(&far);
}

/* sines and cosines of n vectors of any numbers */
CARDAN_INLINE void cardan_sincos_vectors(int n, const cardan_pack *x, cardan_pack *sine,
                                         cardan_pack *cosine)
{
    for (int i = 0; i < n; ++i) cardan_sincos_pack(x + i, sine + i, cosine + i);
    if (cardan_in_range(n, x)) return;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < CARDAN_PACK; ++k) {
            const double angle = x[i][k];
            if (fabs(angle) <= CARDAN_SINCOS_RANGE) continue;
            sine[i][k] = sin(angle);
            cosine[i][k] = cos(angle);
        }
}
#endif

/*
 * Sines and cosines of n angles. The arrays have room for CARDAN_PADDED(n) numbers, those behind
 * the n angles being anything finite: several angles take little longer than one.
 */
#define CARDAN_PADDED(n) (((n) + CARDAN_PACK - 1) / CARDAN_PACK * CARDAN_PACK)
CARDAN_INLINE void cardan_sincos(int n, const double *x, double *sine, double *cosine)
{
    double sum = 0.0;
    for (int i = 0; i < n; ++i) sum += fabs(x[i]);
    if (n == 1 || CARDAN_PACK == 1 || !(sum <= CARDAN_SINCOS_RANGE)) {
        for (int i = 0; i < n; ++i) cardan_sincos_any(x[i], sine + i, cosine + i);
        return;
    }
#if CARDAN_PACK > 1
    for (int i = 0; i < n; i += CARDAN_PACK) {
        cardan_pack angle, s, c;
#if CARDAN_PACK == 2
        angle = (cardan_pack){x[i], x[i + 1]}; /* it would wait for memory */
#else
        memcpy(&angle, x + i, sizeof angle);
#endif
        cardan_sincos_pack(&angle, &s, &c);
        memcpy(sine + i, &s, sizeof s);
        memcpy(cosine + i, &c, sizeof c);
    }
#endif
}

#endif

/* comparisons and logic: 1.0 is true, 0.0 is false, any other number counts as true */
#if CARDAN_PACK > 1
/* By bits, as lanes do it: around a branch compilers would fuse other products with sums than they
 * do in lanes, and the last bit would differ. */
CARDAN_INLINE double cardan_choice(int holds, double then, double otherwise)
{
    const cardan_word mask = (cardan_word)0 - (cardan_word)(holds != 0);
    return cardan_of_bits((mask & cardan_bits(then)) | (~mask & cardan_bits(otherwise)));
}
#else
#define cardan_choice(holds, then, otherwise) ((holds) ? (then) : (otherwise))
#endif
CARDAN_INLINE double cardan_lt(double a, double b) { return cardan_choice(a < b, 1.0, 0.0); }
CARDAN_INLINE double cardan_le(double a, double b) { return cardan_choice(a <= b, 1.0, 0.0); }
CARDAN_INLINE double cardan_eq(double a, double b) { return cardan_choice(a == b, 1.0, 0.0); }
CARDAN_INLINE double cardan_and(double a, double b)
{
    return cardan_choice((a != 0.0) & (b != 0.0), 1.0, 0.0);
}
CARDAN_INLINE double cardan_or(double a, double b)
{
    return cardan_choice((a != 0.0) | (b != 0.0), 1.0, 0.0);
}
CARDAN_INLINE double cardan_not(double a) { return cardan_choice(a == 0.0, 1.0, 0.0); }

/* choice by value: both sides have been computed */
#define cardan_select(condition, then, otherwise)                                                  \
    cardan_choice((condition) != 0.0, then, otherwise)
CARDAN_INLINE double cardan_sign(double x) { return cardan_lt(0.0, x) - cardan_lt(x, 0.0); }
CARDAN_INLINE double cardan_min(double a, double b) { return cardan_choice(b < a, b, a); }
CARDAN_INLINE double cardan_max(double a, double b) { return cardan_choice(a < b, b, a); }

CARDAN_INLINE double cardan_factorial(int n)
{
    double product = 1.0;
    for (int j = 2; j <= n; ++j) product *= (double)j;
    return product;
}

/* c_k(x) by its series, for 2 |x| < (k + 1) (k + 2), where the terms fall at once */
CARDAN_INLINE double cardan_stumpff_series(int k, double x)
{
    double term = 1.0 / cardan_factorial(k), total = term;
    for (int i = k; fabs(term) > 1e-17 * fabs(total); i += 2) {
        term *= -x / (((double)i + 1.0) * ((double)i + 2.0));
        total += term;
    }
    return total;
}

/* c_1(x) = sin(sqrt(x)) / sqrt(x), the hyperbolic sine for negative x */
CARDAN_INLINE double cardan_stumpff_1(double x)
{
    if (fabs(x) < 3.0) return cardan_stumpff_series(1, x);
    const double root = sqrt(fabs(x));
    return (x > 0.0 ? sin(root) : sinh(root)) / root;
}

/*
 * Stumpff function c_k(x) = sum_i (-x)^i / (k + 2 i)!, smooth for every real x; k is a literal.
 * Source: K. Stumpff, Himmelsmechanik I, 1959.
 */
CARDAN_APART double cardan_stumpff(int k, double x)
{
    if (2.0 * fabs(x) < ((double)k + 1.0) * ((double)k + 2.0)) return cardan_stumpff_series(k, x);
    if (k == 0) return x > 0.0 ? cos(sqrt(x)) : cosh(sqrt(-x));
    /* c_1, or c_2 by the half angle, which keeps the digits where 1 - cos vanishes */
    const double half = cardan_stumpff_1(k % 2 ? x : 0.25 * x);
    double value = k % 2 ? half : 0.5 * half * half;
    /* c_{j+2} = (1/j! - c_j) / x upwards */
    for (int j = k % 2 ? 1 : 2; j < k; j += 2)
        value = (1.0 / cardan_factorial(j) - value) / x;
    return value;
}

/*
 * Derivative of a piecewise polynomial: breaks (pieces + 1) increasing, coefficients
 * (pieces x order) of x - breaks[piece], highest power first. The end pieces go on outside.
 */
CARDAN_APART double cardan_piecewise(int pieces, int order, const double *breaks,
                                    const double *coefficients, int derivative, double x)
{
    /* the piece by bisection: breaks[low] <= x < breaks[high] */
    int low = 0, high = pieces;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (x < breaks[middle])
            high = middle;
        else
            low = middle;
    }
    /* Horner's rule on the derivative */
    const double *c = coefficients + low * order;
    const double h = x - breaks[low];
    double total = 0.0;
    for (int i = 0; i < order - derivative; ++i) {
        double factor = 1.0;
        for (int j = 0; j < derivative; ++j) factor *= (double)(order - 1 - i - j);
        total = total * h + factor * c[i];
    }
    return total;
}

#ifdef CARDAN_LANE_PARAMETERS
#include "lanes.h"
#endif

#endif
