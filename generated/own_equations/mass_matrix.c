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
    /* M = S . momentum */
    const wreal m = p[2];
    const wreal m_cart = p[3];
    const wreal M_equations_v_equations_v = m_cart + 2.0 * m;
    w[0] = M_equations_v_equations_v;

    /* common */
    const wreal l = p[1];
    const wreal m_times_l_times_c1p5 = 1.5 * l * m;
    const wreal m_times_half_l = 0.5 * l * m;
    const wreal l_squared = l * l;
    const wreal l_squared_times_half_m = 0.5 * m * l_squared;
    w[1] = m_times_l_times_c1p5;
    w[2] = m_times_half_l;
    w[4] = l_squared_times_half_m;

    /* M */
    /* M = S . momentum */
    const wreal M_equations_u1_equations_u1 = 1.3333333333333333 * m * l_squared;
    const wreal M_equations_u2_equations_u2 = 0.3333333333333333 * m * l_squared;
    w[3] = M_equations_u1_equations_u1;
    w[5] = M_equations_u2_equations_u2;
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
    const real q1_cos = cosine[0];
    const real q2_cos = cosine[1];
    const real q1_sin = sine[0];
    const real q2_sin = sine[1];

    /* common */
    const wreal m_times_l_times_c1p5 = w[1];
    const wreal m_times_half_l = w[2];
    const real M_equations_u1_equations_v = -q1_cos * m_times_l_times_c1p5;
    const real M_equations_u2_equations_v = -q2_cos * m_times_half_l;
    out[1] = M_equations_u1_equations_v; /* M: v,u1 */
    out[3] = M_equations_u1_equations_v; /* M: u1,v */
    out[2] = M_equations_u2_equations_v; /* M: v,u2 */
    out[6] = M_equations_u2_equations_v; /* M: u2,v */

    /* M */
    /* M = S . momentum */
    const wreal l_squared_times_half_m = w[4];
    const real M_equations_u2_equations_u1 = (q1_cos * q2_cos
        + q1_sin * q2_sin) * l_squared_times_half_m;
    out[5] = M_equations_u2_equations_u1; /* M: u1,u2 */
    out[7] = M_equations_u2_equations_u1; /* M: u2,u1 */

    /* results that are numbers or inputs */
    out[0] = CARDAN_REAL(w[0]); /* M: v,v */
    out[4] = CARDAN_REAL(w[3]); /* M: u1,u1 */
    out[8] = CARDAN_REAL(w[5]); /* M: u2,u2 */
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int mass_matrix_sizes[] = {9, 0, 6, 0, 3, 0, 0, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
