/*
 * model.h: places of the entries of model 'change_points'.
 *
 * Such as q[q_<coordinate>] or p[p_<parameter>]; units behind the names.
 */
#ifndef CARDAN_MODEL_H
#define CARDAN_MODEL_H

#include "cardan.h"

/* sizes */
enum {
    cardan_nq = 5,
    cardan_nu = 5,
    cardan_nr = 0,
    cardan_np = 28,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 5,
    cardan_nparts = 5
};

/* generalized coordinates */
enum {
    q_A0 = 0, /* A0 [rad] */
    q_A1 = 1, /* A1 [rad] */
    q_A2 = 2, /* A2 [rad] */
    q_B0 = 3, /* B0 [rad] */
    q_B1 = 4 /* B1 [rad] */
};

/* generalized speeds */
enum {
    u_A0_u = 0, /* A0.u [rad/s] */
    u_A1_u = 1, /* A1.u [rad/s] */
    u_A2_u = 2, /* A2.u [rad/s] */
    u_B0_u = 3, /* B0.u [rad/s] */
    u_B1_u = 4 /* B1.u [rad/s] */
};

/* parameters */
enum {
    p_crank0_mass = 0, /* crank0.mass [kg] */
    p_crank0_com_x = 1, /* crank0.com.x [m] */
    p_crank0_inertia_yy = 2, /* crank0.inertia.yy [kg m^2] */
    p_crank0_inertia_zz = 3, /* crank0.inertia.zz [kg m^2] */
    p_A1_position_x = 4, /* A1.position.x [m] */
    p_crank1_mass = 5, /* crank1.mass [kg] */
    p_crank1_com_x = 6, /* crank1.com.x [m] */
    p_crank1_inertia_yy = 7, /* crank1.inertia.yy [kg m^2] */
    p_crank1_inertia_zz = 8, /* crank1.inertia.zz [kg m^2] */
    p_A2_position_x = 9, /* A2.position.x [m] */
    p_crank2_mass = 10, /* crank2.mass [kg] */
    p_crank2_com_x = 11, /* crank2.com.x [m] */
    p_crank2_inertia_yy = 12, /* crank2.inertia.yy [kg m^2] */
    p_crank2_inertia_zz = 13, /* crank2.inertia.zz [kg m^2] */
    p_B0_position_x = 14, /* B0.position.x [m] */
    p_coupler0_mass = 15, /* coupler0.mass [kg] */
    p_coupler0_com_x = 16, /* coupler0.com.x [m] */
    p_coupler0_inertia_yy = 17, /* coupler0.inertia.yy [kg m^2] */
    p_coupler0_inertia_zz = 18, /* coupler0.inertia.zz [kg m^2] */
    p_B1_position_x = 19, /* B1.position.x [m] */
    p_coupler1_mass = 20, /* coupler1.mass [kg] */
    p_coupler1_com_x = 21, /* coupler1.com.x [m] */
    p_coupler1_inertia_yy = 22, /* coupler1.inertia.yy [kg m^2] */
    p_coupler1_inertia_zz = 23, /* coupler1.inertia.zz [kg m^2] */
    p_C0_position_x = 24, /* C0.position.x [m] */
    p_C0_child_position_x = 25, /* C0.child.position.x [m] */
    p_C1_position_x = 26, /* C1.position.x [m] */
    p_C1_child_position_x = 27 /* C1.child.position.x [m] */
};

#endif
