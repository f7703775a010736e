/*
 * Signs of the eigenvalues of symmetric panels. Part of cardan.
 *
 * By Sylvester and Haynsworth the signs of the eigenvalues of a matrix are those of the pivot blocks
 * of its symmetric elimination. The blocks are the D of the panels, taken before they are eliminated
 * themselves; each is factored here symmetrically with 1x1 and 2x2 pivots.
 * Source: J. R. Bunch, L. Kaufman, Math. Comp. 31 (1977) 163-179, partial pivoting.
 */
#include "sparse.h"
#include "sparse_dense.h"

/* a 1x1 pivot is taken if it is at least this fraction of the largest entry beside it */
#define ALPHA 0.6403882032022076

/* The symmetric matrix that remains: rows and columns k to n - 1 of m. */
typedef struct reduced_block {
    ptrdiff_t n, k;
    double *m;     /* n x n, both halves */
    double *noise; /* (n) diagonal entries up to this size count as zero */
} reduced_block;

/* The largest number beside the diagonal in column j, and its row. */
static double largest_off_diagonal(const reduced_block *x, ptrdiff_t j, ptrdiff_t *where)
{
    double most = 0;

    for (ptrdiff_t i = x->k; i < x->n; i++)
        if (i != j && fabs(x->m[i * x->n + j]) > most) {
            most = fabs(x->m[i * x->n + j]);
            *where = i;
        }
    return most;
}

/* Rows and columns i and j change places. */
static void swap(const reduced_block *x, ptrdiff_t i, ptrdiff_t j)
{
    const double noise = x->noise[i];

    x->noise[i] = x->noise[j], x->noise[j] = noise;
    for (ptrdiff_t c = 0; c < x->n; c++) {
        const double saved = x->m[i * x->n + c];
        x->m[i * x->n + c] = x->m[j * x->n + c];
        x->m[j * x->n + c] = saved;
    }
    for (ptrdiff_t r = 0; r < x->n; r++) {
        const double saved = x->m[r * x->n + i];
        x->m[r * x->n + i] = x->m[r * x->n + j];
        x->m[r * x->n + j] = saved;
    }
}

/* Eliminate row k. */
static void eliminate_one(const reduced_block *x)
{
    const ptrdiff_t n = x->n, k = x->k;
    const double *row = x->m + k * n;

    for (ptrdiff_t i = k + 1; i < n; i++)
        cardan_minus(n - k - 1, row[i] / row[k], row + k + 1, x->m + i * n + k + 1);
}

/* Eliminate rows k and k + 1 together. */
static void eliminate_two(const reduced_block *x)
{
    const ptrdiff_t n = x->n, k = x->k;
    const double *one = x->m + k * n, *two = one + n;
    const double a = one[k] / one[k + 1], c = two[k + 1] / one[k + 1];
    const double size = 1 / (one[k + 1] * (a * c - 1));

    for (ptrdiff_t i = k + 2; i < n; i++) {
        const double p = (c * one[i] - two[i]) * size, q = (a * two[i] - one[i]) * size;
        cardan_minus(n - k - 2, p, one + k + 2, x->m + i * n + k + 2);
        cardan_minus(n - k - 2, q, two + k + 2, x->m + i * n + k + 2);
    }
}

/* Bring a pivot to row k. Returns how many rows it has, 0 where nothing but noise is left. */
static int choose(const reduced_block *x)
{
    const ptrdiff_t n = x->n, k = x->k;
    const double diagonal = fabs(x->m[k * n + k]);
    ptrdiff_t other = k, ignored = k;
    const double most = largest_off_diagonal(x, k, &other);
    double next;

    if (diagonal <= x->noise[k] && most <= x->noise[k])
        return 0;
    /* a diagonal that is no number too: of the last row there is no other */
    if (!(diagonal < ALPHA * most))
        return 1;
    next = largest_off_diagonal(x, other, &ignored);
    if (diagonal * next >= ALPHA * most * most)
        return 1;
    if (fabs(x->m[other * n + other]) >= ALPHA * next) {
        swap(x, k, other);
        return 1;
    }
    swap(x, k + 1, other);
    return 2;
}

void cardan_sparse_signs(ptrdiff_t n, const double *d, double *work, cardan_sparse_factors *f)
{
    reduced_block x = {n, 0, work + n, work};

    memcpy(x.m, d, (size_t)(n * n) * sizeof(double));
    while (x.k < n) {
        const int rows = choose(&x);
        if (rows == 2) {
            /* pivots of two rows are taken where their determinant is negative */
            f->positive++, f->negative++;
            eliminate_two(&x);
        } else if (rows == 1) {
            if (x.m[x.k * n + x.k] > 0)
                f->positive++;
            else
                f->negative++;
            eliminate_one(&x);
        }
        x.k += rows ? rows : 1;
    }
}
