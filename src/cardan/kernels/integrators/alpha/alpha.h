/* The generalized-alpha method for constrained systems: data and functions its files share.
 *
 * Part of cardan. Caller owns all memory; all arrays lie in `method_memory` of the run.
 */
#ifndef CARDAN_ALPHA_H
#define CARDAN_ALPHA_H

#include "mesh_matrix.h"
#include "run.h"

/* entries of `now`: state of the method */
enum {
    ALPHA_STEP,    /* step size to which a belongs */
    ALPHA_MATRIX,  /* step size of the factored matrix, 0: none */
    ALPHA_RATE,    /* convergence rate of the last Newton iteration */
    ALPHA_AGE,     /* steps since the matrix was factored */
    ALPHA_RENEW,   /* so many of the next steps start with a new matrix */
    ALPHA_FEWEST,  /* mesh: fewest corrections of a step with the matrix, 0: no step yet */
    ALPHA_EXTRA,   /* mesh: corrections beyond the fewest, summed over its steps */
    ALPHA_STEPS_SINCE_CHANGE,   /* steps since the step size last changed */
    ALPHA_WEAK,    /* mesh: number of replaced pivots; if not 0, solutions are refined */
    ALPHA_SPLIT_LEVELS,   /* mesh, 1: separate matrices for positions and for speeds */
    ALPHA_VELOCITY_RANK_LOSS,    /* replaced pivots of the matrix for speeds */
    ALPHA_ROTATION,  /* mesh: angle the nodes have turned since the matrix was factored */
    ALPHA_EXTENT,  /* mesh: reference length for tolerances, see mesh_extent.c */
    ALPHA_MIDDLE,  /* (3) centroid of the nodes at the start */
    ALPHA_NOW = ALPHA_MIDDLE + 3
};

typedef struct cardan_alpha {
    real am, af, beta, gamma;
    ptrdiff_t index;    /* 3, or 2: stabilized */
    ptrdiff_t full;     /* 1: full Newton, a new matrix per correction; 0: modified Newton */
    ptrdiff_t adaptive;
    ptrdiff_t nq, nu, mp, m, size; /* size: of the largest system */
    const cardan_mesh *mesh; /* finite elements with a sparse matrix; NULL: dense matrix */

    /* persistent between steps */
    real *now;       /* ALPHA_NOW numbers */
    real *a;         /* (nu) algorithmic accelerations: udot near t + (am - af) h */
    real *udot;      /* (nu) at t */
    real *rise;      /* (nu) rate of change of a in the last step */
    real *lam_old;   /* (m) multipliers at t_old */
    real *lam;       /* (m) multipliers at t; must follow lam_old in memory */
    real *amplitude; /* (nq) largest absolute coordinates of the run so far; not of a mesh */
    real *picked;    /* (m) 1 for the independent constraint rows in use, 0 for redundant ones */

    real *closing;   /* (mp) what the shift of the last trial closes, for the next prediction */
    real *w;         /* (nz) algorithmic rates of internal states */

    /* trial step */
    real *w_new, *zdot, *gap, *terms; /* (nz) */
    real *slopes;    /* (nz, nz); mesh: (most states of an element, nz) */
    real *block;     /* system of equations of the states that are solved for together */
    real *a_new, *udot_new, *lam_new;
    real *shift;     /* (nu) part the stabilization subtracts from the increment */
    real *increment; /* (nu) */
    real *moved;     /* q (nq), then T (nu, nu); for a mesh T (places, 9) of its last matrix */
    real *residual;  /* balance (nu), g (mp), rates (m) */
    real *rates;     /* (nq) */

    /* factored matrix */
    real *tangent;   /* K, C, M (nu, nu) each, then R, G (m, nu) each */
    real *weight;    /* (nu) scale of a speed: 1 / sqrt(inertia) */
    real *unit;      /* (m) scale of a constraint row: 1 / its norm in scaled speeds */
    real *matrix;    /* (size, size) */
    real *order, *right; /* (size) */
    real *room;      /* workspace (size, nu); for a mesh (nu) */
    real *dx;        /* (nu) correction of the increment */
    real *probe;     /* finite differences: speeds (nu), balances (2, size), q (nq), T (nu, nu) */

    /* mesh: sparse systems in place of these */
    cardan_mesh_system system;
    cardan_mesh_system settling; /* matrix for speeds with ALPHA_SPLIT_LEVELS */
} cardan_alpha;

