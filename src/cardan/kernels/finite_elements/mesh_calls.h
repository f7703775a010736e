/* Functions of a whole mesh with the interface of generated ones; `w` is the mesh. Part of cardan. */
#ifndef CARDAN_MESH_CALLS_H
#define CARDAN_MESH_CALLS_H

#include "mesh_matrix.h"

static inline const cardan_mesh *cardan_mesh_of(const cardan_in *in)
{
    return (const cardan_mesh *)(const void *)in->w;
}

static inline cardan_state cardan_state_of(const cardan_in *in)
{
    const cardan_state at = {.t = in->t ? *in->t : 0, .q = in->q, .u = in->u, .udot = in->udot,
                             .lam = in->lam, .z = in->z, .s = in->s, .r = in->r};

    return at;
}

int cardan_mesh_accelerations(const cardan_mesh *mesh, const cardan_state *asked, const real *tau,
                              real *out, real *work);
/* the same; the factored system stays in `work` */
int cardan_mesh_solve_motion(const cardan_mesh *mesh, const cardan_state *asked, const real *tau,
                             real *out, real *work, cardan_mesh_system *system);
/* Factor M and G as they close loops by the least motion; `locked` and `fixed`: see mesh_close.c. */
int cardan_mesh_closing_factor(const cardan_mesh *mesh, const cardan_state *at, const real *locked,
                               int fixed, cardan_mesh_system *system);
/* how certain friction is that follows from reactions (frictions), in `work` of the last solution */
real *cardan_mesh_certainty(const cardan_mesh *mesh, real *work);
int cardan_mesh_values(const cardan_mesh *mesh, const cardan_state *at, const real *shares,
                       real *a, real *work);
int cardan_mesh_call_balance(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_qdot(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_move(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_energy(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_forward_dynamics(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_mass_matrix(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_momentum(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_outputs(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_power(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_rhs(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_close_position(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_close_velocity(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_constraint_jacobian(const cardan_in *in, real *out, real *work);
/* mesh_loops.c */
int cardan_mesh_loops(const cardan_mesh *mesh, const cardan_mesh_system *system, real *rows);
/* mesh_events.c; `jump_room`, in mesh_jumps.c: numbers of memory of a transition besides that of accelerations */
int cardan_mesh_call_events(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_transition(const cardan_in *in, real *out, real *work);
ptrdiff_t cardan_mesh_jump_room(const cardan_mesh *mesh);
ptrdiff_t cardan_mesh_call_work(const cardan_mesh *mesh);

/* mesh_start.c: move what is not held of x = [q, u, z] until all constraints hold, then the speeds.
 * quaternions (count): the first entry of each in q. held (nq + nu): not 0 where x stays. Returns 0,
 * the status of an element, or CARDAN_CONSTRAINT_OPEN where that is not possible. */
ptrdiff_t cardan_mesh_start_work(const cardan_mesh *mesh);
int cardan_mesh_start(const cardan_mesh *mesh, real t, const real *r, const ptrdiff_t *quaternions,
                      ptrdiff_t count, const real *locked, real *x, real *work);

#endif
