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
    cardan_nq = 78,
    cardan_nu = 67,
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
    q_bar_start_w = 1, /* bar.start.w */
    q_bar_start_x = 2, /* bar.start.x */
    q_bar_start_y = 3, /* bar.start.y */
    q_bar_start_z = 4, /* bar.start.z */
    q_bar_start_px = 5, /* bar.start.px [m] */
    q_bar_start_py = 6, /* bar.start.py [m] */
    q_bar_start_pz = 7, /* bar.start.pz [m] */
    q_bar_end_w = 8, /* bar.end.w */
    q_bar_end_x = 9, /* bar.end.x */
    q_bar_end_y = 10, /* bar.end.y */
    q_bar_end_z = 11, /* bar.end.z */
    q_bar_end_px = 12, /* bar.end.px [m] */
    q_bar_end_py = 13, /* bar.end.py [m] */
    q_bar_end_pz = 14, /* bar.end.pz [m] */
    q_bar_node1_w = 15, /* bar.node1.w */
    q_bar_node1_x = 16, /* bar.node1.x */
    q_bar_node1_y = 17, /* bar.node1.y */
    q_bar_node1_z = 18, /* bar.node1.z */
    q_bar_node1_px = 19, /* bar.node1.px [m] */
    q_bar_node1_py = 20, /* bar.node1.py [m] */
    q_bar_node1_pz = 21, /* bar.node1.pz [m] */
    q_bar_node2_w = 22, /* bar.node2.w */
    q_bar_node2_x = 23, /* bar.node2.x */
    q_bar_node2_y = 24, /* bar.node2.y */
    q_bar_node2_z = 25, /* bar.node2.z */
    q_bar_node2_px = 26, /* bar.node2.px [m] */
    q_bar_node2_py = 27, /* bar.node2.py [m] */
    q_bar_node2_pz = 28, /* bar.node2.pz [m] */
    q_bar_node3_w = 29, /* bar.node3.w */
    q_bar_node3_x = 30, /* bar.node3.x */
    q_bar_node3_y = 31, /* bar.node3.y */
    q_bar_node3_z = 32, /* bar.node3.z */
    q_bar_node3_px = 33, /* bar.node3.px [m] */
    q_bar_node3_py = 34, /* bar.node3.py [m] */
    q_bar_node3_pz = 35, /* bar.node3.pz [m] */
    q_bar_node4_w = 36, /* bar.node4.w */
    q_bar_node4_x = 37, /* bar.node4.x */
    q_bar_node4_y = 38, /* bar.node4.y */
    q_bar_node4_z = 39, /* bar.node4.z */
    q_bar_node4_px = 40, /* bar.node4.px [m] */
    q_bar_node4_py = 41, /* bar.node4.py [m] */
    q_bar_node4_pz = 42, /* bar.node4.pz [m] */
    q_bar_node5_w = 43, /* bar.node5.w */
    q_bar_node5_x = 44, /* bar.node5.x */
    q_bar_node5_y = 45, /* bar.node5.y */
    q_bar_node5_z = 46, /* bar.node5.z */
    q_bar_node5_px = 47, /* bar.node5.px [m] */
    q_bar_node5_py = 48, /* bar.node5.py [m] */
    q_bar_node5_pz = 49, /* bar.node5.pz [m] */
    q_bar_node6_w = 50, /* bar.node6.w */
    q_bar_node6_x = 51, /* bar.node6.x */
    q_bar_node6_y = 52, /* bar.node6.y */
    q_bar_node6_z = 53, /* bar.node6.z */
    q_bar_node6_px = 54, /* bar.node6.px [m] */
    q_bar_node6_py = 55, /* bar.node6.py [m] */
    q_bar_node6_pz = 56, /* bar.node6.pz [m] */
    q_bar_node7_w = 57, /* bar.node7.w */
    q_bar_node7_x = 58, /* bar.node7.x */
    q_bar_node7_y = 59, /* bar.node7.y */
    q_bar_node7_z = 60, /* bar.node7.z */
    q_bar_node7_px = 61, /* bar.node7.px [m] */
    q_bar_node7_py = 62, /* bar.node7.py [m] */
    q_bar_node7_pz = 63, /* bar.node7.pz [m] */
    q_bar_node8_w = 64, /* bar.node8.w */
    q_bar_node8_x = 65, /* bar.node8.x */
    q_bar_node8_y = 66, /* bar.node8.y */
    q_bar_node8_z = 67, /* bar.node8.z */
    q_bar_node8_px = 68, /* bar.node8.px [m] */
    q_bar_node8_py = 69, /* bar.node8.py [m] */
    q_bar_node8_pz = 70, /* bar.node8.pz [m] */
    q_bar_node9_w = 71, /* bar.node9.w */
    q_bar_node9_x = 72, /* bar.node9.x */
    q_bar_node9_y = 73, /* bar.node9.y */
    q_bar_node9_z = 74, /* bar.node9.z */
    q_bar_node9_px = 75, /* bar.node9.px [m] */
    q_bar_node9_py = 76, /* bar.node9.py [m] */
    q_bar_node9_pz = 77 /* bar.node9.pz [m] */
};

