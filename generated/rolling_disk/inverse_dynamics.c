/*
 * inverse_dynamics of rolling_disk
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 5, work 0, w 5
 * Operations per call: 142 = 86 mul, 29 add, 21 sub, 3 cos, 3 sin
 * Operations of prepare: 10 = 6 mul, 2 add, 2 sub
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
 * Input udot (5): derivatives of the speeds
 *   udot[0]  rolling.u.xdot [m/s^2]
 *   udot[1]  rolling.u.ydot [m/s^2]
 *   udot[2]  rolling.u.yawdot [rad/s^2]
 *   udot[3]  rolling.u.leandot [rad/s^2]
 *   udot[4]  rolling.u.spindot [rad/s^2]
 *
 * Output tau (5)
 *   out[0]  rolling.u.x.tau [N]
 *   out[1]  rolling.u.y.tau [N]
 *   out[2]  rolling.u.yaw.tau [N*m]
 *   out[3]  rolling.u.lean.tau [N*m]
 *   out[4]  rolling.u.spin.tau [N*m]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
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
    w[3] = coin_base_second_moment_xx;
    w[4] = coin_base_second_moment_yy;

    /* parameters as they are */
    w[0] = p[0]; /* m [kg] */
    w[1] = p[1]; /* r [m] */
    w[2] = p[2]; /* gravity.z [m/s^2] */
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

    /* rolling: R */
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

    /* rolling: R, drift, S */
    /* R = R_fixed R_joint(q) */
    /* drift = S' u + [0; omega x v] */
    /* S = d(twist of the child) / du */
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
    const real rolling_u_yaw_times_lean_cos = rolling_u_yaw * rolling_lean_cos;
    const real r_times_rolling_lean_sin = r_value * rolling_lean_sin;
    const real rolling_spin_cos_times_r_times_rolling_lean_sin = rolling_spin_cos *
        r_times_rolling_lean_sin;
    const real rolling_spin_sin_times_r_times_rolling_lean_sin = rolling_spin_sin *
        r_times_rolling_lean_sin;
    const real rolling_u_yaw_times_lean_sin = rolling_u_yaw * rolling_lean_sin;
    const real rolling_u_spin_times_u_yaw_times_lean_cos = rolling_u_spin *
        rolling_u_yaw_times_lean_cos;
    const real coin_alpha_x_part = rolling_u_lean * rolling_u_spin
        - rolling_u_lean * rolling_u_yaw_times_lean_sin;
    const real coin_a_x_part = 2.0 * rolling_u_lean * rolling_u_yaw_times_lean_cos * r_value;
    const real coin_a_x_part_2 = r_value * (rolling_u_lean * rolling_u_lean
        + rolling_u_yaw_times_lean_sin * rolling_u_yaw_times_lean_sin);

    /* coin: omega, alpha, a, f, U, n */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real rolling_u_xdot = udot[0]; /* m/s^2 */
    const real rolling_u_ydot = udot[1]; /* m/s^2 */
    const real rolling_u_yawdot = udot[2]; /* rad/s^2 */
    const real rolling_u_leandot = udot[3]; /* rad/s^2 */
    const real rolling_u_spindot = udot[4]; /* rad/s^2 */
    const wreal m = w[0]; /* kg */
    const wreal gravity_z = w[2]; /* m/s^2 */
    const wreal coin_base_second_moment_xx = w[3];
    const wreal coin_base_second_moment_yy = w[4];
    const real coin_omega_x = rolling_u_lean * rolling_spin_cos
        - rolling_u_yaw * rolling_minus_R_zx;
    const real coin_omega_y = rolling_u_spin + rolling_u_yaw_times_lean_sin;
    const real coin_omega_z = rolling_u_yaw * rolling_R_zz + rolling_u_lean * rolling_spin_sin;
    const real coin_alpha_x = rolling_u_leandot * rolling_spin_cos
        - rolling_u_yawdot * rolling_minus_R_zx
        - rolling_spin_cos * rolling_u_spin_times_u_yaw_times_lean_cos
        - rolling_spin_sin * coin_alpha_x_part;
    const real coin_alpha_y = rolling_u_spindot + rolling_u_yawdot * rolling_lean_sin
        + rolling_u_lean * rolling_u_yaw_times_lean_cos;
    const real coin_alpha_z = rolling_u_yawdot * rolling_R_zz
        + rolling_u_leandot * rolling_spin_sin
        - rolling_spin_sin * rolling_u_spin_times_u_yaw_times_lean_cos
        + rolling_spin_cos * coin_alpha_x_part;
    const real coin_a_x = rolling_u_yawdot * rolling_spin_cos_times_r_times_rolling_lean_sin
        + gravity_z * rolling_minus_R_zx + rolling_u_ydot * rolling_R_yx
        + (rolling_spin_cos * coin_a_x_part + rolling_u_xdot * rolling_R_xx
        + rolling_spin_sin * coin_a_x_part_2);
    const real coin_f_x = m * coin_a_x;
    const real coin_a_y = rolling_u_ydot * rolling_R_yy - rolling_u_xdot * rolling_minus_R_xy
        + (rolling_u_yaw_times_lean_sin * rolling_u_yaw_times_lean_cos * r_value
        - (r_value * rolling_u_leandot + gravity_z * rolling_lean_sin));
    const real coin_f_y = m * coin_a_y;
    const real coin_a_z = rolling_u_yawdot * rolling_spin_sin_times_r_times_rolling_lean_sin
        - gravity_z * rolling_R_zz + rolling_u_ydot * rolling_R_yz
        + (rolling_spin_sin * coin_a_x_part + rolling_u_xdot * rolling_R_xz
        - rolling_spin_cos * coin_a_x_part_2);
    const real coin_f_z = m * coin_a_z;
    const real coin_omega_x_times_omega_y = coin_omega_x * coin_omega_y;
    const real coin_omega_x_times_omega_z = coin_omega_x * coin_omega_z;
    const real coin_omega_y_times_omega_z = coin_omega_y * coin_omega_z;
    const real coin_U_xy = coin_omega_x_times_omega_y - coin_alpha_z;
    const real coin_U_yx = coin_alpha_z + coin_omega_x_times_omega_y;
    const real coin_n_z = coin_base_second_moment_xx * coin_U_yx
        - coin_base_second_moment_yy * coin_U_xy;
    const real coin_U_xz = coin_alpha_y + coin_omega_x_times_omega_z;
    const real coin_U_zx = coin_omega_x_times_omega_z - coin_alpha_y;
    const real coin_n_y = coin_base_second_moment_xx * coin_U_xz
        - coin_base_second_moment_xx * coin_U_zx;
    const real coin_U_yz = coin_omega_y_times_omega_z - coin_alpha_x;
    const real coin_U_zy = coin_alpha_x + coin_omega_y_times_omega_z;
    const real coin_n_x = coin_base_second_moment_yy * coin_U_zy
        - coin_base_second_moment_xx * coin_U_yz;
    out[4] = coin_n_y; /* tau: rolling.u.spin.tau [N*m] */

    /* rolling: tau */
    /* tau = S . [n; f] - force on the joint */
    /* tau: rolling.u.x.tau [N] */
    out[0] = rolling_R_xx * coin_f_x - rolling_minus_R_xy * coin_f_y + rolling_R_xz * coin_f_z;
    /* tau: rolling.u.y.tau [N] */
    out[1] = rolling_R_yx * coin_f_x + rolling_R_yy * coin_f_y + rolling_R_yz * coin_f_z;
    /* tau: rolling.u.yaw.tau [N*m] */
    out[2] = rolling_R_zz * coin_n_z + rolling_spin_cos_times_r_times_rolling_lean_sin * coin_f_x
        + (rolling_lean_sin * coin_n_y - rolling_minus_R_zx * coin_n_x
        + rolling_spin_sin_times_r_times_rolling_lean_sin * coin_f_z);
    /* tau: rolling.u.lean.tau [N*m] */
    out[3] = rolling_spin_cos * coin_n_x - r_value * coin_f_y + rolling_spin_sin * coin_n_z;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {5, 0, 5, 0, 5, 5, 0, 0, 0, 3, 0, 5, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
