/* Systems (a I - J) x = b of the implicit methods, a real or complex, solved without the
 * coordinates whose rate is one speed: what is left is a system of the speeds. Part of cardan.
 */
#ifndef CARDAN_SHIFT_H
#define CARDAN_SHIFT_H

#include "run.h"

/* One system. Its memory lives as long as its factors are wanted. */
typedef struct cardan_shift {
    ptrdiff_t n, nq;
    const real *jacobian; /* (n, n), the same when factors are made and used */
    real *kept;           /* (1 + n): how many rows are kept, and which */
    real *mate;           /* (n): for rows that are not: the column of their one entry, else -1 */
    real *order;          /* (n) exchanges of rows */
    real *re, *im;        /* (n, n) factors; im NULL for real a */
    real *b, *c;          /* (n) right side of what is kept */
} cardan_shift;

/* Numbers of memory that a system needs, and the system in it. */
ptrdiff_t cardan_shift_length(const cardan_run *run, int paired);
cardan_shift cardan_shift_in(const cardan_run *run, const real *jacobian, real *memory, int paired);

/* Whether the rows and columns that its memory speaks of exist. */
int cardan_shift_sound(const cardan_shift *at);

/* Factor (a + i b) I - J; returns 1 where that is singular or holds no numbers. */
int cardan_shift_factor(const cardan_shift *at, real a, real b);

/* x + i y (n) becomes the solution for this right side, at the a, b of the factors. */
void cardan_shift_solve(const cardan_shift *at, real a, real b, real *x, real *y);

#endif
