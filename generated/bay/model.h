/*
 * model.h: places of the entries of model 'bay'.
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
    cardan_np = 55,
    cardan_nz = 0,
    cardan_ns = 1,
    cardan_nbodies = 2,
    cardan_nparts = 2
};

/* generalized coordinates */
enum {
    q_height = 0, /* height [m] */
    q_twist = 1 /* twist [rad] */
};

/* generalized speeds */
enum {
    u_height_u = 0, /* height.u [m/s] */
    u_twist_u = 1 /* twist.u [rad/s] */
};

/* parameters */
enum {
    p_load = 0, /* load [N] */
    p_cable0_EA = 1, /* cable0.EA [N] */
    p_cable0_length = 2, /* cable0.length [m] */
    p_cable0_damping = 3, /* cable0.damping [s] */
    p_counter0_EA = 4, /* counter0.EA [N] */
    p_counter0_length = 5, /* counter0.length [m] */
    p_counter0_damping = 6, /* counter0.damping [s] */
    p_cable1_EA = 7, /* cable1.EA [N] */
    p_cable1_length = 8, /* cable1.length [m] */
    p_cable1_damping = 9, /* cable1.damping [s] */
    p_counter1_EA = 10, /* counter1.EA [N] */
    p_counter1_length = 11, /* counter1.length [m] */
    p_counter1_damping = 12, /* counter1.damping [s] */
    p_cable2_EA = 13, /* cable2.EA [N] */
    p_cable2_length = 14, /* cable2.length [m] */
    p_cable2_damping = 15, /* cable2.damping [s] */
    p_counter2_EA = 16, /* counter2.EA [N] */
    p_counter2_length = 17, /* counter2.length [m] */
    p_counter2_damping = 18, /* counter2.damping [s] */
    p_top_mass = 19, /* top.mass [kg] */
    p_top_inertia_xx = 20, /* top.inertia.xx [kg m^2] */
    p_top_inertia_yy = 21, /* top.inertia.yy [kg m^2] */
    p_top_inertia_zz = 22, /* top.inertia.zz [kg m^2] */
    p_bar0_stiffness = 23, /* bar0.stiffness [N/m] */
    p_bar0_damping = 24, /* bar0.damping [N*s/m] */
    p_bar0_rest_length = 25, /* bar0.rest_length [m] */
    p_bar0_a_position_x = 26, /* bar0.a.position.x [m] */
    p_bar0_b_position_x = 27, /* bar0.b.position.x [m] */
    p_bar1_stiffness = 28, /* bar1.stiffness [N/m] */
    p_bar1_damping = 29, /* bar1.damping [N*s/m] */
    p_bar1_rest_length = 30, /* bar1.rest_length [m] */
    p_bar1_a_position_x = 31, /* bar1.a.position.x [m] */
    p_bar1_a_position_y = 32, /* bar1.a.position.y [m] */
    p_bar1_b_position_x = 33, /* bar1.b.position.x [m] */
    p_bar1_b_position_y = 34, /* bar1.b.position.y [m] */
    p_bar2_stiffness = 35, /* bar2.stiffness [N/m] */
    p_bar2_damping = 36, /* bar2.damping [N*s/m] */
    p_bar2_rest_length = 37, /* bar2.rest_length [m] */
    p_bar2_a_position_x = 38, /* bar2.a.position.x [m] */
    p_bar2_a_position_y = 39, /* bar2.a.position.y [m] */
    p_bar2_b_position_x = 40, /* bar2.b.position.x [m] */
    p_bar2_b_position_y = 41, /* bar2.b.position.y [m] */
    p_end_upper = 42, /* end.upper [rad] */
    p_end_restitution = 43, /* end.restitution */
    p_end_settle = 44, /* end.settle [rad/s] */
    p_cable0_b_position_x = 45, /* cable0.b.position.x [m] */
    p_cable0_b_position_y = 46, /* cable0.b.position.y [m] */
    p_counter0_b_position_x = 47, /* counter0.b.position.x [m] */
    p_counter0_b_position_y = 48, /* counter0.b.position.y [m] */
    p_cable1_b_position_x = 49, /* cable1.b.position.x [m] */
    p_cable1_b_position_y = 50, /* cable1.b.position.y [m] */
    p_counter1_b_position_x = 51, /* counter1.b.position.x [m] */
    p_cable2_b_position_x = 52, /* cable2.b.position.x [m] */
    p_counter2_b_position_x = 53, /* counter2.b.position.x [m] */
    p_counter2_b_position_y = 54 /* counter2.b.position.y [m] */
};

#endif
