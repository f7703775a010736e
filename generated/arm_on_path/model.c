/*
 * model.c: values of model 'arm_on_path' to start from.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.0, /* shoulder [rad] */
    0.0, /* elbow [rad] */
};

/* inputs */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* nothing */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    -9.81, /* gravity.z [m/s^2] */
    3.0, /* upper.mass [kg] */
    0.25, /* upper.com.x [m] */
    0.01, /* upper.inertia.xx [kg m^2] */
    0.07, /* upper.inertia.yy [kg m^2] */
    0.07, /* upper.inertia.zz [kg m^2] */
    0.5, /* elbow.position.x [m] */
    1.5, /* lower.mass [kg] */
    0.2, /* lower.com.x [m] */
    0.005, /* lower.inertia.xx [kg m^2] */
    0.03, /* lower.inertia.yy [kg m^2] */
    0.03, /* lower.inertia.zz [kg m^2] */
};
