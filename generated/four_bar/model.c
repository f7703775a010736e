/*
 * model.c: values of model 'four_bar' to start from; the model as one
 * constant.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.470659074167, /* A [rad] */
    0.19379722886, /* B [rad] */
    1.64115435381, /* D [rad] */
};

/* generalized speeds */
const double cardan_default_u[cardan_nu + (cardan_nu == 0)] = {
    0.0, /* A.u [rad/s] */
    0.0, /* B.u [rad/s] */
    0.0, /* D.u [rad/s] */
};

/* inputs of the model */
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
    .name = "four_bar",
    .nq = 3,
    .nu = 3,
    .nr = 0,
    .nz = 0,
    .ns = 0,
    .zeros = 18,
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
    .positions = 2,
    .rates = 2,
    .size = 1.0,
    .columns = NULL,
    .cost = NULL,
};
