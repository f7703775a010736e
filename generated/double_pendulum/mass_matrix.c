/*
 * mass_matrix of double_pendulum
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * rewrites: base_parameters
 * passes: reassociate, schedule
 *
 * Sizes: out 4, work 0, w 4
 * Operations per call: 6 = 3 mul, 2 add, 1 cos
 * Operations of prepare: 13 = 10 mul, 3 add
 *
 * Input q (2): generalized coordinates
 *   q[0]  shoulder [rad]
 *   q[1]  elbow [rad]
 *
 * Input p (3): parameters, read by prepare_ only
 *
 * Output M (2 x 2): out[0 ... 3], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* shared by several: mass */
    const wreal m = p[0]; /* kg */
    const wreal l = p[1]; /* m */
    const wreal upper_mass_2 = 0.5 * l;
    const wreal upper_mass = m * upper_mass_2;
    w[1] = upper_mass; /* upper_mass */

    /* upper: inertia, base inertia */
    const wreal upper_inertia_xx = l * l * (0.08333333333333333 * m) + upper_mass_2 * upper_mass;
    const wreal upper_base_inertia_yy = upper_inertia_xx + 0.5 * m * l * l * 2.0;
    w[2] = upper_inertia_xx; /* upper_inertia_xx */
    w[3] = upper_inertia_xx + upper_base_inertia_yy; /* upper_inertia */

    /* parameters as they are */
    w[0] = p[1]; /* l [m] */
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
    (void)work;

    /* elbow: cos */
    const real elbow_q = q[1]; /* rad */
    const real angle[CARDAN_PADDED(1)] = {elbow_q};
    real sine[CARDAN_PADDED(1)], cosine[CARDAN_PADDED(1)];
    cardan_sincos(1, angle, sine, cosine);
    const real elbow_cos = cosine[0];

    /* shared by several: inertia */
    const wreal l = w[0]; /* m */
    const wreal upper_mass = w[1];
    const real upper_inertia_2 = upper_mass * elbow_cos * l;

    /* upper: composite inertia */
    const wreal upper_inertia = w[3];
    out[0] = 2.0 * upper_inertia_2 + upper_inertia; /* M: shoulder.u,shoulder.u */

    /* M */
    const wreal upper_inertia_xx = w[2];
    const real M_2_1 = upper_inertia_xx + upper_inertia_2;
    out[1] = M_2_1; /* M: shoulder.u,elbow.u */
    out[2] = M_2_1; /* M: elbow.u,shoulder.u */

    /* results that are numbers or inputs */
    out[3] = CARDAN_REAL(w[2]); /* M: elbow.u,elbow.u */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {4, 0, 4, 0, 2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
