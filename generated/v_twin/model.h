/*
 * model.h: places of the entries of model 'v_twin'.
 *
 * Such as q[q_<coordinate>] or p[p_<parameter>]; units behind the names.
 */
#ifndef CARDAN_MODEL_H
#define CARDAN_MODEL_H

#include "cardan.h"

/* sizes */
enum {
    cardan_nq = 6,
    cardan_nu = 6,
    cardan_nr = 4,
    cardan_np = 18,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 6,
    cardan_nparts = 6
};

/* generalized coordinates */
enum {
    q_right_crank = 0, /* right.crank [rad] */
    q_right_rod = 1, /* right.rod [rad] */
    q_right_piston = 2, /* right.piston [m] */
    q_left_crank = 3, /* left.crank [rad] */
    q_left_rod = 4, /* left.rod [rad] */
    q_left_piston = 5 /* left.piston [m] */
};

/* generalized speeds */
enum {
    u_right_crank_u = 0, /* right.crank.u [rad/s] */
    u_right_rod_u = 1, /* right.rod.u [rad/s] */
    u_right_piston_u = 2, /* right.piston.u [m/s] */
    u_left_crank_u = 3, /* left.crank.u [rad/s] */
    u_left_rod_u = 4, /* left.rod.u [rad/s] */
    u_left_piston_u = 5 /* left.piston.u [m/s] */
};

/* inputs */
enum {
    r_right_torque = 0, /* right.torque [N m] */
    r_right_force = 1, /* right.force [N] */
    r_left_torque = 2, /* left.torque [N m] */
    r_left_force = 3 /* left.force [N] */
};

/* parameters */
enum {
    p_right_crank_length = 0, /* right.crank_length [m] */
    p_right_rod_length = 1, /* right.rod_length [m] */
    p_right_offset = 2, /* right.offset [m] */
    p_right_bore = 3, /* right.bore [m] */
    p_right_crank_mass = 4, /* right.crank_mass [kg] */
    p_right_rod_mass = 5, /* right.rod_mass [kg] */
    p_right_piston_mass = 6, /* right.piston_mass [kg] */
    p_left_crank_length = 7, /* left.crank_length [m] */
    p_left_rod_length = 8, /* left.rod_length [m] */
    p_left_offset = 9, /* left.offset [m] */
    p_left_bore = 10, /* left.bore [m] */
    p_left_crank_mass = 11, /* left.crank_mass [kg] */
    p_left_rod_mass = 12, /* left.rod_mass [kg] */
    p_left_piston_mass = 13, /* left.piston_mass [kg] */
    p_gravity_z = 14, /* gravity.z [m/s^2] */
    p_right_ground_rotation_angle2 = 15, /* right.ground.rotation.angle2 [rad] */
    p_left_ground_position_y = 16, /* left.ground.position.y [m] */
    p_left_ground_rotation_angle2 = 17 /* left.ground.rotation.angle2 [rad] */
};

#endif