/* generalized speeds */
enum {
    u_pin_u = 0, /* pin.u [rad/s] */
    u_bar_start_u_x = 1, /* bar.start.u.x [rad/s] */
    u_bar_start_u_y = 2, /* bar.start.u.y [rad/s] */
    u_bar_start_u_z = 3, /* bar.start.u.z [rad/s] */
    u_bar_start_u_px = 4, /* bar.start.u.px [m/s] */
    u_bar_start_u_py = 5, /* bar.start.u.py [m/s] */
    u_bar_start_u_pz = 6, /* bar.start.u.pz [m/s] */
    u_bar_end_u_x = 7, /* bar.end.u.x [rad/s] */
    u_bar_end_u_y = 8, /* bar.end.u.y [rad/s] */
    u_bar_end_u_z = 9, /* bar.end.u.z [rad/s] */
    u_bar_end_u_px = 10, /* bar.end.u.px [m/s] */
    u_bar_end_u_py = 11, /* bar.end.u.py [m/s] */
    u_bar_end_u_pz = 12, /* bar.end.u.pz [m/s] */
    u_bar_node1_u_x = 13, /* bar.node1.u.x [rad/s] */
    u_bar_node1_u_y = 14, /* bar.node1.u.y [rad/s] */
    u_bar_node1_u_z = 15, /* bar.node1.u.z [rad/s] */
    u_bar_node1_u_px = 16, /* bar.node1.u.px [m/s] */
    u_bar_node1_u_py = 17, /* bar.node1.u.py [m/s] */
    u_bar_node1_u_pz = 18, /* bar.node1.u.pz [m/s] */
    u_bar_node2_u_x = 19, /* bar.node2.u.x [rad/s] */
    u_bar_node2_u_y = 20, /* bar.node2.u.y [rad/s] */
    u_bar_node2_u_z = 21, /* bar.node2.u.z [rad/s] */
    u_bar_node2_u_px = 22, /* bar.node2.u.px [m/s] */
    u_bar_node2_u_py = 23, /* bar.node2.u.py [m/s] */
    u_bar_node2_u_pz = 24, /* bar.node2.u.pz [m/s] */
    u_bar_node3_u_x = 25, /* bar.node3.u.x [rad/s] */
    u_bar_node3_u_y = 26, /* bar.node3.u.y [rad/s] */
    u_bar_node3_u_z = 27, /* bar.node3.u.z [rad/s] */
    u_bar_node3_u_px = 28, /* bar.node3.u.px [m/s] */
    u_bar_node3_u_py = 29, /* bar.node3.u.py [m/s] */
    u_bar_node3_u_pz = 30, /* bar.node3.u.pz [m/s] */
    u_bar_node4_u_x = 31, /* bar.node4.u.x [rad/s] */
    u_bar_node4_u_y = 32, /* bar.node4.u.y [rad/s] */
    u_bar_node4_u_z = 33, /* bar.node4.u.z [rad/s] */
    u_bar_node4_u_px = 34, /* bar.node4.u.px [m/s] */
    u_bar_node4_u_py = 35, /* bar.node4.u.py [m/s] */
    u_bar_node4_u_pz = 36, /* bar.node4.u.pz [m/s] */
    u_bar_node5_u_x = 37, /* bar.node5.u.x [rad/s] */
    u_bar_node5_u_y = 38, /* bar.node5.u.y [rad/s] */
    u_bar_node5_u_z = 39, /* bar.node5.u.z [rad/s] */
    u_bar_node5_u_px = 40, /* bar.node5.u.px [m/s] */
    u_bar_node5_u_py = 41, /* bar.node5.u.py [m/s] */
    u_bar_node5_u_pz = 42, /* bar.node5.u.pz [m/s] */
    u_bar_node6_u_x = 43, /* bar.node6.u.x [rad/s] */
    u_bar_node6_u_y = 44, /* bar.node6.u.y [rad/s] */
    u_bar_node6_u_z = 45, /* bar.node6.u.z [rad/s] */
    u_bar_node6_u_px = 46, /* bar.node6.u.px [m/s] */
    u_bar_node6_u_py = 47, /* bar.node6.u.py [m/s] */
    u_bar_node6_u_pz = 48, /* bar.node6.u.pz [m/s] */
    u_bar_node7_u_x = 49, /* bar.node7.u.x [rad/s] */
    u_bar_node7_u_y = 50, /* bar.node7.u.y [rad/s] */
    u_bar_node7_u_z = 51, /* bar.node7.u.z [rad/s] */
    u_bar_node7_u_px = 52, /* bar.node7.u.px [m/s] */
    u_bar_node7_u_py = 53, /* bar.node7.u.py [m/s] */
    u_bar_node7_u_pz = 54, /* bar.node7.u.pz [m/s] */
    u_bar_node8_u_x = 55, /* bar.node8.u.x [rad/s] */
    u_bar_node8_u_y = 56, /* bar.node8.u.y [rad/s] */
    u_bar_node8_u_z = 57, /* bar.node8.u.z [rad/s] */
    u_bar_node8_u_px = 58, /* bar.node8.u.px [m/s] */
    u_bar_node8_u_py = 59, /* bar.node8.u.py [m/s] */
    u_bar_node8_u_pz = 60, /* bar.node8.u.pz [m/s] */
    u_bar_node9_u_x = 61, /* bar.node9.u.x [rad/s] */
    u_bar_node9_u_y = 62, /* bar.node9.u.y [rad/s] */
    u_bar_node9_u_z = 63, /* bar.node9.u.z [rad/s] */
    u_bar_node9_u_px = 64, /* bar.node9.u.px [m/s] */
    u_bar_node9_u_py = 65, /* bar.node9.u.py [m/s] */
    u_bar_node9_u_pz = 66 /* bar.node9.u.pz [m/s] */
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
