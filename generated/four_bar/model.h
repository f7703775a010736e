/*
 * model.h: places of the entries of model 'four_bar'.
 *
 * Such as q[q_<coordinate>] or p[p_<parameter>]; units behind the names.
 */
#ifndef CARDAN_MODEL_H
#define CARDAN_MODEL_H

#include "cardan.h"

/* sizes */
enum {
    cardan_nq = 3,
    cardan_nu = 3,
    cardan_nr = 0,
    cardan_np = 20,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 3,
    cardan_nparts = 3
};

/* generalized coordinates */
enum {
    q_A = 0, /* A [rad] */
    q_B = 1, /* B [rad] */
    q_D = 2 /* D [rad] */
};

/* generalized speeds */
enum {
    u_A_u = 0, /* A.u [rad/s] */
    u_B_u = 1, /* B.u [rad/s] */
    u_D_u = 2 /* D.u [rad/s] */
};

/* parameters */
enum {
    p_gravity_y = 0, /* gravity.y [m/s^2] */
    p_crank_mass = 1, /* crank.mass [kg] */
    p_crank_com_x = 2, /* crank.com.x [m] */
    p_crank_inertia_xx = 3, /* crank.inertia.xx [kg m^2] */
    p_crank_inertia_yy = 4, /* crank.inertia.yy [kg m^2] */
    p_crank_inertia_zz = 5, /* crank.inertia.zz [kg m^2] */
    p_B_position_x = 6, /* B.position.x [m] */
    p_coupler_mass = 7, /* coupler.mass [kg] */
    p_coupler_com_x = 8, /* coupler.com.x [m] */
    p_coupler_inertia_xx = 9, /* coupler.inertia.xx [kg m^2] */
    p_coupler_inertia_yy = 10, /* coupler.inertia.yy [kg m^2] */
    p_coupler_inertia_zz = 11, /* coupler.inertia.zz [kg m^2] */
    p_D_position_x = 12, /* D.position.x [m] */
    p_rocker_mass = 13, /* rocker.mass [kg] */
    p_rocker_com_x = 14, /* rocker.com.x [m] */
    p_rocker_inertia_xx = 15, /* rocker.inertia.xx [kg m^2] */
    p_rocker_inertia_yy = 16, /* rocker.inertia.yy [kg m^2] */
    p_rocker_inertia_zz = 17, /* rocker.inertia.zz [kg m^2] */
    p_C_position_x = 18, /* C.position.x [m] */
    p_C_child_position_x = 19 /* C.child.position.x [m] */
};

#endif
