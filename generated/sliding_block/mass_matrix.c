/*
 * mass_matrix of sliding_block
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * passes: reassociate, schedule
 *
 * Sizes: out 1, work 0, w 1
 * Operations per call: none
 * Operations of prepare: none
 *
 * Input p (9): parameters, read by prepare_ only
 *
 * Output M (1 x 1): out[0], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* parameters as they are */
    w[0] = p[3]; /* block.mass [kg] */
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const wreal *const w = in->w;
    (void)work;

    /* results that are numbers or inputs */
    out[0] = CARDAN_REAL(w[0]); /* M: slide.u,slide.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {1, 0, 1, 0, 0, 0, 0, 0, 0, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
