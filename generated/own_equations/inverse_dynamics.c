/*
 * inverse_dynamics of own_equations
 * tau with M udot + h = f + tau
 * formalism: composite
 * passes: reassociate, schedule
 *
 * Sizes: out 3, work 0, w 9
 * Operations per call: 88 = 52 mul, 16 add, 16 sub, 2 cos, 2 sin
 * Operations of prepare: 21 = 20 mul, 1 add
 *
 * Input q (3): generalized coordinates
 *   q[0]  x
 *   q[1]  q1
 *   q[2]  q2
 *
 * Input u (3): generalized speeds
 *   u[0]  v
 *   u[1]  u1
 *   u[2]  u2
 *
 * Input r (1): inputs of the model
 *   r[0]  F
 *
 * Input p (4): parameters, read by prepare_ only
 *
 * Input udot (3): derivatives of the speeds
 *   udot[0]  vdot
 *   udot[1]  u1dot
 *   udot[2]  u2dot
 *
 * Output tau (3)
 *   out[0]  v.tau
 *   out[1]  u1.tau
 *   out[2]  u2.tau
 */
#include "cardan.h"

CARDAN_API void prepare_inverse_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* common */
    const wreal g = p[0];
    const wreal l = p[1];
    const wreal m = p[2];
    const wreal m_cart = p[3];
    const wreal mul_1_9 = l * l;
    w[0] = m_cart + 2.0 * m; /* add_1 */
    w[1] = 1.5 * l * m; /* mul_1 */
    w[2] = 0.5 * l * m; /* mul_1_2 */
    w[3] = 1.3333333333333333 * m * mul_1_9; /* mul_1_3 */
    w[4] = 0.5 * m * mul_1_9; /* mul_1_4 */
    w[5] = 0.3333333333333333 * m * mul_1_9; /* mul_1_5 */
    w[6] = 1.5 * g * l * m; /* mul_1_6 */
    w[7] = 0.5 * g * l * m; /* mul_1_7 */
    w[8] = g * l * m; /* mul_1_8 */
}

#include "lanes.h"

/* tau with M udot + h = f + tau */
CARDAN_API int inverse_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const r = in->r;
    const wreal *const w = in->w;
    const real *const udot = in->udot;
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

    /* common */
    const real F = r[0];
    const real v = u[0];
    const real u1 = u[1];
    const real u2 = u[2];
    const wreal mul_1 = w[1];
    const wreal mul_1_2 = w[2];
    const wreal mul_1_4 = w[4];
    const wreal mul_1_6 = w[6];
    const wreal mul_1_7 = w[7];
    const wreal mul_1_8 = w[8];
    const real mul_1_10 = cos_1 * mul_1;
    const real mul_1_11 = cos_1_2 * mul_1_2;
    const real mul_1_12 = (cos_1 * cos_1_2 + tip_output * tip_output_2) * mul_1_4;
    const real mul_1_13 = u1 * u1;
    const real mul_1_14 = u2 * u2;
    const real sub_1 = F - mul_1 * mul_1_13 * tip_output - mul_1_2 * mul_1_14 * tip_output_2;
    const real sub_1_2 = cos_1_2 * tip_output - cos_1 * tip_output_2;
    const real sub_1_3 = tip_output * mul_1_6 - mul_1_4 * mul_1_14 * sub_1_2;
    const real add_1_2 = tip_output_2 * mul_1_7 + mul_1_4 * mul_1_13 * sub_1_2;
    const real mul_1_15 = u1 * tip_output;
    const real mul_1_16 = mul_1 * mul_1_15;
    const real mul_1_17 = u2 * tip_output_2;
    const real mul_1_18 = mul_1_2 * mul_1_17;
    const real mul_1_19 = mul_1_4 * (u1 * cos_1 * tip_output_2 + u2 * cos_1_2 * tip_output
        - (cos_1_2 * mul_1_15 + cos_1 * mul_1_17));
    const real add_1_3 = sub_1 + 0.5 * (u1 * mul_1_16 + u2 * mul_1_18);
    const real add_1_4 = sub_1_3 - 1.5 * tip_output * mul_1_8 + 0.5 * (v * mul_1_16
        + u2 * mul_1_19);
    const real add_1_5 = add_1_2 - 0.5 * tip_output_2 * mul_1_8 + 0.5 * (v * mul_1_18
        + u1 * mul_1_19);

    /* equations: tau v, tau u */
    const real vdot = udot[0];
    const real u1dot = udot[1];
    const real u2dot = udot[2];
    const wreal add_1 = w[0];
    const wreal mul_1_3 = w[3];
    const wreal mul_1_5 = w[5];
    /* tau: v.tau */
    out[0] = add_1 * vdot - mul_1_10 * u1dot - (sub_1 + mul_1_11 * u2dot) - add_1_3 + add_1_3;
    /* tau: u1.tau */
    out[1] = mul_1_3 * u1dot - mul_1_10 * vdot + mul_1_12 * u2dot - sub_1_3 - add_1_4 + add_1_4;
    /* tau: u2.tau */
    out[2] = mul_1_5 * u2dot - mul_1_11 * vdot + mul_1_12 * u1dot - add_1_2 - add_1_5 + add_1_5;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {3, 0, 9, 0, 3, 3, 0, 0, 1, 4, 0, 3, 0, 0, 0, 0, 0, 0, 0};
#endif
