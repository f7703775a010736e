/*
 * inverse_dynamics of andrews
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate
 *
 * Sizes: out 7, work 0, w 20
 * Operations per call: 105 = 60 mul, 21 add, 11 sub, 4 cos, 4 sin, 2 select, 1 div, 1 lt, 1 sqrt
 * Operations of prepare: 93 = 44 add, 33 mul, 16 sub
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
 * Input udot (7): derivatives of the speeds
 *   udot[0]  beta.udot [rad/s^2]
 *   udot[1]  theta.udot [rad/s^2]
 *   udot[2]  gamma.udot [rad/s^2]
 *   udot[3]  delta.udot [rad/s^2]
 *   udot[4]  phi.udot [rad/s^2]
 *   udot[5]  epsilon.udot [rad/s^2]
 *   udot[6]  omega.udot [rad/s^2]
 *
 * Output tau (7)
 *   out[0]  beta.u.tau [N*m]
 *   out[1]  theta.u.tau [N*m]
 *   out[2]  gamma.u.tau [N*m]
 *   out[3]  delta.u.tau [N*m]
 *   out[4]  phi.u.tau [N*m]
 *   out[5]  epsilon.u.tau [N*m]
 *   out[6]  omega.u.tau [N*m]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* K1: first moment, mass, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal K1_mass = p[0]; /* kg */
    const wreal K1_com_x = p[1]; /* m */
    const wreal K1_inertia_xx = p[2]; /* kg m^2 */
    const wreal K1_inertia_yy = p[3]; /* kg m^2 */
    const wreal K1_inertia_zz = p[4]; /* kg m^2 */
    const wreal theta_position_x = p[5]; /* m */
    const wreal K2_mass = p[6]; /* kg */
    const wreal K1_first_moment_x = K1_mass * K1_com_x;
    const wreal K1_com_x_times_first_moment_x = K1_com_x * K1_first_moment_x;
    const wreal K1_origin_inertia_yy = K1_inertia_yy + K1_com_x_times_first_moment_x;
    const wreal K1_origin_inertia_zz = K1_inertia_zz + K1_com_x_times_first_moment_x;
    const wreal K1_base_half_trace = 0.5 * (K1_inertia_xx + K1_origin_inertia_zz
        + K1_origin_inertia_yy);
    const wreal K1_base_second_moment_yy = K1_base_half_trace - K1_origin_inertia_yy;
    const wreal K1_base_second_moment_xx = theta_position_x * K2_mass * theta_position_x
        + K1_base_half_trace - K1_inertia_xx;
    const wreal K1_base_second_moment_yy_plus_base_second_moment_xx = K1_base_second_moment_yy
        + K1_base_second_moment_xx;
    w[13] = K1_base_second_moment_yy_plus_base_second_moment_xx;

    /* K2: first moment, mass, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal K2_com_x = p[7]; /* m */
    const wreal K2_inertia_xx = p[8]; /* kg m^2 */
    const wreal K2_inertia_yy = p[9]; /* kg m^2 */
    const wreal K2_inertia_zz = p[10]; /* kg m^2 */
    const wreal K2_first_moment_x = K2_mass * K2_com_x;
    const wreal K2_com_x_times_first_moment_x = K2_com_x * K2_first_moment_x;
    const wreal K2_origin_inertia_yy = K2_inertia_yy + K2_com_x_times_first_moment_x;
    const wreal K2_origin_inertia_zz = K2_inertia_zz + K2_com_x_times_first_moment_x;
    const wreal K2_base_half_trace = 0.5 * (K2_inertia_xx + K2_origin_inertia_zz
        + K2_origin_inertia_yy);
    const wreal K2_base_second_moment_xx = K2_base_half_trace - K2_inertia_xx;
    const wreal K2_base_second_moment_yy = K2_base_half_trace - K2_origin_inertia_yy;
    const wreal K2_base_second_moment_xx_plus_base_second_moment_yy = K2_base_second_moment_xx
        + K2_base_second_moment_yy;
    w[1] = K2_first_moment_x;
    w[14] = K2_base_second_moment_xx_plus_base_second_moment_yy;

    /* K3: first moment, mass, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal K3_mass = p[13]; /* kg */
    const wreal K3_com_x = p[14]; /* m */
    const wreal K3_com_y = p[15]; /* m */
    const wreal K3_inertia_xx = p[16]; /* kg m^2 */
    const wreal K3_inertia_yy = p[17]; /* kg m^2 */
    const wreal K3_inertia_zz = p[18]; /* kg m^2 */
    const wreal K3_first_moment_x = K3_mass * K3_com_x;
    const wreal K3_first_moment_y = K3_mass * K3_com_y;
    const wreal K3_com_x_times_first_moment_x = K3_com_x * K3_first_moment_x;
    const wreal K3_com_y_times_first_moment_y = K3_com_y * K3_first_moment_y;
    const wreal K3_origin_inertia_xx = K3_inertia_xx + K3_com_y_times_first_moment_y;
    const wreal K3_origin_inertia_yy = K3_inertia_yy + K3_com_x_times_first_moment_x;
    const wreal K3_origin_inertia_zz = K3_inertia_zz + K3_com_x_times_first_moment_x
        + K3_com_y_times_first_moment_y;
    const wreal K3_base_half_trace = 0.5 * (K3_origin_inertia_xx + K3_origin_inertia_zz
        + K3_origin_inertia_yy);
    const wreal K3_base_second_moment_xx = K3_base_half_trace - K3_origin_inertia_xx;
    const wreal K3_base_second_moment_yy = K3_base_half_trace - K3_origin_inertia_yy;
    const wreal K3_base_second_moment_xx_plus_base_second_moment_yy = K3_base_second_moment_xx
        + K3_base_second_moment_yy;
    w[15] = K3_base_second_moment_xx_plus_base_second_moment_yy;

    /* K5: first moment, mass, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal K5_mass = p[21]; /* kg */
    const wreal K5_com_x = p[22]; /* m */
    const wreal K5_com_y = p[23]; /* m */
    const wreal K5_inertia_xx = p[24]; /* kg m^2 */
    const wreal K5_inertia_yy = p[25]; /* kg m^2 */
    const wreal K5_inertia_zz = p[26]; /* kg m^2 */
    const wreal phi_position_x = p[27]; /* m */
    const wreal K4_mass = p[28]; /* kg */
    const wreal K5_first_moment_x = K5_mass * K5_com_x;
    const wreal K5_first_moment_y = K5_mass * K5_com_y;
    const wreal K5_com_x_times_first_moment_x = K5_com_x * K5_first_moment_x;
    const wreal K5_com_y_times_first_moment_y = K5_com_y * K5_first_moment_y;
    const wreal K5_origin_inertia_xx = K5_inertia_xx + K5_com_y_times_first_moment_y;
    const wreal K5_origin_inertia_yy = K5_inertia_yy + K5_com_x_times_first_moment_x;
    const wreal K5_origin_inertia_zz = K5_inertia_zz + K5_com_x_times_first_moment_x
        + K5_com_y_times_first_moment_y;
    const wreal K5_base_half_trace = 0.5 * (K5_origin_inertia_xx + K5_origin_inertia_zz
        + K5_origin_inertia_yy);
    const wreal K5_base_second_moment_yy = K5_base_half_trace - K5_origin_inertia_yy;
    const wreal K5_base_second_moment_xx = phi_position_x * K4_mass * phi_position_x
        + K5_base_half_trace - K5_origin_inertia_xx;
    const wreal K5_base_second_moment_yy_plus_base_second_moment_xx = K5_base_second_moment_yy
        + K5_base_second_moment_xx;
    w[16] = K5_base_second_moment_yy_plus_base_second_moment_xx;

    /* K4: first moment, mass, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal K4_com_y = p[29]; /* m */
    const wreal K4_inertia_xx = p[30]; /* kg m^2 */
    const wreal K4_inertia_yy = p[31]; /* kg m^2 */
    const wreal K4_inertia_zz = p[32]; /* kg m^2 */
    const wreal K4_first_moment_y = K4_mass * K4_com_y;
    const wreal K4_com_y_times_first_moment_y = K4_com_y * K4_first_moment_y;
    const wreal K4_origin_inertia_xx = K4_inertia_xx + K4_com_y_times_first_moment_y;
    const wreal K4_origin_inertia_zz = K4_inertia_zz + K4_com_y_times_first_moment_y;
    const wreal K4_base_half_trace = 0.5 * (K4_inertia_yy + K4_origin_inertia_zz
        + K4_origin_inertia_xx);
    const wreal K4_base_second_moment_xx = K4_base_half_trace - K4_origin_inertia_xx;
    const wreal K4_base_second_moment_yy = K4_base_half_trace - K4_inertia_yy;
    const wreal K4_base_second_moment_xx_plus_base_second_moment_yy = K4_base_second_moment_xx
        + K4_base_second_moment_yy;
    w[3] = K4_first_moment_y;
    w[17] = K4_base_second_moment_xx_plus_base_second_moment_yy;

    /* K7: first moment, mass, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal K7_mass = p[35]; /* kg */
    const wreal K7_com_x = p[36]; /* m */
    const wreal K7_com_y = p[37]; /* m */
    const wreal K7_inertia_xx = p[38]; /* kg m^2 */
    const wreal K7_inertia_yy = p[39]; /* kg m^2 */
    const wreal K7_inertia_zz = p[40]; /* kg m^2 */
    const wreal omega_position_y = p[41]; /* m */
    const wreal K6_mass = p[42]; /* kg */
    const wreal K7_first_moment_x = K7_mass * K7_com_x;
    const wreal K7_first_moment_y = K7_mass * K7_com_y;
    const wreal K7_com_x_times_first_moment_x = K7_com_x * K7_first_moment_x;
    const wreal K7_com_y_times_first_moment_y = K7_com_y * K7_first_moment_y;
    const wreal K7_origin_inertia_xx = K7_inertia_xx + K7_com_y_times_first_moment_y;
    const wreal K7_origin_inertia_yy = K7_inertia_yy + K7_com_x_times_first_moment_x;
    const wreal K7_origin_inertia_zz = K7_inertia_zz + K7_com_x_times_first_moment_x
        + K7_com_y_times_first_moment_y;
    const wreal K7_base_half_trace = 0.5 * (K7_origin_inertia_xx + K7_origin_inertia_zz
        + K7_origin_inertia_yy);
    const wreal K7_base_second_moment_xx = K7_base_half_trace - K7_origin_inertia_xx;
    const wreal K7_base_second_moment_yy = omega_position_y * K6_mass * omega_position_y
        + K7_base_half_trace - K7_origin_inertia_yy;
    const wreal K7_base_second_moment_xx_plus_base_second_moment_yy = K7_base_second_moment_xx
        + K7_base_second_moment_yy;
    w[18] = K7_base_second_moment_xx_plus_base_second_moment_yy;

    /* K6: first moment, mass, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal K6_com_x = p[43]; /* m */
    const wreal K6_inertia_xx = p[44]; /* kg m^2 */
    const wreal K6_inertia_yy = p[45]; /* kg m^2 */
    const wreal K6_inertia_zz = p[46]; /* kg m^2 */
    const wreal K6_first_moment_x = K6_mass * K6_com_x;
    const wreal K6_com_x_times_first_moment_x = K6_com_x * K6_first_moment_x;
    const wreal K6_origin_inertia_yy = K6_inertia_yy + K6_com_x_times_first_moment_x;
    const wreal K6_origin_inertia_zz = K6_inertia_zz + K6_com_x_times_first_moment_x;
    const wreal K6_base_half_trace = 0.5 * (K6_inertia_xx + K6_origin_inertia_zz
        + K6_origin_inertia_yy);
    const wreal K6_base_second_moment_xx = K6_base_half_trace - K6_inertia_xx;
    const wreal K6_base_second_moment_yy = K6_base_half_trace - K6_origin_inertia_yy;
    const wreal K6_base_second_moment_xx_plus_base_second_moment_yy = K6_base_second_moment_xx
        + K6_base_second_moment_yy;
    w[5] = K6_first_moment_x;
    w[19] = K6_base_second_moment_xx_plus_base_second_moment_yy;

    /* spring: spring damper */
    /* force = stiffness (distance - rest_length) + damping d(distance)/dt */
    const wreal gamma_position_x = p[11]; /* m */
    const wreal gamma_position_y = p[12]; /* m */
    const wreal spring_a_position_x = p[53]; /* m */
    const wreal spring_a_position_y = p[54]; /* m */
    const wreal gamma_position_x_minus_spring_a_position_x = gamma_position_x - spring_a_position_x;
    const wreal gamma_position_y_minus_spring_a_position_y = gamma_position_y - spring_a_position_y;
    w[11] = gamma_position_x_minus_spring_a_position_x;
    w[12] = gamma_position_y_minus_spring_a_position_y;

    /* parameters as they are */
    w[0] = p[5]; /* theta.position.x [m] */
    w[2] = p[27]; /* phi.position.x [m] */
    w[4] = p[41]; /* omega.position.y [m] */
    w[6] = p[51]; /* spring.stiffness [N/m] */
    w[7] = p[52]; /* spring.rest_length [m] */
    w[8] = p[55]; /* spring.b.position.x [m] */
    w[9] = p[56]; /* spring.b.position.y [m] */
    w[10] = p[57]; /* drive.force */
}

