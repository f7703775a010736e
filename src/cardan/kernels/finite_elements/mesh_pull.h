/* Sweeps in reverse through the functions of a mesh, at one state: see mesh_product.h.
 *
 * Part of cardan. Caller owns all memory.
 */
#ifndef CARDAN_MESH_PULL_H
#define CARDAN_MESH_PULL_H

#include "mesh_product.h"

/* Derivatives by everything, added up; one block. */
typedef struct cardan_slopes {
    real *t, *along, *q, *u, *z, *s, *r, *p, *udot, *tau, *lam;
    ptrdiff_t count;
} cardan_slopes;

/* A state at which products are taken, with what was solved for there. */
typedef struct cardan_place {
    const cardan_mesh_product *product;
    const cardan_mesh *mesh;
    cardan_state at;
    cardan_mesh_system system;
    cardan_slopes by, way; /* derivatives, or the direction of a change */
    real *weights; /* of the balance (nu), g (mp), rates (m), what accelerations miss (m), zdot (nz) */
    real *direct;  /* energies' weights (2), or the outputs that a formula reads */
    real *unit;    /* (results), or weights of outputs */
    real *column;  /* (columns), then a result */
    real *room;    /* of loops over elements */
} cardan_place;

/* What a formula reads: the outputs are in `direct`. */
static inline cardan_in cardan_formula_in(const cardan_place *here, const cardan_form *form)
{
    const cardan_in in = {.t = &here->at.t, .q = here->at.q, .u = here->at.u, .z = here->at.z,
                          .r = here->at.r, .v = here->direct, .w = form->w};

    return in;
}

/* Point into a block, NULL: only measure. Returns how many numbers that takes. */
ptrdiff_t cardan_mesh_lay_place(const cardan_mesh_product *product, real *block, cardan_place *here);
/* Derivatives `by` of the results with weights v. */
int cardan_mesh_pull(cardan_place *here, const real *v);
/* mesh_push.c: change of the results along a direction v (columns). */
int cardan_mesh_push(cardan_place *here, const real *v, real *out);

#endif
