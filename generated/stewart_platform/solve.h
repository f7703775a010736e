/*
 * solve.h: linear systems inside generated functions that need pivoting.
 *
 * A (n x n) and B (n x m) are stored row by row. Both are overwritten: B by the solution, A by the
 * factors. `scratch` needs 2 n numbers per system, plus n (n + m) / 2 for systems of lanes.
 * Contains static functions only. (cardan_max) in parentheses is the scalar function, even if
 * lanes.h redefines the name as a macro.
 */
#ifndef CARDAN_SOLVE_H
#define CARDAN_SOLVE_H

#include "cardan.h"
#include <float.h>

/* type of the solvers below, and how to call one; lanes.h redefines this for several systems */
typedef int cardan_solver(int n, int m, double *a, double *b, double *scratch);
#ifndef CARDAN_SOLVE
#define CARDAN_SOLVE(kind, n, m, a, b, scratch) cardan_solve_##kind(n, m, a, b, scratch)
#endif

/* Exchange two rows of a matrix with m columns. */
CARDAN_INLINE void cardan_swap_rows(int m, double *a, int i, int j)
{
    for (int k = 0; k < m; ++k) {
        const double swap = a[i * m + k];
        a[i * m + k] = a[j * m + k];
        a[j * m + k] = swap;
    }
}

/* Exchange two columns of a matrix with n rows. */
CARDAN_INLINE void cardan_swap_columns(int n, double *a, int i, int j)
{
    for (int k = 0; k < n; ++k) {
        const double swap = a[k * n + i];
        a[k * n + i] = a[k * n + j];
        a[k * n + j] = swap;
    }
}

CARDAN_INLINE void cardan_swap(double *a, int i, int j)
{
    const double swap = a[i];
    a[i] = a[j];
    a[j] = swap;
}

/* Undo the exchanges of unknowns. */
CARDAN_INLINE void cardan_restore_order(int n, int m, double *b, double *order)
{
    for (int i = 0; i < n; ++i)
        while ((int)order[i] != i) {
            const int j = (int)order[i];
            cardan_swap_rows(m, b, i, j);
            cardan_swap(order, i, j);
        }
}

/* No solution: fill with NaN and return the status. */
CARDAN_INLINE int cardan_no_solution(int size, double *b)
{
    for (int i = 0; i < size; ++i) b[i] = (double)NAN;
    return CARDAN_SINGULAR;
}

/*
 * A X = B by elimination with complete pivoting; A may be singular.
 *
 * Unknowns that A leaves free become 0. Pivots below n eps max|A| count as zero.
 * Returns CARDAN_SINGULAR if the system is inconsistent.
 * Source: G. H. Golub, C. F. Van Loan, Matrix Computations, section 3.4.8.
 */
CARDAN_INLINE int cardan_solve_rank_revealing(int n, int m, double *a, double *b, double *scratch)
{
    double *const order = scratch, *const scale = scratch + n;
    double tolerance = 0.0;
    int rank = 0;

    /* the largest entry of each row of B separates rounding from inconsistency */
    for (int i = 0; i < n; ++i) {
        order[i] = (double)i;
        scale[i] = 0.0;
        for (int k = 0; k < m; ++k) scale[i] = (cardan_max)(scale[i], fabs(b[i * m + k]));
    }
    for (; rank < n; ++rank) {
        /* the largest entry left becomes the pivot */
        int row = rank, column = rank;
        for (int i = rank; i < n; ++i)
            for (int j = rank; j < n; ++j)
                if (fabs(a[i * n + j]) > fabs(a[row * n + column])) {
                    row = i;
                    column = j;
                }
        const double pivot = a[row * n + column];
        if (!(pivot - pivot == 0.0)) return cardan_no_solution(n * m, b);
        if (rank == 0) tolerance = (double)n * DBL_EPSILON * fabs(pivot);
        if (fabs(pivot) <= tolerance) break;
        cardan_swap_rows(n, a, row, rank);
        cardan_swap_rows(m, b, row, rank);
        cardan_swap_columns(n, a, column, rank);
        cardan_swap(order, column, rank);
        cardan_swap(scale, row, rank);

        /* eliminate below */
        for (int i = rank + 1; i < n; ++i) {
            const double factor = a[i * n + rank] / pivot;
            if (factor == 0.0) continue;
            for (int j = rank + 1; j < n; ++j) a[i * n + j] -= factor * a[rank * n + j];
            for (int k = 0; k < m; ++k) b[i * m + k] -= factor * b[rank * m + k];
            scale[i] = (cardan_max)(scale[i], fabs(factor) * scale[rank]);
        }
    }

    /* rows without a pivot must have a zero right-hand side, up to rounding */
    for (int i = rank; i < n; ++i)
        for (int k = 0; k < m; ++k) {
            if (!(fabs(b[i * m + k]) <= 64 * (double)n * DBL_EPSILON * scale[i]))
                return cardan_no_solution(n * m, b);
            b[i * m + k] = 0.0;
        }

    /* back substitution */
    for (int i = rank - 1; i >= 0; --i)
        for (int k = 0; k < m; ++k) {
            double sum = b[i * m + k];
            for (int j = i + 1; j < rank; ++j) sum -= a[i * n + j] * b[j * m + k];
            b[i * m + k] = sum / a[i * n + i];
        }

    cardan_restore_order(n, m, b, order);
    return CARDAN_OK;
}

