/*
 * model.c: values of model 'elevator_door' to start from; the model as one
 * constant.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.0, /* rail [m] */
};

/* generalized speeds */
const double cardan_default_u[cardan_nu + (cardan_nu == 0)] = {
    0.0, /* rail.u [m/s] */
};

/* inputs of the model */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.9, /* goal [m] */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    -9.81, /* gravity.z [m/s^2] */
    20.0, /* door.mass [kg] */
    12.0, /* friction.damping [N*s/m] */
    0.9, /* ends.upper [m] */
    0.4, /* ends.restitution */
    0.02, /* ends.settle [m/s] */
};

/* internal continuous states */
const double cardan_default_z[cardan_nz + (cardan_nz == 0)] = {
    0.0, /* nothing */
};

/* discrete states */
const double cardan_default_s[cardan_ns + (cardan_ns == 0)] = {
    0.0, /* ends */
    0.0, /* motor.force */
};

/* all that a run must know of the model */
static const cardan_exported_function scene_functions[] = {
    {.name = "forward_dynamics", .function = forward_dynamics, .out = forward_dynamics_out_size, .work = forward_dynamics_work_size, .w = forward_dynamics_w_size, .prepare = prepare_forward_dynamics},
    {.name = "inverse_dynamics", .function = inverse_dynamics, .out = inverse_dynamics_out_size, .work = inverse_dynamics_work_size, .w = inverse_dynamics_w_size, .prepare = prepare_inverse_dynamics},
    {.name = "mass_matrix", .function = mass_matrix, .out = mass_matrix_out_size, .work = mass_matrix_work_size, .w = mass_matrix_w_size, .prepare = prepare_mass_matrix},
    {.name = "events", .function = events, .out = events_out_size, .work = events_work_size, .w = events_w_size, .prepare = prepare_events},
    {.name = "transition", .function = transition, .out = transition_out_size, .work = transition_work_size, .w = transition_w_size, .prepare = prepare_transition},
};
const cardan_export cardan_scene = {
    .name = "elevator_door",
    .nq = 1,
    .nu = 1,
    .nr = 1,
    .nz = 0,
    .ns = 2,
    .zeros = 6,
    .q = cardan_default_q,
    .u = cardan_default_u,
    .r = cardan_default_r,
    .p = cardan_default_p,
    .z = cardan_default_z,
    .s = cardan_default_s,
    .functions = scene_functions,
    .function_count = 5,
    .methods = NULL,
    .method_count = 0,
    .quaternions = NULL,
    .quaternion_count = 0,
    .positions = 0,
    .rates = 1,
    .size = 1.0,
    .columns = NULL,
    .cost = NULL,
};
