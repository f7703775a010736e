/*
 * forward_dynamics of arm_on_path
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 2, work 0, w 7
 * Operations per call: 92 = 48 mul, 20 add, 14 sub, 5 cos, 4 sin, 1 div
 * Operations of prepare: 12 = 6 mul, 5 add, 1 div
 *
 * Input t (1): time
 *   t[0]  t [s]
 *
 * Input q (2): generalized coordinates
 *   q[0]  shoulder [rad]
 *   q[1]  elbow [rad]
 *
 * Input u (2): generalized speeds
 *   u[0]  shoulder.u [rad/s]
 *   u[1]  elbow.u [rad/s]
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
    /* upper: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal upper_mass = p[1]; /* kg */
    const wreal upper_com_x = p[2]; /* m */
    const wreal upper_inertia_yy = p[4]; /* kg m^2 */
    const wreal upper_first_moment_x = upper_mass * upper_com_x;
    const wreal upper_origin_inertia_yy = upper_inertia_yy + upper_com_x * upper_first_moment_x;

    /* lower: first moment, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal elbow_position_x = p[6]; /* m */
    const wreal lower_mass = p[7]; /* kg */
    const wreal lower_com_x = p[8]; /* m */
    const wreal lower_inertia_yy = p[10]; /* kg m^2 */
    const wreal lower_first_moment_x = lower_mass * lower_com_x;
    const wreal lower_origin_inertia_yy = lower_inertia_yy + lower_com_x * lower_first_moment_x;
    const wreal lower_base_mass_moment_x = elbow_position_x * lower_mass;
    w[2] = lower_first_moment_x;
    w[3] = lower_origin_inertia_yy;

    /* upper: base, inertia */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal upper_base_moment_x = upper_first_moment_x + lower_base_mass_moment_x;
    const wreal upper_base_inertia_yy = upper_origin_inertia_yy
        + elbow_position_x * lower_base_mass_moment_x;
    const wreal lower_origin_inertia_yy_plus_upper_base_inertia_yy = lower_origin_inertia_yy
        + upper_base_inertia_yy;
    w[4] = upper_base_moment_x;
    w[5] = lower_origin_inertia_yy_plus_upper_base_inertia_yy;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal M_factor_D_inverse_elbow = 1.0 / lower_origin_inertia_yy;
    w[6] = M_factor_D_inverse_elbow;

    /* parameters as they are */
    w[0] = p[0]; /* gravity.z [m/s^2] */
    w[1] = p[6]; /* elbow.position.x [m] */
}

