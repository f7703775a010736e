/*
 * forward_dynamics of andrews
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: parallel, base_parameters
 * passes: unroll
 *
 * Sizes: out 7, work 75, w 32
 * Operations per call: 864 = 496 mul, 169 sub, 168 add, 8 neg, 7 cos, 7 sin, 4 div, 2 select,
 *     1 lt, 1 solve, 1 sqrt
 * Operations of prepare: 43 = 26 mul, 13 add, 4 div
 *
 * Input q (7): generalized coordinates
 *   q[0]  beta [rad]
 *   q[1]  theta [rad]
 *   q[2]  gamma [rad]
 *   q[3]  delta [rad]
 *   q[4]  phi [rad]
 *   q[5]  epsilon [rad]
 *   q[6]  omega [rad]
 *
 * Input u (7): generalized speeds
 *   u[0]  beta.u [rad/s]
 *   u[1]  theta.u [rad/s]
 *   u[2]  gamma.u [rad/s]
 *   u[3]  delta.u [rad/s]
 *   u[4]  phi.u [rad/s]
 *   u[5]  epsilon.u [rad/s]
 *   u[6]  omega.u [rad/s]
 *
 * Input p (58): parameters, read by prepare_ only
 *
 * Input tau (7): applied generalized forces
 *   tau[0]  beta.u.tau [N*m]
 *   tau[1]  theta.u.tau [N*m]
 *   tau[2]  gamma.u.tau [N*m]
 *   tau[3]  delta.u.tau [N*m]
 *   tau[4]  phi.u.tau [N*m]
 *   tau[5]  epsilon.u.tau [N*m]
 *   tau[6]  omega.u.tau [N*m]
 *
 * Output udot (7)
 *   out[0]  beta.udot [rad/s^2]
 *   out[1]  theta.udot [rad/s^2]
 *   out[2]  gamma.udot [rad/s^2]
 *   out[3]  delta.udot [rad/s^2]
 *   out[4]  phi.udot [rad/s^2]
 *   out[5]  epsilon.udot [rad/s^2]
 *   out[6]  omega.udot [rad/s^2]
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* K1: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal K1_mass = p[0]; /* kg */
    const wreal K1_com_x = p[1]; /* m */
    const wreal K1_inertia_zz = p[4]; /* kg m^2 */
    const wreal theta_position_x = p[5]; /* m */
    const wreal K2_mass = p[6]; /* kg */
    const wreal K1_first_moment_x = K1_mass * K1_com_x;
    const wreal K1_origin_inertia_zz = K1_inertia_zz + K1_com_x * K1_first_moment_x;
    const wreal K1_base_inertia_zz = K1_origin_inertia_zz
        + theta_position_x * K2_mass * theta_position_x;
    w[27] = K1_base_inertia_zz;

    /* K2: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal K2_com_x = p[7]; /* m */
    const wreal K2_inertia_zz = p[10]; /* kg m^2 */
    const wreal K2_first_moment_x = K2_mass * K2_com_x;
    const wreal K2_origin_inertia_zz = K2_inertia_zz + K2_com_x * K2_first_moment_x;
    w[1] = K2_first_moment_x;
    w[2] = K2_origin_inertia_zz;

    /* K3: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal K3_mass = p[13]; /* kg */
    const wreal K3_com_x = p[14]; /* m */
    const wreal K3_com_y = p[15]; /* m */
    const wreal K3_inertia_zz = p[18]; /* kg m^2 */
    const wreal K3_first_moment_x = K3_mass * K3_com_x;
    const wreal K3_first_moment_y = K3_mass * K3_com_y;
    const wreal K3_origin_inertia_zz = K3_com_x * K3_first_moment_x
        + K3_com_y * K3_first_moment_y + K3_inertia_zz;

    /* K5: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal K5_mass = p[21]; /* kg */
    const wreal K5_com_x = p[22]; /* m */
    const wreal K5_com_y = p[23]; /* m */
    const wreal K5_inertia_zz = p[26]; /* kg m^2 */
    const wreal phi_position_x = p[27]; /* m */
    const wreal K4_mass = p[28]; /* kg */
    const wreal K5_first_moment_x = K5_mass * K5_com_x;
    const wreal K5_first_moment_y = K5_mass * K5_com_y;
    const wreal K5_origin_inertia_zz = K5_com_x * K5_first_moment_x
        + K5_com_y * K5_first_moment_y + K5_inertia_zz;
    const wreal K5_base_inertia_zz = K5_origin_inertia_zz
        + phi_position_x * K4_mass * phi_position_x;
    w[26] = K5_base_inertia_zz;

    /* K4: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal K4_com_y = p[29]; /* m */
    const wreal K4_inertia_zz = p[32]; /* kg m^2 */
    const wreal K4_first_moment_y = K4_mass * K4_com_y;
    const wreal K4_origin_inertia_zz = K4_inertia_zz + K4_com_y * K4_first_moment_y;
    w[8] = K4_first_moment_y;
    w[9] = K4_origin_inertia_zz;

    /* K7: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal K7_mass = p[35]; /* kg */
    const wreal K7_com_x = p[36]; /* m */
    const wreal K7_com_y = p[37]; /* m */
    const wreal K7_inertia_zz = p[40]; /* kg m^2 */
    const wreal omega_position_y = p[41]; /* m */
    const wreal K6_mass = p[42]; /* kg */
    const wreal K7_first_moment_x = K7_mass * K7_com_x;
    const wreal K7_first_moment_y = K7_mass * K7_com_y;
    const wreal K7_origin_inertia_zz = K7_com_x * K7_first_moment_x
        + K7_com_y * K7_first_moment_y + K7_inertia_zz;
    const wreal K7_base_inertia_zz = K7_origin_inertia_zz
        + omega_position_y * K6_mass * omega_position_y;
    w[25] = K7_base_inertia_zz;

    /* K6: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal K6_com_x = p[43]; /* m */
    const wreal K6_inertia_zz = p[46]; /* kg m^2 */
    const wreal K6_first_moment_x = K6_mass * K6_com_x;
    const wreal K6_origin_inertia_zz = K6_inertia_zz + K6_com_x * K6_first_moment_x;
    w[13] = K6_first_moment_x;
    w[14] = K6_origin_inertia_zz;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal M_factor_D_inverse_omega = 1.0 / K6_origin_inertia_zz;
    const wreal M_factor_D_inverse_phi = 1.0 / K4_origin_inertia_zz;
    const wreal M_factor_D_inverse_gamma = 1.0 / K3_origin_inertia_zz;
    const wreal M_factor_D_inverse_theta = 1.0 / K2_origin_inertia_zz;
    w[28] = M_factor_D_inverse_omega;
    w[29] = M_factor_D_inverse_phi;
    w[30] = M_factor_D_inverse_gamma;
    w[31] = M_factor_D_inverse_theta;

    /* parameters as they are */
    w[0] = p[5]; /* theta.position.x [m] */
    w[3] = p[11]; /* gamma.position.x [m] */
    w[4] = p[12]; /* gamma.position.y [m] */
    w[5] = p[19]; /* delta.position.x [m] */
    w[6] = p[20]; /* delta.position.y [m] */
    w[7] = p[27]; /* phi.position.x [m] */
    w[10] = p[33]; /* epsilon.position.x [m] */
    w[11] = p[34]; /* epsilon.position.y [m] */
    w[12] = p[41]; /* omega.position.y [m] */
    w[15] = p[48]; /* E3.child.position.y [m] */
    w[16] = p[49]; /* E4.child.position.y [m] */
    w[17] = p[50]; /* E6.child.position.x [m] */
    w[18] = p[51]; /* spring.stiffness [N/m] */
    w[19] = p[52]; /* spring.rest_length [m] */
    w[20] = p[53]; /* spring.a.position.x [m] */
    w[21] = p[54]; /* spring.a.position.y [m] */
    w[22] = p[55]; /* spring.b.position.x [m] */
    w[23] = p[56]; /* spring.b.position.y [m] */
    w[24] = p[57]; /* drive.force */
}

