/*
 * forward_dynamics of filmed_pendulum
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 2, work 0, w 9
 * Operations per call: 42 = 23 mul, 11 sub, 3 add, 2 cos, 2 sin, 1 div
 * Operations of prepare: 20 = 14 mul, 5 add, 1 div
 *
 * Input q (2): generalized coordinates
 *   q[0]  shoulder [rad]
 *   q[1]  elbow [rad]
 *
 * Input u (2): generalized speeds
 *   u[0]  shoulder.u [rad/s]
 *   u[1]  elbow.u [rad/s]
 *
 * Input p (7): parameters, read by prepare_ only
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
    /* upper: mass, origin inertia */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal m1 = p[0]; /* kg */
    const wreal l1 = p[2]; /* m */
    const wreal half_l1 = 0.5 * l1;
    const wreal upper_minus_first_moment_z = m1 * half_l1;
    const wreal upper_origin_inertia_xx = l1 * l1 * (0.08333333333333333 * m1)
        + half_l1 * upper_minus_first_moment_z;

    /* lower: mass, origin inertia, base */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal m2 = p[1]; /* kg */
    const wreal l2 = p[3]; /* m */
    const wreal half_l2 = 0.5 * l2;
    const wreal lower_minus_first_moment_z = m2 * half_l2;
    const wreal lower_origin_inertia_xx = l2 * l2 * (0.08333333333333333 * m2)
        + half_l2 * lower_minus_first_moment_z;
    const wreal lower_minus_base_mass_moment_z = m2 * l1;
    const wreal upper_minus_base_moment_z = upper_minus_first_moment_z
        + lower_minus_base_mass_moment_z;
    w[4] = lower_minus_first_moment_z;
    w[5] = lower_origin_inertia_xx;
    w[6] = upper_minus_base_moment_z;

    /* upper: base, inertia */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal upper_base_inertia_yy = upper_origin_inertia_xx
        + l1 * lower_minus_base_mass_moment_z;
    const wreal lower_origin_inertia_xx_plus_upper_base_inertia_yy = lower_origin_inertia_xx
        + upper_base_inertia_yy;
    w[7] = lower_origin_inertia_xx_plus_upper_base_inertia_yy;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal M_factor_D_inverse_elbow = 1.0 / lower_origin_inertia_xx;
    w[8] = M_factor_D_inverse_elbow;

    /* parameters as they are */
    w[0] = p[2]; /* l1 [m] */
    w[1] = p[4]; /* d1 [N m s/rad] */
    w[2] = p[5]; /* d2 [N m s/rad] */
    w[3] = p[6]; /* gravity.z [m/s^2] */
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
    const wreal l1 = w[0]; /* m */
    const wreal lower_minus_first_moment_z = w[4];
    const real l1_times_upper_minus_inertia_mean_moment_z = lower_minus_first_moment_z * elbow_cos *
        l1;

    /* upper: composite, a */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    const wreal gravity_z = w[3]; /* m/s^2 */
    const wreal lower_origin_inertia_xx_plus_upper_base_inertia_yy = w[7];
    const real upper_composite_inertia_yy = 2.0 * l1_times_upper_minus_inertia_mean_moment_z
        + lower_origin_inertia_xx_plus_upper_base_inertia_yy;
    const real upper_a_x = gravity_z * shoulder_sin;

    /* M: factor */
    /* M = S . momentum */
    /* factor = L, D with M = Lᵀ D L */
    const wreal lower_origin_inertia_xx = w[5];
    const wreal M_factor_D_inverse_elbow = w[8];
    const real M_elbow_shoulder = lower_origin_inertia_xx
        + l1_times_upper_minus_inertia_mean_moment_z;
    const real M_factor_L_elbow_shoulder = M_elbow_shoulder * M_factor_D_inverse_elbow;

    /* lower: omega, a, inertia force, f */
    /* omega = Rᵀ omega_parent + S_w u */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real shoulder_u = u[0]; /* rad/s */
    const real elbow_u = u[1]; /* rad/s */
    const real lower_omega_y = shoulder_u + elbow_u;
    const real lower_a_x = elbow_cos * upper_a_x - elbow_sin * (shoulder_u * shoulder_u * l1
        - gravity_z * shoulder_cos);
    const real lower_minus_n_y = lower_minus_first_moment_z * lower_a_x;
    const real lower_f_z = lower_omega_y * lower_omega_y * lower_minus_first_moment_z;

    /* upper: f */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real upper_f_x = elbow_sin * lower_f_z;

    /* elbow: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real elbow_u_tau = tau[1]; /* N*m */
    const wreal d2 = w[2]; /* N m s/rad */
    const real elbow_tau = d2 * elbow_u - lower_minus_n_y;
    const real elbow_drive = elbow_u_tau - elbow_tau;

    /* shoulder: tau, drive, udot */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    /* udot = M⁻¹ drive */
    const real shoulder_u_tau = tau[0]; /* N*m */
    const wreal d1 = w[1]; /* N m s/rad */
    const wreal upper_minus_base_moment_z = w[6];
    const real shoulder_tau = d1 * shoulder_u - upper_minus_base_moment_z * upper_a_x
        - l1 * upper_f_x - lower_minus_n_y;
    const real shoulder_drive = shoulder_u_tau - shoulder_tau;
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
const int forward_dynamics_sizes[] = {2, 0, 9, 0, 2, 2, 0, 0, 0, 7, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0};
#endif
