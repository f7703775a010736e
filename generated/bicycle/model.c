/*
 * model.c: values of model 'bicycle' to start from; the model as one
 * constant.
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

/* generalized speeds */
const double cardan_default_u[cardan_nu + (cardan_nu == 0)] = {
    0.0, /* rear_contact.u.x [m/s] */
    0.0, /* rear_contact.u.y [m/s] */
    0.0, /* rear_contact.u.yaw [rad/s] */
    0.0, /* rear_contact.u.lean [rad/s] */
    0.0, /* rear_contact.u.spin [rad/s] */
    0.0, /* rear_hub.u [rad/s] */
    0.0, /* steer.u [rad/s] */
    0.0, /* front_hub.u [rad/s] */
};

/* inputs of the model */
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
    .name = "bicycle",
    .nq = 8,
    .nu = 8,
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
    .positions = 1,
    .rates = 5,
    .size = 1.0,
    .columns = NULL,
    .cost = NULL,
};
