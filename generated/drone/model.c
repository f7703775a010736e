/*
 * model.c: values of model 'drone' to start from.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.0, /* fly.x [m] */
    0.0, /* fly.y [m] */
    0.0, /* fly.angle [rad] */
};

/* inputs */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* left */
    0.0, /* right */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    -9.81, /* gravity.z [m/s^2] */
    1.2, /* drone.mass [kg] */
    0.01, /* drone.inertia.xx [kg m^2] */
    0.02, /* drone.inertia.yy [kg m^2] */
    0.02, /* drone.inertia.zz [kg m^2] */
    -0.2, /* left.frame.position.x [m] */
    0.2, /* right.frame.position.x [m] */
};
