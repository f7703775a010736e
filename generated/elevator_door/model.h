/*
 * model.h: places of the entries of model 'elevator_door'.
 *
 * Such as q[q_<coordinate>] or p[p_<parameter>]; units behind the names.
 */
#ifndef CARDAN_MODEL_H
#define CARDAN_MODEL_H

#include "cardan.h"

/* sizes */
enum {
    cardan_nq = 1,
    cardan_nu = 1,
    cardan_nr = 1,
    cardan_np = 6,
    cardan_nz = 0,
    cardan_ns = 2,
    cardan_nbodies = 1,
    cardan_nparts = 1
};

/* generalized coordinates */
enum {
    q_rail = 0 /* rail [m] */
};

/* generalized speeds */
enum {
    u_rail_u = 0 /* rail.u [m/s] */
};

/* inputs */
enum {
    r_goal = 0 /* goal [m] */
};

/* parameters */
enum {
    p_gravity_z = 0, /* gravity.z [m/s^2] */
    p_door_mass = 1, /* door.mass [kg] */
    p_friction_damping = 2, /* friction.damping [N*s/m] */
    p_ends_upper = 3, /* ends.upper [m] */
    p_ends_restitution = 4, /* ends.restitution */
    p_ends_settle = 5 /* ends.settle [m/s] */
};

#endif
