/*
 * model.c: values of model 'stewart_platform' to start from; the model as one
 * constant.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.206331740908, /* hooke0.angle1 [rad] */
    -0.334264276128, /* hooke0.angle2 [rad] */
    0.434661033144, /* slide0 [m] */
    0.994479975015, /* ball0.qw */
    -0.054967631682, /* ball0.qx */
    0.084469922035, /* ball0.qy */
    0.029205667805, /* ball0.qz */
    -0.236734052785, /* hooke1.angle1 [rad] */
    -0.331678827194, /* hooke1.angle2 [rad] */
    0.496999331908, /* slide1 [m] */
    0.187488217949, /* hooke2.angle1 [rad] */
    0.364949005684, /* hooke2.angle2 [rad] */
    0.482933740805, /* slide2 [m] */
    0.449776242427, /* hooke3.angle1 [rad] */
    0.019586743392, /* hooke3.angle2 [rad] */
    0.374123647188, /* slide3 [m] */
    -0.477308192371, /* hooke4.angle1 [rad] */
    0.024290617692, /* hooke4.angle2 [rad] */
    0.373012130536, /* slide4 [m] */
    -0.243021153166, /* hooke5.angle1 [rad] */
    0.407669807094, /* hooke5.angle2 [rad] */
    0.44057263122, /* slide5 [m] */
};

/* generalized speeds */
const double cardan_default_u[cardan_nu + (cardan_nu == 0)] = {
    0.0, /* hooke0.u.angle1 [rad/s] */
    0.0, /* hooke0.u.angle2 [rad/s] */
    0.0, /* slide0.u [m/s] */
    0.0, /* ball0.u.x [rad/s] */
    0.0, /* ball0.u.y [rad/s] */
    0.0, /* ball0.u.z [rad/s] */
    0.0, /* hooke1.u.angle1 [rad/s] */
    0.0, /* hooke1.u.angle2 [rad/s] */
    0.0, /* slide1.u [m/s] */
    0.0, /* hooke2.u.angle1 [rad/s] */
    0.0, /* hooke2.u.angle2 [rad/s] */
    0.0, /* slide2.u [m/s] */
    0.0, /* hooke3.u.angle1 [rad/s] */
    0.0, /* hooke3.u.angle2 [rad/s] */
    0.0, /* slide3.u [m/s] */
    0.0, /* hooke4.u.angle1 [rad/s] */
    0.0, /* hooke4.u.angle2 [rad/s] */
    0.0, /* slide4.u [m/s] */
    0.0, /* hooke5.u.angle1 [rad/s] */
    0.0, /* hooke5.u.angle2 [rad/s] */
    0.0, /* slide5.u [m/s] */
};

