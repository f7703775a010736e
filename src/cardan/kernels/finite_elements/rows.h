/*
 * rows.h: rows of numbers of states, and their products with constant matrices.
 *
 * Generated files include it where states may stand side by side: `real` is one number or several.
 * Single states go in packs of four along the rows. Every entry is the same sequence of operations
 * either way, so that lanes have the bits of single states.
 */
#ifndef CARDAN_ROWS_H
#define CARDAN_ROWS_H

#include "cardan.h"

#if CARDAN_LANES == 1 && CARDAN_PACK > 1 && !defined CARDAN_COMPLEX
#define CARDAN_QUAD 4
typedef double cardan_quad __attribute__((vector_size(32), aligned(8), may_alias));
#else
#define CARDAN_QUAD 1
#endif

/* out (n) = 0 */
CARDAN_INLINE void cardan_clear(int n, real *out)
{
    for (int i = 0; i < n; ++i) out[i] = CARDAN_REAL(0.0);
}

#if CARDAN_QUAD > 1
/* Where sums of products begin and go: y and out_y only where there are two of them. */
typedef struct cardan_sums {
    const double *from, *x, *y; /* from: NULL for zeros */
    double *out, *out_y;        /* the second sum begins with zeros */
} cardan_sums;

/* Up to six quads of out = from + C^T x from column j on, and the same of y where `both`. Rows of C
 * are `pitch` apart. The last quad may begin before the end of the one ahead of it: only its last
 * `left` entries count. */
static inline __attribute__((always_inline)) void
cardan_quads(int count, int both, int left, int rows, int pitch, int j, const double *C,
             const cardan_sums *s)
{
    const int last = count == 1 ? j + left - 4 : j + 4 * (count - 2) + left;
    const cardan_quad zeros = {0.0};
    cardan_quad sums[6], more[6];

#define CARDAN_ALL(do_one)                                                                          \
    if (count > 1) do_one(0, j);                                                                    \
    if (count > 2) do_one(1, j + 4);                                                                \
    if (count > 3) do_one(2, j + 8);                                                                \
    if (count > 4) do_one(3, j + 12);                                                               \
    if (count > 5) do_one(4, j + 16);                                                               \
    do_one(5, last)
#define CARDAN_FETCH(k, at)                                                                         \
    do {                                                                                            \
        sums[k] = s->from ? *(const cardan_quad *)(s->from + (at)) : zeros;                         \
        if (both) more[k] = zeros;                                                                  \
    } while (0)
#define CARDAN_ADD(k, at)                                                                           \
    do {                                                                                            \
        const cardan_quad entries = *(const cardan_quad *)(row + (at));                             \
        sums[k] += s->x[i] * entries;                                                               \
        if (both) more[k] += s->y[i] * entries;                                                     \
    } while (0)
#define CARDAN_PUT(k, at)                                                                           \
    do {                                                                                            \
        *(cardan_quad *)(s->out + (at)) = sums[k];                                                  \
        if (both) *(cardan_quad *)(s->out_y + (at)) = more[k];                                      \
    } while (0)
    CARDAN_ALL(CARDAN_FETCH);
    for (int i = 0; i < rows; ++i) {
        const double *const row = C + i * pitch;

        CARDAN_ALL(CARDAN_ADD);
    }
    if (count > 1) CARDAN_PUT(0, j);
    if (count > 2) CARDAN_PUT(1, j + 4);
    if (count > 3) CARDAN_PUT(2, j + 8);
    if (count > 4) CARDAN_PUT(3, j + 12);
    if (count > 5) CARDAN_PUT(4, j + 16);
    for (int m = 4 - left; m < 4; ++m) {
        s->out[last + m] = sums[5][m];
        if (both) s->out_y[last + m] = more[5][m];
    }
#undef CARDAN_ALL
#undef CARDAN_FETCH
#undef CARDAN_ADD
#undef CARDAN_PUT
}

static inline __attribute__((always_inline)) void
cardan_in_quads(int both, int rows, int n, int pitch, const double *C, const cardan_sums *s)
{
    int j = 0;

    for (; n - j > 24; j += 16) cardan_quads(4, both, 4, rows, pitch, j, C, s);
    const int count = (n - j + 3) / 4, left = n - j - 4 * (count - 1);

    switch (count) {
    case 1: cardan_quads(1, both, left, rows, pitch, j, C, s); break;
    case 2: cardan_quads(2, both, left, rows, pitch, j, C, s); break;
    case 3: cardan_quads(3, both, left, rows, pitch, j, C, s); break;
    case 4: cardan_quads(4, both, left, rows, pitch, j, C, s); break;
    case 5: cardan_quads(5, both, left, rows, pitch, j, C, s); break;
    default: cardan_quads(6, both, left, rows, pitch, j, C, s);
    }
}
#endif

/* out (n) = a first number + C^T x, rows of C `pitch` apart */
#define CARDAN_PRODUCT(rows, n, pitch, C, x, first, out)                                            \
    for (int j = 0; j < (n); ++j) {                                                                 \
        real sum = (first);                                                                         \
                                                                                                    \
        for (int i = 0; i < (rows); ++i) sum += (x)[i] * (C)[i * (pitch) + j];                      \
        (out)[j] = sum;                                                                             \
    }

