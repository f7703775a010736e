/*
 * forward_dynamics of compass_gait
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 2, work 0, w 7
 * Operations per call: 38 = 21 mul, 6 add, 6 sub, 2 cos, 2 sin, 1 div
 * Operations of prepare: 14 = 8 mul, 5 add, 1 div
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
 * Input tau (2): applied generalized forces
 *   tau[0]  stance.u.tau [N*m]
 *   tau[1]  hip.u.tau [N*m]
 *
 * Output udot (2)
 *   out[0]  stance.udot [rad/s^2]
 *   out[1]  hip.udot [rad/s^2]
 */
#include "cardan.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* stance_leg: mass */
    const wreal stance_leg_mass = p[2]; /* kg */
    const wreal stance_leg_com_z = p[3]; /* m */
    const wreal stance_leg_mass_times_com_z = stance_leg_mass * stance_leg_com_z;

    /* hip_mass: mass */
    const wreal top_position_z = p[4]; /* m */
    const wreal hip_mass_mass = p[5]; /* kg */
    const wreal top_position_z_times_hip_mass_mass = top_position_z * hip_mass_mass;

    /* swing_leg: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal hip_position_z = p[6]; /* m */
    const wreal swing_leg_mass = p[7]; /* kg */
    const wreal swing_leg_com_z = p[8]; /* m */
    const wreal swing_leg_first_moment_z = swing_leg_mass * swing_leg_com_z;
    const wreal swing_leg_origin_inertia_xx = swing_leg_com_z * swing_leg_first_moment_z;
    const wreal swing_leg_base_mass_moment_z = hip_position_z * swing_leg_mass;
    w[2] = swing_leg_first_moment_z;
    w[3] = swing_leg_origin_inertia_xx;

    /* stance_leg: first moment, origin inertia, base, inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal stance_leg_first_moment_z = stance_leg_mass_times_com_z
        + top_position_z_times_hip_mass_mass;
    const wreal stance_leg_origin_inertia_xx = stance_leg_com_z * stance_leg_mass_times_com_z
        + top_position_z * top_position_z_times_hip_mass_mass;
    const wreal stance_leg_base_moment_z = stance_leg_first_moment_z + swing_leg_base_mass_moment_z;
    const wreal stance_leg_base_inertia_yy = stance_leg_origin_inertia_xx
        + hip_position_z * swing_leg_base_mass_moment_z;
    const wreal swing_leg_origin_inertia_xx_plus_stance_leg_base_inertia_yy =
        swing_leg_origin_inertia_xx + stance_leg_base_inertia_yy;
    w[4] = stance_leg_base_moment_z;
    w[5] = swing_leg_origin_inertia_xx_plus_stance_leg_base_inertia_yy;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal M_factor_D_inverse_hip = 1.0 / swing_leg_origin_inertia_xx;
    w[6] = M_factor_D_inverse_hip;

    /* parameters as they are */
    w[0] = p[1]; /* gravity.z [m/s^2] */
    w[1] = p[6]; /* hip.position.z [m] */
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

    /* shared by several: R */
    /* R = R_fixed R_joint(q) */
    const real stance_q = q[0]; /* rad */
    const real hip_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(2)] = {hip_q, stance_q};
    real sine[CARDAN_PADDED(2)], cosine[CARDAN_PADDED(2)];
    cardan_sincos(2, angle, sine, cosine);
    const real hip_cos = cosine[0];
    const real hip_sin = sine[0];
    const real stance_cos = cosine[1];
    const real stance_sin = sine[1];

    /* shared by several: inertia */
    const wreal hip_position_z = w[1]; /* m */
    const wreal swing_leg_first_moment_z = w[2];
    const real hip_position_z_times_stance_leg_inertia_mean_moment_z = swing_leg_first_moment_z *
        hip_cos * hip_position_z;

    /* stance_leg: composite, a */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const wreal swing_leg_origin_inertia_xx_plus_stance_leg_base_inertia_yy = w[5];
    const real stance_leg_composite_inertia_yy = 2.0 *
        hip_position_z_times_stance_leg_inertia_mean_moment_z
        + swing_leg_origin_inertia_xx_plus_stance_leg_base_inertia_yy;
    const real stance_leg_minus_a_x = gravity_z * stance_sin;

    /* M: factor */
    /* M = S . momentum */
    /* factor = L, D with M = Lᵀ D L */
    const wreal swing_leg_origin_inertia_xx = w[3];
    const wreal M_factor_D_inverse_hip = w[6];
    const real M_hip_stance = swing_leg_origin_inertia_xx
        + hip_position_z_times_stance_leg_inertia_mean_moment_z;
    const real M_factor_L_hip_stance = M_hip_stance * M_factor_D_inverse_hip;

    /* swing_leg: omega */
    /* omega = Rᵀ omega_parent + S_w u */
    const real stance_u = u[0]; /* rad/s */
    const real hip_u = u[1]; /* rad/s */
    const real swing_leg_minus_omega_y = stance_u + hip_u;

    /* hip: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real hip_u_tau = tau[1]; /* N*m */
    const real hip_tau = swing_leg_first_moment_z * (hip_cos * stance_leg_minus_a_x
        + hip_sin * (gravity_z * stance_cos + stance_u * stance_u * hip_position_z));
    const real hip_drive = hip_u_tau - hip_tau;

    /* stance_leg: f, n */
    /* f = inertia_force_f - applied_f + sum R f_child */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal stance_leg_base_moment_z = w[4];
    const real stance_leg_f_x = swing_leg_minus_omega_y * swing_leg_minus_omega_y *
        swing_leg_first_moment_z * hip_sin;
    const real stance_leg_n_y = hip_position_z * stance_leg_f_x
        - stance_leg_base_moment_z * stance_leg_minus_a_x - hip_tau;

    /* stance: drive, udot */
    /* drive = tau + f - h */
    /* udot = M⁻¹ drive */
    const real stance_u_tau = tau[0]; /* N*m */
    const real stance_drive = stance_u_tau + stance_leg_n_y;
    const real stance_udot = 1.0 / (stance_leg_composite_inertia_yy
        - M_hip_stance * M_factor_L_hip_stance) * (stance_drive
        - hip_drive * M_factor_L_hip_stance);
    out[0] = stance_udot; /* udot: stance.udot [rad/s^2] */

    /* hip: udot */
    /* udot = M⁻¹ drive */
    /* udot: hip.udot [rad/s^2] */
    out[1] = hip_drive * M_factor_D_inverse_hip - M_factor_L_hip_stance * stance_udot;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {2, 0, 7, 0, 2, 2, 0, 0, 0, 9, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0};
#endif
