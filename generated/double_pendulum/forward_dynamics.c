/*
 * forward_dynamics of double_pendulum
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 2, work 0, w 7
 * Operations per call: 38 = 21 mul, 7 add, 5 sub, 2 cos, 2 sin, 1 div
 * Operations of prepare: 13 = 8 mul, 4 add, 1 div
 *
 * Input q (2): generalized coordinates
 *   q[0]  shoulder [rad]
 *   q[1]  elbow [rad]
 *
 * Input u (2): generalized speeds
 *   u[0]  shoulder.u [rad/s]
 *   u[1]  elbow.u [rad/s]
 *
 * Input p (3): parameters, read by prepare_ only
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
    /* shared by several: mass */
    const wreal m = p[0]; /* kg */
    const wreal l = p[1]; /* m */
    const wreal half_l = 0.5 * l;
    const wreal upper_minus_first_moment_z = m * half_l;
    w[2] = upper_minus_first_moment_z;

    /* upper: origin inertia */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal upper_origin_inertia_xx = l * l * (0.08333333333333333 * m)
        + half_l * upper_minus_first_moment_z;
    w[3] = upper_origin_inertia_xx;

    /* lower: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal lower_minus_base_mass_moment_z = m * l;
    const wreal upper_minus_base_moment_z = upper_minus_first_moment_z
        + lower_minus_base_mass_moment_z;
    w[4] = upper_minus_base_moment_z;

    /* upper: base, inertia */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal upper_base_inertia_yy = upper_origin_inertia_xx
        + l * lower_minus_base_mass_moment_z;
    const wreal upper_origin_inertia_xx_plus_base_inertia_yy = upper_origin_inertia_xx
        + upper_base_inertia_yy;
    w[5] = upper_origin_inertia_xx_plus_base_inertia_yy;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal M_factor_D_inverse_elbow = 1.0 / upper_origin_inertia_xx;
    w[6] = M_factor_D_inverse_elbow;

    /* parameters as they are */
    w[0] = p[1]; /* l [m] */
    w[1] = p[2]; /* gravity.z [m/s^2] */
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
    const wreal l = w[0]; /* m */
    const wreal upper_minus_first_moment_z = w[2];
    const real l_times_upper_minus_inertia_mean_moment_z = upper_minus_first_moment_z * elbow_cos *
        l;

    /* upper: composite, a */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    const wreal gravity_z = w[1]; /* m/s^2 */
    const wreal upper_origin_inertia_xx_plus_base_inertia_yy = w[5];
    const real upper_composite_inertia_yy = 2.0 * l_times_upper_minus_inertia_mean_moment_z
        + upper_origin_inertia_xx_plus_base_inertia_yy;
    const real upper_a_x = gravity_z * shoulder_sin;

    /* M: factor */
    /* M = S . momentum */
    /* factor = L, D with M = Lᵀ D L */
    const wreal upper_origin_inertia_xx = w[3];
    const wreal M_factor_D_inverse_elbow = w[6];
    const real M_elbow_shoulder = upper_origin_inertia_xx
        + l_times_upper_minus_inertia_mean_moment_z;
    const real M_factor_L_elbow_shoulder = M_elbow_shoulder * M_factor_D_inverse_elbow;

    /* lower: omega, a, inertia force, f */
    /* omega = Rᵀ omega_parent + S_w u */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real shoulder_u = u[0]; /* rad/s */
    const real elbow_u = u[1]; /* rad/s */
    const real lower_omega_y = shoulder_u + elbow_u;
    const real lower_a_x = elbow_cos * upper_a_x - elbow_sin * (shoulder_u * shoulder_u * l
        - gravity_z * shoulder_cos);
    const real lower_minus_n_y = upper_minus_first_moment_z * lower_a_x;
    const real lower_f_z = lower_omega_y * lower_omega_y * upper_minus_first_moment_z;

    /* upper: f */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real upper_f_x = elbow_sin * lower_f_z;

    /* shoulder: drive */
    /* drive = tau + f - h */
    const real shoulder_u_tau = tau[0]; /* N*m */
    const wreal upper_minus_base_moment_z = w[4];
    const real shoulder_drive = shoulder_u_tau + upper_minus_base_moment_z * upper_a_x
        + l * upper_f_x + lower_minus_n_y;

    /* elbow: drive */
    /* drive = tau + f - h */
    const real elbow_u_tau = tau[1]; /* N*m */
    const real elbow_drive = elbow_u_tau + lower_minus_n_y;

    /* shoulder: udot */
    /* udot = M⁻¹ drive */
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
const int forward_dynamics_sizes[] = {2, 0, 7, 0, 2, 2, 0, 0, 0, 3, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0};
#endif