/* inputs of the model */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* drive0 */
    0.0, /* drive1 */
    0.0, /* drive2 */
    0.0, /* drive3 */
    0.0, /* drive4 */
    0.0, /* drive5 */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    -9.81, /* gravity.z [m/s^2] */
    0.5908846518073247, /* hooke0.position.x [m] */
    -0.1041889066001582, /* hooke0.position.y [m] */
    1.2, /* tube0.mass [kg] */
    0.2, /* tube0.com.z [m] */
    0.016, /* tube0.inertia.xx [kg m^2] */
    0.016, /* tube0.inertia.yy [kg m^2] */
    0.0005, /* tube0.inertia.zz [kg m^2] */
    0.5, /* slide0.position.z [m] */
    0.5, /* rod0.mass [kg] */
    -0.2, /* rod0.com.z [m] */
    0.007, /* rod0.inertia.xx [kg m^2] */
    0.007, /* rod0.inertia.yy [kg m^2] */
    6e-05, /* rod0.inertia.zz [kg m^2] */
    0.25711504387461576, /* ball0.child.position.x [m] */
    -0.3064177772475912, /* ball0.child.position.y [m] */
    5.0, /* platform.mass [kg] */
    0.03, /* platform.com.z [m] */
    0.22, /* platform.inertia.xx [kg m^2] */
    0.25, /* platform.inertia.yy [kg m^2] */
    0.4, /* platform.inertia.zz [kg m^2] */
    0.5908846518073247, /* hooke1.position.x [m] */
    0.1041889066001582, /* hooke1.position.y [m] */
    1.2, /* tube1.mass [kg] */
    0.2, /* tube1.com.z [m] */
    0.016, /* tube1.inertia.xx [kg m^2] */
    0.016, /* tube1.inertia.yy [kg m^2] */
    0.0005, /* tube1.inertia.zz [kg m^2] */
    0.5, /* slide1.position.z [m] */
    0.5, /* rod1.mass [kg] */
    -0.2, /* rod1.com.z [m] */
    0.007, /* rod1.inertia.xx [kg m^2] */
    0.007, /* rod1.inertia.yy [kg m^2] */
    6e-05, /* rod1.inertia.zz [kg m^2] */
    -0.20521208599540122, /* hooke2.position.x [m] */
    0.563815572471545, /* hooke2.position.y [m] */
    1.2, /* tube2.mass [kg] */
    0.2, /* tube2.com.z [m] */
    0.016, /* tube2.inertia.xx [kg m^2] */
    0.016, /* tube2.inertia.yy [kg m^2] */
    0.0005, /* tube2.inertia.zz [kg m^2] */
    0.5, /* slide2.position.z [m] */
    0.5, /* rod2.mass [kg] */
    -0.2, /* rod2.com.z [m] */
    0.007, /* rod2.inertia.xx [kg m^2] */
    0.007, /* rod2.inertia.yy [kg m^2] */
    6e-05, /* rod2.inertia.zz [kg m^2] */
    -0.3856725658119236, /* hooke3.position.x [m] */
    0.4596266658713868, /* hooke3.position.y [m] */
    1.2, /* tube3.mass [kg] */
    0.2, /* tube3.com.z [m] */
    0.016, /* tube3.inertia.xx [kg m^2] */
    0.016, /* tube3.inertia.yy [kg m^2] */
    0.0005, /* tube3.inertia.zz [kg m^2] */
    0.5, /* slide3.position.z [m] */
    0.5, /* rod3.mass [kg] */
    -0.2, /* rod3.com.z [m] */
    0.007, /* rod3.inertia.xx [kg m^2] */
    0.007, /* rod3.inertia.yy [kg m^2] */
    6e-05, /* rod3.inertia.zz [kg m^2] */
    -0.38567256581192366, /* hooke4.position.x [m] */
    -0.45962666587138673, /* hooke4.position.y [m] */
    1.2, /* tube4.mass [kg] */
    0.2, /* tube4.com.z [m] */
    0.016, /* tube4.inertia.xx [kg m^2] */
    0.016, /* tube4.inertia.yy [kg m^2] */
    0.0005, /* tube4.inertia.zz [kg m^2] */
    0.5, /* slide4.position.z [m] */
    0.5, /* rod4.mass [kg] */
    -0.2, /* rod4.com.z [m] */
    0.007, /* rod4.inertia.xx [kg m^2] */
    0.007, /* rod4.inertia.yy [kg m^2] */
    6e-05, /* rod4.inertia.zz [kg m^2] */
    -0.2052120859954011, /* hooke5.position.x [m] */
    -0.563815572471545, /* hooke5.position.y [m] */
    1.2, /* tube5.mass [kg] */
    0.2, /* tube5.com.z [m] */
    0.016, /* tube5.inertia.xx [kg m^2] */
    0.016, /* tube5.inertia.yy [kg m^2] */
    0.0005, /* tube5.inertia.zz [kg m^2] */
    0.5, /* slide5.position.z [m] */
    0.5, /* rod5.mass [kg] */
    -0.2, /* rod5.com.z [m] */
    0.007, /* rod5.inertia.xx [kg m^2] */
    0.007, /* rod5.inertia.yy [kg m^2] */
    6e-05, /* rod5.inertia.zz [kg m^2] */
    0.25711504387461576, /* ball1.child.position.x [m] */
    0.3064177772475912, /* ball1.child.position.y [m] */
    0.13680805733026755, /* ball2.child.position.x [m] */
    0.37587704831436336, /* ball2.child.position.y [m] */
    -0.3939231012048832, /* ball3.child.position.x [m] */
    0.06945927106677212, /* ball3.child.position.y [m] */
    -0.3939231012048832, /* ball4.child.position.x [m] */
    -0.06945927106677219, /* ball4.child.position.y [m] */
    0.1368080573302676, /* ball5.child.position.x [m] */
    -0.37587704831436336, /* ball5.child.position.y [m] */
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
    3,
};
const cardan_export cardan_scene = {
    .name = "stewart_platform",
    .nq = 22,
    .nu = 21,
    .nr = 6,
    .nz = 0,
    .ns = 0,
    .zeros = 78,
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
    .positions = 15,
    .rates = 15,
    .size = 1.0,
    .columns = NULL,
    .cost = NULL,
};
