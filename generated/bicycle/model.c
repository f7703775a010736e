/*
 * model.c: values of model 'bicycle' to start from.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.0, /* rear_contact.x [m] */
    0.0, /* rear_contact.y [m] */
    0.0, /* rear_contact.yaw [rad] */
    0.0, /* rear_contact.lean [rad] */
    0.0, /* rear_contact.spin [rad] */
    0.0, /* rear_hub [rad] */
    0.0, /* steer [rad] */
    0.0, /* front_hub [rad] */
};

/* inputs */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* nothing */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    1.02, /* wheelbase [m] */
    0.08, /* trail [m] */
    0.3141592653589793, /* tilt [rad] */
    0.3, /* rear_radius [m] */
    0.35, /* front_radius [m] */
    -9.81, /* gravity.z [m/s^2] */
    2.0, /* rear_wheel.mass [kg] */
    0.0603, /* rear_wheel.inertia.xx [kg m^2] */
    0.12, /* rear_wheel.inertia.yy [kg m^2] */
    0.0603, /* rear_wheel.inertia.zz [kg m^2] */
    85.0, /* frame.mass [kg] */
    0.3, /* frame.com.x [m] */
    9.2, /* frame.inertia.xx [kg m^2] */
    -2.4, /* frame.inertia.xz [kg m^2] */
    11.0, /* frame.inertia.yy [kg m^2] */
    2.8, /* frame.inertia.zz [kg m^2] */
    4.0, /* fork.mass [kg] */
    0.7, /* fork.com.z [m] */
    0.05892, /* fork.inertia.xx [kg m^2] */
    0.00756, /* fork.inertia.xz [kg m^2] */
    0.06, /* fork.inertia.yy [kg m^2] */
    0.00708, /* fork.inertia.zz [kg m^2] */
    3.0, /* front_wheel.mass [kg] */
    0.1405, /* front_wheel.inertia.xx [kg m^2] */
    0.28, /* front_wheel.inertia.yy [kg m^2] */
    0.1405, /* front_wheel.inertia.zz [kg m^2] */
};
