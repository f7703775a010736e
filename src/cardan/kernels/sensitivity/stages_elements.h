/* The iterations for stages over elements: their matrices, and what they are solved with.
 *
 * Part of cardan. Caller owns all memory.
 */
#ifndef CARDAN_STAGES_ELEMENTS_H
#define CARDAN_STAGES_ELEMENTS_H

#include "mesh_calls.h"
#include "steps.h"

typedef struct cardan_element_stages {
    const cardan_mesh *mesh;
    cardan_mesh doubled; /* the mesh with the plan of pairs */
    cardan_sparse pairs;
    real *h;             /* (1) of the step */
    real *powers[3];     /* see cardan_mesh_powers */
    real *tables;        /* of the plan of pairs */
    cardan_mesh_system alone, pair;
    real *solution;      /* (nu + m) accelerations and multipliers, then memory of their solution */
    real *padded;        /* (n) */
    real *product;       /* (4, n) */
    real *along;         /* (3, nu) changes along the speeds */
    real *before;        /* (3, nu) the same before a system is solved for them */
    real *speeds;        /* (3, nu) */
    real *moved;         /* (nq) */
    real *missing;       /* (3, nx) in the equations */
    real *applied;       /* (3, nx) */
} cardan_element_stages;

/* Point into a block, NULL: only measure. Returns how many numbers that takes. */
ptrdiff_t cardan_element_stages_lay(const cardan_run *run, real *memory, cardan_element_stages *at);
/* The factors of P for a step of size h, with the Jacobian at t, y. */
int cardan_element_stages_factor(const cardan_steps *steps, cardan_element_stages *at, real t, real h,
                                 const real *y);
/* x (3, nx) becomes P^-1 x, or P^-T x. */
void cardan_element_stages_precondition(const cardan_steps *steps, const cardan_element_stages *at,
                                        int transposed, real *x);
/* Rates (nq) of coordinates q at speeds u (nu). */
void cardan_element_rates(const cardan_mesh *mesh, const real *q, const real *u, real *rates);

#endif
