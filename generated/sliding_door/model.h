/*
 * model.h: places of the entries of model 'sliding_door'.
 *
 * Such as q[q_<coordinate>] or p[p_<parameter>]; units behind the names.
 */
#ifndef CARDAN_MODEL_H
#define CARDAN_MODEL_H

#include "cardan.h"

/* sizes */
enum {
    cardan_nq = 2,
    cardan_nu = 2,
    cardan_nr = 1,
    cardan_np = 19,
    cardan_nz = 0,
    cardan_ns = 4,
    cardan_nbodies = 2,
    cardan_nparts = 2
};

/* generalized coordinates */
enum {
    q_rail = 0, /* rail [m] */
    q_hook = 1 /* hook [rad] */
};

/* generalized speeds */
enum {
    u_rail_u = 0, /* rail.u [m/s] */
    u_hook_u = 1 /* hook.u [rad/s] */
};

/* inputs */
enum {
    r_goal = 0 /* goal [m] */
};

/* parameters */
enum {
    p_gravity_z = 0, /* gravity.z [m/s^2] */
    p_door_mass = 1, /* door.mass [kg] */
    p_door_com_z = 2, /* door.com.z [m] */
    p_door_inertia_xx = 3, /* door.inertia.xx [kg m^2] */
    p_door_inertia_yy = 4, /* door.inertia.yy [kg m^2] */
    p_door_inertia_zz = 5, /* door.inertia.zz [kg m^2] */
    p_hook_position_x = 6, /* hook.position.x [m] */
    p_hook_position_z = 7, /* hook.position.z [m] */
    p_lamp_mass = 8, /* lamp.mass [kg] */
    p_lamp_com_z = 9, /* lamp.com.z [m] */
    p_lamp_inertia_xx = 10, /* lamp.inertia.xx [kg m^2] */
    p_lamp_inertia_yy = 11, /* lamp.inertia.yy [kg m^2] */
    p_lamp_inertia_zz = 12, /* lamp.inertia.zz [kg m^2] */
    p_friction_coulomb = 13, /* friction.coulomb [N] */
    p_friction_static = 14, /* friction.static [N] */
    p_friction_viscous = 15, /* friction.viscous [N*s/m] */
    p_ends_upper = 16, /* ends.upper [m] */
    p_ends_restitution = 17, /* ends.restitution */
    p_ends_settle = 18 /* ends.settle [m/s] */
};

#endif
