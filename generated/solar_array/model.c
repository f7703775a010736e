/*
 * model.c: values of model 'solar_array' to start from; the model as one
 * constant.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    1.0, /* drift.qw */
    0.0, /* drift.qx */
    0.0, /* drift.qy */
    0.0, /* drift.qz */
    0.0, /* drift.px [m] */
    0.0, /* drift.py [m] */
    0.0, /* drift.pz [m] */
    0.0, /* hinge0 [rad] */
    0.0, /* hinge1 [rad] */
    0.0, /* hinge2 [rad] */
    0.0, /* hinge3 [rad] */
};

/* generalized speeds */
const double cardan_default_u[cardan_nu + (cardan_nu == 0)] = {
    0.0, /* drift.u.x [rad/s] */
    0.0, /* drift.u.y [rad/s] */
    0.0, /* drift.u.z [rad/s] */
    0.0, /* drift.u.px [m/s] */
    0.0, /* drift.u.py [m/s] */
    0.0, /* drift.u.pz [m/s] */
    0.0, /* hinge0.u [rad/s] */
    0.0, /* hinge1.u [rad/s] */
    0.0, /* hinge2.u [rad/s] */
    0.0, /* hinge3.u [rad/s] */
};

/* inputs of the model */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* nothing */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    400.0, /* hub.mass [kg] */
    120.0, /* hub.inertia.xx [kg m^2] */
    150.0, /* hub.inertia.yy [kg m^2] */
    120.0, /* hub.inertia.zz [kg m^2] */
    0.8, /* hinge0.position.x [m] */
    9.0, /* panel0.mass [kg] */
    0.8, /* panel0.com.x [m] */
    3.630675, /* panel0.inertia.xx [kg m^2] */
    1.9206750000000004, /* panel0.inertia.yy [kg m^2] */
    5.550000000000001, /* panel0.inertia.zz [kg m^2] */
    1.6, /* hinge1.position.x [m] */
    9.0, /* panel1.mass [kg] */
    0.8, /* panel1.com.x [m] */
    3.630675, /* panel1.inertia.xx [kg m^2] */
    1.9206750000000004, /* panel1.inertia.yy [kg m^2] */
    5.550000000000001, /* panel1.inertia.zz [kg m^2] */
    1.6, /* hinge2.position.x [m] */
    9.0, /* panel2.mass [kg] */
    0.8, /* panel2.com.x [m] */
    3.630675, /* panel2.inertia.xx [kg m^2] */
    1.9206750000000004, /* panel2.inertia.yy [kg m^2] */
    5.550000000000001, /* panel2.inertia.zz [kg m^2] */
    1.6, /* hinge3.position.x [m] */
    9.0, /* panel3.mass [kg] */
    0.8, /* panel3.com.x [m] */
    3.630675, /* panel3.inertia.xx [kg m^2] */
    1.9206750000000004, /* panel3.inertia.yy [kg m^2] */
    5.550000000000001, /* panel3.inertia.zz [kg m^2] */
    6.0, /* spring.stiffness [N*m/rad] */
    25.0, /* spring.damping [N*m*s/rad] */
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
static const ptrdiff_t quaternions[] = {
    0,
};
const cardan_export cardan_scene = {
    .name = "solar_array",
    .nq = 11,
    .nu = 10,
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
    .quaternions = quaternions,
    .quaternion_count = 1,
    .positions = 3,
    .rates = 3,
    .size = 1.0,
    .columns = NULL,
    .cost = NULL,
};
