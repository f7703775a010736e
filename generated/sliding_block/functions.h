/*
 * functions.h: what model 'sliding_block' computes.
 *
 * out, work and w are arrays of the caller of at least the sizes given here.
 */
#ifndef CARDAN_FUNCTIONS_H
#define CARDAN_FUNCTIONS_H

#include "model.h"
#include "export.h"

/* model.c: values to start from; all that a run must know of the model */
extern const double cardan_default_q[cardan_nq + (cardan_nq == 0)];
extern const double cardan_default_u[cardan_nu + (cardan_nu == 0)];
extern const double cardan_default_r[cardan_nr + (cardan_nr == 0)];
extern const double cardan_default_p[cardan_np + (cardan_np == 0)];
extern const double cardan_default_z[cardan_nz + (cardan_nz == 0)];
extern const double cardan_default_s[cardan_ns + (cardan_ns == 0)];
extern const cardan_export cardan_scene;

/* udot with M udot + h = f + tau; reads u, s, p, tau */
enum {
    forward_dynamics_out_size = 1,
    forward_dynamics_work_size = 13,
    forward_dynamics_w_size = 7
};
CARDAN_API int forward_dynamics(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *w);

/* tau with M udot + h = f + tau; reads u, s, p, udot */
enum {
    inverse_dynamics_out_size = 1,
    inverse_dynamics_work_size = 0,
    inverse_dynamics_w_size = 7
};
CARDAN_API int inverse_dynamics(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *w);

/* M: kinetic energy is 1/2 uᵀ M u; reads p */
enum {
    mass_matrix_out_size = 1,
    mass_matrix_work_size = 0,
    mass_matrix_w_size = 1
};
CARDAN_API int mass_matrix(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *w);

/* numbers that fall through zero where an event happens; reads q, u, s, p */
enum {
    events_out_size = 5,
    events_work_size = 13,
    events_w_size = 8
};
CARDAN_API int events(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_events(const wreal *p, wreal *w);

/* speeds, internal and discrete states behind the events e; reads u, s, p, e */
enum {
    transition_out_size = 3,
    transition_work_size = 31,
    transition_w_size = 9
};
CARDAN_API int transition(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_transition(const wreal *p, wreal *w);

#endif
