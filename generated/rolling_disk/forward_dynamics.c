/*
 * forward_dynamics of rolling_disk
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 5, work 13, w 11
 * Operations per call: 324 = 198 mul, 63 sub, 52 add, 4 div, 3 cos, 3 sin, 1 solve
 * Operations of prepare: 14 = 9 mul, 2 add, 2 sub, 1 div
 *
 * Input q (5): generalized coordinates
 *   q[0]  rolling.x [m]
 *   q[1]  rolling.y [m]
 *   q[2]  rolling.yaw [rad]
 *   q[3]  rolling.lean [rad]
 *   q[4]  rolling.spin [rad]
 *
 * Input u (5): generalized speeds
 *   u[0]  rolling.u.x [m/s]
 *   u[1]  rolling.u.y [m/s]
 *   u[2]  rolling.u.yaw [rad/s]
 *   u[3]  rolling.u.lean [rad/s]
 *   u[4]  rolling.u.spin [rad/s]
 *
 * Input p (3): parameters, read by prepare_ only
 *
 * Input tau (5): applied generalized forces
 *   tau[0]  rolling.u.x.tau [N]
 *   tau[1]  rolling.u.y.tau [N]
 *   tau[2]  rolling.u.yaw.tau [N*m]
 *   tau[3]  rolling.u.lean.tau [N*m]
 *   tau[4]  rolling.u.spin.tau [N*m]
 *
 * Output udot (5)
 *   out[0]  rolling.u.xdot [m/s^2]
 *   out[1]  rolling.u.ydot [m/s^2]
 *   out[2]  rolling.u.yawdot [rad/s^2]
 *   out[3]  rolling.u.leandot [rad/s^2]
 *   out[4]  rolling.u.spindot [rad/s^2]
 */
