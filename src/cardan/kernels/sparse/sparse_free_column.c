/*
 * A free motion (null vector) of the speeds from the factors of sparse.h. Part of cardan.
 *
 * Let E hold the changes of the replaced pivots, so that A + E was factored. Every null vector x of A
 * satisfies (A + E)^-1 E x = x. If A is regular, the left side is of the size of E, which is small.
 * So one solve with right-hand side E v, where v has entries at the replaced speeds, shows whether
 * there is a free motion: it is kept at its size or nearly vanishes.
 */
#include "sparse.h"
#include "sparse_dense.h"

/* a free motion keeps its size (1), anything else nearly vanishes */
static const double RELEVANT = 0.1;

/* The equation whose row, after the exchanges within its supernode, has pivot k. */
static int32_t equation(const cardan_sparse *plan, const cardan_sparse_factors *f, ptrdiff_t k)
{
    ptrdiff_t s = 0, row, high = plan->supernodes;

    while (high - s > 1) {
        const ptrdiff_t middle = s + (high - s) / 2;
        if (plan->start[middle] <= k)
            s = middle;
        else
            high = middle;
    }
    /* exchanges up to this pivot, undone */
    row = k - plan->start[s];
    for (ptrdiff_t j = row; j >= 0; j--) {
        const ptrdiff_t other = f->pivot[plan->start[s] + j];
        row = row == j ? other : row == other ? j : row;
    }
    return plan->order[plan->start[s] + row];
}

int32_t cardan_sparse_free_column(const cardan_sparse *plan, const cardan_sparse_factors *f, double *x)
{
    int32_t most = -1;
    double largest = RELEVANT;

    memset(x, 0, (size_t)plan->n * sizeof(double));
    for (ptrdiff_t w = 0; w < f->weak; w++) {
        const ptrdiff_t k = f->replaced[w];
        const int32_t row = equation(plan, f, k);
        /* unequal entries, so that contributions of several motions do not cancel */
        const double amount = 1 + 0.5 * sin(1 + (double)w);
        if (!plan->multiplier[k]) {
            x[row] += amount * f->shift[w] / (f->rows ? f->rows[row] : 1);
            most = row;
        }
    }
    if (most < 0)
        return -1;
    cardan_sparse_solve(plan, f, 1, x, x);
    most = -1;
    for (ptrdiff_t w = 0; w < f->weak; w++) {
        const int32_t i = plan->order[f->replaced[w]];
        const double magnitude = fabs(x[i]) / (f->columns ? f->columns[i] : 1);
        if (!plan->multiplier[f->replaced[w]] && !(magnitude <= largest))
            largest = magnitude, most = i;
    }
    return most;
}
