/*
 * inverse_dynamics of four_bar
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 3, work 0, w 8
 * Operations per call: 36 = 20 mul, 7 add, 4 sub, 3 cos, 2 sin
 * Operations of prepare: 34 = 17 add, 11 mul, 6 sub
 *
 * Input q (3): generalized coordinates
 *   q[0]  A [rad]
 *   q[1]  B [rad]
 *   q[2]  D [rad]
 *
 * Input u (3): generalized speeds
 *   u[0]  A.u [rad/s]
 *   u[1]  B.u [rad/s]
 *   u[2]  D.u [rad/s]
 *
 * Input p (20): parameters, read by prepare_ only
 *
 * Input udot (3): derivatives of the speeds
 *   udot[0]  A.udot [rad/s^2]
 *   udot[1]  B.udot [rad/s^2]
 *   udot[2]  D.udot [rad/s^2]
 *
 * Output tau (3)
 *   out[0]  A.u.tau [N*m]
 *   out[1]  B.u.tau [N*m]
 *   out[2]  D.u.tau [N*m]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* crank: first moment, mass, origin inertia, base */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal crank_mass = p[1]; /* kg */
    const wreal crank_com_x = p[2]; /* m */
    const wreal crank_inertia_xx = p[3]; /* kg m^2 */
    const wreal crank_inertia_yy = p[4]; /* kg m^2 */
    const wreal crank_inertia_zz = p[5]; /* kg m^2 */
    const wreal crank_first_moment_x = crank_mass * crank_com_x;
    const wreal crank_com_x_times_first_moment_x = crank_com_x * crank_first_moment_x;
    const wreal crank_origin_inertia_yy = crank_inertia_yy + crank_com_x_times_first_moment_x;
    const wreal crank_origin_inertia_zz = crank_inertia_zz + crank_com_x_times_first_moment_x;
    const wreal crank_base_half_trace = 0.5 * (crank_inertia_xx + crank_origin_inertia_zz
        + crank_origin_inertia_yy);
    const wreal crank_base_second_moment_yy = crank_base_half_trace - crank_origin_inertia_yy;

    /* coupler: first moment, mass, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal B_position_x = p[6]; /* m */
    const wreal coupler_mass = p[7]; /* kg */
    const wreal coupler_com_x = p[8]; /* m */
    const wreal coupler_inertia_xx = p[9]; /* kg m^2 */
    const wreal coupler_inertia_yy = p[10]; /* kg m^2 */
    const wreal coupler_inertia_zz = p[11]; /* kg m^2 */
    const wreal coupler_first_moment_x = coupler_mass * coupler_com_x;
    const wreal coupler_com_x_times_first_moment_x = coupler_com_x * coupler_first_moment_x;
    const wreal coupler_origin_inertia_yy = coupler_inertia_yy + coupler_com_x_times_first_moment_x;
    const wreal coupler_origin_inertia_zz = coupler_inertia_zz + coupler_com_x_times_first_moment_x;
    const wreal coupler_base_mass_moment_x = B_position_x * coupler_mass;
    const wreal coupler_base_half_trace = 0.5 * (coupler_inertia_xx + coupler_origin_inertia_zz
        + coupler_origin_inertia_yy);
    const wreal coupler_base_second_moment_xx = coupler_base_half_trace - coupler_inertia_xx;
    const wreal coupler_base_second_moment_yy = coupler_base_half_trace - coupler_origin_inertia_yy;
    const wreal coupler_base_second_moment_xx_plus_base_second_moment_yy =
        coupler_base_second_moment_xx + coupler_base_second_moment_yy;
    w[2] = coupler_first_moment_x;
    w[6] = coupler_base_second_moment_xx_plus_base_second_moment_yy;

    /* rocker: first moment, mass, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal rocker_mass = p[13]; /* kg */
    const wreal rocker_com_x = p[14]; /* m */
    const wreal rocker_inertia_xx = p[15]; /* kg m^2 */
    const wreal rocker_inertia_yy = p[16]; /* kg m^2 */
    const wreal rocker_inertia_zz = p[17]; /* kg m^2 */
    const wreal rocker_first_moment_x = rocker_mass * rocker_com_x;
    const wreal rocker_com_x_times_first_moment_x = rocker_com_x * rocker_first_moment_x;
    const wreal rocker_origin_inertia_yy = rocker_inertia_yy + rocker_com_x_times_first_moment_x;
    const wreal rocker_origin_inertia_zz = rocker_inertia_zz + rocker_com_x_times_first_moment_x;
    const wreal rocker_base_half_trace = 0.5 * (rocker_inertia_xx + rocker_origin_inertia_zz
        + rocker_origin_inertia_yy);
    const wreal rocker_base_second_moment_xx = rocker_base_half_trace - rocker_inertia_xx;
    const wreal rocker_base_second_moment_yy = rocker_base_half_trace - rocker_origin_inertia_yy;
    const wreal rocker_base_second_moment_xx_plus_base_second_moment_yy =
        rocker_base_second_moment_xx + rocker_base_second_moment_yy;
    w[3] = rocker_first_moment_x;
    w[7] = rocker_base_second_moment_xx_plus_base_second_moment_yy;

    /* crank: base, inertia force */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal crank_base_moment_x = crank_first_moment_x + coupler_base_mass_moment_x;
    const wreal crank_base_second_moment_xx = B_position_x * coupler_base_mass_moment_x
        + crank_base_half_trace - crank_inertia_xx;
    const wreal crank_base_second_moment_yy_plus_base_second_moment_xx = crank_base_second_moment_yy
        + crank_base_second_moment_xx;
    w[4] = crank_base_moment_x;
    w[5] = crank_base_second_moment_yy_plus_base_second_moment_xx;

    /* parameters as they are */
    w[0] = p[0]; /* gravity.y [m/s^2] */
    w[1] = p[6]; /* B.position.x [m] */
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
    const real A_q = q[0]; /* rad */
    const real B_q = q[1]; /* rad */
    const real D_q = q[2]; /* rad */
    const real angle[CARDAN_PADDED(3)] = {A_q, B_q, D_q};
    real sine[CARDAN_PADDED(3)], cosine[CARDAN_PADDED(3)];
    cardan_sincos(3, angle, sine, cosine);
    const real A_cos = cosine[0];
    const real A_sin = sine[0];
    const real B_cos = cosine[1];
    const real B_sin = sine[1];
    const real D_cos = cosine[2];

    /* crank: a */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    const wreal gravity_y = w[0]; /* m/s^2 */
    const real crank_minus_a_y = gravity_y * A_cos;

    /* coupler: omega, alpha, a, n, f */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real A_u = u[0]; /* rad/s */
    const real B_u = u[1]; /* rad/s */
    const real A_udot = udot[0]; /* rad/s^2 */
    const real B_udot = udot[1]; /* rad/s^2 */
    const wreal B_position_x = w[1]; /* m */
    const wreal coupler_first_moment_x = w[2];
    const wreal coupler_base_second_moment_xx_plus_base_second_moment_yy = w[6];
    const real coupler_omega_z = A_u + B_u;
    const real coupler_alpha_z = A_udot + B_udot;
    const real coupler_a_y = B_sin * (gravity_y * A_sin + A_u * A_u * B_position_x)
        + B_cos * (B_position_x * A_udot - crank_minus_a_y);
    const real coupler_n_z = coupler_alpha_z *
        coupler_base_second_moment_xx_plus_base_second_moment_yy
        + coupler_first_moment_x * coupler_a_y;
    const real coupler_f_y = coupler_first_moment_x * coupler_alpha_z;
    out[1] = coupler_n_z; /* tau: B.u.tau [N*m] */

    /* crank: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal crank_base_moment_x = w[4];
    const wreal crank_base_second_moment_yy_plus_base_second_moment_xx = w[5];
    /* tau: A.u.tau [N*m] */
    out[0] = A_udot * crank_base_second_moment_yy_plus_base_second_moment_xx
        - crank_base_moment_x * crank_minus_a_y + B_position_x * (B_cos * coupler_f_y
        - coupler_omega_z * coupler_omega_z * coupler_first_moment_x * B_sin) + coupler_n_z;

    /* rocker: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real D_udot = udot[2]; /* rad/s^2 */
    const wreal rocker_first_moment_x = w[3];
    const wreal rocker_base_second_moment_xx_plus_base_second_moment_yy = w[7];
    /* tau: D.u.tau [N*m] */
    out[2] = D_udot * rocker_base_second_moment_xx_plus_base_second_moment_yy
        - gravity_y * D_cos * rocker_first_moment_x;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {3, 0, 8, 0, 3, 3, 0, 0, 0, 20, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
