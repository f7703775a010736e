/*
 * forward_dynamics of elastic_pendulum
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 2, work 0, w 8
 * Operations per call: 28 = 16 mul, 6 add, 3 sub, 1 cos, 1 div, 1 sin
 * Operations of prepare: 4 = 2 mul, 1 add, 1 div
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
 * Input tau (2): applied generalized forces
 *   tau[0]  pivot.u.tau [N*m]
 *   tau[1]  slide.u.tau [N]
 *
 * Output udot (2)
 *   out[0]  pivot.udot [rad/s^2]
 *   out[1]  slide.udot [m/s^2]
 */
#include "cardan.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* arm: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal arm_mass = p[3]; /* kg */
    const wreal arm_com_z = p[4]; /* m */
    const wreal arm_inertia_yy = p[6]; /* kg m^2 */
    const wreal arm_first_moment_z = arm_mass * arm_com_z;
    const wreal arm_origin_inertia_yy = arm_inertia_yy + arm_com_z * arm_first_moment_z;
    w[3] = arm_first_moment_z;
    w[4] = arm_origin_inertia_yy;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal mass = p[0]; /* kg */
    const wreal M_factor_D_inverse_slide = 1.0 / mass;
    w[7] = M_factor_D_inverse_slide;

    /* parameters as they are */
    w[0] = p[0]; /* mass [kg] */
    w[1] = p[1]; /* stiffness [N/m] */
    w[2] = p[2]; /* gravity.z [m/s^2] */
    w[5] = p[8]; /* slide.position.z [m] */
    w[6] = p[9]; /* spring.damping [N*s/m] */
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

    /* pivot: R */
    /* R = R_fixed R_joint(q) */
    const real pivot_q = q[0]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {pivot_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real pivot_cos = cosine[0];
    const real pivot_sin = sine[0];

    /* slide: p, tau, drive, udot */
    /* p = p_fixed + R_fixed p_joint(q) */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    /* udot = M⁻¹ drive */
    const real slide_q = q[1]; /* m */
    const real slide_u_tau = tau[1]; /* N */
    const real pivot_u = u[0]; /* rad/s */
    const real slide_u = u[1]; /* m/s */
    const wreal mass = w[0]; /* kg */
    const wreal stiffness = w[1]; /* N/m */
    const wreal gravity_z = w[2]; /* m/s^2 */
    const wreal slide_position_z = w[5]; /* m */
    const wreal spring_damping = w[6]; /* N*s/m */
    const wreal M_factor_D_inverse_slide = w[7];
    const real slide_p_z = slide_position_z + slide_q;
    const real slide_tau = stiffness * slide_q + slide_u * spring_damping
        - mass * (gravity_z * pivot_cos + pivot_u * pivot_u * slide_p_z);
    const real slide_drive = slide_u_tau - slide_tau;
    out[1] = slide_drive * M_factor_D_inverse_slide; /* udot: slide.udot [m/s^2] */

    /* arm: composite, a */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    const wreal arm_origin_inertia_yy = w[4];
    const real arm_composite_inertia_xx = mass * slide_p_z * slide_p_z;
    const real arm_composite_inertia_yy = arm_origin_inertia_yy + arm_composite_inertia_xx;
    const real arm_a_x = gravity_z * pivot_sin;

    /* bob: a, f */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real bob_a_x = arm_a_x + pivot_u * slide_u * 2.0;
    const real bob_f_x = mass * bob_a_x;

    /* arm: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const wreal arm_first_moment_z = w[3];
    const real arm_n_y = arm_first_moment_z * arm_a_x + slide_p_z * bob_f_x;

    /* pivot: drive, udot */
    /* drive = tau + f - h */
    /* udot = M⁻¹ drive */
    const real pivot_u_tau = tau[0]; /* N*m */
    const real pivot_drive = pivot_u_tau - arm_n_y;
    out[0] = 1.0 / arm_composite_inertia_yy * pivot_drive; /* udot: pivot.udot [rad/s^2] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {2, 0, 8, 0, 2, 2, 0, 0, 0, 10, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0};
#endif
