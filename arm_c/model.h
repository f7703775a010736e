/*
 * model.h: places of the entries of model 'arm'.
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
    cardan_np = 8,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 2,
    cardan_nparts = 2
};

/* generalized coordinates */
enum {
    q_shoulder_qw = 0, /* shoulder.qw */
    q_shoulder_qx = 1, /* shoulder.qx */
    q_shoulder_qy = 2, /* shoulder.qy */
    q_shoulder_qz = 3, /* shoulder.qz */
    q_elbow = 4 /* elbow [rad] */
};

/* generalized speeds */
enum {
    u_shoulder_u_x = 0, /* shoulder.u.x [rad/s] */
    u_shoulder_u_y = 1, /* shoulder.u.y [rad/s] */
    u_shoulder_u_z = 2, /* shoulder.u.z [rad/s] */
    u_elbow_u = 3 /* elbow.u [rad/s] */
};

/* parameters */
enum {
    p_m = 0, /* m [kg] */
    p_gravity_z = 1, /* gravity.z [m/s^2] */
    p_upper_com_z = 2, /* upper.com.z [m] */
    p_elbow_position_z = 3, /* elbow.position.z [m] */
    p_hand_mass = 4, /* hand.mass [kg] */
    p_hand_inertia_xx = 5, /* hand.inertia.xx [kg m^2] */
    p_hand_inertia_yy = 6, /* hand.inertia.yy [kg m^2] */
    p_hand_inertia_zz = 7 /* hand.inertia.zz [kg m^2] */
};

#endif
