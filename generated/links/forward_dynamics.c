/*
 * forward_dynamics of links
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 2, work 0, w 9
 * Operations per call: 42 = 23 mul, 8 add, 6 sub, 2 cos, 2 sin, 1 div
 * Operations of prepare: 13 = 7 mul, 5 add, 1 div
 *
 * Input q (2): generalized coordinates
 *   q[0]  shoulder [rad]
 *   q[1]  elbow [rad]
 *
 * Input u (2): generalized speeds
 *   u[0]  shoulder.u [rad/s]
 *   u[1]  elbow.u [rad/s]
 *
 * Input p (10): parameters, read by prepare_ only
 *
 * Input tau (2): applied generalized forces
 *   tau[0]  shoulder.u.tau [N*m]
 *   tau[1]  elbow.u.tau [N*m]
 *
 * Output udot (2)
 *   out[0]  shoulder.udot [rad/s^2]
 *   out[1]  elbow.udot [rad/s^2]
 */
#include "cardan.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* upper: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal upper_mass = p[4]; /* kg */
    const wreal upper_com_z = p[5]; /* m */
    const wreal upper_inertia_yy = p[7]; /* kg m^2 */
    const wreal upper_first_moment_z = upper_mass * upper_com_z;
    const wreal upper_origin_inertia_yy = upper_inertia_yy + upper_com_z * upper_first_moment_z;

    /* lower: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal m = p[0]; /* kg */
    const wreal elbow_position_z = p[8]; /* m */
    const wreal lower_com_z = p[9]; /* m */
    const wreal lower_first_moment_z = m * lower_com_z;
    const wreal lower_origin_inertia_xx = 0.053333333333333344 * m
        + lower_com_z * lower_first_moment_z;
    const wreal lower_base_mass_moment_z = m * elbow_position_z;
    w[4] = lower_first_moment_z;
    w[5] = lower_origin_inertia_xx;

    /* upper: base, inertia */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal upper_base_moment_z = upper_first_moment_z + lower_base_mass_moment_z;
    const wreal upper_base_inertia_yy = upper_origin_inertia_yy
        + elbow_position_z * lower_base_mass_moment_z;
    const wreal lower_origin_inertia_xx_plus_upper_base_inertia_yy = lower_origin_inertia_xx
        + upper_base_inertia_yy;
    w[6] = upper_base_moment_z;
    w[7] = lower_origin_inertia_xx_plus_upper_base_inertia_yy;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal M_factor_D_inverse_elbow = 1.0 / lower_origin_inertia_xx;
    w[8] = M_factor_D_inverse_elbow;

    /* parameters as they are */
    w[0] = p[1]; /* k [N m/rad] */
    w[1] = p[2]; /* d [N m s/rad] */
    w[2] = p[3]; /* gravity.z [m/s^2] */
    w[3] = p[8]; /* elbow.position.z [m] */
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
    const real shoulder_q = q[0]; /* rad */
    const real elbow_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(2)] = {elbow_q, shoulder_q};
    real sine[CARDAN_PADDED(2)], cosine[CARDAN_PADDED(2)];
    cardan_sincos(2, angle, sine, cosine);
    const real elbow_cos = cosine[0];
    const real elbow_sin = sine[0];
    const real shoulder_cos = cosine[1];
    const real shoulder_sin = sine[1];

    /* shared by several: inertia */
    const wreal elbow_position_z = w[3]; /* m */
    const wreal lower_first_moment_z = w[4];
    const real elbow_position_z_times_upper_inertia_mean_moment_z = lower_first_moment_z * elbow_cos
        * elbow_position_z;

    /* upper: composite, a */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    const wreal gravity_z = w[2]; /* m/s^2 */
    const wreal lower_origin_inertia_xx_plus_upper_base_inertia_yy = w[7];
    const real upper_composite_inertia_yy = 2.0 * elbow_position_z_times_upper_inertia_mean_moment_z
        + lower_origin_inertia_xx_plus_upper_base_inertia_yy;
    const real upper_a_x = gravity_z * shoulder_sin;

    /* M: factor */
    /* M = S . momentum */
    /* factor = L, D with M = Lᵀ D L */
    const wreal lower_origin_inertia_xx = w[5];
    const wreal M_factor_D_inverse_elbow = w[8];
    const real M_elbow_shoulder = lower_origin_inertia_xx
        + elbow_position_z_times_upper_inertia_mean_moment_z;
    const real M_factor_L_elbow_shoulder = M_elbow_shoulder * M_factor_D_inverse_elbow;

    /* lower: omega, a, n */
    /* omega = Rᵀ omega_parent + S_w u */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real shoulder_u = u[0]; /* rad/s */
    const real elbow_u = u[1]; /* rad/s */
    const real lower_omega_y = shoulder_u + elbow_u;
    const real lower_a_x = elbow_cos * upper_a_x + elbow_sin * (gravity_z * shoulder_cos
        + shoulder_u * shoulder_u * elbow_position_z);
    const real lower_n_y = lower_first_moment_z * lower_a_x;

    /* upper: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal upper_base_moment_z = w[6];
    const real upper_n_y = upper_base_moment_z * upper_a_x
        - lower_omega_y * lower_omega_y * lower_first_moment_z * elbow_sin * elbow_position_z
        + lower_n_y;

    /* elbow: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real elbow_u_tau = tau[1]; /* N*m */
    const wreal k = w[0]; /* N m/rad */
    const wreal d = w[1]; /* N m s/rad */
    const real elbow_tau = k * elbow_q + d * elbow_u + lower_n_y;
    const real elbow_drive = elbow_u_tau - elbow_tau;

    /* shoulder: drive, udot */
    /* drive = tau + f - h */
    /* udot = M⁻¹ drive */
    const real shoulder_u_tau = tau[0]; /* N*m */
    const real shoulder_drive = shoulder_u_tau - upper_n_y;
    const real shoulder_udot = 1.0 / (upper_composite_inertia_yy
        - M_elbow_shoulder * M_factor_L_elbow_shoulder) * (shoulder_drive
        - elbow_drive * M_factor_L_elbow_shoulder);
    out[0] = shoulder_udot; /* udot: shoulder.udot [rad/s^2] */

    /* elbow: udot */
    /* udot = M⁻¹ drive */
    /* udot: elbow.udot [rad/s^2] */
    out[1] = elbow_drive * M_factor_D_inverse_elbow - M_factor_L_elbow_shoulder * shoulder_udot;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {2, 0, 9, 0, 2, 2, 0, 0, 0, 10, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0};
#endif
