/* What the two files of the energy-keeping midpoint rule share: its memory and its equations.
 *
 * Part of cardan. Caller owns all memory.
 */
#ifndef CARDAN_MIDPOINT_H
#define CARDAN_MIDPOINT_H

#include "explicit.h"
#include <float.h>

/* roundings of the energies that count as none */
#define BALANCED (4 * DBL_EPSILON)

/* kept from step to step, before everything else in the method's memory */
enum { ENERGY, WORK, SIZE, SCALE, NOISE, KINETIC, INVERTED, FASTEST, MEMORY };

/* Parts of the method's own memory; size = nx + 1, of x1 and nu. */
typedef struct room {
    ptrdiff_t size;
    real *memory;     /* (KEPT) energy and work at the start of the segment, the sum of energies
                       without signs, what a residual is divided by, what roundings of the state do
                       to the energy, that of motion, whether there is `inverse`, the largest speed
                       of the run so far */
    real *inverse;  /* (size, size) of the matrix of the equations */
    real *matrix;   /* (size, 2 size) */
    real *z;        /* (size) x1 in the chart, nu */
    real *residual; /* (size) */
    real *change;   /* (size) of z */
    real *image;    /* (size) */
    real *direction; /* (nu) d, a unit vector or 0 */
    real *end;      /* (n) state at x1, closed */
} room;

/* What a step solves for: from x0 in the chart to t_new. */
typedef struct problem {
    const real *base; /* (n) */
    real h, t_new;
    real speed;   /* against which um counts */
    real missing; /* energy, as of the last residual */
    int motionless;  /* um along d is too slow to bring or take energy */
    real lever;   /* what of it stands in a residual, relative to speeds */
} problem;

int cardan_midpoint_residual(cardan_run *run, const room *at, problem *step, real *residual);
int cardan_midpoint_solve(cardan_run *run, const room *at, problem *step, int untried);

#endif