/* out (n) += C^T x, C (rows, n) */
CARDAN_APART void cardan_add_product(int rows, int n, const double *C, const real *x, real *out)
{
#if CARDAN_QUAD > 1
    if (n >= 4) {
        const cardan_sums sums = {out, x, NULL, out, NULL};

        cardan_in_quads(0, rows, n, n, C, &sums);
        return;
    }
#endif
    CARDAN_PRODUCT(rows, n, n, C, x, out[j], out)
}

/* out (n) = constants, NULL for zeros, + C^T x */
CARDAN_APART void cardan_set_product(int rows, int n, const double *constants, const double *C,
                                     const real *x, real *out)
{
#if CARDAN_QUAD > 1
    if (n >= 4) {
        const cardan_sums sums = {constants, x, NULL, out, NULL};

        cardan_in_quads(0, rows, n, n, C, &sums);
        return;
    }
#endif
    CARDAN_PRODUCT(rows, n, n, C, x, CARDAN_REAL(constants ? constants[j] : 0.0), out)
}

/* The same, and out_y (n) = C^T y */
CARDAN_APART void cardan_set_products(int rows, int n, const double *constants, const double *C,
                                      const real *x, real *out, const real *y, real *out_y)
{
#if CARDAN_QUAD > 1
    if (n >= 4) {
        const cardan_sums sums = {constants, x, y, out, out_y};

        cardan_in_quads(1, rows, n, n, C, &sums);
        return;
    }
#endif
    CARDAN_PRODUCT(rows, n, n, C, x, CARDAN_REAL(constants ? constants[j] : 0.0), out)
    CARDAN_PRODUCT(rows, n, n, C, y, CARDAN_REAL(0.0), out_y)
}

/* out (n, n), with a stride, = constants + the sum of x_i C_i over matrices C_i that follow each
 * other */
CARDAN_APART void cardan_set_matrix(int count, int n, const double *constants, const double *C,
                                    const real *x, int stride, real *out)
{
    for (int k = 0; k < n; ++k, constants += n, C += n, out += stride) {
#if CARDAN_QUAD > 1
        if (n >= 4) {
            const cardan_sums sums = {constants, x, NULL, out, NULL};

            cardan_in_quads(0, count, n, n * n, C, &sums);
            continue;
        }
#endif
        CARDAN_PRODUCT(count, n, n * n, C, x, CARDAN_REAL(constants[j]), out)
    }
}

/* out (n) += C^T x with C of states, from zeros where `set` */
#if CARDAN_LANES > 1 || defined CARDAN_COMPLEX
CARDAN_APART void cardan_rows(int set, int rows, int n, const real *C, const real *x, real *out)
{
    CARDAN_PRODUCT(rows, n, n, C, x, set ? CARDAN_REAL(0.0) : out[j], out)
}
#else
CARDAN_INLINE void cardan_rows(int set, int rows, int n, const real *C, const real *x, real *out)
{
    if (set)
        cardan_set_product(rows, n, NULL, C, x, out);
    else
        cardan_add_product(rows, n, C, x, out);
}
#endif

/* Sum of products in four parts, which do not wait for each other. */
#define CARDAN_SUM_OF_PRODUCTS(n, a, b, out)                                                        \
    do {                                                                                            \
        real part[4];                                                                               \
        int at = 0;                                                                                 \
                                                                                                    \
        for (int m = 0; m < 4; ++m) part[m] = CARDAN_REAL(0.0);                                     \
        CARDAN_FOURS(n, a, b)                                                                       \
        for (int m = 0; at + m < (n); ++m) part[m] += (a)[at + m] * (b)[at + m];                    \
        (out) = (part[0] + part[2]) + (part[1] + part[3]);                                          \
    } while (0)
#if CARDAN_QUAD > 1
#define CARDAN_FOURS(n, a, b)                                                                       \
    cardan_quad four = *(const cardan_quad *)part;                                                  \
    for (; at + 4 <= (n); at += 4)                                                                  \
        four += *(const cardan_quad *)((a) + at) * *(const cardan_quad *)((b) + at);                \
    *(cardan_quad *)part = four;
#else
#define CARDAN_FOURS(n, a, b)                                                                       \
    for (; at + 4 <= (n); at += 4)                                                                  \
        for (int m = 0; m < 4; ++m) part[m] += (a)[at + m] * (b)[at + m];
#endif

/* out (rows) = A x, A (rows, n) */
CARDAN_APART void cardan_dots(int rows, int n, const real *A, const real *x, real *out)
{
    for (int k = 0; k < rows; ++k) CARDAN_SUM_OF_PRODUCTS(n, A + k * n, x, out[k]);
}

/* The same with A of constants. */
#if CARDAN_LANES > 1 || defined CARDAN_COMPLEX
CARDAN_APART void cardan_dots_constants(int rows, int n, const double *A, const real *x, real *out)
{
    for (int k = 0; k < rows; ++k) CARDAN_SUM_OF_PRODUCTS(n, A + k * n, x, out[k]);
}
#else
#define cardan_dots_constants cardan_dots
#endif

/* out (3, n) += Q X for Q (3, 3) and X (3, n), from zeros where `set` */
CARDAN_INLINE void cardan_3_rows(int set, int n, const real *Q, const real *X, real *out)
{
    for (int k = 0; k < 3; ++k) cardan_rows(set, 3, n, X, Q + 3 * k, out + k * n);
}

/* out (3, n) = Q X with X of constants */
CARDAN_INLINE void cardan_3_constants(int n, const real *Q, const double *X, real *out)
{
    for (int k = 0; k < 3; ++k) cardan_set_product(3, n, NULL, X, Q + 3 * k, out + k * n);
}

#endif
