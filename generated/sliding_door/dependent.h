/*
 * dependent.h: linear systems of constraints, of which some may follow from others.
 *
 * As in solve.h, after which it is included: A (n x n) and B (n x m) row by row, both overwritten,
 * B by the solution.
 */
#ifndef CARDAN_DEPENDENT_H
#define CARDAN_DEPENDENT_H

#include "solve.h"

/*
 * A X = B for symmetric positive semidefinite A = G M⁻¹ Gᵀ of constraints G, of which some may
 * follow from others. Only the lower triangle of A is read.
 *
 * Every row is measured by the root of its diagonal entry, so that units and masses do not matter;
 * of those of which a part is left, CARDAN_LEAST of what is left of the row that depends least, the
 * largest is taken next: where a row passes through zero beside others that hold the same, it would
 * magnify what they miss, by far more than one at a small angle to those before it. A row whose
 * pivot is below CARDAN_DEPENDENT of its diagonal entry depends on those before it: the sine of its
 * angle to them is the root of that. Its unknown becomes 0, whatever B says there. Rows of which
 * rounding is all that is left, as of a condition across a plane in which everything moves, have no
 * direction: no measure is below CARDAN_VANISHED of the largest. Runs do not ask where a row is about to depend: see hold.c.
 * Source: N. J. Higham, Accuracy and Stability of Numerical Algorithms, section 10.3.
 */
#define CARDAN_DEPENDENT 1e-9
#define CARDAN_VANISHED 1e-15
#define CARDAN_LEAST 1e-3
CARDAN_INLINE int cardan_solve_semidefinite(int n, int m, double *a, double *b, double *scratch)
{
    double *const order = scratch, *const size = scratch + n;
    double largest = 0.0;
    int rank = 0;

    for (int i = 0; i < n; ++i) {
        order[i] = i;
        size[i] = a[i * n + i];
        if (!(size[i] - size[i] == 0.0)) return cardan_no_solution(n * m, b);
        for (int j = 0; j < i; ++j) a[j * n + i] = a[i * n + j];
        largest = (cardan_max)(largest, size[i]);
    }
    for (int i = 0; i < n; ++i) size[i] = (cardan_max)(size[i], CARDAN_VANISHED * largest);
    for (; rank < n; ++rank) {
        /* the largest of the rows that do not depend much more than others on those before them */
        int best = -1;
        double share = CARDAN_DEPENDENT;
        for (int i = rank; i < n; ++i)
            share = (cardan_max)(share, CARDAN_LEAST * (a[i * n + i] / size[i]));
        for (int i = rank; i < n; ++i)
            if (a[i * n + i] > share * size[i]
                && (best < 0 || a[i * n + i] > a[best * n + best]))
                best = i;
        if (best < 0) break;
        cardan_swap_rows(n, a, best, rank);
        cardan_swap_columns(n, a, best, rank);
        cardan_swap_rows(m, b, best, rank);
        cardan_swap(order, best, rank);
        cardan_swap(size, best, rank);

        const double inverse = 1.0 / a[rank * n + rank];
        a[rank * n + rank] = inverse;
        for (int i = rank + 1; i < n; ++i) {
            const double factor = a[i * n + rank] * inverse;
            if (factor == 0.0) continue;
            for (int j = rank + 1; j <= i; ++j) {
                a[i * n + j] -= factor * a[rank * n + j];
                a[j * n + i] = a[i * n + j];
            }
            for (int k = 0; k < m; ++k) b[i * m + k] -= factor * b[rank * m + k];
        }
    }
    for (int i = rank * m; i < n * m; ++i) b[i] = 0.0;
    for (int i = rank - 1; i >= 0; --i)
        for (int k = 0; k < m; ++k) {
            double sum = b[i * m + k];
            for (int j = i + 1; j < rank; ++j) sum -= a[i * n + j] * b[j * m + k];
            b[i * m + k] = sum * a[i * n + i];
        }
    cardan_restore_order(n, m, b, order);
    return CARDAN_OK;
}

/*
 * A X = B by elimination with complete pivoting, for rows of which some may follow from others.
 *
 * Rows are measured by their largest entry, but by no less than the root of CARDAN_VANISHED of the
 * largest of all; one of which less than the root of CARDAN_DEPENDENT is left depends on those
 * before it, and is left out whatever B says there. Unknowns that A leaves free become 0: a basic
 * solution.
 * Source: R. A. Wehage, E. J. Haug, J. Mech. Design 104 (1982).
 */
CARDAN_INLINE int cardan_solve_basic(int n, int m, double *a, double *b, double *scratch)
{
    double *const order = scratch;
    double vanished = 0.0;
    int rank = 0;

    for (int i = 0; i < n * n; ++i) {
        if (!(a[i] - a[i] == 0.0)) return cardan_no_solution(n * m, b);
        vanished = (cardan_max)(vanished, fabs(a[i]));
    }
    vanished *= sqrt(CARDAN_VANISHED);
    for (int i = 0; i < n; ++i) {
        double largest = vanished;
        order[i] = i;
        for (int j = 0; j < n; ++j) largest = (cardan_max)(largest, fabs(a[i * n + j]));
        if (largest == 0.0) continue;
        for (int j = 0; j < n; ++j) a[i * n + j] /= largest;
        for (int k = 0; k < m; ++k) b[i * m + k] /= largest;
    }
    for (; rank < n; ++rank) {
        int row = rank, column = rank;
        for (int i = rank; i < n; ++i)
            for (int j = rank; j < n; ++j)
                if (fabs(a[i * n + j]) > fabs(a[row * n + column])) {
                    row = i;
                    column = j;
                }
        const double pivot = a[row * n + column];
        if (!(pivot * pivot > CARDAN_DEPENDENT)) break;
        cardan_swap_rows(n, a, row, rank);
        cardan_swap_rows(m, b, row, rank);
        cardan_swap_columns(n, a, column, rank);
        cardan_swap(order, column, rank);
        for (int i = rank + 1; i < n; ++i) {
            const double factor = a[i * n + rank] / pivot;
            if (factor == 0.0) continue;
            for (int j = rank + 1; j < n; ++j) a[i * n + j] -= factor * a[rank * n + j];
            for (int k = 0; k < m; ++k) b[i * m + k] -= factor * b[rank * m + k];
        }
    }
    for (int i = rank * m; i < n * m; ++i) b[i] = 0.0;
    for (int i = rank - 1; i >= 0; --i)
        for (int k = 0; k < m; ++k) {
            double sum = b[i * m + k];
            for (int j = i + 1; j < rank; ++j) sum -= a[i * n + j] * b[j * m + k];
            b[i * m + k] = sum / a[i * n + i];
        }
    cardan_restore_order(n, m, b, order);
    return CARDAN_OK;
}

#endif
