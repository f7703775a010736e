/*
 * model.h: places of the entries of model 'lamp_arm'.
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
    cardan_nr = 1,
    cardan_np = 15,
    cardan_nz = 0,
    cardan_ns = 1,
    cardan_nbodies = 2,
    cardan_nparts = 2
};

/* generalized coordinates */
enum {
    q_shoulder = 0, /* shoulder [rad] */
    q_elbow = 1 /* elbow [rad] */
};

/* generalized speeds */
enum {
    u_shoulder_u = 0, /* shoulder.u [rad/s] */
    u_elbow_u = 1 /* elbow.u [rad/s] */
};

/* inputs */
enum {
    r_torque = 0 /* torque */
};

/* parameters */
enum {
    p_gravity_z = 0, /* gravity.z [m/s^2] */
    p_upper_mass = 1, /* upper.mass [kg] */
    p_upper_com_z = 2, /* upper.com.z [m] */
    p_upper_inertia_xx = 3, /* upper.inertia.xx [kg m^2] */
    p_upper_inertia_yy = 4, /* upper.inertia.yy [kg m^2] */
    p_elbow_position_z = 5, /* elbow.position.z [m] */
    p_lower_mass = 6, /* lower.mass [kg] */
    p_lower_com_z = 7, /* lower.com.z [m] */
    p_lower_inertia_xx = 8, /* lower.inertia.xx [kg m^2] */
    p_lower_inertia_yy = 9, /* lower.inertia.yy [kg m^2] */
    p_hand_position_z = 10, /* hand.position.z [m] */
    p_friction_damping = 11, /* friction.damping [N*m*s/rad] */
    p_stop_upper = 12, /* stop.upper [rad] */
    p_stop_restitution = 13, /* stop.restitution */
    p_stop_settle = 14 /* stop.settle [rad/s] */
};

#endif
