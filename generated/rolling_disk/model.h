/*
 * model.h: places of the entries of model 'rolling_disk'.
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
    cardan_np = 3,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 1,
    cardan_nparts = 1
};

/* generalized coordinates */
enum {
    q_rolling_x = 0, /* rolling.x [m] */
    q_rolling_y = 1, /* rolling.y [m] */
    q_rolling_yaw = 2, /* rolling.yaw [rad] */
    q_rolling_lean = 3, /* rolling.lean [rad] */
    q_rolling_spin = 4 /* rolling.spin [rad] */
};

/* generalized speeds */
enum {
    u_rolling_u_x = 0, /* rolling.u.x [m/s] */
    u_rolling_u_y = 1, /* rolling.u.y [m/s] */
    u_rolling_u_yaw = 2, /* rolling.u.yaw [rad/s] */
    u_rolling_u_lean = 3, /* rolling.u.lean [rad/s] */
    u_rolling_u_spin = 4 /* rolling.u.spin [rad/s] */
};

/* parameters */
enum {
    p_m = 0, /* m [kg] */
    p_r = 1, /* r [m] */
    p_gravity_z = 2 /* gravity.z [m/s^2] */
};

#endif
