/*
 * inverse_dynamics of bucket
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 2, work 0, w 5
 * Operations per call: 58 = 36 mul, 11 sub, 7 add, 2 cos, 2 sin
 * Operations of prepare: 13 = 8 mul, 3 add, 2 sub
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
 * Input udot (2): derivatives of the speeds
 *   udot[0]  hang.u.angle1dot [rad/s^2]
 *   udot[1]  hang.u.angle2dot [rad/s^2]
 *
 * Output tau (2)
 *   out[0]  hang.u.angle1.tau [N*m]
 *   out[1]  hang.u.angle2.tau [N*m]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
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
    w[2] = bucket_minus_first_moment_z;
    w[3] = bucket_base_second_moment_xx;
    w[4] = bucket_base_second_moment_zz;

    /* parameters as they are */
    w[0] = p[1]; /* rope [m] */
    w[1] = p[3]; /* gravity.z [m/s^2] */
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

    /* bucket: a, omega, alpha, U, n */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* U = [alpha] + [omega][omega] */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real hang_u_angle1dot = udot[0]; /* rad/s^2 */
    const real hang_u_angle2dot = udot[1]; /* rad/s^2 */
    const wreal gravity_z = w[1]; /* m/s^2 */
    const wreal bucket_base_second_moment_xx = w[3];
    const real bucket_a_x = hang_angle1_cos * hang_angle2_sin * gravity_z;
    const real bucket_omega_x = hang_u_angle1 * hang_angle2_cos;
    const real bucket_omega_z = hang_u_angle1 * hang_angle2_sin;
    const real bucket_alpha_x = hang_u_angle1dot * hang_angle2_cos
        - hang_angle2_sin * hang_u_angle1_times_u_angle2;
    const real bucket_alpha_z = hang_angle2_cos * hang_u_angle1_times_u_angle2
        + hang_u_angle1dot * hang_angle2_sin;
    const real hang_u_angle2_times_bucket_omega_x = hang_u_angle2 * bucket_omega_x;
    const real bucket_omega_x_times_omega_z = bucket_omega_x * bucket_omega_z;
    const real hang_u_angle2_times_bucket_omega_z = hang_u_angle2 * bucket_omega_z;
    const real bucket_U_xy = hang_u_angle2_times_bucket_omega_x - bucket_alpha_z;
    const real bucket_U_yx = bucket_alpha_z + hang_u_angle2_times_bucket_omega_x;
    const real bucket_n_z = bucket_base_second_moment_xx * bucket_U_yx
        - bucket_base_second_moment_xx * bucket_U_xy;
    const real bucket_U_xz = hang_u_angle2dot + bucket_omega_x_times_omega_z;
    const real bucket_U_zx = bucket_omega_x_times_omega_z - hang_u_angle2dot;
    const real bucket_U_yz = hang_u_angle2_times_bucket_omega_z - bucket_alpha_x;
    const real bucket_U_zy = bucket_alpha_x + hang_u_angle2_times_bucket_omega_z;

    /* air: force, data */
    /* force = R (its components) at the origin */
    const wreal rope = w[0]; /* m */
    const real rope_times_hang_u_angle2 = rope * hang_u_angle2;
    const real air_minus_force_on_middle_y = 2.0 * (rope * bucket_omega_x * hang_angle1_cos
        - hang_R_yx * rope_times_hang_u_angle2);

    /* bucket: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal bucket_minus_first_moment_z = w[2];
    const wreal bucket_base_second_moment_zz = w[4];
    const real bucket_n_x = bucket_base_second_moment_xx * bucket_U_zy
        - gravity_z * hang_angle1_sin * bucket_minus_first_moment_z
        - bucket_base_second_moment_zz * bucket_U_yz
        + hang_angle1_cos * air_minus_force_on_middle_y * rope;
    /* tau: hang.u.angle2.tau [N*m] */
    out[1] = bucket_base_second_moment_zz * bucket_U_xz
        - bucket_minus_first_moment_z * bucket_a_x - bucket_base_second_moment_xx * bucket_U_zx
        + rope * (hang_angle2_cos * rope_times_hang_u_angle2 * 2.0 * hang_angle2_cos
        - hang_R_yx * air_minus_force_on_middle_y);

    /* hang: tau */
    /* tau = S . [n; f] - force on the joint */
    /* tau: hang.u.angle1.tau [N*m] */
    out[0] = hang_angle2_cos * bucket_n_x + hang_angle2_sin * bucket_n_z;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {2, 0, 5, 0, 2, 2, 0, 0, 0, 4, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
