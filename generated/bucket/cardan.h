/*
 * cardan.h: what every C file written by cardan stands on.
 *
 * The calling convention of a function (ABI 1)
 *
 *     int name(const cardan_in *in, real *out, real *work);
 *     void prepare_name(const real *p, wreal *w);
 *
 * `in` points to the input blocks; a block the function does not read may be NULL. `out` receives
 * the results one after the other, matrices row by row; `work` is scratch. The caller owns all
 * memory; the sizes stand in the head of each file and in manifest.json. `out` and `work` must
 * overlap neither each other nor an input. `w` holds the parameters p as the function needs them:
 * call prepare_name once for new parameters. The result is 0 or a status code.
 *
 * Self-contained: C99 and its mathematical library; no memory is allocated, no state is kept.
 */
#ifndef CARDAN_H
#define CARDAN_H

#include <math.h>

#define CARDAN_ABI 1

/* numbers: `real` of a state, `wreal` of a prepared parameter */
typedef double real;
typedef double wreal;

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
    const real *p;      /* parameters; read by prepare_ functions only */
    const wreal *w;     /* prepared parameters of the called function */
    const real *udot;   /* derivatives of u */
    const real *zdot;   /* derivatives of z */
    const real *lam;    /* Lagrange multipliers */
    const real *tau;    /* generalized applied forces of the caller */
    const real *wrench; /* wrenches on bodies, torque before force */
    const real *du;     /* finite increment along u */
    const real *q0;     /* coordinates an increment starts from */
} cardan_in;

/* elementary functions */
CARDAN_INLINE real cardan_sqrt(real x) { return sqrt(x); }
CARDAN_INLINE real cardan_sin(real x) { return sin(x); }
CARDAN_INLINE real cardan_cos(real x) { return cos(x); }
CARDAN_INLINE real cardan_tan(real x) { return tan(x); }
CARDAN_INLINE real cardan_asin(real x) { return asin(x); }
CARDAN_INLINE real cardan_acos(real x) { return acos(x); }
CARDAN_INLINE real cardan_atan(real x) { return atan(x); }
CARDAN_INLINE real cardan_atan2(real y, real x) { return atan2(y, x); }
CARDAN_INLINE real cardan_exp(real x) { return exp(x); }
CARDAN_INLINE real cardan_log(real x) { return log(x); }
CARDAN_INLINE real cardan_sinh(real x) { return sinh(x); }
CARDAN_INLINE real cardan_cosh(real x) { return cosh(x); }
CARDAN_INLINE real cardan_tanh(real x) { return tanh(x); }
CARDAN_INLINE real cardan_asinh(real x) { return asinh(x); }
CARDAN_INLINE real cardan_acosh(real x) { return acosh(x); }
CARDAN_INLINE real cardan_atanh(real x) { return atanh(x); }
CARDAN_INLINE real cardan_pow(real x, real y) { return pow(x, y); }
CARDAN_INLINE real cardan_floor(real x) { return floor(x); }
CARDAN_INLINE real cardan_abs(real x) { return fabs(x); }

/* comparisons and logic: 1.0 is true, 0.0 is false, any other number counts as true */
CARDAN_INLINE real cardan_lt(real a, real b) { return a < b ? 1.0 : 0.0; }
CARDAN_INLINE real cardan_le(real a, real b) { return a <= b ? 1.0 : 0.0; }
CARDAN_INLINE real cardan_eq(real a, real b) { return a == b ? 1.0 : 0.0; }
CARDAN_INLINE real cardan_and(real a, real b) { return a != 0.0 && b != 0.0 ? 1.0 : 0.0; }
CARDAN_INLINE real cardan_or(real a, real b) { return a != 0.0 || b != 0.0 ? 1.0 : 0.0; }
CARDAN_INLINE real cardan_not(real a) { return a == 0.0 ? 1.0 : 0.0; }

/* choice by value: both sides have been computed */
#define cardan_select(condition, then, otherwise) ((condition) != 0.0 ? (then) : (otherwise))
CARDAN_INLINE real cardan_sign(real x) { return cardan_lt(0.0, x) - cardan_lt(x, 0.0); }
CARDAN_INLINE real cardan_min(real a, real b) { return b < a ? b : a; }
CARDAN_INLINE real cardan_max(real a, real b) { return b > a ? b : a; }

CARDAN_INLINE double cardan_factorial(int n)
{
    double product = 1.0;
    for (int j = 2; j <= n; ++j) product *= j;
    return product;
}

/* c_k(x) by its series, for 2 |x| < (k + 1) (k + 2), where the terms fall at once */
CARDAN_INLINE real cardan_stumpff_series(int k, real x)
{
    real term = 1.0 / cardan_factorial(k), total = term;
    for (int i = k; fabs(term) > 1e-17 * fabs(total); i += 2) {
        term *= -x / ((i + 1.0) * (i + 2.0));
        total += term;
    }
    return total;
}

/* c_1(x) = sin(sqrt(x)) / sqrt(x), the hyperbolic sine for negative x */
CARDAN_INLINE real cardan_stumpff_1(real x)
{
    if (fabs(x) < 3.0) return cardan_stumpff_series(1, x);
    const real root = sqrt(fabs(x));
    return (x > 0.0 ? sin(root) : sinh(root)) / root;
}

/*
 * Stumpff function c_k(x) = sum_i (-x)^i / (k + 2 i)!, smooth for every real x; k is a literal.
 * Source: K. Stumpff, Himmelsmechanik I, 1959.
 */
CARDAN_INLINE real cardan_stumpff(int k, real x)
{
    if (2.0 * fabs(x) < (k + 1.0) * (k + 2.0)) return cardan_stumpff_series(k, x);
    if (k == 0) return x > 0.0 ? cos(sqrt(x)) : cosh(sqrt(-x));
    /* c_1, or c_2 by the half angle, which keeps the digits where 1 - cos vanishes */
    const real half = cardan_stumpff_1(k % 2 ? x : 0.25 * x);
    real value = k % 2 ? half : 0.5 * half * half;
    /* c_{j+2} = (1/j! - c_j) / x upwards */
    for (int j = k % 2 ? 1 : 2; j < k; j += 2)
        value = (1.0 / cardan_factorial(j) - value) / x;
    return value;
}

/*
 * Derivative of a piecewise polynomial: breaks (pieces + 1) increasing, coefficients
 * (pieces x order) of x - breaks[piece], highest power first. The end pieces go on outside.
 */
CARDAN_INLINE real cardan_piecewise(int pieces, int order, const double *breaks,
                                    const double *coefficients, int derivative, real x)
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
    const real h = x - breaks[low];
    real total = 0.0;
    for (int i = 0; i < order - derivative; ++i) {
        double factor = 1.0;
        for (int j = 0; j < derivative; ++j) factor *= order - 1 - i - j;
        total = total * h + factor * c[i];
    }
    return total;
}

#endif
