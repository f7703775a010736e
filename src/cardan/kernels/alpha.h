/* The generalized-alpha method on systems with constraints: what its parts share.
 *
 * Part of cardan. Caller owns all memory; everything here lies in `own` of the run.
 */
#ifndef CARDAN_ALPHA_H
#define CARDAN_ALPHA_H

#include "mesh_matrix.h"
#include "run.h"

/* how a step was made, in `now` */
enum {
    ALPHA_STEP,    /* for which a stands */
    ALPHA_MATRIX,  /* step of the factored matrix, 0: there is none */
    ALPHA_RATE,    /* by which the corrections of the last iteration shrank */
    ALPHA_AGE,     /* steps since the matrix was factored */
    ALPHA_HASTE,   /* steps that are to begin with a new one */
    ALPHA_SINCE,   /* steps since their size was last changed */
    ALPHA_WEAK,    /* pivots of the factored matrix that were replaced: of a mesh */
    ALPHA_APART,   /* 1: positions and speeds of a mesh are bound by a matrix each */
    ALPHA_LAME,    /* pivots of the one for speeds that were replaced */
    ALPHA_TURNED,  /* angle by which nodes have turned since the matrix of a mesh was factored */
    ALPHA_EXTENT,  /* of a mesh: the amplitude against which lengths count */
    ALPHA_MIDDLE,  /* (3) of its nodes at the start */
    ALPHA_NOW = ALPHA_MIDDLE + 3
};

typedef struct cardan_alpha {
    real am, af, beta, gamma;
    ptrdiff_t index;    /* 3, or 2: stabilized */
    ptrdiff_t full;     /* 1: a new matrix at every correction; 0: while corrections shrink well */
    ptrdiff_t adaptive;
    ptrdiff_t nq, nu, mp, m, size; /* size: of the largest system */
    const cardan_mesh *mesh; /* elements in tables with a sparse matrix; NULL: a full one */

    /* kept from step to step */
    real *now;       /* ALPHA_NOW numbers */
    real *a;         /* (nu) the accelerations of the method: udot near t + (am - af) h */
    real *udot;      /* (nu) at t */
    real *rise;      /* (nu) by which a grew in the last step, per time */
    real *lam_old;   /* (m) at t_old, then */
    real *lam;       /* (m) at t */
    real *amplitude; /* (nq) largest coordinates of the run so far */
    real *picked;    /* (m) 1 for rows that follow from no others */

    /* of the step that is tried */
    real *a_new, *udot_new, *lam_new;
    real *shift;     /* (nu) what the stabilization takes off the increment */
    real *increment; /* (nu) */
    real *moved;     /* q (nq), T (nu, nu); of a mesh T (places, 9) */
    real *residual;  /* balance (nu), g (mp), rates (m) */
    real *rates;     /* (nq) */

    /* of the factored matrix */
    real *tangent;   /* K C M (nu, nu) each, R G (m, nu) each */
    real *weight;    /* (nu) unit of a speed: the root of the inverse of its inertia */
    real *unit;      /* (m) unit of a row: the inverse of its length in these units */
    real *matrix;    /* (size, size) */
    real *order, *right; /* (size) */
    real *room;      /* (size, nu); of a mesh (nu) */
    real *dx;        /* (nu) */
    real *probe;     /* speeds (nu), balances (2, size), q (nq), T (nu, nu): of differences */

    /* of a mesh, in place of these */
    cardan_mesh_system system;
    cardan_mesh_system settling; /* of speeds, where they are bound apart */
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

/* alpha_sparse.c */
ptrdiff_t cardan_alpha_sparse_lay(const cardan_mesh *mesh, real *own, cardan_alpha *v);
int cardan_alpha_sparse_renew(cardan_run *run, const cardan_alpha *v, real h, real t,
                              const real *y, const real *udot, const real *lam);
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

/* alpha_dense.c */
int cardan_alpha_dense(cardan_run *run);
real cardan_alpha_misfit(cardan_run *run, const cardan_alpha *v, real h, int *status);

#endif
