/*
 * model.h: places of the entries of model 'flexible_pendulum'.
 *
 * Such as q[q_<coordinate>] or p[p_<parameter>]; units behind the names.
 */
#ifndef CARDAN_MODEL_H
#define CARDAN_MODEL_H

#include "cardan.h"

/* sizes */
enum {
    cardan_nq = 71,
    cardan_nu = 61,
    cardan_nr = 0,
    cardan_np = 6,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 2,
    cardan_nparts = 2
};

/* generalized coordinates */
enum {
    q_pin = 0, /* pin [rad] */
    q_bar_end_qw = 1, /* bar.end.qw */
    q_bar_end_qx = 2, /* bar.end.qx */
    q_bar_end_qy = 3, /* bar.end.qy */
    q_bar_end_qz = 4, /* bar.end.qz */
    q_bar_end_px = 5, /* bar.end.px [m] */
    q_bar_end_py = 6, /* bar.end.py [m] */
    q_bar_end_pz = 7, /* bar.end.pz [m] */
    q_bar_node1_qw = 8, /* bar.node1.qw */
    q_bar_node1_qx = 9, /* bar.node1.qx */
    q_bar_node1_qy = 10, /* bar.node1.qy */
    q_bar_node1_qz = 11, /* bar.node1.qz */
    q_bar_node1_px = 12, /* bar.node1.px [m] */
    q_bar_node1_py = 13, /* bar.node1.py [m] */
    q_bar_node1_pz = 14, /* bar.node1.pz [m] */
    q_bar_node2_qw = 15, /* bar.node2.qw */
    q_bar_node2_qx = 16, /* bar.node2.qx */
    q_bar_node2_qy = 17, /* bar.node2.qy */
    q_bar_node2_qz = 18, /* bar.node2.qz */
    q_bar_node2_px = 19, /* bar.node2.px [m] */
    q_bar_node2_py = 20, /* bar.node2.py [m] */
    q_bar_node2_pz = 21, /* bar.node2.pz [m] */
    q_bar_node3_qw = 22, /* bar.node3.qw */
    q_bar_node3_qx = 23, /* bar.node3.qx */
    q_bar_node3_qy = 24, /* bar.node3.qy */
    q_bar_node3_qz = 25, /* bar.node3.qz */
    q_bar_node3_px = 26, /* bar.node3.px [m] */
    q_bar_node3_py = 27, /* bar.node3.py [m] */
    q_bar_node3_pz = 28, /* bar.node3.pz [m] */
    q_bar_node4_qw = 29, /* bar.node4.qw */
    q_bar_node4_qx = 30, /* bar.node4.qx */
    q_bar_node4_qy = 31, /* bar.node4.qy */
    q_bar_node4_qz = 32, /* bar.node4.qz */
    q_bar_node4_px = 33, /* bar.node4.px [m] */
    q_bar_node4_py = 34, /* bar.node4.py [m] */
    q_bar_node4_pz = 35, /* bar.node4.pz [m] */
    q_bar_node5_qw = 36, /* bar.node5.qw */
    q_bar_node5_qx = 37, /* bar.node5.qx */
    q_bar_node5_qy = 38, /* bar.node5.qy */
    q_bar_node5_qz = 39, /* bar.node5.qz */
    q_bar_node5_px = 40, /* bar.node5.px [m] */
    q_bar_node5_py = 41, /* bar.node5.py [m] */
    q_bar_node5_pz = 42, /* bar.node5.pz [m] */
    q_bar_node6_qw = 43, /* bar.node6.qw */
    q_bar_node6_qx = 44, /* bar.node6.qx */
    q_bar_node6_qy = 45, /* bar.node6.qy */
    q_bar_node6_qz = 46, /* bar.node6.qz */
    q_bar_node6_px = 47, /* bar.node6.px [m] */
    q_bar_node6_py = 48, /* bar.node6.py [m] */
    q_bar_node6_pz = 49, /* bar.node6.pz [m] */
    q_bar_node7_qw = 50, /* bar.node7.qw */
    q_bar_node7_qx = 51, /* bar.node7.qx */
    q_bar_node7_qy = 52, /* bar.node7.qy */
    q_bar_node7_qz = 53, /* bar.node7.qz */
    q_bar_node7_px = 54, /* bar.node7.px [m] */
    q_bar_node7_py = 55, /* bar.node7.py [m] */
    q_bar_node7_pz = 56, /* bar.node7.pz [m] */
    q_bar_node8_qw = 57, /* bar.node8.qw */
    q_bar_node8_qx = 58, /* bar.node8.qx */
    q_bar_node8_qy = 59, /* bar.node8.qy */
    q_bar_node8_qz = 60, /* bar.node8.qz */
    q_bar_node8_px = 61, /* bar.node8.px [m] */
    q_bar_node8_py = 62, /* bar.node8.py [m] */
    q_bar_node8_pz = 63, /* bar.node8.pz [m] */
    q_bar_node9_qw = 64, /* bar.node9.qw */
    q_bar_node9_qx = 65, /* bar.node9.qx */
    q_bar_node9_qy = 66, /* bar.node9.qy */
    q_bar_node9_qz = 67, /* bar.node9.qz */
    q_bar_node9_px = 68, /* bar.node9.px [m] */
    q_bar_node9_py = 69, /* bar.node9.py [m] */
    q_bar_node9_pz = 70 /* bar.node9.pz [m] */
};

