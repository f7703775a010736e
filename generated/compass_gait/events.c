/*
 * events of compass_gait
 * numbers that fall through zero where an event happens
 * formalism: composite
 * rewrites: parallel, base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 1, work 0, w 1
 * Operations per call: 5 = 2 add, 1 max, 1 mul, 1 sub
 * Operations of prepare: 1 = 1 mul
 *
 * Input q (2): generalized coordinates
 *   q[0]  stance [rad]
 *   q[1]  hip [rad]
 *
 * Input p (9): parameters, read by prepare_ only
 *
 * Output events (1)
 *   out[0]  strike
 */
#include "cardan.h"

CARDAN_API void prepare_events(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* strike: data */
    const wreal slope = p[0]; /* rad */
    const wreal twice_slope = 2.0 * slope;
    w[0] = twice_slope;
}

#include "lanes.h"

/* numbers that fall through zero where an event happens */
CARDAN_API int events(const cardan_in *in, real *CARDAN_RESTRICT out, real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
    (void)work;

    /* strike: data */
    const real stance_q = q[0]; /* rad */
    const real hip_q = q[1]; /* rad */
    const wreal twice_slope = w[0];
    out[0] = cardan_max(0.1 - hip_q, hip_q + twice_slope + 2.0 * stance_q); /* events: strike */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int events_sizes[] = {1, 0, 1, 0, 2, 0, 0, 0, 0, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
