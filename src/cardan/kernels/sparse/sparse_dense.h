/*
 * sparse_dense.h: small dense matrices of the sparse solver, row by row, and the processor's mode.
 *
 * Vectors are spelled out: eight numbers, four, two, one. They need no alignment.
 * Source: G. H. Golub, C. F. Van Loan, Matrix Computations, sections 3.4 and 4.4 (Bunch, Kaufman).
 */
#ifndef CARDAN_SPARSE_DENSE_H
#define CARDAN_SPARSE_DENSE_H

#include "cardan.h"
#include <stddef.h>

#if CARDAN_PACK > 1
typedef double cardan_eight __attribute__((vector_size(64), aligned(8), may_alias));
typedef double cardan_four __attribute__((vector_size(32), aligned(8), may_alias));
typedef double cardan_two __attribute__((vector_size(16), aligned(8), may_alias));
typedef uint64_t cardan_four_bits __attribute__((vector_size(32), aligned(8), may_alias));
#endif

/* Flush denormals to zero: along a chain they cost six times as much. Returns the mode before. */
static inline uint64_t cardan_flush(void)
{
#if defined __GNUC__ && defined __SSE2__
    unsigned int mode;
    unsigned int flushed;

    __asm__ volatile("stmxcsr %0" : "=m"(mode));
    flushed = mode | 0x8040u;
    __asm__ volatile("ldmxcsr %0" : : "m"(flushed));
    return mode;
#elif defined __GNUC__ && defined __aarch64__
    uint64_t mode;

    __asm__ volatile("mrs %0, fpcr" : "=r"(mode));
    __asm__ volatile("msr fpcr, %0" : : "r"(mode | ((uint64_t)1 << 24)));
    return mode;
#else
    return 0;
#endif
}

/* Back to the mode before. */
static inline void cardan_restore(uint64_t mode)
{
#if defined __GNUC__ && defined __SSE2__
    unsigned int before = (unsigned int)mode;

    __asm__ volatile("ldmxcsr %0" : : "m"(before));
#elif defined __GNUC__ && defined __aarch64__
    __asm__ volatile("msr fpcr, %0" : : "r"(mode));
#else
    (void)mode;
#endif
}

/* y -= factor x, n numbers */
static inline void cardan_minus(ptrdiff_t n, double factor, const double *x, double *y)
{
    ptrdiff_t j = 0;

#if CARDAN_PACK > 1
    for (; j + 4 <= n; j += 4)
        *(cardan_four *)(y + j) -= factor * *(const cardan_four *)(x + j);
    if (j + 2 <= n) {
        *(cardan_two *)(y + j) -= factor * *(const cardan_two *)(x + j);
        j += 2;
    }
#endif
    for (; j < n; j++)
        y[j] -= factor * x[j];
}

/* y = factor x unit, n numbers each */
static inline void cardan_scaled(ptrdiff_t n, double factor, const double *x, const double *unit,
                                 double *y)
{
    ptrdiff_t j = 0;

#if CARDAN_PACK > 1
    for (; j + 4 <= n; j += 4)
        *(cardan_four *)(y + j) =
            factor * *(const cardan_four *)(x + j) * *(const cardan_four *)(unit + j);
    if (j + 2 <= n) {
        *(cardan_two *)(y + j) =
            factor * *(const cardan_two *)(x + j) * *(const cardan_two *)(unit + j);
        j += 2;
    }
#endif
    for (; j < n; j++)
        y[j] = factor * x[j] * unit[j];
}

/* y = the larger of y and |x|, n numbers */
static inline void cardan_larger(ptrdiff_t n, const double *x, double *y)
{
    ptrdiff_t j = 0;

#if CARDAN_PACK > 1
    for (; j + 4 <= n; j += 4) {
        const cardan_four_bits size = *(const cardan_four_bits *)(x + j) & ~CARDAN_SIGN;
        const cardan_four before = *(cardan_four *)(y + j);
        const cardan_four_bits more = (cardan_four_bits)((cardan_four)size > before);
        *(cardan_four_bits *)(y + j) = (more & size) | (~more & (cardan_four_bits)before);
    }
#endif
    for (; j < n; j++) {
        const double size = fabs(x[j]);
        y[j] = size > y[j] ? size : y[j];
    }
}

/* the sum of |x|, n numbers */
static inline double cardan_sum_of_sizes(ptrdiff_t n, const double *x)
{
    double sum = 0;
    ptrdiff_t j = 0;

#if CARDAN_PACK > 1
    cardan_four total = {0};
    for (; j + 4 <= n; j += 4)
        total += (cardan_four)(*(const cardan_four_bits *)(x + j) & ~CARDAN_SIGN);
    sum = (total[0] + total[2]) + (total[1] + total[3]);
#endif
    for (; j < n; j++)
        sum += fabs(x[j]);
    return sum;
}

