/*
 * model.h: places of the entries of model 'dual_spin'.
 *
 * Such as q[q_<coordinate>] or p[p_<parameter>]; units behind the names.
 */
#ifndef CARDAN_MODEL_H
#define CARDAN_MODEL_H

#include "cardan.h"

/* sizes */
enum {
    cardan_nq = 5,
    cardan_nu = 4,
    cardan_nr = 0,
    cardan_np = 9,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 2,
    cardan_nparts = 2
};

/* generalized coordinates */
enum {
    q_attitude_qw = 0, /* attitude.qw */
    q_attitude_qx = 1, /* attitude.qx */
    q_attitude_qy = 2, /* attitude.qy */
    q_attitude_qz = 3, /* attitude.qz */
    q_tube = 4 /* tube [m] */
};

/* generalized speeds */
enum {
    u_attitude_u_x = 0, /* attitude.u.x [rad/s] */
    u_attitude_u_y = 1, /* attitude.u.y [rad/s] */
    u_attitude_u_z = 2, /* attitude.u.z [rad/s] */
    u_tube_u = 3 /* tube.u [m/s] */
};

/* parameters */
enum {
    p_hs = 0, /* hs [N m s] */
    p_bus_mass = 1, /* bus.mass [kg] */
    p_bus_inertia_xx = 2, /* bus.inertia.xx [kg m^2] */
    p_bus_inertia_yy = 3, /* bus.inertia.yy [kg m^2] */
    p_bus_inertia_zz = 4, /* bus.inertia.zz [kg m^2] */
    p_tube_position_x = 5, /* tube.position.x [m] */
    p_ball_mass = 6, /* ball.mass [kg] */
    p_oil_stiffness = 7, /* oil.stiffness [N/m] */
    p_oil_damping = 8 /* oil.damping [N*s/m] */
};

#endif
