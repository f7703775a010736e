/*
 * model.c: values of model 'arm' to start from; the model as one
 * constant.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    1.0, /* shoulder.qw */
    0.0, /* shoulder.qx */
    0.0, /* shoulder.qy */
    0.0, /* shoulder.qz */
    0.0, /* elbow [rad] */
};

/* generalized speeds */
const double cardan_default_u[cardan_nu + (cardan_nu == 0)] = {
    0.0, /* shoulder.u.x [rad/s] */
    0.0, /* shoulder.u.y [rad/s] */
    0.0, /* shoulder.u.z [rad/s] */
    0.0, /* elbow.u [rad/s] */
};

/* inputs of the model */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* nothing */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    1.0, /* m [kg] */
    -9.81, /* gravity.z [m/s^2] */
    -0.5, /* upper.com.z [m] */
    -1.0, /* elbow.position.z [m] */
    0.5, /* hand.mass [kg] */
    0.01, /* hand.inertia.xx [kg m^2] */
    0.01, /* hand.inertia.yy [kg m^2] */
    0.01, /* hand.inertia.zz [kg m^2] */
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
    {.name = "derivative__forward_dynamics_q_u", .function = derivative__forward_dynamics_q_u, .out = derivative__forward_dynamics_q_u_out_size, .work = derivative__forward_dynamics_q_u_work_size, .w = derivative__forward_dynamics_q_u_w_size, .prepare = prepare_derivative__forward_dynamics_q_u},
};
static const ptrdiff_t quaternions[] = {
    0,
};
const cardan_export cardan_scene = {
    .name = "arm",
    .nq = 5,
    .nu = 4,
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
    .function_count = 1,
    .methods = NULL,
    .method_count = 0,
    .quaternions = quaternions,
    .quaternion_count = 1,
    .positions = 0,
    .rates = 0,
    .size = 1.0,
    .columns = NULL,
    .cost = NULL,
};
