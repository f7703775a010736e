/*
 * model.h: places of the entries of model 'andrews'.
 *
 * Such as q[q_<coordinate>] or p[p_<parameter>]; units behind the names.
 */
#ifndef CARDAN_MODEL_H
#define CARDAN_MODEL_H

#include "cardan.h"

/* sizes */
enum {
    cardan_nq = 7,
    cardan_nu = 7,
    cardan_nr = 0,
    cardan_np = 58,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 7,
    cardan_nparts = 7
};

/* generalized coordinates */
enum {
    q_beta = 0, /* beta [rad] */
    q_theta = 1, /* theta [rad] */
    q_gamma = 2, /* gamma [rad] */
    q_delta = 3, /* delta [rad] */
    q_phi = 4, /* phi [rad] */
    q_epsilon = 5, /* epsilon [rad] */
    q_omega = 6 /* omega [rad] */
};

/* generalized speeds */
enum {
    u_beta_u = 0, /* beta.u [rad/s] */
    u_theta_u = 1, /* theta.u [rad/s] */
    u_gamma_u = 2, /* gamma.u [rad/s] */
    u_delta_u = 3, /* delta.u [rad/s] */
    u_phi_u = 4, /* phi.u [rad/s] */
    u_epsilon_u = 5, /* epsilon.u [rad/s] */
    u_omega_u = 6 /* omega.u [rad/s] */
};

/* parameters */
enum {
    p_K1_mass = 0, /* K1.mass [kg] */
    p_K1_com_x = 1, /* K1.com.x [m] */
    p_K1_inertia_xx = 2, /* K1.inertia.xx [kg m^2] */
    p_K1_inertia_yy = 3, /* K1.inertia.yy [kg m^2] */
    p_K1_inertia_zz = 4, /* K1.inertia.zz [kg m^2] */
    p_theta_position_x = 5, /* theta.position.x [m] */
    p_K2_mass = 6, /* K2.mass [kg] */
    p_K2_com_x = 7, /* K2.com.x [m] */
    p_K2_inertia_xx = 8, /* K2.inertia.xx [kg m^2] */
    p_K2_inertia_yy = 9, /* K2.inertia.yy [kg m^2] */
    p_K2_inertia_zz = 10, /* K2.inertia.zz [kg m^2] */
    p_gamma_position_x = 11, /* gamma.position.x [m] */
    p_gamma_position_y = 12, /* gamma.position.y [m] */
    p_K3_mass = 13, /* K3.mass [kg] */
    p_K3_com_x = 14, /* K3.com.x [m] */
    p_K3_com_y = 15, /* K3.com.y [m] */
    p_K3_inertia_xx = 16, /* K3.inertia.xx [kg m^2] */
    p_K3_inertia_yy = 17, /* K3.inertia.yy [kg m^2] */
    p_K3_inertia_zz = 18, /* K3.inertia.zz [kg m^2] */
    p_delta_position_x = 19, /* delta.position.x [m] */
    p_delta_position_y = 20, /* delta.position.y [m] */
    p_K5_mass = 21, /* K5.mass [kg] */
    p_K5_com_x = 22, /* K5.com.x [m] */
    p_K5_com_y = 23, /* K5.com.y [m] */
    p_K5_inertia_xx = 24, /* K5.inertia.xx [kg m^2] */
    p_K5_inertia_yy = 25, /* K5.inertia.yy [kg m^2] */
    p_K5_inertia_zz = 26, /* K5.inertia.zz [kg m^2] */
    p_phi_position_x = 27, /* phi.position.x [m] */
    p_K4_mass = 28, /* K4.mass [kg] */
    p_K4_com_y = 29, /* K4.com.y [m] */
    p_K4_inertia_xx = 30, /* K4.inertia.xx [kg m^2] */
    p_K4_inertia_yy = 31, /* K4.inertia.yy [kg m^2] */
    p_K4_inertia_zz = 32, /* K4.inertia.zz [kg m^2] */
    p_epsilon_position_x = 33, /* epsilon.position.x [m] */
    p_epsilon_position_y = 34, /* epsilon.position.y [m] */
    p_K7_mass = 35, /* K7.mass [kg] */
    p_K7_com_x = 36, /* K7.com.x [m] */
    p_K7_com_y = 37, /* K7.com.y [m] */
    p_K7_inertia_xx = 38, /* K7.inertia.xx [kg m^2] */
    p_K7_inertia_yy = 39, /* K7.inertia.yy [kg m^2] */
    p_K7_inertia_zz = 40, /* K7.inertia.zz [kg m^2] */
    p_omega_position_y = 41, /* omega.position.y [m] */
    p_K6_mass = 42, /* K6.mass [kg] */
    p_K6_com_x = 43, /* K6.com.x [m] */
    p_K6_inertia_xx = 44, /* K6.inertia.xx [kg m^2] */
    p_K6_inertia_yy = 45, /* K6.inertia.yy [kg m^2] */
    p_K6_inertia_zz = 46, /* K6.inertia.zz [kg m^2] */
    p_E3_position_x = 47, /* E3.position.x [m] */
    p_E3_child_position_y = 48, /* E3.child.position.y [m] */
    p_E4_child_position_y = 49, /* E4.child.position.y [m] */
    p_E6_child_position_x = 50, /* E6.child.position.x [m] */
    p_spring_stiffness = 51, /* spring.stiffness [N/m] */
    p_spring_rest_length = 52, /* spring.rest_length [m] */
    p_spring_a_position_x = 53, /* spring.a.position.x [m] */
    p_spring_a_position_y = 54, /* spring.a.position.y [m] */
    p_spring_b_position_x = 55, /* spring.b.position.x [m] */
    p_spring_b_position_y = 56, /* spring.b.position.y [m] */
    p_drive_force = 57 /* drive.force */
};

#endif
