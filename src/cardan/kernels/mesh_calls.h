/* Functions of a whole mesh with the interface of generated ones; `w` is the mesh. Part of cardan. */
#ifndef CARDAN_MESH_CALLS_H
#define CARDAN_MESH_CALLS_H

#include "mesh_matrix.h"

int cardan_mesh_accelerations(const cardan_mesh *mesh, const cardan_state *asked, const real *tau,
                              real *out, real *work);
int cardan_mesh_values(const cardan_mesh *mesh, const cardan_state *at, const real *shares,
                       real *a, real *work);
int cardan_mesh_call_balance(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_qdot(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_move(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_energy(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_power(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_rhs(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_close_position(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_close_velocity(const cardan_in *in, real *out, real *work);
ptrdiff_t cardan_mesh_call_work(const cardan_mesh *mesh);

#endif
