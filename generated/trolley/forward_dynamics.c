/*
 * forward_dynamics of trolley
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 5, work 0, w 18
 * Operations per call: 195 = 120 mul, 34 sub, 28 add, 4 cos, 4 sin, 3 div, 1 table, 1 tanh
 * Operations of prepare: 38 = 21 mul, 10 add, 4 sub, 3 div
 *
 * Input t (1): time
 *   t[0]  t [s]
 *
 * Input q (5): generalized coordinates
 *   q[0]  track [m]
 *   q[1]  left.hang.angle1 [rad]
 *   q[2]  left.hang.angle2 [rad]
 *   q[3]  right.hang.angle1 [rad]
 *   q[4]  right.hang.angle2 [rad]
 *
 * Input u (5): generalized speeds
 *   u[0]  track.u [m/s]
 *   u[1]  left.hang.u.angle1 [rad/s]
 *   u[2]  left.hang.u.angle2 [rad/s]
 *   u[3]  right.hang.u.angle1 [rad/s]
 *   u[4]  right.hang.u.angle2 [rad/s]
 *
 * Input r (1): inputs of the model
 *   r[0]  push [N]
 *
 * Input p (13): parameters, read by prepare_ only
 *
 * Input tau (5): applied generalized forces
 *   tau[0]  track.u.tau [N]
 *   tau[1]  left.hang.u.angle1.tau [N*m]
 *   tau[2]  left.hang.u.angle2.tau [N*m]
 *   tau[3]  right.hang.u.angle1.tau [N*m]
 *   tau[4]  right.hang.u.angle2.tau [N*m]
 *
 * Output udot (5)
 *   out[0]  track.udot [m/s^2]
 *   out[1]  left.hang.u.angle1dot [rad/s^2]
 *   out[2]  left.hang.u.angle2dot [rad/s^2]
 *   out[3]  right.hang.u.angle1dot [rad/s^2]
 *   out[4]  right.hang.u.angle2dot [rad/s^2]
 */
#include "cardan.h"

static const double table_0_forward_dynamics_breaks[5] = {
    -3.0, -1.0, 0.0, 1.0, 3.0
};