/* Solve D [x y]ᵀ = [e f]ᵀ for the symmetric 2 x 2 pivot block D at row k of A. */
CARDAN_INLINE void cardan_divide_block(int n, const double *a, int k, double e, double f, double *x,
                                       double *y)
{
    const double off_diagonal = a[k * n + k + 1];
    const double first = a[k * n + k] / off_diagonal, second = a[(k + 1) * n + k + 1] / off_diagonal;
    const double scale = 1.0 / (off_diagonal * (first * second - 1.0));
    *x = scale * (second * e - f);
    *y = scale * (first * f - e);
}

/* Find the next pivot: a diagonal entry (returns 1) or a 2 x 2 block (2); 0 if none is left. */
CARDAN_INLINE int cardan_find_pivot(int n, const double *a, int k, double tolerance, int *one,
                                    int *two)
{
    const double alpha = 0.6403882032022076; /* (1 + sqrt(17)) / 8 bounds the growth */
    int diagonal = k, row = k, column = k;
    double off_diagonal = 0.0;

    for (int i = k; i < n; ++i) {
        if (fabs(a[i * n + i]) > fabs(a[diagonal * n + diagonal])) diagonal = i;
        for (int j = k; j < i; ++j)
            if (fabs(a[i * n + j]) > off_diagonal) {
                off_diagonal = fabs(a[i * n + j]);
                row = i;
                column = j;
            }
    }
    const double size = fabs(a[diagonal * n + diagonal]);
    const int single = size >= alpha * off_diagonal;
    *one = single ? diagonal : column;
    *two = row;
    if (!(size - size == 0.0) || (cardan_max)(size, off_diagonal) <= tolerance) return 0;
    return single ? 1 : 2;
}

/* Eliminate with the pivot rows k ... k + size - 1 from all rows below; L overwrites A. */
CARDAN_INLINE void cardan_eliminate(int n, int m, double *a, double *b, int k, int size)
{
    for (int i = k + size; i < n; ++i) {
        double x, y = 0.0;
        if (size == 1)
            x = a[i * n + k] / a[k * n + k];
        else
            cardan_divide_block(n, a, k, a[i * n + k], a[i * n + k + 1], &x, &y);
        const int next = k + size - 1;
        for (int j = k + size; j < n; ++j) a[i * n + j] -= x * a[k * n + j] + y * a[next * n + j];
        for (int c = 0; c < m; ++c) b[i * m + c] -= x * b[k * m + c] + y * b[next * m + c];
        a[i * n + next] = y;
        a[i * n + k] = x;
    }
}

/*
 * A X = B for symmetric indefinite A: P A Pᵀ = L D Lᵀ with 1 x 1 and 2 x 2 pivot blocks, chosen by
 * complete (Bunch-Parlett) pivoting. Only the lower triangle of A is read.
 *
 * Returns CARDAN_SINGULAR if a pivot falls below n eps max|A|.
 * Source: J. R. Bunch, B. N. Parlett, Direct methods for solving symmetric indefinite systems of
 * linear equations, SIAM J. Numer. Anal. 8 (1971).
 */
CARDAN_INLINE int cardan_solve_symmetric_indefinite(int n, int m, double *a, double *b,
                                                    double *scratch)
{
    double *const order = scratch, *const block = scratch + n;
    double largest = 0.0;

    /* mirror the lower triangle, so that rows and columns can be exchanged in full */
    for (int i = 0; i < n; ++i) {
        order[i] = (double)i;
        block[i] = 0.0;
        for (int j = 0; j <= i; ++j) {
            a[j * n + i] = a[i * n + j];
            largest = (cardan_max)(largest, fabs(a[i * n + j]));
        }
    }

    /* factor, forward substitution along with it; block[k] is the size of a block, 0 inside */
    for (int k = 0; k < n;) {
        int at[2];
        const int size = cardan_find_pivot(n, a, k, (double)n * DBL_EPSILON * largest, at, at + 1);
        if (size == 0) return cardan_no_solution(n * m, b);
        for (int i = 0; i < size; ++i) {
            cardan_swap_rows(n, a, at[i], k + i);
            cardan_swap_columns(n, a, at[i], k + i);
            cardan_swap_rows(m, b, at[i], k + i);
            cardan_swap(order, at[i], k + i);
        }
        cardan_eliminate(n, m, a, b, k, size);
        block[k] = (double)size;
        k += size;
    }

    /* divide by D, then back substitution with Lᵀ */
    for (int k = n - 1; k >= 0; --k) {
        const int size = (int)block[k];
        for (int c = 0; c < m && size > 0; ++c) {
            double *const x = b + k * m + c;
            if (size == 1)
                *x /= a[k * n + k];
            else
                cardan_divide_block(n, a, k, x[0], x[m], x, x + m);
            for (int i = k + size; i < n; ++i)
                for (int j = 0; j < size; ++j) x[j * m] -= a[i * n + k + j] * b[i * m + c];
        }
    }
    cardan_restore_order(n, m, b, order);
    return CARDAN_OK;
}

