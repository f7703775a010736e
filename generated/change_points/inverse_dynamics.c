/*
 * inverse_dynamics of change_points
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 5, work 0, w 9
 * Operations per call: 47 = 29 mul, 12 add, 2 cos, 2 sin, 2 sub
 * Operations of prepare: 46 = 22 add, 19 mul, 5 sub
 *
 * Input q (5): generalized coordinates
 *   q[0]  A0 [rad]
 *   q[1]  A1 [rad]
 *   q[2]  A2 [rad]
 *   q[3]  B0 [rad]
 *   q[4]  B1 [rad]
 *
 * Input u (5): generalized speeds
 *   u[0]  A0.u [rad/s]
 *   u[1]  A1.u [rad/s]
 *   u[2]  A2.u [rad/s]
 *   u[3]  B0.u [rad/s]
 *   u[4]  B1.u [rad/s]
 *
 * Input p (28): parameters, read by prepare_ only
 *
 * Input udot (5): derivatives of the speeds
 *   udot[0]  A0.udot [rad/s^2]
 *   udot[1]  A1.udot [rad/s^2]
 *   udot[2]  A2.udot [rad/s^2]
 *   udot[3]  B0.udot [rad/s^2]
 *   udot[4]  B1.udot [rad/s^2]
 *
 * Output tau (5)
 *   out[0]  A0.u.tau [N*m]
 *   out[1]  A1.u.tau [N*m]
 *   out[2]  A2.u.tau [N*m]
 *   out[3]  B0.u.tau [N*m]
 *   out[4]  B1.u.tau [N*m]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* crank0: first moment, mass, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal crank0_mass = p[0]; /* kg */
    const wreal crank0_com_x = p[1]; /* m */
    const wreal crank0_inertia_yy = p[2]; /* kg m^2 */
    const wreal crank0_inertia_zz = p[3]; /* kg m^2 */
    const wreal B0_position_x = p[14]; /* m */
    const wreal coupler0_mass = p[15]; /* kg */
    const wreal crank0_first_moment_x = crank0_mass * crank0_com_x;
    const wreal crank0_com_x_times_first_moment_x = crank0_com_x * crank0_first_moment_x;
    const wreal crank0_origin_inertia_yy = crank0_inertia_yy + crank0_com_x_times_first_moment_x;
    const wreal crank0_origin_inertia_zz = crank0_inertia_zz + crank0_com_x_times_first_moment_x;
    const wreal crank0_base_half_trace = 0.5 * (crank0_origin_inertia_yy
        + crank0_origin_inertia_zz);
    const wreal crank0_base_second_moment_yy = crank0_base_half_trace - crank0_origin_inertia_yy;
    const wreal crank0_base_second_moment_xx = B0_position_x * coupler0_mass * B0_position_x
        + crank0_base_half_trace;
    const wreal crank0_base_second_moment_yy_plus_base_second_moment_xx =
        crank0_base_second_moment_yy + crank0_base_second_moment_xx;
    w[4] = crank0_base_second_moment_yy_plus_base_second_moment_xx;

    /* crank1: first moment, mass, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal crank1_mass = p[5]; /* kg */
    const wreal crank1_com_x = p[6]; /* m */
    const wreal crank1_inertia_yy = p[7]; /* kg m^2 */
    const wreal crank1_inertia_zz = p[8]; /* kg m^2 */
    const wreal B1_position_x = p[19]; /* m */
    const wreal coupler1_mass = p[20]; /* kg */
    const wreal crank1_first_moment_x = crank1_mass * crank1_com_x;
    const wreal crank1_com_x_times_first_moment_x = crank1_com_x * crank1_first_moment_x;
    const wreal crank1_origin_inertia_yy = crank1_inertia_yy + crank1_com_x_times_first_moment_x;
    const wreal crank1_origin_inertia_zz = crank1_inertia_zz + crank1_com_x_times_first_moment_x;
    const wreal crank1_base_half_trace = 0.5 * (crank1_origin_inertia_yy
        + crank1_origin_inertia_zz);
    const wreal crank1_base_second_moment_yy = crank1_base_half_trace - crank1_origin_inertia_yy;
    const wreal crank1_base_second_moment_xx = B1_position_x * coupler1_mass * B1_position_x
        + crank1_base_half_trace;
    const wreal crank1_base_second_moment_yy_plus_base_second_moment_xx =
        crank1_base_second_moment_yy + crank1_base_second_moment_xx;
    w[5] = crank1_base_second_moment_yy_plus_base_second_moment_xx;

    /* crank2: first moment, mass, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal crank2_mass = p[10]; /* kg */
    const wreal crank2_com_x = p[11]; /* m */
    const wreal crank2_inertia_yy = p[12]; /* kg m^2 */
    const wreal crank2_inertia_zz = p[13]; /* kg m^2 */
    const wreal crank2_first_moment_x = crank2_mass * crank2_com_x;
    const wreal crank2_com_x_times_first_moment_x = crank2_com_x * crank2_first_moment_x;
    const wreal crank2_origin_inertia_yy = crank2_inertia_yy + crank2_com_x_times_first_moment_x;
    const wreal crank2_origin_inertia_zz = crank2_inertia_zz + crank2_com_x_times_first_moment_x;
    const wreal crank2_base_second_moment_xx = 0.5 * (crank2_origin_inertia_yy
        + crank2_origin_inertia_zz);
    const wreal crank2_base_second_moment_yy = crank2_base_second_moment_xx
        - crank2_origin_inertia_yy;
    const wreal crank2_base_second_moment_xx_plus_base_second_moment_yy =
        crank2_base_second_moment_xx + crank2_base_second_moment_yy;
    w[6] = crank2_base_second_moment_xx_plus_base_second_moment_yy;

    /* coupler0: first moment, mass, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal coupler0_com_x = p[16]; /* m */
    const wreal coupler0_inertia_yy = p[17]; /* kg m^2 */
    const wreal coupler0_inertia_zz = p[18]; /* kg m^2 */
    const wreal coupler0_first_moment_x = coupler0_mass * coupler0_com_x;
    const wreal coupler0_com_x_times_first_moment_x = coupler0_com_x * coupler0_first_moment_x;
    const wreal coupler0_origin_inertia_yy = coupler0_inertia_yy
        + coupler0_com_x_times_first_moment_x;
    const wreal coupler0_origin_inertia_zz = coupler0_inertia_zz
        + coupler0_com_x_times_first_moment_x;
    const wreal coupler0_base_second_moment_xx = 0.5 * (coupler0_origin_inertia_yy
        + coupler0_origin_inertia_zz);
    const wreal coupler0_base_second_moment_yy = coupler0_base_second_moment_xx
        - coupler0_origin_inertia_yy;
    const wreal coupler0_base_second_moment_xx_plus_base_second_moment_yy =
        coupler0_base_second_moment_xx + coupler0_base_second_moment_yy;
    w[1] = coupler0_first_moment_x;
    w[7] = coupler0_base_second_moment_xx_plus_base_second_moment_yy;

    /* coupler1: first moment, mass, origin inertia, base, inertia force */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal coupler1_com_x = p[21]; /* m */
    const wreal coupler1_inertia_yy = p[22]; /* kg m^2 */
    const wreal coupler1_inertia_zz = p[23]; /* kg m^2 */
    const wreal coupler1_first_moment_x = coupler1_mass * coupler1_com_x;
    const wreal coupler1_com_x_times_first_moment_x = coupler1_com_x * coupler1_first_moment_x;
    const wreal coupler1_origin_inertia_yy = coupler1_inertia_yy
        + coupler1_com_x_times_first_moment_x;
    const wreal coupler1_origin_inertia_zz = coupler1_inertia_zz
        + coupler1_com_x_times_first_moment_x;
    const wreal coupler1_base_second_moment_xx = 0.5 * (coupler1_origin_inertia_yy
        + coupler1_origin_inertia_zz);
    const wreal coupler1_base_second_moment_yy = coupler1_base_second_moment_xx
        - coupler1_origin_inertia_yy;
    const wreal coupler1_base_second_moment_xx_plus_base_second_moment_yy =
        coupler1_base_second_moment_xx + coupler1_base_second_moment_yy;
    w[3] = coupler1_first_moment_x;
    w[8] = coupler1_base_second_moment_xx_plus_base_second_moment_yy;

    /* parameters as they are */
    w[0] = p[14]; /* B0.position.x [m] */
    w[2] = p[19]; /* B1.position.x [m] */
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
    const real B0_q = q[3]; /* rad */
    const real B1_q = q[4]; /* rad */
    const real angle[CARDAN_PADDED(2)] = {B0_q, B1_q};
    real sine[CARDAN_PADDED(2)], cosine[CARDAN_PADDED(2)];
    cardan_sincos(2, angle, sine, cosine);
    const real B0_cos = cosine[0];
    const real B0_sin = sine[0];
    const real B1_cos = cosine[1];
    const real B1_sin = sine[1];

    /* coupler0: omega, alpha, a, n, f */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real A0_u = u[0]; /* rad/s */
    const real B0_u = u[3]; /* rad/s */
    const real A0_udot = udot[0]; /* rad/s^2 */
    const real B0_udot = udot[3]; /* rad/s^2 */
    const wreal B0_position_x = w[0]; /* m */
    const wreal coupler0_first_moment_x = w[1];
    const wreal coupler0_base_second_moment_xx_plus_base_second_moment_yy = w[7];
    const real coupler0_omega_z = A0_u + B0_u;
    const real coupler0_alpha_z = A0_udot + B0_udot;
    const real coupler0_a_y = A0_u * A0_u * B0_position_x * B0_sin
        + B0_position_x * A0_udot * B0_cos;
    const real coupler0_n_z = coupler0_alpha_z *
        coupler0_base_second_moment_xx_plus_base_second_moment_yy
        + coupler0_first_moment_x * coupler0_a_y;
    const real coupler0_f_y = coupler0_first_moment_x * coupler0_alpha_z;
    out[3] = coupler0_n_z; /* tau: B0.u.tau [N*m] */

    /* coupler1: omega, alpha, a, n, f */
    /* omega = Rᵀ omega_parent + S_w u */
    /* alpha = Rᵀ alpha_parent + S_w udot + c_w */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real A1_u = u[1]; /* rad/s */
    const real B1_u = u[4]; /* rad/s */
    const real A1_udot = udot[1]; /* rad/s^2 */
    const real B1_udot = udot[4]; /* rad/s^2 */
    const wreal B1_position_x = w[2]; /* m */
    const wreal coupler1_first_moment_x = w[3];
    const wreal coupler1_base_second_moment_xx_plus_base_second_moment_yy = w[8];
    const real coupler1_omega_z = A1_u + B1_u;
    const real coupler1_alpha_z = A1_udot + B1_udot;
    const real coupler1_a_y = A1_u * A1_u * B1_position_x * B1_sin
        + B1_position_x * A1_udot * B1_cos;
    const real coupler1_n_z = coupler1_alpha_z *
        coupler1_base_second_moment_xx_plus_base_second_moment_yy
        + coupler1_first_moment_x * coupler1_a_y;
    const real coupler1_f_y = coupler1_first_moment_x * coupler1_alpha_z;
    out[4] = coupler1_n_z; /* tau: B1.u.tau [N*m] */

    /* crank2: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real A2_udot = udot[2]; /* rad/s^2 */
    const wreal crank2_base_second_moment_xx_plus_base_second_moment_yy = w[6];
    /* tau: A2.u.tau [N*m] */
    out[2] = A2_udot * crank2_base_second_moment_xx_plus_base_second_moment_yy;

    /* crank0: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal crank0_base_second_moment_yy_plus_base_second_moment_xx = w[4];
    /* tau: A0.u.tau [N*m] */
    out[0] = A0_udot * crank0_base_second_moment_yy_plus_base_second_moment_xx
        + B0_position_x * (B0_cos * coupler0_f_y
        - coupler0_omega_z * coupler0_omega_z * coupler0_first_moment_x * B0_sin) + coupler0_n_z;

    /* crank1: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal crank1_base_second_moment_yy_plus_base_second_moment_xx = w[5];
    /* tau: A1.u.tau [N*m] */
    out[1] = A1_udot * crank1_base_second_moment_yy_plus_base_second_moment_xx
        + B1_position_x * (B1_cos * coupler1_f_y
        - coupler1_omega_z * coupler1_omega_z * coupler1_first_moment_x * B1_sin) + coupler1_n_z;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {5, 0, 9, 0, 5, 5, 0, 0, 0, 28, 0, 5, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
