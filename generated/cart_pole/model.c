/*
 * model.c: values of model 'cart_pole' to start from.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.0, /* track [m] */
    0.0, /* hinge [rad] */
};

/* inputs */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* push */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    -9.81, /* gravity.z [m/s^2] */
    2.0, /* cart.mass [kg] */
    0.5, /* pole.mass [kg] */
    0.4, /* pole.com.z [m] */
    0.026666666666666672, /* pole.inertia.xx [kg m^2] */
    0.026666666666666672, /* pole.inertia.yy [kg m^2] */
};
