/*
 * mass_matrix of foot_linkage
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: parallel, base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 4, work 0, w 2
 * Operations per call: none
 * Operations of prepare: none
 *
 * Input p (22): parameters, read by prepare_ only
 *
 * Output M (2 x 2): out[0 ... 3], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* parameters as they are */
    w[0] = p[17]; /* coupler_link.inertia.zz [kg m^2] */
    w[1] = p[21]; /* rocker_link.inertia.zz [kg m^2] */
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const wreal *const w = in->w;
    (void)work;

    /* results that are numbers or inputs */
    out[0] = CARDAN_REAL(w[0]); /* M: B.u,B.u */
    out[1] = CARDAN_REAL(0.0); /* M: B.u,D.u */
    out[2] = CARDAN_REAL(0.0); /* M: D.u,B.u */
    out[3] = CARDAN_REAL(w[1]); /* M: D.u,D.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {4, 0, 2, 0, 0, 0, 0, 0, 0, 22, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
