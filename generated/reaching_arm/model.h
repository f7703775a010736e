/*
 * model.h: places of the entries of model 'reaching_arm'.
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
    cardan_nr = 2,
    cardan_np = 12,
    cardan_nz = 0,
    cardan_ns = 0,
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
    r_shoulder_torque = 0, /* shoulder_torque [N m] */
    r_elbow_torque = 1 /* elbow_torque [N m] */
};

/* parameters */
enum {
    p_upper_mass = 0, /* upper.mass [kg] */
    p_upper_com_x = 1, /* upper.com.x [m] */
    p_upper_inertia_yy = 2, /* upper.inertia.yy [kg m^2] */
    p_upper_inertia_zz = 3, /* upper.inertia.zz [kg m^2] */
    p_elbow_position_x = 4, /* elbow.position.x [m] */
    p_lower_mass = 5, /* lower.mass [kg] */
    p_lower_com_x = 6, /* lower.com.x [m] */
    p_lower_inertia_yy = 7, /* lower.inertia.yy [kg m^2] */
    p_lower_inertia_zz = 8, /* lower.inertia.zz [kg m^2] */
    p_lower_at1_position_x = 9, /* lower.at1.position.x [m] */
    p_shoulder_bearing_damping = 10, /* shoulder_bearing.damping [N*m*s/rad] */
    p_elbow_bearing_damping = 11 /* elbow_bearing.damping [N*m*s/rad] */
};

#endif
