/*
 * model.h: places of the entries of model 'compass_gait'.
 *
 * Such as q[q_<coordinate>] or p[p_<parameter>]; units behind the names.
 */
#ifndef CARDAN_MODEL_H
#define CARDAN_MODEL_H

#include "cardan.h"

/* sizes */
enum {
    cardan_nq = 2,
    cardan_nu = 2,
    cardan_nr = 0,
    cardan_np = 9,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 2,
    cardan_nparts = 3
};

/* generalized coordinates */
enum {
    q_stance = 0, /* stance [rad] */
    q_hip = 1 /* hip [rad] */
};

/* generalized speeds */
enum {
    u_stance_u = 0, /* stance.u [rad/s] */
    u_hip_u = 1 /* hip.u [rad/s] */
};

/* parameters */
enum {
    p_slope = 0, /* slope [rad] */
    p_gravity_z = 1, /* gravity.z [m/s^2] */
    p_stance_leg_mass = 2, /* stance_leg.mass [kg] */
    p_stance_leg_com_z = 3, /* stance_leg.com.z [m] */
    p_top_position_z = 4, /* top.position.z [m] */
    p_hip_mass_mass = 5, /* hip_mass.mass [kg] */
    p_hip_position_z = 6, /* hip.position.z [m] */
    p_swing_leg_mass = 7, /* swing_leg.mass [kg] */
    p_swing_leg_com_z = 8 /* swing_leg.com.z [m] */
};

#endif
