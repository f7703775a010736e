/*
 * A bound of the backward error of all solutions by the factors of sparse.h. Part of cardan.
 *
 * To multiply a solution out takes as long as to find it. Its error is at most what rounding leaves by the
 * sizes of the factors, which are summed up once, while they are made: where these have not grown, all
 * solutions by them are certain.
 */
#include "sparse.h"
#include "sparse_dense.h"
#include <float.h>

/* roundings of a number of the matrix that is scaled, and of a solution in units */
#define SCALED 4

/* Bound what rounding leaves of right-hand sides in the rows of a supernode, of the largest unknown.
 *
 * The solution by computed L and U solves a system whose matrix differs by no more than 3 t eps |L| |U|
 * with t terms in the longest sum of a row. The products of a supernode with those behind it are counted
 * with these: `sums` has, for every supernode, their sizes and how many terms they have. Sums of all
 * sizes take the place of largest ones, so that none hides what is not a number.
 * Source: N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., theorem 9.4.
 */
void cardan_sparse_bound(const cardan_sparse *plan, ptrdiff_t s, const cardan_panel *panel, double *sums,
                         double *left)
{
    const ptrdiff_t n = panel->n, later = panel->later;
    const cardan_sparse_run *end = plan->run + plan->run_start[s + 1];
    double lower = (double)n, upper = 0, terms, here;

    for (ptrdiff_t k = 0; k < n; k++) {
        const double *row = panel->d + k * n;
        lower += cardan_sum_of_sizes(k, row);
        /* diagonals are reciprocals */
        upper += 1 / fabs(row[k]) + cardan_sum_of_sizes(n - k - 1, row + k + 1);
    }
    upper += cardan_sum_of_sizes(n * later, panel->u);
    lower += cardan_sum_of_sizes(n * later, panel->lt);
    here = lower * upper;
    for (const cardan_sparse_run *run = plan->run + plan->run_start[s]; run < end; run++) {
        sums[2 * run->owner] += here;
        sums[2 * run->owner + 1] += (double)n;
    }
    terms = sums[2 * s + 1] + (double)(n + later + SCALED);
    here = 3 * terms * DBL_EPSILON * (sums[2 * s] + here);
    /* what is not a number stays: no supernode after it makes the solution certain */
    if (here > *left || here != here)
        *left = here;
}
