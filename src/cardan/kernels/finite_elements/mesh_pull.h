/* Sweeps in reverse and forward through the functions of a mesh, at one state: see mesh_product.h.
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
    real *direct;  /* (outputs) that a formula reads */
    real *sums;    /* (sums + 1) weights of sums, or their changes; behind them what is not asked for */
    real *unit;    /* (results) weights of one of them */
    real *probe;   /* (nu) a unit speed or acceleration */
    real *column;  /* (columns), then a result */
    real *stretch; /* (quaternions) what directions had along quaternions, of these */
    real *room;    /* of loops over elements */
    /* of Hessians, NULL else: derivatives by the data of all elements (data_rows), and weights of the
     * equations of an increment that closes loops, laid out like `weights` */
    real *by_data, *closing;
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
ptrdiff_t cardan_mesh_lay_slopes(const cardan_mesh_product *product, real *block, cardan_slopes *by);
/* mesh_product.c: solve for what the functions need at a state. */
int cardan_mesh_enter(const cardan_in *in, real *work, cardan_place *here);
/* mesh_pull.c: derivatives `by` of the results with weights v; `stored`: by q as it is stored alone. */
int cardan_mesh_pull(cardan_place *here, const real *v);
int cardan_mesh_pull_stored(cardan_place *here, const real *v);
/* Add the gradient of a weighted sum of results of elements to `by`; `along`: forms are curvatures, which
 * give its change along the direction `way`. Weights stand as `layout` says. CARDAN_BALANCE: those of the
 * balance (nu), of g (mp), of the rates (m), of what accelerations miss (m), of zdot (nz);
 * CARDAN_TANGENT: of M udot (nu) and of G udot (m); CARDAN_FORMS: of sums. */
int cardan_mesh_pull_elements(cardan_place *here, const cardan_form *forms, int layout,
                              const real *weights, int along);
/* Add derivatives by data to those by parameters, rows of one element side by side; `by_data` (rows), if it
 * is not NULL, gets them too. */
void cardan_mesh_add_data(const cardan_data_slopes *data, const cardan_element_lanes *some,
                          const real *out, real *by_p, real *by_data);
/* Add weights of the dynamics by which what was solved for has derivatives `by_udot` and `by_lam`; NULL: none. */
int cardan_mesh_pull_solution(cardan_place *here, const real *by_udot, const real *by_lam);

/* mesh_push.c: change of the results along a direction v (columns). */
int cardan_mesh_push(cardan_place *here, const real *v, real *out);
/* Everything that a direction changes, in `way`: coordinates along the speeds and as they are stored. */
int cardan_mesh_direction(cardan_place *here, const real *v);
/* Directions of what elements read, as a gift. */
real *cardan_mesh_give_direction(const cardan_mesh *mesh, const cardan_group *g,
                                 const ptrdiff_t *element, ptrdiff_t lanes,
                                 const cardan_gift *gift, real *to);
/* Changes of accelerations and multipliers, which become parts of the direction. */
int cardan_mesh_push_solution(cardan_place *here);
/* Set `to` (size) to the changes of results of elements, in the same layouts. */
int cardan_mesh_push_elements(cardan_place *here, const cardan_form *forms, int layout, ptrdiff_t size,
                              real *to);
/* Changes of the data of elements, side by side. Returns where they end. */
real *cardan_mesh_data_change(const cardan_data_slopes *data, const real *p, const ptrdiff_t *element,
                              ptrdiff_t lanes, real *to);
/* Change of the increment that closes positions, or speeds, as the solution of the system. */
int cardan_mesh_push_increment(cardan_place *here, int speeds);

/* mesh_matrix_products.c: derivatives, or their changes `along`, and changes of the mass matrix or the
 * Jacobian of constraints */
int cardan_mesh_pull_matrix(cardan_place *here, const real *v, int along);
int cardan_mesh_push_matrix(cardan_place *here, real *out);
/* mesh_frame_products.c: those of the functions of a frame */
int cardan_mesh_pull_frame(cardan_place *here, const real *v);
int cardan_mesh_push_frame(cardan_place *here, real *out);

/* mesh_rate_products.c: add v . qdot by q and u; u may be NULL: by u alone, which are speeds that q moves
 * along. */
int cardan_mesh_pull_rates(const cardan_place *here, const real *u, const real *v, real *by_q, real *by_u);
/* Add its change along dq and du, at fixed v; NULL: 0, or not wanted. */
int cardan_mesh_pull_rates_along(const cardan_place *here, const real *u, const real *v, const real *dq,
                                 const real *du, real *by_q, real *by_u);
/* Changes of qdot along `way`. */
int cardan_mesh_push_rates(const cardan_place *here, real *out);

/* The gradient of the dynamics with weights, or its change. */
static inline int cardan_mesh_pull_balance(cardan_place *here, const real *weights, int along)
{
    return cardan_mesh_pull_elements(here, here->product->dynamics, CARDAN_BALANCE, weights, along);
}

#endif
