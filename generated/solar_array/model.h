/*
 * model.h: places of the entries of model 'solar_array'.
 *
 * Such as q[q_<coordinate>] or p[p_<parameter>]; units behind the names.
 */
#ifndef CARDAN_MODEL_H
#define CARDAN_MODEL_H

#include "cardan.h"

/* sizes */
enum {
    cardan_nq = 11,
    cardan_nu = 10,
    cardan_nr = 0,
    cardan_np = 30,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 5,
    cardan_nparts = 5
};

/* generalized coordinates */
enum {
    q_drift_qw = 0, /* drift.qw */
    q_drift_qx = 1, /* drift.qx */
    q_drift_qy = 2, /* drift.qy */
    q_drift_qz = 3, /* drift.qz */
    q_drift_px = 4, /* drift.px [m] */
    q_drift_py = 5, /* drift.py [m] */
    q_drift_pz = 6, /* drift.pz [m] */
    q_hinge0 = 7, /* hinge0 [rad] */
    q_hinge1 = 8, /* hinge1 [rad] */
    q_hinge2 = 9, /* hinge2 [rad] */
    q_hinge3 = 10 /* hinge3 [rad] */
};

/* generalized speeds */
enum {
    u_drift_u_x = 0, /* drift.u.x [rad/s] */
    u_drift_u_y = 1, /* drift.u.y [rad/s] */
    u_drift_u_z = 2, /* drift.u.z [rad/s] */
    u_drift_u_px = 3, /* drift.u.px [m/s] */
    u_drift_u_py = 4, /* drift.u.py [m/s] */
    u_drift_u_pz = 5, /* drift.u.pz [m/s] */
    u_hinge0_u = 6, /* hinge0.u [rad/s] */
    u_hinge1_u = 7, /* hinge1.u [rad/s] */
    u_hinge2_u = 8, /* hinge2.u [rad/s] */
    u_hinge3_u = 9 /* hinge3.u [rad/s] */
};

/* parameters */
enum {
    p_hub_mass = 0, /* hub.mass [kg] */
    p_hub_inertia_xx = 1, /* hub.inertia.xx [kg m^2] */
    p_hub_inertia_yy = 2, /* hub.inertia.yy [kg m^2] */
    p_hub_inertia_zz = 3, /* hub.inertia.zz [kg m^2] */
    p_hinge0_position_x = 4, /* hinge0.position.x [m] */
    p_panel0_mass = 5, /* panel0.mass [kg] */
    p_panel0_com_x = 6, /* panel0.com.x [m] */
    p_panel0_inertia_xx = 7, /* panel0.inertia.xx [kg m^2] */
    p_panel0_inertia_yy = 8, /* panel0.inertia.yy [kg m^2] */
    p_panel0_inertia_zz = 9, /* panel0.inertia.zz [kg m^2] */
    p_hinge1_position_x = 10, /* hinge1.position.x [m] */
    p_panel1_mass = 11, /* panel1.mass [kg] */
    p_panel1_com_x = 12, /* panel1.com.x [m] */
    p_panel1_inertia_xx = 13, /* panel1.inertia.xx [kg m^2] */
    p_panel1_inertia_yy = 14, /* panel1.inertia.yy [kg m^2] */
    p_panel1_inertia_zz = 15, /* panel1.inertia.zz [kg m^2] */
    p_hinge2_position_x = 16, /* hinge2.position.x [m] */
    p_panel2_mass = 17, /* panel2.mass [kg] */
    p_panel2_com_x = 18, /* panel2.com.x [m] */
    p_panel2_inertia_xx = 19, /* panel2.inertia.xx [kg m^2] */
    p_panel2_inertia_yy = 20, /* panel2.inertia.yy [kg m^2] */
    p_panel2_inertia_zz = 21, /* panel2.inertia.zz [kg m^2] */
    p_hinge3_position_x = 22, /* hinge3.position.x [m] */
    p_panel3_mass = 23, /* panel3.mass [kg] */
    p_panel3_com_x = 24, /* panel3.com.x [m] */
    p_panel3_inertia_xx = 25, /* panel3.inertia.xx [kg m^2] */
    p_panel3_inertia_yy = 26, /* panel3.inertia.yy [kg m^2] */
    p_panel3_inertia_zz = 27, /* panel3.inertia.zz [kg m^2] */
    p_spring_stiffness = 28, /* spring.stiffness [N*m/rad] */
    p_spring_damping = 29 /* spring.damping [N*m*s/rad] */
};

#endif
