/*
 * model.c: values of model 'flexible_pendulum' to start from; the model as one
 * constant.
 */
#include "tables.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.0, /* pin [rad] */
    1.0, /* bar.end.qw */
    0.0, /* bar.end.qx */
    0.0, /* bar.end.qy */
    0.0, /* bar.end.qz */
    1.0, /* bar.end.px [m] */
    0.0, /* bar.end.py [m] */
    0.0, /* bar.end.pz [m] */
    1.0, /* bar.node1.qw */
    0.0, /* bar.node1.qx */
    0.0, /* bar.node1.qy */
    0.0, /* bar.node1.qz */
    0.1, /* bar.node1.px [m] */
    0.0, /* bar.node1.py [m] */
    0.0, /* bar.node1.pz [m] */
    1.0, /* bar.node2.qw */
    0.0, /* bar.node2.qx */
    0.0, /* bar.node2.qy */
    0.0, /* bar.node2.qz */
    0.20000000000000004, /* bar.node2.px [m] */
    0.0, /* bar.node2.py [m] */
    0.0, /* bar.node2.pz [m] */
    1.0, /* bar.node3.qw */
    0.0, /* bar.node3.qx */
    0.0, /* bar.node3.qy */
    0.0, /* bar.node3.qz */
    0.30000000000000004, /* bar.node3.px [m] */
    0.0, /* bar.node3.py [m] */
    0.0, /* bar.node3.pz [m] */
    1.0, /* bar.node4.qw */
    0.0, /* bar.node4.qx */
    0.0, /* bar.node4.qy */
    0.0, /* bar.node4.qz */
    0.4, /* bar.node4.px [m] */
    0.0, /* bar.node4.py [m] */
    0.0, /* bar.node4.pz [m] */
    1.0, /* bar.node5.qw */
    0.0, /* bar.node5.qx */
    0.0, /* bar.node5.qy */
    0.0, /* bar.node5.qz */
    0.5, /* bar.node5.px [m] */
    0.0, /* bar.node5.py [m] */
    0.0, /* bar.node5.pz [m] */
    1.0, /* bar.node6.qw */
    0.0, /* bar.node6.qx */
    0.0, /* bar.node6.qy */
    0.0, /* bar.node6.qz */
    0.6000000000000001, /* bar.node6.px [m] */
    0.0, /* bar.node6.py [m] */
    0.0, /* bar.node6.pz [m] */
    1.0, /* bar.node7.qw */
    0.0, /* bar.node7.qx */
    0.0, /* bar.node7.qy */
    0.0, /* bar.node7.qz */
    0.7000000000000001, /* bar.node7.px [m] */
    0.0, /* bar.node7.py [m] */
    0.0, /* bar.node7.pz [m] */
    1.0, /* bar.node8.qw */
    0.0, /* bar.node8.qx */
    0.0, /* bar.node8.qy */
    0.0, /* bar.node8.qz */
    0.8, /* bar.node8.px [m] */
    0.0, /* bar.node8.py [m] */
    0.0, /* bar.node8.pz [m] */
    1.0, /* bar.node9.qw */
    0.0, /* bar.node9.qx */
    0.0, /* bar.node9.qy */
    0.0, /* bar.node9.qz */
    0.9, /* bar.node9.px [m] */
    0.0, /* bar.node9.py [m] */
    0.0, /* bar.node9.pz [m] */
};

