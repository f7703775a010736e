/*
 * model.c: values of model 'rotor' to start from.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.0, /* x [m] */
    0.0, /* y [m] */
    0.0, /* tilt [rad] */
    0.0, /* lean [rad] */
    0.0, /* spin [rad] */
};

/* inputs */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* nothing */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    60.0, /* outer */
    20.0, /* inner */
    4.0, /* disk.mass [kg] */
    0.05, /* disk.inertia.xx [kg m^2] */
    0.05, /* disk.inertia.yy [kg m^2] */
    0.08, /* disk.inertia.zz [kg m^2] */
};
