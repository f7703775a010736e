/*
 * forward_dynamics of four_bar
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: parallel, base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 3, work 13, w 11
 * Operations per call: 233 = 139 mul, 45 sub, 41 add, 3 cos, 3 sin, 1 div, 1 solve
 * Operations of prepare: 16 = 8 mul, 6 add, 2 div
 *
 * Input q (3): generalized coordinates
 *   q[0]  A [rad]
 *   q[1]  B [rad]
 *   q[2]  D [rad]
 *
 * Input u (3): generalized speeds
 *   u[0]  A.u [rad/s]
 *   u[1]  B.u [rad/s]
 *   u[2]  D.u [rad/s]
 *
 * Input p (20): parameters, read by prepare_ only
 *
 * Input tau (3): applied generalized forces
 *   tau[0]  A.u.tau [N*m]
 *   tau[1]  B.u.tau [N*m]
 *   tau[2]  D.u.tau [N*m]
 *
 * Output udot (3)
 *   out[0]  A.udot [rad/s^2]
 *   out[1]  B.udot [rad/s^2]
 *   out[2]  D.udot [rad/s^2]
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* crank: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal crank_mass = p[1]; /* kg */
    const wreal crank_com_x = p[2]; /* m */
    const wreal crank_inertia_zz = p[5]; /* kg m^2 */
    const wreal crank_first_moment_x = crank_mass * crank_com_x;
    const wreal crank_origin_inertia_zz = crank_inertia_zz + crank_com_x * crank_first_moment_x;

    /* coupler: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal B_position_x = p[6]; /* m */
    const wreal coupler_mass = p[7]; /* kg */
    const wreal coupler_com_x = p[8]; /* m */
    const wreal coupler_inertia_zz = p[11]; /* kg m^2 */
    const wreal coupler_first_moment_x = coupler_mass * coupler_com_x;
    const wreal coupler_origin_inertia_zz = coupler_inertia_zz
        + coupler_com_x * coupler_first_moment_x;
    const wreal coupler_base_mass_moment_x = B_position_x * coupler_mass;
    w[2] = coupler_first_moment_x;
    w[3] = coupler_origin_inertia_zz;

    /* rocker: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal rocker_mass = p[13]; /* kg */
    const wreal rocker_com_x = p[14]; /* m */
    const wreal rocker_inertia_zz = p[17]; /* kg m^2 */
    const wreal rocker_first_moment_x = rocker_mass * rocker_com_x;
    const wreal rocker_origin_inertia_zz = rocker_inertia_zz + rocker_com_x * rocker_first_moment_x;
    w[5] = rocker_first_moment_x;

    /* crank: base, inertia */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal crank_base_moment_x = crank_first_moment_x + coupler_base_mass_moment_x;
    const wreal crank_base_inertia_zz = crank_origin_inertia_zz
        + B_position_x * coupler_base_mass_moment_x;
    const wreal coupler_origin_inertia_zz_plus_crank_base_inertia_zz = coupler_origin_inertia_zz
        + crank_base_inertia_zz;
    w[7] = crank_base_moment_x;
    w[8] = coupler_origin_inertia_zz_plus_crank_base_inertia_zz;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal M_factor_D_inverse_D = 1.0 / rocker_origin_inertia_zz;
    const wreal M_factor_D_inverse_B = 1.0 / coupler_origin_inertia_zz;
    w[9] = M_factor_D_inverse_D;
    w[10] = M_factor_D_inverse_B;

    /* parameters as they are */
    w[0] = p[0]; /* gravity.y [m/s^2] */
    w[1] = p[6]; /* B.position.x [m] */
    w[4] = p[12]; /* D.position.x [m] */
    w[6] = p[19]; /* C.child.position.x [m] */
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
    real (*const circuit_matrix)[2] = (real (*)[2])(work + 0);
    real *const circuit_right = work + 4;
    real *const circuit_scratch = work + 6;
    int status = CARDAN_OK;

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real A_q = q[0]; /* rad */
    const real B_q = q[1]; /* rad */
    const real D_q = q[2]; /* rad */
    const real B_turn = A_q + B_q;
    const real angle[CARDAN_PADDED(3)] = {A_q, B_turn, D_q};
    real sine[CARDAN_PADDED(3)], cosine[CARDAN_PADDED(3)];
    cardan_sincos(3, angle, sine, cosine);
    const real A_cos = cosine[0];
    const real A_sin = sine[0];
    const real B_turn_cos = cosine[1];
    const real B_turn_sin = sine[1];
    const real D_cos = cosine[2];
    const real D_sin = sine[2];

    /* B: p */
    /* p = p_fixed + R_fixed p_joint(q) */
    const wreal B_position_x = w[1]; /* m */
    const real B_p_x = B_position_x * A_cos;
    const real B_p_y = B_position_x * A_sin;

    /* C: pose, twist, G */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* G = d(rate) / du */
    const real A_u = u[0]; /* rad/s */
    const real B_u = u[1]; /* rad/s */
    const real D_u = u[2]; /* rad/s */
    const wreal D_position_x = w[4]; /* m */
    const wreal C_child_position_x = w[6]; /* m */
    const real C_child_p_y = C_child_position_x * D_sin;
    const real C_child_p_x = D_position_x + C_child_position_x * D_cos;
    const real C_R_xx = B_turn_cos * D_cos + B_turn_sin * D_sin;
    const real C_R_xy = B_turn_sin * D_cos - B_turn_cos * D_sin;
    const real C_arm_B_x = C_child_p_x - B_p_x;
    const real C_arm_B_y = C_child_p_y - B_p_y;
    const real C_arm_D_x = C_child_p_x - D_position_x;
    const real C_base_twist_vx = A_u * C_child_p_y - D_u * C_child_p_y + B_u * C_arm_B_y;
    const real C_base_twist_vy = D_u * C_arm_D_x - A_u * C_child_p_x - B_u * C_arm_B_x;
    const real D_cos_times_C_child_p_y = D_cos * C_child_p_y;
    const real C_twist_A_vx = D_cos_times_C_child_p_y - D_sin * C_child_p_x;
    const real D_sin_times_C_child_p_y = D_sin * C_child_p_y;
    const real C_minus_twist_A_vy = D_sin_times_C_child_p_y + D_cos * C_child_p_x;
    const real C_twist_B_vx = D_cos * C_arm_B_y - D_sin * C_arm_B_x;
    const real C_minus_twist_B_vy = D_sin * C_arm_B_y + D_cos * C_arm_B_x;
    const real C_twist_D_vx = D_sin * C_arm_D_x - D_cos_times_C_child_p_y;
    const real C_twist_D_vy = D_sin_times_C_child_p_y + D_cos * C_arm_D_x;
    const real C_twist_vx = D_cos * C_base_twist_vx + D_sin * C_base_twist_vy;
    const real C_twist_vy = D_cos * C_base_twist_vy - D_sin * C_base_twist_vx;
    const real C_G_px_A = C_R_xx * C_twist_A_vx - C_R_xy * C_minus_twist_A_vy;
    const real C_G_px_B = C_R_xx * C_twist_B_vx - C_R_xy * C_minus_twist_B_vy;
    const real C_G_px_D = C_R_xx * C_twist_D_vx + C_R_xy * C_twist_D_vy;
    const real C_minus_G_py_A = C_R_xy * C_twist_A_vx + C_R_xx * C_minus_twist_A_vy;
    const real C_minus_G_py_B = C_R_xy * C_twist_B_vx + C_R_xx * C_minus_twist_B_vy;
    const real C_G_py_D = C_R_xx * C_twist_D_vy - C_R_xy * C_twist_D_vx;

    /* coupler: omega, inertia force */
    /* omega = Rᵀ omega_parent + S_w u */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal coupler_first_moment_x = w[2];
    const real coupler_omega_z = A_u + B_u;
    const real coupler_minus_f_x = coupler_omega_z * coupler_omega_z * coupler_first_moment_x;

    /* shared by several: inertia */
    const real crank_inertia_shift_part = coupler_first_moment_x * B_turn_cos * B_p_x
        + coupler_first_moment_x * B_turn_sin * B_p_y;

    /* crank: composite, U */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* U = [alpha] + [omega][omega] */
    const wreal coupler_origin_inertia_zz_plus_crank_base_inertia_zz = w[8];
    const real crank_composite_inertia_zz = 2.0 * crank_inertia_shift_part
        + coupler_origin_inertia_zz_plus_crank_base_inertia_zz;
    const real crank_minus_U_xx = A_u * A_u;

    /* M */
    /* M = S . momentum */
    const wreal coupler_origin_inertia_zz = w[3];
    const real M_B_A = coupler_origin_inertia_zz + crank_inertia_shift_part;

    /* coupler: a, n */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal gravity_y = w[0]; /* m/s^2 */
    const real coupler_a_y = B_p_x * crank_minus_U_xx * B_turn_sin - B_turn_cos * (gravity_y
        + B_p_y * crank_minus_U_xx);
    const real coupler_n_z = coupler_first_moment_x * coupler_a_y;

    /* crank: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal crank_base_moment_x = w[7];
    const real crank_n_z = B_turn_cos * coupler_minus_f_x * B_p_y
        - crank_base_moment_x * A_cos * gravity_y - B_turn_sin * coupler_minus_f_x * B_p_x
        + coupler_n_z;

    /* A: drive */
    /* drive = tau + f - h */
    const real A_u_tau = tau[0]; /* N*m */
    const real A_drive = A_u_tau - crank_n_z;

    /* B: drive, R */
    /* drive = tau + f - h */
    /* R = R_fixed R_joint(q) */
    const real B_u_tau = tau[1]; /* N*m */
    const real B_drive = B_u_tau - coupler_n_z;
    const real B_turn_sin_times_coupler_omega_z = B_turn_sin * coupler_omega_z;
    const real B_turn_cos_times_coupler_omega_z = B_turn_cos * coupler_omega_z;

    /* D: drive, R */
    /* drive = tau + f - h */
    /* R = R_fixed R_joint(q) */
    const real D_u_tau = tau[2]; /* N*m */
    const wreal rocker_first_moment_x = w[5];
    const real D_drive = D_u_tau + gravity_y * D_cos * rocker_first_moment_x;
    const real D_u_times_sin = D_u * D_sin;
    const real D_u_times_cos = D_u * D_cos;

    /* C: pose, twist, gamma */
    /* pose = [R_Pᵀ R_C, R_Pᵀ (p_C - p_P)] */
    /* twist = R_Cᵀ sum +-[R w; R v + R w x arm] */
    /* gamma = -d(rate)/dt at udot = 0 */
    const real C_minus_child_p_x_rate = C_child_position_x * D_u_times_sin;
    const real C_child_p_y_rate = C_child_position_x * D_u_times_cos;
    const real C_R_xx_rate = B_turn_sin * D_u_times_cos - B_turn_cos * D_u_times_sin
        + (D_sin * B_turn_cos_times_coupler_omega_z - D_cos * B_turn_sin_times_coupler_omega_z);
    const real C_R_xy_rate = D_sin * B_turn_sin_times_coupler_omega_z
        + D_cos * B_turn_cos_times_coupler_omega_z - (B_turn_cos * D_u_times_cos
        + B_turn_sin * D_u_times_sin);
    const real C_base_twist_vx_rate = A_u * C_child_p_y_rate - D_u * C_child_p_y_rate
        + B_u * (C_child_p_y_rate - A_u * A_cos * B_position_x);
    const real C_minus_base_twist_vy_rate = D_u * C_minus_child_p_x_rate
        - A_u * C_minus_child_p_x_rate + B_u * (A_u * A_sin * B_position_x
        - C_minus_child_p_x_rate);
    const real C_twist_vx_rate = D_cos * C_base_twist_vx_rate - C_base_twist_vx * D_u_times_sin
        + (C_base_twist_vy * D_u_times_cos - D_sin * C_minus_base_twist_vy_rate);
    const real C_minus_twist_vy_rate = C_base_twist_vx * D_u_times_cos
        + D_sin * C_base_twist_vx_rate + (C_base_twist_vy * D_u_times_sin
        + D_cos * C_minus_base_twist_vy_rate);
    const real C_gamma_px = C_R_xy * C_minus_twist_vy_rate - C_R_xx * C_twist_vx_rate
        - (C_twist_vx * C_R_xx_rate + C_twist_vy * C_R_xy_rate);
    const real C_gamma_py = C_twist_vx * C_R_xy_rate - C_twist_vy * C_R_xx_rate
        + (C_R_xy * C_twist_vx_rate + C_R_xx * C_minus_twist_vy_rate);

    /* constraints: factor, multipliers */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const wreal M_factor_D_inverse_D = w[9];
    const wreal M_factor_D_inverse_B = w[10];
    const real M_factor_L_B_A = M_B_A * M_factor_D_inverse_B;
    const real M_factor_D_inverse_A = 1.0 / (crank_composite_inertia_zz - M_B_A * M_factor_L_B_A);
    const real free_udot_A = M_factor_D_inverse_A * (A_drive - B_drive * M_factor_L_B_A);
    const real free_udot_D = D_drive * M_factor_D_inverse_D;
    const real free_udot_B = B_drive * M_factor_D_inverse_B - M_factor_L_B_A * free_udot_A;
    const real C_px_response_A = M_factor_D_inverse_A * (C_G_px_A - C_G_px_B * M_factor_L_B_A);
    const real C_px_response_D = C_G_px_D * M_factor_D_inverse_D;
    const real C_px_response_B = C_G_px_B * M_factor_D_inverse_B - M_factor_L_B_A * C_px_response_A;
    const real C_py_response_A = M_factor_D_inverse_A * (C_minus_G_py_B * M_factor_L_B_A
        - C_minus_G_py_A);
    const real C_py_response_D = C_G_py_D * M_factor_D_inverse_D;
    const real C_py_minus_response_B = C_minus_G_py_B * M_factor_D_inverse_B
        + M_factor_L_B_A * C_py_response_A;
    const real circuit_C_px_C_px = C_G_px_A * C_px_response_A + C_G_px_D * C_px_response_D
        + C_G_px_B * C_px_response_B;
    circuit_matrix[0][0] = circuit_C_px_C_px;
    const real circuit_C_py_C_px = C_G_py_D * C_px_response_D - C_minus_G_py_A * C_px_response_A
        - C_minus_G_py_B * C_px_response_B;
    circuit_matrix[0][1] = circuit_C_py_C_px;
    circuit_matrix[1][0] = circuit_C_py_C_px;
    const real circuit_C_py_C_py = C_G_py_D * C_py_response_D - C_minus_G_py_A * C_py_response_A
        + C_minus_G_py_B * C_py_minus_response_B;
    circuit_matrix[1][1] = circuit_C_py_C_py;
    const real free_gamma_C_px = C_gamma_px - C_G_px_D * free_udot_D - C_G_px_A * free_udot_A
        - C_G_px_B * free_udot_B;
    circuit_right[0] = free_gamma_C_px;
    const real free_gamma_C_py = C_gamma_py - C_G_py_D * free_udot_D
        + C_minus_G_py_A * free_udot_A + C_minus_G_py_B * free_udot_B;
    circuit_right[1] = free_gamma_C_py;
    /* circuit_matrix lam = circuit_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 2, 1, circuit_matrix[0], circuit_right, circuit_scratch);

    /* C: multiplier px, multiplier py */
    const real C_multiplier_px = circuit_right[0];
    const real C_multiplier_py = circuit_right[1];

    /* A: udot */
    /* udot = free_udot + response multipliers */
    /* udot: A.udot [rad/s^2] */
    out[0] = free_udot_A + C_px_response_A * C_multiplier_px + C_py_response_A * C_multiplier_py;

    /* B: udot */
    /* udot = free_udot + response multipliers */
    /* udot: B.udot [rad/s^2] */
    out[1] = free_udot_B + C_px_response_B * C_multiplier_px
        - C_py_minus_response_B * C_multiplier_py;

    /* D: udot */
    /* udot = free_udot + response multipliers */
    /* udot: D.udot [rad/s^2] */
    out[2] = free_udot_D + C_px_response_D * C_multiplier_px + C_py_response_D * C_multiplier_py;
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {3, 13, 11, 0, 3, 3, 0, 0, 0, 20, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0};
#endif
