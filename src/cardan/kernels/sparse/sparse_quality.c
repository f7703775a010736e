/*
 * Residuals, iterative refinement, determinant and smallest singular value by the factors of
 * sparse.h. Part of cardan.
 *
 * Refinement solves for the residual with the same factors until the backward error is small enough
 * or no longer falls. It makes up for replaced pivots: the factors are those of a nearby matrix.
 */
#include "sparse.h"
#include "sparse_dense.h"

void cardan_sparse_multiply(const cardan_sparse *plan, const double *a, const double *x, double *y)
{
    for (ptrdiff_t block = 0; block < plan->blocks; block++) {
        const double *row = a + plan->at[block];
        for (ptrdiff_t i = plan->first[block]; i < plan->first[block + 1]; i++) {
            double sum = 0;
            for (ptrdiff_t pair = plan->row[block]; pair < plan->row[block + 1]; pair++) {
                const int32_t column = plan->column[pair], from = plan->first[column];
                const ptrdiff_t n = plan->first[column + 1] - from;
                sum += cardan_dot(n, row, x + from);
                row += n;
            }
            y[i] = sum;
        }
    }
}

void cardan_sparse_multiply_transposed(const cardan_sparse *plan, const double *a, const double *x,
                                       double *y)
{
    for (ptrdiff_t i = 0; i < plan->n; i++)
        y[i] = 0;
    for (ptrdiff_t block = 0; block < plan->blocks; block++) {
        const double *row = a + plan->at[block];
        for (ptrdiff_t i = plan->first[block]; i < plan->first[block + 1]; i++)
            for (ptrdiff_t pair = plan->row[block]; pair < plan->row[block + 1]; pair++) {
                const int32_t column = plan->column[pair];
                for (ptrdiff_t j = plan->first[column]; j < plan->first[column + 1]; j++)
                    y[j] += *row++ * x[i];
            }
    }
}

double cardan_sparse_residual(const cardan_sparse *plan, const cardan_sparse_factors *f,
                              const double *a, const double *b, const double *x, double *r)
{
    double most = 0, size = 0;
    int finite = 1;

    for (ptrdiff_t block = 0; block < plan->blocks; block++) {
        const double *row = a + plan->at[block];
        for (ptrdiff_t i = plan->first[block]; i < plan->first[block + 1]; i++) {
            const double unit = f->rows ? f->rows[i] : 1;
            double sum = fabs(b[i]), product = 0;
            for (ptrdiff_t pair = plan->row[block]; pair < plan->row[block + 1]; pair++) {
                const int32_t column = plan->column[pair], from = plan->first[column];
                const ptrdiff_t n = plan->first[column + 1] - from;
                product += cardan_dot_sizes(n, row, x + from, &sum);
                row += n;
            }
            r[i] = b[i] - product;
            /* fmax would drop a NaN, so it is noted separately */
            finite = finite && r[i] - r[i] == 0;
            if (fabs(r[i]) * unit > most)
                most = fabs(r[i]) * unit;
            if (sum * unit > size)
                size = sum * unit;
        }
    }
    if (!finite)
        return INFINITY;
    return most > 0 ? most / fmax(size, CARDAN_LEAST) : 0;
}

double cardan_sparse_refine(const cardan_sparse *plan, const cardan_sparse_factors *f,
                            const double *a, const double *b, double enough, ptrdiff_t steps,
                            double *x, double *room)
{
    double *r = room, *better = room + plan->n;
    double error = cardan_sparse_residual(plan, f, a, b, x, r), next;

    for (ptrdiff_t step = 0; step < steps && error > enough; step++) {
        cardan_sparse_solve(plan, f, 1, r, better);
        for (ptrdiff_t i = 0; i < plan->n; i++)
            better[i] += x[i];
        next = cardan_sparse_residual(plan, f, a, b, better, r);
        if (!(next < error))
            break;
        memcpy(x, better, (size_t)plan->n * sizeof(double));
        error = next;
    }
    return error;
}

