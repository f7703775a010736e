/*
 * forward_dynamics of cart
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 2, work 0, w 4
 * Operations per call: 21 = 12 mul, 3 add, 3 sub, 1 cos, 1 div, 1 sin
 * Operations of prepare: 4 = 2 mul, 1 add, 1 div
 *
 * Input q (2): generalized coordinates
 *   q[0]  slide [m]
 *   q[1]  swing [rad]
 *
 * Input u (2): generalized speeds
 *   u[0]  slide.u [m/s]
 *   u[1]  swing.u [rad/s]
 *
 * Input r (1): inputs of the model
 *   r[0]  push
 *
 * Input p (7): parameters, read by prepare_ only
 *
 * Input tau (2): applied generalized forces
 *   tau[0]  slide.u.tau [N]
 *   tau[1]  swing.u.tau [N*m]
 *
 * Output udot (2)
 *   out[0]  slide.udot [m/s^2]
 *   out[1]  swing.udot [rad/s^2]
 */
#include "cardan.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* bob: mass, origin inertia */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal m = p[0]; /* kg */
    const wreal l = p[1]; /* m */
    const wreal bob_minus_first_moment_z = m * l;
    const wreal bob_origin_inertia_xx = l * bob_minus_first_moment_z;
    w[1] = bob_minus_first_moment_z;

    /* cart: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal cart_mass = p[3]; /* kg */
    const wreal cart_base_mass = m + cart_mass;
    w[2] = cart_base_mass;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal M_factor_D_inverse_swing = 1.0 / bob_origin_inertia_xx;
    w[3] = M_factor_D_inverse_swing;

    /* parameters as they are */
    w[0] = p[2]; /* gravity.z [m/s^2] */
}

#include "lanes.h"

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const r = in->r;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
    (void)work;

    /* swing: R */
    /* R = R_fixed R_joint(q) */
    const real swing_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {swing_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real swing_cos = cosine[0];
    const real swing_sin = sine[0];

    /* shared by several: inertia */
    const wreal bob_minus_first_moment_z = w[1];
    const real cart_minus_inertia_mean_moment_z = bob_minus_first_moment_z * swing_cos;

    /* bob: a, f */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real swing_u = u[1]; /* rad/s */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const real bob_a_x = gravity_z * swing_sin;
    const real bob_f_z = swing_u * swing_u * bob_minus_first_moment_z;

    /* cart: f */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real cart_f_x = swing_sin * bob_f_z;

    /* slide: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real push = r[0];
    const real slide_u_tau = tau[0]; /* N */
    const real slide_tau = cart_f_x - push;
    const real slide_drive = slide_u_tau - slide_tau;

    /* swing: drive */
    /* drive = tau + f - h */
    const real swing_u_tau = tau[1]; /* N*m */
    const real swing_drive = swing_u_tau + bob_minus_first_moment_z * bob_a_x;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal M_factor_D_inverse_swing = w[3];
    const real M_minus_factor_L_swing_slide = cart_minus_inertia_mean_moment_z *
        M_factor_D_inverse_swing;

    /* slide: udot */
    /* udot = M⁻¹ drive */
    const wreal cart_base_mass = w[2];
    const real slide_udot = 1.0 / (cart_base_mass
        - cart_minus_inertia_mean_moment_z * M_minus_factor_L_swing_slide) * (slide_drive
        + swing_drive * M_minus_factor_L_swing_slide);
    out[0] = slide_udot; /* udot: slide.udot [m/s^2] */

    /* swing: udot */
    /* udot = M⁻¹ drive */
    /* udot: swing.udot [rad/s^2] */
    out[1] = swing_drive * M_factor_D_inverse_swing + M_minus_factor_L_swing_slide * slide_udot;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {2, 0, 4, 0, 2, 2, 0, 0, 1, 7, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0};
#endif
