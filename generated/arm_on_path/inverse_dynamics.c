/*
 * inverse_dynamics of arm_on_path
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 2, work 0, w 6
 * Operations per call: 85 = 44 mul, 23 add, 9 sub, 5 cos, 4 sin
 * Operations of prepare: 24 = 12 add, 8 mul, 4 sub
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
 * Input udot (2): derivatives of the speeds
 *   udot[0]  shoulder.udot [rad/s^2]
 *   udot[1]  elbow.udot [rad/s^2]
 *
 * Output tau (2)
 *   out[0]  shoulder.u.tau [N*m]
 *   out[1]  elbow.u.tau [N*m]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* upper: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal upper_mass = p[1]; /* kg */
    const wreal upper_com_x = p[2]; /* m */
    const wreal upper_inertia_xx = p[3]; /* kg m^2 */
    const wreal upper_inertia_yy = p[4]; /* kg m^2 */
    const wreal upper_inertia_zz = p[5]; /* kg m^2 */
    const wreal upper_first_moment_x = upper_mass * upper_com_x;
    const wreal upper_com_x_times_first_moment_x = upper_com_x * upper_first_moment_x;
    const wreal upper_origin_inertia_yy = upper_inertia_yy + upper_com_x_times_first_moment_x;
    const wreal upper_origin_inertia_zz = upper_inertia_zz + upper_com_x_times_first_moment_x;
    const wreal upper_base_half_trace = 0.5 * (upper_inertia_xx + upper_origin_inertia_zz
        + upper_origin_inertia_yy);
    const wreal upper_base_second_moment_zz = upper_base_half_trace - upper_origin_inertia_zz;

    /* lower: first moment, mass, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal elbow_position_x = p[6]; /* m */
    const wreal lower_mass = p[7]; /* kg */
    const wreal lower_com_x = p[8]; /* m */
    const wreal lower_inertia_xx = p[9]; /* kg m^2 */
    const wreal lower_inertia_yy = p[10]; /* kg m^2 */
    const wreal lower_inertia_zz = p[11]; /* kg m^2 */
    const wreal lower_first_moment_x = lower_mass * lower_com_x;
    const wreal lower_com_x_times_first_moment_x = lower_com_x * lower_first_moment_x;
    const wreal lower_origin_inertia_yy = lower_inertia_yy + lower_com_x_times_first_moment_x;
    const wreal lower_origin_inertia_zz = lower_inertia_zz + lower_com_x_times_first_moment_x;
    const wreal lower_base_mass_moment_x = elbow_position_x * lower_mass;
    const wreal lower_base_half_trace = 0.5 * (lower_inertia_xx + lower_origin_inertia_zz
        + lower_origin_inertia_yy);
    const wreal lower_base_second_moment_xx = lower_base_half_trace - lower_inertia_xx;
    const wreal lower_base_second_moment_zz = lower_base_half_trace - lower_origin_inertia_zz;
    const wreal lower_base_second_moment_xx_plus_base_second_moment_zz = lower_base_second_moment_xx
        + lower_base_second_moment_zz;
    w[2] = lower_first_moment_x;
    w[5] = lower_base_second_moment_xx_plus_base_second_moment_zz;

    /* upper: base, inertia force */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal upper_base_moment_x = upper_first_moment_x + lower_base_mass_moment_x;
    const wreal upper_base_second_moment_xx = elbow_position_x * lower_base_mass_moment_x
        + upper_base_half_trace - upper_inertia_xx;
    const wreal upper_base_second_moment_zz_plus_base_second_moment_xx = upper_base_second_moment_zz
        + upper_base_second_moment_xx;
    w[3] = upper_base_moment_x;
    w[4] = upper_base_second_moment_zz_plus_base_second_moment_xx;

    /* parameters as they are */
    w[0] = p[0]; /* gravity.z [m/s^2] */
    w[1] = p[6]; /* elbow.position.x [m] */
}

#include "lanes.h"

