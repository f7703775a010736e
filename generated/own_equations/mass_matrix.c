/*
 * mass_matrix of own_equations
 * M: kinetic energy is 1/2 uᵀ M u
 * formalism: composite
 * passes: reassociate, schedule
 *
 * Sizes: out 9, work 0, w 6
 * Operations per call: 12 = 5 mul, 2 cos, 2 neg, 2 sin, 1 add
 * Operations of prepare: 13 = 12 mul, 1 add
 *
 * Input q (3): generalized coordinates
 *   q[0]  x
 *   q[1]  q1
 *   q[2]  q2
 *
 * Input p (4): parameters, read by prepare_ only
 *
 * Output M (3 x 3): out[0 ... 8], row by row
 */
#include "cardan.h"

CARDAN_API void prepare_mass_matrix(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* M */
    const wreal m = p[2];
    const wreal m_cart = p[3];
    w[0] = m_cart + 2.0 * m; /* M_1_1 */

    /* common */
    const wreal l = p[1];
    const wreal mul_1_4 = l * l;
    w[1] = 1.5 * l * m; /* mul_1 */
    w[2] = 0.5 * l * m; /* mul_1_2 */
    w[4] = 0.5 * m * mul_1_4; /* mul_1_3 */

    /* M */
    w[3] = 1.3333333333333333 * m * mul_1_4; /* M_2_2 */
    w[5] = 0.3333333333333333 * m * mul_1_4; /* M_3_3 */
}

#include "lanes.h"

/* M: kinetic energy is 1/2 uᵀ M u */
CARDAN_API int mass_matrix(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const wreal *const w = in->w;
    (void)work;

    /* shared by several: output */
    const real q1_q = q[1];
    const real q2_q = q[2];
    const real angle[CARDAN_PADDED(2)] = {q1_q, q2_q};
    real sine[CARDAN_PADDED(2)], cosine[CARDAN_PADDED(2)];
    cardan_sincos(2, angle, sine, cosine);
    const real cos_1 = cosine[0];
    const real cos_1_2 = cosine[1];
    const real tip_output = sine[0];
    const real tip_output_2 = sine[1];

    /* M */
    const wreal mul_1 = w[1];
    const wreal mul_1_2 = w[2];
    const wreal mul_1_3 = w[4];
    const real M_2_1 = -cos_1 * mul_1;
    const real M_3_1 = -cos_1_2 * mul_1_2;
    const real M_3_2 = (cos_1 * cos_1_2 + tip_output * tip_output_2) * mul_1_3;
    out[1] = M_2_1; /* M: v,u1 */
    out[3] = M_2_1; /* M: u1,v */
    out[2] = M_3_1; /* M: v,u2 */
    out[6] = M_3_1; /* M: u2,v */
    out[5] = M_3_2; /* M: u1,u2 */
    out[7] = M_3_2; /* M: u2,u1 */

    /* results that are numbers or inputs */
    out[0] = CARDAN_REAL(w[0]); /* M: v,v */
    out[4] = CARDAN_REAL(w[3]); /* M: u1,u1 */
    out[8] = CARDAN_REAL(w[5]); /* M: u2,u2 */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {9, 0, 6, 0, 3, 0, 0, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
