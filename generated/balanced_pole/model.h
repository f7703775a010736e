/*
 * model.h: places of the entries of model 'balanced_pole'.
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
    cardan_np = 9,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 2,
    cardan_nparts = 2
};

/* generalized coordinates */
enum {
    q_rail = 0, /* rail [m] */
    q_hinge = 1 /* hinge [rad] */
};

/* generalized speeds */
enum {
    u_rail_u = 0, /* rail.u [m/s] */
    u_hinge_u = 1 /* hinge.u [rad/s] */
};

/* inputs */
enum {
    r_push = 0 /* push [N] */
};

/* parameters */
enum {
    p_gravity_z = 0, /* gravity.z [m/s^2] */
    p_cart_mass = 1, /* cart.mass [kg] */
    p_cart_inertia_xx = 2, /* cart.inertia.xx [kg m^2] */
    p_cart_inertia_yy = 3, /* cart.inertia.yy [kg m^2] */
    p_cart_inertia_zz = 4, /* cart.inertia.zz [kg m^2] */
    p_pole_mass = 5, /* pole.mass [kg] */
    p_pole_com_z = 6, /* pole.com.z [m] */
    p_pole_inertia_xx = 7, /* pole.inertia.xx [kg m^2] */
    p_pole_inertia_yy = 8 /* pole.inertia.yy [kg m^2] */
};

#endif
