/*
 * model.h: places of the entries of model 'arm'.
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
    cardan_np = 29,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 3,
    cardan_nparts = 4
};

/* generalized coordinates */
enum {
    q_waist = 0, /* waist [rad] */
    q_shoulder = 1, /* shoulder [rad] */
    q_elbow = 2 /* elbow [rad] */
};

/* generalized speeds */
enum {
    u_waist_u = 0, /* waist.u [rad/s] */
    u_shoulder_u = 1, /* shoulder.u [rad/s] */
    u_elbow_u = 2 /* elbow.u [rad/s] */
};

/* parameters */
enum {
    p_gravity_z = 0, /* gravity.z [m/s^2] */
    p_column_mass = 1, /* column.mass [kg] */
    p_column_com_z = 2, /* column.com.z [m] */
    p_column_inertia_xx = 3, /* column.inertia.xx [kg m^2] */
    p_column_inertia_yy = 4, /* column.inertia.yy [kg m^2] */
    p_column_inertia_zz = 5, /* column.inertia.zz [kg m^2] */
    p_shoulder_position_z = 6, /* shoulder.position.z [m] */
    p_upper_arm_mass = 7, /* upper_arm.mass [kg] */
    p_upper_arm_com_x = 8, /* upper_arm.com.x [m] */
    p_upper_arm_inertia_xx = 9, /* upper_arm.inertia.xx [kg m^2] */
    p_upper_arm_inertia_yy = 10, /* upper_arm.inertia.yy [kg m^2] */
    p_upper_arm_inertia_zz = 11, /* upper_arm.inertia.zz [kg m^2] */
    p_elbow_position_x = 12, /* elbow.position.x [m] */
    p_forearm_mass = 13, /* forearm.mass [kg] */
    p_forearm_com_x = 14, /* forearm.com.x [m] */
    p_forearm_com_y = 15, /* forearm.com.y [m] */
    p_forearm_inertia_xx = 16, /* forearm.inertia.xx [kg m^2] */
    p_forearm_inertia_xz = 17, /* forearm.inertia.xz [kg m^2] */
    p_forearm_inertia_yy = 18, /* forearm.inertia.yy [kg m^2] */
    p_forearm_inertia_zz = 19, /* forearm.inertia.zz [kg m^2] */
    p_wrist_position_x = 20, /* wrist.position.x [m] */
    p_wrist_rotation_yaw = 21, /* wrist.rotation.yaw [rad] */
    p_hand_mass = 22, /* hand.mass [kg] */
    p_hand_inertia_xx = 23, /* hand.inertia.xx [kg m^2] */
    p_hand_inertia_yy = 24, /* hand.inertia.yy [kg m^2] */
    p_hand_inertia_zz = 25, /* hand.inertia.zz [kg m^2] */
    p_waist_damping = 26, /* waist.damping [N*m*s/rad] */
    p_shoulder_damping = 27, /* shoulder.damping [N*m*s/rad] */
    p_elbow_damping = 28 /* elbow.damping [N*m*s/rad] */
};

#endif
