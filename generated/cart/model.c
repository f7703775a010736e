/*
 * model.c: values of model 'cart' to start from.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.0, /* slide [m] */
    0.0, /* swing [rad] */
};

/* inputs */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* push */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    1.0, /* m [kg] */
    0.5, /* l [m] */
    -9.81, /* gravity.z [m/s^2] */
    2.0, /* cart.mass [kg] */
    0.1, /* cart.inertia.xx [kg m^2] */
    0.1, /* cart.inertia.yy [kg m^2] */
    0.1, /* cart.inertia.zz [kg m^2] */
};
