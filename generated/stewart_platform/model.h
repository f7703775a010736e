/*
 * model.h: places of the entries of model 'stewart_platform'.
 *
 * Such as q[q_<coordinate>] or p[p_<parameter>]; units behind the names.
 */
#ifndef CARDAN_MODEL_H
#define CARDAN_MODEL_H

#include "cardan.h"

/* sizes */
enum {
    cardan_nq = 22,
    cardan_nu = 21,
    cardan_nr = 6,
    cardan_np = 96,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 13,
    cardan_nparts = 13
};

/* generalized coordinates */
enum {
    q_hooke0_angle1 = 0, /* hooke0.angle1 [rad] */
    q_hooke0_angle2 = 1, /* hooke0.angle2 [rad] */
    q_slide0 = 2, /* slide0 [m] */
    q_ball0_qw = 3, /* ball0.qw */
    q_ball0_qx = 4, /* ball0.qx */
    q_ball0_qy = 5, /* ball0.qy */
    q_ball0_qz = 6, /* ball0.qz */
    q_hooke1_angle1 = 7, /* hooke1.angle1 [rad] */
    q_hooke1_angle2 = 8, /* hooke1.angle2 [rad] */
    q_slide1 = 9, /* slide1 [m] */
    q_hooke2_angle1 = 10, /* hooke2.angle1 [rad] */
    q_hooke2_angle2 = 11, /* hooke2.angle2 [rad] */
    q_slide2 = 12, /* slide2 [m] */
    q_hooke3_angle1 = 13, /* hooke3.angle1 [rad] */
    q_hooke3_angle2 = 14, /* hooke3.angle2 [rad] */
    q_slide3 = 15, /* slide3 [m] */
    q_hooke4_angle1 = 16, /* hooke4.angle1 [rad] */
    q_hooke4_angle2 = 17, /* hooke4.angle2 [rad] */
    q_slide4 = 18, /* slide4 [m] */
    q_hooke5_angle1 = 19, /* hooke5.angle1 [rad] */
    q_hooke5_angle2 = 20, /* hooke5.angle2 [rad] */
    q_slide5 = 21 /* slide5 [m] */
};

/* generalized speeds */
enum {
    u_hooke0_u_angle1 = 0, /* hooke0.u.angle1 [rad/s] */
    u_hooke0_u_angle2 = 1, /* hooke0.u.angle2 [rad/s] */
    u_slide0_u = 2, /* slide0.u [m/s] */
    u_ball0_u_x = 3, /* ball0.u.x [rad/s] */
    u_ball0_u_y = 4, /* ball0.u.y [rad/s] */
    u_ball0_u_z = 5, /* ball0.u.z [rad/s] */
    u_hooke1_u_angle1 = 6, /* hooke1.u.angle1 [rad/s] */
    u_hooke1_u_angle2 = 7, /* hooke1.u.angle2 [rad/s] */
    u_slide1_u = 8, /* slide1.u [m/s] */
    u_hooke2_u_angle1 = 9, /* hooke2.u.angle1 [rad/s] */
    u_hooke2_u_angle2 = 10, /* hooke2.u.angle2 [rad/s] */
    u_slide2_u = 11, /* slide2.u [m/s] */
    u_hooke3_u_angle1 = 12, /* hooke3.u.angle1 [rad/s] */
    u_hooke3_u_angle2 = 13, /* hooke3.u.angle2 [rad/s] */
    u_slide3_u = 14, /* slide3.u [m/s] */
    u_hooke4_u_angle1 = 15, /* hooke4.u.angle1 [rad/s] */
    u_hooke4_u_angle2 = 16, /* hooke4.u.angle2 [rad/s] */
    u_slide4_u = 17, /* slide4.u [m/s] */
    u_hooke5_u_angle1 = 18, /* hooke5.u.angle1 [rad/s] */
    u_hooke5_u_angle2 = 19, /* hooke5.u.angle2 [rad/s] */
    u_slide5_u = 20 /* slide5.u [m/s] */
};

