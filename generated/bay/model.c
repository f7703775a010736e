/*
 * model.c: values of model 'bay' to start from; the model as one
 * constant.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.8, /* height [m] */
    0.0, /* twist [rad] */
};

/* generalized speeds */
const double cardan_default_u[cardan_nu + (cardan_nu == 0)] = {
    0.0, /* height.u [m/s] */
    0.0, /* twist.u [rad/s] */
};

/* inputs of the model */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* nothing */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    0.0, /* load [N] */
    20000.0, /* cable0.EA [N] */
    1.1558653061325095, /* cable0.length [m] */
    0.001, /* cable0.damping [s] */
    20000.0, /* counter0.EA [N] */
    1.1558653061325095, /* counter0.length [m] */
    0.001, /* counter0.damping [s] */
    20000.0, /* cable1.EA [N] */
    1.1558653061325095, /* cable1.length [m] */
    0.001, /* cable1.damping [s] */
    20000.0, /* counter1.EA [N] */
    1.1558653061325095, /* counter1.length [m] */
    0.001, /* counter1.damping [s] */
    20000.0, /* cable2.EA [N] */
    1.1558653061325095, /* cable2.length [m] */
    0.001, /* cable2.damping [s] */
    20000.0, /* counter2.EA [N] */
    1.1558653061325095, /* counter2.length [m] */
    0.001, /* counter2.damping [s] */
    5.0, /* top.mass [kg] */
    0.5, /* top.inertia.xx [kg m^2] */
    0.5, /* top.inertia.yy [kg m^2] */
    1.0, /* top.inertia.zz [kg m^2] */
    13000000.0, /* bar0.stiffness [N/m] */
    2000.0, /* bar0.damping [N*s/m] */
    0.8, /* bar0.rest_length [m] */
    0.5, /* bar0.a.position.x [m] */
    0.5, /* bar0.b.position.x [m] */
    13000000.0, /* bar1.stiffness [N/m] */
    2000.0, /* bar1.damping [N*s/m] */
    0.8, /* bar1.rest_length [m] */
    -0.2499999999999999, /* bar1.a.position.x [m] */
    0.43301270189221935, /* bar1.a.position.y [m] */
    -0.2499999999999999, /* bar1.b.position.x [m] */
    0.43301270189221935, /* bar1.b.position.y [m] */
    13000000.0, /* bar2.stiffness [N/m] */
    2000.0, /* bar2.damping [N*s/m] */
    0.8, /* bar2.rest_length [m] */
    -0.2500000000000002, /* bar2.a.position.x [m] */
    -0.4330127018922192, /* bar2.a.position.y [m] */
    -0.2500000000000002, /* bar2.b.position.x [m] */
    -0.4330127018922192, /* bar2.b.position.y [m] */
    1.7, /* end.upper [rad] */
    0.3, /* end.restitution */
    0.05, /* end.settle [rad/s] */
    -0.2499999999999999, /* cable0.b.position.x [m] */
    0.43301270189221935, /* cable0.b.position.y [m] */
    -0.2500000000000002, /* counter0.b.position.x [m] */
    -0.4330127018922192, /* counter0.b.position.y [m] */
    -0.2500000000000002, /* cable1.b.position.x [m] */
    -0.4330127018922192, /* cable1.b.position.y [m] */
    0.5, /* counter1.b.position.x [m] */
    0.5, /* cable2.b.position.x [m] */
    -0.2499999999999999, /* counter2.b.position.x [m] */
    0.43301270189221935, /* counter2.b.position.y [m] */
};

/* internal continuous states */
const double cardan_default_z[cardan_nz + (cardan_nz == 0)] = {
    0.0, /* nothing */
};

/* discrete states */
const double cardan_default_s[cardan_ns + (cardan_ns == 0)] = {
    0.0, /* end */
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
    .name = "bay",
    .nq = 2,
    .nu = 2,
    .nr = 0,
    .nz = 0,
    .ns = 1,
    .zeros = 12,
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
};
