/*
 * model.c: values of model 'trolley' to start from.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.0, /* track [m] */
    0.0, /* left.hang.angle1 [rad] */
    0.0, /* left.hang.angle2 [rad] */
    0.0, /* right.hang.angle1 [rad] */
    0.0, /* right.hang.angle2 [rad] */
};

/* inputs */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* push [N] */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    1.2, /* span [m] */
    5.0, /* wheel [kg] */
    0.1, /* radius [m] */
    40.0, /* left.load [kg] */
    1.5, /* left.rope [m] */
    0.3, /* left.size [m] */
    60.0, /* right.load [kg] */
    1.5, /* right.rope [m] */
    0.3, /* right.size [m] */
    -9.81, /* gravity.z [m/s^2] */
    80.0, /* trolley.mass [kg] */
    150.0, /* buffer.stiffness [N/m] */
    0.5, /* buffer.rest [m] */
};