#include "lanes.h"

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const t = in->t;
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    (void)work;

    /* shared by several: data, R */
    /* R = R_fixed R_joint(q) */
    const real shoulder_q = q[0]; /* rad */
    const real elbow_q = q[1]; /* rad */
    const real t_value = t[0]; /* s */
    const real t_times_c1p3 = 1.3 * t_value;
    const real t_times_c2p1 = 2.1 * t_value;
    const real angle[CARDAN_PADDED(5)] = {shoulder_q
        + elbow_q, shoulder_q, elbow_q, t_times_c1p3, t_times_c2p1};
    real sine[CARDAN_PADDED(5)], cosine[CARDAN_PADDED(5)];
    cardan_sincos(5, angle, sine, cosine);
    const real cos_of_shoulder_plus_elbow = cosine[0];
    const real shoulder_cos = cosine[1];
    const real elbow_cos = cosine[2];
    const real cos_of_t_times_c1p3 = cosine[3];
    const real sin_of_t_times_c1p3 = sine[3];
    const real cos_of_t_times_c2p1 = cosine[4];
    const real sin_of_t_times_c2p1 = sine[4];
    const real elbow_sin = sine[2];
    const real shoulder_sin = sine[1];

    /* shared by several: data, U, inertia */
    /* U = [alpha] + [omega][omega] */
    const real shoulder_u = u[0]; /* rad/s */
    const wreal elbow_position_x = w[1]; /* m */
    const wreal lower_first_moment_x = w[2];
    const real cos_of_shoulder_plus_elbow_times_c2p9430000000000005 = 2.9430000000000005 *
        cos_of_shoulder_plus_elbow;
    const real shoulder_tau_part = 12.48 * cos_of_t_times_c1p3 - (12.0 * shoulder_u
        + 36.0 * shoulder_q) + 27.448 * sin_of_t_times_c1p3;
    const real shoulder_tau_part_2 = 0.09000000000000001 + 0.15000000000000002 * elbow_cos;
    const real upper_minus_U_xx = shoulder_u * shoulder_u;
    const real elbow_position_x_times_upper_inertia_mean_moment_x = lower_first_moment_x * elbow_cos
        * elbow_position_x;

    /* upper: composite, a */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const wreal lower_origin_inertia_yy_plus_upper_base_inertia_yy = w[5];
    const real upper_composite_inertia_yy = 2.0 * elbow_position_x_times_upper_inertia_mean_moment_x
        + lower_origin_inertia_yy_plus_upper_base_inertia_yy;
    const real upper_a_x = gravity_z * shoulder_sin;
    const real upper_minus_a_z = gravity_z * shoulder_cos;

    /* M: factor */
    /* M = S . momentum */
    /* factor = L, D with M = Lᵀ D L */
    const wreal lower_origin_inertia_yy = w[3];
    const wreal M_factor_D_inverse_elbow = w[6];
    const real M_elbow_shoulder = lower_origin_inertia_yy
        + elbow_position_x_times_upper_inertia_mean_moment_x;
    const real M_factor_L_elbow_shoulder = M_elbow_shoulder * M_factor_D_inverse_elbow;

    /* lower: omega, a, inertia force */
    /* omega = Rᵀ omega_parent + S_w u */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const real elbow_u = u[1]; /* rad/s */
    const real lower_omega_y = shoulder_u + elbow_u;
    const real lower_a_z = elbow_sin * (upper_a_x - elbow_position_x * upper_minus_U_xx)
        - elbow_cos * upper_minus_a_z;
    const real lower_minus_n_y = lower_first_moment_x * lower_a_z;

    /* upper: f, n */
    /* f = inertia_force_f - applied_f + sum R f_child */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal upper_base_moment_x = w[4];
    const real upper_f_z = lower_omega_y * lower_omega_y * lower_first_moment_x * elbow_sin;
    const real upper_n_y = upper_base_moment_x * upper_minus_a_z - elbow_position_x * upper_f_z
        - lower_minus_n_y;

    /* shoulder: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real shoulder_u_tau = tau[0]; /* N*m */
    const real shoulder_tau_part_3 = 14.715 * shoulder_cos
        + 0.15000000000000002 * elbow_u * (elbow_u + 2.0 * shoulder_u) * elbow_sin
        + cos_of_shoulder_plus_elbow_times_c2p9430000000000005 - (0.7225000000000001
        + 0.30000000000000004 * elbow_cos) * shoulder_tau_part;
    const real shoulder_tau = shoulder_tau_part_2 * (12.0 * elbow_u + 36.0 * elbow_q
        + 18.953999999999997 * sin_of_t_times_c2p1 + 15.120000000000001 * cos_of_t_times_c2p1)
        + upper_n_y + shoulder_tau_part_3;
    const real shoulder_drive = shoulder_u_tau - shoulder_tau;

    /* common */
    const real elbow_u_tau = tau[1]; /* N*m */
    const real elbow_drive_part = elbow_u_tau - 3.24 * elbow_q - 1.08 * elbow_u
        + 0.15000000000000002 * upper_minus_U_xx * elbow_sin
        - 1.3608000000000002 * cos_of_t_times_c2p1
        - (cos_of_shoulder_plus_elbow_times_c2p9430000000000005 + 1.70586 * sin_of_t_times_c2p1)
        + shoulder_tau_part * shoulder_tau_part_2;

    /* elbow: drive */
    /* drive = tau + f - h */
    const real elbow_drive = lower_minus_n_y + elbow_drive_part;

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
const int forward_dynamics_sizes[] = {2, 0, 7, 1, 2, 2, 0, 0, 0, 12, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0};
#endif
