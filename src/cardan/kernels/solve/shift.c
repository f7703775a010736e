/* Systems (a I - J) x = b; see shift.h. Part of cardan. Caller owns all memory.
 *
 * If row i of J has a single entry v, in column m of a speed, then x_i = (b_i + v x_m) / a.
 * Substituting this into the other rows eliminates half of the unknowns of most mechanisms, and 7/8
 * of the work. The only divisor is a, so this is as stable as factoring the reduced matrix.
 */
#include "shift.h"
#include "linear.h"

int cardan_shift_sound(const cardan_shift *at)
{
    const real last = (real)(at->n - 1);

    return cardan_places_fit(at->rows, 1, 0, (real)at->n)
           && cardan_places_fit(at->rows + 1, at->n, 0, last)
           && cardan_places_fit(at->mate, at->n, -1, last)
           && cardan_places_fit(at->order, at->n, 0, last);
}

/* Column of the only entry of row i if it is a speed or internal state, else -1. */
static ptrdiff_t mate_of(const cardan_shift *at, ptrdiff_t i)
{
    const real *row = at->jacobian + i * at->n;
    ptrdiff_t pivot_row = -1;

    for (ptrdiff_t j = 0; j < at->n; j++)
        if (row[j] != 0) {
            if (pivot_row >= 0 || j < at->nq)
                return -1;
            pivot_row = j;
        }
    return pivot_row;
}

/* Select the rows that remain. `order` temporarily stores their index in the reduced system. */
static ptrdiff_t choose(const cardan_shift *at)
{
    ptrdiff_t count = 0;

    for (ptrdiff_t i = 0; i < at->n; i++) {
        at->mate[i] = i < at->nq ? (real)mate_of(at, i) : -1;
        if (at->mate[i] >= 0)
            continue;
        at->order[i] = (real)count;
        at->rows[++count] = (real)i;
    }
    at->rows[0] = (real)count;
    return count;
}

int cardan_shift_factor(const cardan_shift *at, real a, real b)
{
    const ptrdiff_t n = at->n, count = choose(at);
    const real size = 1 / (a * a + b * b), p = a * size, q = -b * size;

    /* reduced matrix; p + i q = 1 / (a + i b) */
    for (ptrdiff_t k = 0; k < count; k++) {
        const real *row = at->jacobian + (ptrdiff_t)at->rows[1 + k] * n;
        real *re = at->re + k * count, *im = at->im ? at->im + k * count : NULL;
        for (ptrdiff_t j = 0; j < count; j++) {
            re[j] = j == k ? a : 0;
            if (im)
                im[j] = j == k ? b : 0;
        }
        for (ptrdiff_t j = 0; j < n; j++) {
            const ptrdiff_t mate = (ptrdiff_t)at->mate[j];
            if (row[j] == 0)
                continue;
            /* a remaining unknown, or an eliminated one expressed by its speed */
            if (mate < 0) {
                re[(ptrdiff_t)at->order[j]] -= row[j];
            } else {
                const ptrdiff_t to = (ptrdiff_t)at->order[mate];
                const real through = row[j] * at->jacobian[j * n + mate];
                re[to] -= through * p;
                if (im)
                    im[to] -= through * q;
            }
        }
    }
    return at->im ? cardan_factor_complex(count, at->re, at->im, at->order)
                  : cardan_factor(count, at->re, at->order);
}

void cardan_shift_solve(const cardan_shift *at, real a, real b, real *x, real *y)
{
    const ptrdiff_t n = at->n, count = (ptrdiff_t)at->rows[0];
    const real size = 1 / (a * a + b * b), p = a * size, q = -b * size;

    /* right-hand sides of the eliminated rows divided by a + i b */
    for (ptrdiff_t j = 0; j < at->nq; j++)
        if (at->mate[j] >= 0) {
            const real value = x[j];
            x[j] = value * p - (y ? y[j] * q : 0);
            if (y)
                y[j] = y[j] * p + value * q;
        }
    /* their contribution to the right-hand side of the reduced system */
    for (ptrdiff_t k = 0; k < count; k++) {
        const ptrdiff_t i = (ptrdiff_t)at->rows[1 + k];
        const real *row = at->jacobian + i * n;
        at->b[k] = x[i];
        at->c[k] = y ? y[i] : 0;
        for (ptrdiff_t j = 0; j < at->nq; j++)
            if (at->mate[j] >= 0) {
                at->b[k] += row[j] * x[j];
                if (y)
                    at->c[k] += row[j] * y[j];
            }
    }
    if (y)
        cardan_substitute_complex(count, at->re, at->im, at->order, at->b, at->c);
    else
        cardan_substitute(count, at->re, at->order, at->b);
    for (ptrdiff_t k = 0; k < count; k++) {
        const ptrdiff_t i = (ptrdiff_t)at->rows[1 + k];
        x[i] = at->b[k];
        if (y)
            y[i] = at->c[k];
    }
    /* recover the eliminated coordinates from their speeds */
    for (ptrdiff_t j = 0; j < at->nq; j++) {
        const ptrdiff_t mate = (ptrdiff_t)at->mate[j];
        if (mate >= 0) {
            const real v = at->jacobian[j * n + mate];
            x[j] += v * (x[mate] * p - (y ? y[mate] * q : 0));
            if (y)
                y[j] += v * (y[mate] * p + x[mate] * q);
        }
    }
}