/* alpha_memory.c */
cardan_alpha cardan_alpha_at(const cardan_run *run);
ptrdiff_t cardan_alpha_length(const cardan_run *run);
int cardan_alpha_sound(const cardan_run *run);

/* alpha_pick.c */
ptrdiff_t cardan_alpha_picked(const cardan_alpha *v, ptrdiff_t rows);
void cardan_alpha_pick(const cardan_alpha *v);
void cardan_alpha_pick_again(const cardan_alpha *v);

/* alpha_matrix.c */
int cardan_alpha_tangent(cardan_run *run, const cardan_alpha *v, real t, const real *y,
                         const real *udot, const real *lam);
ptrdiff_t cardan_alpha_assemble(const cardan_alpha *v, real h);
ptrdiff_t cardan_alpha_matrix(cardan_run *run, real h, real *matrix);
int cardan_alpha_renew(cardan_run *run, const cardan_alpha *v, real h, real t, const real *y,
                       const real *udot, const real *lam);
int cardan_alpha_correct(cardan_run *run, const cardan_alpha *v, real h, real *dx);
int cardan_alpha_shift(const cardan_alpha *v);

/* alpha_sparse.c */
ptrdiff_t cardan_alpha_sparse_lay(const cardan_mesh *mesh, real *memory, cardan_alpha *v);
int cardan_alpha_sparse_sound(const cardan_alpha *v);
int cardan_alpha_sparse_renew(cardan_run *run, const cardan_alpha *v, real h, real t,
                              const real *y, const real *udot, const real *lam);
int cardan_alpha_sparse_place(cardan_run *run, const cardan_alpha *v, real *q, real *tangent_maps);
int cardan_alpha_sparse_shift(const cardan_alpha *v);
int cardan_alpha_sparse_correct(cardan_run *run, const cardan_alpha *v, real h, real *dx);
real cardan_alpha_sparse_turn(const cardan_run *run, const cardan_alpha *v, real h);
int cardan_alpha_sparse_settle(cardan_run *run, const cardan_alpha *v, real h, real t, real *dx);

/* alpha_extent.c */
void cardan_alpha_extent(const cardan_run *run, const cardan_alpha *v, int first);
real cardan_alpha_rounding(const cardan_run *run, const cardan_alpha *v);
real cardan_alpha_sparse_norm(cardan_run *run, const cardan_alpha *v, const real *dx, real rtol,
                              real atol);
int cardan_alpha_first_step(cardan_run *run, const cardan_alpha *v, int order);

/* alpha_newton.c */
int cardan_alpha_restart(cardan_run *run, const cardan_alpha *v, real h);
int cardan_alpha_balance(cardan_run *run, const cardan_alpha *v, real t);
int cardan_alpha_gaps(cardan_run *run, const cardan_alpha *v, real t);
int cardan_alpha_solve(cardan_run *run, const cardan_alpha *v, real h, real t_new);
real cardan_alpha_norm(cardan_run *run, const cardan_alpha *v, const real *dx, real rtol,
                       real atol, int *status);

/* alpha_differences.c */
int cardan_alpha_differences(cardan_run *run, const cardan_alpha *v, real t, const real *y,
                             const real *udot, const real *lam);

/* alpha_internal.c: internal states z' of the trial, and their rates; algorithmic rates for another
 * step size or at the start of a segment; error in units of the tolerance */
int cardan_alpha_internal(cardan_run *run, const cardan_alpha *v, real t);
void cardan_alpha_internal_restart(const cardan_run *run, const cardan_alpha *v, real share, int fresh);
real cardan_alpha_internal_error(const cardan_run *run, const cardan_alpha *v, real h);

/* alpha_dense.c */
int cardan_alpha_dense(cardan_run *run);
real cardan_alpha_misfit(cardan_run *run, const cardan_alpha *v, real h, int *status);

#endif
