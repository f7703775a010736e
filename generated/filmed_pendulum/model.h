/*
 * model.h: places of the entries of model 'filmed_pendulum'.
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
    cardan_np = 7,
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
    p_m1 = 0, /* m1 [kg] */
    p_m2 = 1, /* m2 [kg] */
    p_l1 = 2, /* l1 [m] */
    p_l2 = 3, /* l2 [m] */
    p_d1 = 4, /* d1 [N m s/rad] */
    p_d2 = 5, /* d2 [N m s/rad] */
    p_gravity_z = 6 /* gravity.z [m/s^2] */
};

#endif
