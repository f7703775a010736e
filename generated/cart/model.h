/*
 * model.h: places of the entries of model 'cart'.
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
    cardan_np = 7,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 2,
    cardan_nparts = 2
};

/* generalized coordinates */
enum {
    q_slide = 0, /* slide [m] */
    q_swing = 1 /* swing [rad] */
};

/* generalized speeds */
enum {
    u_slide_u = 0, /* slide.u [m/s] */
    u_swing_u = 1 /* swing.u [rad/s] */
};

/* inputs */
enum {
    r_push = 0 /* push */
};

/* parameters */
enum {
    p_m = 0, /* m [kg] */
    p_l = 1, /* l [m] */
    p_gravity_z = 2, /* gravity.z [m/s^2] */
    p_cart_mass = 3, /* cart.mass [kg] */
    p_cart_inertia_xx = 4, /* cart.inertia.xx [kg m^2] */
    p_cart_inertia_yy = 5, /* cart.inertia.yy [kg m^2] */
    p_cart_inertia_zz = 6 /* cart.inertia.zz [kg m^2] */
};

#endif
