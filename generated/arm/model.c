/*
 * model.c: values of model 'arm' to start from.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.0, /* waist [rad] */
    0.0, /* shoulder [rad] */
    0.0, /* elbow [rad] */
};

/* inputs */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* nothing */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    -9.81, /* gravity.z [m/s^2] */
    2.0, /* column.mass [kg] */
    0.1, /* column.com.z [m] */
    0.01, /* column.inertia.xx [kg m^2] */
    0.01, /* column.inertia.yy [kg m^2] */
    0.006, /* column.inertia.zz [kg m^2] */
    0.2, /* shoulder.position.z [m] */
    1.5, /* upper_arm.mass [kg] */
    0.2, /* upper_arm.com.x [m] */
    0.002, /* upper_arm.inertia.xx [kg m^2] */
    0.02, /* upper_arm.inertia.yy [kg m^2] */
    0.02, /* upper_arm.inertia.zz [kg m^2] */
    0.4, /* elbow.position.x [m] */
    0.8, /* forearm.mass [kg] */
    0.15, /* forearm.com.x [m] */
    0.01, /* forearm.com.y [m] */
    0.001, /* forearm.inertia.xx [kg m^2] */
    0.0002, /* forearm.inertia.xz [kg m^2] */
    0.006, /* forearm.inertia.yy [kg m^2] */
    0.006, /* forearm.inertia.zz [kg m^2] */
    0.3, /* wrist.position.x [m] */
    0.5, /* wrist.rotation.yaw [rad] */
    0.3, /* hand.mass [kg] */
    0.0003, /* hand.inertia.xx [kg m^2] */
    0.0003, /* hand.inertia.yy [kg m^2] */
    0.0003, /* hand.inertia.zz [kg m^2] */
    0.3, /* waist.damping [N*m*s/rad] */
    0.2, /* shoulder.damping [N*m*s/rad] */
    0.1, /* elbow.damping [N*m*s/rad] */
};
