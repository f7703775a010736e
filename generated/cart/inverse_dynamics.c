/*
 * inverse_dynamics of cart
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 2, work 0, w 4
 * Operations per call: 17 = 10 mul, 3 sub, 2 add, 1 cos, 1 sin
 * Operations of prepare: 7 = 3 add, 3 mul, 1 sub
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
 * Input udot (2): derivatives of the speeds
 *   udot[0]  slide.udot [m/s^2]
 *   udot[1]  swing.udot [rad/s^2]
 *
 * Output tau (2)
 *   out[0]  slide.u.tau [N]
 *   out[1]  swing.u.tau [N*m]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* bob: mass, origin inertia, base, inertia force */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal m = p[0]; /* kg */
    const wreal l = p[1]; /* m */
    const wreal bob_minus_first_moment_z = m * l;
    const wreal bob_origin_inertia_xx = l * bob_minus_first_moment_z;
    const wreal bob_base_second_moment_zz = 0.5 * (bob_origin_inertia_xx + bob_origin_inertia_xx);
    const wreal bob_base_second_moment_xx = bob_base_second_moment_zz - bob_origin_inertia_xx;
    const wreal bob_base_second_moment_zz_plus_base_second_moment_xx = bob_base_second_moment_zz
        + bob_base_second_moment_xx;
    w[1] = bob_minus_first_moment_z;
    w[3] = bob_base_second_moment_zz_plus_base_second_moment_xx;

    /* cart: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal cart_mass = p[3]; /* kg */
    const wreal cart_base_mass = m + cart_mass;
    w[2] = cart_base_mass;

    /* parameters as they are */
    w[0] = p[2]; /* gravity.z [m/s^2] */
}

#include "lanes.h"

/* tau with M udot + h = f + tau */
CARDAN_API int inverse_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const r = in->r;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
    (void)work;

    /* swing: R */
    /* R = R_fixed R_joint(q) */
    const real swing_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {swing_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real swing_cos = cosine[0];
    const real swing_sin = sine[0];

    /* bob: a, f, n */
    /* a = Rᵀ (a_parent + U_parent p) + S_v udot + c_v */
    /* f = inertia_force_f - applied_f + sum R f_child */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real swing_u = u[1]; /* rad/s */
    const real slide_udot = udot[0]; /* m/s^2 */
    const real swing_udot = udot[1]; /* rad/s^2 */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const wreal bob_minus_first_moment_z = w[1];
    const wreal bob_base_second_moment_zz_plus_base_second_moment_xx = w[3];
    const real bob_a_x = slide_udot * swing_cos + gravity_z * swing_sin;
    const real bob_f_z = swing_u * swing_u * bob_minus_first_moment_z;
    /* tau: swing.u.tau [N*m] */
    out[1] = swing_udot * bob_base_second_moment_zz_plus_base_second_moment_xx
        - bob_minus_first_moment_z * bob_a_x;

    /* cart: f */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const wreal cart_base_mass = w[2];
    const real cart_f_x = cart_base_mass * slide_udot + swing_sin * bob_f_z
        - bob_minus_first_moment_z * swing_udot * swing_cos;

    /* slide: tau */
    /* tau = S . [n; f] - force on the joint */
    const real push = r[0];
    out[0] = cart_f_x - push; /* tau: slide.u.tau [N] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {2, 0, 4, 0, 2, 2, 0, 0, 1, 7, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
