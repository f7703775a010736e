/*
 * model.h: places of the entries of model 'bicycle'.
 *
 * Such as q[q_<coordinate>] or p[p_<parameter>]; units behind the names.
 */
#ifndef CARDAN_MODEL_H
#define CARDAN_MODEL_H

#include "cardan.h"

/* sizes */
enum {
    cardan_nq = 8,
    cardan_nu = 8,
    cardan_nr = 0,
    cardan_np = 26,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 4,
    cardan_nparts = 4
};

/* generalized coordinates */
enum {
    q_rear_contact_x = 0, /* rear_contact.x [m] */
    q_rear_contact_y = 1, /* rear_contact.y [m] */
    q_rear_contact_yaw = 2, /* rear_contact.yaw [rad] */
    q_rear_contact_lean = 3, /* rear_contact.lean [rad] */
    q_rear_contact_spin = 4, /* rear_contact.spin [rad] */
    q_rear_hub = 5, /* rear_hub [rad] */
    q_steer = 6, /* steer [rad] */
    q_front_hub = 7 /* front_hub [rad] */
};

/* generalized speeds */
enum {
    u_rear_contact_u_x = 0, /* rear_contact.u.x [m/s] */
    u_rear_contact_u_y = 1, /* rear_contact.u.y [m/s] */
    u_rear_contact_u_yaw = 2, /* rear_contact.u.yaw [rad/s] */
    u_rear_contact_u_lean = 3, /* rear_contact.u.lean [rad/s] */
    u_rear_contact_u_spin = 4, /* rear_contact.u.spin [rad/s] */
    u_rear_hub_u = 5, /* rear_hub.u [rad/s] */
    u_steer_u = 6, /* steer.u [rad/s] */
    u_front_hub_u = 7 /* front_hub.u [rad/s] */
};

/* parameters */
enum {
    p_wheelbase = 0, /* wheelbase [m] */
    p_trail = 1, /* trail [m] */
    p_tilt = 2, /* tilt [rad] */
    p_rear_radius = 3, /* rear_radius [m] */
    p_front_radius = 4, /* front_radius [m] */
    p_gravity_z = 5, /* gravity.z [m/s^2] */
    p_rear_wheel_mass = 6, /* rear_wheel.mass [kg] */
    p_rear_wheel_inertia_xx = 7, /* rear_wheel.inertia.xx [kg m^2] */
    p_rear_wheel_inertia_yy = 8, /* rear_wheel.inertia.yy [kg m^2] */
    p_rear_wheel_inertia_zz = 9, /* rear_wheel.inertia.zz [kg m^2] */
    p_frame_mass = 10, /* frame.mass [kg] */
    p_frame_com_x = 11, /* frame.com.x [m] */
    p_frame_inertia_xx = 12, /* frame.inertia.xx [kg m^2] */
    p_frame_inertia_xz = 13, /* frame.inertia.xz [kg m^2] */
    p_frame_inertia_yy = 14, /* frame.inertia.yy [kg m^2] */
    p_frame_inertia_zz = 15, /* frame.inertia.zz [kg m^2] */
    p_fork_mass = 16, /* fork.mass [kg] */
    p_fork_com_z = 17, /* fork.com.z [m] */
    p_fork_inertia_xx = 18, /* fork.inertia.xx [kg m^2] */
    p_fork_inertia_xz = 19, /* fork.inertia.xz [kg m^2] */
    p_fork_inertia_yy = 20, /* fork.inertia.yy [kg m^2] */
    p_fork_inertia_zz = 21, /* fork.inertia.zz [kg m^2] */
    p_front_wheel_mass = 22, /* front_wheel.mass [kg] */
    p_front_wheel_inertia_xx = 23, /* front_wheel.inertia.xx [kg m^2] */
    p_front_wheel_inertia_yy = 24, /* front_wheel.inertia.yy [kg m^2] */
    p_front_wheel_inertia_zz = 25 /* front_wheel.inertia.zz [kg m^2] */
};

#endif
