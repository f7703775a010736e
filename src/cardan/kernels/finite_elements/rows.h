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

#if CARDAN_LANES == 1 && CARDAN_PACK > 1
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

/* out (n) = c, of constants */
CARDAN_INLINE void cardan_set(int n, const double *c, real *out)
{
#if CARDAN_LANES > 1
    for (int i = 0; i < n; ++i) out[i] = CARDAN_REAL(c[i]);
#else
    memcpy(out, c, (size_t)n * sizeof *out);
#endif
}

/* out (n) += factor x */
CARDAN_APART void cardan_add_scaled(int n, const real *factor, const real *x, real *out)
{
    const real f = *factor;
    int i = 0;

#if CARDAN_QUAD > 1
    for (; i + 4 <= n; i += 4)
        *(cardan_quad *)(out + i) += f * *(const cardan_quad *)(x + i);
#endif
    for (; i < n; ++i) out[i] += f * x[i];
}

#if CARDAN_QUAD > 1
/* Up to five quads of out += C^T x from column j on, and the same of y where `both`. The last quad
 * may begin before the end of the one ahead of it: only its last `left` entries count. */
static inline __attribute__((always_inline)) void
cardan_quads(int count, int both, int left, int rows, int n, int j,
                                const double *C, const double *x, double *out, const double *y,
                                double *out_y)
{
    const int last = count == 1 ? j + left - 4 : j + 4 * (count - 2) + left;
    cardan_quad sums[5], more[5];

#define CARDAN_ALL(do_one)                                                                          \
    if (count > 1) do_one(0, j);                                                                    \
    if (count > 2) do_one(1, j + 4);                                                                \
    if (count > 3) do_one(2, j + 8);                                                                \
    if (count > 4) do_one(3, j + 12);                                                               \
    do_one(4, last)
#define CARDAN_FETCH(k, at)                                                                         \
    do {                                                                                            \
        sums[k] = *(const cardan_quad *)(out + (at));                                               \
        if (both) more[k] = *(const cardan_quad *)(out_y + (at));                                   \
    } while (0)
#define CARDAN_ADD(k, at)                                                                           \
    do {                                                                                            \
        const cardan_quad entries = *(const cardan_quad *)(row + (at));                             \
        sums[k] += x[i] * entries;                                                                  \
        if (both) more[k] += y[i] * entries;                                                        \
    } while (0)
#define CARDAN_PUT(k, at)                                                                           \
    do {                                                                                            \
        *(cardan_quad *)(out + (at)) = sums[k];                                                     \
        if (both) *(cardan_quad *)(out_y + (at)) = more[k];                                         \
    } while (0)
    CARDAN_ALL(CARDAN_FETCH);
    for (int i = 0; i < rows; ++i) {
        const double *const row = C + i * n;

        CARDAN_ALL(CARDAN_ADD);
    }
    if (count > 1) CARDAN_PUT(0, j);
    if (count > 2) CARDAN_PUT(1, j + 4);
    if (count > 3) CARDAN_PUT(2, j + 8);
    if (count > 4) CARDAN_PUT(3, j + 12);
    for (int m = 4 - left; m < 4; ++m) {
        out[last + m] = sums[4][m];
        if (both) out_y[last + m] = more[4][m];
    }
#undef CARDAN_ALL
#undef CARDAN_FETCH
#undef CARDAN_ADD
#undef CARDAN_PUT
}

static inline __attribute__((always_inline)) void
cardan_in_quads(int both, int rows, int n, const double *C, const double *x,
                                   double *out, const double *y, double *out_y)
{
    int j = 0;

    for (; n - j > 20; j += 16) cardan_quads(4, both, 4, rows, n, j, C, x, out, y, out_y);
    const int count = (n - j + 3) / 4, left = n - j - 4 * (count - 1);

    switch (count) {
    case 1: cardan_quads(1, both, left, rows, n, j, C, x, out, y, out_y); break;
    case 2: cardan_quads(2, both, left, rows, n, j, C, x, out, y, out_y); break;
    case 3: cardan_quads(3, both, left, rows, n, j, C, x, out, y, out_y); break;
    case 4: cardan_quads(4, both, left, rows, n, j, C, x, out, y, out_y); break;
    default: cardan_quads(5, both, left, rows, n, j, C, x, out, y, out_y);
    }
}
#endif

#define CARDAN_PRODUCT(rows, n, C, x, out)                                                          \
    for (int j = 0; j < (n); ++j) {                                                                 \
        real sum = (out)[j];                                                                        \
                                                                                                    \
        for (int i = 0; i < (rows); ++i) sum += (x)[i] * (C)[i * (n) + j];                          \
        (out)[j] = sum;                                                                             \
    }

/* out (n) += C^T x, C (rows, n) */
CARDAN_APART void cardan_add_product(int rows, int n, const double *C, const real *x, real *out)
{
#if CARDAN_QUAD > 1
    if (n >= 4) {
        cardan_in_quads(0, rows, n, C, x, out, NULL, NULL);
        return;
    }
#endif
    CARDAN_PRODUCT(rows, n, C, x, out)
}

/* The same of x and of y. */
CARDAN_APART void cardan_add_products(int rows, int n, const double *C, const real *x, real *out,
                                      const real *y, real *out_y)
{
#if CARDAN_QUAD > 1
    if (n >= 4) {
        cardan_in_quads(1, rows, n, C, x, out, y, out_y);
        return;
    }
#endif
    CARDAN_PRODUCT(rows, n, C, x, out)
    CARDAN_PRODUCT(rows, n, C, y, out_y)
}

/* out (n) += C^T x with C of states */
#if CARDAN_LANES > 1
CARDAN_APART void cardan_add_rows(int rows, int n, const real *C, const real *x, real *out)
{
    CARDAN_PRODUCT(rows, n, C, x, out)
}
#else
#define cardan_add_rows cardan_add_product
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

CARDAN_APART void cardan_dot(int n, const real *a, const real *b, real *out)
{
    CARDAN_SUM_OF_PRODUCTS(n, a, b, *out);
}

#if CARDAN_LANES > 1
CARDAN_APART void cardan_dot_constants(int n, const double *c, const real *x, real *out)
{
    CARDAN_SUM_OF_PRODUCTS(n, c, x, *out);
}
#else
#define cardan_dot_constants cardan_dot
#endif

/* out (3, n), with a stride, += Q X for Q (3, 3) and X (3, n) */
CARDAN_INLINE void cardan_add_3_rows(int n, const real *Q, const real *X, int stride, real *out)
{
    for (int k = 0; k < 3; ++k) cardan_add_rows(3, n, X, Q + 3 * k, out + k * stride);
}

/* The same with X of constants. */
CARDAN_INLINE void cardan_add_3_constants(int n, const real *Q, const double *X, int stride, real *out)
{
    for (int k = 0; k < 3; ++k) cardan_add_product(3, n, X, Q + 3 * k, out + k * stride);
}

#endif
