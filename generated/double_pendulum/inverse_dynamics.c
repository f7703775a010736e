/*
 * inverse_dynamics of double_pendulum
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 2, work 0, w 6
 * Operations per call: 31 = 17 mul, 7 sub, 3 add, 2 cos, 2 sin
 * Operations of prepare: 16 = 9 mul, 6 add, 1 sub
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

    /* lower: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal lower_minus_base_mass_moment_z = m * l;
    const wreal upper_minus_base_moment_z = upper_minus_first_moment_z
        + lower_minus_base_mass_moment_z;
    const wreal lower_base_second_moment_zz = 0.5 * (upper_origin_inertia_xx
        + upper_origin_inertia_xx);
    w[3] = upper_minus_base_moment_z;

    /* upper: base, inertia force */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal upper_base_second_moment_xx = lower_base_second_moment_zz - upper_origin_inertia_xx;
    const wreal upper_base_second_moment_zz = l * lower_minus_base_mass_moment_z
        + lower_base_second_moment_zz;
    const wreal upper_base_second_moment_xx_plus_base_second_moment_zz = upper_base_second_moment_xx
        + upper_base_second_moment_zz;
    w[4] = upper_base_second_moment_xx_plus_base_second_moment_zz;

    /* lower: inertia force */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal lower_base_second_moment_zz_plus_upper_base_second_moment_xx =
        lower_base_second_moment_zz + upper_base_second_moment_xx;
    w[5] = lower_base_second_moment_zz_plus_upper_base_second_moment_xx;

    /* parameters as they are */
    w[0] = p[1]; /* l [m] */
    w[1] = p[2]; /* gravity.z [m/s^2] */
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
    const wreal gravity_z = w[1]; /* m/s^2 */
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
    const wreal l = w[0]; /* m */
    const wreal upper_minus_first_moment_z = w[2];
    const wreal lower_base_second_moment_zz_plus_upper_base_second_moment_xx = w[5];
    const real lower_omega_y = shoulder_u + elbow_u;
    const real lower_f_z = lower_omega_y * lower_omega_y * upper_minus_first_moment_z;
    const real lower_alpha_y = shoulder_udot + elbow_udot;
    const real lower_a_x = elbow_cos * (upper_a_x - l * shoulder_udot)
        - elbow_sin * (shoulder_u * shoulder_u * l - gravity_z * shoulder_cos);
    const real lower_n_y = lower_alpha_y *
        lower_base_second_moment_zz_plus_upper_base_second_moment_xx
        - upper_minus_first_moment_z * lower_a_x;
    out[1] = lower_n_y; /* tau: elbow.u.tau [N*m] */

    /* upper: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal upper_minus_base_moment_z = w[3];
    const wreal upper_base_second_moment_xx_plus_base_second_moment_zz = w[4];
    /* tau: shoulder.u.tau [N*m] */
    out[0] = shoulder_udot * upper_base_second_moment_xx_plus_base_second_moment_zz
        - upper_minus_base_moment_z * upper_a_x - l * (elbow_sin * lower_f_z
        - upper_minus_first_moment_z * lower_alpha_y * elbow_cos) + lower_n_y;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {2, 0, 6, 0, 2, 2, 0, 0, 0, 3, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
