/*
 * model.h: places of the entries of model 'rotor'.
 *
 * Such as q[q_<coordinate>] or p[p_<parameter>]; units behind the names.
 */
#ifndef CARDAN_MODEL_H
#define CARDAN_MODEL_H

#include "cardan.h"

/* sizes */
enum {
    cardan_nq = 5,
    cardan_nu = 5,
    cardan_nr = 0,
    cardan_np = 6,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 5,
    cardan_nparts = 5
};

/* generalized coordinates */
enum {
    q_x = 0, /* x [m] */
    q_y = 1, /* y [m] */
    q_tilt = 2, /* tilt [rad] */
    q_lean = 3, /* lean [rad] */
    q_spin = 4 /* spin [rad] */
};

/* generalized speeds */
enum {
    u_x_u = 0, /* x.u [m/s] */
    u_y_u = 1, /* y.u [m/s] */
    u_tilt_u = 2, /* tilt.u [rad/s] */
    u_lean_u = 3, /* lean.u [rad/s] */
    u_spin_u = 4 /* spin.u [rad/s] */
};

/* parameters */
enum {
    p_outer = 0, /* outer */
    p_inner = 1, /* inner */
    p_disk_mass = 2, /* disk.mass [kg] */
    p_disk_inertia_xx = 3, /* disk.inertia.xx [kg m^2] */
    p_disk_inertia_yy = 4, /* disk.inertia.yy [kg m^2] */
    p_disk_inertia_zz = 5 /* disk.inertia.zz [kg m^2] */
};

#endif
