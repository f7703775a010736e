/*
 * model.c: values of model 'rolling_disk' to start from.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.0, /* rolling.x [m] */
    0.0, /* rolling.y [m] */
    0.0, /* rolling.yaw [rad] */
    0.0, /* rolling.lean [rad] */
    0.0, /* rolling.spin [rad] */
};

/* inputs */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* nothing */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    1.0, /* m [kg] */
    0.1, /* r [m] */
    -9.81, /* gravity.z [m/s^2] */
};
