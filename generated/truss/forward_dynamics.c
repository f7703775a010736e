/*
 * forward_dynamics of truss
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 2, work 0, w 10
 * Operations per call: 38 = 15 mul, 7 sub, 6 add, 4 select, 2 div, 2 lt, 2 sqrt
 * Operations of prepare: 2 = 1 div, 1 mul
 *
 * Input q (2): generalized coordinates
 *   q[0]  u [m]
 *   q[1]  w [m]
 *
 * Input p (13): parameters, read by prepare_ only
 *
 * Input tau (2): applied generalized forces
 *   tau[0]  u.u.tau [N]
 *   tau[1]  w.u.tau [N]
 *
 * Output udot (2)
 *   out[0]  u.udot [m/s^2]
 *   out[1]  w.udot [m/s^2]
 */
#include "cardan.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* load: data */
    const wreal P = p[0];
    const wreal tilt = p[1];
    const wreal load_force_on_apex_x = P * tilt;
    w[8] = load_force_on_apex_x;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal apex_mass = p[3]; /* kg */
    const wreal M_factor_D_inverse_u = 1.0 / apex_mass;
    w[9] = M_factor_D_inverse_u;

    /* parameters as they are */
    w[0] = p[0]; /* P */
    w[1] = p[2]; /* u.position.z [m] */
    w[2] = p[7]; /* left.stiffness [N/m] */
    w[3] = p[8]; /* left.rest_length [m] */
    w[4] = p[9]; /* left.a.position.x [m] */
    w[5] = p[10]; /* right.stiffness [N/m] */
    w[6] = p[11]; /* right.rest_length [m] */
    w[7] = p[12]; /* right.a.position.x [m] */
}

#include "lanes.h"

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    (void)work;

    /* apex: position */
    /* position = position_parent + orientation_parent p */
    const real w_q = q[1]; /* m */
    const wreal u_position_z = w[1]; /* m */
    const real apex_position_z = u_position_z - w_q;

    /* left: spring damper */
    /* force = stiffness (distance - rest_length) + damping d(distance)/dt */
    const real u_q = q[0]; /* m */
    const wreal left_a_position_x = w[4]; /* m */
    const real left_spring_damper_span_x = u_q - left_a_position_x;

    /* shared by several: spring damper */
    /* force = stiffness (distance - rest_length) + damping d(distance)/dt */
    const real apex_position_z_squared = apex_position_z * apex_position_z;

    /* left: spring damper */
    /* force = stiffness (distance - rest_length) + damping d(distance)/dt */
    const wreal left_stiffness = w[2]; /* N/m */
    const wreal left_rest_length = w[3]; /* m */
    const real left_spring_damper_distance = cardan_sqrt(left_spring_damper_span_x *
        left_spring_damper_span_x + apex_position_z_squared);
    const real left_spring_damper_apart = cardan_lt(0.0, left_spring_damper_distance);
    const real left_spring_damper_inverse_distance = cardan_select(left_spring_damper_apart, 1.0,
        0.0) / cardan_select(left_spring_damper_apart, left_spring_damper_distance, 1.0);
    const real left_force_on_left_a_x_part = left_stiffness * (left_spring_damper_distance
        - left_rest_length);

    /* right: spring damper */
    /* force = stiffness (distance - rest_length) + damping d(distance)/dt */
    const wreal right_stiffness = w[5]; /* N/m */
    const wreal right_rest_length = w[6]; /* m */
    const wreal right_a_position_x = w[7]; /* m */
    const real right_spring_damper_span_x = u_q - right_a_position_x;
    const real right_spring_damper_distance = cardan_sqrt(apex_position_z_squared
        + right_spring_damper_span_x * right_spring_damper_span_x);
    const real right_spring_damper_apart = cardan_lt(0.0, right_spring_damper_distance);
    const real right_spring_damper_inverse_distance = cardan_select(right_spring_damper_apart, 1.0,
        0.0) / cardan_select(right_spring_damper_apart, right_spring_damper_distance, 1.0);
    const real right_force_on_right_a_x_part = right_stiffness * (right_spring_damper_distance
        - right_rest_length);

    /* apex: f */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const wreal P = w[0];
    const real apex_f_z = P
        + apex_position_z * left_spring_damper_inverse_distance * left_force_on_left_a_x_part
        + apex_position_z * right_spring_damper_inverse_distance * right_force_on_right_a_x_part;

    /* u: drive, udot */
    /* drive = tau + f - h */
    /* udot = M⁻¹ drive */
    const real u_u_tau = tau[0]; /* N */
    const wreal load_force_on_apex_x = w[8];
    const wreal M_factor_D_inverse_u = w[9];
    const real u_drive = load_force_on_apex_x + u_u_tau
        - left_spring_damper_span_x * left_spring_damper_inverse_distance *
        left_force_on_left_a_x_part
        - right_spring_damper_span_x * right_spring_damper_inverse_distance *
        right_force_on_right_a_x_part;
    out[0] = u_drive * M_factor_D_inverse_u; /* udot: u.udot [m/s^2] */

    /* w: drive, udot */
    /* drive = tau + f - h */
    /* udot = M⁻¹ drive */
    const real w_u_tau = tau[1]; /* N */
    const real w_drive = w_u_tau + apex_f_z;
    out[1] = w_drive * M_factor_D_inverse_u; /* udot: w.udot [m/s^2] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {2, 0, 10, 0, 2, 0, 0, 0, 0, 13, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0};
#endif
