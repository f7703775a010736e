/*
 * forward_dynamics of cart_and_pole
 * udot with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: unroll, reassociate
 *
 * Sizes: out 2, work 0, w 4
 * Operations per call: 21 = 12 mul, 4 sub, 2 add, 1 cos, 1 div, 1 sin
 * Operations of prepare: 4 = 2 mul, 1 add, 1 div
 *
 * Input q (2): generalized coordinates
 *   q[0]  rail [m]
 *   q[1]  hinge [rad]
 *
 * Input u (2): generalized speeds
 *   u[0]  rail.u [m/s]
 *   u[1]  hinge.u [rad/s]
 *
 * Input r (1): inputs of the model
 *   r[0]  push [N]
 *
 * Input p (7): parameters, read by prepare_ only
 *
 * Input tau (2): applied generalized forces
 *   tau[0]  rail.u.tau [N]
 *   tau[1]  hinge.u.tau [N*m]
 *
 * Output udot (2)
 *   out[0]  rail.udot [m/s^2]
 *   out[1]  hinge.udot [rad/s^2]
 */
#include "cardan.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* bob: first moment, origin inertia */
    /* first_moment = sum m c */
    /* origin_inertia = sum (R I Rᵀ + m (c·c 1 - c cᵀ)) */
    const wreal bob_mass = p[5]; /* kg */
    const wreal bob_com_z = p[6]; /* m */
    const wreal bob_first_moment_z = bob_mass * bob_com_z;
    const wreal bob_origin_inertia_xx = bob_com_z * bob_first_moment_z;
    w[1] = bob_first_moment_z;

    /* cart: base */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    const wreal cart_mass = p[1]; /* kg */
    const wreal cart_base_mass = cart_mass + bob_mass;
    w[2] = cart_base_mass;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal M_factor_D_inverse_hinge = 1.0 / bob_origin_inertia_xx;
    w[3] = M_factor_D_inverse_hinge;

    /* parameters as they are */
    w[0] = p[0]; /* gravity.z [m/s^2] */
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

    /* hinge: R */
    /* R = R_fixed R_joint(q) */
    const real hinge_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {hinge_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real hinge_cos = cosine[0];
    const real hinge_sin = sine[0];

    /* cart: composite, f */
    /* composite = own + sum R composite_child Rᵀ moved by p */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real hinge_u = u[1]; /* rad/s */
    const wreal bob_first_moment_z = w[1];
    const real cart_composite_moment_z = bob_first_moment_z * hinge_cos;
    const real cart_f_x = hinge_u * hinge_u * bob_first_moment_z * hinge_sin;

    /* hinge: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real hinge_u_tau = tau[1]; /* N*m */
    const wreal gravity_z = w[0]; /* m/s^2 */
    const real hinge_tau = gravity_z * hinge_sin * bob_first_moment_z;
    const real hinge_drive = hinge_u_tau - hinge_tau;

    /* rail: tau, drive */
    /* tau = S . [n; f] - force on the joint */
    /* drive = tau + f - h */
    const real push = r[0]; /* N */
    const real rail_u_tau = tau[0]; /* N */
    const real rail_tau = cart_f_x - push;
    const real rail_drive = rail_u_tau - rail_tau;

    /* M: factor */
    /* factor = L, D with M = Lᵀ D L */
    const wreal M_factor_D_inverse_hinge = w[3];
    const real M_minus_factor_L_hinge_rail = cart_composite_moment_z * M_factor_D_inverse_hinge;

    /* rail: udot */
    /* udot = M⁻¹ drive */
    const wreal cart_base_mass = w[2];
    const real rail_udot = 1.0 / (cart_base_mass
        - cart_composite_moment_z * M_minus_factor_L_hinge_rail) * (rail_drive
        + hinge_drive * M_minus_factor_L_hinge_rail);
    out[0] = rail_udot; /* udot: rail.udot [m/s^2] */

    /* hinge: udot */
    /* udot = M⁻¹ drive */
    /* udot: hinge.udot [rad/s^2] */
    out[1] = hinge_drive * M_factor_D_inverse_hinge + M_minus_factor_L_hinge_rail * rail_udot;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {2, 0, 4, 0, 2, 2, 0, 0, 1, 7, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0};
#endif
