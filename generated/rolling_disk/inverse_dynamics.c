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
    /* coin: mass, inertia */
    const wreal m = p[0]; /* kg */
    const wreal r_1 = p[1]; /* m */
    const wreal coin_mass = r_1 * r_1;
    const wreal coin_inertia_xx = 0.25 * m * coin_mass;
    const wreal coin_inertia_yy = 0.5 * m * coin_mass;

    /* common */
    const wreal mul_1 = 0.5 * (coin_inertia_xx + coin_inertia_xx + coin_inertia_yy);

    /* coin: base second moment */
    w[3] = mul_1 - coin_inertia_xx; /* coin_base_second_moment_xx */
    w[4] = mul_1 - coin_inertia_yy; /* coin_base_second_moment_yy */

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

    /* rolling: R, sin */
    const real rolling_yaw = q[2]; /* rad */
    const real rolling_lean = q[3]; /* rad */
    const real rolling_spin = q[4]; /* rad */
    const real angle[CARDAN_PADDED(3)] = {rolling_yaw, rolling_lean, rolling_spin};
    real sine[CARDAN_PADDED(3)], cosine[CARDAN_PADDED(3)];
    cardan_sincos(3, angle, sine, cosine);
    const real rolling_R = cosine[0];
    const real rolling_R_2 = sine[0];
    const real rolling_R_3 = cosine[1];
    const real rolling_sin = sine[1];
    const real rolling_R_4 = cosine[2];
    const real rolling_R_5 = sine[2];

    /* rolling: R, drift, S */
    const real rolling_u_yaw = u[2]; /* rad/s */
    const real rolling_u_lean = u[3]; /* rad/s */
    const real rolling_u_spin = u[4]; /* rad/s */
    const wreal r_1 = w[1]; /* m */
    const real rolling_R_6 = rolling_R_2 * rolling_R_3;
    const real rolling_R_7 = rolling_R_2 * rolling_sin;
    const real rolling_R_yy = rolling_R * rolling_R_3;
    const real rolling_R_8 = rolling_R * rolling_sin;
    const real rolling_R_xx = rolling_R * rolling_R_4 - rolling_R_7 * rolling_R_5;
    const real rolling_R_xz = rolling_R * rolling_R_5 + rolling_R_7 * rolling_R_4;
    const real rolling_R_yx = rolling_R_2 * rolling_R_4 + rolling_R_8 * rolling_R_5;
    const real rolling_R_yz = rolling_R_2 * rolling_R_5 - rolling_R_8 * rolling_R_4;
    const real rolling_R_9 = rolling_R_3 * rolling_R_5;
    const real rolling_R_zz = rolling_R_3 * rolling_R_4;
    const real rolling_drift = rolling_u_yaw * rolling_R_3;
    const real rolling_S = r_1 * rolling_sin;
    const real rolling_S_2 = rolling_R_4 * rolling_S;
    const real rolling_S_3 = rolling_R_5 * rolling_S;
    const real rolling_drift_2 = rolling_u_yaw * rolling_sin;
    const real rolling_drift_3 = rolling_u_spin * rolling_drift;
    const real rolling_drift_4 = rolling_u_lean * rolling_u_spin - rolling_u_lean * rolling_drift_2;
    const real rolling_drift_5 = 2.0 * rolling_u_lean * rolling_drift * r_1;
    const real rolling_drift_6 = r_1 * (rolling_u_lean * rolling_u_lean
        + rolling_drift_2 * rolling_drift_2);

    /* coin: omega, alpha, a, f, U, n */
    const real rolling_u_xdot = udot[0]; /* m/s^2 */
    const real rolling_u_ydot = udot[1]; /* m/s^2 */
    const real rolling_u_yawdot = udot[2]; /* rad/s^2 */
    const real rolling_u_leandot = udot[3]; /* rad/s^2 */
    const real rolling_u_spindot = udot[4]; /* rad/s^2 */
    const wreal m = w[0]; /* kg */
    const wreal gravity_z = w[2]; /* m/s^2 */
    const wreal coin_base_second_moment_xx = w[3];
    const wreal coin_base_second_moment_yy = w[4];
    const real coin_omega_x = rolling_u_lean * rolling_R_4 - rolling_u_yaw * rolling_R_9;
    const real coin_omega_y = rolling_u_spin + rolling_drift_2;
    const real coin_omega_z = rolling_u_yaw * rolling_R_zz + rolling_u_lean * rolling_R_5;
    const real coin_alpha_x = rolling_u_leandot * rolling_R_4 - rolling_u_yawdot * rolling_R_9
        - rolling_R_4 * rolling_drift_3 - rolling_R_5 * rolling_drift_4;
    const real coin_alpha_y = rolling_u_spindot + rolling_u_yawdot * rolling_sin
        + rolling_u_lean * rolling_drift;
    const real coin_alpha = rolling_u_yawdot * rolling_R_zz + rolling_u_leandot * rolling_R_5
        - rolling_R_5 * rolling_drift_3;
    const real coin_alpha_z = rolling_R_4 * rolling_drift_4 + coin_alpha;
    const real coin_a = rolling_R_4 * rolling_drift_5 + rolling_u_xdot * rolling_R_xx
        + rolling_R_5 * rolling_drift_6;
    const real coin_a_2 = rolling_R_5 * rolling_drift_5 + rolling_u_xdot * rolling_R_xz
        - rolling_R_4 * rolling_drift_6;
    const real coin_a_x = rolling_u_yawdot * rolling_S_2 + gravity_z * rolling_R_9
        + rolling_u_ydot * rolling_R_yx + coin_a;
    const real coin_f_x = m * coin_a_x;
    const real coin_a_3 = rolling_drift_2 * rolling_drift * r_1 - (r_1 * rolling_u_leandot
        + gravity_z * rolling_sin);
    const real coin_a_y = rolling_u_ydot * rolling_R_yy - rolling_u_xdot * rolling_R_6 + coin_a_3;
    const real coin_f_y = m * coin_a_y;
    const real coin_a_z = rolling_u_yawdot * rolling_S_3 - gravity_z * rolling_R_zz
        + rolling_u_ydot * rolling_R_yz + coin_a_2;
    const real coin_f_z = m * coin_a_z;
    const real coin_U = coin_omega_x * coin_omega_y;
    const real coin_U_2 = coin_omega_x * coin_omega_z;
    const real coin_U_3 = coin_omega_y * coin_omega_z;
    const real coin_U_xy = coin_U - coin_alpha_z;
    const real coin_U_yx = coin_alpha_z + coin_U;
    const real coin_n_z = coin_base_second_moment_xx * coin_U_yx
        - coin_base_second_moment_yy * coin_U_xy;
    const real coin_U_xz = coin_alpha_y + coin_U_2;
    const real coin_U_zx = coin_U_2 - coin_alpha_y;
    const real coin_n_y = coin_base_second_moment_xx * coin_U_xz
        - coin_base_second_moment_xx * coin_U_zx;
    const real coin_U_yz = coin_U_3 - coin_alpha_x;
    const real coin_U_zy = coin_alpha_x + coin_U_3;
    const real coin_n_x = coin_base_second_moment_yy * coin_U_zy
        - coin_base_second_moment_xx * coin_U_yz;
    out[4] = coin_n_y; /* tau: rolling.u.spin.tau [N*m] */

    /* rolling: tau, tau yaw, tau lean */
    const real rolling_tau = rolling_sin * coin_n_y - rolling_R_9 * coin_n_x
        + rolling_S_3 * coin_f_z;
    /* tau: rolling.u.x.tau [N] */
    out[0] = rolling_R_xx * coin_f_x - rolling_R_6 * coin_f_y + rolling_R_xz * coin_f_z;
    /* tau: rolling.u.y.tau [N] */
    out[1] = rolling_R_yx * coin_f_x + rolling_R_yy * coin_f_y + rolling_R_yz * coin_f_z;
    /* tau: rolling.u.yaw.tau [N*m] */
    out[2] = rolling_R_zz * coin_n_z + rolling_S_2 * coin_f_x + rolling_tau;
    /* tau: rolling.u.lean.tau [N*m] */
    out[3] = rolling_R_4 * coin_n_x - r_1 * coin_f_y + rolling_R_5 * coin_n_z;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {5, 0, 5, 0, 5, 5, 0, 0, 0, 3, 0, 5, 0, 0, 0, 0, 0, 0, 0};
#endif
