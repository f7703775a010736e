/*
 * inverse_dynamics of foot_linkage
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: parallel, base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 2, work 0, w 2
 * Operations per call: 2 = 2 mul
 * Operations of prepare: 12 = 6 add, 4 sub, 2 mul
 *
 * Input p (22): parameters, read by prepare_ only
 *
 * Input udot (2): derivatives of the speeds
 *   udot[0]  B.udot [rad/s^2]
 *   udot[1]  D.udot [rad/s^2]
 *
 * Output tau (2)
 *   out[0]  B.u.tau [N*m]
 *   out[1]  D.u.tau [N*m]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* coupler_link: base, inertia force */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal coupler_link_inertia_xx = p[15]; /* kg m^2 */
    const wreal coupler_link_inertia_yy = p[16]; /* kg m^2 */
    const wreal coupler_link_inertia_zz = p[17]; /* kg m^2 */
    const wreal coupler_link_base_half_trace = 0.5 * (coupler_link_inertia_xx
        + coupler_link_inertia_zz + coupler_link_inertia_yy);
    const wreal coupler_link_base_second_moment_xx = coupler_link_base_half_trace
        - coupler_link_inertia_xx;
    const wreal coupler_link_base_second_moment_yy = coupler_link_base_half_trace
        - coupler_link_inertia_yy;
    const wreal coupler_link_n_z_part = coupler_link_base_second_moment_xx
        + coupler_link_base_second_moment_yy;
    w[0] = coupler_link_n_z_part;

    /* rocker_link: base, inertia force */
    /* base = inertia + what the joints outboard do not feel of theirs - what its own does not */
    /* inertia_force = [2 vee(skew(U J)) + h x a; m a + U h] */
    const wreal rocker_link_inertia_xx = p[19]; /* kg m^2 */
    const wreal rocker_link_inertia_yy = p[20]; /* kg m^2 */
    const wreal rocker_link_inertia_zz = p[21]; /* kg m^2 */
    const wreal rocker_link_base_half_trace = 0.5 * (rocker_link_inertia_xx
        + rocker_link_inertia_zz + rocker_link_inertia_yy);
    const wreal rocker_link_base_second_moment_xx = rocker_link_base_half_trace
        - rocker_link_inertia_xx;
    const wreal rocker_link_base_second_moment_yy = rocker_link_base_half_trace
        - rocker_link_inertia_yy;
    const wreal rocker_link_base_second_moment_xx_plus_base_second_moment_yy =
        rocker_link_base_second_moment_xx + rocker_link_base_second_moment_yy;
    w[1] = rocker_link_base_second_moment_xx_plus_base_second_moment_yy;
}

#include "lanes.h"

/* tau with M udot + h = f + tau */
CARDAN_API int inverse_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const wreal *const w = in->w;
    const real *const udot = in->udot;
    (void)work;

    /* coupler_link: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real B_udot = udot[0]; /* rad/s^2 */
    const wreal coupler_link_n_z_part = w[0];
    out[0] = B_udot * coupler_link_n_z_part; /* tau: B.u.tau [N*m] */

    /* rocker_link: n */
    /* n = inertia_force_n - applied_n + sum (R n_child + p x R f_child) */
    const real D_udot = udot[1]; /* rad/s^2 */
    const wreal rocker_link_base_second_moment_xx_plus_base_second_moment_yy = w[1];
    /* tau: D.u.tau [N*m] */
    out[1] = D_udot * rocker_link_base_second_moment_xx_plus_base_second_moment_yy;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {2, 0, 2, 0, 0, 0, 0, 0, 0, 22, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
