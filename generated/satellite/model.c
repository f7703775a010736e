/*
 * model.c: values of model 'satellite' to start from.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.0, /* attitude.angle1 [rad] */
    0.0, /* attitude.angle2 [rad] */
    0.0, /* attitude.angle3 [rad] */
};

/* inputs */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* nothing */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    398600441800000.0, /* mu [m^3/s^2] */
    -1.2, /* orbit.plane.child.rotation.angle2 [rad] */
    7178137.0, /* orbit.position.x [m] */
    50.0, /* sat.mass [kg] */
    10.0, /* sat.inertia.xx [kg m^2] */
    12.0, /* sat.inertia.yy [kg m^2] */
    5.0, /* sat.inertia.zz [kg m^2] */
};
