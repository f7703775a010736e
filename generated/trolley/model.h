/*
 * model.h: places of the entries of model 'trolley'.
 *
 * Such as q[q_<coordinate>] or p[p_<parameter>]; units behind the names.
 */
#ifndef CARDAN_MODEL_H
#define CARDAN_MODEL_H

#include "cardan.h"

/* sizes */
enum {
    cardan_nq = 5,
    cardan_nu = 5,
    cardan_nr = 1,
    cardan_np = 13,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 4,
    cardan_nparts = 6
};

/* generalized coordinates */
enum {
    q_track = 0, /* track [m] */
    q_left_hang_angle1 = 1, /* left.hang.angle1 [rad] */
    q_left_hang_angle2 = 2, /* left.hang.angle2 [rad] */
    q_right_hang_angle1 = 3, /* right.hang.angle1 [rad] */
    q_right_hang_angle2 = 4 /* right.hang.angle2 [rad] */
};

/* generalized speeds */
enum {
    u_track_u = 0, /* track.u [m/s] */
    u_left_hang_u_angle1 = 1, /* left.hang.u.angle1 [rad/s] */
    u_left_hang_u_angle2 = 2, /* left.hang.u.angle2 [rad/s] */
    u_right_hang_u_angle1 = 3, /* right.hang.u.angle1 [rad/s] */
    u_right_hang_u_angle2 = 4 /* right.hang.u.angle2 [rad/s] */
};

/* inputs */
enum {
    r_push = 0 /* push [N] */
};

/* parameters */
enum {
    p_span = 0, /* span [m] */
    p_wheel = 1, /* wheel [kg] */
    p_radius = 2, /* radius [m] */
    p_left_load = 3, /* left.load [kg] */
    p_left_rope = 4, /* left.rope [m] */
    p_left_size = 5, /* left.size [m] */
    p_right_load = 6, /* right.load [kg] */
    p_right_rope = 7, /* right.rope [m] */
    p_right_size = 8, /* right.size [m] */
    p_gravity_z = 9, /* gravity.z [m/s^2] */
    p_trolley_mass = 10, /* trolley.mass [kg] */
    p_buffer_stiffness = 11, /* buffer.stiffness [N/m] */
    p_buffer_rest = 12 /* buffer.rest [m] */
};

#endif
