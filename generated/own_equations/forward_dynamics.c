/*
 * forward_dynamics of own_equations
 * udot with M udot + h = f + tau
 * formalism: composite
 * passes: unroll, reassociate
 *
 * Sizes: out 3, work 0, w 9
 * Operations per call: 101 = 59 mul, 18 add, 18 sub, 2 cos, 2 div, 2 sin
 * Operations of prepare: 22 = 20 mul, 1 add, 1 div
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
 * Input tau (3): applied generalized forces
 *   tau[0]  v.tau
 *   tau[1]  u1.tau
 *   tau[2]  u2.tau
 *
 * Output udot (3)
 *   out[0]  vdot
 *   out[1]  u1dot
 *   out[2]  u2dot
 */
#include "cardan.h"

CARDAN_API void prepare_forward_dynamics(const wreal *p, wreal *CARDAN_RESTRICT w)
{
    /* M */
    const wreal m = p[2];
    const wreal m_cart = p[3];
    w[0] = m_cart + 2.0 * m; /* M_1_1 */

    /* common */
    const wreal g = p[0];
    const wreal l = p[1];
    const wreal mul_1_7 = l * l;
    w[1] = 1.5 * l * m; /* mul_1 */
    w[2] = 0.5 * l * m; /* mul_1_2 */
    w[4] = 0.5 * m * mul_1_7; /* mul_1_3 */
    w[5] = 1.5 * g * l * m; /* mul_1_4 */
    w[6] = 0.5 * g * l * m; /* mul_1_5 */
    w[7] = g * l * m; /* mul_1_6 */

    /* M: D inverse */
    const wreal M_3_3 = 0.3333333333333333 * m * mul_1_7;
    w[3] = 1.3333333333333333 * m * mul_1_7; /* M_2_2 */
    w[8] = 1.0 / M_3_3; /* M_D_inverse_3 */
}

#include "lanes.h"

/* udot with M udot + h = f + tau */
CARDAN_API int forward_dynamics(const cardan_in *in, real *CARDAN_RESTRICT out,
    real *CARDAN_RESTRICT work)
{
    const real *const q = in->q;
    const real *const u = in->u;
    const real *const r = in->r;
    const wreal *const w = in->w;
    const real *const tau = in->tau;
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
    const wreal mul_1_3 = w[4];
    const wreal mul_1_4 = w[5];
    const wreal mul_1_5 = w[6];
    const wreal mul_1_6 = w[7];
    const real mul_1_8 = cos_1_2 * mul_1_2;
    const real mul_1_9 = u1 * u1;
    const real mul_1_10 = u2 * u2;
    const real sub_1 = F - mul_1 * mul_1_9 * tip_output - mul_1_2 * mul_1_10 * tip_output_2;
    const real sub_1_2 = cos_1_2 * tip_output - cos_1 * tip_output_2;
    const real sub_1_3 = tip_output * mul_1_4 - mul_1_3 * mul_1_10 * sub_1_2;
    const real add_1 = tip_output_2 * mul_1_5 + mul_1_3 * mul_1_9 * sub_1_2;
    const real mul_1_11 = u1 * tip_output;
    const real mul_1_12 = mul_1 * mul_1_11;
    const real mul_1_13 = u2 * tip_output_2;
    const real mul_1_14 = mul_1_2 * mul_1_13;
    const real mul_1_15 = mul_1_3 * (u1 * cos_1 * tip_output_2 + u2 * cos_1_2 * tip_output
        - (cos_1_2 * mul_1_11 + cos_1 * mul_1_13));
    const real add_1_2 = sub_1 + 0.5 * (u1 * mul_1_12 + u2 * mul_1_14);
    const real add_1_3 = sub_1_3 - 1.5 * tip_output * mul_1_6 + 0.5 * (v * mul_1_12
        + u2 * mul_1_15);
    const real add_1_4 = add_1 - 0.5 * tip_output_2 * mul_1_6 + 0.5 * (v * mul_1_14
        + u1 * mul_1_15);

    /* M: L, factor, D inverse */
    const wreal M_1_1 = w[0];
    const wreal M_2_2 = w[3];
    const wreal M_D_inverse_3 = w[8];
    const real M_3_2 = (cos_1 * cos_1_2 + tip_output * tip_output_2) * mul_1_3;
    const real M_L_3_2 = M_3_2 * M_D_inverse_3;
    const real M_factor = mul_1_8 * M_L_3_2 - cos_1 * mul_1;
    const real M_factor_2 = mul_1_8 * M_D_inverse_3;
    const real M_D_inverse_2 = 1.0 / (M_2_2 - M_3_2 * M_L_3_2);
    const real M_L_2_1 = M_factor * M_D_inverse_2;
    const real M_D_inverse_1 = 1.0 / (M_1_1 - mul_1_8 * M_factor_2 - M_factor * M_L_2_1);

    /* equations: drive v, drive u */
    const real v_tau = tau[0];
    const real u1_tau = tau[1];
    const real u2_tau = tau[2];
    const real equations_drive_v = sub_1 + v_tau + add_1_2 - add_1_2;
    const real equations_drive_u1 = sub_1_3 + u1_tau + add_1_3 - add_1_3;
    const real equations_drive_u2 = add_1 + u2_tau + add_1_4 - add_1_4;

    /* M: factor */
    const real M_factor_3 = equations_drive_u1 - equations_drive_u2 * M_L_3_2;

    /* equations: udot v, udot u */
    const real equations_udot_v = M_D_inverse_1 * (equations_drive_v
        + equations_drive_u2 * M_factor_2 - M_L_2_1 * M_factor_3);
    const real equations_udot_u1 = M_D_inverse_2 * M_factor_3 - M_L_2_1 * equations_udot_v;
    out[0] = equations_udot_v; /* udot: vdot */
    out[1] = equations_udot_u1; /* udot: u1dot */
    /* udot: u2dot */
    out[2] = equations_drive_u2 * M_D_inverse_3 + M_factor_2 * equations_udot_v
        - M_L_3_2 * equations_udot_u1;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int forward_dynamics_sizes[] = {3, 0, 9, 0, 3, 3, 0, 0, 1, 4, 0, 0, 0, 0, 3, 0, 0, 0, 0};
#endif
