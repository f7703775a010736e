/*
 * inverse_dynamics of elevator_door
 * tau with M udot + h = f + tau
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 1, work 0, w 2
 * Operations per call: 4 = 2 mul, 1 add, 1 sub
 * Operations of prepare: none
 *
 * Input u (1): generalized speeds
 *   u[0]  rail.u [m/s]
 *
 * Input s (2): discrete states
 *   s[0]  ends
 *   s[1]  motor.force
 *
 * Input p (6): parameters, read by prepare_ only
 *
 * Input udot (1): derivatives of the speeds
 *   udot[0]  rail.udot [m/s^2]
 *
 * Output tau (1)
 *   out[0]  rail.u.tau [N]
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* parameters as they are */
    w[0] = p[1]; /* door.mass [kg] */
    w[1] = p[2]; /* friction.damping [N*s/m] */
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

    /* door: f */
    /* f = inertia_force_f - applied_f + sum R f_child */
    const real rail_udot = udot[0]; /* m/s^2 */
    const wreal door_mass = w[0]; /* kg */
    const real door_f_x = door_mass * rail_udot;

    /* rail: tau */
    /* tau = S . [n; f] - force on the joint */
    const real motor_force = s[1];
    const real rail_u = u[0]; /* m/s */
    const wreal friction_damping = w[1]; /* N*s/m */
    out[0] = door_f_x - motor_force + rail_u * friction_damping; /* tau: rail.u.tau [N] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {1, 0, 2, 0, 0, 1, 0, 2, 0, 6, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
