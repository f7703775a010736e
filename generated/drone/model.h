/*
 * model.h: places of the entries of model 'drone'.
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
    cardan_nr = 2,
    cardan_np = 7,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 1,
    cardan_nparts = 1
};

/* generalized coordinates */
enum {
    q_fly_x = 0, /* fly.x [m] */
    q_fly_y = 1, /* fly.y [m] */
    q_fly_angle = 2 /* fly.angle [rad] */
};

/* generalized speeds */
enum {
    u_fly_u_x = 0, /* fly.u.x [m/s] */
    u_fly_u_y = 1, /* fly.u.y [m/s] */
    u_fly_u_angle = 2 /* fly.u.angle [rad/s] */
};

/* inputs */
enum {
    r_left = 0, /* left */
    r_right = 1 /* right */
};

/* parameters */
enum {
    p_gravity_z = 0, /* gravity.z [m/s^2] */
    p_drone_mass = 1, /* drone.mass [kg] */
    p_drone_inertia_xx = 2, /* drone.inertia.xx [kg m^2] */
    p_drone_inertia_yy = 3, /* drone.inertia.yy [kg m^2] */
    p_drone_inertia_zz = 4, /* drone.inertia.zz [kg m^2] */
    p_left_frame_position_x = 5, /* left.frame.position.x [m] */
    p_right_frame_position_x = 6 /* right.frame.position.x [m] */
};

#endif
