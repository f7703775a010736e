/*
 * forward_dynamics of change_points
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: parallel, base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 5, work 38, w 15
 * Operations per call: 468 = 279 mul, 90 sub, 84 add, 5 cos, 5 sin, 2 div, 2 neg, 1 solve
 * Operations of prepare: 26 = 14 mul, 9 add, 3 div
 *
 * Input q (5): generalized coordinates
 *   q[0]  A0 [rad]
 *   q[1]  A1 [rad]
 *   q[2]  A2 [rad]
 *   q[3]  B0 [rad]
 *   q[4]  B1 [rad]
 *
 * Input u (5): generalized speeds
 *   u[0]  A0.u [rad/s]
 *   u[1]  A1.u [rad/s]
 *   u[2]  A2.u [rad/s]
 *   u[3]  B0.u [rad/s]
 *   u[4]  B1.u [rad/s]
 *
 * Input p (28): parameters, read by prepare_ only
 *
 * Input tau (5): applied generalized forces
 *   tau[0]  A0.u.tau [N*m]
 *   tau[1]  A1.u.tau [N*m]
 *   tau[2]  A2.u.tau [N*m]
 *   tau[3]  B0.u.tau [N*m]
 *   tau[4]  B1.u.tau [N*m]
 *
 * Output udot (5)
 *   out[0]  A0.udot [rad/s^2]
 *   out[1]  A1.udot [rad/s^2]
 *   out[2]  A2.udot [rad/s^2]
 *   out[3]  B0.udot [rad/s^2]
 *   out[4]  B1.udot [rad/s^2]
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* crank0: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal crank0_mass = p[0]; /* kg */
    const wreal crank0_com_x = p[1]; /* m */
    const wreal crank0_inertia_zz = p[3]; /* kg m^2 */
    const wreal B0_position_x = p[14]; /* m */
    const wreal coupler0_mass = p[15]; /* kg */
    const wreal crank0_first_moment_x = crank0_mass * crank0_com_x;
    const wreal crank0_origin_inertia_zz = crank0_inertia_zz + crank0_com_x * crank0_first_moment_x;
    const wreal crank0_base_inertia_zz = crank0_origin_inertia_zz
        + B0_position_x * coupler0_mass * B0_position_x;

    /* crank1: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal crank1_mass = p[5]; /* kg */
    const wreal crank1_com_x = p[6]; /* m */
    const wreal crank1_inertia_zz = p[8]; /* kg m^2 */
    const wreal B1_position_x = p[19]; /* m */
    const wreal coupler1_mass = p[20]; /* kg */
    const wreal crank1_first_moment_x = crank1_mass * crank1_com_x;
    const wreal crank1_origin_inertia_zz = crank1_inertia_zz + crank1_com_x * crank1_first_moment_x;
    const wreal crank1_base_inertia_zz = crank1_origin_inertia_zz
        + B1_position_x * coupler1_mass * B1_position_x;

    /* crank2: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal crank2_mass = p[10]; /* kg */
    const wreal crank2_com_x = p[11]; /* m */
    const wreal crank2_inertia_zz = p[13]; /* kg m^2 */
    const wreal crank2_first_moment_x = crank2_mass * crank2_com_x;
    const wreal crank2_origin_inertia_zz = crank2_inertia_zz + crank2_com_x * crank2_first_moment_x;

    /* coupler0: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal coupler0_com_x = p[16]; /* m */
    const wreal coupler0_inertia_zz = p[18]; /* kg m^2 */
    const wreal coupler0_first_moment_x = coupler0_mass * coupler0_com_x;
    const wreal coupler0_origin_inertia_zz = coupler0_inertia_zz
        + coupler0_com_x * coupler0_first_moment_x;
    w[3] = coupler0_first_moment_x;
    w[4] = coupler0_origin_inertia_zz;

    /* coupler1: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal coupler1_com_x = p[21]; /* m */
    const wreal coupler1_inertia_zz = p[23]; /* kg m^2 */
    const wreal coupler1_first_moment_x = coupler1_mass * coupler1_com_x;
    const wreal coupler1_origin_inertia_zz = coupler1_inertia_zz
        + coupler1_com_x * coupler1_first_moment_x;
    w[6] = coupler1_first_moment_x;
    w[7] = coupler1_origin_inertia_zz;

    /* crank1: inertia */
    const wreal coupler1_origin_inertia_zz_plus_crank1_base_inertia_zz = coupler1_origin_inertia_zz
        + crank1_base_inertia_zz;
    w[10] = coupler1_origin_inertia_zz_plus_crank1_base_inertia_zz;

    /* crank0: inertia */
    const wreal coupler0_origin_inertia_zz_plus_crank0_base_inertia_zz = coupler0_origin_inertia_zz
        + crank0_base_inertia_zz;
    w[11] = coupler0_origin_inertia_zz_plus_crank0_base_inertia_zz;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal M_factor_D_inverse_B1 = 1.0 / coupler1_origin_inertia_zz;
    const wreal M_factor_D_inverse_B0 = 1.0 / coupler0_origin_inertia_zz;
    const wreal M_factor_D_inverse_A2 = 1.0 / crank2_origin_inertia_zz;
    w[12] = M_factor_D_inverse_B1;
    w[13] = M_factor_D_inverse_B0;
    w[14] = M_factor_D_inverse_A2;

    /* parameters as they are */
    w[0] = p[4]; /* A1.position.x [m] */
    w[1] = p[9]; /* A2.position.x [m] */
    w[2] = p[14]; /* B0.position.x [m] */
    w[5] = p[19]; /* B1.position.x [m] */
    w[8] = p[25]; /* C0.child.position.x [m] */
    w[9] = p[27]; /* C1.child.position.x [m] */
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
    real (*const circuit_matrix)[4] = (real (*)[4])(work + 0);
    real *const circuit_right = work + 16;
    real *const circuit_scratch = work + 20;
    int status = CARDAN_OK;

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real A0_q = q[0]; /* rad */
    const real A1_q = q[1]; /* rad */
    const real A2_q = q[2]; /* rad */
    const real B0_q = q[3]; /* rad */
    const real B1_q = q[4]; /* rad */
    const real B0_turn = A0_q + B0_q;
    const real B1_turn = A1_q + B1_q;
    const real angle[CARDAN_PADDED(5)] = {A0_q, A1_q, B0_turn, A2_q, B1_turn};
    real sine[CARDAN_PADDED(5)], cosine[CARDAN_PADDED(5)];
    cardan_sincos(5, angle, sine, cosine);
    const real A0_cos = cosine[0];
    const real A0_sin = sine[0];
    const real A1_cos = cosine[1];
    const real A1_sin = sine[1];
    const real B0_turn_cos = cosine[2];
    const real B0_turn_sin = sine[2];
    const real A2_cos = cosine[3];
    const real A2_sin = sine[3];
    const real B1_turn_cos = cosine[4];
    const real B1_turn_sin = sine[4];

    /* B0: p */
    /* p = p_fixed + R_fixed p_joint(q) */
    const wreal B0_position_x = w[2]; /* m */
    const real B0_p_x = B0_position_x * A0_cos;
    const real B0_p_y = B0_position_x * A0_sin;

    /* C0: pose, twist, G */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* G = d(rate) / du */
    const real A0_u = u[0]; /* rad/s */
    const real A1_u = u[1]; /* rad/s */
    const real B0_u = u[3]; /* rad/s */
    const wreal A1_position_x = w[0]; /* m */
    const wreal C0_child_position_x = w[8]; /* m */
    const real C0_child_p_y = C0_child_position_x * A1_sin;
    const real C0_child_p_x = A1_position_x + C0_child_position_x * A1_cos;
    const real C0_R_xx = A1_cos * B0_turn_cos + A1_sin * B0_turn_sin;
    const real C0_R_xy = A1_cos * B0_turn_sin - A1_sin * B0_turn_cos;
    const real C0_arm_A1_x = C0_child_p_x - A1_position_x;
    const real C0_arm_B0_x = C0_child_p_x - B0_p_x;
    const real C0_arm_B0_y = C0_child_p_y - B0_p_y;
    const real C0_base_twist_vx = A0_u * C0_child_p_y - A1_u * C0_child_p_y + B0_u * C0_arm_B0_y;
    const real C0_base_twist_vy = A1_u * C0_arm_A1_x - A0_u * C0_child_p_x - B0_u * C0_arm_B0_x;
    const real A1_cos_times_C0_child_p_y = A1_cos * C0_child_p_y;
    const real C0_twist_A0_vx = A1_cos_times_C0_child_p_y - A1_sin * C0_child_p_x;
    const real A1_sin_times_C0_child_p_y = A1_sin * C0_child_p_y;
    const real C0_minus_twist_A0_vy = A1_sin_times_C0_child_p_y + A1_cos * C0_child_p_x;
    const real C0_twist_A1_vx = A1_sin * C0_arm_A1_x - A1_cos_times_C0_child_p_y;
    const real C0_twist_A1_vy = A1_sin_times_C0_child_p_y + A1_cos * C0_arm_A1_x;
    const real C0_twist_B0_vx = A1_cos * C0_arm_B0_y - A1_sin * C0_arm_B0_x;
    const real C0_minus_twist_B0_vy = A1_sin * C0_arm_B0_y + A1_cos * C0_arm_B0_x;
    const real C0_twist_vx = A1_cos * C0_base_twist_vx + A1_sin * C0_base_twist_vy;
    const real C0_twist_vy = A1_cos * C0_base_twist_vy - A1_sin * C0_base_twist_vx;
    const real C0_G_px_A0 = C0_R_xx * C0_twist_A0_vx - C0_R_xy * C0_minus_twist_A0_vy;
    const real C0_G_px_A1 = C0_R_xx * C0_twist_A1_vx + C0_R_xy * C0_twist_A1_vy;
    const real C0_G_px_B0 = C0_R_xx * C0_twist_B0_vx - C0_R_xy * C0_minus_twist_B0_vy;
    const real C0_minus_G_py_A0 = C0_R_xy * C0_twist_A0_vx + C0_R_xx * C0_minus_twist_A0_vy;
    const real C0_G_py_A1 = C0_R_xx * C0_twist_A1_vy - C0_R_xy * C0_twist_A1_vx;
    const real C0_minus_G_py_B0 = C0_R_xy * C0_twist_B0_vx + C0_R_xx * C0_minus_twist_B0_vy;

    /* B1: p */
    /* p = p_fixed + R_fixed p_joint(q) */
    const wreal B1_position_x = w[5]; /* m */
    const real B1_p_x = B1_position_x * A1_cos;
    const real B1_p_y = B1_position_x * A1_sin;

    /* C1: pose, twist, G */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* G = d(rate) / du */
    const real A2_u = u[2]; /* rad/s */
    const real B1_u = u[4]; /* rad/s */
    const wreal A2_position_x = w[1]; /* m */
    const wreal C1_child_position_x = w[9]; /* m */
    const real C1_child_p_y = C1_child_position_x * A2_sin;
    const real C1_child_p_x = A2_position_x + C1_child_position_x * A2_cos;
    const real C1_R_xx = A2_cos * B1_turn_cos + A2_sin * B1_turn_sin;
    const real C1_R_xy = A2_cos * B1_turn_sin - A2_sin * B1_turn_cos;
    const real C1_arm_A1_x = C1_child_p_x - A1_position_x;
    const real C1_arm_A2_x = C1_child_p_x - A2_position_x;
    const real C1_arm_B1_x = C1_child_p_x - (A1_position_x + B1_p_x);
    const real C1_arm_B1_y = C1_child_p_y - B1_p_y;
    const real C1_base_twist_vx = A1_u * C1_child_p_y - A2_u * C1_child_p_y + B1_u * C1_arm_B1_y;
    const real C1_base_twist_vy = A2_u * C1_arm_A2_x - A1_u * C1_arm_A1_x - B1_u * C1_arm_B1_x;
    const real A2_cos_times_C1_child_p_y = A2_cos * C1_child_p_y;
    const real C1_twist_A1_vx = A2_cos_times_C1_child_p_y - A2_sin * C1_arm_A1_x;
    const real A2_sin_times_C1_child_p_y = A2_sin * C1_child_p_y;
    const real C1_minus_twist_A1_vy = A2_sin_times_C1_child_p_y + A2_cos * C1_arm_A1_x;
    const real C1_twist_A2_vx = A2_sin * C1_arm_A2_x - A2_cos_times_C1_child_p_y;
    const real C1_twist_A2_vy = A2_sin_times_C1_child_p_y + A2_cos * C1_arm_A2_x;
    const real C1_twist_B1_vx = A2_cos * C1_arm_B1_y - A2_sin * C1_arm_B1_x;
    const real C1_minus_twist_B1_vy = A2_sin * C1_arm_B1_y + A2_cos * C1_arm_B1_x;
    const real C1_twist_vx = A2_cos * C1_base_twist_vx + A2_sin * C1_base_twist_vy;
    const real C1_twist_vy = A2_cos * C1_base_twist_vy - A2_sin * C1_base_twist_vx;
    const real C1_G_px_A1 = C1_R_xx * C1_twist_A1_vx - C1_R_xy * C1_minus_twist_A1_vy;
    const real C1_G_px_A2 = C1_R_xx * C1_twist_A2_vx + C1_R_xy * C1_twist_A2_vy;
    const real C1_G_px_B1 = C1_R_xx * C1_twist_B1_vx - C1_R_xy * C1_minus_twist_B1_vy;
    const real C1_minus_G_py_A1 = C1_R_xy * C1_twist_A1_vx + C1_R_xx * C1_minus_twist_A1_vy;
    const real C1_G_py_A2 = C1_R_xx * C1_twist_A2_vy - C1_R_xy * C1_twist_A2_vx;
    const real C1_minus_G_py_B1 = C1_R_xy * C1_twist_B1_vx + C1_R_xx * C1_minus_twist_B1_vy;

    /* shared by several: inertia */
    const wreal coupler0_first_moment_x = w[3];
    const wreal coupler1_first_moment_x = w[6];
    const real crank1_inertia_shift_part = coupler1_first_moment_x * B1_turn_cos * B1_p_x
        + coupler1_first_moment_x * B1_turn_sin * B1_p_y;
    const real crank0_inertia_shift_part = coupler0_first_moment_x * B0_turn_cos * B0_p_x
        + coupler0_first_moment_x * B0_turn_sin * B0_p_y;

    /* crank1: composite, U */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* U = [alpha] + [omega][omega] */
    const wreal coupler1_origin_inertia_zz_plus_crank1_base_inertia_zz = w[10];
    const real crank1_composite_inertia_zz = 2.0 * crank1_inertia_shift_part
        + coupler1_origin_inertia_zz_plus_crank1_base_inertia_zz;
    const real crank1_minus_U_xx = A1_u * A1_u;

    /* crank0: composite, U */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* U = [alpha] + [omega][omega] */
    const wreal coupler0_origin_inertia_zz_plus_crank0_base_inertia_zz = w[11];
    const real crank0_composite_inertia_zz = 2.0 * crank0_inertia_shift_part
        + coupler0_origin_inertia_zz_plus_crank0_base_inertia_zz;
    const real crank0_minus_U_xx = A0_u * A0_u;

    /* M */
    /* M = S . momentum */
    const wreal coupler0_origin_inertia_zz = w[4];
    const wreal coupler1_origin_inertia_zz = w[7];
    const real M_B1_A1 = coupler1_origin_inertia_zz + crank1_inertia_shift_part;
    const real M_B0_A0 = coupler0_origin_inertia_zz + crank0_inertia_shift_part;

    /* coupler0: omega, a, n, inertia force */
    /* omega = Rᵀ omega_parent + S_w u */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const real coupler0_omega_z = A0_u + B0_u;
    const real coupler0_a_y = B0_p_x * crank0_minus_U_xx * B0_turn_sin
        - B0_p_y * crank0_minus_U_xx * B0_turn_cos;
    const real coupler0_n_z = coupler0_first_moment_x * coupler0_a_y;
    const real coupler0_minus_f_x = coupler0_omega_z * coupler0_omega_z * coupler0_first_moment_x;

    /* coupler1: omega, a, n, inertia force */
    /* omega = Rᵀ omega_parent + S_w u */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const real coupler1_omega_z = A1_u + B1_u;
    const real coupler1_a_y = B1_p_x * crank1_minus_U_xx * B1_turn_sin
        - B1_p_y * crank1_minus_U_xx * B1_turn_cos;
    const real coupler1_n_z = coupler1_first_moment_x * coupler1_a_y;
    const real coupler1_minus_f_x = coupler1_omega_z * coupler1_omega_z * coupler1_first_moment_x;

    /* crank1: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real crank1_n_z = B1_turn_cos * coupler1_minus_f_x * B1_p_y
        - B1_turn_sin * coupler1_minus_f_x * B1_p_x + coupler1_n_z;

    /* crank0: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real crank0_n_z = B0_turn_cos * coupler0_minus_f_x * B0_p_y
        - B0_turn_sin * coupler0_minus_f_x * B0_p_x + coupler0_n_z;

    /* A0: drive */
    /* drive = tau + f - h */
    const real A0_u_tau = tau[0]; /* N*m */
    const real A0_drive = A0_u_tau - crank0_n_z;

    /* A1: drive, R */
    /* drive = tau + f - h */
    /* R = R_fixed R_joint(q) */
    const real A1_u_tau = tau[1]; /* N*m */
    const real A1_drive = A1_u_tau - crank1_n_z;
    const real A1_u_times_sin = A1_u * A1_sin;
    const real A1_u_times_cos = A1_u * A1_cos;

    /* B0: drive, R */
    /* drive = tau + f - h */
    /* R = R_fixed R_joint(q) */
    const real B0_u_tau = tau[3]; /* N*m */
    const real B0_drive = B0_u_tau - coupler0_n_z;
    const real B0_turn_sin_times_coupler0_omega_z = B0_turn_sin * coupler0_omega_z;
    const real B0_turn_cos_times_coupler0_omega_z = B0_turn_cos * coupler0_omega_z;

    /* B1: drive, R */
    /* drive = tau + f - h */
    /* R = R_fixed R_joint(q) */
    const real B1_u_tau = tau[4]; /* N*m */
    const real B1_drive = B1_u_tau - coupler1_n_z;
    const real B1_turn_sin_times_coupler1_omega_z = B1_turn_sin * coupler1_omega_z;
    const real B1_turn_cos_times_coupler1_omega_z = B1_turn_cos * coupler1_omega_z;

    /* C0: pose, twist, gamma */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* gamma = -d(rate)/dt at udot = 0 */
    const real C0_minus_child_p_x_rate = C0_child_position_x * A1_u_times_sin;
    const real C0_child_p_y_rate = C0_child_position_x * A1_u_times_cos;
    const real C0_R_xx_rate = B0_turn_sin * A1_u_times_cos - B0_turn_cos * A1_u_times_sin
        + (A1_sin * B0_turn_cos_times_coupler0_omega_z
        - A1_cos * B0_turn_sin_times_coupler0_omega_z);
    const real C0_R_xy_rate = A1_sin * B0_turn_sin_times_coupler0_omega_z
        + A1_cos * B0_turn_cos_times_coupler0_omega_z - (B0_turn_cos * A1_u_times_cos
        + B0_turn_sin * A1_u_times_sin);
    const real C0_base_twist_vx_rate = A0_u * C0_child_p_y_rate - A1_u * C0_child_p_y_rate
        + B0_u * (C0_child_p_y_rate - A0_u * A0_cos * B0_position_x);
    const real C0_base_twist_vy_rate = A0_u * C0_minus_child_p_x_rate
        - A1_u * C0_minus_child_p_x_rate - B0_u * (A0_u * A0_sin * B0_position_x
        - C0_minus_child_p_x_rate);
    const real C0_twist_vx_rate = A1_cos * C0_base_twist_vx_rate
        - C0_base_twist_vx * A1_u_times_sin + (C0_base_twist_vy * A1_u_times_cos
        + A1_sin * C0_base_twist_vy_rate);
    const real C0_twist_vy_rate = A1_cos * C0_base_twist_vy_rate
        - C0_base_twist_vx * A1_u_times_cos - (A1_sin * C0_base_twist_vx_rate
        + C0_base_twist_vy * A1_u_times_sin);
    const real C0_gamma_py = C0_twist_vx * C0_R_xy_rate - C0_twist_vy * C0_R_xx_rate
        + (C0_R_xy * C0_twist_vx_rate - C0_R_xx * C0_twist_vy_rate);

    /* A2: R */
    /* R = R_fixed R_joint(q) */
    const real A2_u_times_sin = A2_u * A2_sin;
    const real A2_u_times_cos = A2_u * A2_cos;

    /* C1: pose, twist, gamma */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* gamma = -d(rate)/dt at udot = 0 */
    const real C1_minus_child_p_x_rate = C1_child_position_x * A2_u_times_sin;
    const real C1_child_p_y_rate = C1_child_position_x * A2_u_times_cos;
    const real C1_R_xx_rate = B1_turn_sin * A2_u_times_cos - B1_turn_cos * A2_u_times_sin
        + (A2_sin * B1_turn_cos_times_coupler1_omega_z
        - A2_cos * B1_turn_sin_times_coupler1_omega_z);
    const real C1_R_xy_rate = A2_sin * B1_turn_sin_times_coupler1_omega_z
        + A2_cos * B1_turn_cos_times_coupler1_omega_z - (B1_turn_cos * A2_u_times_cos
        + B1_turn_sin * A2_u_times_sin);
    const real C1_base_twist_vx_rate = A1_u * C1_child_p_y_rate - A2_u * C1_child_p_y_rate
        + B1_u * (C1_child_p_y_rate - B1_position_x * A1_u_times_cos);
    const real C1_base_twist_vy_rate = A1_u * C1_minus_child_p_x_rate
        - A2_u * C1_minus_child_p_x_rate - B1_u * (B1_position_x * A1_u_times_sin
        - C1_minus_child_p_x_rate);
    const real C1_twist_vx_rate = A2_cos * C1_base_twist_vx_rate
        - C1_base_twist_vx * A2_u_times_sin + (C1_base_twist_vy * A2_u_times_cos
        + A2_sin * C1_base_twist_vy_rate);
    const real C1_twist_vy_rate = A2_cos * C1_base_twist_vy_rate
        - C1_base_twist_vx * A2_u_times_cos - (A2_sin * C1_base_twist_vx_rate
        + C1_base_twist_vy * A2_u_times_sin);
    const real C1_gamma_py = C1_twist_vx * C1_R_xy_rate - C1_twist_vy * C1_R_xx_rate
        + (C1_R_xy * C1_twist_vx_rate - C1_R_xx * C1_twist_vy_rate);

    /* constraints: factor, multipliers */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const real A2_u_tau = tau[2]; /* N*m */
    const wreal M_factor_D_inverse_B1 = w[12];
    const wreal M_factor_D_inverse_B0 = w[13];
    const wreal M_factor_D_inverse_A2 = w[14];
    const real M_factor_L_B1_A1 = M_B1_A1 * M_factor_D_inverse_B1;
    const real M_factor_L_B0_A0 = M_B0_A0 * M_factor_D_inverse_B0;
    const real M_factor_D_inverse_A1 = 1.0 / (crank1_composite_inertia_zz
        - M_B1_A1 * M_factor_L_B1_A1);
    const real M_factor_D_inverse_A0 = 1.0 / (crank0_composite_inertia_zz
        - M_B0_A0 * M_factor_L_B0_A0);
    const real free_udot_A0 = M_factor_D_inverse_A0 * (A0_drive - B0_drive * M_factor_L_B0_A0);
    const real free_udot_A1 = M_factor_D_inverse_A1 * (A1_drive - B1_drive * M_factor_L_B1_A1);
    const real free_udot_A2 = A2_u_tau * M_factor_D_inverse_A2;
    const real free_udot_B0 = B0_drive * M_factor_D_inverse_B0 - M_factor_L_B0_A0 * free_udot_A0;
    const real free_udot_B1 = B1_drive * M_factor_D_inverse_B1 - M_factor_L_B1_A1 * free_udot_A1;
    const real C0_px_response_A0 = M_factor_D_inverse_A0 * (C0_G_px_A0
        - C0_G_px_B0 * M_factor_L_B0_A0);
    const real C0_px_response_A1 = C0_G_px_A1 * M_factor_D_inverse_A1;
    const real C0_px_response_B0 = C0_G_px_B0 * M_factor_D_inverse_B0
        - M_factor_L_B0_A0 * C0_px_response_A0;
    const real C0_px_minus_response_B1 = M_factor_L_B1_A1 * C0_px_response_A1;
    const real C0_py_response_A0 = M_factor_D_inverse_A0 * (C0_minus_G_py_B0 * M_factor_L_B0_A0
        - C0_minus_G_py_A0);
    const real C0_py_response_A1 = C0_G_py_A1 * M_factor_D_inverse_A1;
    const real C0_py_minus_response_B0 = C0_minus_G_py_B0 * M_factor_D_inverse_B0
        + M_factor_L_B0_A0 * C0_py_response_A0;
    const real C0_py_minus_response_B1 = M_factor_L_B1_A1 * C0_py_response_A1;
    const real C1_px_response_A1 = M_factor_D_inverse_A1 * (C1_G_px_A1
        - C1_G_px_B1 * M_factor_L_B1_A1);
    const real C1_px_response_A2 = C1_G_px_A2 * M_factor_D_inverse_A2;
    const real C1_px_response_B1 = C1_G_px_B1 * M_factor_D_inverse_B1
        - M_factor_L_B1_A1 * C1_px_response_A1;
    const real C1_py_response_A1 = M_factor_D_inverse_A1 * (C1_minus_G_py_B1 * M_factor_L_B1_A1
        - C1_minus_G_py_A1);
    const real C1_py_response_A2 = C1_G_py_A2 * M_factor_D_inverse_A2;
    const real C1_py_minus_response_B1 = C1_minus_G_py_B1 * M_factor_D_inverse_B1
        + M_factor_L_B1_A1 * C1_py_response_A1;
    const real circuit_C0_px_C0_px = C0_G_px_A0 * C0_px_response_A0
        + C0_G_px_A1 * C0_px_response_A1 + C0_G_px_B0 * C0_px_response_B0;
    circuit_matrix[0][0] = circuit_C0_px_C0_px;
    const real circuit_C0_py_C0_px = C0_G_py_A1 * C0_px_response_A1
        - C0_minus_G_py_A0 * C0_px_response_A0 - C0_minus_G_py_B0 * C0_px_response_B0;
    circuit_matrix[0][1] = circuit_C0_py_C0_px;
    circuit_matrix[1][0] = circuit_C0_py_C0_px;
    const real circuit_C0_py_C0_py = C0_G_py_A1 * C0_py_response_A1
        - C0_minus_G_py_A0 * C0_py_response_A0 + C0_minus_G_py_B0 * C0_py_minus_response_B0;
    circuit_matrix[1][1] = circuit_C0_py_C0_py;
    const real circuit_C1_px_C0_px = C1_G_px_A1 * C0_px_response_A1
        - C1_G_px_B1 * C0_px_minus_response_B1;
    circuit_matrix[0][2] = circuit_C1_px_C0_px;
    circuit_matrix[2][0] = circuit_C1_px_C0_px;
    const real circuit_C1_px_C0_py = C1_G_px_A1 * C0_py_response_A1
        - C1_G_px_B1 * C0_py_minus_response_B1;
    circuit_matrix[1][2] = circuit_C1_px_C0_py;
    circuit_matrix[2][1] = circuit_C1_px_C0_py;
    const real circuit_C1_px_C1_px = C1_G_px_A1 * C1_px_response_A1
        + C1_G_px_A2 * C1_px_response_A2 + C1_G_px_B1 * C1_px_response_B1;
    circuit_matrix[2][2] = circuit_C1_px_C1_px;
    const real circuit_C1_py_C0_px = C1_minus_G_py_B1 * C0_px_minus_response_B1
        - C1_minus_G_py_A1 * C0_px_response_A1;
    circuit_matrix[0][3] = circuit_C1_py_C0_px;
    circuit_matrix[3][0] = circuit_C1_py_C0_px;
    const real circuit_C1_py_C0_py = C1_minus_G_py_B1 * C0_py_minus_response_B1
        - C1_minus_G_py_A1 * C0_py_response_A1;
    circuit_matrix[1][3] = circuit_C1_py_C0_py;
    circuit_matrix[3][1] = circuit_C1_py_C0_py;
    const real circuit_C1_py_C1_px = C1_G_py_A2 * C1_px_response_A2
        - C1_minus_G_py_A1 * C1_px_response_A1 - C1_minus_G_py_B1 * C1_px_response_B1;
    circuit_matrix[2][3] = circuit_C1_py_C1_px;
    circuit_matrix[3][2] = circuit_C1_py_C1_px;
    const real circuit_C1_py_C1_py = C1_G_py_A2 * C1_py_response_A2
        - C1_minus_G_py_A1 * C1_py_response_A1 + C1_minus_G_py_B1 * C1_py_minus_response_B1;
    circuit_matrix[3][3] = circuit_C1_py_C1_py;
    const real free_gamma_C0_px = -(C0_twist_vx * C0_R_xx_rate + C0_twist_vy * C0_R_xy_rate
        + (C0_R_xx * C0_twist_vx_rate + C0_R_xy * C0_twist_vy_rate) + C0_G_px_A0 * free_udot_A0
        + C0_G_px_A1 * free_udot_A1 + C0_G_px_B0 * free_udot_B0);
    circuit_right[0] = free_gamma_C0_px;
    const real free_gamma_C0_py = C0_gamma_py - C0_G_py_A1 * free_udot_A1
        + C0_minus_G_py_A0 * free_udot_A0 + C0_minus_G_py_B0 * free_udot_B0;
    circuit_right[1] = free_gamma_C0_py;
    const real free_gamma_C1_px = -(C1_R_xx * C1_twist_vx_rate + C1_twist_vy * C1_R_xy_rate
        + (C1_twist_vx * C1_R_xx_rate + C1_G_px_A2 * free_udot_A2 + C1_R_xy * C1_twist_vy_rate)
        + C1_G_px_A1 * free_udot_A1 + C1_G_px_B1 * free_udot_B1);
    circuit_right[2] = free_gamma_C1_px;
    const real free_gamma_C1_py = C1_gamma_py - C1_G_py_A2 * free_udot_A2
        + C1_minus_G_py_A1 * free_udot_A1 + C1_minus_G_py_B1 * free_udot_B1;
    circuit_right[3] = free_gamma_C1_py;
    /* circuit_matrix lam = circuit_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 4, 1, circuit_matrix[0], circuit_right, circuit_scratch);

    /* C0: multiplier px, multiplier py */
    const real C0_multiplier_px = circuit_right[0];
    const real C0_multiplier_py = circuit_right[1];

    /* C1: multiplier px, multiplier py */
    const real C1_multiplier_px = circuit_right[2];
    const real C1_multiplier_py = circuit_right[3];

    /* A0: udot */
    /* udot = free_udot + response multipliers */
    /* udot: A0.udot [rad/s^2] */
    out[0] = free_udot_A0 + C0_px_response_A0 * C0_multiplier_px
        + C0_py_response_A0 * C0_multiplier_py;

    /* A1: udot */
    /* udot = free_udot + response multipliers */
    /* udot: A1.udot [rad/s^2] */
    out[1] = C0_py_response_A1 * C0_multiplier_py + C1_px_response_A1 * C1_multiplier_px
        + (free_udot_A1 + C0_px_response_A1 * C0_multiplier_px
        + C1_py_response_A1 * C1_multiplier_py);

    /* A2: udot */
    /* udot = free_udot + response multipliers */
    /* udot: A2.udot [rad/s^2] */
    out[2] = free_udot_A2 + C1_px_response_A2 * C1_multiplier_px
        + C1_py_response_A2 * C1_multiplier_py;

    /* B0: udot */
    /* udot = free_udot + response multipliers */
    /* udot: B0.udot [rad/s^2] */
    out[3] = free_udot_B0 + C0_px_response_B0 * C0_multiplier_px
        - C0_py_minus_response_B0 * C0_multiplier_py;

    /* B1: udot */
    /* udot = free_udot + response multipliers */
    /* udot: B1.udot [rad/s^2] */
    out[4] = free_udot_B1 + C1_px_response_B1 * C1_multiplier_px
        - C1_py_minus_response_B1 * C1_multiplier_py
        - (C0_px_minus_response_B1 * C0_multiplier_px + C0_py_minus_response_B1 * C0_multiplier_py);
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {5, 38, 15, 0, 5, 5, 0, 0, 0, 28, 0, 0, 0, 0, 5, 0, 0, 0, 0, 0};
#endif
