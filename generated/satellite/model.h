/*
 * model.h: places of the entries of model 'satellite'.
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
    cardan_np = 7,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 2,
    cardan_nparts = 2
};

/* generalized coordinates */
enum {
    q_attitude_angle1 = 0, /* attitude.angle1 [rad] */
    q_attitude_angle2 = 1, /* attitude.angle2 [rad] */
    q_attitude_angle3 = 2 /* attitude.angle3 [rad] */
};

/* generalized speeds */
enum {
    u_attitude_u_x = 0, /* attitude.u.x [rad/s] */
    u_attitude_u_y = 1, /* attitude.u.y [rad/s] */
    u_attitude_u_z = 2 /* attitude.u.z [rad/s] */
};

/* parameters */
enum {
    p_mu = 0, /* mu [m^3/s^2] */
    p_orbit_plane_child_rotation_angle2 = 1, /* orbit.plane.child.rotation.angle2 [rad] */
    p_orbit_position_x = 2, /* orbit.position.x [m] */
    p_sat_mass = 3, /* sat.mass [kg] */
    p_sat_inertia_xx = 4, /* sat.inertia.xx [kg m^2] */
    p_sat_inertia_yy = 5, /* sat.inertia.yy [kg m^2] */
    p_sat_inertia_zz = 6 /* sat.inertia.zz [kg m^2] */
};

#endif
