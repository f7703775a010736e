/*
 * model.c: values of model 'arm' to start from; the model as one
 * constant.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.0, /* waist [rad] */
    0.0, /* shoulder [rad] */
    0.0, /* elbow [rad] */
};

/* generalized speeds */
const double cardan_default_u[cardan_nu + (cardan_nu == 0)] = {
    0.0, /* waist.u [rad/s] */
    0.0, /* shoulder.u [rad/s] */
    0.0, /* elbow.u [rad/s] */
};

/* inputs of the model */
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

/* internal continuous states */
const double cardan_default_z[cardan_nz + (cardan_nz == 0)] = {
    0.0, /* nothing */
};

/* discrete states */
const double cardan_default_s[cardan_ns + (cardan_ns == 0)] = {
    0.0, /* nothing */
};

/* all that a run must know of the model */
static const cardan_exported_function scene_functions[] = {
    {.name = "forward_dynamics", .function = forward_dynamics, .out = forward_dynamics_out_size, .work = forward_dynamics_work_size, .w = forward_dynamics_w_size, .prepare = prepare_forward_dynamics},
    {.name = "inverse_dynamics", .function = inverse_dynamics, .out = inverse_dynamics_out_size, .work = inverse_dynamics_work_size, .w = inverse_dynamics_w_size, .prepare = prepare_inverse_dynamics},
    {.name = "mass_matrix", .function = mass_matrix, .out = mass_matrix_out_size, .work = mass_matrix_work_size, .w = mass_matrix_w_size, .prepare = prepare_mass_matrix},
};
const cardan_export cardan_scene = {
    .name = "arm",
    .nq = 3,
    .nu = 3,
    .nr = 0,
    .nz = 0,
    .ns = 0,
    .zeros = 24,
    .q = cardan_default_q,
    .u = cardan_default_u,
    .r = cardan_default_r,
    .p = cardan_default_p,
    .z = cardan_default_z,
    .s = cardan_default_s,
    .functions = scene_functions,
    .function_count = 3,
    .methods = NULL,
    .method_count = 0,
    .quaternions = NULL,
    .quaternion_count = 0,
    .positions = 0,
    .rates = 0,
    .size = 1.0,
    .columns = NULL,
    .cost = NULL,
};
