/*
 * model.h: places of the entries of model 'sliding_block'.
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
    cardan_nr = 0,
    cardan_np = 9,
    cardan_nz = 0,
    cardan_ns = 2,
    cardan_nbodies = 1,
    cardan_nparts = 1
};

/* generalized coordinates */
enum {
    q_slide = 0 /* slide [m] */
};

/* generalized speeds */
enum {
    u_slide_u = 0 /* slide.u [m/s] */
};

/* parameters */
enum {
    p_mu = 0, /* mu */
    p_e = 1, /* e */
    p_gravity_z = 2, /* gravity.z [m/s^2] */
    p_block_mass = 3, /* block.mass [kg] */
    p_block_inertia_xx = 4, /* block.inertia.xx [kg m^2] */
    p_block_inertia_yy = 5, /* block.inertia.yy [kg m^2] */
    p_block_inertia_zz = 6, /* block.inertia.zz [kg m^2] */
    p_wall_upper = 7, /* wall.upper [m] */
    p_wall_settle = 8 /* wall.settle [m/s] */
};

#endif
