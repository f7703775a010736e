/*
 * model.h: places of the entries of model 'links'.
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
    cardan_np = 10,
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
    p_m = 0, /* m [kg] */
    p_k = 1, /* k [N m/rad] */
    p_d = 2, /* d [N m s/rad] */
    p_gravity_z = 3, /* gravity.z [m/s^2] */
    p_upper_mass = 4, /* upper.mass [kg] */
    p_upper_com_z = 5, /* upper.com.z [m] */
    p_upper_inertia_xx = 6, /* upper.inertia.xx [kg m^2] */
    p_upper_inertia_yy = 7, /* upper.inertia.yy [kg m^2] */
    p_elbow_position_z = 8, /* elbow.position.z [m] */
    p_lower_com_z = 9 /* lower.com.z [m] */
};

#endif