/* generalized speeds */
enum {
    u_pin_u = 0, /* pin.u [rad/s] */
    u_bar_end_u_x = 1, /* bar.end.u.x [rad/s] */
    u_bar_end_u_y = 2, /* bar.end.u.y [rad/s] */
    u_bar_end_u_z = 3, /* bar.end.u.z [rad/s] */
    u_bar_end_u_px = 4, /* bar.end.u.px [m/s] */
    u_bar_end_u_py = 5, /* bar.end.u.py [m/s] */
    u_bar_end_u_pz = 6, /* bar.end.u.pz [m/s] */
    u_bar_node1_u_x = 7, /* bar.node1.u.x [rad/s] */
    u_bar_node1_u_y = 8, /* bar.node1.u.y [rad/s] */
    u_bar_node1_u_z = 9, /* bar.node1.u.z [rad/s] */
    u_bar_node1_u_px = 10, /* bar.node1.u.px [m/s] */
    u_bar_node1_u_py = 11, /* bar.node1.u.py [m/s] */
    u_bar_node1_u_pz = 12, /* bar.node1.u.pz [m/s] */
    u_bar_node2_u_x = 13, /* bar.node2.u.x [rad/s] */
    u_bar_node2_u_y = 14, /* bar.node2.u.y [rad/s] */
    u_bar_node2_u_z = 15, /* bar.node2.u.z [rad/s] */
    u_bar_node2_u_px = 16, /* bar.node2.u.px [m/s] */
    u_bar_node2_u_py = 17, /* bar.node2.u.py [m/s] */
    u_bar_node2_u_pz = 18, /* bar.node2.u.pz [m/s] */
    u_bar_node3_u_x = 19, /* bar.node3.u.x [rad/s] */
    u_bar_node3_u_y = 20, /* bar.node3.u.y [rad/s] */
    u_bar_node3_u_z = 21, /* bar.node3.u.z [rad/s] */
    u_bar_node3_u_px = 22, /* bar.node3.u.px [m/s] */
    u_bar_node3_u_py = 23, /* bar.node3.u.py [m/s] */
    u_bar_node3_u_pz = 24, /* bar.node3.u.pz [m/s] */
    u_bar_node4_u_x = 25, /* bar.node4.u.x [rad/s] */
    u_bar_node4_u_y = 26, /* bar.node4.u.y [rad/s] */
    u_bar_node4_u_z = 27, /* bar.node4.u.z [rad/s] */
    u_bar_node4_u_px = 28, /* bar.node4.u.px [m/s] */
    u_bar_node4_u_py = 29, /* bar.node4.u.py [m/s] */
    u_bar_node4_u_pz = 30, /* bar.node4.u.pz [m/s] */
    u_bar_node5_u_x = 31, /* bar.node5.u.x [rad/s] */
    u_bar_node5_u_y = 32, /* bar.node5.u.y [rad/s] */
    u_bar_node5_u_z = 33, /* bar.node5.u.z [rad/s] */
    u_bar_node5_u_px = 34, /* bar.node5.u.px [m/s] */
    u_bar_node5_u_py = 35, /* bar.node5.u.py [m/s] */
    u_bar_node5_u_pz = 36, /* bar.node5.u.pz [m/s] */
    u_bar_node6_u_x = 37, /* bar.node6.u.x [rad/s] */
    u_bar_node6_u_y = 38, /* bar.node6.u.y [rad/s] */
    u_bar_node6_u_z = 39, /* bar.node6.u.z [rad/s] */
    u_bar_node6_u_px = 40, /* bar.node6.u.px [m/s] */
    u_bar_node6_u_py = 41, /* bar.node6.u.py [m/s] */
    u_bar_node6_u_pz = 42, /* bar.node6.u.pz [m/s] */
    u_bar_node7_u_x = 43, /* bar.node7.u.x [rad/s] */
    u_bar_node7_u_y = 44, /* bar.node7.u.y [rad/s] */
    u_bar_node7_u_z = 45, /* bar.node7.u.z [rad/s] */
    u_bar_node7_u_px = 46, /* bar.node7.u.px [m/s] */
    u_bar_node7_u_py = 47, /* bar.node7.u.py [m/s] */
    u_bar_node7_u_pz = 48, /* bar.node7.u.pz [m/s] */
    u_bar_node8_u_x = 49, /* bar.node8.u.x [rad/s] */
    u_bar_node8_u_y = 50, /* bar.node8.u.y [rad/s] */
    u_bar_node8_u_z = 51, /* bar.node8.u.z [rad/s] */
    u_bar_node8_u_px = 52, /* bar.node8.u.px [m/s] */
    u_bar_node8_u_py = 53, /* bar.node8.u.py [m/s] */
    u_bar_node8_u_pz = 54, /* bar.node8.u.pz [m/s] */
    u_bar_node9_u_x = 55, /* bar.node9.u.x [rad/s] */
    u_bar_node9_u_y = 56, /* bar.node9.u.y [rad/s] */
    u_bar_node9_u_z = 57, /* bar.node9.u.z [rad/s] */
    u_bar_node9_u_px = 58, /* bar.node9.u.px [m/s] */
    u_bar_node9_u_py = 59, /* bar.node9.u.py [m/s] */
    u_bar_node9_u_pz = 60 /* bar.node9.u.pz [m/s] */
};

/* parameters */
enum {
    p_gravity_z = 0, /* gravity.z [m/s^2] */
    p_bar_section_width = 1, /* bar.section.width [m] */
    p_bar_section_height = 2, /* bar.section.height [m] */
    p_bar_material_E = 3, /* bar.material.E [Pa] */
    p_bar_material_nu = 4, /* bar.material.nu */
    p_bar_material_rho = 5 /* bar.material.rho [kg/m^3] */
};

#endif
