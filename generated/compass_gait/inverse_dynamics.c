/*
 * inverse_dynamics of compass_gait
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 2, work 0, w 6
 * Operations per call: 32 = 17 mul, 7 add, 3 sub, 2 cos, 2 sin, 1 neg
 * Operations of prepare: 20 = 10 mul, 8 add, 2 sub
 *
 * Input q (2): generalized coordinates
 *   q[0]  stance [rad]
 *   q[1]  hip [rad]
 *
 * Input u (2): generalized speeds
 *   u[0]  stance.u [rad/s]
 *   u[1]  hip.u [rad/s]
 *
 * Input p (9): parameters, read by prepare_ only
 *
 * Input udot (2): derivatives of the speeds
 *   udot[0]  stance.udot [rad/s^2]
 *   udot[1]  hip.udot [rad/s^2]
 *
 * Output tau (2)
 *   out[0]  stance.u.tau [N*m]
 *   out[1]  hip.u.tau [N*m]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* stance_leg: mass */
    const wreal stance_leg_mass = p[2]; /* kg */
    const wreal stance_leg_com_z = p[3]; /* m */
    const wreal stance_leg_mass_times_com_z = stance_leg_mass * stance_leg_com_z;

    /* hip_mass: mass */
    const wreal top_position_z = p[4]; /* m */
    const wreal hip_mass_mass = p[5]; /* kg */
    const wreal top_position_z_times_hip_mass_mass = top_position_z * hip_mass_mass;

    /* swing_leg: first moment, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal hip_position_z = p[6]; /* m */
    const wreal swing_leg_mass = p[7]; /* kg */
    const wreal swing_leg_com_z = p[8]; /* m */
    const wreal swing_leg_first_moment_z = swing_leg_mass * swing_leg_com_z;
    const wreal swing_leg_origin_inertia_xx = swing_leg_com_z * swing_leg_first_moment_z;
    const wreal swing_leg_base_mass_moment_z = hip_position_z * swing_leg_mass;
    const wreal swing_leg_base_second_moment_zz = 0.5 * (swing_leg_origin_inertia_xx
        + swing_leg_origin_inertia_xx);
    const wreal swing_leg_base_second_moment_xx = swing_leg_base_second_moment_zz
        - swing_leg_origin_inertia_xx;
    const wreal swing_leg_base_second_moment_zz_plus_base_second_moment_xx =
        swing_leg_base_second_moment_zz + swing_leg_base_second_moment_xx;
    w[2] = swing_leg_first_moment_z;
    w[5] = swing_leg_base_second_moment_zz_plus_base_second_moment_xx;

    /* stance_leg: first moment, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal stance_leg_first_moment_z = stance_leg_mass_times_com_z
        + top_position_z_times_hip_mass_mass;
    const wreal stance_leg_origin_inertia_xx = stance_leg_com_z * stance_leg_mass_times_com_z
        + top_position_z * top_position_z_times_hip_mass_mass;
    const wreal stance_leg_base_moment_z = stance_leg_first_moment_z + swing_leg_base_mass_moment_z;
    const wreal stance_leg_base_half_trace = 0.5 * (stance_leg_origin_inertia_xx
        + stance_leg_origin_inertia_xx);
    const wreal stance_leg_base_second_moment_xx = stance_leg_base_half_trace
        - stance_leg_origin_inertia_xx;
    const wreal stance_leg_base_second_moment_zz = hip_position_z * swing_leg_base_mass_moment_z
        + stance_leg_base_half_trace;
    const wreal stance_leg_base_second_moment_xx_plus_base_second_moment_zz =
        stance_leg_base_second_moment_xx + stance_leg_base_second_moment_zz;
    w[3] = stance_leg_base_moment_z;
    w[4] = stance_leg_base_second_moment_xx_plus_base_second_moment_zz;

    /* parameters as they are */
    w[0] = p[1]; /* gravity.z [m/s^2] */
    w[1] = p[6]; /* hip.position.z [m] */
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

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real stance_q = q[0]; /* rad */
    const real hip_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(2)] = {stance_q, hip_q};
    real sine[CARDAN_PADDED(2)], cosine[CARDAN_PADDED(2)];
    cardan_sincos(2, angle, sine, cosine);
    const real stance_cos = cosine[0];
    const real stance_sin = sine[0];
    const real hip_cos = cosine[1];
    const real hip_sin = sine[1];

    /* stance_leg: a */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const real stance_leg_minus_a_x = gravity_z * stance_sin;

    /* swing_leg: omega, U, f */
    /* omega = Rᵀ omega_parent + S_w u */
    /* U = [alpha] + [omega][omega] */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real stance_u = u[0]; /* rad/s */
    const real hip_u = u[1]; /* rad/s */
    const real stance_udot = udot[0]; /* rad/s^2 */
    const real hip_udot = udot[1]; /* rad/s^2 */
    const wreal hip_position_z = w[1]; /* m */
    const wreal swing_leg_first_moment_z = w[2];
    const real swing_leg_minus_omega_y = stance_u + hip_u;
    const real swing_leg_U_zx = stance_udot + hip_udot;
    const real stance_leg_n_y_part = hip_position_z * (swing_leg_minus_omega_y *
        swing_leg_minus_omega_y * swing_leg_first_moment_z * hip_sin
        - swing_leg_first_moment_z * swing_leg_U_zx * hip_cos);

    /* hip: tau */
    /* tau = S . [n; f] - force on the joint */
    const wreal swing_leg_base_second_moment_zz_plus_base_second_moment_xx = w[5];
    const real hip_tau = swing_leg_U_zx * swing_leg_base_second_moment_zz_plus_base_second_moment_xx
        + swing_leg_first_moment_z * (hip_cos * (stance_leg_minus_a_x
        + hip_position_z * stance_udot) + hip_sin * (gravity_z * stance_cos
        + stance_u * stance_u * hip_position_z));
    out[1] = hip_tau; /* tau: hip.u.tau [N*m] */

    /* stance_leg: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal stance_leg_base_moment_z = w[3];
    const wreal stance_leg_base_second_moment_xx_plus_base_second_moment_zz = w[4];
    const real stance_leg_n_y = stance_leg_n_y_part
        - (stance_udot * stance_leg_base_second_moment_xx_plus_base_second_moment_zz
        + stance_leg_base_moment_z * stance_leg_minus_a_x) - hip_tau;

    /* stance: tau */
    /* tau = S . [n; f] - force on the joint */
    out[0] = -stance_leg_n_y; /* tau: stance.u.tau [N*m] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {2, 0, 6, 0, 2, 2, 0, 0, 0, 9, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
