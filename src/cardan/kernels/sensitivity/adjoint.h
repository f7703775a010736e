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

#include "steps.h"

/* Every product below has the derivatives along coordinates, u, z, then s, r and p as far as there are
 * any of them: weights v times the derivative of a function. */
typedef struct cardan_adjoint {
    struct cardan_steps *steps;
    cardan_call rates;          /* product with the derivative of rhs (nx weights) */
    cardan_call close_position; /* of close_position (nq + positions), NULL without constraints */
    cardan_call close_velocity; /* of close_velocity (nu + rates) */
    cardan_call integrand;      /* of the running cost (1), NULL without */
    cardan_call integrand_value;   /* (1) */
    ptrdiff_t np;               /* parameters that the products know */

    /* what comes out; all is added up but lam */
    real *lam;           /* (nx) gradient by the last state, then by the first one */
    real *by_p;          /* (np) */
    real *by_s;          /* (ns) by the discrete states at all steps */
    real *by_r;          /* (nr) by inputs that are constant */
    real *by_coefficients;     /* by the coefficients of all signals one after the other (pieces, 4) */
    real *cost;          /* (1) integral of the running cost */

    real *pulled;        /* (CARDAN_MOST_STAGES, nx) gradients by the states of the stages */
    real *weights;       /* (CARDAN_MOST_STAGES, nx) gradients by slopes of coupled stages; of a pass
                            those of the running cost by its stages */
    real *v;             /* (nx + positions + rates) weights of a product */
    real *out;           /* (nx + ns + nr + np) its result */
} cardan_adjoint;

int cardan_adjoint_sweep(cardan_adjoint *adjoint);
int cardan_pull_projection(const cardan_adjoint *adjoint, real t, const real *end, const real *place,
                           real factor, real *lam);

#endif
