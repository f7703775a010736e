/*
 * inverse_dynamics of elastic_pendulum
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 2, work 0, w 7
 * Operations per call: 25 = 14 mul, 7 add, 2 sub, 1 cos, 1 sin
 * Operations of prepare: 10 = 5 add, 3 mul, 2 sub
 *
 * Input q (2): generalized coordinates
 *   q[0]  pivot [rad]
 *   q[1]  slide [m]
 *
 * Input u (2): generalized speeds
 *   u[0]  pivot.u [rad/s]
 *   u[1]  slide.u [m/s]
 *
 * Input p (10): parameters, read by prepare_ only
 *
 * Input udot (2): derivatives of the speeds
 *   udot[0]  pivot.udot [rad/s^2]
 *   udot[1]  slide.udot [m/s^2]
 *
 * Output tau (2)
 *   out[0]  pivot.u.tau [N*m]
 *   out[1]  slide.u.tau [N]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* arm: first moment, mass, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal arm_mass = p[3]; /* kg */
    const wreal arm_com_z = p[4]; /* m */
    const wreal arm_inertia_xx = p[5]; /* kg m^2 */
    const wreal arm_inertia_yy = p[6]; /* kg m^2 */
    const wreal arm_inertia_zz = p[7]; /* kg m^2 */
    const wreal arm_first_moment_z = arm_mass * arm_com_z;
    const wreal arm_com_z_times_first_moment_z = arm_com_z * arm_first_moment_z;
    const wreal arm_origin_inertia_xx = arm_inertia_xx + arm_com_z_times_first_moment_z;
    const wreal arm_origin_inertia_yy = arm_inertia_yy + arm_com_z_times_first_moment_z;
    const wreal arm_base_half_trace = 0.5 * (arm_inertia_zz + arm_origin_inertia_xx
        + arm_origin_inertia_yy);
    const wreal arm_base_second_moment_xx = arm_base_half_trace - arm_origin_inertia_xx;
    const wreal arm_base_second_moment_zz = arm_base_half_trace - arm_inertia_zz;
    const wreal arm_base_second_moment_xx_plus_base_second_moment_zz = arm_base_second_moment_xx
        + arm_base_second_moment_zz;
    w[3] = arm_first_moment_z;
    w[6] = arm_base_second_moment_xx_plus_base_second_moment_zz;

    /* parameters as they are */
    w[0] = p[0]; /* mass [kg] */
    w[1] = p[1]; /* stiffness [N/m] */
    w[2] = p[2]; /* gravity.z [m/s^2] */
    w[4] = p[8]; /* slide.position.z [m] */
    w[5] = p[9]; /* spring.damping [N*s/m] */
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

    /* pivot: R */
    /* R = R_fixed R_joint(q) */
    const real pivot_q = q[0]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {pivot_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real pivot_cos = cosine[0];
    const real pivot_sin = sine[0];

    /* arm: a */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    const wreal gravity_z = w[2]; /* m/s^2 */
    const real arm_a_x = gravity_z * pivot_sin;

    /* slide: p */
    /* p = p_fixed + R_fixed p_joint(q) */
    const real slide_q = q[1]; /* m */
    const wreal slide_position_z = w[4]; /* m */
    const real slide_p_z = slide_position_z + slide_q;

    /* bob: a, f */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real pivot_u = u[0]; /* rad/s */
    const real slide_u = u[1]; /* m/s */
    const real pivot_udot = udot[0]; /* rad/s^2 */
    const real slide_udot = udot[1]; /* m/s^2 */
    const wreal mass = w[0]; /* kg */
    const real bob_a_z = slide_udot - pivot_u * pivot_u * slide_p_z - gravity_z * pivot_cos;
    const real bob_f_z = mass * bob_a_z;
    const real bob_a_x = pivot_u * slide_u * 2.0 + pivot_udot * slide_p_z + arm_a_x;
    const real bob_f_x = mass * bob_a_x;

    /* slide: tau */
    /* tau = S . [n; f] - force on the joint */
    const wreal stiffness = w[1]; /* N/m */
    const wreal spring_damping = w[5]; /* N*s/m */
    out[1] = stiffness * slide_q + slide_u * spring_damping + bob_f_z; /* tau: slide.u.tau [N] */

    /* arm: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal arm_first_moment_z = w[3];
    const wreal arm_base_second_moment_xx_plus_base_second_moment_zz = w[6];
    /* tau: pivot.u.tau [N*m] */
    out[0] = pivot_udot * arm_base_second_moment_xx_plus_base_second_moment_zz
        + arm_first_moment_z * arm_a_x + slide_p_z * bob_f_x;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {2, 0, 7, 0, 2, 2, 0, 0, 0, 10, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
