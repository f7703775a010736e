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
    const wreal m_cart_plus_twice_m = m_cart + 2.0 * m;
    const wreal m_times_l_times_c1p5 = 1.5 * l * m;
    const wreal m_times_half_l = 0.5 * l * m;
    const wreal l_squared = l * l;
    const wreal l_squared_times_m_times_c1p3333333333333333 = 1.3333333333333333 * m * l_squared;
    const wreal l_squared_times_half_m = 0.5 * m * l_squared;
    const wreal l_squared_times_m_times_c0p3333333333333333 = 0.3333333333333333 * m * l_squared;
    const wreal m_times_l_times_g_times_c1p5 = 1.5 * g * l * m;
    const wreal m_times_l_times_half_g = 0.5 * g * l * m;
    const wreal m_times_g_times_l = g * l * m;
    w[0] = m_cart_plus_twice_m;
    w[1] = m_times_l_times_c1p5;
    w[2] = m_times_half_l;
    w[3] = l_squared_times_m_times_c1p3333333333333333;
    w[4] = l_squared_times_half_m;
    w[5] = l_squared_times_m_times_c0p3333333333333333;
    w[6] = m_times_l_times_g_times_c1p5;
    w[7] = m_times_l_times_half_g;
    w[8] = m_times_g_times_l;
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
    const real q1_cos = cosine[0];
    const real q2_cos = cosine[1];
    const real q1_sin = sine[0];
    const real q2_sin = sine[1];

    /* common */
    const real F = r[0];
    const real v_value = u[0];
    const real u1 = u[1];
    const real u2 = u[2];
    const wreal m_times_l_times_c1p5 = w[1];
    const wreal m_times_half_l = w[2];
    const wreal l_squared_times_half_m = w[4];
    const wreal m_times_l_times_g_times_c1p5 = w[6];
    const wreal m_times_l_times_half_g = w[7];
    const wreal m_times_g_times_l = w[8];
    const real q1_cos_times_m_times_l_times_c1p5 = q1_cos * m_times_l_times_c1p5;
    const real q2_cos_times_m_times_half_l = q2_cos * m_times_half_l;
    const real equations_tau_u1_part = (q1_cos * q2_cos + q1_sin * q2_sin) * l_squared_times_half_m;
    const real u1_squared = u1 * u1;
    const real u2_squared = u2 * u2;
    const real equations_tau_v_part = F - m_times_l_times_c1p5 * u1_squared * q1_sin
        - m_times_half_l * u2_squared * q2_sin;
    const real q2_cos_times_q1_sin_minus_q1_cos_times_q2_sin = q2_cos * q1_sin - q1_cos * q2_sin;
    const real equations_tau_u1_part_2 = q1_sin * m_times_l_times_g_times_c1p5
        - l_squared_times_half_m * u2_squared * q2_cos_times_q1_sin_minus_q1_cos_times_q2_sin;
    const real equations_tau_u2_part = q2_sin * m_times_l_times_half_g
        + l_squared_times_half_m * u1_squared * q2_cos_times_q1_sin_minus_q1_cos_times_q2_sin;
    const real u1_times_q1_sin = u1 * q1_sin;
    const real m_times_l_times_c1p5_times_u1_times_q1_sin = m_times_l_times_c1p5 * u1_times_q1_sin;
    const real u2_times_q2_sin = u2 * q2_sin;
    const real m_times_half_l_times_u2_times_q2_sin = m_times_half_l * u2_times_q2_sin;
    const real equations_tau_u1_part_3 = l_squared_times_half_m * (u1 * q1_cos * q2_sin
        + u2 * q2_cos * q1_sin - (q2_cos * u1_times_q1_sin + q1_cos * u2_times_q2_sin));
    const real equations_tau_v_part_2 = equations_tau_v_part
        + 0.5 * (u1 * m_times_l_times_c1p5_times_u1_times_q1_sin
        + u2 * m_times_half_l_times_u2_times_q2_sin);
    const real equations_tau_u1_part_4 = equations_tau_u1_part_2
        - 1.5 * q1_sin * m_times_g_times_l
        + 0.5 * (v_value * m_times_l_times_c1p5_times_u1_times_q1_sin
        + u2 * equations_tau_u1_part_3);
    const real equations_tau_u2_part_2 = equations_tau_u2_part - 0.5 * q2_sin * m_times_g_times_l
        + 0.5 * (v_value * m_times_half_l_times_u2_times_q2_sin + u1 * equations_tau_u1_part_3);

    /* equations: tau */
    /* tau = S . [n; f] - force on the joint */
    const real vdot = udot[0];
    const real u1dot = udot[1];
    const real u2dot = udot[2];
    const wreal m_cart_plus_twice_m = w[0];
    const wreal l_squared_times_m_times_c1p3333333333333333 = w[3];
    const wreal l_squared_times_m_times_c0p3333333333333333 = w[5];
    /* tau: v.tau */
    out[0] = m_cart_plus_twice_m * vdot - q1_cos_times_m_times_l_times_c1p5 * u1dot
        - (equations_tau_v_part + q2_cos_times_m_times_half_l * u2dot) - equations_tau_v_part_2
        + equations_tau_v_part_2;
    /* tau: u1.tau */
    out[1] = l_squared_times_m_times_c1p3333333333333333 * u1dot
        - q1_cos_times_m_times_l_times_c1p5 * vdot + equations_tau_u1_part * u2dot
        - equations_tau_u1_part_2 - equations_tau_u1_part_4 + equations_tau_u1_part_4;
    /* tau: u2.tau */
    out[2] = l_squared_times_m_times_c0p3333333333333333 * u2dot
        - q2_cos_times_m_times_half_l * vdot + equations_tau_u1_part * u1dot
        - equations_tau_u2_part - equations_tau_u2_part_2 + equations_tau_u2_part_2;
    return CARDAN_OK;
}

#ifdef CARDAN_LOADED
/* numbers of out, work, w and of the blocks that are read: see manifest.json */
const int inverse_dynamics_sizes[] = {3, 0, 9, 0, 3, 3, 0, 0, 1, 4, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0};
#endif
