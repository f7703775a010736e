/*
 * model.h: places of the entries of model 'foot_linkage'.
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
    cardan_np = 22,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 3,
    cardan_nparts = 3
};

/* generalized coordinates */
enum {
    q_B = 0, /* B [rad] */
    q_D = 1 /* D [rad] */
};

/* generalized speeds */
enum {
    u_B_u = 0, /* B.u [rad/s] */
    u_D_u = 1 /* D.u [rad/s] */
};

/* parameters */
enum {
    p_crank = 0, /* crank [m] */
    p_coupler = 1, /* coupler [m] */
    p_rocker = 2, /* rocker [m] */
    p_ground = 3, /* ground [m] */
    p_along = 4, /* along [m] */
    p_aside = 5, /* aside [m] */
    p_base_x = 6, /* base_x [m] */
    p_base_y = 7, /* base_y [m] */
    p_tilt = 8, /* tilt [rad] */
    p_phase = 9, /* phase [rad] */
    p_crank_link_mass = 10, /* crank_link.mass [kg] */
    p_crank_link_inertia_xx = 11, /* crank_link.inertia.xx [kg m^2] */
    p_crank_link_inertia_yy = 12, /* crank_link.inertia.yy [kg m^2] */
    p_crank_link_inertia_zz = 13, /* crank_link.inertia.zz [kg m^2] */
    p_coupler_link_mass = 14, /* coupler_link.mass [kg] */
    p_coupler_link_inertia_xx = 15, /* coupler_link.inertia.xx [kg m^2] */
    p_coupler_link_inertia_yy = 16, /* coupler_link.inertia.yy [kg m^2] */
    p_coupler_link_inertia_zz = 17, /* coupler_link.inertia.zz [kg m^2] */
    p_rocker_link_mass = 18, /* rocker_link.mass [kg] */
    p_rocker_link_inertia_xx = 19, /* rocker_link.inertia.xx [kg m^2] */
    p_rocker_link_inertia_yy = 20, /* rocker_link.inertia.yy [kg m^2] */
    p_rocker_link_inertia_zz = 21 /* rocker_link.inertia.zz [kg m^2] */
};

#endif
