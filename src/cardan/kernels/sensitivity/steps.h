/* Steps of a Runge-Kutta method that a run has taken, computed again.
 *
 * Part of cardan. Caller owns all memory.
 */
#ifndef CARDAN_STEPS_H
#define CARDAN_STEPS_H

#include "run.h"

typedef struct cardan_steps {
    cardan_run *run; /* that took the steps: its functions, signals and sizes */
    ptrdiff_t stages;
    const real *nodes;   /* (stages) */
    const real *weights; /* (stages) */
    const real *matrix;  /* (stages, stages) below the diagonal */
    const real *rows;    /* (count): t, y, r, s at the ends of steps, as the run wrote them */
    ptrdiff_t count;
    ptrdiff_t failed;    /* row of the step that could not be done, -1 */
    real *states;        /* (stages, nx) at which the stages were taken */
    real *slopes;        /* (stages, nx) */
    real *end;           /* (nx) state at the end, before projections */
    real *place;         /* (nx) the same at the positions behind them */
    real *work;          /* of the functions */
} cardan_steps;

int cardan_step_again(cardan_steps *steps, ptrdiff_t k);
cardan_in cardan_step_in(const cardan_steps *steps, const real *t, const real *x);

/* Nodes (stages), weights (stages) and matrix (stages, stages) of methods; return their stages. */
ptrdiff_t cardan_rk4_tableau(real *nodes, real *weights, real *matrix);
ptrdiff_t cardan_rk45_tableau(real *nodes, real *weights, real *matrix);
ptrdiff_t cardan_dop853_tableau(real *nodes, real *weights, real *matrix);

#endif
