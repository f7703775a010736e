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
    /* coin: mass, inertia */
    const wreal m = p[0]; /* kg */
    const wreal r_1 = p[1]; /* m */
    const wreal coin_mass = r_1 * r_1;
    const wreal coin_inertia_xx = 0.25 * m * coin_mass;
    const wreal coin_inertia_yy = 0.5 * m * coin_mass;
    w[3] = coin_inertia_xx; /* coin_inertia_xx */
    w[4] = coin_inertia_yy; /* coin_inertia_yy */

    /* common */
    const wreal mul_1 = 0.5 * (coin_inertia_xx + coin_inertia_xx + coin_inertia_yy);

    /* coin: base second moment */
    w[5] = mul_1 - coin_inertia_xx; /* coin_base_second_moment_xx */
    w[6] = mul_1 - coin_inertia_yy; /* coin_base_second_moment_yy */

    /* rolling: M */
    const wreal rolling_M = m * r_1;
    w[7] = rolling_M; /* rolling_M */
    w[8] = r_1 * rolling_M; /* rolling_M_2 */

    /* constraints: D inverse, multipliers */
    const wreal constraints_D_inverse_5 = 1.0 / coin_inertia_yy;
    w[9] = constraints_D_inverse_5; /* constraints_D_inverse_5 */
    w[10] = r_1 * constraints_D_inverse_5; /* constraints_multipliers */

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
    int status = CARDAN_OK;

    /* shared by several: G, sin, R */
    const real rolling_yaw = q[2]; /* rad */
    const real rolling_lean = q[3]; /* rad */
    const real rolling_spin = q[4]; /* rad */
    const real angle[CARDAN_PADDED(3)] = {rolling_yaw, rolling_lean, rolling_spin};
    real sine[CARDAN_PADDED(3)], cosine[CARDAN_PADDED(3)];
    cardan_sincos(3, angle, sine, cosine);
    const real rolling_G = cosine[0];
    const real rolling_G_2 = sine[0];
    const real rolling_G_3 = cosine[1];
    const real rolling_sin = sine[1];
    const real rolling_R = cosine[2];
    const real rolling_R_2 = sine[2];

    /* rolling: R, S, drift, momentum fx, momentum fz, momentum fy, momentum my, ... */
    const real rolling_u_yaw = u[2]; /* rad/s */
    const real rolling_u_lean = u[3]; /* rad/s */
    const real rolling_u_spin = u[4]; /* rad/s */
    const wreal m = w[0]; /* kg */
    const wreal r_1 = w[1]; /* m */
    const wreal coin_inertia_xx = w[3];
    const wreal coin_inertia_yy = w[4];
    const real rolling_R_3 = rolling_G_2 * rolling_G_3;
    const real rolling_R_4 = rolling_G_2 * rolling_sin;
    const real rolling_R_yy = rolling_G * rolling_G_3;
    const real rolling_R_5 = rolling_G * rolling_sin;
    const real rolling_R_xx = rolling_G * rolling_R - rolling_R_4 * rolling_R_2;
    const real rolling_R_xz = rolling_G * rolling_R_2 + rolling_R_4 * rolling_R;
    const real rolling_R_yx = rolling_G_2 * rolling_R + rolling_R_5 * rolling_R_2;
    const real rolling_R_yz = rolling_G_2 * rolling_R_2 - rolling_R_5 * rolling_R;
    const real rolling_R_6 = rolling_G_3 * rolling_R_2;
    const real rolling_R_zz = rolling_G_3 * rolling_R;
    const real rolling_S = r_1 * rolling_sin;
    const real rolling_S_2 = rolling_R * rolling_S;
    const real rolling_S_3 = rolling_R_2 * rolling_S;
    const real rolling_drift = rolling_u_yaw * rolling_sin;
    const real rolling_drift_2 = rolling_u_yaw * rolling_G_3;
    const real rolling_drift_3 = rolling_u_spin * rolling_drift_2;
    const real rolling_drift_4 = rolling_u_lean * rolling_u_spin - rolling_u_lean * rolling_drift;
    const real rolling_drift_5 = rolling_R * rolling_drift_3 + rolling_R_2 * rolling_drift_4;
    const real rolling_drift_6 = 2.0 * rolling_u_lean * rolling_drift_2 * r_1;
    const real rolling_drift_7 = r_1 * (rolling_u_lean * rolling_u_lean
        + rolling_drift * rolling_drift);
    const real rolling_momentum_fx = m * rolling_R_xx;
    const real rolling_momentum_fz = m * rolling_R_xz;
    const real rolling_momentum_fx_2 = m * rolling_R_yx;
    const real rolling_momentum_fy = m * rolling_R_yy;
    const real rolling_momentum_fz_2 = m * rolling_R_yz;
    const real rolling_momentum_my = coin_inertia_yy * rolling_sin;
    const real rolling_momentum_mz = coin_inertia_xx * rolling_R_zz;
    const real rolling_momentum_fx_3 = m * rolling_S_2;
    const real rolling_momentum_fz_3 = m * rolling_S_3;
    const real rolling_M_3 = coin_inertia_xx * rolling_R_6 * rolling_R_6
        + rolling_sin * rolling_momentum_my + rolling_S_3 * rolling_momentum_fz_3;
    const real rolling_momentum_mx = coin_inertia_xx * rolling_R;
    const real rolling_momentum_mz_2 = coin_inertia_xx * rolling_R_2;

    /* coin: omega, alpha, a, U, n, f */
    const wreal gravity_z = w[2]; /* m/s^2 */
    const wreal coin_base_second_moment_xx = w[5];
    const wreal coin_base_second_moment_yy = w[6];
    const real coin_omega_x = rolling_u_lean * rolling_R - rolling_u_yaw * rolling_R_6;
    const real coin_omega_y = rolling_u_spin + rolling_drift;
    const real coin_omega_z = rolling_u_yaw * rolling_R_zz + rolling_u_lean * rolling_R_2;
    const real coin_alpha_y = rolling_u_lean * rolling_drift_2;
    const real coin_alpha_z = rolling_R * rolling_drift_4 - rolling_R_2 * rolling_drift_3;
    const real coin_a_x = rolling_R * rolling_drift_6 + gravity_z * rolling_R_6
        + rolling_R_2 * rolling_drift_7;
    const real coin_a_y = rolling_drift * rolling_drift_2 * r_1 - gravity_z * rolling_sin;
    const real coin_a_z = rolling_R_2 * rolling_drift_6 - gravity_z * rolling_R_zz
        - rolling_R * rolling_drift_7;
    const real coin_U = coin_omega_x * coin_omega_y;
    const real coin_U_2 = coin_omega_x * coin_omega_z;
    const real coin_U_3 = coin_omega_y * coin_omega_z;
    const real coin_U_xy = coin_U - coin_alpha_z;
    const real coin_U_xz = coin_alpha_y + coin_U_2;
    const real coin_U_yx = coin_alpha_z + coin_U;
    const real coin_U_yz = rolling_drift_5 + coin_U_3;
    const real coin_U_zx = coin_U_2 - coin_alpha_y;
    const real coin_U_zy = coin_U_3 - rolling_drift_5;
    const real coin_n_x = coin_base_second_moment_yy * coin_U_zy
        - coin_base_second_moment_xx * coin_U_yz;
    const real coin_n_y = coin_base_second_moment_xx * coin_U_xz
        - coin_base_second_moment_xx * coin_U_zx;
    const real coin_n_z = coin_base_second_moment_xx * coin_U_yx
        - coin_base_second_moment_yy * coin_U_xy;
    const real coin_f_x = m * coin_a_x;
    const real coin_f_y = m * coin_a_y;
    const real coin_f_z = m * coin_a_z;

    /* M */
    const wreal rolling_M = w[7];
    const wreal rolling_M_2 = w[8];
    const real M_1_1 = rolling_R_xx * rolling_momentum_fx + m * rolling_R_3 * rolling_R_3
        + rolling_R_xz * rolling_momentum_fz;
    const real M_2_1 = rolling_R_xx * rolling_momentum_fx_2 - rolling_R_3 * rolling_momentum_fy
        + rolling_R_xz * rolling_momentum_fz_2;
    const real M_2_2 = rolling_R_yx * rolling_momentum_fx_2 + rolling_R_yy * rolling_momentum_fy
        + rolling_R_yz * rolling_momentum_fz_2;
    const real M_3_1 = rolling_R_xx * rolling_momentum_fx_3 + rolling_R_xz * rolling_momentum_fz_3;
    const real M_3_2 = rolling_R_yx * rolling_momentum_fx_3 + rolling_R_yz * rolling_momentum_fz_3;
    const real M_3_3 = rolling_R_zz * rolling_momentum_mz + rolling_S_2 * rolling_momentum_fx_3
        + rolling_M_3;
    const real M_4_1 = rolling_R_3 * rolling_M;
    const real M_4_3 = rolling_R_zz * rolling_momentum_mz_2 - rolling_R_6 * rolling_momentum_mx;
    const real M_4_4 = rolling_R * rolling_momentum_mx + rolling_M_2
        + rolling_R_2 * rolling_momentum_mz_2;

    /* shared by several: M */
    const real rolling_M_4 = rolling_R_yy * rolling_M;

    /* rolling: tau, tau yaw, tau lean, drive, drive yaw, drive lean, drive spin */
    const real rolling_u_x_tau = tau[0]; /* N */
    const real rolling_u_y_tau = tau[1]; /* N */
    const real rolling_u_yaw_tau = tau[2]; /* N*m */
    const real rolling_u_lean_tau = tau[3]; /* N*m */
    const real rolling_u_spin_tau = tau[4]; /* N*m */
    const real rolling_tau_x = rolling_R_xx * coin_f_x - rolling_R_3 * coin_f_y
        + rolling_R_xz * coin_f_z;
    const real rolling_tau_y = rolling_R_yx * coin_f_x + rolling_R_yy * coin_f_y
        + rolling_R_yz * coin_f_z;
    const real rolling_tau = rolling_sin * coin_n_y + rolling_S_2 * coin_f_x
        + rolling_R_zz * coin_n_z;
    const real rolling_tau_yaw = rolling_S_3 * coin_f_z - rolling_R_6 * coin_n_x + rolling_tau;
    const real rolling_tau_lean = rolling_R * coin_n_x - r_1 * coin_f_y + rolling_R_2 * coin_n_z;
    const real rolling_drive_x = rolling_u_x_tau - rolling_tau_x;
    const real rolling_drive_y = rolling_u_y_tau - rolling_tau_y;
    const real rolling_drive_yaw = rolling_u_yaw_tau - rolling_tau_yaw;
    const real rolling_drive_lean = rolling_u_lean_tau - rolling_tau_lean;
    const real rolling_drive_spin = rolling_u_spin_tau - coin_n_y;

    /* constraints: multipliers, L, D inverse */
    const real rolling_u_x = u[0]; /* m/s */
    const real rolling_u_y = u[1]; /* m/s */
    const wreal constraints_D_inverse_5 = w[9];
    const wreal constraints_multipliers = w[10];
    const real constraints_multipliers_2 = rolling_u_yaw * rolling_G_2;
    const real constraints_multipliers_3 = rolling_u_yaw * rolling_G;
    const real constraints_L_5_3 = rolling_momentum_my * constraints_D_inverse_5;
    const real constraints_D_inverse_4 = 1.0 / M_4_4;
    const real constraints_L_4_3 = M_4_3 * constraints_D_inverse_4;
    const real constraints_multipliers_4 = M_3_1 - M_4_1 * constraints_L_4_3;
    const real constraints_multipliers_5 = M_3_2 + rolling_M_4 * constraints_L_4_3;
    const real constraints_multipliers_6 = rolling_M_4 * constraints_D_inverse_4;
    const real constraints_L_4_1 = M_4_1 * constraints_D_inverse_4;
    const real constraints_D_inverse_3 = 1.0 / (M_3_3 - rolling_momentum_my * constraints_L_5_3
        - M_4_3 * constraints_L_4_3);
    const real constraints_L_3_2 = constraints_multipliers_5 * constraints_D_inverse_3;
    const real constraints_multipliers_7 = M_2_1 + M_4_1 * constraints_multipliers_6
        - constraints_multipliers_4 * constraints_L_3_2;
    const real constraints_L_3_1 = constraints_multipliers_4 * constraints_D_inverse_3;
    const real constraints_D_inverse_2 = 1.0 / (M_2_2 - rolling_M_4 * constraints_multipliers_6
        - constraints_multipliers_5 * constraints_L_3_2);
    const real constraints_L_2_1 = constraints_multipliers_7 * constraints_D_inverse_2;
    const real constraints_multipliers_8 = M_1_1 - M_4_1 * constraints_L_4_1
        - constraints_multipliers_4 * constraints_L_3_1;
    const real constraints_D_inverse_1 = 1.0 / (constraints_multipliers_8
        - constraints_multipliers_7 * constraints_L_2_1);
    const real constraints_multipliers_9 = rolling_drive_yaw
        - rolling_drive_spin * constraints_L_5_3 - rolling_drive_lean * constraints_L_4_3;
    const real constraints_multipliers_10 = rolling_drive_y
        + rolling_drive_lean * constraints_multipliers_6
        - constraints_L_3_2 * constraints_multipliers_9;
    const real constraints_multipliers_11 = rolling_drive_x
        - rolling_drive_lean * constraints_L_4_1 - constraints_L_3_1 * constraints_multipliers_9;
    const real constraints_multipliers_12 = constraints_D_inverse_1 * (constraints_multipliers_11
        - constraints_L_2_1 * constraints_multipliers_10);
    const real constraints_multipliers_13 = constraints_D_inverse_2 * constraints_multipliers_10
        - constraints_L_2_1 * constraints_multipliers_12;
    const real constraints_multipliers_14 = constraints_D_inverse_3 * constraints_multipliers_9
        - constraints_L_3_1 * constraints_multipliers_12;
    const real constraints_multipliers_15 = constraints_multipliers_14
        - constraints_L_3_2 * constraints_multipliers_13;
    const real constraints_multipliers_16 = rolling_drive_spin * constraints_D_inverse_5
        - constraints_L_5_3 * constraints_multipliers_15;
    const real constraints_multipliers_17 = r_1 * constraints_L_5_3;
    const real constraints_multipliers_18 = rolling_G_2
        - constraints_L_3_2 * constraints_multipliers_17;
    const real constraints_multipliers_19 = rolling_G
        - constraints_L_3_1 * constraints_multipliers_17
        - constraints_L_2_1 * constraints_multipliers_18;
    const real constraints_multipliers_20 = constraints_D_inverse_1 * constraints_multipliers_19;
    const real constraints_multipliers_21 = constraints_D_inverse_2 * constraints_multipliers_18
        - constraints_L_2_1 * constraints_multipliers_20;
    const real constraints_multipliers_22 = constraints_D_inverse_3 * constraints_multipliers_17
        - constraints_L_3_1 * constraints_multipliers_20;
    const real constraints_multipliers_23 = constraints_multipliers_22
        - constraints_L_3_2 * constraints_multipliers_21;
    const real constraints_multipliers_24 = constraints_multipliers_6 * constraints_multipliers_21 -
        constraints_L_4_1 * constraints_multipliers_20;
    const real constraints_multipliers_25 = constraints_multipliers
        + constraints_L_5_3 * constraints_multipliers_23;
    const real constraints_multipliers_26 = constraints_D_inverse_1 * (rolling_G_2
        + rolling_G * constraints_L_2_1);
    const real constraints_multipliers_27 = rolling_G * constraints_D_inverse_2
        + constraints_L_2_1 * constraints_multipliers_26;
    const real constraints_multipliers_28 = constraints_L_3_1 * constraints_multipliers_26
        - constraints_L_3_2 * constraints_multipliers_27;
    const real constraints_multipliers_29 = constraints_L_4_1 * constraints_multipliers_26
        + constraints_multipliers_6 * constraints_multipliers_27;
    const real constraints_multipliers_30 = rolling_G * constraints_multipliers_20
        + rolling_G_2 * constraints_multipliers_21 + r_1 * constraints_multipliers_25;
    work[0] = constraints_multipliers_30;
    const real constraints_multipliers_31 = rolling_G * constraints_multipliers_21
        - rolling_G_2 * constraints_multipliers_20;
    work[1] = constraints_multipliers_31;
    work[2] = constraints_multipliers_31;
    const real constraints_multipliers_32 = rolling_G_2 * constraints_multipliers_26
        + rolling_G * constraints_multipliers_27;
    work[3] = constraints_multipliers_32;
    const real constraints_multipliers_33 = rolling_u_x * constraints_multipliers_2
        - rolling_u_y * constraints_multipliers_3;
    const real constraints_multipliers_34 = constraints_multipliers_33
        - rolling_G * constraints_multipliers_12 - rolling_G_2 * constraints_multipliers_13;
    const real constraints_multipliers_35 = r_1 * constraints_multipliers_16
        + constraints_multipliers_34;
    work[4] = constraints_multipliers_35;
    const real constraints_multipliers_36 = rolling_u_y * constraints_multipliers_2
        + rolling_u_x * constraints_multipliers_3;
    const real constraints_multipliers_37 = rolling_G_2 * constraints_multipliers_12
        + constraints_multipliers_36 - rolling_G * constraints_multipliers_13;
    work[5] = constraints_multipliers_37;
    status |= CARDAN_SOLVE(semidefinite, 2, 1, work + 0, work + 4, work + 6);
    const real constraints_multipliers_38 = rolling_drive_lean * constraints_D_inverse_4
        - constraints_L_4_1 * constraints_multipliers_12;
    const real constraints_multipliers_39 = constraints_multipliers_6 * constraints_multipliers_13 +
        constraints_multipliers_38;

    /* rolling: multiplier longitudinal, multiplier lateral */
    const real rolling_multiplier_longitudinal = work[4];
    const real rolling_multiplier_lateral = work[5];

    /* constraints: multipliers */
    const real constraints_multipliers_40 = (constraints_multipliers_24
        - constraints_L_4_3 * constraints_multipliers_23) * rolling_multiplier_longitudinal;
    const real constraints_multipliers_41 = (constraints_multipliers_29
        - constraints_L_4_3 * constraints_multipliers_28) * rolling_multiplier_lateral;
    const real constraints_multipliers_42 = constraints_multipliers_12
        + constraints_multipliers_20 * rolling_multiplier_longitudinal;
    const real constraints_multipliers_43 = constraints_multipliers_13
        + constraints_multipliers_21 * rolling_multiplier_longitudinal;
    const real constraints_multipliers_44 = constraints_multipliers_15
        + constraints_multipliers_23 * rolling_multiplier_longitudinal;
    const real constraints_multipliers_45 = constraints_multipliers_39
        - constraints_L_4_3 * constraints_multipliers_15 + constraints_multipliers_40;
    const real constraints_multipliers_46 = constraints_multipliers_16
        - constraints_multipliers_25 * rolling_multiplier_longitudinal;

    /* rolling: udot, udot yaw, udot lean, udot spin */
    /* udot: rolling.u.xdot [m/s^2] */
    out[0] = constraints_multipliers_42 - constraints_multipliers_26 * rolling_multiplier_lateral;
    /* udot: rolling.u.ydot [m/s^2] */
    out[1] = constraints_multipliers_27 * rolling_multiplier_lateral + constraints_multipliers_43;
    /* udot: rolling.u.yawdot [rad/s^2] */
    out[2] = constraints_multipliers_28 * rolling_multiplier_lateral + constraints_multipliers_44;
    /* udot: rolling.u.leandot [rad/s^2] */
    out[3] = constraints_multipliers_41 + constraints_multipliers_45;
    /* udot: rolling.u.spindot [rad/s^2] */
    out[4] = constraints_multipliers_46
        - constraints_L_5_3 * constraints_multipliers_28 * rolling_multiplier_lateral;
    return status;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {5, 13, 11, 0, 5, 5, 0, 0, 0, 3, 0, 0, 0, 0, 5, 0, 0, 0, 0};
#endif
