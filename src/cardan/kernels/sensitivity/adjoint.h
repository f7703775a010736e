/* Gradient of a cost along a motion: a sweep backward over the steps that a run has taken.
 *
 * Part of cardan. Caller owns all memory.
 *
 * The cost is what the caller begins with, a gradient by the last state, plus the integral of a
 * running cost. Steps are those of a Runge-Kutta method, whose stages are computed again. The gradient
 * is that of the numbers that were computed, with the sizes of the steps as they were: it holds for
 * any tolerance. Steps end with the projections of the run, which are pulled back too. Events lie
 * between two sweeps: what happens there is the caller's.
 * Source: W. W. Hager, Runge-Kutta methods in optimal control and the transformed adjoint system,
 * Numer. Math. 87 (2000) 247-282; J. M. Sanz-Serna, Symplectic Runge-Kutta schemes for adjoint
 * equations, SIAM Review 58 (2016) 3-33.
 */
#ifndef CARDAN_ADJOINT_H
#define CARDAN_ADJOINT_H

#include "run.h"

/* Every product below has the derivatives along coordinates, u, z, then s, r and p as far as there are
 * any of them: weights v times the derivative of a function. */
typedef struct cardan_adjoint {
    cardan_run *run;            /* that took the steps: its functions, signals and sizes */
    cardan_call rates;          /* product with the derivative of rhs (nx weights) */
    cardan_call close_position; /* of close_position (nq + positions), NULL without constraints */
    cardan_call close_velocity; /* of close_velocity (nu + rates) */
    cardan_call running;        /* of the running cost (1), NULL without */
    cardan_call running_cost;   /* (1) */

    ptrdiff_t stages;
    const real *nodes;   /* (stages) */
    const real *weights; /* (stages) */
    const real *matrix;  /* (stages, stages) below the diagonal */

    const real *rows;    /* (count): t, y, r, s at the ends of steps, as the run wrote them */
    ptrdiff_t count;
    ptrdiff_t np;        /* parameters that the products know */

    /* what comes out; all is added up but lam */
    real *lam;           /* (nx) gradient by the last state, then by the first one */
    real *by_p;          /* (np) */
    real *by_s;          /* (ns) by the discrete states at all steps */
    real *by_r;          /* (nr) by inputs that are constant */
    real *by_pieces;     /* by the coefficients of all signals one after the other (pieces, 4) */
    real *cost;          /* (1) integral of the running cost */

    real *memory;        /* cardan_adjoint_length(adjoint, work) numbers */
    ptrdiff_t work;      /* that the functions need */
    ptrdiff_t failed;    /* row of the step that could not be done, -1 */
} cardan_adjoint;

ptrdiff_t cardan_adjoint_length(const cardan_adjoint *adjoint, ptrdiff_t work);
int cardan_adjoint_sweep(cardan_adjoint *adjoint);

/* Nodes (stages), weights (stages) and matrix (stages, stages) of methods; return their stages. */
ptrdiff_t cardan_rk4_tableau(real *nodes, real *weights, real *matrix);
ptrdiff_t cardan_rk45_tableau(real *nodes, real *weights, real *matrix);
ptrdiff_t cardan_dop853_tableau(real *nodes, real *weights, real *matrix);

#endif
