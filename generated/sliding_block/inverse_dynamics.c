/*
 * inverse_dynamics of sliding_block
 * tau with M udot + h = f + tau
 * formalism: composite
 * passes: reassociate
 *
 * Sizes: out 1, work 0, w 7
 * Operations per call: 11 = 4 select, 2 eq, 2 lt, 2 mul, 1 add
 * Operations of prepare: 4 = 2 mul, 1 abs, 1 solve
 *
 * Input u (1): generalized speeds
 *   u[0]  slide.u [m/s]
 *
 * Input s (2): discrete states
 *   s[0]  friction
 *   s[1]  wall
 *
 * Input p (9): parameters, read by prepare_ only
 *
 * Input udot (1): derivatives of the speeds
 *   udot[0]  slide.udot [m/s^2]
 *
 * Output tau (1)
 *   out[0]  slide.u.tau [N]
 */
#include "cardan.h"
#include "solve.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    wreal *const system_matrix = w + 2;
    wreal *const system_right = w + 3;
    wreal *const system_scratch = w + 4;

    /* common */
    const wreal mu = p[0];
    const wreal gravity_z = p[2]; /* m/s^2 */
    const wreal block_mass = p[3]; /* kg */
    const wreal mu_times_block_minus_f_z_abs = mu * cardan_abs(gravity_z * block_mass);
    system_right[0] = mu_times_block_minus_f_z_abs;
    system_matrix[0] = CARDAN_WREAL(1.0);
    /* system_matrix x = system_right; the solution takes its place */
    (void)CARDAN_SOLVE(rank_revealing, 1, 1, system_matrix, system_right, system_scratch);
    const wreal slide_tau_part = system_right[0];
    w[1] = slide_tau_part;

    /* parameters as they are */
    w[0] = p[3]; /* block.mass [kg] */
}

#include "lanes.h"

/* tau with M udot + h = f + tau */
CARDAN_API int inverse_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const u = in->u;
    const real *const s = in->s;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
    (void)work;

    /* block: f */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real slide_udot = udot[0]; /* m/s^2 */
    const wreal block_mass = w[0]; /* kg */
    const real block_f_x = block_mass * slide_udot;

    /* slide: tau */
    /* tau = S . [n; f] - force on the joint */
    const real friction = s[0];
    const real slide_u = u[0]; /* m/s */
    const wreal slide_tau_part = w[1];
    /* tau: slide.u.tau [N] */
    out[0] = block_f_x
        + cardan_select(cardan_eq(0.0, friction), cardan_select(cardan_lt(0.0, slide_u), 1.0,
        cardan_select(cardan_lt(slide_u, 0.0), -1.0, 0.0)), cardan_select(cardan_eq(friction, 2.0),
        0.0, friction)) * slide_tau_part;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {1, 0, 7, 0, 0, 1, 0, 2, 0, 9, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
