/*
 * model.h: places of the entries of model 'bucket'.
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
    cardan_np = 4,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 1,
    cardan_nparts = 1
};

/* generalized coordinates */
enum {
    q_hang_angle1 = 0, /* hang.angle1 [rad] */
    q_hang_angle2 = 1 /* hang.angle2 [rad] */
};

/* generalized speeds */
enum {
    u_hang_u_angle1 = 0, /* hang.u.angle1 [rad/s] */
    u_hang_u_angle2 = 1 /* hang.u.angle2 [rad/s] */
};

/* parameters */
enum {
    p_load = 0, /* load [kg] */
    p_rope = 1, /* rope [m] */
    p_size = 2, /* size [m] */
    p_gravity_z = 3 /* gravity.z [m/s^2] */
};

#endif
