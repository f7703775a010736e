/*
 * model.h: places of the entries of model 'cart_pole'.
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
    cardan_np = 6,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 2,
    cardan_nparts = 2
};

/* generalized coordinates */
enum {
    q_track = 0, /* track [m] */
    q_hinge = 1 /* hinge [rad] */
};

/* generalized speeds */
enum {
    u_track_u = 0, /* track.u [m/s] */
    u_hinge_u = 1 /* hinge.u [rad/s] */
};

/* inputs */
enum {
    r_push = 0 /* push */
};

/* parameters */
enum {
    p_gravity_z = 0, /* gravity.z [m/s^2] */
    p_cart_mass = 1, /* cart.mass [kg] */
    p_pole_mass = 2, /* pole.mass [kg] */
    p_pole_com_z = 3, /* pole.com.z [m] */
    p_pole_inertia_xx = 4, /* pole.inertia.xx [kg m^2] */
    p_pole_inertia_yy = 5 /* pole.inertia.yy [kg m^2] */
};

#endif
