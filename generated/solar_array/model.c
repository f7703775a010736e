/*
 * model.c: values of model 'solar_array' to start from.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    1.0, /* drift.w */
    0.0, /* drift.x */
    0.0, /* drift.y */
    0.0, /* drift.z */
    0.0, /* drift.px [m] */
    0.0, /* drift.py [m] */
    0.0, /* drift.pz [m] */
    0.0, /* hinge0 [rad] */
    0.0, /* hinge1 [rad] */
    0.0, /* hinge2 [rad] */
    0.0, /* hinge3 [rad] */
};

/* inputs */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* nothing */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    400.0, /* hub.mass [kg] */
    120.0, /* hub.inertia.xx [kg m^2] */
    150.0, /* hub.inertia.yy [kg m^2] */
    120.0, /* hub.inertia.zz [kg m^2] */
    0.8, /* hinge0.position.x [m] */
    9.0, /* panel0.mass [kg] */
    0.8, /* panel0.com.x [m] */
    3.630675, /* panel0.inertia.xx [kg m^2] */
    1.9206750000000004, /* panel0.inertia.yy [kg m^2] */
    5.550000000000001, /* panel0.inertia.zz [kg m^2] */
    1.6, /* hinge1.position.x [m] */
    9.0, /* panel1.mass [kg] */
    0.8, /* panel1.com.x [m] */
    3.630675, /* panel1.inertia.xx [kg m^2] */
    1.9206750000000004, /* panel1.inertia.yy [kg m^2] */
    5.550000000000001, /* panel1.inertia.zz [kg m^2] */
    1.6, /* hinge2.position.x [m] */
    9.0, /* panel2.mass [kg] */
    0.8, /* panel2.com.x [m] */
    3.630675, /* panel2.inertia.xx [kg m^2] */
    1.9206750000000004, /* panel2.inertia.yy [kg m^2] */
    5.550000000000001, /* panel2.inertia.zz [kg m^2] */
    1.6, /* hinge3.position.x [m] */
    9.0, /* panel3.mass [kg] */
    0.8, /* panel3.com.x [m] */
    3.630675, /* panel3.inertia.xx [kg m^2] */
    1.9206750000000004, /* panel3.inertia.yy [kg m^2] */
    5.550000000000001, /* panel3.inertia.zz [kg m^2] */
    6.0, /* spring.stiffness [N*m/rad] */
    25.0, /* spring.damping [N*m*s/rad] */
};