#include "cardan.h"
#include "solve.h"
#include "dependent.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* coin: mass, origin inertia, base */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal m = p[0]; /* kg */
    const wreal r_value = p[1]; /* m */
    const wreal r_squared = r_value * r_value;
    const wreal coin_origin_inertia_xx = 0.25 * m * r_squared;
    const wreal coin_origin_inertia_yy = 0.5 * m * r_squared;
    const wreal coin_base_half_trace = 0.5 * (coin_origin_inertia_xx + coin_origin_inertia_xx
        + coin_origin_inertia_yy);
    const wreal coin_base_second_moment_xx = coin_base_half_trace - coin_origin_inertia_xx;
    const wreal coin_base_second_moment_yy = coin_base_half_trace - coin_origin_inertia_yy;
    w[3] = coin_origin_inertia_xx;
    w[4] = coin_origin_inertia_yy;
    w[5] = coin_base_second_moment_xx;
    w[6] = coin_base_second_moment_yy;

    /* rolling: M */
    /* M = S . momentum */
    const wreal momentum_minus_rolling_lean_fy = m * r_value;
    const wreal r_times_momentum_minus_rolling_lean_fy = r_value * momentum_minus_rolling_lean_fy;
    w[7] = momentum_minus_rolling_lean_fy;
    w[8] = r_times_momentum_minus_rolling_lean_fy;

    /* constraints: factor */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    const wreal M_factor_D_inverse_rolling_spin = 1.0 / coin_origin_inertia_yy;
    const wreal rolling_longitudinal_minus_z_rolling_spin = r_value *
        M_factor_D_inverse_rolling_spin;
    w[9] = M_factor_D_inverse_rolling_spin;
    w[10] = rolling_longitudinal_minus_z_rolling_spin;

    /* parameters as they are */
    w[0] = p[0]; /* m [kg] */
    w[1] = p[1]; /* r [m] */
    w[2] = p[2]; /* gravity.z [m/s^2] */
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

    /* rolling: G, R */
    /* G = d(rate) / du */
    /* R = R_fixed R_joint(q) */
    const real rolling_yaw = q[2]; /* rad */
    const real rolling_lean = q[3]; /* rad */
    const real rolling_spin = q[4]; /* rad */
    const real angle[CARDAN_PADDED(3)] = {rolling_yaw, rolling_lean, rolling_spin};
    real sine[CARDAN_PADDED(3)], cosine[CARDAN_PADDED(3)];
    cardan_sincos(3, angle, sine, cosine);
    const real rolling_yaw_cos = cosine[0];
    const real rolling_yaw_sin = sine[0];
    const real rolling_lean_cos = cosine[1];
    const real rolling_lean_sin = sine[1];
    const real rolling_spin_cos = cosine[2];
    const real rolling_spin_sin = sine[2];

    /* rolling: R, S, drift, gamma */
    /* R = R_fixed R_joint(q) */
    /* S = d(twist of the child) / du */
    /* drift = S' u + [0; omega x v] */
    /* gamma = -d(rate)/dt at udot = 0 */
    const real rolling_u_x = u[0]; /* m/s */
    const real rolling_u_y = u[1]; /* m/s */
    const real rolling_u_yaw = u[2]; /* rad/s */
    const real rolling_u_lean = u[3]; /* rad/s */
    const real rolling_u_spin = u[4]; /* rad/s */
    const wreal r_value = w[1]; /* m */
    const real rolling_minus_R_xy = rolling_yaw_sin * rolling_lean_cos;
    const real rolling_yaw_sin_times_lean_sin = rolling_yaw_sin * rolling_lean_sin;
    const real rolling_R_yy = rolling_yaw_cos * rolling_lean_cos;
    const real rolling_yaw_cos_times_lean_sin = rolling_yaw_cos * rolling_lean_sin;
    const real rolling_R_xx = rolling_yaw_cos * rolling_spin_cos
        - rolling_yaw_sin_times_lean_sin * rolling_spin_sin;
    const real rolling_R_xz = rolling_yaw_cos * rolling_spin_sin
        + rolling_yaw_sin_times_lean_sin * rolling_spin_cos;
    const real rolling_R_yx = rolling_yaw_sin * rolling_spin_cos
        + rolling_yaw_cos_times_lean_sin * rolling_spin_sin;
    const real rolling_R_yz = rolling_yaw_sin * rolling_spin_sin
        - rolling_yaw_cos_times_lean_sin * rolling_spin_cos;
    const real rolling_minus_R_zx = rolling_lean_cos * rolling_spin_sin;
    const real rolling_R_zz = rolling_lean_cos * rolling_spin_cos;
    const real r_times_rolling_lean_sin = r_value * rolling_lean_sin;
    const real rolling_spin_cos_times_r_times_rolling_lean_sin = rolling_spin_cos *
        r_times_rolling_lean_sin;
    const real rolling_spin_sin_times_r_times_rolling_lean_sin = rolling_spin_sin *
        r_times_rolling_lean_sin;
    const real rolling_u_yaw_times_lean_sin = rolling_u_yaw * rolling_lean_sin;
    const real rolling_u_yaw_times_lean_cos = rolling_u_yaw * rolling_lean_cos;
    const real rolling_u_spin_times_u_yaw_times_lean_cos = rolling_u_spin *
        rolling_u_yaw_times_lean_cos;
    const real rolling_minus_drift_relative_wx_part = rolling_u_lean * rolling_u_spin
        - rolling_u_lean * rolling_u_yaw_times_lean_sin;
    const real rolling_minus_drift_relative_wx = rolling_spin_cos *
        rolling_u_spin_times_u_yaw_times_lean_cos
        + rolling_spin_sin * rolling_minus_drift_relative_wx_part;
    const real coin_a_x_part = 2.0 * rolling_u_lean * rolling_u_yaw_times_lean_cos * r_value;
    const real coin_a_x_part_2 = r_value * (rolling_u_lean * rolling_u_lean
        + rolling_u_yaw_times_lean_sin * rolling_u_yaw_times_lean_sin);
    const real rolling_u_yaw_times_yaw_sin = rolling_u_yaw * rolling_yaw_sin;
    const real rolling_u_yaw_times_yaw_cos = rolling_u_yaw * rolling_yaw_cos;
    const real rolling_gamma_lateral = rolling_u_y * rolling_u_yaw_times_yaw_sin
        + rolling_u_x * rolling_u_yaw_times_yaw_cos;
    const real rolling_gamma_longitudinal = rolling_u_x * rolling_u_yaw_times_yaw_sin
        - rolling_u_y * rolling_u_yaw_times_yaw_cos;

    /* coin: omega, alpha, a, U, n, f */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const wreal m = w[0]; /* kg */
    const wreal gravity_z = w[2]; /* m/s^2 */
    const wreal coin_base_second_moment_xx = w[5];
    const wreal coin_base_second_moment_yy = w[6];
    const real coin_omega_x = rolling_u_lean * rolling_spin_cos
        - rolling_u_yaw * rolling_minus_R_zx;
    const real coin_omega_y = rolling_u_spin + rolling_u_yaw_times_lean_sin;
    const real coin_omega_z = rolling_u_yaw * rolling_R_zz + rolling_u_lean * rolling_spin_sin;
    const real coin_alpha_y = rolling_u_lean * rolling_u_yaw_times_lean_cos;
    const real coin_alpha_z = rolling_spin_cos * rolling_minus_drift_relative_wx_part
        - rolling_spin_sin * rolling_u_spin_times_u_yaw_times_lean_cos;
    const real coin_a_x = rolling_spin_cos * coin_a_x_part + gravity_z * rolling_minus_R_zx
        + rolling_spin_sin * coin_a_x_part_2;
    const real coin_a_y = rolling_u_yaw_times_lean_sin * rolling_u_yaw_times_lean_cos * r_value
        - gravity_z * rolling_lean_sin;
    const real coin_a_z = rolling_spin_sin * coin_a_x_part - gravity_z * rolling_R_zz
        - rolling_spin_cos * coin_a_x_part_2;
    const real coin_omega_x_times_omega_y = coin_omega_x * coin_omega_y;
    const real coin_omega_x_times_omega_z = coin_omega_x * coin_omega_z;
    const real coin_omega_y_times_omega_z = coin_omega_y * coin_omega_z;
    const real coin_U_xy = coin_omega_x_times_omega_y - coin_alpha_z;
    const real coin_U_xz = coin_alpha_y + coin_omega_x_times_omega_z;
    const real coin_U_yx = coin_alpha_z + coin_omega_x_times_omega_y;
    const real coin_U_yz = rolling_minus_drift_relative_wx + coin_omega_y_times_omega_z;
    const real coin_U_zx = coin_omega_x_times_omega_z - coin_alpha_y;
    const real coin_U_zy = coin_omega_y_times_omega_z - rolling_minus_drift_relative_wx;
    const real coin_n_x = coin_base_second_moment_yy * coin_U_zy
        - coin_base_second_moment_xx * coin_U_yz;
    const real coin_n_y = coin_base_second_moment_xx * coin_U_xz
        - coin_base_second_moment_xx * coin_U_zx;
    const real coin_n_z = coin_base_second_moment_xx * coin_U_yx
        - coin_base_second_moment_yy * coin_U_xy;
    const real coin_f_x = m * coin_a_x;
    const real coin_f_y = m * coin_a_y;
    const real coin_f_z = m * coin_a_z;

    /* momentum */
    /* momentum = composite inertia S */
    const wreal coin_origin_inertia_xx = w[3];
    const wreal coin_origin_inertia_yy = w[4];
    const real momentum_rolling_x_fx = m * rolling_R_xx;
    const real momentum_rolling_x_fz = m * rolling_R_xz;
    const real momentum_rolling_y_fx = m * rolling_R_yx;
    const real momentum_rolling_y_fy = m * rolling_R_yy;
    const real momentum_rolling_y_fz = m * rolling_R_yz;
    const real momentum_rolling_yaw_my = coin_origin_inertia_yy * rolling_lean_sin;
    const real momentum_rolling_yaw_mz = coin_origin_inertia_xx * rolling_R_zz;
    const real momentum_rolling_yaw_fx = m * rolling_spin_cos_times_r_times_rolling_lean_sin;
    const real momentum_rolling_yaw_fz = m * rolling_spin_sin_times_r_times_rolling_lean_sin;
    const real momentum_rolling_lean_mx = coin_origin_inertia_xx * rolling_spin_cos;
    const real momentum_rolling_lean_mz = coin_origin_inertia_xx * rolling_spin_sin;

    /* M */
    /* M = S . momentum */
    const wreal momentum_minus_rolling_lean_fy = w[7];
    const wreal r_times_momentum_minus_rolling_lean_fy = w[8];
    const real M_rolling_x_rolling_x = rolling_R_xx * momentum_rolling_x_fx
        + m * rolling_minus_R_xy * rolling_minus_R_xy + rolling_R_xz * momentum_rolling_x_fz;
    const real M_rolling_y_rolling_x = rolling_R_xx * momentum_rolling_y_fx
        - rolling_minus_R_xy * momentum_rolling_y_fy + rolling_R_xz * momentum_rolling_y_fz;
    const real M_rolling_y_rolling_y = rolling_R_yx * momentum_rolling_y_fx
        + rolling_R_yy * momentum_rolling_y_fy + rolling_R_yz * momentum_rolling_y_fz;
    const real M_rolling_yaw_rolling_x = rolling_R_xx * momentum_rolling_yaw_fx
        + rolling_R_xz * momentum_rolling_yaw_fz;
    const real M_rolling_yaw_rolling_y = rolling_R_yx * momentum_rolling_yaw_fx
        + rolling_R_yz * momentum_rolling_yaw_fz;
    const real M_rolling_lean_rolling_x = rolling_minus_R_xy * momentum_minus_rolling_lean_fy;
    const real M_rolling_lean_rolling_yaw = rolling_R_zz * momentum_rolling_lean_mz
        - rolling_minus_R_zx * momentum_rolling_lean_mx;
    const real M_rolling_lean_rolling_lean = rolling_spin_cos * momentum_rolling_lean_mx
        + r_times_momentum_minus_rolling_lean_fy + rolling_spin_sin * momentum_rolling_lean_mz;

    /* rolling: M, tau, drive */
    /* M = S . momentum */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real rolling_u_x_tau = tau[0]; /* N */
    const real rolling_u_y_tau = tau[1]; /* N */
    const real rolling_u_yaw_tau = tau[2]; /* N*m */
    const real rolling_u_lean_tau = tau[3]; /* N*m */
    const real rolling_u_spin_tau = tau[4]; /* N*m */
    const real M_rolling_yaw_rolling_yaw_part = coin_origin_inertia_xx * rolling_minus_R_zx *
        rolling_minus_R_zx + rolling_lean_sin * momentum_rolling_yaw_my
        + rolling_spin_sin_times_r_times_rolling_lean_sin * momentum_rolling_yaw_fz;
    const real rolling_tau_x = rolling_R_xx * coin_f_x - rolling_minus_R_xy * coin_f_y
        + rolling_R_xz * coin_f_z;
    const real rolling_tau_y = rolling_R_yx * coin_f_x + rolling_R_yy * coin_f_y
        + rolling_R_yz * coin_f_z;
    const real rolling_tau_yaw = rolling_spin_sin_times_r_times_rolling_lean_sin * coin_f_z
        - rolling_minus_R_zx * coin_n_x + (rolling_lean_sin * coin_n_y
        + rolling_spin_cos_times_r_times_rolling_lean_sin * coin_f_x + rolling_R_zz * coin_n_z);
    const real rolling_tau_lean = rolling_spin_cos * coin_n_x - r_value * coin_f_y
        + rolling_spin_sin * coin_n_z;
    const real rolling_drive_x = rolling_u_x_tau - rolling_tau_x;
    const real rolling_drive_y = rolling_u_y_tau - rolling_tau_y;
    const real rolling_drive_yaw = rolling_u_yaw_tau - rolling_tau_yaw;
    const real rolling_drive_lean = rolling_u_lean_tau - rolling_tau_lean;
    const real rolling_drive_spin = rolling_u_spin_tau - coin_n_y;

    /* M */
    /* M = S . momentum */
    const real M_rolling_yaw_rolling_yaw = rolling_R_zz * momentum_rolling_yaw_mz
        + rolling_spin_cos_times_r_times_rolling_lean_sin * momentum_rolling_yaw_fx
        + M_rolling_yaw_rolling_yaw_part;

    /* shared by several: M */
    /* M = S . momentum */
    const real momentum_minus_rolling_lean_about_ground_fy = rolling_R_yy *
        momentum_minus_rolling_lean_fy;

    /* constraints: factor, multipliers */
    /* factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive, response = M⁻¹ Gᵀ */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const wreal M_factor_D_inverse_rolling_spin = w[9];
    const wreal rolling_longitudinal_minus_z_rolling_spin = w[10];
    const real M_factor_L_rolling_spin_rolling_yaw = momentum_rolling_yaw_my *
        M_factor_D_inverse_rolling_spin;
    const real M_factor_D_inverse_rolling_lean = 1.0 / M_rolling_lean_rolling_lean;
    const real M_factor_L_rolling_lean_rolling_yaw = M_rolling_lean_rolling_yaw *
        M_factor_D_inverse_rolling_lean;
    const real M_factor_DL_rolling_yaw_rolling_x = M_rolling_yaw_rolling_x
        - M_rolling_lean_rolling_x * M_factor_L_rolling_lean_rolling_yaw;
    const real M_factor_DL_rolling_yaw_rolling_y = M_rolling_yaw_rolling_y
        + momentum_minus_rolling_lean_about_ground_fy * M_factor_L_rolling_lean_rolling_yaw;
    const real M_minus_factor_L_rolling_lean_rolling_y = momentum_minus_rolling_lean_about_ground_fy
        * M_factor_D_inverse_rolling_lean;
    const real M_factor_L_rolling_lean_rolling_x = M_rolling_lean_rolling_x *
        M_factor_D_inverse_rolling_lean;
    const real M_factor_D_inverse_rolling_yaw = 1.0 / (M_rolling_yaw_rolling_yaw
        - momentum_rolling_yaw_my * M_factor_L_rolling_spin_rolling_yaw
        - M_rolling_lean_rolling_yaw * M_factor_L_rolling_lean_rolling_yaw);
    const real M_factor_L_rolling_yaw_rolling_y = M_factor_DL_rolling_yaw_rolling_y *
        M_factor_D_inverse_rolling_yaw;
    const real M_factor_DL_rolling_y_rolling_x = M_rolling_y_rolling_x
        + M_rolling_lean_rolling_x * M_minus_factor_L_rolling_lean_rolling_y
        - M_factor_DL_rolling_yaw_rolling_x * M_factor_L_rolling_yaw_rolling_y;
    const real M_factor_L_rolling_yaw_rolling_x = M_factor_DL_rolling_yaw_rolling_x *
        M_factor_D_inverse_rolling_yaw;
    const real M_factor_D_inverse_rolling_y = 1.0 / (M_rolling_y_rolling_y
        - momentum_minus_rolling_lean_about_ground_fy * M_minus_factor_L_rolling_lean_rolling_y
        - M_factor_DL_rolling_yaw_rolling_y * M_factor_L_rolling_yaw_rolling_y);
    const real M_factor_L_rolling_y_rolling_x = M_factor_DL_rolling_y_rolling_x *
        M_factor_D_inverse_rolling_y;
    const real M_factor_D_inverse_rolling_x = 1.0 / (M_rolling_x_rolling_x
        - M_rolling_lean_rolling_x * M_factor_L_rolling_lean_rolling_x
        - M_factor_DL_rolling_yaw_rolling_x * M_factor_L_rolling_yaw_rolling_x
        - M_factor_DL_rolling_y_rolling_x * M_factor_L_rolling_y_rolling_x);
    const real free_y_rolling_yaw = rolling_drive_yaw
        - rolling_drive_spin * M_factor_L_rolling_spin_rolling_yaw
        - rolling_drive_lean * M_factor_L_rolling_lean_rolling_yaw;
    const real free_y_rolling_y = rolling_drive_y
        + rolling_drive_lean * M_minus_factor_L_rolling_lean_rolling_y
        - M_factor_L_rolling_yaw_rolling_y * free_y_rolling_yaw;
    const real free_udot_rolling_x = M_factor_D_inverse_rolling_x * (rolling_drive_x
        - rolling_drive_lean * M_factor_L_rolling_lean_rolling_x
        - M_factor_L_rolling_yaw_rolling_x * free_y_rolling_yaw
        - M_factor_L_rolling_y_rolling_x * free_y_rolling_y);
    const real free_udot_rolling_y = M_factor_D_inverse_rolling_y * free_y_rolling_y
        - M_factor_L_rolling_y_rolling_x * free_udot_rolling_x;
    const real free_udot_rolling_yaw = M_factor_D_inverse_rolling_yaw * free_y_rolling_yaw
        - M_factor_L_rolling_yaw_rolling_x * free_udot_rolling_x
        - M_factor_L_rolling_yaw_rolling_y * free_udot_rolling_y;
    const real free_udot_rolling_spin = rolling_drive_spin * M_factor_D_inverse_rolling_spin
        - M_factor_L_rolling_spin_rolling_yaw * free_udot_rolling_yaw;
    const real rolling_longitudinal_y_rolling_yaw = r_value * M_factor_L_rolling_spin_rolling_yaw;
    const real rolling_longitudinal_y_rolling_y = rolling_yaw_sin
        - M_factor_L_rolling_yaw_rolling_y * rolling_longitudinal_y_rolling_yaw;
    const real rolling_longitudinal_response_rolling_x = M_factor_D_inverse_rolling_x *
        (rolling_yaw_cos - M_factor_L_rolling_yaw_rolling_x * rolling_longitudinal_y_rolling_yaw
        - M_factor_L_rolling_y_rolling_x * rolling_longitudinal_y_rolling_y);
    const real rolling_longitudinal_response_rolling_y = M_factor_D_inverse_rolling_y *
        rolling_longitudinal_y_rolling_y
        - M_factor_L_rolling_y_rolling_x * rolling_longitudinal_response_rolling_x;
    const real rolling_longitudinal_response_rolling_yaw = M_factor_D_inverse_rolling_yaw *
        rolling_longitudinal_y_rolling_yaw
        - M_factor_L_rolling_yaw_rolling_x * rolling_longitudinal_response_rolling_x
        - M_factor_L_rolling_yaw_rolling_y * rolling_longitudinal_response_rolling_y;
    const real rolling_longitudinal_response_rolling_lean = M_minus_factor_L_rolling_lean_rolling_y
        * rolling_longitudinal_response_rolling_y
        - M_factor_L_rolling_lean_rolling_x * rolling_longitudinal_response_rolling_x
        - M_factor_L_rolling_lean_rolling_yaw * rolling_longitudinal_response_rolling_yaw;
    const real rolling_longitudinal_minus_response_rolling_spin =
        rolling_longitudinal_minus_z_rolling_spin
        + M_factor_L_rolling_spin_rolling_yaw * rolling_longitudinal_response_rolling_yaw;
    const real rolling_lateral_minus_response_rolling_x = M_factor_D_inverse_rolling_x *
        (rolling_yaw_sin + rolling_yaw_cos * M_factor_L_rolling_y_rolling_x);
    const real rolling_lateral_response_rolling_y = rolling_yaw_cos * M_factor_D_inverse_rolling_y +
        M_factor_L_rolling_y_rolling_x * rolling_lateral_minus_response_rolling_x;
    const real rolling_lateral_response_rolling_yaw = M_factor_L_rolling_yaw_rolling_x *
        rolling_lateral_minus_response_rolling_x
        - M_factor_L_rolling_yaw_rolling_y * rolling_lateral_response_rolling_y;
    const real circuit_rolling_longitudinal_rolling_longitudinal = rolling_yaw_cos *
        rolling_longitudinal_response_rolling_x
        + rolling_yaw_sin * rolling_longitudinal_response_rolling_y
        + r_value * rolling_longitudinal_minus_response_rolling_spin;
    circuit_matrix[0][0] = circuit_rolling_longitudinal_rolling_longitudinal;
    const real circuit_rolling_lateral_rolling_longitudinal = rolling_yaw_cos *
        rolling_longitudinal_response_rolling_y
        - rolling_yaw_sin * rolling_longitudinal_response_rolling_x;
    circuit_matrix[0][1] = circuit_rolling_lateral_rolling_longitudinal;
    circuit_matrix[1][0] = circuit_rolling_lateral_rolling_longitudinal;
    const real circuit_rolling_lateral_rolling_lateral = rolling_yaw_sin *
        rolling_lateral_minus_response_rolling_x
        + rolling_yaw_cos * rolling_lateral_response_rolling_y;
    circuit_matrix[1][1] = circuit_rolling_lateral_rolling_lateral;
    const real free_gamma_rolling_longitudinal = rolling_gamma_longitudinal
        - rolling_yaw_cos * free_udot_rolling_x - rolling_yaw_sin * free_udot_rolling_y
        + r_value * free_udot_rolling_spin;
    circuit_right[0] = free_gamma_rolling_longitudinal;
    const real free_gamma_rolling_lateral = rolling_gamma_lateral
        + rolling_yaw_sin * free_udot_rolling_x - rolling_yaw_cos * free_udot_rolling_y;
    circuit_right[1] = free_gamma_rolling_lateral;
    /* circuit_matrix lam = circuit_right; the solution takes its place */
    status |= CARDAN_SOLVE(semidefinite, 2, 1, circuit_matrix[0], circuit_right, circuit_scratch);
    const real rolling_udot_lean_part = rolling_drive_lean * M_factor_D_inverse_rolling_lean
        - M_factor_L_rolling_lean_rolling_x * free_udot_rolling_x
        + M_minus_factor_L_rolling_lean_rolling_y * free_udot_rolling_y
        - M_factor_L_rolling_lean_rolling_yaw * free_udot_rolling_yaw;

    /* rolling: multiplier longitudinal, multiplier lateral, udot */
    /* udot = free_udot + response multipliers */
    const real rolling_multiplier_longitudinal = circuit_right[0];
    const real rolling_multiplier_lateral = circuit_right[1];
    /* udot: rolling.u.xdot [m/s^2] */
    out[0] = free_udot_rolling_x
        + rolling_longitudinal_response_rolling_x * rolling_multiplier_longitudinal
        - rolling_lateral_minus_response_rolling_x * rolling_multiplier_lateral;
    /* udot: rolling.u.ydot [m/s^2] */
    out[1] = free_udot_rolling_y
        + rolling_longitudinal_response_rolling_y * rolling_multiplier_longitudinal
        + rolling_lateral_response_rolling_y * rolling_multiplier_lateral;
    /* udot: rolling.u.yawdot [rad/s^2] */
    out[2] = free_udot_rolling_yaw
        + rolling_longitudinal_response_rolling_yaw * rolling_multiplier_longitudinal
        + rolling_lateral_response_rolling_yaw * rolling_multiplier_lateral;
    /* udot: rolling.u.spindot [rad/s^2] */
    out[4] = free_udot_rolling_spin
        - rolling_longitudinal_minus_response_rolling_spin * rolling_multiplier_longitudinal
        - M_factor_L_rolling_spin_rolling_yaw * rolling_lateral_response_rolling_yaw *
        rolling_multiplier_lateral;

    /* constraints: multipliers */
    /* multipliers = loop⁻¹ (gamma - G free_udot) */
    const real rolling_udot_lean_part_2 = (M_factor_L_rolling_lean_rolling_x *
        rolling_lateral_minus_response_rolling_x
        + M_minus_factor_L_rolling_lean_rolling_y * rolling_lateral_response_rolling_y
        - M_factor_L_rolling_lean_rolling_yaw * rolling_lateral_response_rolling_yaw) *
        rolling_multiplier_lateral;

    /* rolling: udot */
    /* udot = free_udot + response multipliers */
    /* udot: rolling.u.leandot [rad/s^2] */
    out[3] = rolling_longitudinal_response_rolling_lean * rolling_multiplier_longitudinal
        + rolling_udot_lean_part + rolling_udot_lean_part_2;
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {5, 13, 11, 0, 5, 5, 0, 0, 0, 3, 0, 0, 0, 0, 5, 0, 0, 0, 0, 0};
#endif
