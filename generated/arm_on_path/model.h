/*
 * model.h: places of the entries of model 'arm_on_path'.
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

/* parameters */
enum {
    p_gravity_z = 0, /* gravity.z [m/s^2] */
    p_upper_mass = 1, /* upper.mass [kg] */
    p_upper_com_x = 2, /* upper.com.x [m] */
    p_upper_inertia_xx = 3, /* upper.inertia.xx [kg m^2] */
    p_upper_inertia_yy = 4, /* upper.inertia.yy [kg m^2] */
    p_upper_inertia_zz = 5, /* upper.inertia.zz [kg m^2] */
    p_elbow_position_x = 6, /* elbow.position.x [m] */
    p_lower_mass = 7, /* lower.mass [kg] */
    p_lower_com_x = 8, /* lower.com.x [m] */
    p_lower_inertia_xx = 9, /* lower.inertia.xx [kg m^2] */
    p_lower_inertia_yy = 10, /* lower.inertia.yy [kg m^2] */
    p_lower_inertia_zz = 11 /* lower.inertia.zz [kg m^2] */
};

#endif