/* tau with M udot + h = f + tau */
CARDAN_API int inverse_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const t = in->t;
    const real *const q = in->q;
    const real *const u = in->u;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
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

    /* shared by several: data, U */
    /* U = [alpha] + [omega][omega] */
    const real shoulder_u = u[0]; /* rad/s */
    const real cos_of_shoulder_plus_elbow_times_c2p9430000000000005 = 2.9430000000000005 *
        cos_of_shoulder_plus_elbow;
    const real shoulder_tau_part = 12.48 * cos_of_t_times_c1p3 - (12.0 * shoulder_u
        + 36.0 * shoulder_q) + 27.448 * sin_of_t_times_c1p3;
    const real elbow_tau_part = 0.09000000000000001 + 0.15000000000000002 * elbow_cos;
    const real upper_minus_U_xx = shoulder_u * shoulder_u;

    /* upper: a */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const real upper_minus_a_z = gravity_z * shoulder_cos;
    const real upper_a_x = gravity_z * shoulder_sin;

    /* shoulder: tau */
    /* tau = S . [n; f] - force on the joint */
    const real elbow_u = u[1]; /* rad/s */
    const real shoulder_tau_part_2 = 14.715 * shoulder_cos
        + 0.15000000000000002 * elbow_u * (elbow_u + 2.0 * shoulder_u) * elbow_sin
        + cos_of_shoulder_plus_elbow_times_c2p9430000000000005 - (0.7225000000000001
        + 0.30000000000000004 * elbow_cos) * shoulder_tau_part;

    /* lower: omega, alpha, a, n */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real shoulder_udot = udot[0]; /* rad/s^2 */
    const real elbow_udot = udot[1]; /* rad/s^2 */
    const wreal elbow_position_x = w[1]; /* m */
    const wreal lower_first_moment_x = w[2];
    const wreal lower_base_second_moment_xx_plus_base_second_moment_zz = w[5];
    const real lower_omega_y = shoulder_u + elbow_u;
    const real lower_alpha_y = shoulder_udot + elbow_udot;
    const real lower_a_z = elbow_sin * (upper_a_x - elbow_position_x * upper_minus_U_xx)
        - elbow_cos * (upper_minus_a_z + elbow_position_x * shoulder_udot);
    const real lower_n_y = lower_alpha_y * lower_base_second_moment_xx_plus_base_second_moment_zz
        - lower_first_moment_x * lower_a_z;

    /* upper: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal upper_base_moment_x = w[3];
    const wreal upper_base_second_moment_zz_plus_base_second_moment_xx = w[4];
    const real upper_n_y = shoulder_udot * upper_base_second_moment_zz_plus_base_second_moment_xx
        + upper_base_moment_x * upper_minus_a_z
        - elbow_position_x * (lower_omega_y * lower_omega_y * lower_first_moment_x * elbow_sin
        - lower_first_moment_x * lower_alpha_y * elbow_cos) + lower_n_y;

    /* elbow: tau */
    /* tau = S . [n; f] - force on the joint */
    /* tau: elbow.u.tau [N*m] */
    out[1] = cos_of_shoulder_plus_elbow_times_c2p9430000000000005 + 1.70586 * sin_of_t_times_c2p1
        + (1.08 * elbow_u + 3.24 * elbow_q - 0.15000000000000002 * upper_minus_U_xx * elbow_sin
        + 1.3608000000000002 * cos_of_t_times_c2p1) - shoulder_tau_part * elbow_tau_part
        + lower_n_y;

    /* shoulder: tau */
    /* tau = S . [n; f] - force on the joint */
    /* tau: shoulder.u.tau [N*m] */
    out[0] = elbow_tau_part * (12.0 * elbow_u + 36.0 * elbow_q
        + 18.953999999999997 * sin_of_t_times_c2p1 + 15.120000000000001 * cos_of_t_times_c2p1)
        + shoulder_tau_part_2 + upper_n_y;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {2, 0, 6, 1, 2, 2, 0, 0, 0, 12, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
