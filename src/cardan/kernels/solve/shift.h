/* Systems (a I - J) x = b of the implicit methods, a real or complex. Coordinates whose rate is a
 * single speed are eliminated first, which leaves a system for the speeds. Part of cardan.
 */
#ifndef CARDAN_SHIFT_H
#define CARDAN_SHIFT_H

#include "run.h"

/* implicit.c: the Jacobian of a run, for the methods that need one */
ptrdiff_t cardan_jacobian_length(const cardan_run *run);
int cardan_jacobian(cardan_run *run, real h, real *jacobian);

/* One system. Its memory must live as long as its factors are used. */
typedef struct cardan_shift {
    ptrdiff_t n, nq;
    const real *jacobian; /* (n, n), must not change between factorization and solve */
    real *rows;           /* (1 + n): number of remaining rows, then their indices */
    real *mate;           /* (n): column of the only entry of an eliminated row, else -1 */
    real *order;          /* (n) row exchanges */
    real *re, *im;        /* (n, n) factors; im is NULL for real a */
    real *b, *c;          /* (n) right-hand side of the reduced system */
} cardan_shift;

/* Size of the memory of a system, and the system laid out in it. */
static inline ptrdiff_t cardan_shift_length(const cardan_run *run, int paired)
{
    const ptrdiff_t n = run->nx;

    return 1 + n * (5 + n + (paired ? n : 0));
}

static inline cardan_shift cardan_shift_in(const cardan_run *run, const real *jacobian,
                                           real *memory, int paired)
{
    const ptrdiff_t n = run->nx;
    cardan_shift at;

    at.n = n;
    at.nq = run->nq;
    at.jacobian = jacobian;
    at.rows = memory;
    at.mate = at.rows + 1 + n;
    at.order = at.mate + n;
    at.b = at.order + n;
    at.c = at.b + n;
    at.re = at.c + n;
    at.im = paired ? at.re + n * n : NULL;
    return at;
}

/* Whether the row and column indices in its memory are valid. */
int cardan_shift_sound(const cardan_shift *at);

/* Factor (a + i b) I - J; returns 1 if it is singular or not finite. */
int cardan_shift_factor(const cardan_shift *at, real a, real b);

/* Solve for the right-hand side x + i y (n) in place; a, b must be those of the factors. */
void cardan_shift_solve(const cardan_shift *at, real a, real b, real *x, real *y);

#endif
