/*
 * transition of compass_gait
 * speeds, internal and discrete states behind the events e
 * formalism: composite
 * rewrites: parallel, base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 2, work 0, w 0
 * Operations per call: none
 * Operations of prepare: none
 *
 * Input u (2): generalized speeds
 *   u[0]  stance.u [rad/s]
 *   u[1]  hip.u [rad/s]
 *
 * Output u (2)
 *   out[0]  stance.u [rad/s]
 *   out[1]  hip.u [rad/s]
 *
 * Output z (0): empty
 *
 * Output s (0): empty
 */
#include "cardan.h"

CARDAN_API void prepare_transition(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    (void)p;
    (void)w;
}

#include "lanes.h"

/* speeds, internal and discrete states behind the events e */
CARDAN_API int transition(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const u = in->u;
    (void)work;

    /* results that are numbers or inputs */
    out[0] = u[0]; /* u: stance.u [rad/s] */
    out[1] = u[1]; /* u: hip.u [rad/s] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int transition_sizes[] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
