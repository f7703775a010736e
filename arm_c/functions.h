/*
 * functions.h: what model 'arm' computes.
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

/* derivative, q along the speeds, of forward_dynamics: q u; reads q, u, p, tau */
enum {
    derivative__forward_dynamics_q_u_out_size = 32,
    derivative__forward_dynamics_q_u_work_size = 0,
    derivative__forward_dynamics_q_u_w_size = 15
};
CARDAN_API int derivative__forward_dynamics_q_u(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_derivative__forward_dynamics_q_u(const wreal *p, wreal *w);

#endif
