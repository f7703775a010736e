/*
 * functions.h: what model 'flexible_pendulum' computes.
 *
 * out, work and w are arrays of the caller of at least the sizes given here.
 */
#ifndef CARDAN_FUNCTIONS_H
#define CARDAN_FUNCTIONS_H

#include "model.h"
#include "export.h"
#include "mesh_export.h"

/* model.c: values to start from; all that a run must know of the model */
extern const double cardan_default_q[cardan_nq + (cardan_nq == 0)];
extern const double cardan_default_u[cardan_nu + (cardan_nu == 0)];
extern const double cardan_default_r[cardan_nr + (cardan_nr == 0)];
extern const double cardan_default_p[cardan_np + (cardan_np == 0)];
extern const double cardan_default_z[cardan_nz + (cardan_nz == 0)];
extern const double cardan_default_s[cardan_ns + (cardan_ns == 0)];
extern const cardan_export cardan_scene;

enum {
    cardan_nlam = 0, /* multipliers: those of positions, then the others */
    cardan_npositions = 0, /* constraints of positions */
    cardan_nplaces = 11, /* places: nodes and joints */
    cardan_noutputs = 0, /* outputs */
    cardan_npowers = 0, /* sources of power */
    cardan_nevents = 0, /* events */
    cardan_nunknowns = 61, /* speeds and multipliers */
    cardan_nvalues = 1021, /* numbers of the sparse matrix */
    cardan_ngroups = 5, /* groups of elements */
    cardan_nnumbers = 1891 /* numbers of elements */
};
#include "elements.h"

/* functions of the whole model, and what of the kernels each of them is */
#define CARDAN_ELEMENT_CALLS(F) F(forward_dynamics, cardan_mesh_call_forward_dynamics) F(energy, cardan_mesh_call_energy)

/* kinetic, potential and their sum; reads t, q, u, z, s, r */
enum {
    energy_out_size = 3
};
CARDAN_API int energy(const cardan_in *in, real *out, real *work);

/* accelerations udot, then the multipliers lam; reads t, q, u, z, s, r, tau */
enum {
    forward_dynamics_out_size = cardan_nu + cardan_nlam
};
CARDAN_API int forward_dynamics(const cardan_in *in, real *out, real *work);

#endif
