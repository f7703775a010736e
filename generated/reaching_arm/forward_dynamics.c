/*
 * forward_dynamics of reaching_arm
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 2, work 0, w 7
 * Operations per call: 35 = 19 mul, 8 sub, 5 add, 1 cos, 1 div, 1 sin
 * Operations of prepare: 11 = 6 mul, 4 add, 1 div
 *
 * Input q (2): generalized coordinates
 *   q[0]  shoulder [rad]
 *   q[1]  elbow [rad]
 *
 * Input u (2): generalized speeds
 *   u[0]  shoulder.u [rad/s]
 *   u[1]  elbow.u [rad/s]
 *
 * Input r (2): inputs of the model
 *   r[0]  shoulder_torque [N m]
 *   r[1]  elbow_torque [N m]
 *
 * Input p (12): parameters, read by prepare_ only
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
    /* upper: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal upper_mass = p[0]; /* kg */
    const wreal upper_com_x = p[1]; /* m */
    const wreal upper_inertia_zz = p[3]; /* kg m^2 */
    const wreal elbow_position_x = p[4]; /* m */
    const wreal lower_mass = p[5]; /* kg */
    const wreal upper_first_moment_x = upper_mass * upper_com_x;
    const wreal upper_origin_inertia_zz = upper_inertia_zz + upper_com_x * upper_first_moment_x;
    const wreal upper_base_inertia_zz = upper_origin_inertia_zz
        + elbow_position_x * lower_mass * elbow_position_x;

    /* lower: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal lower_com_x = p[6]; /* m */
    const wreal lower_inertia_zz = p[8]; /* kg m^2 */
    const wreal lower_first_moment_x = lower_mass * lower_com_x;
    const wreal lower_origin_inertia_zz = lower_inertia_zz + lower_com_x * lower_first_moment_x;
    w[1] = lower_first_moment_x;
    w[2] = lower_origin_inertia_zz;

    /* upper: inertia */
    const wreal lower_origin_inertia_zz_plus_upper_base_inertia_zz = lower_origin_inertia_zz
        + upper_base_inertia_zz;
    w[5] = lower_origin_inertia_zz_plus_upper_base_inertia_zz;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal M_factor_D_inverse_elbow = 1.0 / lower_origin_inertia_zz;
    w[6] = M_factor_D_inverse_elbow;

    /* parameters as they are */
    w[0] = p[4]; /* elbow.position.x [m] */
    w[3] = p[10]; /* shoulder_bearing.damping [N*m*s/rad] */
    w[4] = p[11]; /* elbow_bearing.damping [N*m*s/rad] */
}

#include "lanes.h"

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const r = in->r;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    (void)work;

    /* elbow: R */
    /* R = R_fixed R_joint(q) */
    const real elbow_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {elbow_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real elbow_cos = cosine[0];
    const real elbow_sin = sine[0];

    /* shared by several: inertia */
    const wreal elbow_position_x = w[0]; /* m */
    const wreal lower_first_moment_x = w[1];
    const real elbow_position_x_times_upper_inertia_mean_moment_x = lower_first_moment_x * elbow_cos
        * elbow_position_x;

    /* upper: composite */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    const wreal lower_origin_inertia_zz_plus_upper_base_inertia_zz = w[5];
    const real upper_composite_inertia_zz = 2.0 * elbow_position_x_times_upper_inertia_mean_moment_x
        + lower_origin_inertia_zz_plus_upper_base_inertia_zz;

    /* M: factor */
    /* M = S . momentum */
    /* factor = L, D with M = Lᵀ D L */
    const wreal lower_origin_inertia_zz = w[2];
    const wreal M_factor_D_inverse_elbow = w[6];
    const real M_elbow_shoulder = lower_origin_inertia_zz
        + elbow_position_x_times_upper_inertia_mean_moment_x;
    const real M_factor_L_elbow_shoulder = M_elbow_shoulder * M_factor_D_inverse_elbow;

    /* lower: omega, a, n */
    /* omega = Rᵀ omega_parent + S_w u */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real shoulder_u = u[0]; /* rad/s */
    const real elbow_u = u[1]; /* rad/s */
    const real lower_omega_z = shoulder_u + elbow_u;
    const real lower_a_y = shoulder_u * shoulder_u * elbow_position_x * elbow_sin;
    const real lower_n_z = lower_first_moment_x * lower_a_y;

    /* upper: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real upper_n_z = lower_n_z
        - lower_omega_z * lower_omega_z * lower_first_moment_x * elbow_sin * elbow_position_x;

    /* elbow: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real elbow_torque = r[1]; /* N m */
    const real elbow_u_tau = tau[1]; /* N*m */
    const wreal elbow_bearing_damping = w[4]; /* N*m*s/rad */
    const real elbow_tau = elbow_u * elbow_bearing_damping - elbow_torque + lower_n_z;
    const real elbow_drive = elbow_u_tau - elbow_tau;

    /* shoulder: tau, drive, udot */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    /* udot = M⁻¹ drive */
    const real shoulder_torque = r[0]; /* N m */
    const real shoulder_u_tau = tau[0]; /* N*m */
    const wreal shoulder_bearing_damping = w[3]; /* N*m*s/rad */
    const real shoulder_tau = shoulder_u * shoulder_bearing_damping - shoulder_torque + upper_n_z;
    const real shoulder_drive = shoulder_u_tau - shoulder_tau;
    const real shoulder_udot = 1.0 / (upper_composite_inertia_zz
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
const int forward_dynamics_sizes[] = {2, 0, 7, 0, 2, 2, 0, 0, 2, 12, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0};
#endif
