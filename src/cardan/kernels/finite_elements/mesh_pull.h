/* Sweeps in reverse and forward through the functions of a mesh, at one state: see mesh_product.h.
 *
 * Part of cardan. Caller owns all memory.
 */
#ifndef CARDAN_MESH_PULL_H
#define CARDAN_MESH_PULL_H

#include "mesh_friction.h"
#include "mesh_jumps.h"
#include "mesh_product.h"

/* Derivatives by everything, added up; one block. */
typedef struct cardan_slopes {
    real *t, *along, *q, *u, *z, *s, *r, *p, *udot, *tau, *lam;
    real *behind, *certainty, *responses; /* what events read besides */
    ptrdiff_t count;
} cardan_slopes;

/* An event at a state, and what its derivatives are made of; one block. */
typedef struct cardan_event_place {
    cardan_mesh_jumps all;
    cardan_mesh_system released; /* masses and constraints without what modes hold */
    real *work;    /* of that */
    real *rows;    /* (jumps, CARDAN_JUMP_ROW) weights, or changes, of impulses */
    real *J;       /* (jumps, nu) of velocities */
    real *P;       /* (jumps) of the sizes of impulses */
    real *moved;   /* (nu + m) speeds and multipliers by impulses */
    real *answer;  /* (nu + m) of the equations of these, or their changes */
    real *by_motion; /* (nu + m) derivatives of these equations by speeds and multipliers */
    real *force;   /* (nu) that makes a motion */
    real *shares;  /* of friction: see mesh_friction_products.c */
    real *values;  /* (ne) of events */
    int solved;    /* 1: values of events follow from accelerations or multipliers */
} cardan_event_place;

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
    cardan_event_place event;
    cardan_mesh_friction friction; /* that follows from reactions, where motions are solved for */
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
/* mesh_frame_hessian.c: the change of their gradient along the direction, at a state with gradients, with
 * changes, and with changes of gradients */
int cardan_mesh_pull_frame_along(const cardan_place *here, cardan_place *change, cardan_place *along,
                                 const real *v);
/* mesh_hessian.c: add what second derivatives of data by parameters, along changes p of these, make of
 * derivatives by the data (rows) */
void cardan_mesh_add_second(const cardan_data_slopes *data, const real *by_data, const real *p, real *by_p);

/* mesh_rate_products.c: add v . qdot by q and u; u may be NULL: by u alone, which are speeds that q moves
 * along. */
int cardan_mesh_pull_rates(const cardan_place *here, const real *u, const real *v, real *by_q, real *by_u);
/* Add its change along dq and du, at fixed v; NULL: 0, or not wanted. */
int cardan_mesh_pull_rates_along(const cardan_place *here, const real *u, const real *v, const real *dq,
                                 const real *du, real *by_q, real *by_u);
/* Changes of qdot along `way`. */
int cardan_mesh_push_rates(const cardan_place *here, real *out);

/* mesh_pull.c, mesh_push.c: add the gradient of a sum of results of elements, with the weights of a gift,
 * or its change `along` the direction; give the changes of their results to a taker. */
int cardan_mesh_pull_with(cardan_place *here, const cardan_form *forms, const cardan_gift *weights,
                          int along);
int cardan_mesh_push_with(cardan_place *here, const cardan_form *forms, cardan_taker *take, void *to);
/* Add derivatives by what events read besides, and give directions of that: as elements have it. */
const real *cardan_mesh_add_events(const cardan_mesh *mesh, const cardan_group *g,
                                   const cardan_element_lanes *some, const real *next,
                                   const cardan_slopes *by);
real *cardan_mesh_give_events(const cardan_mesh *mesh, const cardan_group *g, const ptrdiff_t *element,
                              ptrdiff_t lanes, const cardan_slopes *way, real *to);
/* mesh_pull_events.c, mesh_push_events.c: derivatives of values of events, and of what events change;
 * `lay_weights` lays what these are made of alone */
ptrdiff_t cardan_mesh_lay_event(const cardan_mesh_product *product, real *block, cardan_event_place *to);
ptrdiff_t cardan_mesh_lay_weights(const cardan_mesh_product *product, real *block, cardan_event_place *to);
int cardan_mesh_enter_event(const cardan_in *in, real *solution, real *work, cardan_place *here);
int cardan_mesh_pull_events(cardan_place *here, const real *v);
int cardan_mesh_pull_transition(cardan_place *here, const real *v);
int cardan_mesh_push_events(cardan_place *here, real *out);
int cardan_mesh_push_transition(cardan_place *here, real *out);
/* Add the gradient of what elements say, or its change `along` the direction: of values of events with
 * weights v (ne), of states behind events (nz + ns), of impulses with the weights `rows` and `J` of an event. */
int cardan_mesh_pull_signs(cardan_place *here, const real *v, int along);
int cardan_mesh_pull_states(cardan_place *here, const real *v, int along);
int cardan_mesh_pull_jumps(cardan_place *here, const cardan_event_place *weights, int along);
/* Changes of impulses, of responses and of speeds behind the event, where those of accelerations are parts
 * of the direction, of which the last two become parts. */
int cardan_mesh_push_jump(cardan_place *here);
/* mesh_event_hessian.c: the change of the gradient of values of events, or of what events change, along the
 * direction, at a state with gradients, with changes, and with changes of gradients */
int cardan_mesh_pull_events_along(const cardan_place *here, cardan_place *change, cardan_place *along,
                                  const real *v);
int cardan_mesh_pull_transition_along(const cardan_place *here, cardan_place *change, cardan_place *along,
                                      const real *v);
/* Motion (nu + m), speeds or accelerations and multipliers, by forces (nu) and gaps (m), NULL: none. */
int cardan_mesh_motion_of(const cardan_mesh *mesh, cardan_mesh_system *system, const real *force,
                          const real *gap, real *motion);
/* Add the gradient of M udot - G^T lam (nu) and G udot - H lam (m) at a motion, with weights (nu + m), or
 * its change where the motion changes by `change`; NULL: the gradient. What they are by the motion is in
 * `by_motion` of the event. */
int cardan_mesh_pull_impulse(cardan_place *here, const real *motion, const real *weights, real *change);
/* Set `answer` of the event to the changes of these equations at a motion that stays. */
int cardan_mesh_push_impulse(cardan_place *here, const real *motion);
/* Change (nu + m) of a motion by a force that changes by `force` (nu), of these equations solved; `answer` of
 * the event is lost, or `out`. */
int cardan_mesh_push_motion(cardan_place *here, cardan_mesh_system *system, const real *motion,
                            const real *force, real *out);
/* mesh_friction_products.c: of how certain friction is that follows from reactions */
int cardan_mesh_pull_certainty(cardan_place *here);
int cardan_mesh_push_certainty(cardan_place *here);
int cardan_mesh_pull_certainty_along(const cardan_place *here, cardan_place *change, cardan_place *along);

/* The gradient of the dynamics with weights, or its change. */
static inline int cardan_mesh_pull_balance(cardan_place *here, const real *weights, int along)
{
    return cardan_mesh_pull_elements(here, here->product->dynamics, CARDAN_BALANCE, weights, along);
}

#endif
