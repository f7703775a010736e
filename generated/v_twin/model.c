/*
 * model.c: values of model 'v_twin' to start from; the model as one
 * constant.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    1.437159154772, /* right.crank [rad] */
    -1.687537947625, /* right.rod [rad] */
    0.200425715389, /* right.piston [m] */
    -0.133637172023, /* left.crank [rad] */
    0.166953274548, /* left.rod [rad] */
    0.249443205717, /* left.piston [m] */
};

/* generalized speeds */
const double cardan_default_u[cardan_nu + (cardan_nu == 0)] = {
    0.0, /* right.crank.u [rad/s] */
    0.0, /* right.rod.u [rad/s] */
    0.0, /* right.piston.u [m/s] */
    0.0, /* left.crank.u [rad/s] */
    0.0, /* left.rod.u [rad/s] */
    0.0, /* left.piston.u [m/s] */
};

/* inputs of the model */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* right.torque [N m] */
    0.0, /* right.force [N] */
    0.0, /* left.torque [N m] */
    0.0, /* left.force [N] */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    0.05, /* right.crank_length [m] */
    0.2, /* right.rod_length [m] */
    0.0, /* right.offset [m] */
    0.08, /* right.bore [m] */
    0.6, /* right.crank_mass [kg] */
    0.4, /* right.rod_mass [kg] */
    0.5, /* right.piston_mass [kg] */
    0.05, /* left.crank_length [m] */
    0.2, /* left.rod_length [m] */
    0.0, /* left.offset [m] */
    0.08, /* left.bore [m] */
    0.6, /* left.crank_mass [kg] */
    0.4, /* left.rod_mass [kg] */
    0.5, /* left.piston_mass [kg] */
    -9.81, /* gravity.z [m/s^2] */
    -0.7853981633974483, /* right.ground.rotation.angle2 [rad] */
    0.05, /* left.ground.position.y [m] */
    -2.356194490192345, /* left.ground.rotation.angle2 [rad] */
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
    .name = "v_twin",
    .nq = 6,
    .nu = 6,
    .nr = 4,
    .nz = 0,
    .ns = 0,
    .zeros = 36,
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
    .positions = 5,
    .rates = 5,
    .size = 1.0,
    .columns = NULL,
    .cost = NULL,
};
