/*
 * inverse_dynamics of filmed_pendulum
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 2, work 0, w 8
 * Operations per call: 35 = 19 mul, 7 sub, 5 add, 2 cos, 2 sin
 * Operations of prepare: 26 = 16 mul, 8 add, 2 sub
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
    /* upper: mass, origin inertia, base */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal m1 = p[0]; /* kg */
    const wreal l1 = p[2]; /* m */
    const wreal half_l1 = 0.5 * l1;
    const wreal upper_minus_first_moment_z = m1 * half_l1;
    const wreal upper_origin_inertia_xx = l1 * l1 * (0.08333333333333333 * m1)
        + half_l1 * upper_minus_first_moment_z;
    const wreal upper_base_half_trace = 0.5 * (upper_origin_inertia_xx + upper_origin_inertia_xx);
    const wreal upper_base_second_moment_xx = upper_base_half_trace - upper_origin_inertia_xx;

    /* lower: mass, origin inertia, base, inertia force */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal m2 = p[1]; /* kg */
    const wreal l2 = p[3]; /* m */
    const wreal half_l2 = 0.5 * l2;
    const wreal lower_minus_first_moment_z = m2 * half_l2;
    const wreal lower_origin_inertia_xx = l2 * l2 * (0.08333333333333333 * m2)
        + half_l2 * lower_minus_first_moment_z;
    const wreal lower_minus_base_mass_moment_z = m2 * l1;
    const wreal upper_minus_base_moment_z = upper_minus_first_moment_z
        + lower_minus_base_mass_moment_z;
    const wreal lower_base_second_moment_zz = 0.5 * (lower_origin_inertia_xx
        + lower_origin_inertia_xx);
    const wreal lower_base_second_moment_xx = lower_base_second_moment_zz - lower_origin_inertia_xx;
    const wreal lower_base_second_moment_zz_plus_base_second_moment_xx = lower_base_second_moment_zz
        + lower_base_second_moment_xx;
    w[4] = lower_minus_first_moment_z;
    w[5] = upper_minus_base_moment_z;
    w[7] = lower_base_second_moment_zz_plus_base_second_moment_xx;

    /* upper: base, inertia force */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal upper_base_second_moment_zz = l1 * lower_minus_base_mass_moment_z
        + upper_base_half_trace;
    const wreal upper_base_second_moment_xx_plus_base_second_moment_zz = upper_base_second_moment_xx
        + upper_base_second_moment_zz;
    w[6] = upper_base_second_moment_xx_plus_base_second_moment_zz;

    /* parameters as they are */
    w[0] = p[2]; /* l1 [m] */
    w[1] = p[4]; /* d1 [N m s/rad] */
    w[2] = p[5]; /* d2 [N m s/rad] */
    w[3] = p[6]; /* gravity.z [m/s^2] */
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
    const wreal gravity_z = w[3]; /* m/s^2 */
    const real upper_a_x = gravity_z * shoulder_sin;

    /* lower: omega, f, alpha, a, n */
    /* omega = Rᵀ omega_parent + S_w u */
    /* f = inertia_force_f - applied_f + sum R f_child */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real shoulder_u = u[0]; /* rad/s */
    const real elbow_u = u[1]; /* rad/s */
    const real shoulder_udot = udot[0]; /* rad/s^2 */
    const real elbow_udot = udot[1]; /* rad/s^2 */
    const wreal l1 = w[0]; /* m */
    const wreal lower_minus_first_moment_z = w[4];
    const wreal lower_base_second_moment_zz_plus_base_second_moment_xx = w[7];
    const real lower_omega_y = shoulder_u + elbow_u;
    const real lower_f_z = lower_omega_y * lower_omega_y * lower_minus_first_moment_z;
    const real lower_alpha_y = shoulder_udot + elbow_udot;
    const real lower_a_x = elbow_cos * (upper_a_x - l1 * shoulder_udot)
        - elbow_sin * (shoulder_u * shoulder_u * l1 - gravity_z * shoulder_cos);
    const real lower_n_y = lower_alpha_y * lower_base_second_moment_zz_plus_base_second_moment_xx
        - lower_minus_first_moment_z * lower_a_x;

    /* upper: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal upper_minus_base_moment_z = w[5];
    const wreal upper_base_second_moment_xx_plus_base_second_moment_zz = w[6];
    const real upper_n_y = shoulder_udot * upper_base_second_moment_xx_plus_base_second_moment_zz
        - upper_minus_base_moment_z * upper_a_x - l1 * (elbow_sin * lower_f_z
        - lower_minus_first_moment_z * lower_alpha_y * elbow_cos) + lower_n_y;

    /* elbow: tau */
    /* tau = S . [n; f] - force on the joint */
    const wreal d2 = w[2]; /* N m s/rad */
    out[1] = d2 * elbow_u + lower_n_y; /* tau: elbow.u.tau [N*m] */

    /* shoulder: tau */
    /* tau = S . [n; f] - force on the joint */
    const wreal d1 = w[1]; /* N m s/rad */
    out[0] = d1 * shoulder_u + upper_n_y; /* tau: shoulder.u.tau [N*m] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {2, 0, 8, 0, 2, 2, 0, 0, 0, 7, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
