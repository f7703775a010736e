/*
 * model.c: values of model 'four_bar' to start from.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.025652444747, /* A [rad] */
    0.857135016274, /* B [rad] */
    1.778705108217, /* D [rad] */
};

/* inputs */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* nothing */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    -9.81, /* gravity.y [m/s^2] */
    0.1, /* crank.mass [kg] */
    0.05, /* crank.com.x [m] */
    4.166666666666667e-06, /* crank.inertia.xx [kg m^2] */
    8.416666666666669e-05, /* crank.inertia.yy [kg m^2] */
    8.666666666666668e-05, /* crank.inertia.zz [kg m^2] */
    0.1, /* B.position.x [m] */
    0.25, /* coupler.mass [kg] */
    0.125, /* coupler.com.x [m] */
    1.0416666666666666e-05, /* coupler.inertia.xx [kg m^2] */
    0.0013041666666666668, /* coupler.inertia.yy [kg m^2] */
    0.0013104166666666665, /* coupler.inertia.zz [kg m^2] */
    0.3, /* D.position.x [m] */
    0.2, /* rocker.mass [kg] */
    0.1, /* rocker.com.x [m] */
    8.333333333333334e-06, /* rocker.inertia.xx [kg m^2] */
    0.0006683333333333336, /* rocker.inertia.yy [kg m^2] */
    0.0006733333333333335, /* rocker.inertia.zz [kg m^2] */
    0.25, /* C.position.x [m] */
    0.2, /* C.child.position.x [m] */
};