/* generalized speeds */
const double cardan_default_u[cardan_nu + (cardan_nu == 0)] = {
    0.0, /* pin.u [rad/s] */
    0.0, /* bar.end.u.x [rad/s] */
    0.0, /* bar.end.u.y [rad/s] */
    0.0, /* bar.end.u.z [rad/s] */
    0.0, /* bar.end.u.px [m/s] */
    0.0, /* bar.end.u.py [m/s] */
    0.0, /* bar.end.u.pz [m/s] */
    0.0, /* bar.node1.u.x [rad/s] */
    0.0, /* bar.node1.u.y [rad/s] */
    0.0, /* bar.node1.u.z [rad/s] */
    0.0, /* bar.node1.u.px [m/s] */
    0.0, /* bar.node1.u.py [m/s] */
    0.0, /* bar.node1.u.pz [m/s] */
    0.0, /* bar.node2.u.x [rad/s] */
    0.0, /* bar.node2.u.y [rad/s] */
    0.0, /* bar.node2.u.z [rad/s] */
    0.0, /* bar.node2.u.px [m/s] */
    0.0, /* bar.node2.u.py [m/s] */
    0.0, /* bar.node2.u.pz [m/s] */
    0.0, /* bar.node3.u.x [rad/s] */
    0.0, /* bar.node3.u.y [rad/s] */
    0.0, /* bar.node3.u.z [rad/s] */
    0.0, /* bar.node3.u.px [m/s] */
    0.0, /* bar.node3.u.py [m/s] */
    0.0, /* bar.node3.u.pz [m/s] */
    0.0, /* bar.node4.u.x [rad/s] */
    0.0, /* bar.node4.u.y [rad/s] */
    0.0, /* bar.node4.u.z [rad/s] */
    0.0, /* bar.node4.u.px [m/s] */
    0.0, /* bar.node4.u.py [m/s] */
    0.0, /* bar.node4.u.pz [m/s] */
    0.0, /* bar.node5.u.x [rad/s] */
    0.0, /* bar.node5.u.y [rad/s] */
    0.0, /* bar.node5.u.z [rad/s] */
    0.0, /* bar.node5.u.px [m/s] */
    0.0, /* bar.node5.u.py [m/s] */
    0.0, /* bar.node5.u.pz [m/s] */
    0.0, /* bar.node6.u.x [rad/s] */
    0.0, /* bar.node6.u.y [rad/s] */
    0.0, /* bar.node6.u.z [rad/s] */
    0.0, /* bar.node6.u.px [m/s] */
    0.0, /* bar.node6.u.py [m/s] */
    0.0, /* bar.node6.u.pz [m/s] */
    0.0, /* bar.node7.u.x [rad/s] */
    0.0, /* bar.node7.u.y [rad/s] */
    0.0, /* bar.node7.u.z [rad/s] */
    0.0, /* bar.node7.u.px [m/s] */
    0.0, /* bar.node7.u.py [m/s] */
    0.0, /* bar.node7.u.pz [m/s] */
    0.0, /* bar.node8.u.x [rad/s] */
    0.0, /* bar.node8.u.y [rad/s] */
    0.0, /* bar.node8.u.z [rad/s] */
    0.0, /* bar.node8.u.px [m/s] */
    0.0, /* bar.node8.u.py [m/s] */
    0.0, /* bar.node8.u.pz [m/s] */
    0.0, /* bar.node9.u.x [rad/s] */
    0.0, /* bar.node9.u.y [rad/s] */
    0.0, /* bar.node9.u.z [rad/s] */
    0.0, /* bar.node9.u.px [m/s] */
    0.0, /* bar.node9.u.py [m/s] */
    0.0, /* bar.node9.u.pz [m/s] */
};

/* inputs of the model */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* nothing */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    -9.81, /* gravity.z [m/s^2] */
    0.02, /* bar.section.width [m] */
    0.02, /* bar.section.height [m] */
    5000000.0, /* bar.material.E [Pa] */
    0.45, /* bar.material.nu */
    1100.0, /* bar.material.rho [kg/m^3] */
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
    {.name = "energy", .function = energy, .out = energy_out_size},
    {.name = "forward_dynamics", .function = forward_dynamics, .out = forward_dynamics_out_size},
};
static const ptrdiff_t quaternions[] = {
    1, 8, 15, 22, 29, 36, 43, 50, 57, 64,
};
static const double columns[] = {
    1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    1.0,
};
const cardan_export cardan_scene = {
    .name = "flexible_pendulum",
    .nq = 71,
    .nu = 61,
    .nr = 0,
    .nz = 0,
    .ns = 0,
    .zeros = 71,
    .q = cardan_default_q,
    .u = cardan_default_u,
    .r = cardan_default_r,
    .p = cardan_default_p,
    .z = cardan_default_z,
    .s = cardan_default_s,
    .functions = scene_functions,
    .function_count = 2,
    .methods = NULL,
    .method_count = 0,
    .quaternions = quaternions,
    .quaternion_count = 10,
    .positions = 0,
    .rates = 0,
    .size = 1.0,
    .columns = columns,
    .cost = NULL,
    .mesh = &mesh,
    .elements = &elements,
    .calls = &cardan_calls_of_elements,
};
