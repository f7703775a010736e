/*
 * model.c: values of model 'satellite' to start from; the model as one
 * constant.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.0, /* attitude.angle1 [rad] */
    0.0, /* attitude.angle2 [rad] */
    0.0, /* attitude.angle3 [rad] */
};

/* generalized speeds */
const double cardan_default_u[cardan_nu + (cardan_nu == 0)] = {
    0.0, /* attitude.u.x [rad/s] */
    0.0, /* attitude.u.y [rad/s] */
    0.0, /* attitude.u.z [rad/s] */
};

/* inputs of the model */
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
    .name = "satellite",
    .nq = 3,
    .nu = 3,
    .nr = 0,
    .nz = 0,
    .ns = 0,
    .zeros = 12,
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
