/*
 * Solutions by the factors of sparse.h: forward substitution over the supernodes, then backward; for
 * the transposed matrix the other way round. Part of cardan.
 */
#include "sparse.h"
#include "sparse_dense.h"

/* y (n) = P y for the exchanges of a supernode, forwards or backwards */
static void forwards(ptrdiff_t n, const int32_t *pivot, double *y)
{
    for (ptrdiff_t k = 0; k < n; k++) {
        const double swap = y[pivot[k]];
        y[pivot[k]] = y[k];
        y[k] = swap;
    }
}

static void backwards(ptrdiff_t n, const int32_t *pivot, double *y)
{
    for (ptrdiff_t k = n - 1; k >= 0; k--) {
        const double swap = y[pivot[k]];
        y[pivot[k]] = y[k];
        y[k] = swap;
    }
}

/* Subtract the contribution of a solved supernode from the equations of later ones:
 * y -= (rows of x)^T own. */
static void scatter(const cardan_sparse *plan, ptrdiff_t s, const double *x, double *y)
{
    const ptrdiff_t first = plan->start[s], n = plan->start[s + 1] - first;
    const cardan_sparse_run *end = plan->run + plan->run_start[s + 1];

    for (const cardan_sparse_run *run = plan->run + plan->run_start[s]; run < end; run++)
        cardan_product(1, run->size, n, y + first, 1, x + run->at, plan->width[s], y + run->place,
                       0);
}

/* Subtract the contribution of later unknowns from the equations of a supernode:
 * own -= (rows of x) y. */
static void gather(const cardan_sparse *plan, ptrdiff_t s, const double *x, double *y)
{
    const ptrdiff_t first = plan->start[s], n = plan->start[s + 1] - first;
    const cardan_sparse_run *end = plan->run + plan->run_start[s + 1];

    for (const cardan_sparse_run *run = plan->run + plan->run_start[s]; run < end; run++)
        for (ptrdiff_t k = 0; k < n; k++)
            y[first + k] -= cardan_dot(run->size, x + k * plan->width[s] + run->at, y + run->place);
}

/* y becomes the solution for the plain matrix, in order of elimination. */
static void substitute(const cardan_sparse *plan, const cardan_sparse_factors *f, double *y)
{
    for (ptrdiff_t s = 0; s < plan->supernodes; s++) {
        const ptrdiff_t first = plan->start[s], n = plan->start[s + 1] - first;
        const ptrdiff_t width = plan->width[s];
        const double *panel = f->values + plan->panel[s];
        double *block = y + first;

        forwards(n, f->pivot + first, block);
        for (ptrdiff_t k = 0; k < n; k++)
            for (ptrdiff_t i = k + 1; i < n; i++)
                block[i] -= panel[i * width + k] * block[k];
        scatter(plan, s, panel + plan->transposed[s], y);
    }
    for (ptrdiff_t s = plan->supernodes - 1; s >= 0; s--) {
        const ptrdiff_t first = plan->start[s], n = plan->start[s + 1] - first;
        const ptrdiff_t width = plan->width[s];
        const double *panel = f->values + plan->panel[s];
        double *block = y + first;

        gather(plan, s, panel + n, y);
        for (ptrdiff_t k = n - 1; k >= 0; k--) {
            block[k] *= panel[k * width + k];
            for (ptrdiff_t i = 0; i < k; i++)
                block[i] -= panel[i * width + k] * block[k];
        }
        backwards(n, f->exchanged + first, block);
    }
}

/* y becomes the solution for the transposed matrix. */
static void substitute_transposed(const cardan_sparse *plan, const cardan_sparse_factors *f, double *y)
{
    for (ptrdiff_t s = 0; s < plan->supernodes; s++) {
        const ptrdiff_t first = plan->start[s], n = plan->start[s + 1] - first;
        const ptrdiff_t width = plan->width[s];
        const double *panel = f->values + plan->panel[s];
        double *block = y + first;

        forwards(n, f->exchanged + first, block);
        for (ptrdiff_t k = 0; k < n; k++) {
            block[k] *= panel[k * width + k];
            cardan_minus(n - k - 1, block[k], panel + k * width + k + 1, block + k + 1);
        }
        scatter(plan, s, panel + n, y);
    }
    for (ptrdiff_t s = plan->supernodes - 1; s >= 0; s--) {
        const ptrdiff_t first = plan->start[s], n = plan->start[s + 1] - first;
        const ptrdiff_t width = plan->width[s];
        const double *panel = f->values + plan->panel[s];
        double *block = y + first;

        gather(plan, s, panel + plan->transposed[s], y);
        for (ptrdiff_t k = n - 1; k >= 0; k--)
            cardan_minus(k, block[k], panel + k * width, block);
        backwards(n, f->pivot + first, block);
    }
}

void cardan_sparse_solve(const cardan_sparse *plan, const cardan_sparse_factors *f, ptrdiff_t count,
                         const double *b, double *x)
{
    const uint64_t mode = cardan_flush();

    for (ptrdiff_t c = 0; c < count; c++, b += plan->n, x += plan->n) {
        for (ptrdiff_t k = 0; k < plan->n; k++) {
            const int32_t i = plan->order[k];
            f->work[k] = f->rows ? f->rows[i] * b[i] : b[i];
        }
        substitute(plan, f, f->work);
        for (ptrdiff_t k = 0; k < plan->n; k++) {
            const int32_t i = plan->order[k];
            x[i] = f->columns ? f->columns[i] * f->work[k] : f->work[k];
        }
    }
    cardan_restore(mode);
}

void cardan_sparse_solve_transposed(const cardan_sparse *plan, const cardan_sparse_factors *f,
                                ptrdiff_t count, const double *b, double *x)
{
    const uint64_t mode = cardan_flush();

    for (ptrdiff_t c = 0; c < count; c++, b += plan->n, x += plan->n) {
        for (ptrdiff_t k = 0; k < plan->n; k++) {
            const int32_t i = plan->order[k];
            f->work[k] = f->columns ? f->columns[i] * b[i] : b[i];
        }
        substitute_transposed(plan, f, f->work);
        for (ptrdiff_t k = 0; k < plan->n; k++) {
            const int32_t i = plan->order[k];
            x[i] = f->rows ? f->rows[i] * f->work[k] : f->work[k];
        }
    }
    cardan_restore(mode);
}

void cardan_sparse_substitute(const cardan_sparse *plan, const cardan_sparse_factors *f, int transposed,
                              double *y)
{
    if (transposed)
        substitute_transposed(plan, f, y);
    else
        substitute(plan, f, y);
}
