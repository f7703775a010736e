/* The energy-momentum method on elements in tables: what its parts share.
 *
 * Part of cardan. Caller owns all memory; everything here lies in `own` of the run.
 */
#ifndef CARDAN_CONSERVING_H
#define CARDAN_CONSERVING_H

#include "mesh_matrix.h"
#include "run.h"

/* how a step was made, in `now` */
enum {
    CONSERVING_MATRIX, /* step of the factored matrix, 0: there is none */
    CONSERVING_WEAK,   /* pivots of it that were replaced */
    CONSERVING_SINCE,  /* steps since the start of the segment */
    CONSERVING_ENERGY, /* of everything at the start of the segment */
    CONSERVING_EXCESS, /* by how much there is more at t: roundings */
    CONSERVING_UNMET,  /* energies that corrections of forces make up for, without signs */
    CONSERVING_SHARE,  /* of these to add, so that roundings do not add up */
    CONSERVING_RATES,  /* of momenta of the trial over its step, without signs */
    CONSERVING_NOW
};
typedef struct cardan_conserving {
    const cardan_mesh *mesh;
    const real *down;     /* (3) direction of gravity, of length 1; zeros without */
    const real *symmetry; /* (groups) common motions that change no element: 0, 3, 6 */
    ptrdiff_t nq, nu, mp, m, elements;
    ptrdiff_t widest; /* speeds of a place, at most */
    int coupled;      /* 1: inertia of some elements couples places */
    real last; /* the last step, 0: there is none */

    /* kept from step to step */
    real *now;     /* CONSERVING_NOW numbers */
    real *mass;    /* (nu, widest) rows of every place, along its own axes */
    real *pose;    /* (places) 1: a node */
    real *lam_old; /* (m) at t_old, then */
    real *lam;     /* (m) at t */
    real *middle;  /* (m) in the middle of the last step */
    real *rise;    /* (nu) by which u grew in the last step, per time */
    real *open;    /* (mp) g at t */

    /* of the step that is tried */
    real *eta;      /* (nu) the increment: rotations along body axes, translations in the ground */
    real *lam_new;  /* (m) */
    real *half;     /* (nq) half way */
    real *mean;     /* (nu) speeds there, eta / h */
    real *before;   /* (elements) potential at the start */
    real *after;    /* (elements) at the end */
    real *missing;  /* (nu) what is missing in the balance of momenta, per time */
    real *gaps;     /* balance (nu), g (mp), rates (m) at the end */
    real *dx;       /* (nu) */
    real *element;  /* (2 nu) of the widest element */
    real *momenta;  /* of elements whose inertia couples places, along body axes: at the start (nu), */
    real *momenta_new; /* at the end (nu), */
    real *slopes;   /* what acts besides as their inertia changes (nu) */
    real *speeds_half;   /* (2 nu) speeds of the start and the end at the pose half way */
    real *start;    /* udot (nu), lam (m) */
    cardan_mesh_system system;
} cardan_conserving;

static inline void cardan_cross(const real *a, const real *b, real *c)
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

/* A position that nothing moves from. */
static inline cardan_state cardan_conserving_state(const cardan_run *run, real t, const real *q)
{
    const cardan_state at = {.t = t, .q = q, .s = run->s, .r = run->r};

    return at;
}

/* conserving.c */
cardan_conserving cardan_conserving_at(const cardan_run *run);

/* conserving_motion.c */
void cardan_rotation(const real *quaternion, real *R);
void cardan_conserving_turn(const cardan_conserving *v, const real *q, const real *u, real *out);
int cardan_conserving_move(cardan_run *run, const cardan_conserving *v, real h);
void cardan_conserving_momenta(const cardan_run *run, const cardan_conserving *v, real h);

/* conserving_inertia.c */
int cardan_conserving_masses(const cardan_run *run, const cardan_conserving *v);
int cardan_conserving_coupled(const cardan_run *run, const cardan_conserving *v, int start);

/* conserving_forces.c */
int cardan_conserving_energy(const cardan_run *run, const cardan_conserving *v, real *energy);
int cardan_conserving_gaps(const cardan_run *run, const cardan_conserving *v, real t,
                           const real *y);
int cardan_conserving_potentials(const cardan_run *run, const cardan_conserving *v, real t,
                                 const real *q, real *potentials);
int cardan_conserving_forces(const cardan_run *run, const cardan_conserving *v, real t);

/* conserving_newton.c */
int cardan_conserving_solve(cardan_run *run, const cardan_conserving *v, real h, real t_new);

#endif
