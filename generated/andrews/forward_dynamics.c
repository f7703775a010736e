/*
 * forward_dynamics of andrews
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: parallel, base_parameters
 * passes: unroll
 *
 * Sizes: out 7, work 75, w 32
 * Operations per call: 868 = 496 mul, 173 add, 164 sub, 12 neg, 7 cos, 7 sin, 4 div, 2 select,
 *     1 lt, 1 solve, 1 sqrt
 * Operations of prepare: 49 = 32 mul, 13 add, 4 div
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
    /* K1: first moment, inertia, base inertia */
    const wreal K1_mass = p[0]; /* kg */
    const wreal K1_com_x = p[1]; /* m */
    const wreal K1_inertia_zz = p[4]; /* kg m^2 */
    const wreal theta_position_x = p[5]; /* m */
    const wreal K2_mass = p[6]; /* kg */
    const wreal K1_first_moment_x = K1_mass * K1_com_x;
    const wreal K1_inertia_zz_2 = K1_inertia_zz + K1_com_x * K1_first_moment_x;
    /* K1_base_inertia_zz */
    w[27] = K1_inertia_zz_2 + 0.5 * K2_mass * theta_position_x * theta_position_x * 2.0;

    /* K2: first moment, inertia */
    const wreal K2_com_x = p[7]; /* m */
    const wreal K2_inertia_zz = p[10]; /* kg m^2 */
    const wreal K2_first_moment_x = K2_mass * K2_com_x;
    const wreal K2_inertia_zz_2 = K2_inertia_zz + K2_com_x * K2_first_moment_x;
    w[1] = K2_first_moment_x; /* K2_first_moment_x */
    w[2] = K2_inertia_zz_2; /* K2_inertia_zz_2 */

    /* K3: first moment, inertia */
    const wreal K3_mass = p[13]; /* kg */
    const wreal K3_com_x = p[14]; /* m */
    const wreal K3_com_y = p[15]; /* m */
    const wreal K3_inertia_zz = p[18]; /* kg m^2 */
    const wreal K3_first_moment_x = K3_mass * K3_com_x;
    const wreal K3_first_moment_y = K3_mass * K3_com_y;
    const wreal K3_inertia_zz_2 = K3_com_x * K3_first_moment_x + K3_com_y * K3_first_moment_y
        + K3_inertia_zz;

    /* K5: first moment, inertia, base inertia */
    const wreal K5_mass = p[21]; /* kg */
    const wreal K5_com_x = p[22]; /* m */
    const wreal K5_com_y = p[23]; /* m */
    const wreal K5_inertia_zz = p[26]; /* kg m^2 */
    const wreal phi_position_x = p[27]; /* m */
    const wreal K4_mass = p[28]; /* kg */
    const wreal K5_first_moment_x = K5_mass * K5_com_x;
    const wreal K5_first_moment_y = K5_mass * K5_com_y;
    const wreal K5_inertia_zz_2 = K5_com_x * K5_first_moment_x + K5_com_y * K5_first_moment_y
        + K5_inertia_zz;
    /* K5_base_inertia_zz */
    w[26] = K5_inertia_zz_2 + 0.5 * K4_mass * phi_position_x * phi_position_x * 2.0;

    /* K4: first moment, inertia */
    const wreal K4_com_y = p[29]; /* m */
    const wreal K4_inertia_zz = p[32]; /* kg m^2 */
    const wreal K4_first_moment_y = K4_mass * K4_com_y;
    const wreal K4_inertia_zz_2 = K4_inertia_zz + K4_com_y * K4_first_moment_y;
    w[8] = K4_first_moment_y; /* K4_first_moment_y */
    w[9] = K4_inertia_zz_2; /* K4_inertia_zz_2 */

    /* K7: first moment, inertia, base inertia */
    const wreal K7_mass = p[35]; /* kg */
    const wreal K7_com_x = p[36]; /* m */
    const wreal K7_com_y = p[37]; /* m */
    const wreal K7_inertia_zz = p[40]; /* kg m^2 */
    const wreal omega_position_y = p[41]; /* m */
    const wreal K6_mass = p[42]; /* kg */
    const wreal K7_first_moment_x = K7_mass * K7_com_x;
    const wreal K7_first_moment_y = K7_mass * K7_com_y;
    const wreal K7_inertia_zz_2 = K7_com_x * K7_first_moment_x + K7_com_y * K7_first_moment_y
        + K7_inertia_zz;
    /* K7_base_inertia_zz */
    w[25] = K7_inertia_zz_2 + 0.5 * K6_mass * omega_position_y * omega_position_y * 2.0;

    /* K6: first moment, inertia */
    const wreal K6_com_x = p[43]; /* m */
    const wreal K6_inertia_zz = p[46]; /* kg m^2 */
    const wreal K6_first_moment_x = K6_mass * K6_com_x;
    const wreal K6_inertia_zz_2 = K6_inertia_zz + K6_com_x * K6_first_moment_x;
    w[13] = K6_first_moment_x; /* K6_first_moment_x */
    w[14] = K6_inertia_zz_2; /* K6_inertia_zz_2 */

    /* constraints: D inverse */
    w[28] = 1.0 / K6_inertia_zz_2; /* constraints_D_inverse_7 */
    w[29] = 1.0 / K4_inertia_zz_2; /* constraints_D_inverse_5 */
    w[30] = 1.0 / K3_inertia_zz_2; /* constraints_D_inverse_3 */
    w[31] = 1.0 / K2_inertia_zz_2; /* constraints_D_inverse_2 */

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
    w[19] = p[52]; /* spring.length [m] */
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
    int status = CARDAN_OK;

    /* shared by several: R, cos, sin */
    const real beta_q = q[0]; /* rad */
    const real theta_q = q[1]; /* rad */
    const real gamma_q = q[2]; /* rad */
    const real delta_q = q[3]; /* rad */
    const real phi_q = q[4]; /* rad */
    const real epsilon_q = q[5]; /* rad */
    const real omega_q = q[6]; /* rad */
    const real theta_R = beta_q + theta_q;
    const real phi_R = delta_q + phi_q;
    const real omega_R = epsilon_q + omega_q;
    const real angle[CARDAN_PADDED(7)] = {beta_q, delta_q, epsilon_q, theta_R, gamma_q, phi_R,
        omega_R};
    real sine[CARDAN_PADDED(7)], cosine[CARDAN_PADDED(7)];
    cardan_sincos(7, angle, sine, cosine);
    const real beta_cos = cosine[0];
    const real beta_sin = sine[0];
    const real delta_cos = cosine[1];
    const real delta_sin = sine[1];
    const real epsilon_cos = cosine[2];
    const real epsilon_sin = sine[2];
    const real theta_cos = cosine[3];
    const real theta_sin = sine[3];
    const real gamma_cos = cosine[4];
    const real gamma_sin = sine[4];
    const real phi_cos = cosine[5];
    const real phi_sin = sine[5];
    const real omega_cos = cosine[6];
    const real omega_sin = sine[6];

    /* theta: p */
    const wreal theta_position_x = w[0]; /* m */
    const real theta_p_x = theta_position_x * beta_cos;
    const real theta_p_y = theta_position_x * beta_sin;

    /* phi: p */
    const wreal phi_position_x = w[7]; /* m */
    const real phi_p_x = phi_position_x * delta_cos;
    const real phi_p_y = phi_position_x * delta_sin;

    /* omega: p */
    const wreal omega_position_y = w[12]; /* m */
    const real omega_p = omega_position_y * epsilon_sin;
    const real omega_p_y = omega_position_y * epsilon_cos;

    /* shared by several: position, inertia */
    const wreal K2_first_moment_x = w[1];
    const wreal delta_position_x = w[5]; /* m */
    const wreal delta_position_y = w[6]; /* m */
    const wreal K4_first_moment_y = w[8];
    const wreal epsilon_position_x = w[10]; /* m */
    const wreal epsilon_position_y = w[11]; /* m */
    const wreal K6_first_moment_x = w[13];
    const real K4_position = delta_position_x + phi_p_x;
    const real K4_position_2 = delta_position_y + phi_p_y;
    const real K6_position = epsilon_position_x - omega_p;
    const real K6_position_2 = epsilon_position_y + omega_p_y;
    const real K7_inertia = K6_first_moment_x * omega_sin * omega_p_y
        - K6_first_moment_x * omega_cos * omega_p;
    const real K5_inertia = K4_first_moment_y * phi_cos * phi_p_y
        - K4_first_moment_y * phi_sin * phi_p_x;
    const real K1_inertia = K2_first_moment_x * theta_cos * theta_p_x
        + K2_first_moment_x * theta_sin * theta_p_y;

    /* spring: force */
    const wreal gamma_position_x = w[3]; /* m */
    const wreal gamma_position_y = w[4]; /* m */
    const wreal spring_stiffness = w[18]; /* N/m */
    const wreal spring_length = w[19]; /* m */
    const wreal spring_a_position_x = w[20]; /* m */
    const wreal spring_a_position_y = w[21]; /* m */
    const wreal spring_b_position_x = w[22]; /* m */
    const wreal spring_b_position_y = w[23]; /* m */
    const real spring_force = spring_b_position_x * gamma_cos - spring_b_position_y * gamma_sin
        + gamma_position_x - spring_a_position_x;
    const real spring_force_2 = spring_b_position_x * gamma_sin + spring_b_position_y * gamma_cos
        + gamma_position_y - spring_a_position_y;
    const real spring_force_3 = cardan_sqrt(spring_force * spring_force
        + spring_force_2 * spring_force_2);
    const real spring_force_4 = cardan_lt(0.0, spring_force_3);
    const real spring_force_5 = cardan_select(spring_force_4, 1.0,
        0.0) / cardan_select(spring_force_4, spring_force_3, 1.0);
    const real spring_force_6 = spring_stiffness * (spring_force_3 - spring_length);
    const real spring_force_7 = spring_force * spring_force_5 * spring_force_6;
    const real spring_force_8 = spring_force_2 * spring_force_5 * spring_force_6;
    const real spring_force_9 = spring_b_position_x * (gamma_sin * spring_force_7
        - gamma_cos * spring_force_8);

    /* E3: pose, twist, G */
    const real beta_u = u[0]; /* rad/s */
    const real theta_u = u[1]; /* rad/s */
    const real gamma_u = u[2]; /* rad/s */
    const wreal E3_child_position_y = w[15]; /* m */
    const real E3_pose = gamma_position_x - E3_child_position_y * gamma_sin;
    const real E3_pose_2 = gamma_position_y + E3_child_position_y * gamma_cos;
    const real E3_pose_3 = theta_cos * gamma_cos + theta_sin * gamma_sin;
    const real E3_pose_4 = theta_sin * gamma_cos - theta_cos * gamma_sin;
    const real E3_twist = E3_pose - theta_p_x;
    const real E3_twist_2 = E3_pose_2 - theta_p_y;
    const real E3_twist_3 = E3_pose - gamma_position_x;
    const real E3_twist_4 = E3_pose_2 - gamma_position_y;
    const real E3_twist_5 = beta_u * E3_pose_2 + theta_u * E3_twist_2 - gamma_u * E3_twist_4;
    const real E3_twist_6 = gamma_u * E3_twist_3 - (beta_u * E3_pose + theta_u * E3_twist);
    const real E3_twist_7 = gamma_cos * E3_pose_2 - gamma_sin * E3_pose;
    const real E3_twist_8 = gamma_sin * E3_pose_2 + gamma_cos * E3_pose;
    const real E3_twist_9 = gamma_cos * E3_twist_2 - gamma_sin * E3_twist;
    const real E3_twist_10 = gamma_sin * E3_twist_2 + gamma_cos * E3_twist;
    const real E3_twist_11 = gamma_sin * E3_twist_3 - gamma_cos * E3_twist_4;
    const real E3_twist_12 = gamma_sin * E3_twist_4 + gamma_cos * E3_twist_3;
    const real E3_twist_13 = gamma_cos * E3_twist_5 + gamma_sin * E3_twist_6;
    const real E3_twist_14 = gamma_cos * E3_twist_6 - gamma_sin * E3_twist_5;
    const real E3_G = E3_pose_3 * E3_twist_7 - E3_pose_4 * E3_twist_8;
    const real E3_G_2 = E3_pose_3 * E3_twist_9 - E3_pose_4 * E3_twist_10;
    const real E3_G_3 = E3_pose_3 * E3_twist_11 + E3_pose_4 * E3_twist_12;
    const real E3_G_4 = E3_pose_4 * E3_twist_7 + E3_pose_3 * E3_twist_8;
    const real E3_G_5 = E3_pose_4 * E3_twist_9 + E3_pose_3 * E3_twist_10;
    const real E3_G_6 = E3_pose_3 * E3_twist_12 - E3_pose_4 * E3_twist_11;

    /* K2: omega, inertia force */
    const real K2_omega_z = beta_u + theta_u;
    const real K2_inertia_force = K2_omega_z * K2_omega_z * K2_first_moment_x;

    /* E4: pose, twist, G */
    const real delta_u = u[3]; /* rad/s */
    const real phi_u = u[4]; /* rad/s */
    const wreal E4_child_position_y = w[16]; /* m */
    const real E4_pose = K4_position - E4_child_position_y * phi_sin;
    const real E4_pose_2 = K4_position_2 + E4_child_position_y * phi_cos;
    const real E4_pose_3 = theta_cos * phi_cos + theta_sin * phi_sin;
    const real E4_pose_4 = theta_sin * phi_cos - theta_cos * phi_sin;
    const real E4_twist = E4_pose - theta_p_x;
    const real E4_twist_2 = E4_pose_2 - theta_p_y;
    const real E4_twist_3 = E4_pose - delta_position_x;
    const real E4_twist_4 = E4_pose_2 - delta_position_y;
    const real E4_twist_5 = E4_pose - K4_position;
    const real E4_twist_6 = E4_pose_2 - K4_position_2;
    const real E4_twist_7 = beta_u * E4_pose_2 + theta_u * E4_twist_2 - delta_u * E4_twist_4
        - phi_u * E4_twist_6;
    const real E4_twist_8 = delta_u * E4_twist_3 - (beta_u * E4_pose + theta_u * E4_twist)
        + phi_u * E4_twist_5;
    const real E4_twist_9 = phi_cos * E4_pose_2 - phi_sin * E4_pose;
    const real E4_twist_10 = phi_sin * E4_pose_2 + phi_cos * E4_pose;
    const real E4_twist_11 = phi_cos * E4_twist_2 - phi_sin * E4_twist;
    const real E4_twist_12 = phi_sin * E4_twist_2 + phi_cos * E4_twist;
    const real E4_twist_13 = phi_sin * E4_twist_3 - phi_cos * E4_twist_4;
    const real E4_twist_14 = phi_sin * E4_twist_4 + phi_cos * E4_twist_3;
    const real E4_twist_15 = phi_sin * E4_twist_5 - phi_cos * E4_twist_6;
    const real E4_twist_16 = phi_sin * E4_twist_6 + phi_cos * E4_twist_5;
    const real E4_twist_17 = phi_cos * E4_twist_7 + phi_sin * E4_twist_8;
    const real E4_twist_18 = phi_cos * E4_twist_8 - phi_sin * E4_twist_7;
    const real E4_G = E4_pose_3 * E4_twist_9 - E4_pose_4 * E4_twist_10;
    const real E4_G_2 = E4_pose_3 * E4_twist_11 - E4_pose_4 * E4_twist_12;
    const real E4_G_3 = E4_pose_3 * E4_twist_13 + E4_pose_4 * E4_twist_14;
    const real E4_G_4 = E4_pose_3 * E4_twist_15 + E4_pose_4 * E4_twist_16;
    const real E4_G_5 = E4_pose_4 * E4_twist_9 + E4_pose_3 * E4_twist_10;
    const real E4_G_6 = E4_pose_4 * E4_twist_11 + E4_pose_3 * E4_twist_12;
    const real E4_G_7 = E4_pose_3 * E4_twist_14 - E4_pose_4 * E4_twist_13;
    const real E4_G_8 = E4_pose_3 * E4_twist_16 - E4_pose_4 * E4_twist_15;

    /* E6: pose, twist, G */
    const real epsilon_u = u[5]; /* rad/s */
    const real omega_u = u[6]; /* rad/s */
    const wreal E6_child_position_x = w[17]; /* m */
    const real E6_pose = K6_position + E6_child_position_x * omega_cos;
    const real E6_pose_2 = K6_position_2 + E6_child_position_x * omega_sin;
    const real E6_pose_3 = theta_cos * omega_cos + theta_sin * omega_sin;
    const real E6_pose_4 = theta_sin * omega_cos - theta_cos * omega_sin;
    const real E6_twist = E6_pose - theta_p_x;
    const real E6_twist_2 = E6_pose_2 - theta_p_y;
    const real E6_twist_3 = E6_pose - epsilon_position_x;
    const real E6_twist_4 = E6_pose_2 - epsilon_position_y;
    const real E6_twist_5 = E6_pose - K6_position;
    const real E6_twist_6 = E6_pose_2 - K6_position_2;
    const real E6_twist_7 = beta_u * E6_pose_2 + theta_u * E6_twist_2 - epsilon_u * E6_twist_4
        - omega_u * E6_twist_6;
    const real E6_twist_8 = epsilon_u * E6_twist_3 - (beta_u * E6_pose + theta_u * E6_twist)
        + omega_u * E6_twist_5;
    const real E6_twist_9 = omega_cos * E6_pose_2 - omega_sin * E6_pose;
    const real E6_twist_10 = omega_sin * E6_pose_2 + omega_cos * E6_pose;
    const real E6_twist_11 = omega_cos * E6_twist_2 - omega_sin * E6_twist;
    const real E6_twist_12 = omega_sin * E6_twist_2 + omega_cos * E6_twist;
    const real E6_twist_13 = omega_sin * E6_twist_3 - omega_cos * E6_twist_4;
    const real E6_twist_14 = omega_sin * E6_twist_4 + omega_cos * E6_twist_3;
    const real E6_twist_15 = omega_sin * E6_twist_5 - omega_cos * E6_twist_6;
    const real E6_twist_16 = omega_sin * E6_twist_6 + omega_cos * E6_twist_5;
    const real E6_twist_17 = omega_cos * E6_twist_7 + omega_sin * E6_twist_8;
    const real E6_twist_18 = omega_cos * E6_twist_8 - omega_sin * E6_twist_7;
    const real E6_G = E6_pose_3 * E6_twist_9 - E6_pose_4 * E6_twist_10;
    const real E6_G_2 = E6_pose_3 * E6_twist_11 - E6_pose_4 * E6_twist_12;
    const real E6_G_3 = E6_pose_3 * E6_twist_13 + E6_pose_4 * E6_twist_14;
    const real E6_G_4 = E6_pose_3 * E6_twist_15 + E6_pose_4 * E6_twist_16;
    const real E6_G_5 = E6_pose_4 * E6_twist_9 + E6_pose_3 * E6_twist_10;
    const real E6_G_6 = E6_pose_4 * E6_twist_11 + E6_pose_3 * E6_twist_12;
    const real E6_G_7 = E6_pose_3 * E6_twist_14 - E6_pose_4 * E6_twist_13;
    const real E6_G_8 = E6_pose_3 * E6_twist_16 - E6_pose_4 * E6_twist_15;

    /* K7: composite inertia, U */
    const wreal K6_inertia_zz_2 = w[14];
    const wreal K7_base_inertia_zz = w[25];
    const real K7_composite_inertia_zz = K6_inertia_zz_2 + 2.0 * K7_inertia + K7_base_inertia_zz;
    const real K7_U = epsilon_u * epsilon_u;

    /* K5: composite inertia, U */
    const wreal K4_inertia_zz_2 = w[9];
    const wreal K5_base_inertia_zz = w[26];
    const real K5_composite_inertia_zz = K4_inertia_zz_2 + 2.0 * K5_inertia + K5_base_inertia_zz;
    const real K5_U = delta_u * delta_u;

    /* K1: composite inertia, U */
    const wreal K2_inertia_zz_2 = w[2];
    const wreal K1_base_inertia_zz = w[27];
    const real K1_composite_inertia_zz = K2_inertia_zz_2 + 2.0 * K1_inertia + K1_base_inertia_zz;
    const real K1_U = beta_u * beta_u;

    /* M */
    const real M_7_6 = K6_inertia_zz_2 + K7_inertia;
    const real M_5_4 = K4_inertia_zz_2 + K5_inertia;
    const real M_2_1 = K2_inertia_zz_2 + K1_inertia;

    /* K4: omega, n, inertia force */
    const real K4_omega_z = delta_u + phi_u;
    const real K4_n_z = K4_first_moment_y * (phi_p_x * K5_U * phi_cos + phi_p_y * K5_U * phi_sin);
    const real K4_inertia_force = K4_omega_z * K4_omega_z * K4_first_moment_y;

    /* K6: omega, inertia force */
    const real K6_omega_z = epsilon_u + omega_u;
    const real K6_inertia_force = K6_first_moment_x * (omega_p * K7_U * omega_sin
        + omega_p_y * K7_U * omega_cos);
    const real K6_inertia_force_2 = K6_omega_z * K6_omega_z * K6_first_moment_x;

    /* K2: a, n */
    const real K2_a_y = theta_p_x * K1_U * theta_sin - theta_p_y * K1_U * theta_cos;
    const real K2_n_z = K2_first_moment_x * K2_a_y;

    /* K7: n */
    const real K7_n_z = omega_sin * K6_inertia_force_2 * omega_p
        + omega_cos * K6_inertia_force_2 * omega_p_y - K6_inertia_force;

    /* K5: n */
    const real K5_n_z = K4_n_z - (phi_cos * K4_inertia_force * phi_p_x
        + phi_sin * K4_inertia_force * phi_p_y);

    /* K1: n */
    const real K1_n_z = theta_cos * K2_inertia_force * theta_p_y
        - theta_sin * K2_inertia_force * theta_p_x + K2_n_z;

    /* beta: tau, drive */
    const real beta_u_tau = tau[0]; /* N*m */
    const wreal drive_force = w[24];
    const real beta_tau = K1_n_z - drive_force;
    const real beta_drive = beta_u_tau - beta_tau;

    /* theta: drive */
    const real theta_u_tau = tau[1]; /* N*m */
    const real theta_drive = theta_u_tau - K2_n_z;

    /* gamma: drive */
    const real gamma_u_tau = tau[2]; /* N*m */
    const real gamma_drive = spring_force_9 + spring_b_position_y * (gamma_cos * spring_force_7
        + gamma_sin * spring_force_8) + gamma_u_tau;

    /* delta: drive */
    const real delta_u_tau = tau[3]; /* N*m */
    const real delta_drive = delta_u_tau - K5_n_z;

    /* phi: drive */
    const real phi_u_tau = tau[4]; /* N*m */
    const real phi_drive = phi_u_tau - K4_n_z;

    /* epsilon: drive */
    const real epsilon_u_tau = tau[5]; /* N*m */
    const real epsilon_drive = epsilon_u_tau - K7_n_z;

    /* omega: drive */
    const real omega_u_tau = tau[6]; /* N*m */
    const real omega_drive = omega_u_tau + K6_inertia_force;

    /* constraints: multipliers, L, D inverse */
    const wreal constraints_D_inverse_7 = w[28];
    const wreal constraints_D_inverse_5 = w[29];
    const wreal constraints_D_inverse_3 = w[30];
    const wreal constraints_D_inverse_2 = w[31];
    const real constraints_multipliers = theta_sin * K2_omega_z;
    const real constraints_multipliers_2 = theta_cos * K2_omega_z;
    const real constraints_multipliers_3 = beta_u * beta_sin * theta_position_x;
    const real constraints_multipliers_4 = beta_u * beta_cos * theta_position_x;
    const real constraints_multipliers_5 = gamma_u * gamma_sin;
    const real constraints_multipliers_6 = gamma_u * gamma_cos;
    const real constraints_multipliers_7 = phi_sin * K4_omega_z;
    const real constraints_multipliers_8 = phi_cos * K4_omega_z;
    const real constraints_multipliers_9 = delta_u * delta_sin * phi_position_x;
    const real constraints_multipliers_10 = delta_u * delta_cos * phi_position_x;
    const real constraints_multipliers_11 = omega_sin * K6_omega_z;
    const real constraints_multipliers_12 = omega_cos * K6_omega_z;
    const real constraints_multipliers_13 = epsilon_u * epsilon_cos * omega_position_y;
    const real constraints_multipliers_14 = epsilon_u * epsilon_sin * omega_position_y;
    const real constraints_multipliers_15 = E3_child_position_y * constraints_multipliers_6;
    const real constraints_multipliers_16 = E3_child_position_y * constraints_multipliers_5;
    const real constraints_multipliers_17 = gamma_sin * constraints_multipliers_2
        + theta_sin * constraints_multipliers_6;
    const real constraints_multipliers_18 = constraints_multipliers_17
        - (gamma_cos * constraints_multipliers + theta_cos * constraints_multipliers_5);
    const real constraints_multipliers_19 = gamma_cos * constraints_multipliers_2
        - theta_sin * constraints_multipliers_5;
    const real constraints_multipliers_20 = constraints_multipliers_19
        - (theta_cos * constraints_multipliers_6 - gamma_sin * constraints_multipliers);
    const real constraints_multipliers_21 = beta_u * constraints_multipliers_16
        + theta_u * (constraints_multipliers_4 + constraints_multipliers_16);
    const real constraints_multipliers_22 = theta_u * (constraints_multipliers_3
        - constraints_multipliers_15) - beta_u * constraints_multipliers_15;
    const real constraints_multipliers_23 = gamma_u * constraints_multipliers_16
        - constraints_multipliers_21;
    const real constraints_multipliers_24 = constraints_multipliers_22
        + gamma_u * constraints_multipliers_15;
    const real constraints_multipliers_25 = gamma_cos * constraints_multipliers_23
        - E3_twist_5 * constraints_multipliers_5;
    const real constraints_multipliers_26 = E3_twist_6 * constraints_multipliers_6
        - gamma_sin * constraints_multipliers_24 + constraints_multipliers_25;
    const real constraints_multipliers_27 = E3_twist_5 * constraints_multipliers_6
        + gamma_sin * constraints_multipliers_23;
    const real constraints_multipliers_28 = E3_twist_6 * constraints_multipliers_5
        + gamma_cos * constraints_multipliers_24 + constraints_multipliers_27;
    const real constraints_multipliers_29 = constraints_multipliers_9
        + E4_child_position_y * constraints_multipliers_8;
    const real constraints_multipliers_30 = constraints_multipliers_10
        - E4_child_position_y * constraints_multipliers_7;
    const real constraints_multipliers_31 = phi_sin * constraints_multipliers_2
        + theta_sin * constraints_multipliers_8;
    const real constraints_multipliers_32 = constraints_multipliers_31
        - (phi_cos * constraints_multipliers + theta_cos * constraints_multipliers_7);
    const real constraints_multipliers_33 = phi_cos * constraints_multipliers_2
        - theta_sin * constraints_multipliers_7;
    const real constraints_multipliers_34 = constraints_multipliers_33
        - (theta_cos * constraints_multipliers_8 - phi_sin * constraints_multipliers);
    const real constraints_multipliers_35 = beta_u * constraints_multipliers_30
        + theta_u * (constraints_multipliers_30 - constraints_multipliers_4);
    const real constraints_multipliers_36 = theta_u * (constraints_multipliers_3
        - constraints_multipliers_29) - beta_u * constraints_multipliers_29;
    const real constraints_multipliers_37 = constraints_multipliers_35
        - delta_u * constraints_multipliers_30;
    const real constraints_multipliers_38 = constraints_multipliers_36
        + delta_u * constraints_multipliers_29;
    const real constraints_multipliers_39 = constraints_multipliers_37
        - phi_u * (constraints_multipliers_30 - constraints_multipliers_10);
    const real constraints_multipliers_40 = phi_u * (constraints_multipliers_9
        - constraints_multipliers_29) - constraints_multipliers_38;
    const real constraints_multipliers_41 = phi_cos * constraints_multipliers_39
        - E4_twist_7 * constraints_multipliers_7;
    const real constraints_multipliers_42 = E4_twist_8 * constraints_multipliers_8
        + phi_sin * constraints_multipliers_40 + constraints_multipliers_41;
    const real constraints_multipliers_43 = phi_cos * constraints_multipliers_40
        - E4_twist_8 * constraints_multipliers_7;
    const real constraints_multipliers_44 = constraints_multipliers_43
        - (E4_twist_7 * constraints_multipliers_8 + phi_sin * constraints_multipliers_39);
    const real constraints_multipliers_45 = constraints_multipliers_13
        + E6_child_position_x * constraints_multipliers_11;
    const real constraints_multipliers_46 = E6_child_position_x * constraints_multipliers_12
        - constraints_multipliers_14;
    const real constraints_multipliers_47 = omega_sin * constraints_multipliers_2
        + theta_sin * constraints_multipliers_12;
    const real constraints_multipliers_48 = constraints_multipliers_47
        - (omega_cos * constraints_multipliers + theta_cos * constraints_multipliers_11);
    const real constraints_multipliers_49 = omega_cos * constraints_multipliers_2
        - theta_sin * constraints_multipliers_11;
    const real constraints_multipliers_50 = constraints_multipliers_49
        - (theta_cos * constraints_multipliers_12 - omega_sin * constraints_multipliers);
    const real constraints_multipliers_51 = beta_u * constraints_multipliers_46
        + theta_u * (constraints_multipliers_46 - constraints_multipliers_4);
    const real constraints_multipliers_52 = theta_u * (constraints_multipliers_3
        - constraints_multipliers_45) - beta_u * constraints_multipliers_45;
    const real constraints_multipliers_53 = constraints_multipliers_51
        - epsilon_u * constraints_multipliers_46;
    const real constraints_multipliers_54 = constraints_multipliers_52
        + epsilon_u * constraints_multipliers_45;
    const real constraints_multipliers_55 = constraints_multipliers_53
        - omega_u * (constraints_multipliers_14 + constraints_multipliers_46);
    const real constraints_multipliers_56 = omega_u * (constraints_multipliers_13
        - constraints_multipliers_45) - constraints_multipliers_54;
    const real constraints_multipliers_57 = omega_cos * constraints_multipliers_55
        - E6_twist_7 * constraints_multipliers_11;
    const real constraints_multipliers_58 = E6_twist_8 * constraints_multipliers_12
        + omega_sin * constraints_multipliers_56 + constraints_multipliers_57;
    const real constraints_multipliers_59 = omega_cos * constraints_multipliers_56
        - E6_twist_8 * constraints_multipliers_11;
    const real constraints_multipliers_60 = constraints_multipliers_59
        - (E6_twist_7 * constraints_multipliers_12 + omega_sin * constraints_multipliers_55);
    const real constraints_multipliers_61 = E3_twist_13 * constraints_multipliers_18
        + E3_pose_3 * constraints_multipliers_26;
    const real constraints_multipliers_62 = E3_twist_14 * constraints_multipliers_20
        - E3_pose_4 * constraints_multipliers_28 + constraints_multipliers_61;
    const real constraints_multipliers_63 = E3_twist_14 * constraints_multipliers_18
        - E3_pose_3 * constraints_multipliers_28;
    const real constraints_multipliers_64 = constraints_multipliers_63
        - (E3_twist_13 * constraints_multipliers_20 + E3_pose_4 * constraints_multipliers_26);
    const real constraints_multipliers_65 = E4_twist_17 * constraints_multipliers_32
        + E4_pose_3 * constraints_multipliers_42;
    const real constraints_multipliers_66 = E4_twist_18 * constraints_multipliers_34
        + E4_pose_4 * constraints_multipliers_44 + constraints_multipliers_65;
    const real constraints_multipliers_67 = E4_twist_18 * constraints_multipliers_32
        + E4_pose_3 * constraints_multipliers_44;
    const real constraints_multipliers_68 = constraints_multipliers_67
        - (E4_twist_17 * constraints_multipliers_34 + E4_pose_4 * constraints_multipliers_42);
    const real constraints_multipliers_69 = E6_twist_17 * constraints_multipliers_48
        + E6_pose_3 * constraints_multipliers_58;
    const real constraints_multipliers_70 = E6_twist_18 * constraints_multipliers_50
        + E6_pose_4 * constraints_multipliers_60 + constraints_multipliers_69;
    const real constraints_multipliers_71 = E6_twist_18 * constraints_multipliers_48
        + E6_pose_3 * constraints_multipliers_60;
    const real constraints_multipliers_72 = constraints_multipliers_71
        - (E6_twist_17 * constraints_multipliers_50 + E6_pose_4 * constraints_multipliers_58);
    const real constraints_L_7_6 = M_7_6 * constraints_D_inverse_7;
    const real constraints_D_inverse_6 = 1.0 / (K7_composite_inertia_zz
        - M_7_6 * constraints_L_7_6);
    const real constraints_L_5_4 = M_5_4 * constraints_D_inverse_5;
    const real constraints_D_inverse_4 = 1.0 / (K5_composite_inertia_zz
        - M_5_4 * constraints_L_5_4);
    const real constraints_L_2_1 = M_2_1 * constraints_D_inverse_2;
    const real constraints_D_inverse_1 = 1.0 / (K1_composite_inertia_zz
        - M_2_1 * constraints_L_2_1);
    const real constraints_multipliers_73 = constraints_D_inverse_1 * (beta_drive
        - theta_drive * constraints_L_2_1);
    const real constraints_multipliers_74 = gamma_drive * constraints_D_inverse_3;
    const real constraints_multipliers_75 = constraints_D_inverse_4 * (delta_drive
        - phi_drive * constraints_L_5_4);
    const real constraints_multipliers_76 = constraints_D_inverse_6 * (epsilon_drive
        - omega_drive * constraints_L_7_6);
    const real constraints_multipliers_77 = theta_drive * constraints_D_inverse_2
        - constraints_L_2_1 * constraints_multipliers_73;
    const real constraints_multipliers_78 = phi_drive * constraints_D_inverse_5
        - constraints_L_5_4 * constraints_multipliers_75;
    const real constraints_multipliers_79 = omega_drive * constraints_D_inverse_7
        - constraints_L_7_6 * constraints_multipliers_76;
    const real constraints_multipliers_80 = constraints_D_inverse_1 * (E3_G
        - E3_G_2 * constraints_L_2_1);
    const real constraints_multipliers_81 = E3_G_3 * constraints_D_inverse_3;
    const real constraints_multipliers_82 = E3_G_2 * constraints_D_inverse_2
        - constraints_L_2_1 * constraints_multipliers_80;
    const real constraints_multipliers_83 = constraints_D_inverse_1 * (E3_G_5 * constraints_L_2_1
        - E3_G_4);
    const real constraints_multipliers_84 = E3_G_6 * constraints_D_inverse_3;
    const real constraints_multipliers_85 = E3_G_5 * constraints_D_inverse_2
        + constraints_L_2_1 * constraints_multipliers_83;
    const real constraints_multipliers_86 = constraints_D_inverse_1 * (E4_G
        - E4_G_2 * constraints_L_2_1);
    const real constraints_multipliers_87 = constraints_D_inverse_4 * (E4_G_3
        - E4_G_4 * constraints_L_5_4);
    const real constraints_multipliers_88 = E4_G_2 * constraints_D_inverse_2
        - constraints_L_2_1 * constraints_multipliers_86;
    const real constraints_multipliers_89 = E4_G_4 * constraints_D_inverse_5
        - constraints_L_5_4 * constraints_multipliers_87;
    const real constraints_multipliers_90 = constraints_D_inverse_1 * (E4_G_6 * constraints_L_2_1
        - E4_G_5);
    const real constraints_multipliers_91 = constraints_D_inverse_4 * (E4_G_7
        - E4_G_8 * constraints_L_5_4);
    const real constraints_multipliers_92 = E4_G_6 * constraints_D_inverse_2
        + constraints_L_2_1 * constraints_multipliers_90;
    const real constraints_multipliers_93 = E4_G_8 * constraints_D_inverse_5
        - constraints_L_5_4 * constraints_multipliers_91;
    const real constraints_multipliers_94 = constraints_D_inverse_1 * (E6_G
        - E6_G_2 * constraints_L_2_1);
    const real constraints_multipliers_95 = constraints_D_inverse_6 * (E6_G_3
        - E6_G_4 * constraints_L_7_6);
    const real constraints_multipliers_96 = E6_G_2 * constraints_D_inverse_2
        - constraints_L_2_1 * constraints_multipliers_94;
    const real constraints_multipliers_97 = E6_G_4 * constraints_D_inverse_7
        - constraints_L_7_6 * constraints_multipliers_95;
    const real constraints_multipliers_98 = constraints_D_inverse_1 * (E6_G_6 * constraints_L_2_1
        - E6_G_5);
    const real constraints_multipliers_99 = constraints_D_inverse_6 * (E6_G_7
        - E6_G_8 * constraints_L_7_6);
    const real constraints_multipliers_100 = E6_G_6 * constraints_D_inverse_2
        + constraints_L_2_1 * constraints_multipliers_98;
    const real constraints_multipliers_101 = E6_G_8 * constraints_D_inverse_7
        - constraints_L_7_6 * constraints_multipliers_99;
    const real constraints_multipliers_102 = E3_G * constraints_multipliers_80
        + E3_G_2 * constraints_multipliers_82 + E3_G_3 * constraints_multipliers_81;
    work[0] = constraints_multipliers_102;
    const real constraints_multipliers_103 = E3_G_6 * constraints_multipliers_81
        - (E3_G_4 * constraints_multipliers_80 + E3_G_5 * constraints_multipliers_82);
    work[1] = constraints_multipliers_103;
    work[6] = constraints_multipliers_103;
    const real constraints_multipliers_104 = E3_G_6 * constraints_multipliers_84
        - (E3_G_4 * constraints_multipliers_83 - E3_G_5 * constraints_multipliers_85);
    work[7] = constraints_multipliers_104;
    const real constraints_multipliers_105 = E4_G * constraints_multipliers_80
        + E4_G_2 * constraints_multipliers_82;
    work[2] = constraints_multipliers_105;
    work[12] = constraints_multipliers_105;
    const real constraints_multipliers_106 = E4_G * constraints_multipliers_83
        - E4_G_2 * constraints_multipliers_85;
    work[8] = constraints_multipliers_106;
    work[13] = constraints_multipliers_106;
    const real constraints_multipliers_107 = E4_G * constraints_multipliers_86
        + E4_G_2 * constraints_multipliers_88 + E4_G_3 * constraints_multipliers_87;
    const real constraints_multipliers_108 = constraints_multipliers_107
        + E4_G_4 * constraints_multipliers_89;
    work[14] = constraints_multipliers_108;
    const real constraints_multipliers_109 = -(E4_G_5 * constraints_multipliers_80
        + E4_G_6 * constraints_multipliers_82);
    work[3] = constraints_multipliers_109;
    work[18] = constraints_multipliers_109;
    const real constraints_multipliers_110 = -(E4_G_5 * constraints_multipliers_83
        - E4_G_6 * constraints_multipliers_85);
    work[9] = constraints_multipliers_110;
    work[19] = constraints_multipliers_110;
    const real constraints_multipliers_111 = E4_G_7 * constraints_multipliers_87
        - (E4_G_5 * constraints_multipliers_86 + E4_G_6 * constraints_multipliers_88);
    const real constraints_multipliers_112 = constraints_multipliers_111
        + E4_G_8 * constraints_multipliers_89;
    work[15] = constraints_multipliers_112;
    work[20] = constraints_multipliers_112;
    const real constraints_multipliers_113 = E4_G_7 * constraints_multipliers_91
        - (E4_G_5 * constraints_multipliers_90 - E4_G_6 * constraints_multipliers_92);
    const real constraints_multipliers_114 = constraints_multipliers_113
        + E4_G_8 * constraints_multipliers_93;
    work[21] = constraints_multipliers_114;
    const real constraints_multipliers_115 = E6_G * constraints_multipliers_80
        + E6_G_2 * constraints_multipliers_82;
    work[4] = constraints_multipliers_115;
    work[24] = constraints_multipliers_115;
    const real constraints_multipliers_116 = E6_G * constraints_multipliers_83
        - E6_G_2 * constraints_multipliers_85;
    work[10] = constraints_multipliers_116;
    work[25] = constraints_multipliers_116;
    const real constraints_multipliers_117 = E6_G * constraints_multipliers_86
        + E6_G_2 * constraints_multipliers_88;
    work[16] = constraints_multipliers_117;
    work[26] = constraints_multipliers_117;
    const real constraints_multipliers_118 = E6_G * constraints_multipliers_90
        - E6_G_2 * constraints_multipliers_92;
    work[22] = constraints_multipliers_118;
    work[27] = constraints_multipliers_118;
    const real constraints_multipliers_119 = E6_G * constraints_multipliers_94
        + E6_G_2 * constraints_multipliers_96 + E6_G_3 * constraints_multipliers_95;
    const real constraints_multipliers_120 = constraints_multipliers_119
        + E6_G_4 * constraints_multipliers_97;
    work[28] = constraints_multipliers_120;
    const real constraints_multipliers_121 = -(E6_G_5 * constraints_multipliers_80
        + E6_G_6 * constraints_multipliers_82);
    work[5] = constraints_multipliers_121;
    work[30] = constraints_multipliers_121;
    const real constraints_multipliers_122 = -(E6_G_5 * constraints_multipliers_83
        - E6_G_6 * constraints_multipliers_85);
    work[11] = constraints_multipliers_122;
    work[31] = constraints_multipliers_122;
    const real constraints_multipliers_123 = -(E6_G_5 * constraints_multipliers_86
        + E6_G_6 * constraints_multipliers_88);
    work[17] = constraints_multipliers_123;
    work[32] = constraints_multipliers_123;
    const real constraints_multipliers_124 = -(E6_G_5 * constraints_multipliers_90
        - E6_G_6 * constraints_multipliers_92);
    work[23] = constraints_multipliers_124;
    work[33] = constraints_multipliers_124;
    const real constraints_multipliers_125 = E6_G_7 * constraints_multipliers_95
        - (E6_G_5 * constraints_multipliers_94 + E6_G_6 * constraints_multipliers_96);
    const real constraints_multipliers_126 = constraints_multipliers_125
        + E6_G_8 * constraints_multipliers_97;
    work[29] = constraints_multipliers_126;
    work[34] = constraints_multipliers_126;
    const real constraints_multipliers_127 = E6_G_7 * constraints_multipliers_99
        - (E6_G_5 * constraints_multipliers_98 - E6_G_6 * constraints_multipliers_100);
    const real constraints_multipliers_128 = constraints_multipliers_127
        + E6_G_8 * constraints_multipliers_101;
    work[35] = constraints_multipliers_128;
    const real constraints_multipliers_129 = E3_G * constraints_multipliers_73
        + E3_G_2 * constraints_multipliers_77 + E3_G_3 * constraints_multipliers_74;
    const real constraints_multipliers_130 = E3_G_6 * constraints_multipliers_74
        - (E3_G_4 * constraints_multipliers_73 + E3_G_5 * constraints_multipliers_77);
    const real constraints_multipliers_131 = E4_G * constraints_multipliers_73
        + E4_G_2 * constraints_multipliers_77 + E4_G_3 * constraints_multipliers_75;
    const real constraints_multipliers_132 = E4_G_7 * constraints_multipliers_75
        - (E4_G_5 * constraints_multipliers_73 + E4_G_6 * constraints_multipliers_77);
    const real constraints_multipliers_133 = E6_G * constraints_multipliers_73
        + E6_G_2 * constraints_multipliers_77 + E6_G_3 * constraints_multipliers_76;
    const real constraints_multipliers_134 = E6_G_7 * constraints_multipliers_76
        - (E6_G_5 * constraints_multipliers_73 + E6_G_6 * constraints_multipliers_77);
    const real constraints_multipliers_135 = -(constraints_multipliers_62
        + constraints_multipliers_129);
    work[36] = constraints_multipliers_135;
    const real constraints_multipliers_136 = -(constraints_multipliers_64
        + constraints_multipliers_130);
    work[37] = constraints_multipliers_136;
    const real constraints_multipliers_137 = -(constraints_multipliers_131
        + E4_G_4 * constraints_multipliers_78 + constraints_multipliers_66);
    work[38] = constraints_multipliers_137;
    const real constraints_multipliers_138 = -(constraints_multipliers_132
        + E4_G_8 * constraints_multipliers_78 + constraints_multipliers_68);
    work[39] = constraints_multipliers_138;
    const real constraints_multipliers_139 = -(constraints_multipliers_133
        + E6_G_4 * constraints_multipliers_79 + constraints_multipliers_70);
    work[40] = constraints_multipliers_139;
    const real constraints_multipliers_140 = -(constraints_multipliers_134
        + E6_G_8 * constraints_multipliers_79 + constraints_multipliers_72);
    work[41] = constraints_multipliers_140;
    status |= CARDAN_SOLVE(semidefinite, 6, 1, work + 0, work + 36, work + 42);

    /* E3: multiplier px, multiplier py */
    const real E3_multiplier_px = work[36];
    const real E3_multiplier_py = work[37];

    /* E4: multiplier px, multiplier py */
    const real E4_multiplier_px = work[38];
    const real E4_multiplier_py = work[39];

    /* E6: multiplier px, multiplier py */
    const real E6_multiplier_px = work[40];
    const real E6_multiplier_py = work[41];

    /* constraints: multipliers */
    const real constraints_multipliers_141 = constraints_multipliers_80 * E3_multiplier_px
        + constraints_multipliers_83 * E3_multiplier_py;
    const real constraints_multipliers_142 = constraints_multipliers_141
        + constraints_multipliers_86 * E4_multiplier_px;
    const real constraints_multipliers_143 = constraints_multipliers_142
        + constraints_multipliers_90 * E4_multiplier_py;
    const real constraints_multipliers_144 = constraints_multipliers_143
        + constraints_multipliers_94 * E6_multiplier_px;
    const real constraints_multipliers_145 = constraints_multipliers_82 * E3_multiplier_px
        - constraints_multipliers_85 * E3_multiplier_py;
    const real constraints_multipliers_146 = constraints_multipliers_145
        + constraints_multipliers_88 * E4_multiplier_px;
    const real constraints_multipliers_147 = constraints_multipliers_146
        - constraints_multipliers_92 * E4_multiplier_py;
    const real constraints_multipliers_148 = constraints_multipliers_147
        + constraints_multipliers_96 * E6_multiplier_px;

    /* beta: udot */
    /* udot: beta.udot [rad/s^2] */
    out[0] = constraints_multipliers_144 + constraints_multipliers_98 * E6_multiplier_py
        + constraints_multipliers_73;

    /* theta: udot */
    /* udot: theta.udot [rad/s^2] */
    out[1] = constraints_multipliers_148 - constraints_multipliers_100 * E6_multiplier_py
        + constraints_multipliers_77;

    /* gamma: udot */
    /* udot: gamma.udot [rad/s^2] */
    out[2] = constraints_multipliers_81 * E3_multiplier_px
        + constraints_multipliers_84 * E3_multiplier_py + constraints_multipliers_74;

    /* delta: udot */
    /* udot: delta.udot [rad/s^2] */
    out[3] = constraints_multipliers_87 * E4_multiplier_px
        + constraints_multipliers_91 * E4_multiplier_py + constraints_multipliers_75;

    /* phi: udot */
    /* udot: phi.udot [rad/s^2] */
    out[4] = constraints_multipliers_89 * E4_multiplier_px
        + constraints_multipliers_93 * E4_multiplier_py + constraints_multipliers_78;

    /* epsilon: udot */
    /* udot: epsilon.udot [rad/s^2] */
    out[5] = constraints_multipliers_95 * E6_multiplier_px
        + constraints_multipliers_99 * E6_multiplier_py + constraints_multipliers_76;

    /* omega: udot */
    /* udot: omega.udot [rad/s^2] */
    out[6] = constraints_multipliers_97 * E6_multiplier_px
        + constraints_multipliers_101 * E6_multiplier_py + constraints_multipliers_79;
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {7, 75, 32, 0, 7, 7, 0, 0, 0, 58, 0, 0, 0, 0, 7, 0, 0, 0, 0};
#endif
