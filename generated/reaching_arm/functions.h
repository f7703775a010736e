/*
 * functions.h: what model 'reaching_arm' computes.
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

/* udot with M udot + h = f + tau; reads q, u, r, p, tau */
enum {
    forward_dynamics_out_size = 2,
    forward_dynamics_work_size = 0,
    forward_dynamics_w_size = 7
};
CARDAN_API int forward_dynamics(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *w);

/* tau with M udot + h = f + tau; reads q, u, r, p, udot */
enum {
    inverse_dynamics_out_size = 2,
    inverse_dynamics_work_size = 0,
    inverse_dynamics_w_size = 6
};
CARDAN_API int inverse_dynamics(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *w);

/* M: kinetic energy is 1/2 uᵀ M u; reads q, p */
enum {
    mass_matrix_out_size = 4,
    mass_matrix_work_size = 0,
    mass_matrix_w_size = 4
};
CARDAN_API int mass_matrix(const cardan_in *in, real *out, real *work);
CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *w);

#endif