/*
 * Solve Lᵀ D L X = B for several columns of B at once, of type `columns` at `at`. A contains L
 * (unit lower) and the reciprocals of D. Zeros of L are skipped.
 */
#define CARDAN_SUBSTITUTE(name, columns)                                                           \
    CARDAN_INLINE void name(int n, int m, const double *a, double *at)                             \
    {                                                                                              \
        for (int k = n - 1; k > 0; --k) {                                                          \
            const columns x = *(columns *)(at + k * m);                                            \
            for (int j = 0; j < k; ++j)                                                            \
                if (a[k * n + j] != 0.0) *(columns *)(at + j * m) -= a[k * n + j] * x;             \
        }                                                                                          \
        for (int k = 0; k < n; ++k) {                                                              \
            columns x = *(columns *)(at + k * m) * a[k * n + k];                                   \
            for (int j = 0; j < k; ++j)                                                            \
                if (a[k * n + j] != 0.0) x -= a[k * n + j] * *(columns *)(at + j * m);             \
            *(columns *)(at + k * m) = x;                                                          \
        }                                                                                          \
    }
CARDAN_SUBSTITUTE(cardan_substitute_1, double)
#if defined(__GNUC__)
#define CARDAN_COLUMNS(n)                                                                          \
    __attribute__((vector_size(n * sizeof(double)), aligned(sizeof(double)), may_alias))
typedef double cardan_columns_2 CARDAN_COLUMNS(2);
typedef double cardan_columns_4 CARDAN_COLUMNS(4);
typedef double cardan_columns_8 CARDAN_COLUMNS(8);
CARDAN_SUBSTITUTE(cardan_substitute_2, cardan_columns_2)
CARDAN_SUBSTITUTE(cardan_substitute_4, cardan_columns_4)
CARDAN_SUBSTITUTE(cardan_substitute_8, cardan_columns_8)
#endif

/*
 * A X = B for symmetric positive definite A = Lᵀ D L, eliminated from the last row up without
 * exchanges, so that zeros of A due to the branches of a tree cause no fill-in. Only the lower
 * triangle of A is read. Efficient for many columns.
 *
 * Returns CARDAN_SINGULAR if a pivot is not positive.
 * Source: R. Featherstone, Rigid Body Dynamics Algorithms, section 6.5.
 */
CARDAN_INLINE int cardan_solve_spd(int n, int m, double *a, double *b, double *scratch)
{
    int c = 0;
    (void)scratch;

    for (int k = n - 1; k >= 0; --k) {
        double *const row = a + k * n;
        if (!(row[k] > 0.0)) return cardan_no_solution(n * m, b);
        row[k] = 1.0 / row[k];
        for (int i = k - 1; i >= 0; --i) {
            const double factor = row[i] * row[k];
            if (factor == 0.0) continue;
            for (int j = 0; j <= i; ++j) a[i * n + j] -= factor * row[j];
            row[i] = factor;
        }
    }
#if defined(__GNUC__)
    for (; c + 8 <= m; c += 8) cardan_substitute_8(n, m, a, b + c);
    for (; c + 4 <= m; c += 4) cardan_substitute_4(n, m, a, b + c);
    for (; c + 2 <= m; c += 2) cardan_substitute_2(n, m, a, b + c);
#endif
    for (; c < m; ++c) cardan_substitute_1(n, m, a, b + c);
    return CARDAN_OK;
}

#if CARDAN_LANES > 1
/* Solve the systems of all lanes one after the other, since their pivots differ. */
CARDAN_INLINE int cardan_solve_lanes(cardan_solver *solve, int n, int m, real *a, real *b,
                                     real *scratch)
{
    double *const lane_a = (double *)scratch, *const lane_b = lane_a + n * n;
    int status = CARDAN_OK;
    for (int lane = 0; lane < CARDAN_LANES; ++lane) {
        for (int k = 0; k < n * n; ++k) lane_a[k] = a[k][lane];
        for (int k = 0; k < n * m; ++k) lane_b[k] = b[k][lane];
        status |= solve(n, m, lane_a, lane_b, lane_b + n * m);
        for (int k = 0; k < n * m; ++k) b[k][lane] = lane_b[k];
    }
    return status;
}
#endif

#endif