/* the sum of x y, n numbers */
static inline double cardan_dot(ptrdiff_t n, const double *x, const double *y)
{
    double sum = 0;
    ptrdiff_t j = 0;

#if CARDAN_PACK > 1
    cardan_two pair = {0};
    if (n >= 4) {
        cardan_four total = *(const cardan_four *)x * *(const cardan_four *)y;
        for (j = 4; j + 4 <= n; j += 4)
            total += *(const cardan_four *)(x + j) * *(const cardan_four *)(y + j);
        pair = (cardan_two){total[0] + total[2], total[1] + total[3]};
    }
    if (j + 2 <= n) {
        pair += *(const cardan_two *)(x + j) * *(const cardan_two *)(y + j);
        j += 2;
    }
    sum = pair[0] + pair[1];
#endif
    for (; j < n; j++)
        sum += x[j] * y[j];
    return sum;
}

#if CARDAN_PACK > 1
#define CARDAN_SIZES_4(x) ((cardan_four)(*(const cardan_four_bits *)(x) & ~CARDAN_SIGN))
#endif

/* The same, and the sum of the sizes of the products. */
static inline double cardan_dot_sizes(ptrdiff_t n, const double *x, const double *y, double *sizes)
{
    ptrdiff_t j = 0;

#if CARDAN_PACK > 1
    cardan_four total = {0};
    for (; j + 4 <= n; j += 4)
        total += CARDAN_SIZES_4(x + j) * CARDAN_SIZES_4(y + j);
    *sizes += (total[0] + total[2]) + (total[1] + total[3]);
#endif
    for (; j < n; j++)
        *sizes += fabs(x[j]) * fabs(y[j]);
    return cardan_dot(n, x, y);
}

/* A tile of C -= At B: six rows and one row, by as many columns as the vector has. */
#define CARDAN_TILES(six, one, vector)                                                             \
    static inline void six(ptrdiff_t n, const double *a, ptrdiff_t lda, const double *b,           \
                           ptrdiff_t ldb, double *c, ptrdiff_t ldc)                                \
    {                                                                                              \
        vector s0 = {0}, s1 = s0, s2 = s0, s3 = s0, s4 = s0, s5 = s0;                              \
        for (ptrdiff_t k = 0; k < n; k++, a += lda, b += ldb) {                                    \
            const vector x = *(const vector *)b;                                                   \
            s0 += a[0] * x, s1 += a[1] * x, s2 += a[2] * x;                                        \
            s3 += a[3] * x, s4 += a[4] * x, s5 += a[5] * x;                                        \
        }                                                                                          \
        *(vector *)c -= s0, *(vector *)(c + ldc) -= s1, *(vector *)(c + 2 * ldc) -= s2;            \
        *(vector *)(c + 3 * ldc) -= s3, *(vector *)(c + 4 * ldc) -= s4;                            \
        *(vector *)(c + 5 * ldc) -= s5;                                                            \
    }                                                                                              \
    static inline void one(ptrdiff_t n, const double *a, ptrdiff_t lda, const double *b,           \
                           ptrdiff_t ldb, double *c)                                               \
    {                                                                                              \
        vector sum = {0};                                                                          \
        for (ptrdiff_t k = 0; k < n; k++)                                                          \
            sum += a[k * lda] * *(const vector *)(b + k * ldb);                                    \
        *(vector *)c -= sum;                                                                       \
    }

#if CARDAN_PACK > 1
CARDAN_TILES(cardan_six_eight, cardan_one_eight, cardan_eight)
CARDAN_TILES(cardan_six_four, cardan_one_four, cardan_four)
CARDAN_TILES(cardan_six_two, cardan_one_two, cardan_two)
#else
typedef double cardan_single_number;
CARDAN_TILES(cardan_six_single, cardan_one_single, cardan_single_number)
#endif

#if CARDAN_PACK > 1
/* Columns j up to where no vector of this many fits any more. */
#define CARDAN_STRIP(width, six, one)                                                              \
    for (; j + (width) <= columns; j += (width)) {                                                 \
        ptrdiff_t i = 0;                                                                           \
        for (; i + 6 <= rows; i += 6)                                                              \
            six(n, a + i, lda, b + j, ldb, c + i * ldc + j, ldc);                                  \
        for (; i < rows; i++)                                                                      \
            one(n, a + i, lda, b + j, ldb, c + i * ldc + j);                                       \
    }
#endif

/* C (rows x columns) -= At B with A (n x rows), B (n x columns) */
static inline void cardan_product(ptrdiff_t rows, ptrdiff_t columns, ptrdiff_t n, const double *a,
                                  ptrdiff_t lda, const double *b, ptrdiff_t ldb, double *c,
                                  ptrdiff_t ldc)
{
    ptrdiff_t j = 0;

#if CARDAN_PACK > 1
    CARDAN_STRIP(8, cardan_six_eight, cardan_one_eight)
    CARDAN_STRIP(4, cardan_six_four, cardan_one_four)
    CARDAN_STRIP(2, cardan_six_two, cardan_one_two)
#endif
    for (; j < columns; j++)
        for (ptrdiff_t i = 0; i < rows; i++) {
            double sum = 0;
            for (ptrdiff_t k = 0; k < n; k++)
                sum += a[k * lda + i] * b[k * ldb + j];
            c[i * ldc + j] -= sum;
        }
}

#endif