#include "lanes.h"

/* tau with M udot + h = f + tau */
CARDAN_API int inverse_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
    (void)work;

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real theta_q = q[1]; /* rad */
    const real gamma_q = q[2]; /* rad */
    const real phi_q = q[4]; /* rad */
    const real omega_q = q[6]; /* rad */
    const real angle[CARDAN_PADDED(4)] = {theta_q, gamma_q, phi_q, omega_q};
    real sine[CARDAN_PADDED(4)], cosine[CARDAN_PADDED(4)];
    cardan_sincos(4, angle, sine, cosine);
    const real theta_cos = cosine[0];
    const real theta_sin = sine[0];
    const real gamma_cos = cosine[1];
    const real gamma_sin = sine[1];
    const real phi_cos = cosine[2];
    const real phi_sin = sine[2];
    const real omega_cos = cosine[3];
    const real omega_sin = sine[3];

    /* spring: spring damper */
    /* force = stiffness (distance - rest_length) + damping d(distance)/dt */
    const wreal spring_stiffness = w[6]; /* N/m */
    const wreal spring_rest_length = w[7]; /* m */
    const wreal spring_b_position_x = w[8]; /* m */
    const wreal spring_b_position_y = w[9]; /* m */
    const wreal gamma_position_x_minus_spring_a_position_x = w[11];
    const wreal gamma_position_y_minus_spring_a_position_y = w[12];
    const real spring_spring_damper_span_x = spring_b_position_x * gamma_cos
        + gamma_position_x_minus_spring_a_position_x - spring_b_position_y * gamma_sin;
    const real spring_spring_damper_span_y = spring_b_position_x * gamma_sin
        + gamma_position_y_minus_spring_a_position_y + spring_b_position_y * gamma_cos;
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

    /* K2: omega, alpha, a, n, f */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real beta_u = u[0]; /* rad/s */
    const real theta_u = u[1]; /* rad/s */
    const real beta_udot = udot[0]; /* rad/s^2 */
    const real theta_udot = udot[1]; /* rad/s^2 */
    const wreal theta_position_x = w[0]; /* m */
    const wreal K2_first_moment_x = w[1];
    const wreal K2_base_second_moment_xx_plus_base_second_moment_yy = w[14];
    const real K2_omega_z = beta_u + theta_u;
    const real K2_alpha_z = beta_udot + theta_udot;
    const real K2_a_y = beta_u * beta_u * theta_position_x * theta_sin
        + theta_position_x * beta_udot * theta_cos;
    const real K2_n_z = K2_alpha_z * K2_base_second_moment_xx_plus_base_second_moment_yy
        + K2_first_moment_x * K2_a_y;
    const real K2_f_y = K2_first_moment_x * K2_alpha_z;
    out[1] = K2_n_z; /* tau: theta.u.tau [N*m] */

    /* K4: omega, alpha, a, n */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real delta_u = u[3]; /* rad/s */
    const real phi_u = u[4]; /* rad/s */
    const real delta_udot = udot[3]; /* rad/s^2 */
    const real phi_udot = udot[4]; /* rad/s^2 */
    const wreal phi_position_x = w[2]; /* m */
    const wreal K4_first_moment_y = w[3];
    const wreal K4_base_second_moment_xx_plus_base_second_moment_yy = w[17];
    const real K4_omega_z = delta_u + phi_u;
    const real K4_alpha_z = delta_udot + phi_udot;
    const real K4_a_x = phi_position_x * delta_udot * phi_sin
        - delta_u * delta_u * phi_position_x * phi_cos;
    const real K4_n_z = K4_alpha_z * K4_base_second_moment_xx_plus_base_second_moment_yy
        - K4_first_moment_y * K4_a_x;
    out[4] = K4_n_z; /* tau: phi.u.tau [N*m] */

    /* K6: omega, alpha, a, n, f */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real epsilon_u = u[5]; /* rad/s */
    const real omega_u = u[6]; /* rad/s */
    const real epsilon_udot = udot[5]; /* rad/s^2 */
    const real omega_udot = udot[6]; /* rad/s^2 */
    const wreal omega_position_y = w[4]; /* m */
    const wreal K6_first_moment_x = w[5];
    const wreal K6_base_second_moment_xx_plus_base_second_moment_yy = w[19];
    const real K6_omega_z = epsilon_u + omega_u;
    const real K6_alpha_z = epsilon_udot + omega_udot;
    const real K6_a_y = omega_position_y * epsilon_udot * omega_sin
        - epsilon_u * epsilon_u * omega_position_y * omega_cos;
    const real K6_n_z = K6_alpha_z * K6_base_second_moment_xx_plus_base_second_moment_yy
        + K6_first_moment_x * K6_a_y;
    const real K6_f_y = K6_first_moment_x * K6_alpha_z;
    out[6] = K6_n_z; /* tau: omega.u.tau [N*m] */

    /* K3: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real gamma_udot = udot[2]; /* rad/s^2 */
    const wreal K3_base_second_moment_xx_plus_base_second_moment_yy = w[15];
    /* tau: gamma.u.tau [N*m] */
    out[2] = gamma_udot * K3_base_second_moment_xx_plus_base_second_moment_yy
        - spring_b_position_x * (gamma_sin * spring_force_on_spring_a_x
        - gamma_cos * spring_force_on_spring_a_y)
        - spring_b_position_y * (gamma_cos * spring_force_on_spring_a_x
        + gamma_sin * spring_force_on_spring_a_y);

    /* K7: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal K7_base_second_moment_xx_plus_base_second_moment_yy = w[18];
    /* tau: epsilon.u.tau [N*m] */
    out[5] = epsilon_udot * K7_base_second_moment_xx_plus_base_second_moment_yy
        + omega_position_y * (K6_omega_z * K6_omega_z * K6_first_moment_x * omega_cos
        + omega_sin * K6_f_y) + K6_n_z;

    /* K5: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal K5_base_second_moment_yy_plus_base_second_moment_xx = w[16];
    /* tau: delta.u.tau [N*m] */
    out[3] = delta_udot * K5_base_second_moment_yy_plus_base_second_moment_xx
        - phi_position_x * (K4_first_moment_y * K4_alpha_z * phi_sin
        + K4_omega_z * K4_omega_z * K4_first_moment_y * phi_cos) + K4_n_z;

    /* K1: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal K1_base_second_moment_yy_plus_base_second_moment_xx = w[13];
    const real K1_n_z = beta_udot * K1_base_second_moment_yy_plus_base_second_moment_xx
        + theta_position_x * (theta_cos * K2_f_y
        - K2_omega_z * K2_omega_z * K2_first_moment_x * theta_sin) + K2_n_z;

    /* beta: tau */
    /* tau = S . [n; f] - force on the joint */
    const wreal drive_force = w[10];
    out[0] = K1_n_z - drive_force; /* tau: beta.u.tau [N*m] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {7, 0, 20, 0, 7, 7, 0, 0, 0, 58, 0, 7, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