static const double table_0_forward_dynamics_coefficients[16] = {
    0.2118644067796609, -6.673728813559322, 0.0, 120.0, 70.84745762711864, -141.6949152542373,
    -24.152542372881356, 95.0, 70.84745762711864, -70.84745762711864, -95.0, 0.0,
    0.2118644067796609, 5.402542372881356, -24.152542372881356, -95.0
};

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* left.bucket: mass, origin inertia, base */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal left_load = p[3]; /* kg */
    const wreal left_rope = p[4]; /* m */
    const wreal left_size = p[5]; /* m */
    const wreal left_size_squared = left_size * left_size;
    const wreal left_bucket_origin_inertia_zz = 0.5 * left_load * left_size_squared;
    const wreal left_bucket_minus_first_moment_z = left_load * left_rope;
    const wreal left_bucket_origin_inertia_xx = 0.3333333333333333 * left_load * left_size_squared +
        left_rope * left_bucket_minus_first_moment_z;
    const wreal left_bucket_base_half_trace = 0.5 * (left_bucket_origin_inertia_zz
        + left_bucket_origin_inertia_xx + left_bucket_origin_inertia_xx);
    const wreal left_bucket_base_second_moment_xx = left_bucket_base_half_trace
        - left_bucket_origin_inertia_xx;
    const wreal left_bucket_base_second_moment_zz = left_bucket_base_half_trace
        - left_bucket_origin_inertia_zz;
    w[3] = left_bucket_origin_inertia_zz;
    w[4] = left_bucket_minus_first_moment_z;
    w[5] = left_bucket_origin_inertia_xx;
    w[11] = left_bucket_base_second_moment_xx;
    w[12] = left_bucket_base_second_moment_zz;

    /* right.bucket: mass, origin inertia, base */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal right_load = p[6]; /* kg */
    const wreal right_rope = p[7]; /* m */
    const wreal right_size = p[8]; /* m */
    const wreal right_size_squared = right_size * right_size;
    const wreal right_bucket_origin_inertia_zz = 0.5 * right_load * right_size_squared;
    const wreal right_bucket_minus_first_moment_z = right_load * right_rope;
    const wreal right_bucket_origin_inertia_xx = 0.3333333333333333 * right_load *
        right_size_squared + right_rope * right_bucket_minus_first_moment_z;
    const wreal right_bucket_base_half_trace = 0.5 * (right_bucket_origin_inertia_zz
        + right_bucket_origin_inertia_xx + right_bucket_origin_inertia_xx);
    const wreal right_bucket_base_second_moment_xx = right_bucket_base_half_trace
        - right_bucket_origin_inertia_xx;
    const wreal right_bucket_base_second_moment_zz = right_bucket_base_half_trace
        - right_bucket_origin_inertia_zz;
    w[6] = right_bucket_origin_inertia_zz;
    w[7] = right_bucket_minus_first_moment_z;
    w[8] = right_bucket_origin_inertia_xx;
    w[13] = right_bucket_base_second_moment_xx;
    w[14] = right_bucket_base_second_moment_zz;

    /* wheel: origin inertia */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal wheel = p[1]; /* kg */
    const wreal radius = p[2]; /* m */
    const wreal wheel_origin_inertia_yy = radius * radius * (0.5 * wheel);

    /* axle: coupling */
    const wreal radius_inverse = 1.0 / radius;

    /* trolley: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal trolley_mass = p[10]; /* kg */
    const wreal trolley_base_mass = left_load + right_load + (wheel + trolley_mass);

    /* momentum */
    /* momentum = composite inertia S */
    const wreal momentum_track_my = wheel_origin_inertia_yy * radius_inverse;

    /* M: factor */
    /* M = S . momentum */
    /* factor = L, D with M = Lᵀ D L */
    const wreal M_track_track = trolley_base_mass + radius_inverse * momentum_track_my;
    const wreal M_factor_D_inverse_right_hang_angle2 = 1.0 / right_bucket_origin_inertia_xx;
    const wreal M_factor_D_inverse_left_hang_angle2 = 1.0 / left_bucket_origin_inertia_xx;
    w[15] = M_track_track;
    w[16] = M_factor_D_inverse_right_hang_angle2;
    w[17] = M_factor_D_inverse_left_hang_angle2;

    /* parameters as they are */
    w[0] = p[4]; /* left.rope [m] */
    w[1] = p[7]; /* right.rope [m] */
    w[2] = p[9]; /* gravity.z [m/s^2] */
    w[9] = p[11]; /* buffer.stiffness [N/m] */
    w[10] = p[12]; /* buffer.rest [m] */
}

