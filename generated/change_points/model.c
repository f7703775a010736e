/*
 * model.c: values of model 'change_points' to start from; the model as one
 * constant.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.0, /* A0 [rad] */
    0.0, /* A1 [rad] */
    0.0, /* A2 [rad] */
    0.0, /* B0 [rad] */
    0.0, /* B1 [rad] */
};

/* generalized speeds */
const double cardan_default_u[cardan_nu + (cardan_nu == 0)] = {
    0.0, /* A0.u [rad/s] */
    0.0, /* A1.u [rad/s] */
    0.0, /* A2.u [rad/s] */
    0.0, /* B0.u [rad/s] */
    0.0, /* B1.u [rad/s] */
};

/* inputs of the model */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* nothing */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    1.0, /* crank0.mass [kg] */
    0.3, /* crank0.com.x [m] */
    0.03, /* crank0.inertia.yy [kg m^2] */
    0.03, /* crank0.inertia.zz [kg m^2] */
    1.1, /* A1.position.x [m] */
    1.0, /* crank1.mass [kg] */
    0.3, /* crank1.com.x [m] */
    0.03, /* crank1.inertia.yy [kg m^2] */
    0.03, /* crank1.inertia.zz [kg m^2] */
    2.2, /* A2.position.x [m] */
    1.0, /* crank2.mass [kg] */
    0.3, /* crank2.com.x [m] */
    0.03, /* crank2.inertia.yy [kg m^2] */
    0.03, /* crank2.inertia.zz [kg m^2] */
    0.6, /* B0.position.x [m] */
    1.0, /* coupler0.mass [kg] */
    0.55, /* coupler0.com.x [m] */
    0.10083333333333334, /* coupler0.inertia.yy [kg m^2] */
    0.10083333333333334, /* coupler0.inertia.zz [kg m^2] */
    0.6, /* B1.position.x [m] */
    1.0, /* coupler1.mass [kg] */
    0.55, /* coupler1.com.x [m] */
    0.10083333333333334, /* coupler1.inertia.yy [kg m^2] */
    0.10083333333333334, /* coupler1.inertia.zz [kg m^2] */
    1.1, /* C0.position.x [m] */
    0.6, /* C0.child.position.x [m] */
    1.1, /* C1.position.x [m] */
    0.6, /* C1.child.position.x [m] */
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
    .name = "change_points",
    .nq = 5,
    .nu = 5,
    .nr = 0,
    .nz = 0,
    .ns = 0,
    .zeros = 30,
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
    .positions = 4,
    .rates = 4,
    .size = 1.0,
    .columns = NULL,
    .cost = NULL,
};