double cardan_sparse_perturbation(const cardan_sparse *plan, const cardan_sparse_factors *f,
                             const double *b, const double *x, int32_t *unknown)
{
    double most = 0, size = 0;

    *unknown = -1;
    for (ptrdiff_t w = 0; w < f->weak; w++) {
        const int32_t i = plan->order[f->replaced[w]];
        const double backward = fabs(f->shift[w] * x[i]) / (f->columns ? f->columns[i] : 1);
        if (backward > most || backward != backward)
            most = backward, *unknown = i;
    }
    for (ptrdiff_t i = 0; i < plan->n; i++)
        size = fmax(size, fabs(f->rows ? f->rows[i] * b[i] : b[i]));
    return *unknown < 0 ? 0 : most / size;
}

int cardan_sparse_sound(const cardan_sparse *plan, const cardan_sparse_factors *f, double weak)
{
    int sound = weak >= 0 && weak <= (double)plan->n;

    for (ptrdiff_t s = 0; s < plan->supernodes; s++)
        for (ptrdiff_t k = plan->start[s], n = plan->start[s + 1] - k; k < plan->start[s + 1]; k++)
            sound = sound && f->pivot[k] >= 0 && f->pivot[k] < n && f->exchanged[k] >= 0
                    && f->exchanged[k] < n;
    for (ptrdiff_t k = 0; k < plan->n; k++)
        sound = sound && f->replaced[k] >= 0 && f->replaced[k] < plan->n;
    return sound;
}

double cardan_sparse_determinant(const cardan_sparse *plan, const cardan_sparse_factors *f,
                                 double *sign)
{
    double sum = 0;

    *sign = 1;
    for (ptrdiff_t s = 0; s < plan->supernodes; s++)
        for (ptrdiff_t k = 0; k < plan->start[s + 1] - plan->start[s]; k++) {
            /* the diagonal holds the reciprocals of pivots */
            const ptrdiff_t n = plan->start[s + 1] - plan->start[s];
            const double inverse = f->values[plan->panel[s] + k * n + k];
            if ((inverse < 0) != (f->pivot[plan->start[s] + k] != k))
                *sign = -*sign;
            if (f->exchanged[plan->start[s] + k] != k)
                *sign = -*sign;
            sum -= log(fabs(inverse));
        }
    for (ptrdiff_t i = 0; i < plan->n; i++) {
        if (f->rows)
            sum -= log(f->rows[i]);
        if (f->columns)
            sum -= log(f->columns[i]);
    }
    return sum;
}

/* Make x of length 1. Returns the length it had. */
static double normalize(ptrdiff_t n, double *x)
{
    double most = 0, length;

    for (ptrdiff_t i = 0; i < n; i++)
        most = fabs(x[i]) > most ? fabs(x[i]) : most;
    if (most == 0)
        return 0;
    for (ptrdiff_t i = 0; i < n; i++)
        x[i] /= most;
    length = sqrt(cardan_dot(n, x, x));
    for (ptrdiff_t i = 0; i < n; i++)
        x[i] /= length;
    return most * length;
}

double cardan_sparse_smallest(const cardan_sparse *plan, const cardan_sparse_factors *f,
                              ptrdiff_t steps, double *x)
{
    const uint64_t mode = cardan_flush();
    double *y = f->work, grown = 0;

    for (ptrdiff_t k = 0; k < plan->n; k++)
        y[k] = x[plan->order[k]];
    /* inverse iteration with a^T a, `steps` times: converges to the smallest singular value */
    for (ptrdiff_t step = 0; step < steps; step++) {
        (void)normalize(plan->n, y);
        cardan_sparse_substitute(plan, f, 1, y);
        (void)normalize(plan->n, y);
        cardan_sparse_substitute(plan, f, 0, y);
        grown = normalize(plan->n, y);
    }
    for (ptrdiff_t k = 0; k < plan->n; k++)
        x[plan->order[k]] = y[k];
    cardan_restore(mode);
    return grown > 0 ? 1 / grown : 0;
}