#include "lanes.h"

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const t = in->t;
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const r = in->r;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    (void)work;

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real left_hang_angle1 = q[1]; /* rad */
    const real left_hang_angle2 = q[2]; /* rad */
    const real right_hang_angle1 = q[3]; /* rad */
    const real right_hang_angle2 = q[4]; /* rad */
    const real angle[CARDAN_PADDED(4)] = {left_hang_angle1, left_hang_angle2, right_hang_angle1,
        right_hang_angle2};
    real sine[CARDAN_PADDED(4)], cosine[CARDAN_PADDED(4)];
    cardan_sincos(4, angle, sine, cosine);
    const real left_hang_angle1_cos = cosine[0];
    const real left_hang_angle1_sin = sine[0];
    const real left_hang_angle2_cos = cosine[1];
    const real left_hang_angle2_sin = sine[1];
    const real right_hang_angle1_cos = cosine[2];
    const real right_hang_angle1_sin = sine[2];
    const real right_hang_angle2_cos = cosine[3];
    const real right_hang_angle2_sin = sine[3];

    /* left.hang: R, drift */
    /* R = R_fixed R_joint(q) */
    /* drift = S' u + [0; omega x v] */
    const real left_hang_u_angle1 = u[1]; /* rad/s */
    const real left_hang_u_angle2 = u[2]; /* rad/s */
    const real left_hang_R_yx = left_hang_angle1_sin * left_hang_angle2_sin;
    const real left_hang_minus_R_yz = left_hang_angle1_sin * left_hang_angle2_cos;
    const real left_hang_u_angle1_times_hang_u_angle2 = left_hang_u_angle1 * left_hang_u_angle2;
    const real left_hang_minus_drift_relative_wx = left_hang_angle2_sin *
        left_hang_u_angle1_times_hang_u_angle2;

    /* left.bucket: omega, alpha, v, a, U, n */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* v = Rᵀ (v_parent + omega_parent x p) + S_v u */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real track_u = u[0]; /* m/s */
    const wreal gravity_z = w[2]; /* m/s^2 */
    const wreal left_bucket_base_second_moment_xx = w[11];
    const real left_bucket_omega_x = left_hang_u_angle1 * left_hang_angle2_cos;
    const real left_bucket_omega_z = left_hang_u_angle1 * left_hang_angle2_sin;
    const real left_bucket_alpha_z = left_hang_angle2_cos * left_hang_u_angle1_times_hang_u_angle2;
    const real left_bucket_v_x = track_u * left_hang_angle2_cos;
    const real left_bucket_v_z = track_u * left_hang_angle2_sin;
    const real left_bucket_a_x = left_hang_angle1_cos * left_hang_angle2_sin * gravity_z;
    const real left_hang_u_angle2_times_left_bucket_omega_x = left_hang_u_angle2 *
        left_bucket_omega_x;
    const real left_bucket_U_xz = left_bucket_omega_x * left_bucket_omega_z;
    const real left_hang_u_angle2_times_left_bucket_omega_z = left_hang_u_angle2 *
        left_bucket_omega_z;
    const real left_bucket_U_xy = left_hang_u_angle2_times_left_bucket_omega_x
        - left_bucket_alpha_z;
    const real left_bucket_U_yx = left_bucket_alpha_z
        + left_hang_u_angle2_times_left_bucket_omega_x;
    const real left_bucket_U_yz = left_hang_minus_drift_relative_wx
        + left_hang_u_angle2_times_left_bucket_omega_z;
    const real left_bucket_U_zy = left_hang_u_angle2_times_left_bucket_omega_z
        - left_hang_minus_drift_relative_wx;
    const real left_bucket_n_z = left_bucket_base_second_moment_xx * left_bucket_U_yx
        - left_bucket_base_second_moment_xx * left_bucket_U_xy;

    /* right.hang: R, drift */
    /* R = R_fixed R_joint(q) */
    /* drift = S' u + [0; omega x v] */
    const real right_hang_u_angle1 = u[3]; /* rad/s */
    const real right_hang_u_angle2 = u[4]; /* rad/s */
    const real right_hang_R_yx = right_hang_angle1_sin * right_hang_angle2_sin;
    const real right_hang_minus_R_yz = right_hang_angle1_sin * right_hang_angle2_cos;
    const real right_hang_u_angle1_times_hang_u_angle2 = right_hang_u_angle1 * right_hang_u_angle2;
    const real right_hang_minus_drift_relative_wx = right_hang_angle2_sin *
        right_hang_u_angle1_times_hang_u_angle2;

    /* right.bucket: omega, alpha, v, a, U, n */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* v = Rᵀ (v_parent + omega_parent x p) + S_v u */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal right_bucket_base_second_moment_xx = w[13];
    const real right_bucket_omega_x = right_hang_u_angle1 * right_hang_angle2_cos;
    const real right_bucket_omega_z = right_hang_u_angle1 * right_hang_angle2_sin;
    const real right_bucket_alpha_z = right_hang_angle2_cos *
        right_hang_u_angle1_times_hang_u_angle2;
    const real right_bucket_v_x = track_u * right_hang_angle2_cos;
    const real right_bucket_v_z = track_u * right_hang_angle2_sin;
    const real right_bucket_a_x = right_hang_angle1_cos * right_hang_angle2_sin * gravity_z;
    const real right_hang_u_angle2_times_right_bucket_omega_x = right_hang_u_angle2 *
        right_bucket_omega_x;
    const real right_bucket_U_xz = right_bucket_omega_x * right_bucket_omega_z;
    const real right_hang_u_angle2_times_right_bucket_omega_z = right_hang_u_angle2 *
        right_bucket_omega_z;
    const real right_bucket_U_xy = right_hang_u_angle2_times_right_bucket_omega_x
        - right_bucket_alpha_z;
    const real right_bucket_U_yx = right_bucket_alpha_z
        + right_hang_u_angle2_times_right_bucket_omega_x;
    const real right_bucket_U_yz = right_hang_minus_drift_relative_wx
        + right_hang_u_angle2_times_right_bucket_omega_z;
    const real right_bucket_U_zy = right_hang_u_angle2_times_right_bucket_omega_z
        - right_hang_minus_drift_relative_wx;
    const real right_bucket_n_z = right_bucket_base_second_moment_xx * right_bucket_U_yx
        - right_bucket_base_second_moment_xx * right_bucket_U_xy;

    /* left.air: force, data */
    /* force = R (its components) at the origin */
    const wreal left_rope = w[0]; /* m */
    const real left_bucket_v_x_minus_left_rope_times_hang_u_angle2 = left_bucket_v_x
        - left_rope * left_hang_u_angle2;
    const real left_air_minus_force_on_left_middle_x = 2.0 * (left_hang_angle2_cos *
        left_bucket_v_x_minus_left_rope_times_hang_u_angle2
        + left_hang_angle2_sin * left_bucket_v_z);
    const real left_air_minus_force_on_left_middle_y = 2.0 * (left_hang_R_yx *
        left_bucket_v_x_minus_left_rope_times_hang_u_angle2
        - left_hang_minus_R_yz * left_bucket_v_z
        + left_rope * left_bucket_omega_x * left_hang_angle1_cos);
    const real left_bucket_n_y_part = left_hang_angle2_cos * left_air_minus_force_on_left_middle_x +
        left_hang_R_yx * left_air_minus_force_on_left_middle_y;

    /* right.air: force, data */
    /* force = R (its components) at the origin */
    const wreal right_rope = w[1]; /* m */
    const real right_bucket_v_x_minus_right_rope_times_hang_u_angle2 = right_bucket_v_x
        - right_rope * right_hang_u_angle2;
    const real right_air_minus_force_on_right_middle_x = 2.0 * (right_hang_angle2_cos *
        right_bucket_v_x_minus_right_rope_times_hang_u_angle2
        + right_hang_angle2_sin * right_bucket_v_z);
    const real right_air_minus_force_on_right_middle_y = 2.0 * (right_hang_R_yx *
        right_bucket_v_x_minus_right_rope_times_hang_u_angle2
        - right_hang_minus_R_yz * right_bucket_v_z
        + right_rope * right_bucket_omega_x * right_hang_angle1_cos);
    const real right_bucket_n_y_part = right_hang_angle2_cos *
        right_air_minus_force_on_right_middle_x
        + right_hang_R_yx * right_air_minus_force_on_right_middle_y;

    /* momentum */
    /* momentum = composite inertia S */
    const wreal left_bucket_origin_inertia_zz = w[3];
    const wreal left_bucket_minus_first_moment_z = w[4];
    const wreal left_bucket_origin_inertia_xx = w[5];
    const wreal right_bucket_origin_inertia_zz = w[6];
    const wreal right_bucket_minus_first_moment_z = w[7];
    const wreal right_bucket_origin_inertia_xx = w[8];
    const real momentum_right_hang_angle1_mx = right_bucket_origin_inertia_xx *
        right_hang_angle2_cos;
    const real momentum_right_hang_angle1_mz = right_bucket_origin_inertia_zz *
        right_hang_angle2_sin;
    const real momentum_left_hang_angle1_mx = left_bucket_origin_inertia_xx * left_hang_angle2_cos;
    const real momentum_left_hang_angle1_mz = left_bucket_origin_inertia_zz * left_hang_angle2_sin;
    const real momentum_right_hang_angle1_fy = right_bucket_minus_first_moment_z *
        right_hang_angle2_cos;
    const real momentum_left_hang_angle1_fy = left_bucket_minus_first_moment_z *
        left_hang_angle2_cos;

    /* M: factor */
    /* M = S . momentum */
    /* factor = L, D with M = Lᵀ D L */
    const wreal M_track_track = w[15];
    const wreal M_factor_D_inverse_right_hang_angle2 = w[16];
    const wreal M_factor_D_inverse_left_hang_angle2 = w[17];
    const real M_right_hang_angle1_right_hang_angle1 = right_hang_angle2_cos *
        momentum_right_hang_angle1_mx + right_hang_angle2_sin * momentum_right_hang_angle1_mz;
    const real M_left_hang_angle1_left_hang_angle1 = left_hang_angle2_cos *
        momentum_left_hang_angle1_mx + left_hang_angle2_sin * momentum_left_hang_angle1_mz;
    const real M_minus_factor_L_right_hang_angle2_track = momentum_right_hang_angle1_fy *
        M_factor_D_inverse_right_hang_angle2;
    const real M_minus_factor_L_left_hang_angle2_track = momentum_left_hang_angle1_fy *
        M_factor_D_inverse_left_hang_angle2;
    const real M_factor_D_inverse_track = 1.0 / (M_track_track
        - momentum_right_hang_angle1_fy * M_minus_factor_L_right_hang_angle2_track
        - momentum_left_hang_angle1_fy * M_minus_factor_L_left_hang_angle2_track);

    /* left.bucket: n, f */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const wreal left_bucket_base_second_moment_zz = w[12];
    const real left_bucket_n_x = left_bucket_base_second_moment_xx * left_bucket_U_zy
        - gravity_z * left_hang_angle1_sin * left_bucket_minus_first_moment_z
        - left_bucket_base_second_moment_zz * left_bucket_U_yz
        + left_hang_angle1_cos * left_air_minus_force_on_left_middle_y * left_rope;
    const real left_bucket_n_y = left_bucket_base_second_moment_zz * left_bucket_U_xz
        - left_bucket_base_second_moment_xx * left_bucket_U_xz
        - left_bucket_minus_first_moment_z * left_bucket_a_x - left_rope * left_bucket_n_y_part;
    const real left_bucket_f_x = left_bucket_n_y_part
        - left_bucket_minus_first_moment_z * left_bucket_U_xz;
    const real left_bucket_f_z = left_hang_angle2_sin * left_air_minus_force_on_left_middle_x
        + left_bucket_minus_first_moment_z * (left_bucket_omega_x * left_bucket_omega_x
        + left_hang_u_angle2 * left_hang_u_angle2)
        - left_hang_minus_R_yz * left_air_minus_force_on_left_middle_y;

    /* right.bucket: n, f */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const wreal right_bucket_base_second_moment_zz = w[14];
    const real right_bucket_n_x = right_bucket_base_second_moment_xx * right_bucket_U_zy
        - gravity_z * right_hang_angle1_sin * right_bucket_minus_first_moment_z
        - right_bucket_base_second_moment_zz * right_bucket_U_yz
        + right_hang_angle1_cos * right_air_minus_force_on_right_middle_y * right_rope;
    const real right_bucket_n_y = right_bucket_base_second_moment_zz * right_bucket_U_xz
        - right_bucket_base_second_moment_xx * right_bucket_U_xz
        - right_bucket_minus_first_moment_z * right_bucket_a_x - right_rope * right_bucket_n_y_part;
    const real right_bucket_f_x = right_bucket_n_y_part
        - right_bucket_minus_first_moment_z * right_bucket_U_xz;
    const real right_bucket_f_z = right_hang_angle2_sin * right_air_minus_force_on_right_middle_x
        + right_bucket_minus_first_moment_z * (right_bucket_omega_x * right_bucket_omega_x
        + right_hang_u_angle2 * right_hang_u_angle2)
        - right_hang_minus_R_yz * right_air_minus_force_on_right_middle_y;

    /* right.hang: tau, drive, udot */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    /* udot = M⁻¹ drive */
    const real right_hang_u_angle1_tau = tau[3]; /* N*m */
    const real right_hang_u_angle2_tau = tau[4]; /* N*m */
    const real right_hang_tau_angle1 = right_hang_angle2_cos * right_bucket_n_x
        + right_hang_angle2_sin * right_bucket_n_z;
    const real right_hang_drive_angle1 = right_hang_u_angle1_tau - right_hang_tau_angle1;
    const real right_hang_drive_angle2 = right_hang_u_angle2_tau - right_bucket_n_y;
    /* udot: right.hang.u.angle1dot [rad/s^2] */
    out[3] = 1.0 / M_right_hang_angle1_right_hang_angle1 * right_hang_drive_angle1;

    /* left.hang: tau, drive, udot */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    /* udot = M⁻¹ drive */
    const real left_hang_u_angle1_tau = tau[1]; /* N*m */
    const real left_hang_u_angle2_tau = tau[2]; /* N*m */
    const real left_hang_tau_angle1 = left_hang_angle2_cos * left_bucket_n_x
        + left_hang_angle2_sin * left_bucket_n_z;
    const real left_hang_drive_angle1 = left_hang_u_angle1_tau - left_hang_tau_angle1;
    const real left_hang_drive_angle2 = left_hang_u_angle2_tau - left_bucket_n_y;
    /* udot: left.hang.u.angle1dot [rad/s^2] */
    out[1] = 1.0 / M_left_hang_angle1_left_hang_angle1 * left_hang_drive_angle1;

    /* trolley: f */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real trolley_f_x = right_hang_angle2_sin * right_bucket_f_z
        + left_hang_angle2_sin * left_bucket_f_z + (right_hang_angle2_cos * right_bucket_f_x
        + left_hang_angle2_cos * left_bucket_f_x);

    /* track: tau, drive, udot */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    /* udot = M⁻¹ drive */
    const real track_q = q[0]; /* m */
    const real push = r[0]; /* N */
    const real t_value = t[0]; /* s */
    const real track_u_tau = tau[0]; /* N */
    const wreal buffer_stiffness = w[9]; /* N/m */
    const wreal buffer_rest = w[10]; /* m */
    const real track_tau = buffer_stiffness * (track_q - buffer_rest)
        - cardan_piecewise(4, 4, table_0_forward_dynamics_breaks,
        table_0_forward_dynamics_coefficients, 0, track_u) - push * cardan_tanh(2.0 * t_value)
        + trolley_f_x;
    const real track_drive = track_u_tau - track_tau;
    const real track_udot = M_factor_D_inverse_track * (right_hang_drive_angle2 *
        M_minus_factor_L_right_hang_angle2_track
        + left_hang_drive_angle2 * M_minus_factor_L_left_hang_angle2_track + track_drive);
    out[0] = track_udot; /* udot: track.udot [m/s^2] */

    /* left.hang: udot */
    /* udot = M⁻¹ drive */
    /* udot: left.hang.u.angle2dot [rad/s^2] */
    out[2] = left_hang_drive_angle2 * M_factor_D_inverse_left_hang_angle2
        + M_minus_factor_L_left_hang_angle2_track * track_udot;

    /* right.hang: udot */
    /* udot = M⁻¹ drive */
    /* udot: right.hang.u.angle2dot [rad/s^2] */
    out[4] = right_hang_drive_angle2 * M_factor_D_inverse_right_hang_angle2
        + M_minus_factor_L_right_hang_angle2_track * track_udot;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {5, 0, 18, 1, 5, 5, 0, 0, 1, 13, 0, 0, 0, 0, 5, 0, 0, 0, 0, 0};
#endif
