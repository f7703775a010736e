/*
 * forward_dynamics of bucket
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 2, work 0, w 8
 * Operations per call: 62 = 40 mul, 11 sub, 6 add, 2 cos, 2 sin, 1 div
 * Operations of prepare: 14 = 8 mul, 3 add, 2 sub, 1 div
 *
 * Input q (2): generalized coordinates
 *   q[0]  hang.angle1 [rad]
 *   q[1]  hang.angle2 [rad]
 *
 * Input u (2): generalized speeds
 *   u[0]  hang.u.angle1 [rad/s]
 *   u[1]  hang.u.angle2 [rad/s]
 *
 * Input p (4): parameters, read by prepare_ only
 *
 * Input tau (2): applied generalized forces
 *   tau[0]  hang.u.angle1.tau [N*m]
 *   tau[1]  hang.u.angle2.tau [N*m]
 *
 * Output udot (2)
 *   out[0]  hang.u.angle1dot [rad/s^2]
 *   out[1]  hang.u.angle2dot [rad/s^2]
 */
#include "cardan.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* bucket: mass, origin inertia, base */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal load = p[0]; /* kg */
    const wreal rope = p[1]; /* m */
    const wreal size = p[2]; /* m */
    const wreal size_squared = size * size;
    const wreal bucket_origin_inertia_zz = 0.5 * load * size_squared;
    const wreal bucket_minus_first_moment_z = load * rope;
    const wreal bucket_origin_inertia_xx = 0.3333333333333333 * load * size_squared
        + rope * bucket_minus_first_moment_z;
    const wreal bucket_base_half_trace = 0.5 * (bucket_origin_inertia_zz
        + bucket_origin_inertia_xx + bucket_origin_inertia_xx);
    const wreal bucket_base_second_moment_xx = bucket_base_half_trace - bucket_origin_inertia_xx;
    const wreal bucket_base_second_moment_zz = bucket_base_half_trace - bucket_origin_inertia_zz;
    w[2] = bucket_origin_inertia_zz;
    w[3] = bucket_minus_first_moment_z;
    w[4] = bucket_origin_inertia_xx;
    w[5] = bucket_base_second_moment_xx;
    w[6] = bucket_base_second_moment_zz;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal M_factor_D_inverse_hang_angle2 = 1.0 / bucket_origin_inertia_xx;
    w[7] = M_factor_D_inverse_hang_angle2;

    /* parameters as they are */
    w[0] = p[1]; /* rope [m] */
    w[1] = p[3]; /* gravity.z [m/s^2] */
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
    (void)work;

    /* hang: R */
    /* R = R_fixed R_joint(q) */
    const real hang_angle1 = q[0]; /* rad */
    const real hang_angle2 = q[1]; /* rad */
    const real angle[CARDAN_PADDED(2)] = {hang_angle1, hang_angle2};
    real sine[CARDAN_PADDED(2)], cosine[CARDAN_PADDED(2)];
    cardan_sincos(2, angle, sine, cosine);
    const real hang_angle1_cos = cosine[0];
    const real hang_angle1_sin = sine[0];
    const real hang_angle2_cos = cosine[1];
    const real hang_angle2_sin = sine[1];

    /* hang: R, drift */
    /* R = R_fixed R_joint(q) */
    /* drift = S' u + [0; omega x v] */
    const real hang_u_angle1 = u[0]; /* rad/s */
    const real hang_u_angle2 = u[1]; /* rad/s */
    const real hang_R_yx = hang_angle1_sin * hang_angle2_sin;
    const real hang_u_angle1_times_u_angle2 = hang_u_angle1 * hang_u_angle2;
    const real hang_minus_drift_relative_wx = hang_angle2_sin * hang_u_angle1_times_u_angle2;

    /* bucket: omega, alpha, a, U, n */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal gravity_z = w[1]; /* m/s^2 */
    const wreal bucket_base_second_moment_xx = w[5];
    const real bucket_omega_x = hang_u_angle1 * hang_angle2_cos;
    const real bucket_omega_z = hang_u_angle1 * hang_angle2_sin;
    const real bucket_alpha_z = hang_angle2_cos * hang_u_angle1_times_u_angle2;
    const real bucket_a_x = hang_angle1_cos * hang_angle2_sin * gravity_z;
    const real hang_u_angle2_times_bucket_omega_x = hang_u_angle2 * bucket_omega_x;
    const real bucket_U_xz = bucket_omega_x * bucket_omega_z;
    const real hang_u_angle2_times_bucket_omega_z = hang_u_angle2 * bucket_omega_z;
    const real bucket_U_xy = hang_u_angle2_times_bucket_omega_x - bucket_alpha_z;
    const real bucket_U_yx = bucket_alpha_z + hang_u_angle2_times_bucket_omega_x;
    const real bucket_U_yz = hang_minus_drift_relative_wx + hang_u_angle2_times_bucket_omega_z;
    const real bucket_U_zy = hang_u_angle2_times_bucket_omega_z - hang_minus_drift_relative_wx;
    const real bucket_n_z = bucket_base_second_moment_xx * bucket_U_yx
        - bucket_base_second_moment_xx * bucket_U_xy;

    /* air: force, data */
    /* force = R (its components) at the origin */
    const wreal rope = w[0]; /* m */
    const real rope_times_hang_u_angle2 = rope * hang_u_angle2;
    const real air_minus_force_on_middle_y = 2.0 * (rope * bucket_omega_x * hang_angle1_cos
        - hang_R_yx * rope_times_hang_u_angle2);

    /* momentum */
    /* momentum = composite inertia S */
    const wreal bucket_origin_inertia_zz = w[2];
    const wreal bucket_origin_inertia_xx = w[4];
    const real momentum_hang_angle1_mx = bucket_origin_inertia_xx * hang_angle2_cos;
    const real momentum_hang_angle1_mz = bucket_origin_inertia_zz * hang_angle2_sin;

    /* M */
    /* M = S . momentum */
    const real M_hang_angle1_hang_angle1 = hang_angle2_cos * momentum_hang_angle1_mx
        + hang_angle2_sin * momentum_hang_angle1_mz;

    /* bucket: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal bucket_minus_first_moment_z = w[3];
    const wreal bucket_base_second_moment_zz = w[6];
    const real bucket_n_x = bucket_base_second_moment_xx * bucket_U_zy
        - gravity_z * hang_angle1_sin * bucket_minus_first_moment_z
        - bucket_base_second_moment_zz * bucket_U_yz
        + hang_angle1_cos * air_minus_force_on_middle_y * rope;
    const real bucket_n_y = bucket_base_second_moment_zz * bucket_U_xz
        - bucket_base_second_moment_xx * bucket_U_xz - bucket_minus_first_moment_z * bucket_a_x
        + rope * (hang_angle2_cos * rope_times_hang_u_angle2 * 2.0 * hang_angle2_cos
        - hang_R_yx * air_minus_force_on_middle_y);

    /* hang: tau, drive, udot */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    /* udot = M⁻¹ drive */
    const real hang_u_angle1_tau = tau[0]; /* N*m */
    const real hang_u_angle2_tau = tau[1]; /* N*m */
    const wreal M_factor_D_inverse_hang_angle2 = w[7];
    const real hang_tau_angle1 = hang_angle2_cos * bucket_n_x + hang_angle2_sin * bucket_n_z;
    const real hang_drive_angle1 = hang_u_angle1_tau - hang_tau_angle1;
    const real hang_drive_angle2 = hang_u_angle2_tau - bucket_n_y;
    /* udot: hang.u.angle1dot [rad/s^2] */
    out[0] = 1.0 / M_hang_angle1_hang_angle1 * hang_drive_angle1;
    /* udot: hang.u.angle2dot [rad/s^2] */
    out[1] = hang_drive_angle2 * M_factor_D_inverse_hang_angle2;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {2, 0, 8, 0, 2, 2, 0, 0, 0, 4, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0};
#endif
