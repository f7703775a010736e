/*
 * dependent.h: linear systems of possibly redundant constraints.
 *
 * As in solve.h: A (n x n) and B (n x m) are stored row by row and overwritten, B by the solution.
 */
#ifndef CARDAN_DEPENDENT_H
#define CARDAN_DEPENDENT_H

#include "solve.h"

/*
 * A X = B for symmetric positive semidefinite A = G M⁻¹ Gᵀ with constraint rows G, some of which
 * may depend on others. Only the lower triangle of A is read. LDLᵀ with diagonal pivoting:
 *
 * Pivots are compared relative to the original diagonal entry, so units and masses do not matter.
 * Candidates are rows whose relative pivot is at least CARDAN_LEAST times the largest one; the row
 * with the largest absolute pivot among them is next. This avoids rows that pass through zero while
 * others enforce the same condition, since such a row would magnify their errors. A row whose pivot
 * falls below CARDAN_DEPENDENT times its diagonal entry is redundant: that ratio is the squared
 * sine of its angle to the rows before it. Its unknown becomes 0 whatever B contains. Diagonal
 * entries count as at least CARDAN_VANISHED times the largest, because a row of pure rounding, such
 * as a condition normal to a plane in which everything moves, has no direction. Runs do not come
 * here near a loss of rank: see constraint_rank.c.
 * Source: N. J. Higham, Accuracy and Stability of Numerical Algorithms, section 10.3.
 */
#define CARDAN_DEPENDENT CARDAN_ROUNDING(1e-9, 1e-4)
#define CARDAN_VANISHED CARDAN_ROUNDING(1e-15, 1e-6)
#define CARDAN_LEAST 1e-3
CARDAN_INLINE int cardan_solve_semidefinite(int n, int m, double *a, double *b, double *scratch)
{
    double *const order = scratch, *const size = scratch + n;
    double largest = 0.0;
    int rank = 0;

    /* original diagonal as reference; mirror the lower triangle */
    for (int i = 0; i < n; ++i) {
        order[i] = (double)i;
        size[i] = a[i * n + i];
        if (!(size[i] - size[i] == 0.0)) return cardan_no_solution(n * m, b);
        for (int j = 0; j < i; ++j) a[j * n + i] = a[i * n + j];
        largest = (cardan_max)(largest, size[i]);
    }
    for (int i = 0; i < n; ++i) size[i] = (cardan_max)(size[i], CARDAN_VANISHED * largest);
    for (; rank < n; ++rank) {
        /* pivot: the largest among the rows that are not much more dependent than others */
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

        /* eliminate symmetrically, forward substitution along with it */
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
    /* redundant constraints get multiplier 0; back substitution for the others */
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
 * A X = B by elimination with complete pivoting for possibly redundant rows.
 *
 * Rows are scaled by their largest entry, but at least by sqrt(CARDAN_VANISHED) times the largest
 * of all. Elimination stops when all remaining entries fall below sqrt(CARDAN_DEPENDENT): these
 * rows are redundant and ignored whatever B contains. Unknowns that A leaves free become 0 (basic
 * solution).
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
    /* row equilibration, which leaves rows of pure rounding small */
    vanished *= sqrt(CARDAN_VANISHED);
    for (int i = 0; i < n; ++i) {
        double largest = vanished;
        order[i] = (double)i;
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
        /* the largest remaining entry is the pivot; below the limit the rest is redundant */
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
    /* free unknowns 0, back substitution for the others */
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
