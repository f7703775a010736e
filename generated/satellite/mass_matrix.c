/*
 * mass_matrix of satellite
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 9, work 0, w 3
 * Operations per call: none
 * Operations of prepare: none
 *
 * Input p (7): parameters, read by prepare_ only
 *
 * Output M (3 x 3): out[0 ... 8], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* parameters as they are */
    w[0] = p[4]; /* sat.inertia.xx [kg m^2] */
    w[1] = p[5]; /* sat.inertia.yy [kg m^2] */
    w[2] = p[6]; /* sat.inertia.zz [kg m^2] */
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const wreal *const w = in->w;
    (void)work;

    /* results that are numbers or inputs */
    out[0] = CARDAN_REAL(w[0]); /* M: attitude.u.x,attitude.u.x */
    out[1] = CARDAN_REAL(0.0); /* M: attitude.u.x,attitude.u.y */
    out[2] = CARDAN_REAL(0.0); /* M: attitude.u.x,attitude.u.z */
    out[3] = CARDAN_REAL(0.0); /* M: attitude.u.y,attitude.u.x */
    out[4] = CARDAN_REAL(w[1]); /* M: attitude.u.y,attitude.u.y */
    out[5] = CARDAN_REAL(0.0); /* M: attitude.u.y,attitude.u.z */
    out[6] = CARDAN_REAL(0.0); /* M: attitude.u.z,attitude.u.x */
    out[7] = CARDAN_REAL(0.0); /* M: attitude.u.z,attitude.u.y */
    out[8] = CARDAN_REAL(w[2]); /* M: attitude.u.z,attitude.u.z */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {9, 0, 3, 0, 0, 0, 0, 0, 0, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
