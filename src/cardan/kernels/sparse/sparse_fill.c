/*
 * The numbers of a matrix in the panels of sparse.h, before anything is eliminated. Part of cardan.
 */
#include "sparse.h"
#include "sparse_dense.h"

/* Copy a block of the matrix into a part of its panel, whose rows are `width` long, scaled by the units of
 * its rows and columns. */
static void load(const cardan_sparse_load *item, const double *a, const cardan_sparse_factors *f,
                 ptrdiff_t width)
{
    const double *columns = f->columns ? f->columns + item->column : NULL, *from = a + item->from;
    double *to = f->values + item->to;

    for (ptrdiff_t i = 0; i < item->rows; i++, from += item->stride) {
        const double row = f->rows ? f->rows[item->row + i] : 1;
        if (item->transposed)
            for (ptrdiff_t j = 0; j < item->columns; j++)
                to[j * width] = row * from[j] * (columns ? columns[j] : 1);
        else if (columns)
            cardan_scaled(item->columns, row, from, columns, to);
        else
            for (ptrdiff_t j = 0; j < item->columns; j++)
                to[j] = row * from[j];
        to += item->transposed ? 1 : width;
    }
}

/* Fill a panel with the numbers of the matrix, before any supernode is subtracted from it. */
void cardan_sparse_fill(const cardan_sparse *plan, ptrdiff_t s, const double *a,
                        cardan_sparse_factors *f)
{
    const cardan_panel to = cardan_panel_of(plan, s, f->values);

    memset(to.d, 0, (size_t)(to.n * (to.n + 2 * to.later)) * sizeof(double));
    memset(f->scale + to.first, 0, (size_t)to.n * sizeof(double));
    for (ptrdiff_t i = plan->load_start[s]; i < plan->load_start[s + 1]; i++)
        load(plan->load + i, a, f, f->values + plan->load[i].to < to.u ? to.n : to.later);
}
