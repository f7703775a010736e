/*
 * model.c: values of model 'bucket' to start from.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.0, /* hang.angle1 [rad] */
    0.0, /* hang.angle2 [rad] */
};

/* inputs */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* nothing */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    40.0, /* load [kg] */
    1.5, /* rope [m] */
    0.3, /* size [m] */
    -9.81, /* gravity.z [m/s^2] */
};
