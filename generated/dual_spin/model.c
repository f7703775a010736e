/*
 * model.c: values of model 'dual_spin' to start from.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    1.0, /* attitude.w */
    0.0, /* attitude.x */
    0.0, /* attitude.y */
    0.0, /* attitude.z */
    0.0, /* tube [m] */
};

/* inputs */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* nothing */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    0.0, /* hs [N m s] */
    20.0, /* bus.mass [kg] */
    4.0, /* bus.inertia.xx [kg m^2] */
    4.1000000000000005, /* bus.inertia.yy [kg m^2] */
    3.5, /* bus.inertia.zz [kg m^2] */
    0.5, /* tube.position.x [m] */
    0.4, /* ball.mass [kg] */
    0.1, /* oil.stiffness [N/m] */
    0.1, /* oil.damping [N*s/m] */
};