/* inputs */
enum {
    r_drive0 = 0, /* drive0 */
    r_drive1 = 1, /* drive1 */
    r_drive2 = 2, /* drive2 */
    r_drive3 = 3, /* drive3 */
    r_drive4 = 4, /* drive4 */
    r_drive5 = 5 /* drive5 */
};

/* parameters */
enum {
    p_gravity_z = 0, /* gravity.z [m/s^2] */
    p_hooke0_position_x = 1, /* hooke0.position.x [m] */
    p_hooke0_position_y = 2, /* hooke0.position.y [m] */
    p_tube0_mass = 3, /* tube0.mass [kg] */
    p_tube0_com_z = 4, /* tube0.com.z [m] */
    p_tube0_inertia_xx = 5, /* tube0.inertia.xx [kg m^2] */
    p_tube0_inertia_yy = 6, /* tube0.inertia.yy [kg m^2] */
    p_tube0_inertia_zz = 7, /* tube0.inertia.zz [kg m^2] */
    p_slide0_position_z = 8, /* slide0.position.z [m] */
    p_rod0_mass = 9, /* rod0.mass [kg] */
    p_rod0_com_z = 10, /* rod0.com.z [m] */
    p_rod0_inertia_xx = 11, /* rod0.inertia.xx [kg m^2] */
    p_rod0_inertia_yy = 12, /* rod0.inertia.yy [kg m^2] */
    p_rod0_inertia_zz = 13, /* rod0.inertia.zz [kg m^2] */
    p_ball0_child_position_x = 14, /* ball0.child.position.x [m] */
    p_ball0_child_position_y = 15, /* ball0.child.position.y [m] */
    p_platform_mass = 16, /* platform.mass [kg] */
    p_platform_com_z = 17, /* platform.com.z [m] */
    p_platform_inertia_xx = 18, /* platform.inertia.xx [kg m^2] */
    p_platform_inertia_yy = 19, /* platform.inertia.yy [kg m^2] */
    p_platform_inertia_zz = 20, /* platform.inertia.zz [kg m^2] */
    p_hooke1_position_x = 21, /* hooke1.position.x [m] */
    p_hooke1_position_y = 22, /* hooke1.position.y [m] */
    p_tube1_mass = 23, /* tube1.mass [kg] */
    p_tube1_com_z = 24, /* tube1.com.z [m] */
    p_tube1_inertia_xx = 25, /* tube1.inertia.xx [kg m^2] */
    p_tube1_inertia_yy = 26, /* tube1.inertia.yy [kg m^2] */
    p_tube1_inertia_zz = 27, /* tube1.inertia.zz [kg m^2] */
    p_slide1_position_z = 28, /* slide1.position.z [m] */
    p_rod1_mass = 29, /* rod1.mass [kg] */
    p_rod1_com_z = 30, /* rod1.com.z [m] */
    p_rod1_inertia_xx = 31, /* rod1.inertia.xx [kg m^2] */
    p_rod1_inertia_yy = 32, /* rod1.inertia.yy [kg m^2] */
    p_rod1_inertia_zz = 33, /* rod1.inertia.zz [kg m^2] */
    p_hooke2_position_x = 34, /* hooke2.position.x [m] */
    p_hooke2_position_y = 35, /* hooke2.position.y [m] */
    p_tube2_mass = 36, /* tube2.mass [kg] */
    p_tube2_com_z = 37, /* tube2.com.z [m] */
    p_tube2_inertia_xx = 38, /* tube2.inertia.xx [kg m^2] */
    p_tube2_inertia_yy = 39, /* tube2.inertia.yy [kg m^2] */
    p_tube2_inertia_zz = 40, /* tube2.inertia.zz [kg m^2] */
    p_slide2_position_z = 41, /* slide2.position.z [m] */
    p_rod2_mass = 42, /* rod2.mass [kg] */
    p_rod2_com_z = 43, /* rod2.com.z [m] */
    p_rod2_inertia_xx = 44, /* rod2.inertia.xx [kg m^2] */
    p_rod2_inertia_yy = 45, /* rod2.inertia.yy [kg m^2] */
    p_rod2_inertia_zz = 46, /* rod2.inertia.zz [kg m^2] */
    p_hooke3_position_x = 47, /* hooke3.position.x [m] */
    p_hooke3_position_y = 48, /* hooke3.position.y [m] */
    p_tube3_mass = 49, /* tube3.mass [kg] */
    p_tube3_com_z = 50, /* tube3.com.z [m] */
    p_tube3_inertia_xx = 51, /* tube3.inertia.xx [kg m^2] */
    p_tube3_inertia_yy = 52, /* tube3.inertia.yy [kg m^2] */
    p_tube3_inertia_zz = 53, /* tube3.inertia.zz [kg m^2] */
    p_slide3_position_z = 54, /* slide3.position.z [m] */
    p_rod3_mass = 55, /* rod3.mass [kg] */
    p_rod3_com_z = 56, /* rod3.com.z [m] */
    p_rod3_inertia_xx = 57, /* rod3.inertia.xx [kg m^2] */
    p_rod3_inertia_yy = 58, /* rod3.inertia.yy [kg m^2] */
    p_rod3_inertia_zz = 59, /* rod3.inertia.zz [kg m^2] */
    p_hooke4_position_x = 60, /* hooke4.position.x [m] */
    p_hooke4_position_y = 61, /* hooke4.position.y [m] */
    p_tube4_mass = 62, /* tube4.mass [kg] */
    p_tube4_com_z = 63, /* tube4.com.z [m] */
    p_tube4_inertia_xx = 64, /* tube4.inertia.xx [kg m^2] */
    p_tube4_inertia_yy = 65, /* tube4.inertia.yy [kg m^2] */
    p_tube4_inertia_zz = 66, /* tube4.inertia.zz [kg m^2] */
    p_slide4_position_z = 67, /* slide4.position.z [m] */
    p_rod4_mass = 68, /* rod4.mass [kg] */
    p_rod4_com_z = 69, /* rod4.com.z [m] */
    p_rod4_inertia_xx = 70, /* rod4.inertia.xx [kg m^2] */
    p_rod4_inertia_yy = 71, /* rod4.inertia.yy [kg m^2] */
    p_rod4_inertia_zz = 72, /* rod4.inertia.zz [kg m^2] */
    p_hooke5_position_x = 73, /* hooke5.position.x [m] */
    p_hooke5_position_y = 74, /* hooke5.position.y [m] */
    p_tube5_mass = 75, /* tube5.mass [kg] */
    p_tube5_com_z = 76, /* tube5.com.z [m] */
    p_tube5_inertia_xx = 77, /* tube5.inertia.xx [kg m^2] */
    p_tube5_inertia_yy = 78, /* tube5.inertia.yy [kg m^2] */
    p_tube5_inertia_zz = 79, /* tube5.inertia.zz [kg m^2] */
    p_slide5_position_z = 80, /* slide5.position.z [m] */
    p_rod5_mass = 81, /* rod5.mass [kg] */
    p_rod5_com_z = 82, /* rod5.com.z [m] */
    p_rod5_inertia_xx = 83, /* rod5.inertia.xx [kg m^2] */
    p_rod5_inertia_yy = 84, /* rod5.inertia.yy [kg m^2] */
    p_rod5_inertia_zz = 85, /* rod5.inertia.zz [kg m^2] */
    p_ball1_child_position_x = 86, /* ball1.child.position.x [m] */
    p_ball1_child_position_y = 87, /* ball1.child.position.y [m] */
    p_ball2_child_position_x = 88, /* ball2.child.position.x [m] */
    p_ball2_child_position_y = 89, /* ball2.child.position.y [m] */
    p_ball3_child_position_x = 90, /* ball3.child.position.x [m] */
    p_ball3_child_position_y = 91, /* ball3.child.position.y [m] */
    p_ball4_child_position_x = 92, /* ball4.child.position.x [m] */
    p_ball4_child_position_y = 93, /* ball4.child.position.y [m] */
    p_ball5_child_position_x = 94, /* ball5.child.position.x [m] */
    p_ball5_child_position_y = 95 /* ball5.child.position.y [m] */
};

#endif
