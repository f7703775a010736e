/*
 * model.h: places of the entries of model 'elastic_pendulum'.
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
    cardan_np = 10,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 2,
    cardan_nparts = 2
};

/* generalized coordinates */
enum {
    q_pivot = 0, /* pivot [rad] */
    q_slide = 1 /* slide [m] */
};

/* generalized speeds */
enum {
    u_pivot_u = 0, /* pivot.u [rad/s] */
    u_slide_u = 1 /* slide.u [m/s] */
};

/* parameters */
enum {
    p_mass = 0, /* mass [kg] */
    p_stiffness = 1, /* stiffness [N/m] */
    p_gravity_z = 2, /* gravity.z [m/s^2] */
    p_arm_mass = 3, /* arm.mass [kg] */
    p_arm_com_z = 4, /* arm.com.z [m] */
    p_arm_inertia_xx = 5, /* arm.inertia.xx [kg m^2] */
    p_arm_inertia_yy = 6, /* arm.inertia.yy [kg m^2] */
    p_arm_inertia_zz = 7, /* arm.inertia.zz [kg m^2] */
    p_slide_position_z = 8, /* slide.position.z [m] */
    p_spring_damping = 9 /* spring.damping [N*s/m] */
};

#endif