#include "lanes.h"

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    real (*const circuit_matrix)[6] = (real (*)[6])(work + 0);
    real *const circuit_right = work + 36;
    real *const circuit_scratch = work + 42;
    int status = CARDAN_OK;

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real beta_q = q[0]; /* rad */
    const real theta_q = q[1]; /* rad */
    const real gamma_q = q[2]; /* rad */
    const real delta_q = q[3]; /* rad */
    const real phi_q = q[4]; /* rad */
    const real epsilon_q = q[5]; /* rad */
    const real omega_q = q[6]; /* rad */
    const real theta_turn = beta_q + theta_q;
    const real phi_turn = delta_q + phi_q;
    const real omega_turn = epsilon_q + omega_q;
    const real angle[CARDAN_PADDED(7)] = {beta_q, delta_q, epsilon_q, theta_turn, gamma_q,
        phi_turn, omega_turn};
    real sine[CARDAN_PADDED(7)], cosine[CARDAN_PADDED(7)];
    cardan_sincos(7, angle, sine, cosine);
    const real beta_cos = cosine[0];
    const real beta_sin = sine[0];
    const real delta_cos = cosine[1];
    const real delta_sin = sine[1];
    const real epsilon_cos = cosine[2];
    const real epsilon_sin = sine[2];
    const real theta_turn_cos = cosine[3];
    const real theta_turn_sin = sine[3];
    const real gamma_cos = cosine[4];
    const real gamma_sin = sine[4];
    const real phi_turn_cos = cosine[5];
    const real phi_turn_sin = sine[5];
    const real omega_turn_cos = cosine[6];
    const real omega_turn_sin = sine[6];

    /* theta: p */
    /* p = p_fixed + R_fixed p_joint(q) */
    const real beta_u = u[0]; /* rad/s */
    const wreal theta_position_x = w[0]; /* m */
    const real theta_p_x = theta_position_x * beta_cos;
    const real theta_p_y = theta_position_x * beta_sin;
    const real theta_minus_p_x_rate = beta_u * beta_sin * theta_position_x;
    const real theta_p_y_rate = beta_u * beta_cos * theta_position_x;

    /* phi: p */
    /* p = p_fixed + R_fixed p_joint(q) */
    const real delta_u = u[3]; /* rad/s */
    const wreal phi_position_x = w[7]; /* m */
    const real phi_p_x = phi_position_x * delta_cos;
    const real phi_p_y = phi_position_x * delta_sin;
    const real phi_minus_p_x_rate = delta_u * delta_sin * phi_position_x;
    const real phi_p_y_rate = delta_u * delta_cos * phi_position_x;

    /* omega: p */
    /* p = p_fixed + R_fixed p_joint(q) */
    const real epsilon_u = u[5]; /* rad/s */
    const wreal omega_position_y = w[12]; /* m */
    const real omega_minus_p_x = omega_position_y * epsilon_sin;
    const real omega_p_y = omega_position_y * epsilon_cos;
    const real omega_minus_p_x_rate = epsilon_u * epsilon_cos * omega_position_y;
    const real omega_minus_p_y_rate = epsilon_u * epsilon_sin * omega_position_y;

    /* shared by several: position, inertia */
    /* position = position_parent + orientation_parent p */
    const wreal K2_first_moment_x = w[1];
    const wreal delta_position_x = w[5]; /* m */
    const wreal delta_position_y = w[6]; /* m */
    const wreal K4_first_moment_y = w[8];
    const wreal epsilon_position_x = w[10]; /* m */
    const wreal epsilon_position_y = w[11]; /* m */
    const wreal K6_first_moment_x = w[13];
    const real K4_position_x = delta_position_x + phi_p_x;
    const real K4_position_y = delta_position_y + phi_p_y;
    const real K6_position_x = epsilon_position_x - omega_minus_p_x;
    const real K6_position_y = epsilon_position_y + omega_p_y;
    const real K7_inertia_shift_part = K6_first_moment_x * omega_turn_sin * omega_p_y
        - K6_first_moment_x * omega_turn_cos * omega_minus_p_x;
    const real K5_inertia_shift_part = K4_first_moment_y * phi_turn_cos * phi_p_y
        - K4_first_moment_y * phi_turn_sin * phi_p_x;
    const real K1_inertia_shift_part = K2_first_moment_x * theta_turn_cos * theta_p_x
        + K2_first_moment_x * theta_turn_sin * theta_p_y;

    /* spring: spring damper */
    /* force = stiffness (distance - rest_length) + damping d(distance)/dt */
    const wreal gamma_position_x = w[3]; /* m */
    const wreal gamma_position_y = w[4]; /* m */
    const wreal spring_stiffness = w[18]; /* N/m */
    const wreal spring_rest_length = w[19]; /* m */
    const wreal spring_a_position_x = w[20]; /* m */
    const wreal spring_a_position_y = w[21]; /* m */
    const wreal spring_b_position_x = w[22]; /* m */
    const wreal spring_b_position_y = w[23]; /* m */
    const real spring_spring_damper_span_x = spring_b_position_x * gamma_cos
        - spring_b_position_y * gamma_sin + gamma_position_x - spring_a_position_x;
    const real spring_spring_damper_span_y = spring_b_position_x * gamma_sin
        + spring_b_position_y * gamma_cos + gamma_position_y - spring_a_position_y;
    const real spring_spring_damper_distance = cardan_sqrt(spring_spring_damper_span_x *
        spring_spring_damper_span_x + spring_spring_damper_span_y * spring_spring_damper_span_y);
    const real spring_spring_damper_apart = cardan_lt(0.0, spring_spring_damper_distance);
    const real spring_spring_damper_inverse_distance = cardan_select(spring_spring_damper_apart,
        1.0, 0.0) / cardan_select(spring_spring_damper_apart, spring_spring_damper_distance, 1.0);
    const real spring_force_on_spring_a_x_part = spring_stiffness * (spring_spring_damper_distance -
        spring_rest_length);
    const real spring_force_on_spring_a_x = spring_spring_damper_span_x *
        spring_spring_damper_inverse_distance * spring_force_on_spring_a_x_part;
    const real spring_force_on_spring_a_y = spring_spring_damper_span_y *
        spring_spring_damper_inverse_distance * spring_force_on_spring_a_x_part;

    /* E3: pose, twist, G */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* G = d(rate) / du */
    const real theta_u = u[1]; /* rad/s */
    const real gamma_u = u[2]; /* rad/s */
    const wreal E3_child_position_y = w[15]; /* m */
    const real E3_child_p_x = gamma_position_x - E3_child_position_y * gamma_sin;
    const real E3_child_p_y = gamma_position_y + E3_child_position_y * gamma_cos;
    const real E3_R_xx = theta_turn_cos * gamma_cos + theta_turn_sin * gamma_sin;
    const real E3_R_xy = theta_turn_sin * gamma_cos - theta_turn_cos * gamma_sin;
    const real E3_arm_theta_x = E3_child_p_x - theta_p_x;
    const real E3_arm_theta_y = E3_child_p_y - theta_p_y;
    const real E3_arm_gamma_x = E3_child_p_x - gamma_position_x;
    const real E3_arm_gamma_y = E3_child_p_y - gamma_position_y;
    const real E3_base_twist_vx = beta_u * E3_child_p_y + theta_u * E3_arm_theta_y
        - gamma_u * E3_arm_gamma_y;
    const real E3_base_twist_vy = gamma_u * E3_arm_gamma_x - (beta_u * E3_child_p_x
        + theta_u * E3_arm_theta_x);
    const real E3_twist_beta_vx = gamma_cos * E3_child_p_y - gamma_sin * E3_child_p_x;
    const real E3_minus_twist_beta_vy = gamma_sin * E3_child_p_y + gamma_cos * E3_child_p_x;
    const real E3_twist_theta_vx = gamma_cos * E3_arm_theta_y - gamma_sin * E3_arm_theta_x;
    const real E3_minus_twist_theta_vy = gamma_sin * E3_arm_theta_y + gamma_cos * E3_arm_theta_x;
    const real E3_twist_gamma_vx = gamma_sin * E3_arm_gamma_x - gamma_cos * E3_arm_gamma_y;
    const real E3_twist_gamma_vy = gamma_sin * E3_arm_gamma_y + gamma_cos * E3_arm_gamma_x;
    const real E3_twist_vx = gamma_cos * E3_base_twist_vx + gamma_sin * E3_base_twist_vy;
    const real E3_twist_vy = gamma_cos * E3_base_twist_vy - gamma_sin * E3_base_twist_vx;
    const real E3_G_px_beta = E3_R_xx * E3_twist_beta_vx - E3_R_xy * E3_minus_twist_beta_vy;
    const real E3_G_px_theta = E3_R_xx * E3_twist_theta_vx - E3_R_xy * E3_minus_twist_theta_vy;
    const real E3_G_px_gamma = E3_R_xx * E3_twist_gamma_vx + E3_R_xy * E3_twist_gamma_vy;
    const real E3_minus_G_py_beta = E3_R_xy * E3_twist_beta_vx + E3_R_xx * E3_minus_twist_beta_vy;
    const real E3_minus_G_py_theta = E3_R_xy * E3_twist_theta_vx
        + E3_R_xx * E3_minus_twist_theta_vy;
    const real E3_G_py_gamma = E3_R_xx * E3_twist_gamma_vy - E3_R_xy * E3_twist_gamma_vx;

    /* K2: omega, inertia force */
    /* omega = Rᵀ omega_parent + S_w u */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const real K2_omega_z = beta_u + theta_u;
    const real K2_minus_f_x = K2_omega_z * K2_omega_z * K2_first_moment_x;

    /* E4: pose, twist, G */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* G = d(rate) / du */
    const real phi_u = u[4]; /* rad/s */
    const wreal E4_child_position_y = w[16]; /* m */
    const real E4_child_p_x = K4_position_x - E4_child_position_y * phi_turn_sin;
    const real E4_child_p_y = K4_position_y + E4_child_position_y * phi_turn_cos;
    const real E4_R_xx = theta_turn_cos * phi_turn_cos + theta_turn_sin * phi_turn_sin;
    const real E4_R_xy = theta_turn_sin * phi_turn_cos - theta_turn_cos * phi_turn_sin;
    const real E4_arm_theta_x = E4_child_p_x - theta_p_x;
    const real E4_arm_theta_y = E4_child_p_y - theta_p_y;
    const real E4_arm_delta_x = E4_child_p_x - delta_position_x;
    const real E4_arm_delta_y = E4_child_p_y - delta_position_y;
    const real E4_arm_phi_x = E4_child_p_x - K4_position_x;
    const real E4_arm_phi_y = E4_child_p_y - K4_position_y;
    const real E4_base_twist_vx = beta_u * E4_child_p_y + theta_u * E4_arm_theta_y
        - delta_u * E4_arm_delta_y - phi_u * E4_arm_phi_y;
    const real E4_base_twist_vy = delta_u * E4_arm_delta_x - (beta_u * E4_child_p_x
        + theta_u * E4_arm_theta_x) + phi_u * E4_arm_phi_x;
    const real E4_twist_beta_vx = phi_turn_cos * E4_child_p_y - phi_turn_sin * E4_child_p_x;
    const real E4_minus_twist_beta_vy = phi_turn_sin * E4_child_p_y + phi_turn_cos * E4_child_p_x;
    const real E4_twist_theta_vx = phi_turn_cos * E4_arm_theta_y - phi_turn_sin * E4_arm_theta_x;
    const real E4_minus_twist_theta_vy = phi_turn_sin * E4_arm_theta_y
        + phi_turn_cos * E4_arm_theta_x;
    const real E4_twist_delta_vx = phi_turn_sin * E4_arm_delta_x - phi_turn_cos * E4_arm_delta_y;
    const real E4_twist_delta_vy = phi_turn_sin * E4_arm_delta_y + phi_turn_cos * E4_arm_delta_x;
    const real E4_twist_phi_vx = phi_turn_sin * E4_arm_phi_x - phi_turn_cos * E4_arm_phi_y;
    const real E4_twist_phi_vy = phi_turn_sin * E4_arm_phi_y + phi_turn_cos * E4_arm_phi_x;
    const real E4_twist_vx = phi_turn_cos * E4_base_twist_vx + phi_turn_sin * E4_base_twist_vy;
    const real E4_twist_vy = phi_turn_cos * E4_base_twist_vy - phi_turn_sin * E4_base_twist_vx;
    const real E4_G_px_beta = E4_R_xx * E4_twist_beta_vx - E4_R_xy * E4_minus_twist_beta_vy;
    const real E4_G_px_theta = E4_R_xx * E4_twist_theta_vx - E4_R_xy * E4_minus_twist_theta_vy;
    const real E4_G_px_delta = E4_R_xx * E4_twist_delta_vx + E4_R_xy * E4_twist_delta_vy;
    const real E4_G_px_phi = E4_R_xx * E4_twist_phi_vx + E4_R_xy * E4_twist_phi_vy;
    const real E4_minus_G_py_beta = E4_R_xy * E4_twist_beta_vx + E4_R_xx * E4_minus_twist_beta_vy;
    const real E4_minus_G_py_theta = E4_R_xy * E4_twist_theta_vx
        + E4_R_xx * E4_minus_twist_theta_vy;
    const real E4_G_py_delta = E4_R_xx * E4_twist_delta_vy - E4_R_xy * E4_twist_delta_vx;
    const real E4_G_py_phi = E4_R_xx * E4_twist_phi_vy - E4_R_xy * E4_twist_phi_vx;

    /* E6: pose, twist, G */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* G = d(rate) / du */
    const real omega_u = u[6]; /* rad/s */
    const wreal E6_child_position_x = w[17]; /* m */
    const real E6_child_p_x = K6_position_x + E6_child_position_x * omega_turn_cos;
    const real E6_child_p_y = K6_position_y + E6_child_position_x * omega_turn_sin;
    const real E6_R_xx = theta_turn_cos * omega_turn_cos + theta_turn_sin * omega_turn_sin;
    const real E6_R_xy = theta_turn_sin * omega_turn_cos - theta_turn_cos * omega_turn_sin;
    const real E6_arm_theta_x = E6_child_p_x - theta_p_x;
    const real E6_arm_theta_y = E6_child_p_y - theta_p_y;
    const real E6_arm_epsilon_x = E6_child_p_x - epsilon_position_x;
    const real E6_arm_epsilon_y = E6_child_p_y - epsilon_position_y;
    const real E6_arm_omega_x = E6_child_p_x - K6_position_x;
    const real E6_arm_omega_y = E6_child_p_y - K6_position_y;
    const real E6_base_twist_vx = beta_u * E6_child_p_y + theta_u * E6_arm_theta_y
        - epsilon_u * E6_arm_epsilon_y - omega_u * E6_arm_omega_y;
    const real E6_base_twist_vy = epsilon_u * E6_arm_epsilon_x - (beta_u * E6_child_p_x
        + theta_u * E6_arm_theta_x) + omega_u * E6_arm_omega_x;
    const real E6_twist_beta_vx = omega_turn_cos * E6_child_p_y - omega_turn_sin * E6_child_p_x;
    const real E6_minus_twist_beta_vy = omega_turn_sin * E6_child_p_y
        + omega_turn_cos * E6_child_p_x;
    const real E6_twist_theta_vx = omega_turn_cos * E6_arm_theta_y
        - omega_turn_sin * E6_arm_theta_x;
    const real E6_minus_twist_theta_vy = omega_turn_sin * E6_arm_theta_y
        + omega_turn_cos * E6_arm_theta_x;
    const real E6_twist_epsilon_vx = omega_turn_sin * E6_arm_epsilon_x
        - omega_turn_cos * E6_arm_epsilon_y;
    const real E6_twist_epsilon_vy = omega_turn_sin * E6_arm_epsilon_y
        + omega_turn_cos * E6_arm_epsilon_x;
    const real E6_twist_omega_vx = omega_turn_sin * E6_arm_omega_x
        - omega_turn_cos * E6_arm_omega_y;
    const real E6_twist_omega_vy = omega_turn_sin * E6_arm_omega_y
        + omega_turn_cos * E6_arm_omega_x;
    const real E6_twist_vx = omega_turn_cos * E6_base_twist_vx + omega_turn_sin * E6_base_twist_vy;
    const real E6_twist_vy = omega_turn_cos * E6_base_twist_vy - omega_turn_sin * E6_base_twist_vx;
    const real E6_G_px_beta = E6_R_xx * E6_twist_beta_vx - E6_R_xy * E6_minus_twist_beta_vy;
    const real E6_G_px_theta = E6_R_xx * E6_twist_theta_vx - E6_R_xy * E6_minus_twist_theta_vy;
    const real E6_G_px_epsilon = E6_R_xx * E6_twist_epsilon_vx + E6_R_xy * E6_twist_epsilon_vy;
    const real E6_G_px_omega = E6_R_xx * E6_twist_omega_vx + E6_R_xy * E6_twist_omega_vy;
    const real E6_minus_G_py_beta = E6_R_xy * E6_twist_beta_vx + E6_R_xx * E6_minus_twist_beta_vy;
    const real E6_minus_G_py_theta = E6_R_xy * E6_twist_theta_vx
        + E6_R_xx * E6_minus_twist_theta_vy;
    const real E6_G_py_epsilon = E6_R_xx * E6_twist_epsilon_vy - E6_R_xy * E6_twist_epsilon_vx;
    const real E6_G_py_omega = E6_R_xx * E6_twist_omega_vy - E6_R_xy * E6_twist_omega_vx;

    /* K7: composite, U */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* U = [alpha] + [omega][omega] */
    const wreal K6_origin_inertia_zz = w[14];
    const wreal K7_base_inertia_zz = w[25];
    const real K7_composite_inertia_zz = K6_origin_inertia_zz + 2.0 * K7_inertia_shift_part
        + K7_base_inertia_zz;
    const real K7_minus_U_xx = epsilon_u * epsilon_u;

    /* K5: composite, U */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* U = [alpha] + [omega][omega] */
    const wreal K4_origin_inertia_zz = w[9];
    const wreal K5_base_inertia_zz = w[26];
    const real K5_composite_inertia_zz = K4_origin_inertia_zz + 2.0 * K5_inertia_shift_part
        + K5_base_inertia_zz;
    const real K5_minus_U_xx = delta_u * delta_u;

    /* K1: composite, U */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* U = [alpha] + [omega][omega] */
    const wreal K2_origin_inertia_zz = w[2];
    const wreal K1_base_inertia_zz = w[27];
    const real K1_composite_inertia_zz = K2_origin_inertia_zz + 2.0 * K1_inertia_shift_part
        + K1_base_inertia_zz;
    const real K1_minus_U_xx = beta_u * beta_u;

    /* M */
    /* M = S . momentum */
    const real M_omega_epsilon = K6_origin_inertia_zz + K7_inertia_shift_part;
    const real M_phi_delta = K4_origin_inertia_zz + K5_inertia_shift_part;
    const real M_theta_beta = K2_origin_inertia_zz + K1_inertia_shift_part;

    /* K4: omega, n, inertia force */
    /* omega = Rᵀ omega_parent + S_w u */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const real K4_omega_z = delta_u + phi_u;
    const real K4_n_z = K4_first_moment_y * (phi_p_x * K5_minus_U_xx * phi_turn_cos
        + phi_p_y * K5_minus_U_xx * phi_turn_sin);
    const real K4_minus_f_y = K4_omega_z * K4_omega_z * K4_first_moment_y;

    /* K6: omega, inertia force */
    /* omega = Rᵀ omega_parent + S_w u */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const real K6_omega_z = epsilon_u + omega_u;
    const real K6_minus_n_z = K6_first_moment_x * (omega_minus_p_x * K7_minus_U_xx * omega_turn_sin
        + omega_p_y * K7_minus_U_xx * omega_turn_cos);
    const real K6_minus_f_x = K6_omega_z * K6_omega_z * K6_first_moment_x;

    /* K2: a, n */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real K2_a_y = theta_p_x * K1_minus_U_xx * theta_turn_sin
        - theta_p_y * K1_minus_U_xx * theta_turn_cos;
    const real K2_n_z = K2_first_moment_x * K2_a_y;

    /* K7: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real K7_n_z = omega_turn_sin * K6_minus_f_x * omega_minus_p_x
        + omega_turn_cos * K6_minus_f_x * omega_p_y - K6_minus_n_z;

    /* K5: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real K5_n_z = K4_n_z - (phi_turn_cos * K4_minus_f_y * phi_p_x
        + phi_turn_sin * K4_minus_f_y * phi_p_y);

    /* K1: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real K1_n_z = theta_turn_cos * K2_minus_f_x * theta_p_y
        - theta_turn_sin * K2_minus_f_x * theta_p_x + K2_n_z;

    /* beta: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real beta_u_tau = tau[0]; /* N*m */
    const wreal drive_force = w[24];
    const real beta_tau = K1_n_z - drive_force;
    const real beta_drive = beta_u_tau - beta_tau;

    /* theta: drive, R */
    /* drive = tau + f - h */
    /* R = R_fixed R_joint(q) */
    const real theta_u_tau = tau[1]; /* N*m */
    const real theta_drive = theta_u_tau - K2_n_z;
    const real theta_turn_sin_times_K2_omega_z = theta_turn_sin * K2_omega_z;
    const real theta_turn_cos_times_K2_omega_z = theta_turn_cos * K2_omega_z;

    /* gamma: drive, R */
    /* drive = tau + f - h */
    /* R = R_fixed R_joint(q) */
    const real gamma_u_tau = tau[2]; /* N*m */
    const real gamma_drive = spring_b_position_x * (gamma_sin * spring_force_on_spring_a_x
        - gamma_cos * spring_force_on_spring_a_y)
        + spring_b_position_y * (gamma_cos * spring_force_on_spring_a_x
        + gamma_sin * spring_force_on_spring_a_y) + gamma_u_tau;
    const real gamma_u_times_sin = gamma_u * gamma_sin;
    const real gamma_u_times_cos = gamma_u * gamma_cos;

    /* delta: drive */
    /* drive = tau + f - h */
    const real delta_u_tau = tau[3]; /* N*m */
    const real delta_drive = delta_u_tau - K5_n_z;

    /* phi: drive, R */
    /* drive = tau + f - h */
    /* R = R_fixed R_joint(q) */
    const real phi_u_tau = tau[4]; /* N*m */
    const real phi_drive = phi_u_tau - K4_n_z;
    const real phi_turn_sin_times_K4_omega_z = phi_turn_sin * K4_omega_z;
    const real phi_turn_cos_times_K4_omega_z = phi_turn_cos * K4_omega_z;

    /* epsilon: drive */
    /* drive = tau + f - h */
    const real epsilon_u_tau = tau[5]; /* N*m */
    const real epsilon_drive = epsilon_u_tau - K7_n_z;

    /* omega: drive, R */
    /* drive = tau + f - h */
    /* R = R_fixed R_joint(q) */
    const real omega_u_tau = tau[6]; /* N*m */
    const real omega_drive = omega_u_tau + K6_minus_n_z;
    const real omega_turn_sin_times_K6_omega_z = omega_turn_sin * K6_omega_z;
    const real omega_turn_cos_times_K6_omega_z = omega_turn_cos * K6_omega_z;

    /* E3: pose, twist, gamma */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* gamma = -d(rate)/dt at udot = 0 */
    const real E3_minus_child_p_x_rate = E3_child_position_y * gamma_u_times_cos;
    const real E3_minus_child_p_y_rate = E3_child_position_y * gamma_u_times_sin;
    const real E3_R_xx_rate = gamma_sin * theta_turn_cos_times_K2_omega_z
        + theta_turn_sin * gamma_u_times_cos - (gamma_cos * theta_turn_sin_times_K2_omega_z
        + theta_turn_cos * gamma_u_times_sin);
    const real E3_R_xy_rate = gamma_cos * theta_turn_cos_times_K2_omega_z
        - theta_turn_sin * gamma_u_times_sin - (theta_turn_cos * gamma_u_times_cos
        - gamma_sin * theta_turn_sin_times_K2_omega_z);
    const real E3_base_twist_vx_rate = gamma_u * E3_minus_child_p_y_rate
        - (beta_u * E3_minus_child_p_y_rate + theta_u * (theta_p_y_rate + E3_minus_child_p_y_rate));
    const real E3_minus_base_twist_vy_rate = theta_u * (theta_minus_p_x_rate
        - E3_minus_child_p_x_rate) - beta_u * E3_minus_child_p_x_rate
        + gamma_u * E3_minus_child_p_x_rate;
    const real E3_twist_vx_rate = gamma_cos * E3_base_twist_vx_rate
        - E3_base_twist_vx * gamma_u_times_sin + (E3_base_twist_vy * gamma_u_times_cos
        - gamma_sin * E3_minus_base_twist_vy_rate);
    const real E3_minus_twist_vy_rate = E3_base_twist_vx * gamma_u_times_cos
        + gamma_sin * E3_base_twist_vx_rate + (E3_base_twist_vy * gamma_u_times_sin
        + gamma_cos * E3_minus_base_twist_vy_rate);
    const real E3_gamma_px = E3_R_xy * E3_minus_twist_vy_rate - E3_twist_vy * E3_R_xy_rate
        - (E3_twist_vx * E3_R_xx_rate + E3_R_xx * E3_twist_vx_rate);
    const real E3_gamma_py = E3_twist_vx * E3_R_xy_rate + E3_R_xy * E3_twist_vx_rate
        - (E3_twist_vy * E3_R_xx_rate - E3_R_xx * E3_minus_twist_vy_rate);

    /* E4: pose, twist, gamma */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* gamma = -d(rate)/dt at udot = 0 */
    const real E4_minus_child_p_x_rate = phi_minus_p_x_rate
        + E4_child_position_y * phi_turn_cos_times_K4_omega_z;
    const real E4_child_p_y_rate = phi_p_y_rate
        - E4_child_position_y * phi_turn_sin_times_K4_omega_z;
    const real E4_R_xx_rate = phi_turn_sin * theta_turn_cos_times_K2_omega_z
        + theta_turn_sin * phi_turn_cos_times_K4_omega_z
        - (phi_turn_cos * theta_turn_sin_times_K2_omega_z
        + theta_turn_cos * phi_turn_sin_times_K4_omega_z);
    const real E4_R_xy_rate = phi_turn_cos * theta_turn_cos_times_K2_omega_z
        - theta_turn_sin * phi_turn_sin_times_K4_omega_z
        - (theta_turn_cos * phi_turn_cos_times_K4_omega_z
        - phi_turn_sin * theta_turn_sin_times_K2_omega_z);
    const real E4_base_twist_vx_rate = beta_u * E4_child_p_y_rate + theta_u * (E4_child_p_y_rate
        - theta_p_y_rate) - delta_u * E4_child_p_y_rate - phi_u * (E4_child_p_y_rate
        - phi_p_y_rate);
    const real E4_base_twist_vy_rate = phi_u * (phi_minus_p_x_rate - E4_minus_child_p_x_rate)
        - (theta_u * (theta_minus_p_x_rate - E4_minus_child_p_x_rate)
        - beta_u * E4_minus_child_p_x_rate + delta_u * E4_minus_child_p_x_rate);
    const real E4_twist_vx_rate = phi_turn_cos * E4_base_twist_vx_rate
        - E4_base_twist_vx * phi_turn_sin_times_K4_omega_z
        + (E4_base_twist_vy * phi_turn_cos_times_K4_omega_z + phi_turn_sin * E4_base_twist_vy_rate);
    const real E4_twist_vy_rate = phi_turn_cos * E4_base_twist_vy_rate
        - E4_base_twist_vy * phi_turn_sin_times_K4_omega_z
        - (E4_base_twist_vx * phi_turn_cos_times_K4_omega_z + phi_turn_sin * E4_base_twist_vx_rate);
    const real E4_gamma_py = E4_twist_vx * E4_R_xy_rate + E4_R_xy * E4_twist_vx_rate
        - (E4_twist_vy * E4_R_xx_rate + E4_R_xx * E4_twist_vy_rate);

    /* E6: pose, twist, gamma */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* gamma = -d(rate)/dt at udot = 0 */
    const real E6_minus_child_p_x_rate = omega_minus_p_x_rate
        + E6_child_position_x * omega_turn_sin_times_K6_omega_z;
    const real E6_child_p_y_rate = E6_child_position_x * omega_turn_cos_times_K6_omega_z
        - omega_minus_p_y_rate;
    const real E6_R_xx_rate = omega_turn_sin * theta_turn_cos_times_K2_omega_z
        + theta_turn_sin * omega_turn_cos_times_K6_omega_z
        - (omega_turn_cos * theta_turn_sin_times_K2_omega_z
        + theta_turn_cos * omega_turn_sin_times_K6_omega_z);
    const real E6_R_xy_rate = omega_turn_cos * theta_turn_cos_times_K2_omega_z
        - theta_turn_sin * omega_turn_sin_times_K6_omega_z
        - (theta_turn_cos * omega_turn_cos_times_K6_omega_z
        - omega_turn_sin * theta_turn_sin_times_K2_omega_z);
    const real E6_base_twist_vx_rate = beta_u * E6_child_p_y_rate + theta_u * (E6_child_p_y_rate
        - theta_p_y_rate) - epsilon_u * E6_child_p_y_rate - omega_u * (omega_minus_p_y_rate
        + E6_child_p_y_rate);
    const real E6_base_twist_vy_rate = omega_u * (omega_minus_p_x_rate - E6_minus_child_p_x_rate)
        - (theta_u * (theta_minus_p_x_rate - E6_minus_child_p_x_rate)
        - beta_u * E6_minus_child_p_x_rate + epsilon_u * E6_minus_child_p_x_rate);
    const real E6_twist_vx_rate = omega_turn_cos * E6_base_twist_vx_rate
        - E6_base_twist_vx * omega_turn_sin_times_K6_omega_z
        + (E6_base_twist_vy * omega_turn_cos_times_K6_omega_z
        + omega_turn_sin * E6_base_twist_vy_rate);
    const real E6_twist_vy_rate = omega_turn_cos * E6_base_twist_vy_rate
        - E6_base_twist_vy * omega_turn_sin_times_K6_omega_z
        - (E6_base_twist_vx * omega_turn_cos_times_K6_omega_z
        + omega_turn_sin * E6_base_twist_vx_rate);
    const real E6_gamma_py = E6_twist_vx * E6_R_xy_rate + E6_R_xy * E6_twist_vx_rate
        - (E6_twist_vy * E6_R_xx_rate + E6_R_xx * E6_twist_vy_rate);

    /* constraints: factor, multipliers */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const wreal M_factor_D_inverse_omega = w[28];
    const wreal M_factor_D_inverse_phi = w[29];
    const wreal M_factor_D_inverse_gamma = w[30];
    const wreal M_factor_D_inverse_theta = w[31];
    const real M_factor_L_omega_epsilon = M_omega_epsilon * M_factor_D_inverse_omega;
    const real M_factor_D_inverse_epsilon = 1.0 / (K7_composite_inertia_zz
        - M_omega_epsilon * M_factor_L_omega_epsilon);
    const real M_factor_L_phi_delta = M_phi_delta * M_factor_D_inverse_phi;
    const real M_factor_D_inverse_delta = 1.0 / (K5_composite_inertia_zz
        - M_phi_delta * M_factor_L_phi_delta);
    const real M_factor_L_theta_beta = M_theta_beta * M_factor_D_inverse_theta;
    const real M_factor_D_inverse_beta = 1.0 / (K1_composite_inertia_zz
        - M_theta_beta * M_factor_L_theta_beta);
    const real free_udot_beta = M_factor_D_inverse_beta * (beta_drive
        - theta_drive * M_factor_L_theta_beta);
    const real free_udot_gamma = gamma_drive * M_factor_D_inverse_gamma;
    const real free_udot_delta = M_factor_D_inverse_delta * (delta_drive
        - phi_drive * M_factor_L_phi_delta);
    const real free_udot_epsilon = M_factor_D_inverse_epsilon * (epsilon_drive
        - omega_drive * M_factor_L_omega_epsilon);
    const real free_udot_theta = theta_drive * M_factor_D_inverse_theta
        - M_factor_L_theta_beta * free_udot_beta;
    const real free_udot_phi = phi_drive * M_factor_D_inverse_phi
        - M_factor_L_phi_delta * free_udot_delta;
    const real free_udot_omega = omega_drive * M_factor_D_inverse_omega
        - M_factor_L_omega_epsilon * free_udot_epsilon;
    const real E3_px_response_beta = M_factor_D_inverse_beta * (E3_G_px_beta
        - E3_G_px_theta * M_factor_L_theta_beta);
    const real E3_px_response_gamma = E3_G_px_gamma * M_factor_D_inverse_gamma;
    const real E3_px_response_theta = E3_G_px_theta * M_factor_D_inverse_theta
        - M_factor_L_theta_beta * E3_px_response_beta;
    const real E3_py_response_beta = M_factor_D_inverse_beta * (E3_minus_G_py_theta *
        M_factor_L_theta_beta - E3_minus_G_py_beta);
    const real E3_py_response_gamma = E3_G_py_gamma * M_factor_D_inverse_gamma;
    const real E3_py_minus_response_theta = E3_minus_G_py_theta * M_factor_D_inverse_theta
        + M_factor_L_theta_beta * E3_py_response_beta;
    const real E4_px_response_beta = M_factor_D_inverse_beta * (E4_G_px_beta
        - E4_G_px_theta * M_factor_L_theta_beta);
    const real E4_px_response_delta = M_factor_D_inverse_delta * (E4_G_px_delta
        - E4_G_px_phi * M_factor_L_phi_delta);
    const real E4_px_response_theta = E4_G_px_theta * M_factor_D_inverse_theta
        - M_factor_L_theta_beta * E4_px_response_beta;
    const real E4_px_response_phi = E4_G_px_phi * M_factor_D_inverse_phi
        - M_factor_L_phi_delta * E4_px_response_delta;
    const real E4_py_response_beta = M_factor_D_inverse_beta * (E4_minus_G_py_theta *
        M_factor_L_theta_beta - E4_minus_G_py_beta);
    const real E4_py_response_delta = M_factor_D_inverse_delta * (E4_G_py_delta
        - E4_G_py_phi * M_factor_L_phi_delta);
    const real E4_py_minus_response_theta = E4_minus_G_py_theta * M_factor_D_inverse_theta
        + M_factor_L_theta_beta * E4_py_response_beta;
    const real E4_py_response_phi = E4_G_py_phi * M_factor_D_inverse_phi
        - M_factor_L_phi_delta * E4_py_response_delta;
    const real E6_px_response_beta = M_factor_D_inverse_beta * (E6_G_px_beta
        - E6_G_px_theta * M_factor_L_theta_beta);
    const real E6_px_response_epsilon = M_factor_D_inverse_epsilon * (E6_G_px_epsilon
        - E6_G_px_omega * M_factor_L_omega_epsilon);
    const real E6_px_response_theta = E6_G_px_theta * M_factor_D_inverse_theta
        - M_factor_L_theta_beta * E6_px_response_beta;
    const real E6_px_response_omega = E6_G_px_omega * M_factor_D_inverse_omega
        - M_factor_L_omega_epsilon * E6_px_response_epsilon;
    const real E6_py_response_beta = M_factor_D_inverse_beta * (E6_minus_G_py_theta *
        M_factor_L_theta_beta - E6_minus_G_py_beta);
    const real E6_py_response_epsilon = M_factor_D_inverse_epsilon * (E6_G_py_epsilon
        - E6_G_py_omega * M_factor_L_omega_epsilon);
    const real E6_py_minus_response_theta = E6_minus_G_py_theta * M_factor_D_inverse_theta
        + M_factor_L_theta_beta * E6_py_response_beta;
    const real E6_py_response_omega = E6_G_py_omega * M_factor_D_inverse_omega
        - M_factor_L_omega_epsilon * E6_py_response_epsilon;
    const real circuit_E3_px_E3_px = E3_G_px_beta * E3_px_response_beta
        + E3_G_px_theta * E3_px_response_theta + E3_G_px_gamma * E3_px_response_gamma;
    circuit_matrix[0][0] = circuit_E3_px_E3_px;
    const real circuit_E3_py_E3_px = E3_G_py_gamma * E3_px_response_gamma
        - (E3_minus_G_py_beta * E3_px_response_beta + E3_minus_G_py_theta * E3_px_response_theta);
    circuit_matrix[0][1] = circuit_E3_py_E3_px;
    circuit_matrix[1][0] = circuit_E3_py_E3_px;
    const real circuit_E3_py_E3_py = E3_G_py_gamma * E3_py_response_gamma
        - (E3_minus_G_py_beta * E3_py_response_beta
        - E3_minus_G_py_theta * E3_py_minus_response_theta);
    circuit_matrix[1][1] = circuit_E3_py_E3_py;
    const real circuit_E4_px_E3_px = E4_G_px_beta * E3_px_response_beta
        + E4_G_px_theta * E3_px_response_theta;
    circuit_matrix[0][2] = circuit_E4_px_E3_px;
    circuit_matrix[2][0] = circuit_E4_px_E3_px;
    const real circuit_E4_px_E3_py = E4_G_px_beta * E3_py_response_beta
        - E4_G_px_theta * E3_py_minus_response_theta;
    circuit_matrix[1][2] = circuit_E4_px_E3_py;
    circuit_matrix[2][1] = circuit_E4_px_E3_py;
    const real circuit_E4_px_E4_px = E4_G_px_beta * E4_px_response_beta
        + E4_G_px_theta * E4_px_response_theta + E4_G_px_delta * E4_px_response_delta
        + E4_G_px_phi * E4_px_response_phi;
    circuit_matrix[2][2] = circuit_E4_px_E4_px;
    const real circuit_E4_py_E3_px = -(E4_minus_G_py_beta * E3_px_response_beta
        + E4_minus_G_py_theta * E3_px_response_theta);
    circuit_matrix[0][3] = circuit_E4_py_E3_px;
    circuit_matrix[3][0] = circuit_E4_py_E3_px;
    const real circuit_E4_py_E3_py = -(E4_minus_G_py_beta * E3_py_response_beta
        - E4_minus_G_py_theta * E3_py_minus_response_theta);
    circuit_matrix[1][3] = circuit_E4_py_E3_py;
    circuit_matrix[3][1] = circuit_E4_py_E3_py;
    const real circuit_E4_py_E4_px = E4_G_py_delta * E4_px_response_delta
        - (E4_minus_G_py_beta * E4_px_response_beta + E4_minus_G_py_theta * E4_px_response_theta)
        + E4_G_py_phi * E4_px_response_phi;
    circuit_matrix[2][3] = circuit_E4_py_E4_px;
    circuit_matrix[3][2] = circuit_E4_py_E4_px;
    const real circuit_E4_py_E4_py = E4_G_py_delta * E4_py_response_delta
        - (E4_minus_G_py_beta * E4_py_response_beta
        - E4_minus_G_py_theta * E4_py_minus_response_theta) + E4_G_py_phi * E4_py_response_phi;
    circuit_matrix[3][3] = circuit_E4_py_E4_py;
    const real circuit_E6_px_E3_px = E6_G_px_beta * E3_px_response_beta
        + E6_G_px_theta * E3_px_response_theta;
    circuit_matrix[0][4] = circuit_E6_px_E3_px;
    circuit_matrix[4][0] = circuit_E6_px_E3_px;
    const real circuit_E6_px_E3_py = E6_G_px_beta * E3_py_response_beta
        - E6_G_px_theta * E3_py_minus_response_theta;
    circuit_matrix[1][4] = circuit_E6_px_E3_py;
    circuit_matrix[4][1] = circuit_E6_px_E3_py;
    const real circuit_E6_px_E4_px = E6_G_px_beta * E4_px_response_beta
        + E6_G_px_theta * E4_px_response_theta;
    circuit_matrix[2][4] = circuit_E6_px_E4_px;
    circuit_matrix[4][2] = circuit_E6_px_E4_px;
    const real circuit_E6_px_E4_py = E6_G_px_beta * E4_py_response_beta
        - E6_G_px_theta * E4_py_minus_response_theta;
    circuit_matrix[3][4] = circuit_E6_px_E4_py;
    circuit_matrix[4][3] = circuit_E6_px_E4_py;
    const real circuit_E6_px_E6_px = E6_G_px_beta * E6_px_response_beta
        + E6_G_px_theta * E6_px_response_theta + E6_G_px_epsilon * E6_px_response_epsilon
        + E6_G_px_omega * E6_px_response_omega;
    circuit_matrix[4][4] = circuit_E6_px_E6_px;
    const real circuit_E6_py_E3_px = -(E6_minus_G_py_beta * E3_px_response_beta
        + E6_minus_G_py_theta * E3_px_response_theta);
    circuit_matrix[0][5] = circuit_E6_py_E3_px;
    circuit_matrix[5][0] = circuit_E6_py_E3_px;
    const real circuit_E6_py_E3_py = -(E6_minus_G_py_beta * E3_py_response_beta
        - E6_minus_G_py_theta * E3_py_minus_response_theta);
    circuit_matrix[1][5] = circuit_E6_py_E3_py;
    circuit_matrix[5][1] = circuit_E6_py_E3_py;
    const real circuit_E6_py_E4_px = -(E6_minus_G_py_beta * E4_px_response_beta
        + E6_minus_G_py_theta * E4_px_response_theta);
    circuit_matrix[2][5] = circuit_E6_py_E4_px;
    circuit_matrix[5][2] = circuit_E6_py_E4_px;
    const real circuit_E6_py_E4_py = -(E6_minus_G_py_beta * E4_py_response_beta
        - E6_minus_G_py_theta * E4_py_minus_response_theta);
    circuit_matrix[3][5] = circuit_E6_py_E4_py;
    circuit_matrix[5][3] = circuit_E6_py_E4_py;
    const real circuit_E6_py_E6_px = E6_G_py_epsilon * E6_px_response_epsilon
        - (E6_minus_G_py_beta * E6_px_response_beta + E6_minus_G_py_theta * E6_px_response_theta)
        + E6_G_py_omega * E6_px_response_omega;
    circuit_matrix[4][5] = circuit_E6_py_E6_px;
    circuit_matrix[5][4] = circuit_E6_py_E6_px;
    const real circuit_E6_py_E6_py = E6_G_py_epsilon * E6_py_response_epsilon
        - (E6_minus_G_py_beta * E6_py_response_beta
        - E6_minus_G_py_theta * E6_py_minus_response_theta) + E6_G_py_omega * E6_py_response_omega;
    circuit_matrix[5][5] = circuit_E6_py_E6_py;
    const real free_gamma_minus_E6_px_part = E6_G_px_beta * free_udot_beta
        + E6_G_px_theta * free_udot_theta + E6_G_px_epsilon * free_udot_epsilon
        + E6_G_px_omega * free_udot_omega;
    const real free_gamma_E3_px = E3_gamma_px - (E3_G_px_beta * free_udot_beta
        + E3_G_px_theta * free_udot_theta + E3_G_px_gamma * free_udot_gamma);
    circuit_right[0] = free_gamma_E3_px;
    const real free_gamma_E3_py = E3_gamma_py - (E3_G_py_gamma * free_udot_gamma
        - (E3_minus_G_py_beta * free_udot_beta + E3_minus_G_py_theta * free_udot_theta));
    circuit_right[1] = free_gamma_E3_py;
    const real free_gamma_E4_px = -(E4_twist_vx * E4_R_xx_rate + E4_R_xx * E4_twist_vx_rate
        + (E4_twist_vy * E4_R_xy_rate + E4_R_xy * E4_twist_vy_rate)
        + (E4_G_px_beta * free_udot_beta + E4_G_px_theta * free_udot_theta
        + E4_G_px_delta * free_udot_delta + E4_G_px_phi * free_udot_phi));
    circuit_right[2] = free_gamma_E4_px;
    const real free_gamma_E4_py = E4_gamma_py - (E4_G_py_delta * free_udot_delta
        - (E4_minus_G_py_beta * free_udot_beta + E4_minus_G_py_theta * free_udot_theta)
        + E4_G_py_phi * free_udot_phi);
    circuit_right[3] = free_gamma_E4_py;
    const real free_gamma_E6_px = -(E6_twist_vx * E6_R_xx_rate + E6_R_xx * E6_twist_vx_rate
        + (E6_twist_vy * E6_R_xy_rate + E6_R_xy * E6_twist_vy_rate) + free_gamma_minus_E6_px_part);
    circuit_right[4] = free_gamma_E6_px;
    const real free_gamma_E6_py = E6_gamma_py - (E6_G_py_epsilon * free_udot_epsilon
        - (E6_minus_G_py_beta * free_udot_beta + E6_minus_G_py_theta * free_udot_theta)
        + E6_G_py_omega * free_udot_omega);
    circuit_right[5] = free_gamma_E6_py;
    /* circuit_matrix lam = circuit_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 6, 1, circuit_matrix[0], circuit_right, circuit_scratch);

    /* E3: multiplier px, multiplier py */
    const real E3_multiplier_px = circuit_right[0];
    const real E3_multiplier_py = circuit_right[1];

    /* E4: multiplier px, multiplier py */
    const real E4_multiplier_px = circuit_right[2];
    const real E4_multiplier_py = circuit_right[3];

    /* E6: multiplier px, multiplier py */
    const real E6_multiplier_px = circuit_right[4];
    const real E6_multiplier_py = circuit_right[5];

    /* constraints: multipliers */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const real theta_udot_part = E3_px_response_theta * E3_multiplier_px
        - E3_py_minus_response_theta * E3_multiplier_py + E4_px_response_theta * E4_multiplier_px
        - E4_py_minus_response_theta * E4_multiplier_py + E6_px_response_theta * E6_multiplier_px;

    /* beta: udot */
    /* udot = free_udot + response multipliers */
    /* udot: beta.udot [rad/s^2] */
    out[0] = E3_px_response_beta * E3_multiplier_px + E3_py_response_beta * E3_multiplier_py
        + E4_px_response_beta * E4_multiplier_px + E4_py_response_beta * E4_multiplier_py
        + E6_px_response_beta * E6_multiplier_px + E6_py_response_beta * E6_multiplier_py
        + free_udot_beta;

    /* theta: udot */
    /* udot = free_udot + response multipliers */
    /* udot: theta.udot [rad/s^2] */
    out[1] = theta_udot_part - E6_py_minus_response_theta * E6_multiplier_py + free_udot_theta;

    /* gamma: udot */
    /* udot = free_udot + response multipliers */
    /* udot: gamma.udot [rad/s^2] */
    out[2] = E3_px_response_gamma * E3_multiplier_px + E3_py_response_gamma * E3_multiplier_py
        + free_udot_gamma;

    /* delta: udot */
    /* udot = free_udot + response multipliers */
    /* udot: delta.udot [rad/s^2] */
    out[3] = E4_px_response_delta * E4_multiplier_px + E4_py_response_delta * E4_multiplier_py
        + free_udot_delta;

    /* phi: udot */
    /* udot = free_udot + response multipliers */
    /* udot: phi.udot [rad/s^2] */
    out[4] = E4_px_response_phi * E4_multiplier_px + E4_py_response_phi * E4_multiplier_py
        + free_udot_phi;

    /* epsilon: udot */
    /* udot = free_udot + response multipliers */
    /* udot: epsilon.udot [rad/s^2] */
    out[5] = E6_px_response_epsilon * E6_multiplier_px
        + E6_py_response_epsilon * E6_multiplier_py + free_udot_epsilon;

    /* omega: udot */
    /* udot = free_udot + response multipliers */
    /* udot: omega.udot [rad/s^2] */
    out[6] = E6_px_response_omega * E6_multiplier_px + E6_py_response_omega * E6_multiplier_py
        + free_udot_omega;
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {7, 75, 32, 0, 7, 7, 0, 0, 0, 58, 0, 0, 0, 0, 7, 0, 0, 0, 0, 0};
#endif
