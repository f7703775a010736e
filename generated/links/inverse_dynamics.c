/*
 * inverse_dynamics of links
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 2, work 0, w 8
 * Operations per call: 35 = 19 mul, 11 add, 2 cos, 2 sin, 1 sub
 * Operations of prepare: 20 = 9 add, 9 mul, 2 sub
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
    const wreal upper_mass = p[4]; /* kg */
    const wreal upper_com_z = p[5]; /* m */
    const wreal upper_inertia_xx = p[6]; /* kg m^2 */
    const wreal upper_inertia_yy = p[7]; /* kg m^2 */
    const wreal upper_first_moment_z = upper_mass * upper_com_z;
    const wreal upper_com_z_times_first_moment_z = upper_com_z * upper_first_moment_z;
    const wreal upper_origin_inertia_xx = upper_inertia_xx + upper_com_z_times_first_moment_z;
    const wreal upper_origin_inertia_yy = upper_inertia_yy + upper_com_z_times_first_moment_z;
    const wreal upper_base_half_trace = 0.5 * (upper_origin_inertia_xx + upper_origin_inertia_yy);
    const wreal upper_base_second_moment_xx = upper_base_half_trace - upper_origin_inertia_xx;

    /* lower: first moment, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal m = p[0]; /* kg */
    const wreal elbow_position_z = p[8]; /* m */
    const wreal lower_com_z = p[9]; /* m */
    const wreal lower_first_moment_z = m * lower_com_z;
    const wreal lower_origin_inertia_xx = 0.053333333333333344 * m
        + lower_com_z * lower_first_moment_z;
    const wreal lower_base_mass_moment_z = m * elbow_position_z;
    const wreal lower_base_second_moment_zz = 0.5 * (lower_origin_inertia_xx
        + lower_origin_inertia_xx);
    const wreal lower_base_second_moment_xx = lower_base_second_moment_zz - lower_origin_inertia_xx;
    const wreal lower_base_second_moment_zz_plus_base_second_moment_xx = lower_base_second_moment_zz
        + lower_base_second_moment_xx;
    w[4] = lower_first_moment_z;
    w[7] = lower_base_second_moment_zz_plus_base_second_moment_xx;

    /* upper: base, inertia force */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal upper_base_moment_z = upper_first_moment_z + lower_base_mass_moment_z;
    const wreal upper_base_second_moment_zz = elbow_position_z * lower_base_mass_moment_z
        + upper_base_half_trace;
    const wreal upper_base_second_moment_xx_plus_base_second_moment_zz = upper_base_second_moment_xx
        + upper_base_second_moment_zz;
    w[5] = upper_base_moment_z;
    w[6] = upper_base_second_moment_xx_plus_base_second_moment_zz;

    /* parameters as they are */
    w[0] = p[1]; /* k [N m/rad] */
    w[1] = p[2]; /* d [N m s/rad] */
    w[2] = p[3]; /* gravity.z [m/s^2] */
    w[3] = p[8]; /* elbow.position.z [m] */
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
    const real shoulder_q = q[0]; /* rad */
    const real elbow_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(2)] = {shoulder_q, elbow_q};
    real sine[CARDAN_PADDED(2)], cosine[CARDAN_PADDED(2)];
    cardan_sincos(2, angle, sine, cosine);
    const real shoulder_cos = cosine[0];
    const real shoulder_sin = sine[0];
    const real elbow_cos = cosine[1];
    const real elbow_sin = sine[1];

    /* upper: a */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    const wreal gravity_z = w[2]; /* m/s^2 */
    const real upper_a_x = gravity_z * shoulder_sin;

    /* lower: omega, alpha, a, n, f */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real shoulder_u = u[0]; /* rad/s */
    const real elbow_u = u[1]; /* rad/s */
    const real shoulder_udot = udot[0]; /* rad/s^2 */
    const real elbow_udot = udot[1]; /* rad/s^2 */
    const wreal elbow_position_z = w[3]; /* m */
    const wreal lower_first_moment_z = w[4];
    const wreal lower_base_second_moment_zz_plus_base_second_moment_xx = w[7];
    const real lower_omega_y = shoulder_u + elbow_u;
    const real lower_alpha_y = shoulder_udot + elbow_udot;
    const real lower_a_x = elbow_cos * (upper_a_x + elbow_position_z * shoulder_udot)
        + elbow_sin * (gravity_z * shoulder_cos + shoulder_u * shoulder_u * elbow_position_z);
    const real lower_n_y = lower_alpha_y * lower_base_second_moment_zz_plus_base_second_moment_xx
        + lower_first_moment_z * lower_a_x;
    const real lower_f_x = lower_first_moment_z * lower_alpha_y;

    /* upper: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal upper_base_moment_z = w[5];
    const wreal upper_base_second_moment_xx_plus_base_second_moment_zz = w[6];
    /* tau: shoulder.u.tau [N*m] */
    out[0] = shoulder_udot * upper_base_second_moment_xx_plus_base_second_moment_zz
        + upper_base_moment_z * upper_a_x + elbow_position_z * (elbow_cos * lower_f_x
        - lower_omega_y * lower_omega_y * lower_first_moment_z * elbow_sin) + lower_n_y;

    /* elbow: tau */
    /* tau = S . [n; f] - force on the joint */
    const wreal k = w[0]; /* N m/rad */
    const wreal d = w[1]; /* N m s/rad */
    out[1] = k * elbow_q + d * elbow_u + lower_n_y; /* tau: elbow.u.tau [N*m] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {2, 0, 8, 0, 2, 2, 0, 0, 0, 10, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
