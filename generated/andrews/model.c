/*
 * model.c: values of model 'andrews' to start from; the model as one
 * constant.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    -0.009611805847, /* beta [rad] */
    -0.038938484512, /* theta [rad] */
    0.455047362334, /* gamma [rad] */
    0.487417513796, /* delta [rad] */
    0.222198997752, /* phi [rad] */
    1.230369973954, /* epsilon [rad] */
    -0.222198997752, /* omega [rad] */
};

/* generalized speeds */
const double cardan_default_u[cardan_nu + (cardan_nu == 0)] = {
    0.0, /* beta.u [rad/s] */
    0.0, /* theta.u [rad/s] */
    0.0, /* gamma.u [rad/s] */
    0.0, /* delta.u [rad/s] */
    0.0, /* phi.u [rad/s] */
    0.0, /* epsilon.u [rad/s] */
    0.0, /* omega.u [rad/s] */
};

/* inputs of the model */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* nothing */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    0.04325, /* K1.mass [kg] */
    0.00092, /* K1.com.x [m] */
    1.097e-06, /* K1.inertia.xx [kg m^2] */
    1.097e-06, /* K1.inertia.yy [kg m^2] */
    2.194e-06, /* K1.inertia.zz [kg m^2] */
    0.007, /* theta.position.x [m] */
    0.00365, /* K2.mass [kg] */
    -0.0115, /* K2.com.x [m] */
    2.205e-07, /* K2.inertia.xx [kg m^2] */
    2.205e-07, /* K2.inertia.yy [kg m^2] */
    4.41e-07, /* K2.inertia.zz [kg m^2] */
    -0.03635, /* gamma.position.x [m] */
    0.03273, /* gamma.position.y [m] */
    0.02373, /* K3.mass [kg] */
    0.01043, /* K3.com.x [m] */
    -0.01874, /* K3.com.y [m] */
    2.6275e-06, /* K3.inertia.xx [kg m^2] */
    2.6275e-06, /* K3.inertia.yy [kg m^2] */
    5.255e-06, /* K3.inertia.zz [kg m^2] */
    -0.06934, /* delta.position.x [m] */
    -0.00227, /* delta.position.y [m] */
    0.0705, /* K5.mass [kg] */
    0.02308, /* K5.com.x [m] */
    0.00916, /* K5.com.y [m] */
    5.845e-06, /* K5.inertia.xx [kg m^2] */
    5.845e-06, /* K5.inertia.yy [kg m^2] */
    1.169e-05, /* K5.inertia.zz [kg m^2] */
    0.04, /* phi.position.x [m] */
    0.00706, /* K4.mass [kg] */
    -0.00579, /* K4.com.y [m] */
    2.8335e-07, /* K4.inertia.xx [kg m^2] */
    2.8335e-07, /* K4.inertia.yy [kg m^2] */
    5.667e-07, /* K4.inertia.zz [kg m^2] */
    -0.06934, /* epsilon.position.x [m] */
    -0.00227, /* epsilon.position.y [m] */
    0.05498, /* K7.mass [kg] */
    -0.00449, /* K7.com.x [m] */
    -0.01228, /* K7.com.y [m] */
    9.56e-06, /* K7.inertia.xx [kg m^2] */
    9.56e-06, /* K7.inertia.yy [kg m^2] */
    1.912e-05, /* K7.inertia.zz [kg m^2] */
    -0.04, /* omega.position.y [m] */
    0.00706, /* K6.mass [kg] */
    0.00579, /* K6.com.x [m] */
    2.8335e-07, /* K6.inertia.xx [kg m^2] */
    2.8335e-07, /* K6.inertia.yy [kg m^2] */
    5.667e-07, /* K6.inertia.zz [kg m^2] */
    -0.028, /* E3.position.x [m] */
    -0.035, /* E3.child.position.y [m] */
    -0.02, /* E4.child.position.y [m] */
    0.02, /* E6.child.position.x [m] */
    4530.0, /* spring.stiffness [N/m] */
    0.07785, /* spring.rest_length [m] */
    0.014, /* spring.a.position.x [m] */
    0.072, /* spring.a.position.y [m] */
    0.02, /* spring.b.position.x [m] */
    -0.018, /* spring.b.position.y [m] */
    0.033, /* drive.force */
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
    .name = "andrews",
    .nq = 7,
    .nu = 7,
    .nr = 0,
    .nz = 0,
    .ns = 0,
    .zeros = 42,
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
    .positions = 6,
    .rates = 6,
    .size = 1.0,
    .columns = NULL,
    .cost = NULL,
};
