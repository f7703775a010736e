/*
 * model.h: places of the entries of model 'truss'.
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
    cardan_np = 13,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 2,
    cardan_nparts = 2
};

/* generalized coordinates */
enum {
    q_u = 0, /* u [m] */
    q_w = 1 /* w [m] */
};

/* generalized speeds */
enum {
    u_u_u = 0, /* u.u [m/s] */
    u_w_u = 1 /* w.u [m/s] */
};

/* parameters */
enum {
    p_P = 0, /* P */
    p_tilt = 1, /* tilt */
    p_u_position_z = 2, /* u.position.z [m] */
    p_apex_mass = 3, /* apex.mass [kg] */
    p_apex_inertia_xx = 4, /* apex.inertia.xx [kg m^2] */
    p_apex_inertia_yy = 5, /* apex.inertia.yy [kg m^2] */
    p_apex_inertia_zz = 6, /* apex.inertia.zz [kg m^2] */
    p_left_stiffness = 7, /* left.stiffness [N/m] */
    p_left_rest_length = 8, /* left.rest_length [m] */
    p_left_a_position_x = 9, /* left.a.position.x [m] */
    p_right_stiffness = 10, /* right.stiffness [N/m] */
    p_right_rest_length = 11, /* right.rest_length [m] */
    p_right_a_position_x = 12 /* right.a.position.x [m] */
};

#endif
