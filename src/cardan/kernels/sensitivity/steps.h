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
    ptrdiff_t implicit;  /* 1: stages depend on each other, see stages.c */
    const real *nodes;   /* (stages) */
    const real *weights; /* (stages) */
    const real *matrix;  /* (stages, stages), of explicit methods below the diagonal */
    const real *rows;    /* (count): t, y, r, s at the ends of steps, as the run wrote them */
    ptrdiff_t count;
    ptrdiff_t failed;    /* row of the step that could not be done, -1 */
    real *states;        /* (stages, nx) at which the stages were taken */
    real *slopes;        /* (stages, nx) */
    real *end;           /* (nx) state at the end, before projections */
    real *place;         /* (nx) the same at the positions behind them */
    real *system;        /* cardan_stages_length numbers, of implicit methods */
    real *work;          /* of the functions */
} cardan_steps;

int cardan_step_again(cardan_steps *steps, ptrdiff_t k);
cardan_in cardan_step_in(const cardan_steps *steps, const real *t, const real *x);
int cardan_rates_at(const cardan_steps *steps, real t, const real *x, real *rates);

/* stages.c: the linear system of the stages of an implicit method, I - h A J */
ptrdiff_t cardan_stages_length(const cardan_run *run, ptrdiff_t stages);
int cardan_stages_solve(const cardan_steps *steps, ptrdiff_t k);
void cardan_stages_forward(const cardan_steps *steps, real *change);
void cardan_stages_backward(const cardan_steps *steps, real *weights);
void cardan_stage_lengths(const cardan_steps *steps, ptrdiff_t stage, real *change);

/* The change (4) of a quaternion behind its scaling to length 1, or the gradient by what it was
 * before: both are the same. q: either of them; length: what it was. */
static inline void cardan_unit_change(const real *q, real length, real *change)
{
    const real along = cardan_dot(q, change, 4) / cardan_dot(q, q, 4);

    for (int j = 0; j < 4; j++)
        change[j] = (change[j] - along * q[j]) / length;
}

/* Nodes (stages), weights (stages) and matrix (stages, stages) of methods; return their stages. */
ptrdiff_t cardan_rk4_tableau(real *nodes, real *weights, real *matrix);
ptrdiff_t cardan_rk45_tableau(real *nodes, real *weights, real *matrix);
ptrdiff_t cardan_dop853_tableau(real *nodes, real *weights, real *matrix);
ptrdiff_t cardan_radau_tableau(real *nodes, real *weights, real *matrix);

#endif
