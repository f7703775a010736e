/*
 * data_0__tree of flexible_pendulum
 * passes: reassociate, schedule
 *
 * Sizes: out 1, work 0, w 1
 * Operations per call: none
 * Operations of prepare: none
 *
 * Input p (6): parameters, read by prepare_ only
 *
 * Output data (1): out[0]
 */
#include "cardan.h"

CARDAN_API void prepare_data_0__tree(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* parameters as they are */
    w[0] = p[0]; /* gravity.z [m/s^2] */
}

#include "lanes.h"

CARDAN_API int data_0__tree(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const wreal *const w = in->w;
    (void)work;

    /* results that are numbers or inputs */
    out[0] = CARDAN_REAL(w[0]); /* data[0] */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int data_0__tree_sizes[] = {1, 0, 1, 0, 0, 0, 0, 0, 0, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
