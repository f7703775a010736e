/*
 * model.h: places of the entries of model 'whirling_rotor'.
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
    cardan_nr = 0,
    cardan_np = 9,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 2,
    cardan_nparts = 2
};

/* generalized coordinates */
enum {
    q_x = 0, /* x [m] */
    q_y = 1 /* y [m] */
};

/* generalized speeds */
enum {
    u_x_u = 0, /* x.u [m/s] */
    u_y_u = 1 /* y.u [m/s] */
};

/* parameters */
enum {
    p_speed = 0, /* speed [rad/s] */
    p_inner = 1, /* inner [N s/m] */
    p_outer = 2, /* outer [N s/m] */
    p_cubic = 3, /* cubic [N s/m^3] */
    p_uneven = 4, /* uneven */
    p_disk_mass = 5, /* disk.mass [kg] */
    p_disk_inertia_xx = 6, /* disk.inertia.xx [kg m^2] */
    p_disk_inertia_yy = 7, /* disk.inertia.yy [kg m^2] */
    p_disk_inertia_zz = 8 /* disk.inertia.zz [kg m^2] */
};

#endif
